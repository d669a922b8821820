//! How large an object is: a loop makes a few lines of text deep as a well, or double themselves until no memory holds them.

use super::{Object, Scene};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;

/// Objects inside each other; whoever walks them recurses.
const MAX_DEPTH: u32 = 5000;
/// Shapes that clip one object: they are copied whenever it moves.
const MAX_CLIPPING: u32 = 1_000_000;
/// Bytes that each shape takes in the world, about.
const PER_SHAPE: u64 = 1000;

/// More shapes have no numbers.
const MAX_SHAPES: u32 = u32::MAX / 2;

/// Known when an object is made, so that nobody has to walk it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Weight {
    /// Objects inside each other.
    depth: u32,
    /// Shapes in it, each counted as often as it is there; the largest number stands for more.
    shapes: u32,
}

impl Weight {
    /// Of one shape.
    pub const SHAPE: Self = Self { depth: 0, shapes: 1 };

    /// How many shapes are in it.
    pub fn shapes(self) -> u32 {
        self.shapes
    }

    /// With these inside.
    pub fn around(self, parts: &[Object]) -> Self {
        parts.iter().map(|part| part.weight()).fold(self, |sum, part| Self {
            depth: sum.depth.max(part.depth + 1),
            shapes: sum.shapes.saturating_add(part.shapes),
        })
    }

    /// E0104 if it is deeper than anybody can walk.
    ///
    /// # Errors
    /// E0104, if so.
    pub fn check(self, source: Span) -> Result<()> {
        if self.depth <= MAX_DEPTH {
            return Ok(());
        }
        let message = format!("more than {MAX_DEPTH} objects are inside each other here");
        Diagnostic::new(codes::TOO_DEEP, source, message)
            .help("a `union` takes any number of objects side by side")
            .into()
    }

    /// E0242 if these are too many to clip with.
    ///
    /// # Errors
    /// E0242, if so.
    pub fn check_clipping(parts: &[Object], source: Span) -> Result<()> {
        if Self::default().around(parts).shapes <= MAX_CLIPPING {
            return Ok(());
        }
        let message = format!("more than {MAX_CLIPPING} shapes clip one object");
        Diagnostic::err(codes::MEMORY_LIMIT, source, message)
    }
}

impl Scene {
    /// E0242 if the world of this scene would not go into so many bytes.
    ///
    /// # Errors
    /// E0242, if so.
    pub fn check_weight(&self, memory: Option<u64>) -> Result<()> {
        let limit = memory.map_or(MAX_SHAPES, |bytes| (bytes / PER_SHAPE).min(MAX_SHAPES.into()) as u32);
        let mut shapes: u32 = 0;
        for object in &self.objects {
            shapes = shapes.saturating_add(object.weight().shapes);
            if shapes > limit {
                let message =
                    format!("with this object the scene has more than the {limit} shapes for which there is memory");
                return Diagnostic::new(codes::MEMORY_LIMIT, object.source, message)
                    .help("an object that holds two of another doubles it; --max-memory SIZE allows more")
                    .into();
            }
        }
        Ok(())
    }
}
