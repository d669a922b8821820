//! Identity of a picture's work: the same work gives the same bytes, so that an unfinished picture can be continued.

use crate::source::{ContentHash, Disk, Files, Lookup, Lookups, ReadFiles};
use crate::{interpreter, render};
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// All inputs that determine the bytes of a picture, except for the program.
#[derive(Serialize, Deserialize, Clone, Debug, PartialEq)]
pub struct Work {
    /// Options of the render that affect the picture, from [`picture_options_text`].
    pub options: String,
    /// Files that were read, with hashes.
    pub files: ReadFiles,
    /// Look-ups of files: which exist, and where included files were found.
    pub lookups: Lookups,
    /// Value of `now`, as time since the beginning of 1970, if the scene used it.
    pub now: Option<Duration>,
}

/// Inputs of a picture (`Work`), with the identity of the program that began to render it.
#[derive(Serialize, Deserialize, Clone, Debug, PartialEq)]
pub struct Begun {
    /// Identity of the program, from [`program_identity`].
    program: String,
    /// Inputs that determine the bytes of the picture: options, files, look-ups and `now`.
    pub work: Work,
}

impl Begun {
    /// Records that the running program begins this work: adds the identity of the program.
    pub fn new(work: Work) -> Self {
        Self { program: program_identity().into(), work }
    }

    /// Parses the header of a journal, as JSON: the work, and the program that began it.
    ///
    /// # Errors
    /// If another version of the program wrote the text, or it is damaged.
    pub fn parse(text: &[u8]) -> Result<Self, String> {
        #[derive(Deserialize)]
        struct Writer {
            program: String,
        }
        let damaged = |_| "it is damaged".to_string();
        let Writer { program: writer } = serde_json::from_slice(text).map_err(damaged)?;
        if writer != program_identity() {
            return Err("it is from another version of durer".into());
        }
        serde_json::from_slice(text).map_err(damaged)
    }

    /// True if this program would do the same work now: with these options, and from files and look-ups that did not change.
    /// `known_hashes` has the hashes of files that this process will not read again. The value of `now` is not compared.
    pub fn is_current(&self, options: &str, known_hashes: &ReadFiles) -> bool {
        let hash = |path: &Path| {
            let on_disk = || Disk.read(path).ok().map(|bytes| ContentHash::of(&bytes));
            known_hashes.get(path).copied().or_else(on_disk)
        };
        let is_same = |(path, lookups): (_, &Vec<Lookup>)| lookups.iter().all(|lookup| lookup.is_current(&Disk, path));
        self.program == program_identity()
            && self.work.options == options
            && self.work.files.iter().all(|(path, read)| hash(path) == Some(*read))
            && self.work.lookups.iter().map(|(path, lookups)| (path.as_path(), lookups)).all(is_same)
    }
}

impl Work {
    /// Returns the reason why this work cannot continue `other`; `None` if it can. Files that only `other` has read are no
    /// reason.
    pub fn difference_reason(&self, other: &Work) -> Option<String> {
        if self.options != other.options {
            return Some("it was rendered with other options".into());
        }
        let changed = |(path, hash): &(&PathBuf, &ContentHash)| other.files.get(*path).is_some_and(|old| old != *hash);
        if let Some((path, _)) = self.files.iter().find(changed) {
            return Some(format!("`{}` has changed", path.display()));
        }
        let changed = self.lookups.iter().find(|(path, found)| other.lookups.get(*path) != Some(found));
        if let Some((path, found)) = changed {
            let change = match (&found[..], other.lookups.get(path).map(Vec::as_slice)) {
                ([Lookup::Kind(Some(_)), ..], Some([Lookup::Kind(None)])) => "exists now",
                ([Lookup::Kind(None)], Some([Lookup::Kind(Some(_)), ..])) => "does not exist any more",
                _ => "has changed",
            };
            return Some(format!("the scene has changed: `{}` {change}", path.display()));
        }
        // The scene reads a file that it did not read before, for whatever reason.
        if let Some((path, _)) = self.files.iter().find(|(path, _)| !other.files.contains_key(*path)) {
            return Some(format!("`{}` has changed", path.display()));
        }
        (self.now != other.now).then(|| "the scene uses `now`, which has changed".into())
    }
}

/// Returns the identity of this program: its version and a hash of its executable file.
///
/// Development versions share one number, and a commit does not describe a changed work tree; size and time of the file
/// change when the same program is copied, and may stay when another one replaces it. The hash takes some milliseconds,
/// and is computed only if a journal is read or written.
pub fn program_identity() -> &'static str {
    static PROGRAM: LazyLock<String> = LazyLock::new(|| {
        let hash = EXECUTABLE.as_ref().and_then(|file| {
            let mut hasher = blake3::Hasher::new();
            hasher.update_reader(file).ok()?;
            Some(hasher.finalize().to_hex().to_string())
        });
        // A program that cannot read its own file continues no journal, and no other program continues its journals.
        let unique = || {
            let time = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
            format!("process {} at {} ns", std::process::id(), time.as_nanos())
        };
        format!("{} {}", env!("CARGO_PKG_VERSION"), hash.unwrap_or_else(unique))
    });
    &PROGRAM
}

/// Opens the program's file, so that a later [`program_identity`] does not read the file of an update.
pub fn open_own_executable() {
    LazyLock::force(&EXECUTABLE);
}

static EXECUTABLE: LazyLock<Option<File>> = LazyLock::new(|| {
    // Linux: this link leads to the running program even after the file was replaced.
    let own = File::open("/proc/self/exe");
    own.or_else(|_| std::env::current_exe().and_then(File::open)).ok()
});

/// Lists all options that change a pixel, and the moment of the animation.
pub fn picture_options_text(reading: &interpreter::Options, drawing: &render::Options) -> String {
    let drawing = render::Options { threads: 0, ..drawing.clone() };
    let interpreter::Options { timing, header, declares, version, search, input_name, sandbox, .. } = reading;
    let read = &sandbox.read;
    format!("{drawing:?} {timing:?} {header:?} {declares:?} {version:?} {search:?} {input_name:?} {read:?}")
}
