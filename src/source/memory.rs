//! Files in memory: for programs that embed durer, for tests, and for the open documents of an editor.

use super::{Entry, FileKind, Files, Metadata, WriteAccess, WriteMode};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};

/// A file system in memory, whose current folder is its root `/`. Folders exist as soon as a file lies below them.
/// Clones share their files.
///
/// ```
/// use durer::source::{Files, Memory};
/// let files = Memory::default();
/// files.insert("shapes/ball.inc", "sphere { 0, 1 }");
/// assert_eq!(files.read("./shapes/ball.inc".as_ref()).unwrap(), b"sphere { 0, 1 }");
/// ```
#[derive(Clone, Default)]
pub struct Memory(Arc<Mutex<Stored>>);

#[derive(Default)]
struct Stored {
    /// Files held in memory by normalized path.
    files: BTreeMap<PathBuf, File>,
    /// Number of changes so far, which serves as a file's time of modification.
    changes: u64,
}

struct File {
    bytes: Vec<u8>,
    changed: u64,
}

impl Memory {
    /// Creates or replaces a file held in memory.
    pub fn insert(&self, path: impl AsRef<Path>, bytes: impl Into<Vec<u8>>) {
        self.stored().create_or_change(normalized(path.as_ref()), |old| *old = bytes.into());
    }

    /// Removes a file, if it exists.
    pub fn remove(&self, path: impl AsRef<Path>) {
        self.stored().files.remove(&normalized(path.as_ref()));
    }

    /// Returns the contents of a file.
    pub fn get(&self, path: impl AsRef<Path>) -> Option<Vec<u8>> {
        self.stored().files.get(&normalized(path.as_ref())).map(|file| file.bytes.clone())
    }

    /// Returns the absolute paths of all files in alphabetical order.
    pub fn paths(&self) -> Vec<PathBuf> {
        self.stored().files.keys().cloned().collect()
    }

    /// True if there are no files.
    pub fn is_empty(&self) -> bool {
        self.stored().files.is_empty()
    }

    fn stored(&self) -> MutexGuard<'_, Stored> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Stored {
    fn create_or_change(&mut self, path: PathBuf, change: impl FnOnce(&mut Vec<u8>)) {
        self.changes += 1;
        let file = self.files.entry(path).or_insert_with(|| File { bytes: vec![], changed: 0 });
        file.changed = self.changes;
        change(&mut file.bytes);
    }

    /// Returns the files below a folder, with their paths relative to it.
    fn relative_paths_below(&self, folder: &Path) -> impl Iterator<Item = &Path> {
        self.files.keys().filter_map(move |path| path.strip_prefix(folder).ok())
    }
}

