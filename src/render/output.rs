//! Conversion from the numbers of the scene to linear light and alpha (manual, "assumed_gamma", "Output_Alpha").

use super::Options;
use crate::color::Gamma;
use crate::color::transfer::srgb_decode;
use crate::color::{Rgb, gray};
use crate::math::fp;
use crate::world::World;

/// Conversion of a picture's pixels, as [`Watch::store_tile`](super::Watch::store_tile) receives them, to linear light.
#[derive(Clone, Copy, Debug)]
pub struct OutputConversion {
    /// `assumed_gamma` of the scene.
    gamma: Gamma,
    /// True if the picture has alpha.
    has_alpha: bool,
}

impl OutputConversion {
    /// Creates the conversion for a picture of a World.
    pub fn new(world: &World, options: &Options) -> Self {
        Self { gamma: world.gamma, has_alpha: options.alpha }
    }

    /// Returns linear red, green, blue and alpha of a pixel.
    pub fn to_linear_rgba(&self, pixel: &[f32; 4]) -> [f32; 4] {
        let [r, g, b, transparency] = pixel.map(f64::from);
        // (`max` also turns NaN into black.)
        let mut rgb = Rgb::new(r.max(0.0), g.max(0.0), b.max(0.0));
        let mut alpha = 1.0;
        if self.has_alpha {
            // A highlight on clear glass covers the background.
            alpha = (1.0 - transparency).max(gray(rgb)).clamp(0.0, 1.0);
            rgb = if alpha > 0.0 { rgb / alpha } else { Rgb::ZERO };
        }
        let decode = |x: f64| match self.gamma {
            Gamma::Power(1.0) => x as f32,
            Gamma::Power(g) => fp::pow_f32(x, g),
            // Without gamma, a file with the sRGB curve must show the number itself.
            Gamma::Srgb | Gamma::Raw => srgb_decode(x) as f32,
        };
        [decode(rgb.x), decode(rgb.y), decode(rgb.z), alpha as f32]
    }
}
