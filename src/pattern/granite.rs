//! `granite`: fine grains of all sizes (manual, "Granite").
//!
//! ```pov
//! sphere { 0, 1 pigment { granite color_map { [0 color rgb <0.3, 0.2, 0.2>] [0.5 color rgb 0.9] } } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::Result;
use crate::math::noise;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `granite`: the sum of six octaves of noise.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Granite {}

impl Readable for Granite {
    const SPEC: Spec = Spec { name: "granite", summary: "grains of all sizes", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

/// Weight of the last octave: the first one has the weight 1.
const WEIGHT_OF_LAST: f64 = 0.03125;

impl Field for Granite {
    fn value(&self, at: &TextureContext) -> f64 {
        // six octaves, each half as strong and twice as fine, of the distance of the noise from its mean
        let step = |(sum, weight): (f64, f64), noise: f64| {
            noise::continue_if(weight > WEIGHT_OF_LAST, (sum + weight * (0.5 - noise).abs(), 0.5 * weight))
        };
        noise::fold_clamped_octaves(at.p * 4.0, at.noise, (0.0, 1.0), step).0.min(1.0)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        // All six octaves are equally steep, apart from each one's range, and rarely in the same place.
        let steepest = 8.0 * at.noise.max_gradient();
        let octave = |i: i32| (steepest * radius).min(0.5f64.powi(i + 1));
        LocalBounds::from_deviation(self.value(at), (0..6).map(octave).sum(), 6.0 * steepest).clamp_range(0.0, 1.0)
    }
}