impl Files for Memory {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.get(path) {
            Some(bytes) => Ok(bytes),
            None if self.is_folder(path) => Err(io::ErrorKind::IsADirectory.into()),
            None => Err(not_found()),
        }
    }

    fn metadata(&self, path: &Path) -> io::Result<Metadata> {
        let (path, stored) = (normalized(path), self.stored());
        if let Some(file) = stored.files.get(&path) {
            let modified = SystemTime::UNIX_EPOCH + Duration::from_secs(file.changed);
            return Ok(Metadata { kind: FileKind::File, length: file.bytes.len() as u64, modified: Some(modified) });
        }
        let is_folder = path == Path::new("/") || stored.relative_paths_below(&path).next().is_some();
        let folder = Metadata { kind: FileKind::Folder, length: 0, modified: None };
        if is_folder { Ok(folder) } else { Err(not_found()) }
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<Entry>> {
        if !self.is_folder(folder) {
            return Err(not_found());
        }
        let stored = self.stored();
        let mut entries: Vec<Entry> = vec![];
        for path in stored.relative_paths_below(&normalized(folder)) {
            let mut parts = path.components();
            let Some(Component::Normal(name)) = parts.next() else { continue };
            let kind = if parts.next().is_some() { FileKind::Folder } else { FileKind::File };
            // Files below one folder are neighbours in the map.
            if entries.last().is_none_or(|last| last.name != name) {
                entries.push(Entry { name: name.to_os_string(), kind });
            }
        }
        Ok(entries)
    }

    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf> {
        self.metadata(path).map(|_| normalized(path))
    }

    fn open_writer(&self, path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>> {
        self.check_writable(path)?;
        let path = normalized(path);
        self.stored().create_or_change(path.clone(), |bytes| {
            if mode == WriteMode::Truncate {
                bytes.clear();
            }
        });
        Ok(Box::new(Writer { memory: self.clone(), path }))
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.check_writable(path)?;
        self.insert(path, bytes);
        Ok(())
    }

    /// Checks that `path` is not a folder. Its parent folders need not exist.
    fn check_writable(&self, path: &Path) -> io::Result<()> {
        if self.is_folder(path) { Err(io::ErrorKind::IsADirectory.into()) } else { Ok(()) }
    }
}

/// Writer that appends to a file in memory.
struct Writer {
    memory: Memory,
    path: PathBuf,
}

impl Write for Writer {
    fn write(&mut self, new: &[u8]) -> io::Result<usize> {
        self.memory.stored().create_or_change(self.path.clone(), |bytes| bytes.extend_from_slice(new));
        Ok(new.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Texts in memory in front of an underlying storage: open documents hide the files of the same path. Writes go to the
/// underlying storage.
pub struct Overlay {
    files: Arc<dyn Files>,
    texts: Memory,
}

impl Overlay {
    /// Creates an overlay on `files` that replaces no file yet.
    pub fn new(files: Arc<dyn Files>) -> Self {
        Self { files, texts: Memory::default() }
    }

    /// Adds a text that hides the file at `path`, which need not exist in the underlying storage.
    pub fn insert(&self, path: &Path, text: impl Into<Vec<u8>>) {
        self.texts.insert(self.key(path), text);
    }

    /// Returns the path under which the overlay stores a text: the canonical path if the file or its folder exists.
    fn key(&self, path: &Path) -> PathBuf {
        let whole = || self.files.canonicalize(path);
        let beside = || {
            let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
            Some(self.files.canonicalize(folder).ok()?.join(path.file_name()?))
        };
        whole().ok().or_else(beside).unwrap_or_else(|| path.to_path_buf())
    }

    fn ask_visible_storage<T>(
        &self,
        path: &Path,
        ask: impl FnOnce(&dyn Files, &Path) -> io::Result<T>,
    ) -> io::Result<T> {
        let key = self.key(path);
        if self.texts.is_file(&key) { ask(&self.texts, &key) } else { ask(&*self.files, path) }
    }
}

impl Files for Overlay {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.ask_visible_storage(path, |files, path| files.read(path))
    }

    fn metadata(&self, path: &Path) -> io::Result<Metadata> {
        self.ask_visible_storage(path, |files, path| files.metadata(path))
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<Entry>> {
        let mut entries = self.files.list(folder)?;
        let texts = self.texts.list(&self.key(folder)).unwrap_or_default();
        let new: Vec<_> =
            texts.into_iter().filter(|text| entries.iter().all(|entry| entry.name != text.name)).collect();
        entries.extend(new);
        Ok(entries)
    }

    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf> {
        self.ask_visible_storage(path, |files, path| files.canonicalize(path))
    }

    fn is_link(&self, path: &Path) -> bool {
        self.files.is_link(path)
    }

    fn open_writer(&self, path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>> {
        self.files.open_writer(path, mode)
    }

    fn open_below(&self, root: &Path, relative: &Path, access: WriteAccess) -> io::Result<Box<dyn Write + Send>> {
        self.files.open_below(root, relative, access)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.files.write(path, bytes)
    }
}

fn not_found() -> io::Error {
    io::ErrorKind::NotFound.into()
}

/// Returns the absolute path without `.` and `..`. `..` of the root is the root.
fn normalized(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::from("/"), |mut path, part| {
        match part {
            Component::Normal(name) => path.push(name),
            Component::ParentDir => _ = path.pop(),
            Component::Prefix(_) | Component::RootDir | Component::CurDir => {}
        }
        path
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_normalized_and_folders_follow_from_files() {
        let files = Memory::default();
        files.insert("a/b/c.inc", "1");
        files.insert("/a/d.inc", "2");
        assert_eq!(files.read(Path::new("a/./b/../b/c.inc")).unwrap(), b"1");
        assert!(
            files.is_folder(Path::new("a")) && files.is_folder(Path::new(".")) && files.is_file(Path::new("a/d.inc"))
        );
        let mut names: Vec<_> = files.list(Path::new("a")).unwrap().into_iter().map(|entry| entry.name).collect();
        names.sort();
        assert_eq!(names, ["b", "d.inc"]);
        assert_eq!(files.canonicalize(Path::new("../a/d.inc")).unwrap(), Path::new("/a/d.inc"));
        assert!(files.read(Path::new("a")).is_err() && files.read(Path::new("e")).is_err());
        assert!(files.list(Path::new("e")).is_err());
    }

    #[test]
    fn writers_truncate_or_append_and_change_the_stamp() {
        let (files, path) = (Memory::default(), Path::new("out.txt"));
        let write = |mode, text: &str| {
            files.open_writer(path, mode).unwrap().write_all(text.as_bytes()).unwrap();
            (files.get(path).unwrap(), files.stamp(path).unwrap())
        };
        let first = write(WriteMode::Append, "one");
        let second = write(WriteMode::Append, " two");
        let third = write(WriteMode::Truncate, "six");
        assert_eq!([&first.0, &second.0, &third.0], [&b"one"[..], b"one two", b"six"]);
        assert_ne!(first.1, third.1);
    }

    #[test]
    fn overlaid_texts_hide_files_under_any_spelling_of_the_path() {
        let disk = tempfile::tempdir().unwrap();
        let at = |name: &str| disk.path().join(name);
        std::fs::create_dir(at("sub")).unwrap();
        std::fs::write(at("a.inc"), "old").unwrap();
        std::fs::write(at("b.inc"), "b").unwrap();
        let overlay = Overlay::new(Arc::new(crate::source::Disk));
        overlay.insert(&at("a.inc"), "new");
        overlay.insert(&at("unsaved.inc"), "u");
        let read = |name: &str| String::from_utf8(overlay.read(&at(name)).unwrap()).unwrap();
        assert_eq!([read("a.inc"), read("sub/../a.inc"), read("b.inc"), read("unsaved.inc")], ["new", "new", "b", "u"]);
        assert_eq!(overlay.list(disk.path()).unwrap().len(), 4);
    }
}
