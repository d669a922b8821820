//! `interior { … }`: what fills a shape: refraction, dispersion, attenuation (manual, "Interior").

use super::Media;
use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Transform, fp};
use crate::value::ValueKind::{Block, Color, Float};
use crate::value::words::{Row, joined, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec, Thing, WordSpec};
use serde::Serialize;

/// Words of an `interior` block, and how each is read.
const INTERIOR_ROWS: &[Row<Interior>] = &[
    word("ior", Float, "1", "how much light is bent that enters: 1.33 is water, 1.5 glass, 2.4 diamond").sets(
        |s, r| {
            s.has_ior = true;
            set(&mut s.ior, r.float())
        },
    ),
    word(
        "dispersion",
        Float,
        "1",
        "the ratio of violet's index of refraction to red's: 1.01 to 1.1 shows the colours of a prism",
    )
    .sets(|s, r| set(&mut s.dispersion, r.float())),
    word("dispersion_samples", Float, "7", "into how many colours light splits, from 2 to 10000")
        .sets(|s, r| set(&mut s.dispersion_samples, read_dispersion_samples(r))),
    word(
        "fade_distance",
        Float,
        "0",
        "the distance after which light has lost half of its brightness; 0 if light is not attenuated",
    )
    .sets(|s, r| set(&mut s.fade_distance, r.float())),
    word("fade_power", Float, "0", "how fast light fades; 1 to 2 is usual, from 1000 on it fades exponentially")
        .sets(|s, r| set(&mut s.fade_power, r.float())),
    word("fade_color", Color, "0", "the colour of light after a long distance")
        .sets(|s, r| set(&mut s.fade_color, r.color().map(|c| c.rgb))),
    word("fade_colour", Color, "", "the same as `fade_color`")
        .sets(|s, r| set(&mut s.fade_color, r.color().map(|c| c.rgb))),
    word("caustics", Float, "0", "makes shadows bright where light falls straight in; larger is narrower")
        .sets(|s, r| set(&mut s.caustics, r.float())),
];

/// Parts of an `interior` block with braces of their own.
const INTERIOR_PARTS: &[WordSpec] = &[word("media", Block, "", "smoke, fire, dust; several add up")];

/// Description of the block `interior { … }`.
pub const INTERIOR: Spec = Spec {
    name: "interior",
    summary: "what fills a shape",
    words: &joined::<{ INTERIOR_ROWS.len() + 1 }>(specs!(INTERIOR_ROWS), INTERIOR_PARTS),
    ignored: &["refraction"],
    ..Spec::EMPTY
};

/// Optical properties of the inside of a shape.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Interior {
    /// Index of refraction of white light.
    pub ior: f64,
    /// True if the scene states `ior`; without it `dispersion` has no effect (quirk: `dispersion_needs_ior`).
    #[serde(skip)]
    pub has_ior: bool,
    /// Ratio of violet's index of refraction to red's; 1 for no dispersion.
    pub dispersion: f64,
    /// Number of colours into which dispersion splits white light, at least 2.
    pub dispersion_samples: u32,
    /// Distance after which light has lost half of its brightness if `fade_power` is 1, in world units; 0 for no
    /// attenuation.
    pub fade_distance: f64,
    /// Exponent of attenuation by distance; from 1000 on attenuation is exponential.
    pub fade_power: f64,
    /// Transmittance after an infinite distance.
    pub fade_color: Rgb,
    /// Strength of bright spots in shadows, where light enters at a right angle; 0 for none.
    pub caustics: f64,
    /// Media that fill the shape, in the space around the object.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub media: Vec<Media>,
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
            media: vec![],
        }
    }
}

impl Thing for Interior {
    fn kind(&self) -> &'static str {
        "interior"
    }
}

