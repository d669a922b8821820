//! Transfer curves between linear light and stored numbers.

use super::Rgb;
use crate::math::fp;
use serde::Serialize;

/// How numbers in the scene relate to light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Gamma {
    /// They are light to the power of one over this.
    Power(f64),
    /// They are encoded by the sRGB curve.
    Srgb,
    /// No such relation: they go to the file as they are. Scenes older than 3.7 that name no `assumed_gamma`.
    Raw,
}

impl Gamma {
    /// The light that a number stands for.
    pub fn decode(self, v: f64) -> f64 {
        match self {
            Gamma::Power(g) => fp::pow(v.max(0.0), g),
            Gamma::Srgb => srgb_decode(v),
            Gamma::Raw => v,
        }
    }

    /// The number that stands for this light.
    pub fn encode(self, light: f64) -> f64 {
        match self {
            Gamma::Power(g) => fp::pow(light.max(0.0), 1.0 / g),
            Gamma::Srgb => srgb_encode(light),
            Gamma::Raw => light,
        }
    }

    /// Do both mean the same? What they do to a number is undone exactly then.
    pub fn agrees(self, other: Gamma) -> bool {
        match (self, other) {
            (Gamma::Power(a), Gamma::Power(b)) => (a - b).abs() < 1e-3,
            (a, b) => a == b,
        }
    }
}

/// Linear light in [0, 1] to the sRGB curve (IEC 61966-2-1).
pub fn srgb_encode(x: f64) -> f64 {
    if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * fp::pow(x, 1.0 / 2.4) - 0.055 }
}

/// The sRGB curve back to linear light.
pub fn srgb_decode(x: f64) -> f64 {
    if x <= 0.040_45 { x / 12.92 } else { fp::pow((x + 0.055) / 1.055, 2.4) }
}

/// All three channels of [`srgb_encode`].
pub fn srgb_encode_rgb(c: Rgb) -> Rgb {
    Rgb::new(srgb_encode(c.x), srgb_encode(c.y), srgb_encode(c.z))
}

/// All three channels of [`srgb_decode`].
pub fn srgb_decode_rgb(c: Rgb) -> Rgb {
    Rgb::new(srgb_decode(c.x), srgb_decode(c.y), srgb_decode(c.z))
}
