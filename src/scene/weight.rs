//! Size of objects, by which scenes are refused that would exhaust the memory: loops can nest objects, or double them.

use super::{Object, Scene};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;

/// Maximum nesting depth of objects, because functions recurse over objects.
const MAX_DEPTH: u32 = 5000;
/// Maximum number of shapes that clip one object, because each transform of the object copies them.
const MAX_CLIPPING: u32 = 1_000_000;
/// Approximate memory of a shape in the world, in bytes.
const PER_SHAPE: u64 = 1000;

/// Maximum number of shapes that can be numbered.
const MAX_SHAPES: u32 = u32::MAX / 2;

/// Nesting depth and number of shapes of an object, computed when the object is built.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Weight {
    /// Nesting depth of the object.
    depth: u32,
    /// Number of shapes, counting each instance; saturates.
    shapes: u32,
}

impl Weight {
    /// Nesting depth (0) and number of shapes (1) of a single shape.
    pub const SHAPE: Self = Self { depth: 0, shapes: 1 };

    /// Returns the number of shapes, counting each instance.
    pub fn n_shapes(self) -> u32 {
        self.shapes
    }

    /// Returns this weight with parts added: the depth and number of shapes of an object with these parts.
    pub fn enclosing(self, parts: &[Object]) -> Self {
        parts.iter().map(|part| part.weight()).fold(self, |sum, part| Self {
            depth: sum.depth.max(part.depth + 1),
            shapes: sum.shapes.saturating_add(part.shapes),
        })
    }

    /// Checks the nesting depth of an object.
    ///
    /// # Errors
    /// E0104 if the depth is above the maximum.
    pub fn check_depth(self, source: Span) -> Result<()> {
        if self.depth <= MAX_DEPTH {
            return Ok(());
        }
        let message = format!("more than {MAX_DEPTH} objects are inside each other here");
        Diagnostic::new(codes::TOO_DEEP, source, message)
            .help("a `union` takes any number of objects side by side")
            .into()
    }

    /// Checks the number of shapes that clip an object.
    ///
    /// # Errors
    /// E0242 if there are too many.
    pub fn check_clipping_shape_count(parts: &[Object], source: Span) -> Result<()> {
        if Self::default().enclosing(parts).shapes <= MAX_CLIPPING {
            return Ok(());
        }
        let message = format!("more than {MAX_CLIPPING} shapes clip one object");
        Diagnostic::err(codes::MEMORY_LIMIT, source, message)
    }
}

impl Scene {
    /// Checks whether the world of the scene fits into `memory` bytes.
    ///
    /// # Errors
    /// E0242 if the world is too large.
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
