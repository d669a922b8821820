//! `light_source` (manual, "Light Source"): as written, and lowered to [`LoweredLight`].

mod area;
mod beam;
mod lowered;
mod photons;
pub mod words;

pub use area::Area;
pub use beam::{Beam, Edge};
pub use lowered::{LightSample, LoweredLight};
pub use photons::{LIGHT_PHOTONS, LightPhotons};

use crate::color::Rgb;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::{Result, codes};
use crate::math::{DVec3, Transform};
use crate::source::Span;
use crate::value::words::read_row;
use crate::value::{Next, Reader, Thing};
use area::AREA_ROWS;
use beam::BEAM_ROWS;
use serde::Serialize;
use words::LIGHT_ROWS;

/// Light source as written in a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Light {
    /// Location of the light, in the space around its block.
    pub location: DVec3,
    /// Colour of the light; negative values darken.
    pub color: Rgb,
    /// Directional distribution of the light.
    pub beam: Beam,
    /// Target of a spotlight, cylinder light or parallel light.
    pub point_at: DVec3,
    /// True if all rays of the light are parallel.
    pub parallel: bool,
    /// True if the light casts no shadow and makes no highlight.
    pub shadowless: bool,
    /// True for an area light: the scene states `area_light`.
    pub spreads: bool,
    /// Grid of the area light; its words may precede `area_light`.
    pub area: Area,
    /// Distance at which the light has its full strength; 0 for no fall-off.
    pub fade_distance: f64,
    /// Exponent of the light's fall-off by distance; 0 for no fall-off.
    pub fade_power: f64,
    /// True if media scatter the light.
    pub media_interaction: bool,
    /// True if media attenuate the light.
    pub media_attenuation: bool,
    /// Settings of the photons that the light emits.
    pub photons: LightPhotons,
    /// Span of the light source in the scene.
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
            photons: LightPhotons::default(),
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
    /// Reads the location and colour of a light source; `source` is the span of its word.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read_location_and_color(r: &mut dyn Reader, source: Span) -> Result<Self> {
        let location = r.vector()?;
        let color = if r.may_be_at_color()? { r.color()?.rgb } else { Rgb::ZERO };
        Ok(Self { location, color, source, ..Self::default() })
    }

    /// Reads one word of a light source, if it is next, and what follows it; returns false otherwise.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        for rows in [LIGHT_ROWS, BEAM_ROWS, AREA_ROWS] {
            if read_row(rows, self, next, r)? {
                return Ok(true);
            }
        }
        match next {
            Next::Block("photons") => self.photons.read_with_braces(r)?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Checks, when the block is complete, that a `circular` area light has more than one light along each side.
    ///
    /// # Errors
    /// A diagnostic for a grid that cannot be circular.
    pub fn check_circular_grid(&self) -> Result<()> {
        let area = &self.area;
        if self.spreads && area.circular && area.size.contains(&1) {
            let message = "a `circular` area light has more than one light along each side";
            return Diagnostic::err(codes::BAD_ARGUMENT, self.source, message);
        }
        Ok(())
    }

    /// Transforms the light's location, axes and target.
    pub fn transform(&mut self, by: &Transform) {
        self.location = by.transform_point(self.location);
        self.point_at = by.transform_point(self.point_at);
        self.area.axes = self.area.axes.map(|axis| by.transform_vector(axis));
    }
}

fn read_finite(r: &mut dyn Reader) -> Result<f64> {
    let span = r.span();
    let value = r.float()?;
    if value.is_finite() {
        return Ok(value);
    }
    Diagnostic::err(codes::NOT_FINITE, span, "this is not a finite number")
}
