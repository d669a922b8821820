//! `light_source` (manual, "Light Source"): what the author said, and what a ray needs of it, [`LoweredLight`].

mod area;
mod beam;
mod lowered;
pub mod words;

pub use area::Area;
pub use beam::{Beam, Edge};
pub use lowered::{LightSample, LoweredLight};

use crate::color::Rgb;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::{Result, codes};
use crate::math::{DVec3, Transform};
use crate::source::Span;
use crate::value::words::read_row;
use crate::value::{Next, Reader, Thing, Unsupported};
use area::AREA_ROWS;
use beam::BEAM_ROWS;
use serde::Serialize;
use words::{LIGHT, LIGHT_ROWS};

/// A light.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Light {
    /// Where it is, in the space around the block.
    pub location: DVec3,
    /// Its colour; negative ones darken.
    pub color: Rgb,
    /// Where it shines to.
    pub beam: Beam,
    /// What beams and parallel light point at.
    pub point_at: DVec3,
    /// Is all its light parallel?
    pub parallel: bool,
    /// Casts no shadows and makes no highlights.
    pub shadowless: bool,
    /// Is it one of a grid of lights?
    pub spreads: bool,
    /// The grid; its words may stand before `area_light` itself.
    pub area: Area,
    /// Distance at which it has its full colour; 0: it does not fade.
    pub fade_distance: f64,
    /// How fast it fades; 0: it does not.
    pub fade_power: f64,
    /// Does it light up media?
    pub media_interaction: bool,
    /// Do media take from it on its way?
    pub media_attenuation: bool,
    /// What was said and is not drawn yet.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unsupported: Vec<Unsupported>,
    /// The text that made it.
    pub source: Span,
}

impl Default for Light {
    fn default() -> Self {
        Self {
            location: DVec3::ZERO,
            color: Rgb::ZERO,
            beam: Beam::Round,
            point_at: DVec3::Z,
            parallel: false,
            shadowless: false,
            spreads: false,
            area: Area::default(),
            fade_distance: 0.0,
            fade_power: 0.0,
            media_interaction: true,
            media_attenuation: false,
            unsupported: vec![],
            source: Span::NONE,
        }
    }
}

impl Thing for Light {
    fn kind(&self) -> &'static str {
        "light_source"
    }
}

impl Light {
    /// Reads what every light begins with: its place and its colour; `source` is the block's place.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read(r: &mut dyn Reader, source: Span) -> Result<Self> {
        let location = r.vector()?;
        let color = r.color()?.rgb;
        Ok(Self { location, color, source, ..Self::default() })
    }

    /// Reads one of its words, if it comes next, and what follows it; false if none does.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        for rows in [LIGHT_ROWS, BEAM_ROWS, AREA_ROWS] {
            if read_row(rows, self, next, r)? {
                return Ok(true);
            }
        }
        match next {
            Next::Word(word) | Next::Block(word) if LIGHT.is_unsupported(word) => {
                self.unsupported.push(r.read_unsupported(word)?)
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Checks what only the whole block shows.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn finish(&self) -> Result<()> {
        let area = &self.area;
        if self.spreads && area.circular && area.size.contains(&1) {
            let message = "a `circular` area light has more than one light along each side";
            return Diagnostic::err(codes::BAD_ARGUMENT, self.source, message);
        }
        Ok(())
    }

    /// Moves the light.
    pub fn transform(&mut self, by: &Transform) {
        self.location = by.point(self.location);
        self.point_at = by.point(self.point_at);
        self.area.axes = self.area.axes.map(|axis| by.vector(axis));
    }
}

fn finite(r: &mut dyn Reader) -> Result<f64> {
    let span = r.span();
    let value = r.float()?;
    if value.is_finite() {
        return Ok(value);
    }
    Diagnostic::err(codes::NOT_FINITE, span, "this is not a finite number")
}
