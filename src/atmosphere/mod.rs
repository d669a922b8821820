//! Air between surfaces and sky behind them: `fog`, `rainbow`, `sky_sphere`, `background` (manual, "Atmospheric
//! Effects").

mod background;
mod fog;
mod rainbow;
mod sky_sphere;

pub use background::{Background, ViewKind};
pub use fog::{FOG, Fog, combine_fogs_adding_radiance};
pub use rainbow::{RAINBOW, Rainbow, average_rainbows};
pub use sky_sphere::{SKY_SPHERE, SkySphere};

use crate::color::{Color, Rgb};

/// Radiance and transmittance of the atmosphere along a segment of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Radiance that the segment adds.
    pub radiance: Rgb,
    /// Share of the light from behind the ray's segment that is transmitted.
    pub transmittance: Rgb,
}

impl Segment {
    /// Segment of a ray that adds no light and attenuates none.
    pub const NONE: Self = Self { radiance: Rgb::ZERO, transmittance: Rgb::ONE };

    /// Length of a ray's segment that ends at no surface, in world units (quirk: `fog_far`).
    pub const FAR: f64 = 2e10;

    /// Returns a ray's segment in air of one colour: `transmittance` is the transmittance, and `filter` the share of
    /// transmitted light that takes the colour.
    fn from_color(color: Rgb, transmittance: f64, filter: f64) -> Self {
        Self {
            radiance: color * (1.0 - transmittance),
            transmittance: transmittance * (Rgb::splat(1.0 - filter) + filter * color),
        }
    }

    /// Combines this segment of a ray with the segment `behind` it, farther from the eye.
    pub fn in_front_of(self, behind: Segment) -> Self {
        Self {
            radiance: self.radiance + self.transmittance * behind.radiance,
            transmittance: self.transmittance * behind.transmittance,
        }
    }
}

/// Returns the larger of a transmittance and the colour's `transmit`.
fn transmittance_at_least_transmit(color: &Color, transmittance: f64) -> f64 {
    transmittance.max(color.transmit)
}
