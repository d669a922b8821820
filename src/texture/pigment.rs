//! `pigment`: colour and transparency of every point (manual, "Pigment").

use super::ColorMap;
use super::words::pigment_names;
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::{DVec3, Transform};
use crate::pattern::{CellPattern, Cells, Field, FieldPattern, Modifiers, NOT_DRAWN, WORDS_NOT_DRAWN};
use crate::value::{Next, Reader, ReaderExt};
use serde::Serialize;
use std::sync::Arc;

/// What gives the colour.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Paint {
    /// The same everywhere.
    Solid(Color),
    /// A colour for each kind of cell.
    Cells {
        /// Which cell a point is in.
        pattern: CellPattern,
        /// As many as the pattern has kinds.
        pigments: Vec<Pigment>,
    },
    /// A number for each point, and a map from numbers to colours.
    Mapped {
        /// The number.
        pattern: FieldPattern,
        /// What is done to the number.
        modifiers: Modifiers,
        /// The colours.
        map: Arc<ColorMap>,
    },
}

/// Paint in its own space.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pigment {
    /// What gives the colour.
    pub paint: Paint,
    /// From the pigment's space to that of its texture.
    pub transform: Transform,
    /// `quick_color`: shown with quality 5 and below.
    pub quick_color: Option<Color>,
}

impl Default for Pigment {
    fn default() -> Self {
        Self::solid(Color::BLACK)
    }
}

/// A pigment while it is read.
#[derive(Default)]
pub(super) struct Draft {
    cells: Option<CellPattern>,
    cell_pigments: Vec<Pigment>,
    field: Option<FieldPattern>,
    map: Option<Arc<ColorMap>>,
    modifiers: Modifiers,
    color: Option<Color>,
}

impl Pigment {
    /// One colour everywhere.
    pub fn solid(color: Color) -> Self {
        Self { paint: Paint::Solid(color), transform: Transform::IDENTITY, quick_color: None }
    }

    /// Reads what stands between the braces, on top of `base` (the default pigment).
    pub fn read(r: &mut dyn Reader, base: &Pigment) -> Result<Self> {
        let mut pigment = match r.thing::<Pigment>()? {
            Some(declared) => (*declared).clone(),
            None => base.clone(),
        };
        let mut draft = Draft::of(&pigment.paint);
        let mut touched = false;
        loop {
            match r.next()? {
                Next::End => break,
                Next::Word("translate" | "rotate" | "scale" | "matrix" | "transform")
                | Next::Block("transform")
                | Next::Thing("transform") => {
                    if let Some(step) = r.transform()? {
                        pigment.transform = pigment.transform.then(&step);
                    }
                }
                Next::Word("quick_color" | "quick_colour") => {
                    r.take()?;
                    pigment.quick_color = Some(r.color()?);
                }
                next => {
                    draft.read_element(r, next)?;
                    touched = true;
                }
            }
        }
        if touched {
            pigment.paint = draft.finish();
        }
        Ok(pigment)
    }

    /// The colour at a point of the space around it.
    pub fn at(&self, p: DVec3) -> Color {
        let inner = || self.transform.inverse_point(p);
        match &self.paint {
            Paint::Solid(color) => *color,
            Paint::Cells { pattern, pigments } => {
                let inner = inner();
                pigments.get(pattern.cell(inner)).map_or(Color::BLACK, |pigment| pigment.at(inner))
            }
            Paint::Mapped { pattern, modifiers, map } => map.at(modifiers.apply(pattern.value(inner()))),
        }
    }

    /// What the pattern gives at a point, without its map: the number of the cell, or what the wave makes of the number.
    pub fn number_at(&self, p: DVec3) -> f64 {
        let inner = || self.transform.inverse_point(p);
        match &self.paint {
            Paint::Solid(_) => 0.0,
            Paint::Cells { pattern, .. } => pattern.cell(inner()) as f64,
            Paint::Mapped { pattern, modifiers, .. } => modifiers.apply(pattern.value(inner())),
        }
    }

    /// Does no light pass anywhere?
    pub fn is_opaque(&self) -> bool {
        let opaque = |c: &Color| c.filter == 0.0 && c.transmit == 0.0;
        match &self.paint {
            Paint::Solid(color) => opaque(color),
            Paint::Cells { pigments, .. } => pigments.iter().all(Pigment::is_opaque),
            Paint::Mapped { map, .. } => map.entries.iter().all(|(_, color)| opaque(color)),
        }
    }

