//! The block `global_settings` (manual, "Global Settings").

use super::Radiosity;
use super::photon_map::PhotonMapSettings;
use super::subsurface::SubsurfaceSettings;
use super::words::{SETTINGS, SETTINGS_ROWS};
use crate::color::{Gamma, Rgb};
use crate::diagnostic::Result;
use crate::math::noise::NoiseGenerator;
use crate::pattern::TextureContext;
use crate::value::ranges::positive;
use crate::value::words::read_row;
use crate::value::{Next, Reader, ReaderExt};
use serde::Serialize;

/// Values of `global_settings`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Settings {
    /// Value of `assumed_gamma`; while the scene is read, `None` until the scene states it. Never `None` in a finished
    /// scene.
    pub gamma: Option<Gamma>,
    /// Maximum number of reflections and refractions of a ray.
    pub max_trace_level: u32,
    /// Weight below which a ray is not traced.
    pub adc_bailout: f64,
    /// Factor of all `ambient` finishes.
    pub ambient_light: Rgb,
    /// Wavelengths of red, green and blue in the units of `irid { thickness }`.
    pub irid_wavelength: Rgb,
    /// Noise generator of patterns and functions; while the scene is read, `None` until the scene sets it. Never `None`
    /// in a finished scene.
    pub noise_generator: Option<NoiseGenerator>,
    /// Number of wave sources of the patterns `ripples` and `waves`.
    pub number_of_waves: usize,
    /// True for the blending of filters before 3.7: a surface shows of its own light only the share that its filter
    /// colour absorbs; see [`crate::color::Color::opacity`].
    pub opacity_by_color: bool,
    /// True if sky layers are blended as before 3.7; see [`crate::world::Sky`].
    pub sky_by_share: bool,
    /// Settings of radiosity; `None` for a scene without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radiosity: Option<Box<Radiosity>>,
    /// Settings of the photon map; `None` for a scene without photons.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub photons: Option<PhotonMapSettings>,
    /// Length of one unit of the scene in millimetres, for subsurface light transport.
    pub mm_per_unit: f64,
    /// Settings of subsurface light transport; `None` if the scene does not switch it on.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub subsurface: Option<SubsurfaceSettings>,
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
            radiosity: None,
            photons: None,
            mm_per_unit: 10.0,
            subsurface: None,
        }
    }
}

impl Settings {
    /// Reads the contents of a `global_settings` block.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(&mut self, r: &mut dyn Reader) -> Result<()> {
        loop {
            match r.peek_next()? {
                Next::End => return Ok(()),
                next if read_row(SETTINGS_ROWS, self, next, r)? => {}
                Next::Block("photons") => self.photons = Some(PhotonMapSettings::read_with_braces(r)?),
                Next::Word(word) if SETTINGS.ignores(word) => {
                    r.take_token()?;
                    while r.may_be_at_color()?
                        || matches!(r.peek_next()?, Next::Value | Next::Word("utf8" | "ascii" | "sys"))
                    {
                        r.skip_item()?;
                    }
                }
                Next::Word("radiosity") | Next::Block("radiosity") => {
                    self.radiosity = Some(Box::new(Radiosity::read_with_braces(r)?))
                }
                Next::Block("subsurface") => self.subsurface = Some(SubsurfaceSettings::read_with_braces(r)?),
                _ => return Err(r.unknown_word_in(&SETTINGS)),
            }
        }
    }
}

impl Settings {
    /// Reads the number after `max_trace_level`, which old scenes also state outside of `global_settings`.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read_max_trace_level(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.max_trace_level = r.float()?.clamp(1.0, 256.0) as u32;
        Ok(())
    }
}

/// Reads `srgb` or a number after `assumed_gamma`.
pub(super) fn read_gamma(r: &mut dyn Reader) -> Result<Gamma> {
    if r.accept("srgb")? {
        return Ok(Gamma::Srgb);
    }
    let gamma = positive("assumed_gamma", r);
    gamma.map(Gamma::Power).map_err(|fault| Box::new(fault.help("`assumed_gamma 1` computes in linear light")))
}
