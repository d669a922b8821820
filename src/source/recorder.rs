//! Records the inputs of a picture: files that were read, with hashes of the contents, and paths that were looked up.

use super::lookup::{Lookup, Lookups};
use super::{Draft, Entry, Files, Metadata, WriteAccess, WriteMode};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Paths of files that were read, with the hashes of their contents.
pub type ReadFiles = BTreeMap<PathBuf, ContentHash>;

/// BLAKE3 hash of a file's contents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContentHash(blake3::Hash);

impl Ord for ContentHash {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.as_bytes().cmp(other.0.as_bytes())
    }
}

impl PartialOrd for ContentHash {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl ContentHash {
    /// Computes the content hash of `bytes`.
    pub fn of(bytes: &[u8]) -> Self {
        Self(blake3::hash(bytes))
    }

    /// Returns the combined hash of a file whose contents changed from `self` to `next` during a run.
    fn followed_by(self, next: Self) -> Self {
        Self::of(&[*self.0.as_bytes(), *next.0.as_bytes()].concat())
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

/// Storage that records each file it reads, and each look-up of a file.
pub struct Recorder {
    files: Arc<dyn Files>,
    record: Mutex<Record>,
}

#[derive(Default)]
struct Record {
    /// All files that were read.
    read: ReadFiles,
    /// Files that were read since [`Recorder::begin_run`].
    run: ReadFiles,
    /// Look-ups since [`Recorder::begin_run`].
    lookups: Lookups,
}

impl Recorder {
    /// Creates a recorder of all files read through `files`.
    pub fn new(files: Arc<dyn Files>) -> Self {
        Self { files, record: Mutex::default() }
    }

    /// Records contents that were read elsewhere, such as standard input, as those of the file `path`. A file that was
    /// read with different contents during one run gets a hash of all of them.
    pub fn record(&self, path: &Path, bytes: &[u8]) {
        let mut record = self.record_mut();
        let hash = ContentHash::of(bytes);
        let known = record.run.entry(path.to_path_buf()).or_insert(hash);
        if *known != hash {
            *known = known.followed_by(hash);
        }
        let hash = *known;
        record.read.insert(path.to_path_buf(), hash);
    }

    /// Returns all files that were read so far.
    pub fn read_files(&self) -> ReadFiles {
        self.record_mut().read.clone()
    }

    /// Forgets the look-ups of earlier runs, such as the frames before.
    pub fn begin_run(&self) {
        let mut record = self.record_mut();
        record.lookups.clear();
        record.run.clear();
    }

    /// Returns the look-ups since [`Recorder::begin_run`].
    pub fn lookups(&self) -> Lookups {
        self.record_mut().lookups.clone()
    }

    fn record_mut(&self) -> MutexGuard<'_, Record> {
        self.record.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn record_lookup(&self, path: &Path, lookup: Lookup) {
        let mut record = self.record_mut();
        match record.lookups.get_mut(path) {
            Some(known) if known.contains(&lookup) => {}
            Some(known) => known.push(lookup),
            None => _ = record.lookups.insert(path.to_path_buf(), vec![lookup]),
        }
    }
}

impl Files for Recorder {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let bytes = self.files.read(path)?;
        self.record(path, &bytes);
        Ok(bytes)
    }

    fn read_unrecorded(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.record_lookup(path, Lookup::version(&*self.files, path));
        self.files.read_unrecorded(path)
    }

    fn metadata(&self, path: &Path) -> io::Result<Metadata> {
        let metadata = self.files.metadata(path);
        self.record_lookup(path, Lookup::Kind(metadata.as_ref().ok().map(|metadata| metadata.kind)));
        metadata
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<Entry>> {
        let entries = self.files.list(folder);
        self.record_lookup(folder, Lookup::names(entries.as_deref().unwrap_or_default()));
        entries
    }

    fn entry_in_any_case(&self, folder: &Path, name: &str) -> Option<String> {
        let found = self.files.entry_in_any_case(folder, name);
        self.record_lookup(folder, Lookup::Spelling { name: name.to_string(), found: found.clone() });
        found
    }

    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf> {
        let target = self.files.canonicalize(path);
        self.record_lookup(path, Lookup::target(&*self.files, target.as_deref().ok()));
        target
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
        recorder.read_unrecorded(Path::new("b.ttf")).unwrap();
        assert!(recorder.read(Path::new("c.inc")).is_err());
        assert_eq!(recorder.read_files(), ReadFiles::from([("a.inc".into(), ContentHash::of(b"1"))]));
    }

    #[test]
    fn lookups_are_recorded_until_the_next_run() {
        let memory = Arc::new(Memory::default());
        memory.insert("a.inc", "1");
        let recorder = Recorder::new(memory.clone());
        assert!(recorder.exists(Path::new("a.inc")) && !recorder.exists(Path::new("b.inc")));
        recorder.entry_in_any_case(Path::new("."), "A.INC").unwrap();
        let lookups = recorder.lookups();
        let holds = || lookups.iter().all(|(path, all)| all.iter().all(|lookup| lookup.is_current(&*memory, path)));
        assert!(lookups.len() == 3 && holds());
        memory.insert("c.inc", "");
        assert!(holds());
        memory.insert("b.inc", "");
        assert!(!holds());
        recorder.exists(Path::new("b.inc"));
        assert_eq!(recorder.lookups()[Path::new("b.inc")].len(), 2);
        recorder.begin_run();
        assert!(recorder.lookups().is_empty());
    }

    #[test]
    fn contents_that_change_during_a_run_are_recorded_as_changing() {
        let memory = Arc::new(Memory::default());
        let recorder = Recorder::new(memory.clone());
        let read = |text: &str| {
            memory.insert("a.inc", text);
            recorder.read(Path::new("a.inc")).unwrap();
            recorder.read_files()[Path::new("a.inc")]
        };
        assert_eq!(read("1"), ContentHash::of(b"1"));
        assert!(read("2") != ContentHash::of(b"2"));
        assert!(read("1") != ContentHash::of(b"1"));
        recorder.begin_run();
        assert_eq!(read("2"), ContentHash::of(b"2"));
    }

    #[test]
    fn hashes_are_stored_as_text() {
        let hash = ContentHash::of(b"sphere");
        let text = serde_json::to_string(&hash).unwrap();
        assert_eq!((text.len(), serde_json::from_str::<ContentHash>(&text).unwrap()), (66, hash));
        assert!(serde_json::from_str::<ContentHash>("12345").is_err());
    }
}
