//! `onion`: shells around the origin (manual, "Onion").
//!
//! ```pov
//! box { <-1, -1, 0>, 1 pigment { onion color_map { [0 color rgb <0.5, 0.2, 0.4>] [1 color rgb <1, 0.9, 0.9>] } scale 0.3 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::Result;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `onion`: spherical shells around the origin.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Onion {}

impl Readable for Onion {
    const SPEC: Spec = Spec { name: "onion", summary: "shells around the origin, one in each unit", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Onion {
    fn value(&self, at: &TextureContext) -> f64 {
        at.p.length().fract()
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        LocalBounds::from_max_gradient(at.p.length(), 1.0, radius).fractional_part_bounds()
    }
}
