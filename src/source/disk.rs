//! Reading and writing on the machine's disk. A written file appears whole or not at all.

use super::{Entry, FileKind, Files, Metadata, WriteAccess, WriteMode};
use std::fs::{File, FileType, OpenOptions};
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Storage that reads and writes the file system of the machine.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    /// Reads a file. Devices and pipes, which may never end, are refused; opening one does not block.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let mut options = OpenOptions::new();
        options.read(true);
        #[cfg(unix)]
        std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, rustix::fs::OFlags::NONBLOCK.bits() as i32);
        let mut file = options.open(path)?;
        let metadata = file.metadata()?;
        if !metadata.is_file() && !metadata.is_dir() {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is a device or a pipe"));
        }
        let mut bytes = Vec::with_capacity(usize::try_from(metadata.len()).unwrap_or(usize::MAX).min(MAX_RESERVED));
        file.read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    fn metadata(&self, path: &Path) -> io::Result<Metadata> {
        let metadata = std::fs::metadata(path)?;
        let kind = kind_of(metadata.file_type());
        Ok(Metadata { kind, length: metadata.len(), modified: metadata.modified().ok() })
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<Entry>> {
        let entries = std::fs::read_dir(folder)?;
        entries
            .map(|entry| entry.and_then(|e| Ok(Entry { name: e.file_name(), kind: kind_of(e.file_type()?) })))
            .collect()
    }

    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf> {
        path.canonicalize()
    }

    fn is_link(&self, path: &Path) -> bool {
        path.is_symlink()
    }

    fn open_writer(&self, path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>> {
        let append = mode == WriteMode::Append;
        let file = OpenOptions::new().create(true).write(true).append(append).truncate(!append).open(path)?;
        Ok(Box::new(file))
    }

    #[cfg(unix)]
    fn open_below(&self, root: &Path, relative: &Path, access: WriteAccess) -> io::Result<Box<dyn Write + Send>> {
        below::open(root, relative, access).map(|file| Box::new(file) as Box<dyn Write + Send>)
    }

    /// Writes a temporary file in the same folder, which then replaces the old file. Devices and pipes are written
    /// directly; a symbolic link stays a link.
    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let path = follow_links(path)?;
        if is_special(&path) {
            return OpenOptions::new().write(true).open(&path)?.write_all(bytes);
        }
        let mut file = temporary_file_beside(&path)?;
        file.write_all(bytes)?;
        file.persist(&path).map_err(|e| e.error)?;
        Ok(())
    }

    fn draft(&self, path: &Path) -> io::Result<Draft> {
        let path = follow_links(path)?;
        if is_special(&path) {
            return Ok(Draft::in_memory(&path));
        }
        let file = tempfile::tempfile_in(parent_folder(&path))
            .map_err(|e| io::Error::new(e.kind(), error_text_without_path(&e)))?;
        Ok(Draft { path, bytes: DraftStorage::Disk(io::BufWriter::with_capacity(1 << 16, file)), is_durable: false })
    }

    fn check_writable(&self, path: &Path) -> io::Result<()> {
        let path = follow_links(path)?;
        if is_special(&path) {
            return OpenOptions::new().write(true).open(&path).map(drop);
        }
        temporary_file_beside(&path).map(drop)
    }
}

/// Maximum number of bytes that are reserved for a file before it is read; larger files grow while they are read.
const MAX_RESERVED: usize = 1 << 30;

/// Opens files without following links.
#[cfg(unix)]
mod below {
    use super::{File, Path, WriteAccess, io, refused_link};
    use rustix::fs::{Mode, OFlags, open as open_path, openat};
    use std::os::unix::fs::MetadataExt;

