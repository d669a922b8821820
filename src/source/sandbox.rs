//! Policy for the files of a scene: the folders it may read and write, whatever links and `..` its paths contain.

use super::{Draft, Entry, Files, Metadata, WriteMode};
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};

/// Folders that a scene may access.
#[derive(Clone, Debug, Default)]
pub struct Sandbox {
    /// Folders below which the scene may read: its own folder, the include path, `--allow-read`.
    pub read: Vec<PathBuf>,
    /// Folders below which the scene may write and read: the current folder, `--allow-write`.
    pub write: Vec<PathBuf>,
}

impl Sandbox {
    /// Allows to read in all folders of the search path and to write below the current folder.
    pub fn around(search: &super::SearchPath) -> Self {
        // Fonts are not confidential, and include folders hold links to them.
        Self { read: search.folders.iter().chain(&search.fonts).cloned().collect(), write: vec![PathBuf::from(".")] }
    }
}

/// Storage restricted by a [`Sandbox`]: the only place that enforces the policy.
pub struct Sandboxed<'a> {
    files: &'a dyn Files,
    sandbox: &'a Sandbox,
}

impl<'a> Sandboxed<'a> {
    /// Restricts the access to `files` by the rules of `sandbox`.
    pub fn new(files: &'a dyn Files, sandbox: &'a Sandbox) -> Self {
        Self { files, sandbox }
    }

    /// Returns the path without links and `..`. The file need not exist, but its folder must.
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

    fn is_below(&self, path: &Path, folders: &[PathBuf]) -> bool {
        folders.iter().any(|folder| self.files.canonicalize(folder).is_ok_and(|folder| path.starts_with(folder)))
    }

    fn check_read(&self, path: &Path) -> io::Result<()> {
        if self.may_read(path) { Ok(()) } else { Err(io::ErrorKind::PermissionDenied.into()) }
    }

    fn check_write(&self, path: &Path) -> io::Result<()> {
        if self.may_write(path) { Ok(()) } else { Err(io::ErrorKind::PermissionDenied.into()) }
    }
}

impl Files for Sandboxed<'_> {
    fn may_read(&self, path: &Path) -> bool {
        let Ok(resolved) = self.resolved(path) else { return false };
        let Sandbox { read, write } = self.sandbox;
        (self.is_below(&resolved, read) || self.is_below(&resolved, write)) && self.files.may_read(path)
    }

    fn may_write(&self, path: &Path) -> bool {
        self.resolved(path).is_ok_and(|path| self.is_below(&path, &self.sandbox.write)) && self.files.may_write(path)
    }

    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.check_read(path)?;
        self.files.read(path)
    }

    fn inspect(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.check_read(path)?;
        self.files.inspect(path)
    }

    fn open_writer(&self, path: &Path, mode: WriteMode) -> io::Result<Box<dyn Write + Send>> {
        self.check_write(path)?;
        self.files.open_writer(path, mode)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.check_write(path)?;
        self.files.write(path, bytes)
    }

    fn draft(&self, path: &Path) -> io::Result<Draft> {
        self.check_write(path)?;
        self.files.draft(path)
    }

    fn check_writable(&self, path: &Path) -> io::Result<()> {
        self.check_write(path)?;
        self.files.check_writable(path)
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Disk;

    #[test]
    fn files_outside_the_folders_are_refused() {
        let (inner, outer) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let sandbox = Sandbox { read: vec![], write: vec![inner.path().into()] };
        let files = Sandboxed::new(&Disk, &sandbox);
        assert!(files.may_write(&inner.path().join("a.txt")));
        assert!(!files.may_write(&outer.path().join("a.txt")));
        assert!(!files.may_write(&inner.path().join("..").join("a.txt")));
        assert!(!files.may_write(&inner.path().join("no").join("a.txt")));
        std::fs::write(outer.path().join("secret"), "s").unwrap();
        assert!(!files.may_read(&outer.path().join("secret")));
        assert!(files.may_read(&inner.path().join("a.txt")));
        assert!(files.read(&outer.path().join("secret")).is_err());
        assert!(files.write(&outer.path().join("a.txt"), b"").is_err());
        assert!(files.open_writer(&outer.path().join("a.txt"), WriteMode::Append).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn links_to_files_outside_are_refused() {
        let (inner, outer) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        std::fs::write(outer.path().join("secret"), "s").unwrap();
        let sandbox = Sandbox { read: vec![inner.path().into()], write: vec![inner.path().into()] };
        let files = Sandboxed::new(&Disk, &sandbox);
        for target in ["secret", "new"] {
            let link = inner.path().join(target);
            std::os::unix::fs::symlink(outer.path().join(target), &link).unwrap();
            assert!(!files.may_read(&link) && !files.may_write(&link));
        }
        std::os::unix::fs::symlink(outer.path(), inner.path().join("folder")).unwrap();
        assert!(!files.may_write(&inner.path().join("folder").join("x")));
    }
}
