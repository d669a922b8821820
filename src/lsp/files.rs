//! Cache of the files that open texts include: read once, and again after a change. An open text replaces the file of
//! the same path.

use super::document::{BASE, Document, MAX_TEXT};
use super::text::Text;
use crate::library;
use crate::source::{Disk, Files as _, SearchPath, Stamp, read_text};
use crate::syntax::{Outline, tokens_of};
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A file that an open document includes.
pub struct File {
    /// Contents of the included file.
    pub text: Arc<Text>,
    /// Outline of the included file.
    pub outline: Arc<Outline>,
    /// State of the included file when it was read.
    read: Option<Stamp>,
}

/// Cache of included files by path.
#[derive(Default)]
pub struct Files(BTreeMap<PathBuf, File>);

/// Largest number of files that are reached from a text.
const MAX_FILES: usize = 500;

impl Files {
    /// Returns the included file at a path, real or built in, from the cache, and reads it if it is new or has changed. `None`
    /// if it cannot be read, is no text, or is longer than [`MAX_TEXT`].
    fn load(&mut self, path: &Path) -> Option<&File> {
        let now = Disk.stamp(path);
        if self.0.get(path).is_none_or(|file| file.read != now) {
            let built_in =
                path.strip_prefix(library::FOLDER).ok().and_then(Path::to_str).and_then(library::builtin_file_text);
            let text = match built_in {
                Some(text) => text.to_string(),
                None if Disk.metadata(path).is_ok_and(|file| file.length > MAX_TEXT as u64) => return None,
                None => read_text(&Disk, path).ok()?,
            };
            let outline = Arc::new(Outline::new(&text, &tokens_of(&text, BASE).0));
            self.0.insert(path.to_path_buf(), File { text: Arc::new(Text::new(text)), outline, read: now });
        }
        self.0.get(path)
    }
}

/// Text of an open document, or of a file that the document includes directly or indirectly.
#[derive(Clone)]
pub struct ReachableText {
    /// Path; `None` for a text that is not saved.
    pub path: Option<PathBuf>,
    /// Present text of a file that the document reaches.
    pub text: Arc<Text>,
    /// Outline of a file that the document reaches.
    pub outline: Arc<Outline>,
}

/// Returns the path of the file that a text in `folder` includes under this name, real or built in; `None` if there is no
/// such file.
pub fn find_included_file(name: &str, folder: &Path, search: &SearchPath) -> Option<PathBuf> {
    let including = folder.join("file");
    let found = search.resolve(&Disk, name, Some(&including)).map(|found| found.path);
    found.or_else(|| library::builtin_file_text(name).map(|_| Path::new(library::FOLDER).join(name)))
}

/// Returns the text `from` first, and then all files that it includes, directly or indirectly, none twice. The text of an
/// open document replaces its file.
pub fn texts_reachable_from(
    files: &mut Files,
    open: &BTreeMap<String, Document>,
    from: &Document,
    include: &[PathBuf],
) -> Vec<ReachableText> {
    let search = SearchPath::new(&from.folder(), include);
    let own =
        ReachableText { path: from.path.clone(), text: Arc::new(from.text.clone()), outline: from.outline.clone() };
    let (mut out, mut seen) = (vec![own], HashSet::new());
    seen.extend(from.path.clone());
    let mut at = 0;
    while at < out.len() && out.len() < MAX_FILES {
        let (outline, folder) =
            (out[at].outline.clone(), out[at].path.as_deref().and_then(Path::parent).map(Path::to_path_buf));
        for name in &outline.includes {
            let Some(path) =
                find_included_file(outline.slice(name), folder.as_deref().unwrap_or(Path::new(".")), &search)
            else {
                continue;
            };
            if !seen.insert(path.clone()) {
                continue;
            }
            let is_it = |document: &&Document| document.path.as_deref().is_some_and(|open| are_same_file(open, &path));
            let reached = match open.values().find(is_it) {
                Some(open) => Some((Arc::new(open.text.clone()), open.outline.clone())),
                None => files.load(&path).map(|file| (file.text.clone(), file.outline.clone())),
            };
            out.extend(reached.map(|(text, outline)| ReachableText { path: Some(path), text, outline }));
        }
        at += 1;
    }
    out
}

/// True if both paths name the same file.
pub fn are_same_file(a: &Path, b: &Path) -> bool {
    a == b || a.file_name() == b.file_name() && matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}
