//! `dents`: noise with few high peaks (manual, "Dents").
//!
//! ```pov
//! sphere { 0, 1 pigment { dents color_map { [0 color rgb 0.9] [0.5 color rgb <0.6, 0.1, 0>] } scale 0.2 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::Result;
use crate::math::{DVec3, noise};
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `dents`: noise to the third power.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Dents {}

impl Readable for Dents {
    const SPEC: Spec = Spec { name: "dents", summary: "noise to the third power; in a normal, dents", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Dents {
    fn value(&self, at: &TextureContext) -> f64 {
        noise::noise(at.p, at.noise).powi(3)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        // (n³)' = 3 n² n'
        let noise = LocalBounds::from_max_gradient(noise::noise(at.p, at.noise), at.noise.max_gradient(), radius)
            .clamp_range(0.0, 1.0);
        let steepest = 3.0 * noise.range.hi.powi(2) * noise.steepest;
        LocalBounds { range: noise.range.map_increasing(|n| n.powi(3)), steepest, ..noise }
    }

    fn bumped_normal(&self, at: &TextureContext, _: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        Some(n + amount * self.value(at) * noise::noise_vector(at.p))
    }
}
