//! Linear colour with filter and transmit, and the only transfer curves.

pub mod transfer;

pub use transfer::Gamma;

use crate::math::DVec3;
use serde::Serialize;

/// Red, green, blue; linear, not clamped.
pub type Rgb = DVec3;

/// A colour of the scene language: `rgbft <red, green, blue, filter, transmit>`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Color {
    /// What the surface reflects.
    pub rgb: Rgb,
    /// How much of the light behind passes, tinted by `rgb`.
    pub filter: f64,
    /// How much of the light behind passes untinted.
    pub transmit: f64,
}

impl Color {
    /// `rgb 0`.
    pub const BLACK: Color = Color::opaque(Rgb::ZERO);
    /// `rgb 1`.
    pub const WHITE: Color = Color::opaque(Rgb::ONE);

    /// What stands for an infinite number in a colour.
    pub const BLINDING: f64 = 1e30;

    /// As the paint of a surface: numbers that were infinite are 0 then (measured on POV-Ray 3.7).
    pub fn as_paint(self) -> Self {
        let is_infinite = self.to_array().contains(&Self::BLINDING);
        if !is_infinite {
            self
        } else {
            Self::from_array(self.to_array().map(|x| if x == Self::BLINDING { 0.0 } else { x }))
        }
    }

    /// Neither filters nor transmits.
    pub const fn opaque(rgb: Rgb) -> Self {
        Self { rgb, filter: 0.0, transmit: 0.0 }
    }

    /// The five numbers of `rgbft`.
    pub const fn from_array(c: [f64; 5]) -> Self {
        Self { rgb: Rgb::new(c[0], c[1], c[2]), filter: c[3], transmit: c[4] }
    }

    /// The five numbers of `rgbft`.
    pub const fn to_array(self) -> [f64; 5] {
        [self.rgb.x, self.rgb.y, self.rgb.z, self.filter, self.transmit]
    }

    /// The part that is not see-through. Before 3.7, `by_color`, a filter let pass only as much as its brightest channel says
    /// (measured on POV-Ray 3.7).
    pub fn opacity(&self, by_color: bool) -> f64 {
        let filter = if by_color { self.filter * self.rgb.max_element() } else { self.filter };
        1.0 - filter - self.transmit
    }

    /// What it lets pass of the light from behind: filter · rgb + transmit.
    pub fn passing(&self) -> Rgb {
        self.rgb * self.filter + self.transmit
    }

    /// self + t·other, in all five numbers.
    pub fn plus(self, other: Color, t: f64) -> Color {
        Color {
            rgb: self.rgb + other.rgb * t,
            filter: self.filter + other.filter * t,
            transmit: self.transmit + other.transmit * t,
        }
    }

    /// (1-t)·self + t·other, in all five numbers.
    pub fn lerp(self, other: Color, t: f64) -> Color {
        Color {
            rgb: self.rgb.lerp(other.rgb, t),
            filter: self.filter + (other.filter - self.filter) * t,
            transmit: self.transmit + (other.transmit - self.transmit) * t,
        }
    }
}

/// How much red, green and blue add to brightness (manual, "Color Operators").
pub const GRAY_WEIGHTS: [f64; 3] = [0.297, 0.589, 0.114];

/// Brightness as POV-Ray's `.gray` weighs it (manual, "Color Operators").
pub fn gray(c: Rgb) -> f64 {
    GRAY_WEIGHTS[0] * c.x + GRAY_WEIGHTS[1] * c.y + GRAY_WEIGHTS[2] * c.z
}
