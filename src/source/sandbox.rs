//! Policy for the files of a scene: which files it may read and write, also through links and `..` in paths.

use super::{Draft, Entry, Files, Memory, Metadata, WriteAccess, WriteMode};
use std::collections::BTreeSet;
use std::fmt::Debug;
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// Files that a scene may read and write.
#[derive(Clone, Debug, Default)]
pub struct Sandbox {
    /// Files that the scene may read.
    pub read: ReadPolicy,
    /// Files that the scene may write.
    pub write: WritePolicy,
}

/// Files that a scene may read.
#[derive(Clone, Debug, Default)]
pub enum ReadPolicy {
    /// All regular files, as for a compiler or POV-Ray.
    Anywhere,
    /// Files below these folders.
    Below(Vec<PathBuf>),
    /// No files.
    #[default]
    Nowhere,
}

/// Files that a scene may write.
#[derive(Clone, Debug, Default)]
pub enum WritePolicy {
    /// No file changes. Written files stay in memory, where the scene itself can read them during the run.
    #[default]
    InMemory,
    /// Files below these folders, except those that [`WriteFolder`] protects.
    Below(Vec<WriteFolder>),
}

/// A folder below which a scene may create files, and replace files that it created before.
///
/// A scene can't write files whose name or folder begins with a dot, scenes, INI files and snapshots, and can't write
/// through a link.
#[derive(Clone, Debug)]
pub struct WriteFolder {
    /// Path of the folder that the scene may write to.
    pub path: PathBuf,
    /// List of the files that the scene created.
    pub created: Arc<dyn CreatedFiles>,
    /// True if the scene may also replace files that it did not create.
    pub replaces_all: bool,
}

/// List of the files that a scene created.
pub trait CreatedFiles: Debug + Send + Sync {
    /// Records that the scene creates or replaces the file `path` now.
    fn add(&self, path: &Path);
    /// True if the scene created the file `path`, and nobody else has changed it since.
    fn contains(&self, path: &Path) -> bool;
}

/// List of the files that were created during the lifetime of this value.
#[derive(Debug, Default)]
pub struct CreatedInSession(Mutex<BTreeSet<PathBuf>>);

impl CreatedInSession {
    /// Returns the created files in alphabetical order.
    pub fn paths(&self) -> Vec<PathBuf> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).iter().cloned().collect()
    }
}

impl CreatedFiles for CreatedInSession {
    fn add(&self, path: &Path) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_path_buf());
    }

    fn contains(&self, path: &Path) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).contains(path)
    }
}

impl Sandbox {
    /// Returns the rules that let a scene read all files, and that keep the files that the scene writes in memory.
    pub fn with_writes_in_memory() -> Self {
        Self { read: ReadPolicy::Anywhere, write: WritePolicy::InMemory }
    }

    /// Returns the rules that let a scene read below all folders of the search path and of its fonts, and create files below
    /// the current folder.
    pub fn for_search_path(search: &super::SearchPath) -> Self {
        // Fonts are not confidential, and include folders hold links to them.
        let read = search.folders.iter().chain(&search.fonts).cloned().collect();
        let current =
            WriteFolder { path: ".".into(), created: Arc::<CreatedInSession>::default(), replaces_all: false };
        Self { read: ReadPolicy::Below(read), write: WritePolicy::Below(vec![current]) }
    }
}

/// Storage that enforces the policy of a [`Sandbox`] on all accesses.
pub struct Sandboxed<'a> {
    files: &'a dyn Files,
    sandbox: &'a Sandbox,
    /// Files that the scene wrote under [`WritePolicy::InMemory`], by their paths without links.
    written: Memory,
}

impl<'a> Sandboxed<'a> {
    /// Restricts the access to `files` by the rules of `sandbox`.
    pub fn new(files: &'a dyn Files, sandbox: &'a Sandbox) -> Self {
        Self { files, sandbox, written: Memory::default() }
    }

