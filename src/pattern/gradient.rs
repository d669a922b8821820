//! `gradient <vector>`: grows along a direction and repeats after each unit (manual, "Gradient").
//!
//! ```pov
//! sphere { 0, 1 pigment { gradient y color_map { [0 color rgb 0] [1 color rgb 1] } scale 2 translate -y } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::DVec3;
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Pattern `gradient`: a ramp along a direction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Gradient {
    /// Unit vector along which the number of `gradient` grows.
    pub direction: DVec3,
}

impl Readable for Gradient {
    const SPEC: Spec = Spec {
        name: "gradient",
        summary: "a ramp that begins anew after each unit along a direction",
        params: &[Param {
            name: "orientation",
            kind: ValueKind::Vector,
            summary: "the direction; its length does not matter",
        }],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let vector = r.vector()?;
        match vector.try_normalize() {
            Some(direction) => Ok(Self { direction }),
            None => Diagnostic::err(codes::ZERO_VECTOR, span, "a gradient needs a direction, this vector is zero"),
        }
    }
}

impl Field for Gradient {
    fn value(&self, at: &TextureContext) -> f64 {
        // Negative numbers keep their sign here; frequency and phase bring them into [0, 1]. The first period includes
        // its end.
        let along = at.p.dot(self.direction);
        if along > 1.0 { along.fract() } else { along }
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        let along = LocalBounds::from_max_gradient(at.p.dot(self.direction), self.direction.length(), radius);
        match along.range {
            range if range.hi <= 1.0 => along,
            range if range.lo > 1.0 => along.fractional_part_bounds(),
            _ => LocalBounds::UNKNOWN,
        }
    }
}
