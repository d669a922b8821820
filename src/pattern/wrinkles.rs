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

/// Weight of the last octave: the first one has the weight 0.5.
const WEIGHT_OF_LAST: f64 = 0.5 * HALVES[9];

/// Negative powers of two: element i is 2⁻ⁱ.
const HALVES: [f64; 10] = [1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625, 0.0078125, 0.00390625, 0.001953125];

impl Field for Wrinkles {
    fn value(&self, at: &TextureContext) -> f64 {
        self.value_with_params(at, &FieldParams::NONE)
    }

    fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        let constant_below = params.constant_below;
        let step = |(sum, weight): (f64, f64), noise| {
            let sum = sum + weight * noise;
            // The octaves that are left add at most `weight`.
            let is_undecided = sum + weight >= constant_below;
            noise::continue_if(weight > WEIGHT_OF_LAST && is_undecided, (sum, 0.5 * weight))
        };
        noise::fold_clamped_octaves(at.p, at.noise, (0.0, 0.5), step).0
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::noise::NoiseGenerator;

    #[test]
    fn numbers_in_the_constant_start_stay_there_and_others_are_exact() {
        for generator in [NoiseGenerator::Original, NoiseGenerator::RangeCorrected, NoiseGenerator::Perlin] {
            for i in 0..500 {
                let p = DVec3::new(0.37, -1.93, 0.11) * f64::from(i);
                let at = TextureContext::without_surface(p, generator);
                let exact = Wrinkles {}.value(&at);
                for constant_below in [0.0, 0.3, exact, exact.next_up(), 0.6, 1.5] {
                    let params = FieldParams { constant_below, ..FieldParams::NONE };
                    let number = Wrinkles {}.value_with_params(&at, &params);
                    let may_differ = exact < constant_below && (0.0..constant_below).contains(&number);
                    assert!(number == exact || may_differ, "{p} {constant_below}: {number} for {exact}");
                }
            }
        }
    }
}
