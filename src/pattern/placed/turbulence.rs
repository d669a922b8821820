//! `turbulence`: displaces points at random (manual, "Turbulence").

use crate::math::DVec3;
use crate::math::noise::{self, Turbulence};
use crate::value::words::{Row, set, specs, word};
use crate::value::{ValueKind, WordSpec};
use serde::Serialize;

/// Parameters of a pattern's `turbulence`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TurbulenceParams {
    /// Approximate maximum displacement of points along each axis by turbulence.
    pub amount: DVec3,
    /// Number of octaves of noise in turbulence.
    pub octaves: f64,
    /// Factor of the frequency from one octave of turbulence to the next.
    pub lambda: f64,
    /// Factor of the strength from one octave of turbulence to the next.
    pub omega: f64,
}

impl Default for TurbulenceParams {
    fn default() -> Self {
        Self::STILL
    }
}

impl TurbulenceParams {
    /// Parameters of turbulence that leave every point unchanged.
    pub const STILL: Self = Self { amount: DVec3::ZERO, octaves: 6.0, lambda: 2.0, omega: 0.5 };

    /// Keywords of the parameters of `turbulence`.
    pub const WORDS: &[WordSpec] = specs!(Self::ROWS);

    /// Keywords of the parameters of `turbulence`, and how each is read.
    pub const ROWS: &[Row<Self>] = &[
        word("turbulence", ValueKind::Vector, "0", "how far points are displaced")
            .sets(|s, r| set(&mut s.amount, r.vector())),
        word("octaves", ValueKind::Float, "6", "steps of ever finer turbulence, 1 to 10")
            .sets(|s, r| set(&mut s.octaves, r.float())),
        word("lambda", ValueKind::Float, "2", "how much finer each step is").sets(|s, r| set(&mut s.lambda, r.float())),
        word("omega", ValueKind::Float, "0.5", "how much weaker each step is")
            .sets(|s, r| set(&mut s.omega, r.float())),
    ];

    /// Returns the octaves of noise that these parameters describe, without `amount`.
    pub fn to_octaves(&self) -> Turbulence {
        Turbulence::new(self.lambda, self.omega, self.octaves)
    }

    /// Displaces a point by turbulence: p + amount · vturbulence(p).
    pub fn displace(&self, p: DVec3) -> DVec3 {
        if self.amount == DVec3::ZERO { p } else { p + self.amount * noise::vturbulence(p, self.to_octaves()) }
    }
}
