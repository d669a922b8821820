//! Records which files were read, with hashes of their contents: the inputs of a picture.

use super::{Draft, Entry, Files, Metadata, WriteAccess, WriteMode};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// Paths of files that were read, with the hashes of their contents.
pub type ReadFiles = BTreeMap<PathBuf, ContentHash>;

/// BLAKE3 hash of a file's contents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContentHash(blake3::Hash);

impl ContentHash {
    /// Computes the content hash of `bytes`.
    pub fn of(bytes: &[u8]) -> Self {
        Self(blake3::hash(bytes))
    }
}

impl Serialize for ContentHash {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.0.to_hex())
    }
}

impl<'de> Deserialize<'de> for ContentHash {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let hex = String::deserialize(deserializer)?;
        blake3::Hash::from_hex(hex).map(Self).map_err(serde::de::Error::custom)
    }
}

/// Storage that records each file it reads.
pub struct Recorder {
    files: Arc<dyn Files>,
    read: Mutex<ReadFiles>,
}

impl Recorder {
    /// Creates a recorder of all files read through `files`.
    pub fn new(files: Arc<dyn Files>) -> Self {
        Self { files, read: Mutex::default() }
    }

    /// Records contents that came from elsewhere, such as standard input.
    pub fn record(&self, path: &Path, bytes: &[u8]) {
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        read.insert(path.to_path_buf(), ContentHash::of(bytes));
    }

    /// Returns all files that were read so far.
    pub fn read_files(&self) -> ReadFiles {
        self.read.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

impl Files for Recorder {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let bytes = self.files.read(path)?;
        self.record(path, &bytes);
        Ok(bytes)
    }

    fn inspect(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.files.inspect(path)
    }

    fn metadata(&self, path: &Path) -> io::Result<Metadata> {
        self.files.metadata(path)
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<Entry>> {
        self.files.list(folder)
    }

    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf> {
        self.files.canonicalize(path)
    }

    fn is_link(&self, path: &Path) -> bool {
        self.files.is_link(path)
    }

    fn open_writer(&self, path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>> {
        self.files.open_writer(path, mode)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.files.write(path, bytes)
    }

    fn draft(&self, path: &Path) -> io::Result<Draft> {
        self.files.draft(path)
    }

    fn check_writable(&self, path: &Path) -> io::Result<()> {
        self.files.check_writable(path)
    }

    fn may_read(&self, path: &Path) -> bool {
        self.files.may_read(path)
    }

    fn open_below(&self, root: &Path, relative: &Path, access: WriteAccess) -> io::Result<Box<dyn Write + Send>> {
        self.files.open_below(root, relative, access)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Memory;

    #[test]
    fn reads_are_recorded_with_hashes_but_inspections_are_not() {
        let memory = Memory::default();
        memory.insert("a.inc", "1");
        memory.insert("b.ttf", "2");
        let recorder = Recorder::new(Arc::new(memory));
        recorder.read(Path::new("a.inc")).unwrap();
        recorder.inspect(Path::new("b.ttf")).unwrap();
        assert!(recorder.read(Path::new("c.inc")).is_err());
        assert_eq!(recorder.read_files(), ReadFiles::from([("a.inc".into(), ContentHash::of(b"1"))]));
    }

    #[test]
    fn hashes_are_stored_as_text() {
        let hash = ContentHash::of(b"sphere");
        let text = serde_json::to_string(&hash).unwrap();
        assert_eq!((text.len(), serde_json::from_str::<ContentHash>(&text).unwrap()), (66, hash));
        assert!(serde_json::from_str::<ContentHash>("12345").is_err());
    }
}
