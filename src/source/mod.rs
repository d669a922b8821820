//! The files of a scene: their text, places in them, and where they may be looked for.

mod files;
mod search;
mod span;

pub use files::{FileId, Place, Sources, decode_text};
pub use search::SearchPath;
pub use span::Span;
