//! `spiral1 N`: the thread of a screw around the z axis (manual, "Spiral1").
//!
//! ```pov
//! cylinder { 0, 0.2*z, 1 pigment { spiral1 5 color_map { [0.5 color rgb <0.1, 0.2, 0.5>] [0.5 color rgb 1] } scale 0.6 } }
//! ```

use super::{Field, FieldParams, TextureContext, Wave};
use crate::diagnostic::Result;
use crate::math::{DVec3, fp, noise};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;
use std::f64::consts::TAU;

/// Parameter for the number of arms of the patterns `spiral1` and `spiral2`.
pub(super) const ARMS: &[Param] = &[Param {
    name: "arms",
    kind: ValueKind::Float,
    summary: "how many arms wind around the axis; the fraction is dropped",
}];

/// Pattern `spiral1`: spiral arms around the z axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spiral1 {
    /// Number of arms of `spiral1` around the z axis.
    pub arms: f64,
}

impl Readable for Spiral1 {
    const SPEC: Spec =
        Spec { name: "spiral1", summary: "arms of a spiral around the z axis", params: ARMS, ..Spec::EMPTY };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self { arms: r.float()?.trunc() })
    }
}

impl Field for Spiral1 {
    fn value(&self, at: &TextureContext) -> f64 {
        self.value_with_params(at, &FieldParams::NONE)
    }

    fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        spiral_number(at.p, self.arms) + turbulence_shift(at, params)
    }

    fn default_wave(&self) -> Option<Wave> {
        Some(Wave::Triangle)
    }
}

/// Returns the number of a spiral pattern before its wave: it grows by 1 with each unit along z and away from it, and
/// by the number of arms with each turn, starting at -y.
pub(super) fn spiral_number(p: DVec3, arms: f64) -> f64 {
    if p.x == 0.0 && p.y == 0.0 {
        return p.z;
    }
    let turn = fp::atan2(p.y, p.x) / TAU + 0.25;
    p.z + p.truncate().length() + arms * fp::fraction_above_floor(turn)
}

/// Returns the number that `turbulence` adds to a spiral pattern, in addition to the displacement of the point.
pub(super) fn turbulence_shift(at: &TextureContext, params: &FieldParams) -> f64 {
    let amount = params.turbulence.amount.x;
    if amount == 0.0 { 0.0 } else { amount * noise::turbulence(at.p, params.turbulence.to_octaves(), at.noise) }
}
