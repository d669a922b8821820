//! Transfer curves between linear light and stored numbers.

use super::Rgb;
use crate::math::fp;
use serde::Serialize;

/// Relation of a scene's numbers to light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Gamma {
    /// A number is light to the power of one over this.
    Power(f64),
    /// A number is light encoded by the sRGB curve.
    Srgb,
    /// None: numbers are stored unchanged, as in scenes before version 3.7 without `assumed_gamma`.
    Raw,
}

impl Gamma {
    /// Light of a number.
    pub fn decode(self, v: f64) -> f64 {
        match self {
            Gamma::Power(g) => fp::pow(v.max(0.0), g),
            Gamma::Srgb => srgb_decode(v),
            Gamma::Raw => v,
        }
    }

    /// Number of a light.
    pub fn encode(self, light: f64) -> f64 {
        match self {
            Gamma::Power(g) => fp::pow(light.max(0.0), 1.0 / g),
            Gamma::Srgb => srgb_encode(light),
            Gamma::Raw => light,
        }
    }

    /// True if both are equal, so that encoding by one undoes decoding by the other.
    pub fn agrees(self, other: Gamma) -> bool {
        match (self, other) {
            (Gamma::Power(a), Gamma::Power(b)) => (a - b).abs() < 1e-3,
            (a, b) => a == b,
        }
    }
}

/// Encodes linear light in [0, 1] by the sRGB curve (IEC 61966-2-1).
pub fn srgb_encode(x: f64) -> f64 {
    if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * fp::pow(x, 1.0 / 2.4) - 0.055 }
}

/// Decodes the sRGB curve to linear light.
pub fn srgb_decode(x: f64) -> f64 {
    if x <= 0.040_45 { x / 12.92 } else { fp::pow((x + 0.055) / 1.055, 2.4) }
}

/// [`srgb_encode`] of all three channels.
pub fn srgb_encode_rgb(c: Rgb) -> Rgb {
    Rgb::new(srgb_encode(c.x), srgb_encode(c.y), srgb_encode(c.z))
}

/// [`srgb_decode`] of all three channels.
pub fn srgb_decode_rgb(c: Rgb) -> Rgb {
    Rgb::new(srgb_decode(c.x), srgb_decode(c.y), srgb_decode(c.z))
}
