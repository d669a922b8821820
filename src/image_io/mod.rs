//! Decodes and encodes pixel files; nothing else opens one.

mod decode;
mod density;
mod encode;
mod format;
mod frame;
mod picture;
mod quantize;
#[cfg(test)]
mod tests;

use decode::decode_bytes;
pub use decode::{Pixels, Samples, decode, decode_file, spread};
pub use density::Voxels;
pub use encode::{Encoding, encode};
pub use format::Format;
pub use frame::Frame;
pub use picture::{Picture, Stored};
