//! Linear colour with filter and transmit; transfer curves.

pub mod transfer;

pub use transfer::Gamma;

use crate::math::DVec3;
use serde::Serialize;

/// Red, green and blue numbers of a colour or of light; linear, not clamped.
pub type Rgb = DVec3;

/// A colour of the scene language: `rgbft <red, green, blue, filter, transmit>`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Color {
    /// Red, green and blue of the colour, which a surface reflects.
    pub rgb: Rgb,
    /// Fraction of the light from behind that is transmitted and tinted by `rgb`.
    pub filter: f64,
    /// Fraction of the light from behind that is transmitted untinted.
    pub transmit: f64,
}

impl Color {
    /// Opaque black, `rgb 0`.
    pub const BLACK: Color = Color::opaque(Rgb::ZERO);
    /// Opaque white, `rgb 1`.
    pub const WHITE: Color = Color::opaque(Rgb::ONE);

    /// Finite number that replaces infinity in a colour.
    pub const BLINDING: f64 = 1e30;

    /// Returns the colour as a surface shows it: infinite components are 0 (quirk: `infinite_colors`).
    pub fn with_infinities_as_zero(self) -> Self {
        let is_infinite = self.to_array().contains(&Self::BLINDING);
        if !is_infinite {
            self
        } else {
            Self::from_array(self.to_array().map(|x| if x == Self::BLINDING { 0.0 } else { x }))
        }
    }

    /// Creates a colour whose filter and transmit are 0.
    pub const fn opaque(rgb: Rgb) -> Self {
        Self { rgb, filter: 0.0, transmit: 0.0 }
    }

    /// Creates a colour from the five numbers of `rgbft`.
    pub const fn from_array(c: [f64; 5]) -> Self {
        Self { rgb: Rgb::new(c[0], c[1], c[2]), filter: c[3], transmit: c[4] }
    }

    /// Returns the five numbers of `rgbft`.
    pub const fn to_array(self) -> [f64; 5] {
        [self.rgb.x, self.rgb.y, self.rgb.z, self.filter, self.transmit]
    }

    /// Fraction of its own light that a surface of this colour shows. Before 3.7, with `filter_by_brightest_channel`, a
    /// filter transmits only as much as its brightest channel (quirk: `opacity_by_version`).
    pub fn opacity(&self, filter_by_brightest_channel: bool) -> f64 {
        let filter = if filter_by_brightest_channel { self.filter * self.rgb.max_element() } else { self.filter };
        1.0 - filter - self.transmit
    }

    /// Returns the colour with its filter added to `transmit`, and a filter of 0.
    pub fn with_filter_as_transmit(self) -> Self {
        Self { filter: 0.0, transmit: self.filter + self.transmit, ..self }
    }

    /// Transmittance for light from behind: filter · rgb + transmit.
    pub fn transmittance(&self) -> Rgb {
        self.rgb * self.filter + self.transmit
    }

    /// Returns self + factor·other, for all five numbers of a colour.
    pub fn plus_scaled(self, other: Color, factor: f64) -> Color {
        Color {
            rgb: self.rgb + other.rgb * factor,
            filter: self.filter + other.filter * factor,
            transmit: self.transmit + other.transmit * factor,
        }
    }

    /// Returns (1-t)·self + t·other, for all five numbers of a colour.
    pub fn lerp(self, other: Color, t: f64) -> Color {
        Color {
            rgb: self.rgb.lerp(other.rgb, t),
            filter: self.filter + (other.filter - self.filter) * t,
            transmit: self.transmit + (other.transmit - self.transmit) * t,
        }
    }
}

/// Weights of red, green and blue in a colour's brightness (manual, "Color Operators").
pub const GRAY_WEIGHTS: [f64; 3] = [0.297, 0.589, 0.114];

/// Brightness of a colour, as POV-Ray's `.gray` (manual, "Color Operators").
pub fn gray(c: Rgb) -> f64 {
    GRAY_WEIGHTS[0] * c.x + GRAY_WEIGHTS[1] * c.y + GRAY_WEIGHTS[2] * c.z
}
