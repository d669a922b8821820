//! `global_settings` (manual, "Global Settings").

use super::words::{SETTINGS, SETTINGS_ROWS};
use crate::color::{Gamma, Rgb};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::noise::NoiseGenerator;
use crate::pattern::TextureContext;
use crate::value::words::read_row;
use crate::value::{Next, Reader, ReaderExt, Unsupported};
use serde::Serialize;

/// All numbers of `global_settings`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Settings {
    /// `assumed_gamma`, once it is settled.
    pub gamma: Option<Gamma>,
    /// How often a ray may be reflected and bent.
    pub max_trace_level: u32,
    /// Rays that count for less than this are not followed.
    pub adc_bailout: f64,
    /// The light that `finish { ambient }` answers to.
    pub ambient_light: Rgb,
    /// The wavelengths of red, green and blue in the units of `irid { thickness }`.
    pub irid_wavelength: Rgb,
    /// The noise that patterns and functions are made of, if the scene says which.
    pub noise_generator: Option<NoiseGenerator>,
    /// How many sources the patterns `ripples` and `waves` have.
    pub number_of_waves: usize,
    /// Surfaces keep what their filter's color holds back, as before 3.7: see [`crate::color::Color::opacity`].
    pub opacity_by_color: bool,
    /// Skies are layered as before 3.7: see [`crate::world::Sky`].
    pub sky_by_share: bool,
    /// What was said and is not drawn yet.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unsupported: Vec<Unsupported>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            gamma: None,
            max_trace_level: 5,
            adc_bailout: 1.0 / 255.0,
            ambient_light: Rgb::ONE,
            irid_wavelength: Rgb::new(0.7, 0.52, 0.48),
            noise_generator: None,
            number_of_waves: TextureContext::WAVES,
            opacity_by_color: false,
            sky_by_share: false,
            unsupported: vec![],
        }
    }
}

impl Settings {
    /// Reads what stands between the braces.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read(&mut self, r: &mut dyn Reader) -> Result<()> {
        loop {
            match r.next()? {
                Next::End => return Ok(()),
                next if read_row(SETTINGS_ROWS, self, next, r)? => {}
                Next::Word(word) if SETTINGS.ignores(word) => {
                    let mut row = vec![];
                    r.take()?;
                    while r.at_color()? || matches!(r.next()?, Next::Value | Next::Word("utf8" | "ascii" | "sys")) {
                        r.skip_into(&mut row)?;
                    }
                    self.unsupported.push(Unsupported::Block(word, row.into()));
                }
                Next::Word(word) | Next::Block(word) if SETTINGS.is_unsupported(word) => {
                    self.unsupported.push(r.read_unsupported(word)?);
                }
                _ => return Err(r.unknown_word("global_settings", &SETTINGS.names()).into()),
            }
        }
    }
}

impl Settings {
    /// The number behind `max_trace_level`; in old scenes it stands outside of the braces too.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read_max_trace_level(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.max_trace_level = r.float()?.clamp(1.0, 256.0) as u32;
        Ok(())
    }
}

/// `assumed_gamma srgb`, or a number.
pub(super) fn read_gamma(r: &mut dyn Reader) -> Result<Gamma> {
    if r.accept("srgb")? { Ok(Gamma::Srgb) } else { positive(r).map(Gamma::Power) }
}

/// A gamma of 0 or less has no curve.
fn positive(r: &mut dyn Reader) -> Result<f64> {
    let (at, gamma) = (r.span(), r.float()?);
    if gamma > 0.0 {
        return Ok(gamma);
    }
    let message = format!("`assumed_gamma` has to be more than 0, found {gamma}");
    Diagnostic::new(codes::BAD_ARGUMENT, at, message).help("`assumed_gamma 1` computes in linear light").into()
}
