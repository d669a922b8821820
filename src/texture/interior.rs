//! `interior`: the medium inside a shape (manual, "Interior").

use super::words::{INTERIOR, INTERIOR_ROWS};
use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::fp;
use crate::value::words::read_row;
use crate::value::{Next, RawItem, Reader, ReaderExt};
use serde::Serialize;

/// Refraction, attenuation and dispersion inside a shape.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Interior {
    /// Index of refraction.
    pub ior: f64,
    /// True if the index is given; without it nothing is dispersed (quirk: `dispersion_needs_ior`).
    #[serde(skip)]
    pub has_ior: bool,
    /// Ratio of the indices of refraction for violet and red.
    pub dispersion: f64,
    /// Number of colours into which dispersion splits light, at least 2.
    pub dispersion_samples: u32,
    /// Distance after which half of the light remains, for a power of 1; 0 for no attenuation.
    pub fade_distance: f64,
    /// Exponent of the attenuation; from 1000 on it is exponential.
    pub fade_power: f64,
    /// Transmittance at infinite distance.
    pub fade_color: Rgb,
    /// Strength of the brightening of shadows where light is perpendicular to the surface; 0 for none.
    pub caustics: f64,
    /// Parameters that durer reads and does not render yet.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub undrawn: Vec<RawItem>,
}

impl Default for Interior {
    fn default() -> Self {
        Self {
            ior: 1.0,
            has_ior: false,
            dispersion: 1.0,
            dispersion_samples: 7,
            fade_distance: 0.0,
            fade_power: 0.0,
            fade_color: Rgb::ZERO,
            caustics: 0.0,
            undrawn: vec![],
        }
    }
}

impl Interior {
    /// Reads the contents of the braces, on top of an earlier interior.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read(r: &mut dyn Reader, before: Option<&Self>) -> Result<Self> {
        let mut out = before.cloned().unwrap_or_default();
        loop {
            match r.next()? {
                Next::End => return Ok(out),
                Next::Thing(_) => match r.thing::<Interior>()? {
                    Some(declared) => out = (*declared).clone(),
                    None => return Err(r.unknown_word("interior", &INTERIOR.names()).into()),
                },
                next if read_row(INTERIOR_ROWS, &mut out, next, r)? => {}
                // `refraction N` once enabled refraction; its number has no effect.
                Next::Word(word) if INTERIOR.ignores(word) => {
                    r.take()?;
                    r.float()?;
                }
                Next::Word(word) | Next::Block(word) if INTERIOR.leaves_out(word) => {
                    out.undrawn.push(r.keep_undrawn(word)?);
                }
                _ => return Err(r.unknown_word("interior", &INTERIOR.names()).into()),
            }
        }
    }

    /// Index of refraction for a colour of the spectrum, from 0 for red to 1 for violet; white light is in the middle
    /// (quirk: `dispersion_middle`).
    pub fn ior_of(&self, hue: f64) -> f64 {
        if self.dispersion == 1.0 || self.dispersion <= 0.0 {
            return self.ior;
        }
        // n·Dʰ⁻¹ᐟ²
        self.ior * fp::pow(self.dispersion, hue - 0.5)
    }

    /// Transmittance over a distance inside (manual, "Attenuation").
    pub fn fade(&self, distance: f64) -> Rgb {
        if self.fade_distance <= 0.0 {
            return Rgb::ONE;
        }
        let far = distance / self.fade_distance;
        if self.fade_power >= 1000.0 {
            // for each channel: exp(-(1 - color)·d/d₀)
            return ((self.fade_color - Rgb::ONE) * far).map(fp::exp);
        }
        // 1 / (1 + (d/d₀)ᵏ), the rest by fade_color
        let left = 1.0 / (1.0 + fp::pow(far, self.fade_power));
        self.fade_color + (Rgb::ONE - self.fade_color) * left
    }

    /// Factor of the light that passes a surface at an angle with this cosine (quirk: `caustics_formula`).
    pub fn caustic(&self, cos: f64) -> f64 {
        if self.caustics == 0.0 { 1.0 } else { 1.0 + fp::pow(cos, 45.0 * self.caustics) }
    }

    /// True if the interior attenuates or disperses light, or has caustics.
    pub fn colors_light(&self) -> bool {
        self.fade_distance > 0.0 || self.caustics != 0.0
    }
}

pub(super) fn read_samples(r: &mut dyn Reader) -> Result<u32> {
    let (at, number) = (r.span(), r.float()?);
    if number < 2.0 {
        let message = format!("`dispersion_samples` is {number}, and light splits into 2 colours at least");
        return Err(Diagnostic::new(codes::BAD_ARGUMENT, at, message).help("7 is usual, 30 looks smooth").into());
    }
    Ok(number as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fades_as_measured() {
        let one = |fade_distance, fade_power| Interior { fade_distance, fade_power, ..Interior::default() }.fade(2.0).x;
        let values = [one(0.0, 2.0), one(1.0, 1.0), one(0.5, 2.0), one(1.0, 0.0), one(1.0, 1000.0)];
        for (found, wanted) in values.into_iter().zip([1.0, 1.0 / 3.0, 1.0 / 17.0, 0.5, fp::exp(-2.0f64)]) {
            assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
        }
        let fade_color = Rgb::new(0.2, 0.5, 1.0);
        let colored = Interior { fade_distance: 1.0, fade_power: 1.0, fade_color, ..Interior::default() };
        assert!(colored.fade(2.0).distance(Rgb::new(7.0 / 15.0, 2.0 / 3.0, 1.0)) < 1e-12);
    }
}