    /// Opens the file at `relative` below `root`, where `relative` contains no link. Each folder is opened by its name
    /// in the folder before, and the kernel refuses links, so that nothing can change between a check and the opening.
    pub fn open(root: &Path, relative: &Path, access: WriteAccess) -> io::Result<File> {
        let folder_flags = OFlags::DIRECTORY | OFlags::CLOEXEC | OFlags::RDONLY;
        let mut folder = open_path(root, folder_flags, Mode::empty())?;
        let mut names: Vec<_> = relative.iter().collect();
        let Some(name) = names.pop() else { return Err(io::ErrorKind::IsADirectory.into()) };
        for name in names {
            folder = openat(&folder, name, folder_flags | OFlags::NOFOLLOW, Mode::empty()).map_err(refused_link)?;
        }
        // (A pipe without a reader is an error, and does not block.)
        let flags = OFlags::WRONLY | OFlags::CLOEXEC | OFlags::NOFOLLOW | OFlags::NONBLOCK;
        let flags = match access {
            WriteAccess::Create => flags | OFlags::CREATE | OFlags::EXCL,
            WriteAccess::Replace => flags,
            WriteAccess::Append => flags | OFlags::APPEND,
        };
        let file = File::from(openat(&folder, name, flags, Mode::from_raw_mode(0o666)).map_err(refused_link)?);
        let metadata = file.metadata()?;
        if !metadata.is_file() || metadata.nlink() > 1 {
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, "it is not a regular file with one name"));
        }
        if access == WriteAccess::Replace {
            file.set_len(0)?;
        }
        Ok(file)
    }
}

/// Turns the kernel's error for a refused link into one that says so.
#[cfg(unix)]
fn refused_link(error: rustix::io::Errno) -> io::Error {
    match error {
        rustix::io::Errno::LOOP | rustix::io::Errno::NOTDIR => {
            io::Error::new(io::ErrorKind::PermissionDenied, "its path contains a link")
        }
        other => other.into(),
    }
}

/// A file whose bytes arrive over a long time. Nothing appears at the file's path before [`Draft::commit`]. A draft
/// that is not committed vanishes, however the program ends.
pub struct Draft {
    path: PathBuf,
    bytes: DraftStorage,
    /// True if the committed file must survive a power loss.
    is_durable: bool,
}

/// Storage of a draft's bytes until [`Draft::commit`].
enum DraftStorage {
    /// A file on the disk that has no name yet, in the folder of its later path.
    Disk(io::BufWriter<File>),
    /// Bytes in memory, for file systems without nameless files.
    Memory(Cursor<Vec<u8>>),
}

impl Draft {
    /// Creates a draft whose bytes stay in memory until [`Draft::commit`].
    pub fn in_memory(path: &Path) -> Self {
        Self { path: path.to_path_buf(), bytes: DraftStorage::Memory(Cursor::default()), is_durable: false }
    }

    /// Makes [`Draft::commit`] wait until the file on the disk and its name would survive a power loss.
    pub fn make_durable(&mut self) {
        self.is_durable = true;
    }

    /// Returns the bytes of a draft in memory; empty for a draft on disk.
    pub fn into_memory_bytes(self) -> Vec<u8> {
        match self.bytes {
            DraftStorage::Memory(bytes) => bytes.into_inner(),
            DraftStorage::Disk(_) => vec![],
        }
    }

    /// Creates or replaces the file at the draft's path in `files`, the storage that started the draft.
    ///
    /// # Errors
    /// If the file cannot be written; then nothing has changed.
    pub fn commit(self, files: &dyn Files) -> io::Result<()> {
        match self.bytes {
            DraftStorage::Memory(bytes) => files.write(&self.path, bytes.get_ref()),
            DraftStorage::Disk(bytes) => {
                let mut bytes = bytes.into_inner().map_err(io::IntoInnerError::into_error)?;
                bytes.seek(SeekFrom::Start(0))?;
                let mut file = temporary_file_beside(&self.path)?;
                io::copy(&mut bytes, file.as_file_mut())?;
                if self.is_durable {
                    file.as_file().sync_all()?;
                }
                file.persist(&self.path).map_err(|e| e.error)?;
                if self.is_durable {
                    sync_folder_of(&self.path);
                }
                Ok(())
            }
        }
    }
}

impl Write for Draft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.bytes {
            DraftStorage::Disk(file) => file.write(bytes),
            DraftStorage::Memory(memory) => memory.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.bytes {
            DraftStorage::Disk(file) => file.flush(),
            DraftStorage::Memory(_) => Ok(()),
        }
    }
}

impl Seek for Draft {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match &mut self.bytes {
            DraftStorage::Disk(file) => file.seek(to),
            DraftStorage::Memory(memory) => memory.seek(to),
        }
    }
}

fn kind_of(kind: FileType) -> FileKind {
    match kind {
        kind if kind.is_file() => FileKind::File,
        kind if kind.is_dir() => FileKind::Folder,
        kind if kind.is_symlink() => FileKind::Link,
        _ => FileKind::Special,
    }
}

