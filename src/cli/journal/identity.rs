//! Identity of a picture's work: the same work gives the same bytes, so that an unfinished picture can be continued.

use crate::source::ReadFiles;
use crate::{interpreter, render};
use serde::{Deserialize, Serialize};

/// All inputs that determine the bytes of a picture.
#[derive(Serialize, Deserialize, Clone, Debug, PartialEq)]
pub struct Work {
    /// Identity of the program that rendered, from [`program`].
    pub program: String,
    /// Options of the render that affect the picture, from [`options`].
    pub options: String,
    /// Files that were read, with hashes.
    pub files: ReadFiles,
}

impl Work {
    /// Returns the reason why this work cannot continue `other`; `None` if both are the same.
    pub fn differs(&self, other: &Work) -> Option<String> {
        if self.program != other.program {
            return Some("it is from another version of durer".into());
        }
        if self.options != other.options {
            return Some("it was rendered with other options".into());
        }
        let changed = self.files.iter().find(|(path, hash)| other.files.get(*path) != Some(hash));
        changed.map(|(path, _)| format!("`{}` has changed", path.display()))
    }
}

/// Identifies this program: its version, and size and time of its file, since development versions share one number.
pub fn program() -> String {
    let file = std::env::current_exe().and_then(std::fs::metadata);
    let modified = |file: &std::fs::Metadata| file.modified().ok()?.duration_since(std::time::UNIX_EPOCH).ok();
    let file = file.map_or(String::new(), |file| format!("{} {:?}", file.len(), modified(&file).unwrap_or_default()));
    format!("{} {file}", env!("CARGO_PKG_VERSION"))
}

/// Lists all options that change a pixel, and the moment of the animation.
pub fn options(reading: &interpreter::Options, drawing: &render::Options) -> String {
    let drawing = render::Options { threads: 0, ..drawing.clone() };
    let interpreter::Options { timing, declares, version, search, input_name, .. } = reading;
    format!("{drawing:?} {timing:?} {declares:?} {version:?} {search:?} {input_name:?}")
}
