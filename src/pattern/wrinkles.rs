//! `wrinkles`: noise of all sizes (manual, "Wrinkles").
//!
//! ```pov
//! sphere { 0, 1 pigment { wrinkles color_map { [0.2 color rgb <0.2, 0.3, 0.1>] [0.8 color rgb <0.9, 1, 0.6>] } scale 0.3 } }
//! ```

use super::{Field, Readable, Spot, Words};
use crate::diagnostic::Result;
use crate::math::{DVec3, noise};
use crate::value::{Reader, Spec};
use serde::Serialize;

/// Sums of noise.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Wrinkles {}

impl Readable for Wrinkles {
    const SPEC: Spec =
        Spec { name: "wrinkles", summary: "noise of all sizes; in a normal, crumpled foil", params: &[], words: &[] };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Wrinkles {
    fn value(&self, at: &Spot) -> f64 {
        // ten octaves, each half as strong and twice as fine
        (0..10).map(|i| 0.5f64.powi(i + 1) * noise::octave(at.p * 2f64.powi(i), at.noise)).sum()
    }

    fn bumped(&self, at: &Spot, _: &Words, n: DVec3, amount: f64) -> Option<DVec3> {
        // ten octaves of the noise's size along each axis
        let octave = |i: i32| 0.5f64.powi(i) * noise::noise_vector(at.p * 2f64.powi(i)).abs();
        Some(n + amount * (0..10).map(octave).sum::<DVec3>())
    }
}
