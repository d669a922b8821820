//! `turbulence`: displaces points at random (manual, "Turbulence").

use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::math::noise::{self, Turbulence};
use crate::value::{Kind, Reader, WordSpec};
use serde::Serialize;

/// The words of `turbulence`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Turbulent {
    /// How far a point is displaced along each axis, at most about.
    pub amount: DVec3,
    /// How many octaves are added up.
    pub octaves: f64,
    /// How much finer each octave is than the one before.
    pub lambda: f64,
    /// How much weaker.
    pub omega: f64,
}

impl Default for Turbulent {
    fn default() -> Self {
        Self::STILL
    }
}

impl Turbulent {
    /// No turbulence.
    pub const STILL: Self = Self { amount: DVec3::ZERO, octaves: 6.0, lambda: 2.0, omega: 0.5 };

    /// The words it takes.
    pub const WORDS: &[WordSpec] = &[
        WordSpec { name: "turbulence", kind: Kind::Vector, default: "0", summary: "how far points are displaced" },
        WordSpec {
            name: "octaves",
            kind: Kind::Float,
            default: "6",
            summary: "steps of ever finer turbulence, 1 to 10",
        },
        WordSpec { name: "lambda", kind: Kind::Float, default: "2", summary: "how much finer each step is" },
        WordSpec { name: "omega", kind: Kind::Float, default: "0.5", summary: "how much weaker each step is" },
    ];

    /// Reads what follows one of [`Self::WORDS`]; the word itself is consumed.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read_word(&mut self, word: &str, r: &mut dyn Reader) -> Result<()> {
        match word {
            "turbulence" => self.amount = r.vector()?,
            "octaves" => self.octaves = r.float()?,
            "lambda" => self.lambda = r.float()?,
            _ => self.omega = r.float()?,
        }
        Ok(())
    }

    /// How its octaves add up.
    pub fn series(&self) -> Turbulence {
        Turbulence::new(self.lambda, self.omega, self.octaves)
    }

    /// p + amount · vturbulence(p)
    pub fn displace(&self, p: DVec3) -> DVec3 {
        if self.amount == DVec3::ZERO { p } else { p + self.amount * noise::vturbulence(p, self.series()) }
    }
}
