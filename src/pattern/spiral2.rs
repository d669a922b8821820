//! `spiral2 N`: two crossing spirals (manual, "Spiral2").
//!
//! ```pov
//! cylinder { 0, 0.2*z, 1 pigment { spiral2 8 color_map { [0.4 color rgb <0.5, 0.3, 0.1>] [0.6 color rgb <1, 0.9, 0.5>] } scale 0.6 } }
//! ```

use super::spiral1::{ARMS, spiral_number, turbulence_shift};
use super::{Field, FieldParams, TextureContext, Wave};
use crate::diagnostic::Result;
use crate::math::fp;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `spiral2`: a spiral over rings.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spiral2 {
    /// Number of arms of `spiral2` around the z axis.
    pub arms: f64,
}

impl Readable for Spiral2 {
    const SPEC: Spec =
        Spec { name: "spiral2", summary: "crossed arms of spirals around the z axis", params: ARMS, ..Spec::EMPTY };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self { arms: r.float()?.trunc() })
    }
}

impl Field for Spiral2 {
    fn value(&self, at: &TextureContext) -> f64 {
        self.value_with_params(at, &FieldParams::NONE)
    }

    fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        // rings and a thread, each as a triangle wave
        triangle_wave(at.p.truncate().length())
            + triangle_wave(spiral_number(at.p, self.arms) + turbulence_shift(at, params))
    }

    fn default_wave(&self) -> Option<Wave> {
        Some(Wave::Triangle)
    }
}

fn triangle_wave(x: f64) -> f64 {
    1.0 - (2.0 * fp::fraction_above_floor(x) - 1.0).abs()
}
