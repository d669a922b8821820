//! Files that one process at a time uses.

use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

/// A regular file that is locked against other processes as long as this value exists. The system releases the lock if
/// the process is killed. If the file is empty, it is deleted when this value is dropped.
pub struct Exclusive {
    path: PathBuf,
    file: File,
}

/// Reason for which a file cannot be used exclusively.
#[derive(Debug)]
pub enum OpenError {
    /// Another process, or another part of this one, uses the file.
    InUse,
    /// The path is that of a link, a pipe, a device, a folder, or a file with a second name.
    NotPlain,
    /// The system reported an error.
    Io(io::Error),
}

impl From<io::Error> for OpenError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl Exclusive {
    /// Opens and locks a file for reading and writing; creates the file if it does not exist. No link is followed.
    ///
    /// # Errors
    /// If the file is in use, not a plain file, or cannot be opened.
    pub fn open(path: &Path) -> Result<Self, OpenError> {
        Self::open_with(path, |file| match file.try_lock() {
            Ok(()) => Ok(()),
            Err(TryLockError::WouldBlock) => Err(OpenError::InUse),
            Err(TryLockError::Error(error)) => ignore_missing_lock_support(error),
        })
    }

    /// Opens and locks a file as [`Exclusive::open`] does, but first waits for other processes to release it.
    ///
    /// # Errors
    /// If the file is not a plain file, or cannot be opened.
    pub fn wait_for(path: &Path) -> Result<Self, OpenError> {
        Self::open_with(path, |file| file.lock().or_else(ignore_missing_lock_support))
    }

    fn open_with(path: &Path, lock: impl Fn(&File) -> Result<(), OpenError>) -> Result<Self, OpenError> {
        loop {
            let file = open_or_create_regular(path)?;
            lock(&file)?;
            // Another process may have deleted the file before the lock was taken.
            if is_at(&file, path)? {
                return Ok(Self { path: path.to_path_buf(), file });
            }
        }
    }

    /// Returns the path of the locked file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the open handle of the locked file.
    pub fn file(&self) -> &File {
        &self.file
    }

    /// Deletes the file while it is still locked.
    pub fn delete(&self) {
        // After the folder was renamed, another file may have the path.
        if is_at(&self.file, &self.path).unwrap_or(false) {
            let _ = std::fs::remove_file(&self.path);
        }
    }
}

impl Drop for Exclusive {
    fn drop(&mut self) {
        if self.file.metadata().is_ok_and(|metadata| metadata.len() == 0) {
            self.delete();
        }
    }
}

/// Opens a regular file for reading and writing, or creates it. Follows no link, and does not block on a pipe.
///
/// # Errors
/// If the path is not that of a plain file, or the file cannot be opened.
pub fn open_or_create_regular(path: &Path) -> Result<File, OpenError> {
    // Opening a device can have effects, so that its kind is checked before.
    if std::fs::symlink_metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
        return Err(OpenError::NotPlain);
    }
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    #[cfg(unix)]
    {
        use rustix::fs::OFlags;
        let flags = (OFlags::NOFOLLOW | OFlags::NONBLOCK).bits() as i32;
        std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, flags);
    }
    let file = options.open(path)?;
    let metadata = file.metadata()?;
    if metadata.is_file() && !has_other_hard_links(&metadata) { Ok(file) } else { Err(OpenError::NotPlain) }
}

#[cfg(unix)]
fn has_other_hard_links(metadata: &std::fs::Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(metadata) > 1
}

#[cfg(not(unix))]
fn has_other_hard_links(_: &std::fs::Metadata) -> bool {
    false
}

/// Ignores the error of a file system that has no locks; its files are used unlocked.
fn ignore_missing_lock_support(error: io::Error) -> Result<(), OpenError> {
    #[cfg(unix)]
    if error.raw_os_error() == Some(rustix::io::Errno::NOLCK.raw_os_error()) {
        return Ok(());
    }
    if error.kind() == io::ErrorKind::Unsupported { Ok(()) } else { Err(error.into()) }
}

/// True if the open file is the one that `path` names now.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    let own = file.metadata()?;
    match std::fs::symlink_metadata(path) {
        Ok(found) => Ok((found.dev(), found.ino()) == (own.dev(), own.ino())),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

/// True if a file exists at `path`. Windows frees the name of a deleted file only after all processes have closed it.
#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> io::Result<bool> {
    Ok(path.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    #[test]
    fn one_at_a_time_opens_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let first = Exclusive::open(&path).unwrap();
        assert!(matches!(Exclusive::open(&path), Err(OpenError::InUse)));
        drop(first);
        assert!(!path.exists());
        let second = Exclusive::open(&path).unwrap();
        second.file().write_all(b"1").unwrap();
        drop(second);
        assert_eq!(std::fs::read(&path).unwrap(), b"1");
        Exclusive::open(&path).unwrap().delete();
        assert!(!path.exists());
        assert!(matches!(Exclusive::open(&folder.path().join("none/a")), Err(OpenError::Io(_))));
    }

    #[cfg(unix)]
    #[test]
    fn links_pipes_devices_and_folders_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("precious"), "1").unwrap();
        std::os::unix::fs::symlink(at("precious"), at("link")).unwrap();
        std::os::unix::fs::symlink(at("new"), at("dangling")).unwrap();
        std::fs::hard_link(at("precious"), at("second")).unwrap();
        rustix::fs::mkfifoat(rustix::fs::CWD, at("pipe"), rustix::fs::Mode::RUSR | rustix::fs::Mode::WUSR).unwrap();
        std::fs::create_dir(at("folder")).unwrap();
        for path in ["link", "dangling", "second", "pipe", "folder"].map(at).into_iter().chain(["/dev/null".into()]) {
            assert!(matches!(Exclusive::open(&path), Err(OpenError::NotPlain)), "{path:?}");
        }
        assert!(!at("new").exists());
        assert_eq!(std::fs::read(at("precious")).unwrap(), b"1");
    }
}
