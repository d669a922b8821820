//! The files of a scene: their text, places in them, and where they may be looked for.

mod files;
pub mod fonts;
mod read;
mod sandbox;
mod scenes;
mod search;
mod seen;
mod span;
mod write;

pub use files::{FileId, Place, Sources, decode_text};
pub use read::{ReadError, read_text, text_of};
pub use sandbox::Sandbox;
pub use scenes::{scenes_below, texts_below};
pub use search::{Found, SearchPath};
pub use seen::{Seen, fingerprint, forget, note, read_bytes, seen};
pub use span::Span;
pub use write::{Draft, check_writable, write_whole};
