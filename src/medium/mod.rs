//! Media between surfaces: the interior of shapes. One file a medium.

mod interior;

pub use interior::{INTERIOR, Interior};
