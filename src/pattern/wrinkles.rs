//! `wrinkles`: noise of all sizes (manual, "Wrinkles").
//!
//! ```pov
//! sphere { 0, 1 pigment { wrinkles color_map { [0.2 color rgb <0.2, 0.3, 0.1>] [0.8 color rgb <0.9, 1, 0.6>] } scale 0.3 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::Result;
use crate::math::{DVec3, noise};
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `wrinkles`: the sum of ten octaves of noise.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Wrinkles {}

impl Readable for Wrinkles {
    const SPEC: Spec =
        Spec { name: "wrinkles", summary: "noise of all sizes; in a normal, crumpled foil", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

/// Negative powers of two: element i is 2⁻ⁱ.
const HALVES: [f64; 10] = [1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625, 0.0078125, 0.00390625, 0.001953125];

impl Field for Wrinkles {
    fn value(&self, at: &TextureContext) -> f64 {
        // ten octaves, each half as strong and twice as fine
        let octaves = noise::clamped_octaves::<10>(at.p, at.noise);
        octaves.iter().zip(HALVES).map(|(noise, weight)| 0.5 * weight * noise).sum()
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        // All ten octaves are equally steep, apart from each one's range, and rarely in the same place.
        let steepest = at.noise.max_gradient();
        let octave = |most: f64| (steepest * radius).min(0.5 * most);
        let far = HALVES.into_iter().map(octave).sum();
        LocalBounds::from_deviation(self.value(at), far, 10.0 * steepest).clamp_range(0.0, 1.0)
    }

    fn bumped_normal(&self, at: &TextureContext, _: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        // ten octaves of the noise's absolute value along each axis
        let octave = |weight| weight * noise::noise_vector(at.p / weight).abs();
        Some(n + amount * HALVES.into_iter().map(octave).sum::<DVec3>())
    }
}
