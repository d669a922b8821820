//! `wood`: rings around the z axis (manual, "Wood").
//!
//! ```pov
//! box { -1, 1 pigment { wood turbulence 0.1 scale 0.2 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext, Wave};
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::{DVec2, DVec3, fp, noise};
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;
use std::f64::consts::TAU;

/// Pattern `wood`: rings around the z axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Wood {}

impl Readable for Wood {
    const SPEC: Spec =
        Spec { name: "wood", summary: "rings around the z axis, back and forth in each unit", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Wood {
    fn value(&self, at: &TextureContext) -> f64 {
        at.p.truncate().length()
    }

    fn value_bounds_near(&self, at: &TextureContext, params: &FieldParams, radius: f64) -> LocalBounds {
        if params.turbulence.amount != DVec3::ZERO {
            return LocalBounds::UNKNOWN;
        }
        LocalBounds::from_max_gradient(self.value(at), 1.0, radius)
    }

    fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        let by = params.turbulence;
        if by.amount == DVec3::ZERO {
            return self.value(at);
        }
        // Each coordinate is shifted by a sine of itself, whose phase is the noise.
        let p = at.p.truncate();
        let angle = TAU * by.amount.truncate() * (p + noise::vturbulence(at.p, by.to_octaves()).truncate());
        (p + DVec2::new(fp::sin(angle.x), fp::sin(angle.y))).length()
    }

    fn handles_turbulence_itself(&self) -> bool {
        true
    }

    fn default_wave(&self) -> Option<Wave> {
        Some(Wave::Triangle)
    }

    fn default_colors(&self) -> Vec<(f64, Color)> {
        let [early, late] = [[0.666, 0.312, 0.2], [0.4, 0.1333, 0.066]].map(|rgb| Color::opaque(rgb.into()));
        vec![(0.6, early), (0.6, late)]
    }
}
