//! Decodes and encodes pixel files; nothing else opens one.

mod frame;

pub use frame::Frame;
