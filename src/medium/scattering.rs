//! `scattering { TYPE, color … }`: how a medium redirects light (manual, "Scattering").

use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::fp;
use crate::value::ValueKind::Float;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec};
use serde::Serialize;

/// Phase function: distribution of scattered light over directions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// Equal scattering in all directions.
    #[default]
    Isotropic,
    /// Phase function of haze (Nishita, Miyawaki and Nakamae, A shading model for atmospheric scattering, 1987).
    MieHaze,
    /// Phase function of murky air (Nishita, Miyawaki and Nakamae 1987).
    MieMurky,
    /// Phase function of small molecules (Rayleigh 1871).
    Rayleigh,
    /// Phase function of Henyey and Greenstein (Diffuse radiation in the galaxy, 1941), with the block's
    /// `eccentricity`.
    HenyeyGreenstein,
}

/// Scattering of light by a medium.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Scattering {
    /// Distribution of the scattered light over directions.
    pub phase: Phase,
    /// Share of light that is scattered per world unit at density 1.
    pub color: Rgb,
    /// Asymmetry of [`Phase::HenyeyGreenstein`]: above 0 for forward scattering, below 0 for backward scattering.
    pub eccentricity: f64,
    /// Factor of the attenuation that scattering causes; 1 for the physical one.
    pub extinction: f64,
}

impl Default for Scattering {
    fn default() -> Self {
        Self { phase: Phase::Isotropic, color: Rgb::ZERO, eccentricity: 0.0, extinction: 1.0 }
    }
}

/// Words of a `scattering` block after the type and the colour, and how each is read.
const SCATTERING_ROWS: &[Row<Scattering>] = &[
    word("eccentricity", Float, "0", "type 5: above 0, light continues forwards; below 0, backwards")
        .sets(|s, r| set(&mut s.eccentricity, r.float())),
    word("extinction", Float, "1", "factor of the light that scattering takes away")
        .sets(|s, r| set(&mut s.extinction, r.float())),
];

/// Description of the block `scattering { … }`.
pub const SCATTERING: Spec = Spec {
    name: "scattering",
    summary: "light that the particles of a medium send in other directions: a type from 1 to 5 and a colour",
    words: specs!(SCATTERING_ROWS),
    ..Spec::EMPTY
};

impl Scattering {
    /// Reads the items of a `scattering` block.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood, or at a type that does not exist.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        let at = r.span();
        let number = r.float()?;
        let phase = match number as i64 {
            1 => Phase::Isotropic,
            2 => Phase::MieHaze,
            3 => Phase::MieMurky,
            4 => Phase::Rayleigh,
            5 => Phase::HenyeyGreenstein,
            _ => {
                let message = format!("there is no scattering of type {number}");
                let help = "1 is isotropic, 2 and 3 are Mie's for haze and murky air, 4 is Rayleigh's, 5 is Henyey and \
                            Greenstein's";
                return Diagnostic::new(codes::BAD_ARGUMENT, at, message).help(help).into();
            }
        };
        let mut scattering = Self { phase, color: r.color()?.rgb, ..Self::default() };
        loop {
            match r.peek_next()? {
                Next::End => return Ok(scattering),
                next if read_row(SCATTERING_ROWS, &mut scattering, next, r)? => {}
                _ => return Err(r.unknown_word_in(&SCATTERING)),
            }
        }
    }

    /// Returns the share of scattered light that goes towards the eye, relative to isotropic scattering;
    /// `cos_ray_to_light` is the cosine of the angle between the view ray and the direction to the light (quirk:
    /// `phase_functions`).
    pub fn phase_factor(&self, cos_ray_to_light: f64) -> f64 {
        match self.phase {
            Phase::Isotropic => 1.0,
            // K·(1 + 9·cos¹⁶(θ/2))
            Phase::MieHaze => 0.576656 * (1.0 + 9.0 * fp::integer_power((1.0 + cos_ray_to_light) / 2.0, 8)),
            // K·(1 + 50·cos⁶⁴(θ/2))
            Phase::MieMurky => 0.495716 * (1.0 + 50.0 * fp::integer_power((1.0 + cos_ray_to_light) / 2.0, 32)),
            // K·(1 + cos²θ)
            Phase::Rayleigh => 0.799372 * (1.0 + cos_ray_to_light * cos_ray_to_light),
            // (1 - g²) / (1 + g² - 2g·cosθ)^³ᐟ²
            Phase::HenyeyGreenstein => {
                let g = self.eccentricity;
                let base = (1.0 + g * g - 2.0 * g * cos_ray_to_light).max(0.0);
                (1.0 - g * g) / (base * base.sqrt())
            }
        }
    }
}
