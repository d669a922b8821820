//! `agate`: twisted bands (manual, "Agate").
//!
//! ```pov
//! sphere { 0, 1 pigment { agate agate_turb 0.7 } }
//! ```

use super::{Field, FieldParams, TextureContext};
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::{fp, noise};
use crate::value::words::{Row, set, specs, word};
use crate::value::{Readable, Reader, Spec, ValueKind};
use serde::Serialize;
use std::f64::consts::TAU;

/// Pattern `agate`: bands along z, displaced by noise.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Agate {
    /// Strength of the displacement of the `agate` pattern's bands; single precision, as in POV-Ray.
    pub turbulence: f64,
}

impl Readable for Agate {
    const SPEC: Spec = Spec {
        name: "agate",
        summary: "twisted bands; `octaves`, `lambda` and `omega` shape them too",
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] =
        &[word("agate_turb", ValueKind::Float, "1", "how much they are twisted; `turbulence` comes on top of it")
            .sets(|s, r| set(&mut s.turbulence, r.float().map(|x| f64::from(x as f32))))];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self { turbulence: 1.0 })
    }
}

impl Field for Agate {
    fn value(&self, at: &TextureContext) -> f64 {
        self.value_with_params(at, &FieldParams::NONE)
    }

    fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        band(fp::sin(self.angle(at, params)))
    }

    fn values_with_params(&self, at: &[TextureContext; 4], params: &FieldParams) -> [f64; 4] {
        fp::sines(at.each_ref().map(|at| self.angle(at, params))).map(band)
    }

    fn default_colors(&self) -> Vec<(f64, Color)> {
        [
            (0.0, [1.0, 1.0, 1.0]),
            (0.5, [0.95, 0.75, 0.5]),
            (0.5, [0.9, 0.7, 0.5]),
            (0.6, [0.9, 0.7, 0.4]),
            (0.6, [1.0, 0.7, 0.4]),
            (1.0, [0.6, 0.3, 0.0]),
        ]
        .map(|(at, rgb)| (at, Color::opaque(rgb.into())))
        .to_vec()
    }
}

impl Agate {
    /// Returns the angle whose sine determines the band at a point.
    fn angle(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        // quirk: agate_constants
        let turbulence = noise::turbulence(at.p, params.turbulence.to_octaves(), at.noise);
        TAU * (1.3 * self.turbulence * turbulence + 1.1 * at.p.z)
    }
}

/// Returns the pattern's number for the sine of an angle.
fn band(sine: f64) -> f64 {
    fp::pow(0.5 * (sine + 1.0), 0.77)
}