impl Interior {
    /// Reads the items of an `interior` block; they override those of `base`.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(r: &mut dyn Reader, base: Option<&Self>) -> Result<Self> {
        let mut out = base.cloned().unwrap_or_default();
        loop {
            match r.peek_next()? {
                Next::End => return Ok(out),
                Next::Thing(_) => match r.take_declared::<Interior>()? {
                    Some(declared) => out = (*declared).clone(),
                    None => return Err(r.unknown_word_in(&INTERIOR)),
                },
                next if read_row(INTERIOR_ROWS, &mut out, next, r)? => {}
                // `refraction N` switched bending on in POV-Ray 3.0; its number has no effect.
                Next::Word(word) if INTERIOR.ignores(word) => {
                    r.take_token()?;
                    r.float()?;
                }
                Next::Block("media") => {
                    let at = r.take_token()?;
                    out.media.push(Media::read(r, at)?);
                    r.leave_block()?;
                }
                _ => return Err(r.unknown_word_in(&INTERIOR)),
            }
        }
    }

    /// True if transforms change the interior: a medium has densities.
    pub fn has_transformed_contents(&self) -> bool {
        self.media.iter().any(|media| !media.densities.is_empty())
    }

    /// Transforms the densities of the media.
    pub fn transform(&mut self, by: &Transform) {
        self.media.iter_mut().for_each(|media| media.transform(by));
    }

    /// Returns the index of refraction for one colour of the spectrum: `red_to_violet` is 0 for red and 1 for violet;
    /// white light has the index at 0.5 (quirk: `dispersion_ior`).
    pub fn ior_of_hue(&self, red_to_violet: f64) -> f64 {
        if self.dispersion == 1.0 || self.dispersion <= 0.0 {
            return self.ior;
        }
        // n·Dʰ⁻¹ᐟ²
        self.ior * fp::pow(self.dispersion, red_to_violet - 0.5)
    }

    /// Returns the transmittance by `fade_distance`, `fade_power` and `fade_color` over a distance inside the shape, in
    /// world units; media do not count (manual, "Attenuation").
    pub fn fade_transmittance(&self, distance: f64) -> Rgb {
        if self.fade_distance <= 0.0 {
            return Rgb::ONE;
        }
        let far = distance / self.fade_distance;
        if self.fade_power >= 1000.0 {
            // Beer–Lambert law per channel: exp(-(1 - color)·d/d₀)
            return ((self.fade_color - Rgb::ONE) * far).map(fp::exp);
        }
        // Mix white light, which falls off as 1 / (1 + (d/d₀)ᵏ), with fade_color
        let left = 1.0 / (1.0 + fp::pow(far, self.fade_power));
        self.fade_color + (Rgb::ONE - self.fade_color) * left
    }

    /// Returns the factor by which a surface brightens the light that enters through it; `cos_incidence` is the cosine of the
    /// angle of incidence (quirk: `caustics_factor`).
    pub fn caustic_factor(&self, cos_incidence: f64) -> f64 {
        if self.caustics == 0.0 { 1.0 } else { 1.0 + fp::pow(cos_incidence, 45.0 * self.caustics) }
    }

    /// True if the interior attenuates light by distance (`fade_distance`) or brightens it (`caustics`); media do not
    /// count.
    pub fn changes_crossing_light(&self) -> bool {
        self.fade_distance > 0.0 || self.caustics != 0.0
    }
}

/// Maximum number of colours into which dispersion splits light; each is a ray of its own.
const MAX_DISPERSION_SAMPLES: f64 = 10_000.0;

/// Reads the number of `dispersion_samples`; larger numbers count as the maximum.
fn read_dispersion_samples(r: &mut dyn Reader) -> Result<u32> {
    let (at, number) = (r.span(), r.float()?);
    if number < 2.0 {
        let message = format!("`dispersion_samples` is {number}; light splits into at least 2 colours");
        return Err(Diagnostic::new(codes::BAD_ARGUMENT, at, message).help("7 is usual, 30 looks smooth").into());
    }
    Ok(number.min(MAX_DISPERSION_SAMPLES) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attenuation_by_distance_and_power() {
        let one = |fade_distance, fade_power| {
            Interior { fade_distance, fade_power, ..Interior::default() }.fade_transmittance(2.0).x
        };
        let values = [one(0.0, 2.0), one(1.0, 1.0), one(0.5, 2.0), one(1.0, 0.0), one(1.0, 1000.0)];
        for (found, wanted) in values.into_iter().zip([1.0, 1.0 / 3.0, 1.0 / 17.0, 0.5, fp::exp(-2.0f64)]) {
            assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
        }
        let fade_color = Rgb::new(0.2, 0.5, 1.0);
        let colored = Interior { fade_distance: 1.0, fade_power: 1.0, fade_color, ..Interior::default() };
        assert!(colored.fade_transmittance(2.0).distance(Rgb::new(7.0 / 15.0, 2.0 / 3.0, 1.0)) < 1e-12);
    }
}