    /// Returns the paths of the files that the scene wrote to memory, in alphabetical order.
    pub fn paths_written_in_memory(&self) -> Vec<PathBuf> {
        self.written.paths()
    }

    /// Returns a path without links and `..`. The file need not exist, but its folder must.
    fn resolved(&self, path: &Path) -> io::Result<PathBuf> {
        if let Ok(path) = self.files.canonicalize(path) {
            return Ok(path);
        }
        // A dangling link is refused, since a write would follow it.
        let name = match path.components().next_back() {
            Some(Component::Normal(name)) if !self.files.is_link(path) => name,
            _ => return Err(io::ErrorKind::NotFound.into()),
        };
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Ok(self.files.canonicalize(folder)?.join(name))
    }

    fn is_below(&self, resolved_path: &Path, folders: &[PathBuf]) -> bool {
        folders
            .iter()
            .any(|folder| self.files.canonicalize(folder).is_ok_and(|folder| resolved_path.starts_with(folder)))
    }

    fn check_read(&self, path: &Path) -> io::Result<()> {
        if self.may_read(path) { Ok(()) } else { Err(io::ErrorKind::PermissionDenied.into()) }
    }

    /// Returns the key of a file in [`Self::written`]; `None` if the scene wrote no such file to memory.
    fn written_key(&self, path: &Path) -> Option<PathBuf> {
        if self.written.is_empty() {
            return None;
        }
        self.resolved(path).ok().filter(|path| self.written.is_file(path))
    }

    fn open_in_memory(&self, path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>> {
        let key = self.resolved(path)?;
        if mode == WriteMode::Append && !self.written.is_file(&key) && self.may_read(path) {
            self.written.insert(&key, self.files.read(path).unwrap_or_default());
        }
        self.written.open_writer(&key, mode)
    }

    fn open_below(&self, folders: &[WriteFolder], path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>> {
        let permission_error = |reason: &str| Err(io::Error::new(io::ErrorKind::PermissionDenied, reason.to_string()));
        let Some((folder, root, relative)) = folders.iter().find_map(|folder| {
            let (root, relative) = self.root_and_relative_path(&folder.path, path)?;
            Some((folder, root, relative))
        }) else {
            return permission_error("it is outside of the folders that scenes may write to");
        };
        if let Some(reason) = protection_reason(&relative) {
            return permission_error(reason);
        }
        let whole = root.join(&relative);
        let opened = self.files.open_below(&root, &relative, WriteAccess::Create);
        if !matches!(&opened, Err(error) if error.kind() == io::ErrorKind::AlreadyExists) {
            if opened.is_ok() {
                folder.created.add(&whole);
            }
            return opened;
        }
        if !folder.replaces_all && !folder.created.contains(&whole) {
            return permission_error("the file exists, and this scene did not create it");
        }
        let access = match mode {
            WriteMode::Truncate => WriteAccess::Replace,
            WriteMode::Append => WriteAccess::Append,
        };
        folder.created.add(&whole);
        self.files.open_below(&root, &relative, access)
    }

    /// Returns a folder without links, and a path relative to it without `..`; `None` if the path is elsewhere.
    fn root_and_relative_path(&self, folder: &Path, path: &Path) -> Option<(PathBuf, PathBuf)> {
        let root = self.files.canonicalize(folder).ok()?;
        let current = self.files.canonicalize(Path::new(".")).ok()?;
        let whole = without_dots(&current.join(path));
        let relative = whole.strip_prefix(&root).or_else(|_| whole.strip_prefix(folder)).ok()?;
        (relative.components().next().is_some()).then(|| (root, relative.to_path_buf()))
    }
}

/// Returns the path without `.`, and with each `..` applied to the name before it.
fn without_dots(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => _ = out.pop(),
            part => out.push(part),
        }
    }
    out
}

