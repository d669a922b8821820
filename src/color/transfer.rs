//! Transfer curves between linear light and stored numbers.

use super::Rgb;
use crate::math::fp;
use serde::{Deserialize, Serialize};

/// Transfer curve between a scene's numbers and light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Gamma {
    /// Transfer curve of a gamma: a number is light to the power of 1 / gamma.
    Power(f64),
    /// Transfer curve of sRGB: a number is light encoded by it.
    Srgb,
    /// No transfer curve: numbers are stored unchanged, as in scenes before version 3.7 without `assumed_gamma`.
    Raw,
}

impl Gamma {
    /// Decodes a number of this transfer curve to linear light.
    pub fn decode(self, encoded: f64) -> f64 {
        match self {
            Gamma::Power(g) => fp::pow(encoded.max(0.0), g),
            Gamma::Srgb => srgb_decode(encoded),
            Gamma::Raw => encoded,
        }
    }

    /// Encodes linear light as a number by this transfer curve.
    pub fn encode(self, light: f64) -> f64 {
        match self {
            Gamma::Power(g) => fp::pow(light.max(0.0), 1.0 / g),
            Gamma::Srgb => srgb_encode(light),
            Gamma::Raw => light,
        }
    }

    /// True if both transfer curves are equal, so that encoding by one undoes decoding by the other.
    pub fn is_equivalent(self, other: Gamma) -> bool {
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

/// Encodes all three channels of linear light by the sRGB curve.
pub fn srgb_encode_rgb(c: Rgb) -> Rgb {
    Rgb::new(srgb_encode(c.x), srgb_encode(c.y), srgb_encode(c.z))
}

/// Decodes all three channels from the sRGB curve to linear light.
pub fn srgb_decode_rgb(c: Rgb) -> Rgb {
    Rgb::new(srgb_decode(c.x), srgb_decode(c.y), srgb_decode(c.z))
}
