//! `radial`: once around the y axis (manual, "Radial").
//!
//! ```pov
//! cylinder { 0, y, 1 pigment { radial frequency 6 color_map { [0.5 color rgb <1, 0.2, 0.2>] [0.5 color rgb 1] } } }
//! ```

use super::{Field, SIX_COLORS, TextureContext};
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::fp;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;
use std::f64::consts::TAU;

/// Pattern `radial`: the angle around the y axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Radial {}

impl Readable for Radial {
    const SPEC: Spec = Spec { name: "radial", summary: "once around the y axis, from +x over -z", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Radial {
    fn value(&self, at: &TextureContext) -> f64 {
        // Near the axis the number is constant; the angle from -z exceeds 1, which the wave wraps.
        if at.p.x.abs() < 0.001 && at.p.z.abs() < 0.001 {
            return 0.25;
        }
        0.75 + fp::atan2(at.p.x, at.p.z) / TAU
    }

    fn default_colors(&self) -> Vec<(f64, Color)> {
        let [.., yellow, cyan, magenta] = SIX_COLORS.map(Color::opaque);
        [(0.0, cyan), (0.333, yellow), (0.666, magenta), (1.0, cyan)].to_vec()
    }
}
