//! What a scene may read and write: files below these folders, wherever links and `..` lead.

use std::io;
use std::path::{Component, Path, PathBuf};

/// The folders a scene may touch.
#[derive(Clone, Debug, Default)]
pub struct Sandbox {
    /// Below these it may read: its own folder, the include paths, `--allow-read`.
    pub read: Vec<PathBuf>,
    /// Below these it may write, and read too: the current folder, `--allow-write`.
    pub write: Vec<PathBuf>,
}

impl Sandbox {
    /// Reads where includes are looked for, writes below the current folder.
    pub fn around(search: &super::SearchPath) -> Self {
        // Fonts are nobody's secret, and include folders hold links to them.
        Self { read: search.folders.iter().chain(&search.fonts).cloned().collect(), write: vec![PathBuf::from(".")] }
    }

    /// May this file be read?
    pub fn may_read(&self, path: &Path) -> bool {
        let Ok(path) = resolved(path) else { return false };
        is_below(&path, &self.read) || is_below(&path, &self.write)
    }

    /// May this file be written? It need not be there yet.
    pub fn may_write(&self, path: &Path) -> bool {
        resolved(path).is_ok_and(|path| is_below(&path, &self.write))
    }
}

/// Without links and `..`; the last name of a file that is not there yet is taken as it is.
fn resolved(path: &Path) -> io::Result<PathBuf> {
    if let Ok(path) = path.canonicalize() {
        return Ok(path);
    }
    // A link that leads nowhere would be followed by whoever writes: it is refused.
    let name = match path.components().next_back() {
        Some(Component::Normal(name)) if !path.is_symlink() => name,
        _ => return Err(io::ErrorKind::NotFound.into()),
    };
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    Ok(folder.canonicalize()?.join(name))
}

fn is_below(path: &Path, folders: &[PathBuf]) -> bool {
    folders.iter().any(|folder| folder.canonicalize().is_ok_and(|folder| path.starts_with(folder)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_outside_is_touched() {
        let (inner, outer) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let sandbox = Sandbox { read: vec![], write: vec![inner.path().into()] };
        assert!(sandbox.may_write(&inner.path().join("a.txt")));
        assert!(!sandbox.may_write(&outer.path().join("a.txt")));
        assert!(!sandbox.may_write(&inner.path().join("..").join("a.txt")));
        assert!(!sandbox.may_write(&inner.path().join("no").join("a.txt")));
        std::fs::write(outer.path().join("secret"), "s").unwrap();
        assert!(!sandbox.may_read(&outer.path().join("secret")));
        assert!(sandbox.may_read(&inner.path().join("a.txt")));
    }

    #[cfg(unix)]
    #[test]
    fn links_lead_nowhere_else() {
        let (inner, outer) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        std::fs::write(outer.path().join("secret"), "s").unwrap();
        let sandbox = Sandbox { read: vec![inner.path().into()], write: vec![inner.path().into()] };
        for target in ["secret", "new"] {
            let link = inner.path().join(target);
            std::os::unix::fs::symlink(outer.path().join(target), &link).unwrap();
            assert!(!sandbox.may_read(&link) && !sandbox.may_write(&link));
        }
        std::os::unix::fs::symlink(outer.path(), inner.path().join("folder")).unwrap();
        assert!(!sandbox.may_write(&inner.path().join("folder").join("x")));
    }
}
