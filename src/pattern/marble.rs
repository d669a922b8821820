//! `marble`: bands along x (manual, "Marble").
//!
//! ```pov
//! sphere { 0, 1 pigment { marble turbulence 0.8 scale 0.4 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext, Wave};
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::math::noise;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `marble`: bands along x.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Marble {}

impl Readable for Marble {
    const SPEC: Spec = Spec {
        name: "marble",
        summary: "bands across x, back and forth; of `turbulence` only the first number counts",
        ..Spec::EMPTY
    };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Marble {
    fn value(&self, at: &TextureContext) -> f64 {
        at.p.x
    }

    fn value_bounds_near(&self, at: &TextureContext, params: &FieldParams, radius: f64) -> LocalBounds {
        if params.turbulence.amount != DVec3::ZERO {
            return LocalBounds::UNKNOWN;
        }
        LocalBounds::from_max_gradient(self.value(at), 1.0, radius)
    }

    fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        let by = params.turbulence;
        if by.amount.x == 0.0 {
            return at.p.x;
        }
        at.p.x + by.amount.x * noise::turbulence(at.p, by.to_octaves(), at.noise)
    }

    fn handles_turbulence_itself(&self) -> bool {
        true
    }

    fn default_wave(&self) -> Option<Wave> {
        Some(Wave::Triangle)
    }

    fn default_colors(&self) -> Vec<(f64, Color)> {
        [(0.0, [0.9, 0.8, 0.8]), (0.9, [0.9, 0.08, 0.08]), (0.9, [0.0; 3])]
            .map(|(at, rgb)| (at, Color::opaque(rgb.into())))
            .to_vec()
    }
}
