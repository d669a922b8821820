//! The interface through which all files are read and written.
//!
//! The caller of the library chooses an implementation: [`Disk`](super::Disk), [`Memory`](super::Memory) or
//! [`Overlay`](super::Overlay). Only `source/` and the front ends open files in another way.

use super::Draft;
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Storage that a run reads from and writes to. Relative paths start at the implementation's current folder.
pub trait Files: Send + Sync {
    /// Returns the contents of a file.
    ///
    /// # Errors
    /// If the file does not exist or cannot be read.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// Returns the contents of a file that is only a candidate, such as a font during the search for a family.
    /// [`Recorder`](super::Recorder) does not count the file as read.
    ///
    /// # Errors
    /// If the file does not exist or cannot be read.
    fn read_unrecorded(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.read(path)
    }

    /// Returns kind, length and time of modification of a file or folder; follows symbolic links.
    ///
    /// # Errors
    /// If nothing exists at `path`.
    fn metadata(&self, path: &Path) -> io::Result<Metadata>;

    /// Returns the entries of a folder in no particular order.
    ///
    /// # Errors
    /// If the folder does not exist or cannot be read.
    fn list(&self, folder: &Path) -> io::Result<Vec<Entry>>;

    /// Returns the first entry of a folder, in alphabetical order, whose name equals `name` except for letter case.
    fn entry_in_any_case(&self, folder: &Path, name: &str) -> Option<String> {
        let names = self.list(folder).ok()?.into_iter().filter_map(|entry| entry.name.into_string().ok());
        names.filter(|entry| entry.to_lowercase() == name.to_lowercase()).min()
    }

    /// Returns the absolute path without symbolic links, `.` and `..`.
    ///
    /// # Errors
    /// If nothing exists at `path`.
    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf>;

    /// True if `path` itself is a symbolic link, whether or not its target exists.
    fn is_link(&self, _path: &Path) -> bool {
        false
    }

    /// Opens a file that a scene writes piece by piece; creates the file if it does not exist.
    ///
    /// # Errors
    /// If the file cannot be created or written.
    fn open_writer(&self, path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>>;

    /// Opens a regular file below a folder for writing. No link is followed below `root`, and a file that has other names
    /// (hard links) is refused; so are devices and pipes.
    ///
    /// # Errors
    /// If the file exists with [`WriteAccess::Create`] ([`io::ErrorKind::AlreadyExists`]), if it does not exist with the
    /// others, or if it is refused.
    fn open_below(&self, root: &Path, relative: &Path, access: WriteAccess) -> io::Result<Box<dyn Write + Send>> {
        let path = root.join(relative);
        match (access, self.exists(&path)) {
            (WriteAccess::Create, true) => Err(io::ErrorKind::AlreadyExists.into()),
            (WriteAccess::Replace | WriteAccess::Append, false) => Err(io::ErrorKind::NotFound.into()),
            (WriteAccess::Append, true) => self.open_writer(&path, WriteMode::Append),
            (WriteAccess::Create, false) | (WriteAccess::Replace, true) => self.open_writer(&path, WriteMode::Truncate),
        }
    }

    /// Replaces or creates a file, which then contains all of `bytes`.
    ///
    /// # Errors
    /// If the file cannot be written; then nothing has changed.
    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()>;

    /// Starts a file whose bytes arrive over a long time and that appears at `path` with [`Draft::commit`].
    ///
    /// # Errors
    /// If the folder cannot be written to.
    fn draft(&self, path: &Path) -> io::Result<Draft> {
        Ok(Draft::in_memory(path))
    }

    /// Checks whether [`Files::write`] is possible, before hours of work.
    ///
    /// # Errors
    /// The error that [`Files::write`] would return.
    fn check_writable(&self, _path: &Path) -> io::Result<()> {
        Ok(())
    }

    /// True if the storage's policy allows `path` to be read. Only [`Sandboxed`](super::Sandboxed) restricts reading.
    fn may_read(&self, _path: &Path) -> bool {
        true
    }

    /// True if a file, a folder or a device exists at `path`.
    fn exists(&self, path: &Path) -> bool {
        self.metadata(path).is_ok()
    }

    /// True if a regular file exists at `path`.
    fn is_file(&self, path: &Path) -> bool {
        self.metadata(path).is_ok_and(|metadata| metadata.kind == FileKind::File)
    }

    /// True if a folder exists at `path`.
    fn is_folder(&self, path: &Path) -> bool {
        self.metadata(path).is_ok_and(|metadata| metadata.kind == FileKind::Folder)
    }

    /// Returns the state of a file, which differs after the file was written; `None` if the file does not exist, or the
    /// storage does not record the time of the last write.
    fn stamp(&self, path: &Path) -> Option<Stamp> {
        let metadata = self.metadata(path).ok()?;
        Some(Stamp { modified: metadata.modified?, length: metadata.length })
    }
}

/// Kind of a file system entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FileKind {
    /// Kind of path: a regular file.
    File,
    /// Kind of path: a folder.
    Folder,
    /// Kind of path: a symbolic link; only [`Files::list`] returns it.
    Link,
    /// Kind of path: a device, a pipe or a socket.
    Special,
}

/// Properties of a file or folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Metadata {
    /// Kind of the file; for a symbolic link, the kind of the link's target.
    pub kind: FileKind,
    /// Length of the file in bytes.
    pub length: u64,
    /// Time of the last write, if the system records it.
    pub modified: Option<SystemTime>,
}

/// An entry of a folder's listing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name of the folder's entry, without the folder.
    pub name: OsString,
    /// Kind of the folder's entry; [`FileKind::Link`] for a link, which is not followed.
    pub kind: FileKind,
}

/// State of a file at one moment. Different contents nearly always have different stamps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    modified: SystemTime,
    length: u64,
}

/// Treatment of the old contents of a file that is opened for writing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WriteMode {
    /// Mode of writing that removes the file's old contents.
    Truncate,
    /// Mode of writing that appends new bytes to the old contents.
    Append,
}

/// Way in which [`Files::open_below`] opens a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WriteAccess {
    /// Creates a file that does not exist.
    Create,
    /// Removes the contents of an existing file.
    Replace,
    /// Appends to an existing file.
    Append,
}
