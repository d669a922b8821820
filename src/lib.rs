//! durer: an interpreter and renderer for scenes written by hand in POV-Ray's scene language.
//!
//! ```text
//! text ──syntax──▶ AST ──interpreter──▶ Scene ──world──▶ World ──render──▶ Frame ──image_io──▶ file
//! ```

pub mod camera;
pub mod color;
pub mod diagnostic;
pub mod image_io;
pub mod interpreter;
pub mod light;
pub mod math;
pub mod pattern;
pub mod render;
pub mod scene;
pub mod shape;
pub mod source;
pub mod syntax;
pub mod texture;
pub mod value;
pub mod world;
