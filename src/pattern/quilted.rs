//! `quilted`: cubes with soft seams (manual, "Quilted").
//!
//! ```pov
//! box { -1, 1 pigment { quilted control0 0.8 control1 0.5
//!   color_map { [0 color rgb <1, 0.9, 0.8>] [0.6 color rgb <0.4, 0, 0.2>] } scale 0.5 } }
//! ```

use super::{Field, FieldParams, TextureContext};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::words::{Row, set, specs, word};
use crate::value::{Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Pattern `quilted`: unit cubes with rounded edges; the number falls towards the seams.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quilted {
    /// Steepness of `quilted` in the middle of a cube.
    pub control0: f64,
    /// Steepness of `quilted` at the seam.
    pub control1: f64,
}

/// 1/√3 with POV-Ray's digits, for `quilted` (quirk: quilted_constant).
const PART: f64 = 0.577350269;

impl Readable for Quilted {
    const SPEC: Spec =
        Spec { name: "quilted", summary: "unit cubes with soft seams", words: specs!(Self::WORDS), ..Spec::EMPTY };

    const WORDS: &'static [Row<Self>] = &[
        word("control0", ValueKind::Float, "1", "the slope in the middle, 0 to 1")
            .sets(|s, r| set(&mut s.control0, r.float().map(|x| f64::from(x as f32)))),
        word("control1", ValueKind::Float, "1", "the slope at the seams, 0 to 1")
            .sets(|s, r| set(&mut s.control1, r.float().map(|x| f64::from(x as f32)))),
    ];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self { control0: 1.0, control1: 1.0 })
    }
}

impl Quilted {
    /// Evaluates the Bézier curve of `quilted` from 0 to 1 with the two controls.
    pub fn bezier_curve(&self, t: f64) -> f64 {
        let s = 1.0 - t;
        3.0 * self.control0 * t * s * s + 3.0 * self.control1 * t * t * s + t * t * t
    }
}

impl Field for Quilted {
    fn starts_with_zero_frequency(&self) -> bool {
        true
    }

    fn value(&self, at: &TextureContext) -> f64 {
        // distance from the middle of the cube
        let from = (at.p - at.p.floor() - 0.5).abs();
        self.bezier_curve(from.length()).abs() * PART * (from.x + from.y + from.z) * 2.0 / 3.0
    }

    fn bumped_normal(&self, at: &TextureContext, _: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        let from = at.p - at.p.floor() - 0.5;
        Some(n + amount * 2.0 * PART * self.bezier_curve(from.length()) * from)
    }
}
