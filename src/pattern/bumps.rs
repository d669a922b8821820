//! `bumps`: smooth noise, between 0 and 1 (manual, "Bumps").
//!
//! ```pov
//! sphere { 0, 1 pigment { bumps color_map { [0.5 color rgb <0.9, 0.7, 0.4>] [0.6 color rgb <0.4, 0.2, 0.1>] } scale 0.2 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::Result;
use crate::math::{DVec3, noise};
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `bumps`: smooth noise between 0 and 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bumps {}

impl Readable for Bumps {
    const SPEC: Spec =
        Spec { name: "bumps", summary: "as `bozo`, but for its colours; in a normal, bumps", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Bumps {
    fn value(&self, at: &TextureContext) -> f64 {
        noise::noise(at.p, at.noise)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        LocalBounds::from_max_gradient(self.value(at), at.noise.max_gradient(), radius).clamp_range(0.0, 1.0)
    }

    fn bumped_normal(&self, at: &TextureContext, _: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        Some(n + amount * noise::noise_vector(at.p))
    }
}
