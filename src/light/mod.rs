//! `light_source` (manual, "Light Source").

pub mod words;

use crate::color::Rgb;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::{Result, codes};
use crate::math::{DVec3, Transform};
use crate::source::Span;
use crate::value::words::read_row;
use crate::value::{Next, RawItem, Reader, Thing};
use serde::Serialize;
use words::{LIGHT, LIGHT_ROWS};

/// A point of light.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Light {
    /// Where it is, in the space around the block.
    pub location: DVec3,
    /// Its colour; negative ones darken.
    pub color: Rgb,
    /// Casts no shadow and makes no highlight.
    pub shadowless: bool,
    /// Distance at which it has its full colour; 0: it does not fade.
    pub fade_distance: f64,
    /// How fast it fades; 0: it does not.
    pub fade_power: f64,
    /// What was said and is not drawn yet.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub undrawn: Vec<RawItem>,
    /// The text that made it.
    pub source: Span,
}

impl Thing for Light {
    fn kind(&self) -> &'static str {
        "light_source"
    }
}

impl Light {
    /// Reads what stands between the braces; `source` is the block's place.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read(r: &mut dyn Reader, source: Span) -> Result<Self> {
        let location = r.vector()?;
        let color = r.color()?.rgb;
        let mut light =
            Self { location, color, shadowless: false, fade_distance: 0.0, fade_power: 0.0, undrawn: vec![], source };
        loop {
            match r.next()? {
                Next::End => return Ok(light),
                next if read_row(LIGHT_ROWS, &mut light, next, r)? => {}
                next if next.moves() => {
                    if let Some(step) = r.transform()? {
                        light.transform(&step);
                    }
                }
                Next::Word(word) | Next::Block(word) if LIGHT.leaves_out(word) => {
                    light.undrawn.push(r.keep_undrawn(word)?)
                }
                _ => return Err(r.unknown_word("light_source", &LIGHT.names()).into()),
            }
        }
    }

    /// Moves the light.
    pub fn transform(&mut self, by: &Transform) {
        self.location = by.point(self.location);
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
