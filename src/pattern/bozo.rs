//! `bozo`: smooth noise, between 0 and 1 (manual, "Bozo").
//!
//! ```pov
//! sphere { 0, 1 pigment { bozo turbulence 0.6 color_map { [0.4 color rgb <0.2, 0.4, 0.9>] [0.7 color rgb 1] } scale 0.5 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::noise;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `bozo`: smooth noise between 0 and 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bozo {}

impl Readable for Bozo {
    const SPEC: Spec = Spec { name: "bozo", summary: "smooth noise, as clouds are made of", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Bozo {
    fn value(&self, at: &TextureContext) -> f64 {
        noise::noise(at.p, at.noise)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        LocalBounds::from_max_gradient(self.value(at), at.noise.max_gradient(), radius).clamp_range(0.0, 1.0)
    }

    fn default_colors(&self) -> Vec<(f64, Color)> {
        let [white, green, blue, red] = [Rgb::ONE, Rgb::Y, Rgb::Z, Rgb::X].map(Color::opaque);
        [(0.4, white), (0.4, green), (0.6, green), (0.6, blue), (0.8, blue), (0.8, red)].to_vec()
    }
}