/// Returns the reason why scenes can't write a file of this name; `None` if they can.
fn protection_reason(relative: &Path) -> Option<&'static str> {
    let names: Vec<String> = relative.iter().map(|name| name.to_string_lossy().to_lowercase()).collect();
    let (file, folders) = names.split_last()?;
    let ends_with = |endings: &[&str]| endings.iter().any(|ending| file.ends_with(ending));
    if file.starts_with('.') {
        Some("its name begins with a dot")
    } else if folders.iter().any(|name| name.starts_with('.')) {
        Some("it is in a folder whose name begins with a dot")
    } else if ends_with(&[".scene", ".pov"]) {
        Some("scenes don't write scenes")
    } else if ends_with(&[".ini"]) {
        Some("scenes don't write INI files")
    } else if ends_with(&[".snapshot.png"]) {
        Some("scenes don't write snapshots")
    } else {
        None
    }
}

impl Files for Sandboxed<'_> {
    fn may_read(&self, path: &Path) -> bool {
        let allowed = match &self.sandbox.read {
            ReadPolicy::Anywhere => true,
            ReadPolicy::Nowhere => false,
            ReadPolicy::Below(folders) => self.resolved(path).is_ok_and(|path| self.is_below(&path, folders)),
        };
        (allowed || self.written_key(path).is_some() || self.is_in_writable_folder(path)) && self.files.may_read(path)
    }

    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.check_read(path)?;
        match self.written_key(path) {
            Some(key) => self.written.read(&key),
            None => self.files.read(path),
        }
    }

    fn read_unrecorded(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.check_read(path)?;
        self.files.read_unrecorded(path)
    }

    fn open_writer(&self, path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>> {
        match &self.sandbox.write {
            WritePolicy::InMemory => self.open_in_memory(path, mode),
            WritePolicy::Below(folders) => self.open_below(folders, path, mode),
        }
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.open_writer(path, WriteMode::Truncate)?.write_all(bytes)
    }

    fn draft(&self, _: &Path) -> io::Result<Draft> {
        // Scenes write piece by piece.
        Err(io::ErrorKind::PermissionDenied.into())
    }

    fn metadata(&self, path: &Path) -> io::Result<Metadata> {
        match self.written_key(path) {
            Some(key) => self.written.metadata(&key),
            None => self.files.metadata(path),
        }
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<Entry>> {
        self.files.list(folder)
    }

    fn entry_in_any_case(&self, folder: &Path, name: &str) -> Option<String> {
        self.files.entry_in_any_case(folder, name)
    }

    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf> {
        self.written_key(path).map_or_else(|| self.files.canonicalize(path), Ok)
    }

    fn is_link(&self, path: &Path) -> bool {
        self.files.is_link(path)
    }
}

impl Sandboxed<'_> {
    /// True if the file is in a folder that the scene may write to, so that the scene may also read the file.
    fn is_in_writable_folder(&self, path: &Path) -> bool {
        let WritePolicy::Below(folders) = &self.sandbox.write else { return false };
        let folders: Vec<PathBuf> = folders.iter().map(|folder| folder.path.clone()).collect();
        self.resolved(path).is_ok_and(|path| self.is_below(&path, &folders))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Disk;

    fn below(folder: &Path) -> WritePolicy {
        let created = Arc::<CreatedInSession>::default();
        WritePolicy::Below(vec![WriteFolder { path: folder.into(), created, replaces_all: false }])
    }

    fn try_write(files: &Sandboxed, path: &Path) -> Result<(), String> {
        files.write(path, b"new").map_err(|error| error.to_string())
    }

    #[test]
    fn files_outside_the_folders_are_refused() {
        let (inner, outer) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let sandbox = Sandbox { read: ReadPolicy::Below(vec![]), write: below(inner.path()) };
        let files = Sandboxed::new(&Disk, &sandbox);
        assert_eq!(try_write(&files, &inner.path().join("a.txt")), Ok(()));
        for path in [outer.path().join("a.txt"), inner.path().join("..").join("a.txt"), inner.path().to_path_buf()] {
            assert!(try_write(&files, &path).unwrap_err().contains("outside"), "{path:?}");
        }
        assert!(try_write(&files, &inner.path().join("no").join("a.txt")).is_err());
        std::fs::write(outer.path().join("secret"), "s").unwrap();
        assert!(!files.may_read(&outer.path().join("secret")));
        assert!(files.may_read(&inner.path().join("a.txt")));
        assert!(files.read(&outer.path().join("secret")).is_err());
    }

    #[test]
    fn only_created_files_are_replaced_and_protected_names_never_written() {
        let folder = tempfile::tempdir().unwrap();
        let sandbox = Sandbox { read: ReadPolicy::Anywhere, write: below(folder.path()) };
        let files = Sandboxed::new(&Disk, &sandbox);
        std::fs::create_dir(folder.path().join(".git")).unwrap();
        std::fs::write(folder.path().join("mine.txt"), "old").unwrap();
        let at = |name: &str| folder.path().join(name);
        assert_eq!(try_write(&files, &at("data.inc")), Ok(()));
        assert_eq!(try_write(&files, &at("data.inc")), Ok(()));
        assert!(try_write(&files, &at("mine.txt")).unwrap_err().contains("did not create"));
        for name in [".git/config", ".profile", "a.scene", "A.POV", "povray.ini", "a.snapshot.png"] {
            assert!(try_write(&files, &at(name)).is_err(), "{name}");
            assert!(!at(name).exists(), "{name}");
        }
        assert_eq!(std::fs::read(at("mine.txt")).unwrap(), b"old");
    }

    #[cfg(unix)]
    #[test]
    fn links_and_pipes_are_never_written() {
        use std::os::unix::fs::symlink;
        let (inner, outer) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        std::fs::write(outer.path().join("secret"), "s").unwrap();
        std::fs::write(inner.path().join("own"), "o").unwrap();
        let created = Arc::<CreatedInSession>::default();
        let folder = WriteFolder { path: inner.path().into(), created, replaces_all: true };
        let sandbox =
            Sandbox { read: ReadPolicy::Below(vec![inner.path().into()]), write: WritePolicy::Below(vec![folder]) };
        let files = Sandboxed::new(&Disk, &sandbox);
        for (name, target) in [("a", "secret"), ("b", "new")] {
            symlink(outer.path().join(target), inner.path().join(name)).unwrap();
            assert!(!files.may_read(&inner.path().join(name)));
            assert!(try_write(&files, &inner.path().join(name)).is_err());
        }
        symlink(inner.path().join("own"), inner.path().join("c")).unwrap();
        std::fs::hard_link(outer.path().join("secret"), inner.path().join("d")).unwrap();
        symlink(outer.path(), inner.path().join("folder")).unwrap();
        for name in ["c", "d", "folder/x"] {
            assert!(try_write(&files, &inner.path().join(name)).is_err(), "{name}");
        }
        assert_eq!(std::fs::read(outer.path().join("secret")).unwrap(), b"s");
        assert_eq!(std::fs::read(inner.path().join("own")).unwrap(), b"o");
        assert_eq!(std::fs::read_dir(outer.path()).unwrap().count(), 1);
        assert_eq!(try_write(&files, &inner.path().join("own")), Ok(()));
    }

    #[test]
    fn files_in_memory_are_visible_to_the_scene_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        std::fs::write(&path, "old ").unwrap();
        let sandbox = Sandbox { read: ReadPolicy::Anywhere, write: WritePolicy::InMemory };
        let files = Sandboxed::new(&Disk, &sandbox);
        files.open_writer(&path, WriteMode::Append).unwrap().write_all(b"new").unwrap();
        assert_eq!(files.read(&path).unwrap(), b"old new");
        let other = folder.path().join("other.inc");
        files.write(&other, b"1").unwrap();
        assert!(files.exists(&other) && files.is_file(&other) && !other.exists());
        assert_eq!(files.paths_written_in_memory().len(), 2);
        assert_eq!(std::fs::read(&path).unwrap(), b"old ");
    }
}
