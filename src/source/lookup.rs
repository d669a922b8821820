//! Look-ups of files: questions about a path other than the contents of its file, with their answers.

use super::{ContentHash, Entry, FileKind, Files, ReadFiles};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// Look-ups by path, each in the order of its first occurrence; different answers mean that files changed in the run.
pub type Lookups = BTreeMap<PathBuf, Vec<Lookup>>;

/// Files that a run read, and paths that it only asked about.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LookedUpFiles {
    /// Files that were read.
    pub read: ReadFiles,
    /// Questions about paths during the run, with their answers.
    pub lookups: Lookups,
}

impl LookedUpFiles {
    /// Adds the files of another run, whose hashes and answers replace those about the same path.
    pub fn extend(&mut self, other: Self) {
        self.read.extend(other.read);
        self.lookups.extend(other.lookups);
    }
}

/// Answer of the storage to a question about a path.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Lookup {
    /// Kind of the entry at the path; `None` for a missing entry.
    Kind(Option<FileKind>),
    /// Hash of the names in the folder.
    Names(ContentHash),
    /// Spelling, in a folder, of a name whose letter case is ignored.
    Spelling {
        /// Name that was searched for, in any letter case.
        name: String,
        /// Name as the folder spells it; `None` for a missing entry.
        found: Option<String>,
    },
    /// Path without links, relative if it is below the current folder; `None` for a missing entry.
    Target(Option<PathBuf>),
    /// Length and time of modification, in nanoseconds since 1970, of a file that is one of several candidates.
    Version(Option<(u64, u128)>),
}

impl Lookup {
    /// Returns the answer about the names in a folder.
    pub fn names(entries: &[Entry]) -> Self {
        let mut names: Vec<_> = entries.iter().map(|entry| entry.name.as_encoded_bytes()).collect();
        names.sort_unstable();
        Self::Names(ContentHash::of(&names.join(&0)))
    }

    /// Returns the answer about the path without links; `target` is that path, and `None` for a missing entry.
    pub fn target(files: &dyn Files, target: Option<&Path>) -> Self {
        let current = files.canonicalize(Path::new(".")).unwrap_or_default();
        Self::Target(target.map(|target| target.strip_prefix(current).unwrap_or(target).to_path_buf()))
    }

    /// Returns the present answer about the file's length and time of modification.
    pub fn version(files: &dyn Files, path: &Path) -> Self {
        let metadata = files.metadata(path).ok();
        Self::Version(metadata.map(|metadata| {
            let modified = metadata.modified.and_then(|time| time.duration_since(UNIX_EPOCH).ok());
            (metadata.length, modified.unwrap_or_default().as_nanos())
        }))
    }

    /// True if the storage would give the same answer about `path` now.
    pub fn is_current(&self, files: &dyn Files, path: &Path) -> bool {
        let now = match self {
            Self::Kind(_) => Self::Kind(files.metadata(path).ok().map(|metadata| metadata.kind)),
            Self::Names(_) => Self::names(files.list(path).as_deref().unwrap_or_default()),
            Self::Spelling { name, .. } => {
                Self::Spelling { name: name.clone(), found: files.entry_in_any_case(path, name) }
            }
            Self::Target(_) => Self::target(files, files.canonicalize(path).ok().as_deref()),
            Self::Version(_) => Self::version(files, path),
        };
        now == *self
    }
}
