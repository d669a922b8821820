//! Writes files whole or not at all.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Writes a file whole or not at all: into a temporary file in the same folder, which then takes
/// the place of the old one. Devices and pipes are written to directly; a symbolic link stays one.
///
/// # Errors
/// If the folder or the file can't be written to; then nothing has changed.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let path = resolve(path)?;
    if is_special(&path) {
        return std::fs::OpenOptions::new().write(true).open(&path)?.write_all(bytes);
    }
    let mut file = temporary(&path)?;
    file.write_all(bytes)?;
    file.persist(&path).map_err(|e| e.error)?;
    Ok(())
}

/// Would [`write_whole`] be allowed to? To be asked before hours of work.
///
/// # Errors
/// The one that [`write_whole`] would give.
pub fn check_writable(path: &Path) -> io::Result<()> {
    let path = resolve(path)?;
    if is_special(&path) {
        return std::fs::OpenOptions::new().write(true).open(&path).map(drop);
    }
    temporary(&path).map(drop)
}

/// The file behind symbolic links; an error for a folder.
fn resolve(path: &Path) -> io::Result<PathBuf> {
    if path.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    Ok(if path.is_symlink() { path.canonicalize()? } else { path.to_path_buf() })
}

/// Is it there, and neither file nor folder (`/dev/null`, a named pipe)?
fn is_special(path: &Path) -> bool {
    path.metadata().is_ok_and(|m| !m.is_file() && !m.is_dir())
}

/// A file beside `path` that vanishes unless it is persisted, with the permissions that a new file
/// gets by default (a temporary one would be its owner's alone).
fn temporary(path: &Path) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".durer-").suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder).map_err(|e| io::Error::new(e.kind(), system_text(&e)))
}

/// Without the path of the temporary file, which nobody asked for.
fn system_text(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" at path \"").next().unwrap_or_default().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_old_file_is_replaced_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_whole(&path, b"one").unwrap();
        write_whole(&path, b"two").unwrap();
        check_writable(&path).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"two");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn links_and_devices_stay_what_they_are() {
        let folder = tempfile::tempdir().unwrap();
        let (target, link) = (folder.path().join("target"), folder.path().join("link"));
        std::fs::write(&target, "old").unwrap();
        std::os::unix::fs::symlink(&target, &link).unwrap();
        write_whole(&link, b"new").unwrap();
        assert!(link.is_symlink());
        assert_eq!(std::fs::read(&target).unwrap(), b"new");
        write_whole(Path::new("/dev/null"), b"gone").unwrap();
        assert!(!Path::new("/dev/null").is_file());
    }

    #[cfg(unix)]
    #[test]
    fn permissions_are_those_of_any_new_file() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
        write_whole(&ours, b"").unwrap();
        std::fs::write(&plain, b"").unwrap();
        let mode = |p: &Path| p.metadata().unwrap().permissions().mode();
        assert_eq!(mode(&ours), mode(&plain));
    }

    #[test]
    fn what_cannot_be_written_says_so() {
        assert!(write_whole(Path::new("/nowhere/at/all.png"), b"").is_err());
        let folder = tempfile::tempdir().unwrap();
        assert!(write_whole(folder.path(), b"").is_err());
    }
}
