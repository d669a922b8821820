//! `spotted`: smooth noise, between 0 and 1 (manual, "Spotted").
//!
//! ```pov
//! sphere { 0, 1 pigment { spotted color_map { [0.5 color rgb <0.9, 0.7, 0.4>] [0.6 color rgb <0.4, 0.2, 0.1>] } scale 0.2 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::Result;
use crate::math::noise;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `spotted`: smooth noise between 0 and 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spotted {}

impl Readable for Spotted {
    const SPEC: Spec = Spec { name: "spotted", summary: "as `bozo`, but for its colours", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Spotted {
    fn value(&self, at: &TextureContext) -> f64 {
        noise::noise(at.p, at.noise)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        LocalBounds::from_max_gradient(self.value(at), at.noise.max_gradient(), radius).clamp_range(0.0, 1.0)
    }
}
