//! The trees of the files that a command has read: frames of an animation share them.

use crate::source::{FileId, Files, Stamp};
use crate::syntax::Names;
use crate::syntax::ast::{Ast, Element};
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// Parsed files, and the names in them. It belongs to one [`crate::source::Sources`].
#[derive(Default)]
pub struct ParsedFiles {
    pub(super) names: Names,
    pub(super) asts: elsa::FrozenVec<Box<Ast>>,
    /// What elements and expressions of the trees were taken apart into, by their addresses.
    parts: elsa::FrozenMap<*const (), Box<[Element]>, FxBuildHasher>,
    /// Numbers of trees.
    trees: RefCell<FxHashMap<FileId, usize>>,
    /// With their stamps: a scene may write a file that its next frame includes.
    files: RefCell<FxHashMap<PathBuf, (FileId, Option<Stamp>)>>,
}

impl ParsedFiles {
    /// The tree of a file, if it was parsed.
    pub(super) fn tree(&self, file: FileId) -> Option<&Ast> {
        let index = self.trees.borrow().get(&file).copied()?;
        self.asts.get(index)
    }

    /// The parts of something in a tree; `make` is asked once.
    pub(super) fn parts_of<T>(&self, whole: &T, make: impl FnOnce() -> Vec<Element>) -> &[Element] {
        let key: *const () = std::ptr::from_ref(whole).cast();
        match self.parts.get(&key) {
            Some(parts) => parts,
            None => self.parts.insert(key, make().into()),
        }
    }

    pub(super) fn keep(&self, file: FileId, ast: Ast) -> &Ast {
        self.trees.borrow_mut().insert(file, self.asts.len());
        self.asts.push_get(Box::new(ast))
    }

    /// The file that lies there, if it was read and is still the same. Those that are built in have no stamp.
    pub(super) fn file(&self, files: &dyn Files, path: &Path) -> Option<FileId> {
        let (file, read) = self.files.borrow().get(path).copied()?;
        (read == files.stamp(path)).then_some(file)
    }

    pub(super) fn keep_file(&self, files: &dyn Files, path: &Path, file: FileId) {
        self.files.borrow_mut().insert(path.to_path_buf(), (file, files.stamp(path)));
    }

    /// What is written anew must be parsed anew when it is included: two writes may be nearer than the clock of files tells.
    pub(super) fn forget(&self, files: &dyn Files, path: &Path) {
        let full = files.canonicalize(path).ok();
        let same = |known: &Path| known == path || full.is_some() && files.canonicalize(known).ok() == full;
        self.files.borrow_mut().retain(|known, _| !same(known));
    }

    /// All trees of files with their files, in the order of reading.
    pub fn all(&self) -> Vec<(FileId, &Ast)> {
        let mut all: Vec<_> = self.trees.borrow().iter().map(|(&file, &index)| (file, index)).collect();
        all.sort_by_key(|(_, index)| *index);
        all.into_iter().filter_map(|(file, index)| Some((file, self.asts.get(index)?))).collect()
    }

    /// The names in the trees.
    pub fn names(&self) -> &Names {
        &self.names
    }
}
