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
use std::array::from_fn;
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
        if params.turbulence.amount == DVec3::ZERO {
            return self.value(at);
        }
        let (p, angle) = point_and_angles(at, params);
        (p + DVec2::from(fp::sines(angle))).length()
    }

    fn values_with_params(&self, at: &[TextureContext; 4], params: &FieldParams) -> [f64; 4] {
        if params.turbulence.amount == DVec3::ZERO {
            return at.each_ref().map(|at| self.value(at));
        }
        let places = at.each_ref().map(|at| point_and_angles(at, params));
        let sines: [f64; 8] = fp::sines(from_fn(|i| places[i / 2].1[i % 2]));
        from_fn(|i| (places[i].0 + DVec2::new(sines[2 * i], sines[2 * i + 1])).length())
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

/// Returns x and y of a point, and the angles by whose sines turbulence shifts them: the phase of each is the noise.
fn point_and_angles(at: &TextureContext, params: &FieldParams) -> (DVec2, [f64; 2]) {
    let by = params.turbulence;
    let p = at.p.truncate();
    (p, (TAU * by.amount.truncate() * (p + noise::vturbulence(at.p, by.to_octaves()).truncate())).to_array())
}
