//! What lies between the surfaces and behind them: `fog`, `rainbow`, `sky_sphere`, `background` (manual, "Atmospheric Effects").

mod background;
mod fog;
mod rainbow;
mod sky_sphere;

pub use background::{Background, ViewKind};
pub use fog::{FOG, Fog, segment_of as fogs};
pub use rainbow::{RAINBOW, Rainbow, segment_of as rainbows};
pub use sky_sphere::{SKY_SPHERE, SkySphere};

use crate::color::{Color, Rgb};

/// What a stretch of air does to light that comes along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// What it radiance.
    pub radiance: Rgb,
    /// What it leaves of the light from behind.
    pub transmittance: Rgb,
}

impl Segment {
    /// None at all.
    pub const NONE: Self = Self { radiance: Rgb::ZERO, transmittance: Rgb::ONE };

    /// The farthest that a ray gets which hits nothing (measured on POV-Ray 3.7).
    pub const FAR: f64 = 2e10;

    /// A veil of a colour of which a part `clear` is left open; the rest of the light from behind is filtered by so much of the
    /// colour as `filter` says.
    fn of(color: Rgb, clear: f64, filter: f64) -> Self {
        Self { radiance: color * (1.0 - clear), transmittance: clear * (Rgb::splat(1.0 - filter) + filter * color) }
    }

    /// This veil in front of another one.
    pub fn in_front_of(self, behind: Segment) -> Self {
        Self {
            radiance: self.radiance + self.transmittance * behind.radiance,
            transmittance: self.transmittance * behind.transmittance,
        }
    }
}

/// What is left open of a colour's own veil at most, where it is thick.
fn clear_at_least(color: &Color, clear: f64) -> f64 {
    clear.max(color.transmit)
}
