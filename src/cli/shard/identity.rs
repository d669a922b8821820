//! Identity of a picture across machines: contents and names relative to the scene, not paths or times.

use crate::cli::journal::identity::Work;
use crate::source::ContentHash;
use crate::{interpreter, render};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::path::Path;
use std::time::Duration;

/// Everything that determines the pixels of a picture, without anything of the machine that renders it.
#[derive(Serialize, Deserialize, Clone, Debug, PartialEq)]
pub struct Identity {
    /// Version of the program.
    program: String,
    /// Options that change a pixel, and the moment of the animation.
    options: String,
    /// Names and hashes of all files that were read. A name is relative to the scene's folder if the file is below that
    /// folder; otherwise it is the file's name alone.
    files: BTreeSet<(String, ContentHash)>,
    /// Value of `now`, as time since the beginning of 1970, if the scene used it.
    now: Option<Duration>,
}

impl Identity {
    /// Creates the identity of a picture whose scene has been built.
    pub fn new(scene: &Path, reading: &interpreter::Options, drawing: &render::Options, work: &Work) -> Self {
        let folder = scene.canonicalize().ok().and_then(|path| path.parent().map(Path::to_path_buf));
        let name = |path: &Path| {
            let whole = path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
            let below = folder.as_ref().and_then(|folder| whole.strip_prefix(folder).ok());
            let parts = below.unwrap_or(Path::new(whole.file_name().unwrap_or_default())).components();
            let parts: Vec<_> = parts.map(|part| part.as_os_str().to_string_lossy()).collect();
            parts.join("/")
        };
        let interpreter::Options { timing, declares, version, .. } = reading;
        let drawing = render::Options { threads: 0, ..drawing.clone() };
        Self {
            program: env!("CARGO_PKG_VERSION").into(),
            options: format!("{drawing:?} {timing:?} {declares:?} {version:?}"),
            files: work.files.iter().map(|(path, hash)| (name(path), *hash)).collect(),
            now: work.now,
        }
    }

    /// Returns the reason why pixels of this identity and of `other` do not belong to one picture; `None` if they do.
    pub fn difference_reason(&self, other: &Self) -> Option<String> {
        if self.program != other.program {
            return Some(format!(
                "durer {} rendered it, and durer {} rendered the others",
                self.program, other.program
            ));
        }
        if self.options != other.options {
            return Some("it was rendered with other options".into());
        }
        if let Some((name, _)) = self.files.symmetric_difference(&other.files).next() {
            return Some(format!("`{name}` is not the same file"));
        }
        (self.now != other.now).then(|| "the scene uses `now`, whose value is another".into())
    }
}
