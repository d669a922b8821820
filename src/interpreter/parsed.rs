//! Syntax trees of the files that a command has read, which the frames of an animation share.

use crate::source::{FileId, Files, Stamp};
use crate::syntax::Names;
use crate::syntax::ast::{Ast, Element};
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// Parsed files and the names in them, all from one [`crate::source::Sources`].
#[derive(Default)]
pub struct ParsedFiles {
    pub(super) names: Names,
    pub(super) asts: elsa::FrozenVec<Box<Ast>>,
    /// Parts of split elements and expressions, by the address of the syntax tree's node.
    parts: elsa::FrozenMap<*const (), Box<[Element]>, FxBuildHasher>,
    /// Tokens of the rests of files after an old `#version`, by the address of the first element.
    rests: elsa::FrozenMap<*const (), Box<[Element]>, FxBuildHasher>,
    /// Index in `asts` of the syntax tree of each parsed file, by file.
    trees: RefCell<FxHashMap<FileId, usize>>,
    /// Files that were read, by path, each with its state at that time (stamp), because a scene may write a file that
    /// the next frame includes.
    files: RefCell<FxHashMap<PathBuf, (FileId, Option<Stamp>)>>,
}

impl ParsedFiles {
    /// Returns the syntax tree of a file; `None` if the file was not parsed.
    pub(super) fn tree(&self, file: FileId) -> Option<&Ast> {
        let index = self.trees.borrow().get(&file).copied()?;
        self.asts.get(index)
    }

    /// Returns the smaller elements into which a node of a syntax tree is split. They are cached: `make` computes them
    /// once per node.
    pub(super) fn cached_parts<T>(&self, whole: &T, make: impl FnOnce() -> Vec<Element>) -> &[Element] {
        let key: *const () = std::ptr::from_ref(whole).cast();
        match self.parts.get(&key) {
            Some(parts) => parts,
            None => self.parts.insert(key, make().into()),
        }
    }

    /// Returns the tokens of the rest of a file, which begins at the element `first`. They are cached: `make` computes
    /// them once per first element.
    pub(super) fn cached_rest_tokens(&self, first: &Element, make: impl FnOnce() -> Vec<Element>) -> &[Element] {
        let key: *const () = std::ptr::from_ref(first).cast();
        match self.rests.get(&key) {
            Some(rest) => rest,
            None => self.rests.insert(key, make().into()),
        }
    }

    pub(super) fn add_tree(&self, file: FileId, ast: Ast) -> &Ast {
        self.trees.borrow_mut().insert(file, self.asts.len());
        self.asts.push_get(Box::new(ast))
    }

    /// Returns the id of the file that was read from `path`; `None` if the file was not read or has changed since.
    /// Built-in files have no stamp.
    pub(super) fn unchanged_file(&self, files: &dyn Files, path: &Path) -> Option<FileId> {
        let (file, read) = self.files.borrow().get(path).copied()?;
        (read == files.stamp(path)).then_some(file)
    }

    pub(super) fn add_file(&self, files: &dyn Files, path: &Path, file: FileId) {
        self.files.borrow_mut().insert(path.to_path_buf(), (file, files.stamp(path)));
    }

    /// Forgets a file that is being written, so that the next include parses it. (Two writes may have equal stamps.)
    pub(super) fn forget(&self, files: &dyn Files, path: &Path) {
        let full = files.canonicalize(path).ok();
        let same = |known: &Path| known == path || full.is_some() && files.canonicalize(known).ok() == full;
        self.files.borrow_mut().retain(|known, _| !same(known));
    }

    /// Returns all syntax trees with their files, in the order of reading.
    pub fn all(&self) -> Vec<(FileId, &Ast)> {
        let mut all: Vec<_> = self.trees.borrow().iter().map(|(&file, &index)| (file, index)).collect();
        all.sort_by_key(|(_, index)| *index);
        all.into_iter().filter_map(|(file, index)| Some((file, self.asts.get(index)?))).collect()
    }

    /// Returns the table of names that the syntax trees' symbols refer to.
    pub fn names(&self) -> &Names {
        &self.names
    }
}