/// Returns the path behind symbolic links; `path` itself if it is no link, whether it exists or not.
///
/// # Errors
/// If the path leads to a folder, or over more than [`MAX_LINKS`] links.
pub fn follow_links(path: &Path) -> io::Result<PathBuf> {
    if path.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    let mut path = path.to_path_buf();
    for _ in 0..MAX_LINKS {
        if !path.is_symlink() {
            return Ok(path);
        }
        match path.canonicalize() {
            // A link whose file does not exist yet leads to a path in its own folder.
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                path = parent_folder(&path).join(path.read_link()?)
            }
            found => return found,
        }
    }
    Err(io::Error::other("too many links"))
}

/// Maximum number of links from the name of a file to a path that does not exist yet.
const MAX_LINKS: usize = 16;

/// True if `path` exists and is neither a file nor a folder (`/dev/null`, a named pipe).
fn is_special(path: &Path) -> bool {
    path.metadata().is_ok_and(|m| !m.is_file() && !m.is_dir())
}

/// Creates a file in the folder of `path` that is deleted unless it gets a name. The permissions are those of any new
/// file, since by default only the owner could read a temporary file.
fn temporary_file_beside(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".durer-").suffix(".part");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(parent_folder(path)).map_err(|e| io::Error::new(e.kind(), error_text_without_path(&e)))
}

/// Waits until the names in the folder of `path` would survive a power loss. Failures are ignored.
pub fn sync_folder_of(path: &Path) {
    #[cfg(unix)]
    let _ = File::open(parent_folder(path)).and_then(|folder| folder.sync_all());
    #[cfg(not(unix))]
    let _ = path;
}

fn parent_folder(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Returns the error's text without the path of the temporary file, which the user does not know.
fn error_text_without_path(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" at path \"").next().unwrap_or_default().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn write_replaces_the_old_file_and_leaves_no_temporary_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        Disk.write(&path, b"one").unwrap();
        Disk.write(&path, b"two").unwrap();
        Disk.check_writable(&path).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"two");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn write_keeps_links_and_devices() {
        let folder = tempfile::tempdir().unwrap();
        let (target, link) = (folder.path().join("target"), folder.path().join("link"));
        std::fs::write(&target, "old").unwrap();
        std::os::unix::fs::symlink(&target, &link).unwrap();
        Disk.write(&link, b"new").unwrap();
        assert!(link.is_symlink());
        assert_eq!(std::fs::read(&target).unwrap(), b"new");
        Disk.write(Path::new("/dev/null"), b"gone").unwrap();
        assert!(!Path::new("/dev/null").is_file());
    }

    #[cfg(unix)]
    #[test]
    fn written_files_have_default_permissions() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (written, plain) = (folder.path().join("ours"), folder.path().join("plain"));
        Disk.write(&written, b"").unwrap();
        std::fs::write(&plain, b"").unwrap();
        let mode = |p: &Path| p.metadata().unwrap().permissions().mode();
        assert_eq!(mode(&written), mode(&plain));
    }

    #[test]
    fn drafts_appear_with_their_commit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        let mut draft = Disk.draft(&path).unwrap();
        draft.write_all(b"one two").unwrap();
        draft.flush().unwrap();
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        draft.seek(SeekFrom::Start(4)).unwrap();
        draft.write_all(b"2").unwrap();
        draft.commit(&Disk).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"one 2wo");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        assert!(Disk.draft(&folder.path().join("none/a.txt")).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_a_missing_file_is_written_through() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir(at("pictures")).unwrap();
        std::os::unix::fs::symlink("pictures/b", at("a")).unwrap();
        std::os::unix::fs::symlink("c", at("pictures/b")).unwrap();
        Disk.write(&at("a"), b"1").unwrap();
        assert_eq!(std::fs::read(at("pictures/c")).unwrap(), b"1");
        std::os::unix::fs::symlink("nowhere/d", at("lost")).unwrap();
        std::os::unix::fs::symlink("loop", at("loop")).unwrap();
        assert!(Disk.write(&at("lost"), b"1").is_err() && Disk.write(&at("loop"), b"1").is_err());
    }

    #[test]
    fn write_fails_for_folders_and_missing_folders() {
        assert!(Disk.write(Path::new("/nowhere/at/all.png"), b"").is_err());
        let folder = tempfile::tempdir().unwrap();
        assert!(Disk.write(folder.path(), b"").is_err());
    }
}
