//! Decodes and encodes pixel files; nothing else opens one.

mod decode;
mod encode;
mod format;
mod frame;
mod quantize;
#[cfg(test)]
mod tests;

pub use decode::{Pixels, Samples, decode, decode_file};
pub use encode::{Encoding, encode};
pub use format::Format;
pub use frame::Frame;