    /// Moves the pigment after all it has been moved before.
    pub fn transformed(mut self, by: &Transform) -> Self {
        self.transform = self.transform.then(by);
        self
    }
}

impl Draft {
    /// A declared pigment that is changed: `pigment { Wood color_map { … } }`.
    pub(super) fn of(paint: &Paint) -> Self {
        match paint.clone() {
            Paint::Solid(color) => Draft { color: Some(color), ..Draft::default() },
            Paint::Cells { pattern, pigments } => {
                Draft { cells: Some(pattern), cell_pigments: pigments, ..Draft::default() }
            }
            Paint::Mapped { pattern, modifiers, map } => {
                Draft { field: Some(pattern), map: Some(map), modifiers, ..Draft::default() }
            }
        }
    }

    pub(super) fn read_element(&mut self, r: &mut dyn Reader, next: Next) -> Result<()> {
        match next {
            Next::Word(word) if self.is_own_word(word) => {
                r.take()?;
                match (&mut self.cells, &mut self.field) {
                    (Some(pattern), _) => pattern.read_word(word, r),
                    (_, Some(pattern)) => pattern.read_word(word, r),
                    _ => Ok(()),
                }
            }
            Next::Word(word) if Modifiers::WORDS.iter().any(|w| w.name == word) => {
                r.take()?;
                self.modifiers.read_word(word, r)
            }
            Next::Word(word) if CellPattern::SPECS.iter().any(|s| s.name == word) => self.read_cells(r, word),
            Next::Word(word) if FieldPattern::SPECS.iter().any(|s| s.name == word) => {
                r.take()?;
                if let Some(pattern) = FieldPattern::read(word, r) {
                    (self.field, self.cells) = (Some(pattern?), None);
                }
                Ok(())
            }
            Next::Block("color_map" | "colour_map") => {
                r.take()?;
                self.map = Some(Arc::new(ColorMap::read(r)?));
                r.leave()
            }
            Next::Function => r.skip_unsupported("function"),
            Next::Word(word) if NOT_DRAWN.contains(&word) || WORDS_NOT_DRAWN.contains(&word) => {
                r.skip_unsupported(word)
            }
            Next::Block(word) if NOT_DRAWN.contains(&word) || WORDS_NOT_DRAWN.contains(&word) => {
                r.skip_unsupported(word)
            }
            Next::Word(_) if !r.at_color()? => Err(r.unknown_word("pigment", &pigment_names()).into()),
            Next::Word(_) | Next::Value => {
                self.color = Some(r.color()?);
                (self.field, self.cells) = (None, None);
                Ok(())
            }
            _ => Err(r.unknown_word("pigment", &pigment_names()).into()),
        }
    }

    fn is_own_word(&self, word: &str) -> bool {
        let spec = self.cells.as_ref().map(CellPattern::spec).or(self.field.as_ref().map(FieldPattern::spec));
        spec.is_some_and(|s| s.words.iter().any(|w| w.name == word))
    }

    /// `checker color A, color B` or `checker pigment { … } pigment { … }`; what is missing gets the defaults.
    fn read_cells(&mut self, r: &mut dyn Reader, word: &str) -> Result<()> {
        r.take()?;
        let Some(pattern) = CellPattern::read(word, r).transpose()? else { return Ok(()) };
        let mut pigments = vec![];
        for cell in 0..pattern.count() {
            let pigment = if r.next()? == Next::Block("pigment") {
                r.take()?;
                let pigment = Pigment::read(r, &Pigment::default())?;
                r.leave()?;
                pigment
            } else if let Some(declared) = r.thing::<Pigment>()? {
                (*declared).clone()
            } else if r.at_color()? {
                Pigment::solid(r.color()?)
            } else {
                Pigment::solid(pattern.default_color(cell))
            };
            pigments.push(pigment);
        }
        (self.cells, self.cell_pigments, self.field) = (Some(pattern), pigments, None);
        Ok(())
    }

    pub(super) fn finish(self) -> Paint {
        match (self.cells, self.field, self.map) {
            (Some(pattern), ..) => Paint::Cells { pattern, pigments: self.cell_pigments },
            (_, Some(pattern), map) => {
                let map = map.unwrap_or_else(|| Arc::new(ColorMap::black_to_white()));
                Paint::Mapped { pattern, modifiers: self.modifiers, map }
            }
            // A pattern that is not drawn yet, with its map: the map's middle stands for it.
            (_, _, Some(map)) => Paint::Solid(map.at(0.5)),
            _ => Paint::Solid(self.color.unwrap_or(Color::BLACK)),
        }
    }
}
