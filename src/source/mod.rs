//! The files of a scene: storage, texts, positions in texts, the search path and the sandbox.

mod activity;
mod disk;
mod exclusive;
mod files;
pub mod fonts;
mod host;
mod lookup;
mod memory;
mod read;
mod recorder;
mod sandbox;
mod scenes;
mod search;
mod sources;
mod span;

pub use activity::Activity;
pub use disk::{Disk, Draft, follow_links, sync_folder_of};
pub use exclusive::{Exclusive, OpenError, open_or_create_regular};
pub use files::{Entry, FileKind, Files, Metadata, Stamp, WriteAccess, WriteMode};
pub use host::{Host, LocalHost};
pub use lookup::{LookedUpFiles, Lookup, Lookups};
pub use memory::{Memory, Overlay};
pub use read::{ReadError, read_text, text_of};
pub use recorder::{ContentHash, ReadFiles, Recorder};
pub use sandbox::{CreatedFiles, CreatedInSession, ReadPolicy, Sandbox, Sandboxed, WriteFolder, WritePolicy};
pub use scenes::{scenes_and_includes_below, scenes_below};
pub use search::{Found, SearchPath};
pub use sources::{FileId, Place, Sources, decode_text};
pub use span::Span;
