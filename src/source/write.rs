//! Writes files whole or not at all.

use std::fs::File;
use std::io::{self, Cursor, Seek, SeekFrom, Write};
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

/// A file to be, whose bytes come over hours: nothing is to be seen of it before [`Draft::place`], and it vanishes if this never
/// comes, however the program ends.
pub struct Draft {
    path: PathBuf,
    bytes: Bytes,
}

enum Bytes {
    /// Without a name, in the folder of the file to be.
    File(io::BufWriter<File>),
    Memory(Cursor<Vec<u8>>),
}

impl Draft {
    /// What will be at `path`.
    ///
    /// # Errors
    /// If the folder can't be written to.
    pub fn new(path: &Path) -> io::Result<Self> {
        let path = resolve(path)?;
        if is_special(&path) {
            return Ok(Self { path, bytes: Bytes::Memory(Cursor::default()) });
        }
        let file = tempfile::tempfile_in(folder(&path)).map_err(|e| io::Error::new(e.kind(), system_text(&e)))?;
        Ok(Self { path, bytes: Bytes::File(io::BufWriter::with_capacity(1 << 16, file)) })
    }

    /// One that goes nowhere: its bytes are asked for.
    pub fn in_memory() -> Self {
        Self { path: PathBuf::new(), bytes: Bytes::Memory(Cursor::default()) }
    }

    /// The bytes of one in memory.
    pub fn into_bytes(self) -> Vec<u8> {
        match self.bytes {
            Bytes::Memory(bytes) => bytes.into_inner(),
            Bytes::File(_) => vec![],
        }
    }

    /// Puts it where it belongs, whole or not at all.
    ///
    /// # Errors
    /// If it can't be written; then nothing has changed.
    pub fn place(self) -> io::Result<()> {
        match self.bytes {
            Bytes::Memory(bytes) => write_whole(&self.path, bytes.get_ref()),
            Bytes::File(bytes) => {
                let mut bytes = bytes.into_inner().map_err(io::IntoInnerError::into_error)?;
                bytes.seek(SeekFrom::Start(0))?;
                let mut file = temporary(&self.path)?;
                io::copy(&mut bytes, file.as_file_mut())?;
                file.persist(&self.path).map_err(|e| e.error)?;
                Ok(())
            }
        }
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.bytes {
            Bytes::File(file) => file.write(bytes),
            Bytes::Memory(memory) => memory.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.bytes {
            Bytes::File(file) => file.flush(),
            Bytes::Memory(_) => Ok(()),
        }
    }
}

impl Seek for Draft {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match &mut self.bytes {
            Bytes::File(file) => file.seek(to),
            Bytes::Memory(memory) => memory.seek(to),
        }
    }
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
    let mut builder = tempfile::Builder::new();
    builder.prefix(".durer-").suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder(path)).map_err(|e| io::Error::new(e.kind(), system_text(&e)))
}

fn folder(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
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
    fn drafts_are_not_seen_before_they_are_placed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        let mut draft = Draft::new(&path).unwrap();
        draft.write_all(b"one two").unwrap();
        draft.flush().unwrap();
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        draft.seek(SeekFrom::Start(4)).unwrap();
        draft.write_all(b"2").unwrap();
        draft.place().unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"one 2wo");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(Draft::new(&folder.path().join("none/a.txt")).is_err());
    }

    #[test]
    fn what_cannot_be_written_says_so() {
        assert!(write_whole(Path::new("/nowhere/at/all.png"), b"").is_err());
        let folder = tempfile::tempdir().unwrap();
        assert!(write_whole(folder.path(), b"").is_err());
    }
}
