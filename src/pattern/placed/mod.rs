//! A pattern with its space and parameters: the common part of pigments, normals and textures.

mod local_bounds;
mod modifiers;
mod program;
mod space;
mod turbulence;

pub use modifiers::{Modifiers, Wave};
pub use program::PatternProgram;
pub use space::{Space, Step};
pub use turbulence::TurbulenceParams;

use super::{CellPattern, Field, FieldPattern, FunctionPattern, Warp};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::Transform;
use crate::math::noise::NoiseGenerator;
use crate::value::words::{is_word_in_rows, read_row};
use crate::value::{Family, Next, Readable, Reader, SharedDefault, StaticDefault};
use serde::Serialize;

/// Choice of a pattern: function from points to the entry or number that is shown.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PatternKind {
    /// No pattern; every point gets the same value.
    #[default]
    Plain,
    /// Pattern that assigns a number to each point; a map turns the number into what is shown.
    Field(FieldPattern),
    /// Pattern that assigns a cell to each point; the cell's index selects from a list.
    Cells(CellPattern),
    /// Pattern `average`: the weighted mean of all entries of the map.
    Average,
    /// Pattern whose point is replaced by (u, v, 0), and the first entry of the map shows: the form of a block with
    /// `uv_mapping` for a pigment or normal that begins with it (see [`Pattern::around`]).
    Surface,
}

/// A pattern with all its parameters except its colours.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Pattern {
    /// Function from points to the entry or number that the pattern selects.
    pub kind: PatternKind,
    /// Frequency, phase and wave type of the pattern.
    pub modifiers: Modifiers,
    /// Transforms, warps and turbulence of the pattern.
    pub space: Space,
    /// Version of the noise that the pattern's `noise_generator` selects; `None` without that keyword.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise: Option<NoiseGenerator>,
    /// True for `uv_mapping`: the pattern receives (u, v, 0) instead of the point.
    pub uv: bool,
    /// True if `uv_mapping` is given for the texture around the pattern, not for the pattern itself.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub framed: bool,
    /// True if the filter of the pattern's colours transmits light untinted (quirk: `untinted_upper_layers`).
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub untinted: bool,
    /// For a pattern that was mapped by uv when its block ended: the space around the mapping, which later transforms
    /// change. It shows only if a pattern is named later, whose map then is the one entry that is left (quirk:
    /// `uv_mapping_keeps_space`).
    #[serde(skip)]
    pub around: Option<Box<Space>>,
}

impl PatternKind {
    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        match self {
            PatternKind::Field(pattern) => pattern.read_own(next, r),
            PatternKind::Cells(pattern) => pattern.read_own(next, r),
            PatternKind::Plain | PatternKind::Average | PatternKind::Surface => Ok(false),
        }
    }
}

impl StaticDefault for Pattern {
    fn static_default() -> &'static Self {
        static PLAIN: Pattern = Pattern {
            kind: PatternKind::Plain,
            modifiers: Modifiers::NONE,
            space: Space { inner: vec![], transform: SharedDefault::DEFAULT, turbulence: None },
            noise: None,
            uv: false,
            framed: false,
            untinted: false,
            around: None,
        };
        &PLAIN
    }
}

impl Pattern {
    /// Reads one element if it belongs to the pattern: its name, its words, transforms, warps, turbulence; returns
    /// false if not.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read_element(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        match next {
            next if next.is_transform() => {
                if let Some(step) = r.transform()? {
                    self.transform(&step);
                }
            }
            next if self.kind.read_own(next, r)? => {}
            next if read_row(Modifiers::ROWS, &mut self.modifiers, next, r)? => {}
            next if is_word_in_rows(TurbulenceParams::ROWS, next) => {
                read_row(TurbulenceParams::ROWS, self.space.turbulence_mut(), next, r)?;
            }
            Next::Word("noise_generator") => {
                r.take_token()?;
                // quirk: noise_generator_bits
                let bits = |noise: Option<NoiseGenerator>| noise.map_or(0, NoiseGenerator::number);
                self.noise = match bits(self.noise) | bits(read_noise_generator(r, 0.0)?) {
                    0 => None,
                    number => Some(NoiseGenerator::from_number_modulo_4(f64::from(number))),
                };
            }
            Next::Word("uv_mapping") => {
                r.take_token()?;
                self.uv = r.flag()?;
            }
            Next::Block("warp") => {
                let span = r.take_token()?;
                let warp = Warp::read(span, r)?;
                r.leave_block()?;
                self.space.append_warp(warp);
            }
            Next::Word("average") => {
                r.take_token()?;
                self.kind = PatternKind::Average;
            }
            Next::Function => self.kind = PatternKind::Field(FieldPattern::FunctionPattern(FunctionPattern::read(r)?)),
            _ => return self.read_name(next, r),
        }
        Ok(true)
    }

    /// Reads a pattern's name and parameters; false if `next` names no pattern.
    fn read_name(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        if let Some(pattern) = FieldPattern::read_named(next, r)? {
            self.modifiers.wave = pattern.default_wave().unwrap_or(self.modifiers.wave);
            if pattern.starts_with_zero_frequency() {
                self.modifiers.frequency = Some(0.0);
            }
            self.kind = PatternKind::Field(pattern);
        } else if let Some(pattern) = CellPattern::read_named(next, r)? {
            self.kind = PatternKind::Cells(pattern);
            self.modifiers.frequency = Some(0.0);
        } else {
            return Ok(false);
        }
        Ok(true)
    }

    /// True if `next` begins a pattern: its name, or a function.
    pub fn begins_pattern(next: Next) -> bool {
        let is_name = |word| FieldPattern::is_name(word) || CellPattern::is_name(word);
        matches!(next, Next::Word(word) | Next::Block(word) if is_name(word)) || next == Next::Function
    }

    /// True if the pattern mixes all entries of the map.
    pub fn is_average(&self) -> bool {
        self.kind == PatternKind::Average
    }

    /// Appends a transform to those of the pattern.
    pub fn transform(&mut self, by: &Transform) {
        self.around.as_deref_mut().unwrap_or(&mut self.space).append_transform(by);
    }

    /// Ends the block that contains the pattern: a pattern with `uv_mapping` keeps its space apart from later
    /// transforms.
    pub fn separate_uv_space(&mut self) {
        if self.uv {
            self.around.get_or_insert_default();
        }
    }

    /// Removes the space around a pattern that was mapped by uv, and returns it as the space of a new pattern of the
    /// kind `Surface`; from then on this pattern receives points. `None` if this pattern was not mapped.
    pub fn take_space_outside_uv(&mut self) -> Option<Self> {
        let space = *self.around.take()?;
        self.uv = false;
        Some(Self { kind: PatternKind::Surface, space, ..Self::default() })
    }

    /// Restores the space around a pattern that [`Self::take_space_outside_uv`] returned.
    pub fn restore_space_outside_uv(&mut self, around: Self) {
        (self.uv, self.around) = (true, Some(Box::new(around.space)));
    }

    /// True if the pattern receives (u, v, 0) instead of the point.
    pub fn receives_uv(&self) -> bool {
        self.uv || self.kind == PatternKind::Surface
    }

    /// True if the pattern, or the pigment whose brightness it is, depends on surface coordinates.
    pub fn depends_on_uv(&self) -> bool {
        self.receives_uv()
            || matches!(&self.kind, PatternKind::Field(FieldPattern::PigmentPattern(inner)) if inner.depends_on_uv())
    }

    /// True if the pattern may depend on the surface normal. (Functions and the pigments of patterns are not searched.)
    pub fn may_depend_on_normal(&self) -> bool {
        use FieldPattern::{Aoi, FunctionPattern, PigmentPattern, Slope};
        matches!(self.kind, PatternKind::Field(Slope(_) | Aoi(_) | FunctionPattern(_) | PigmentPattern(_)))
    }
}

/// Reads the argument of a pattern's `noise_generator`: a number from `least` to below 4, whose fraction is ignored. `None`
/// below 1, for the scene's generator.
///
/// # Errors
/// A diagnostic at the item that is not understood.
pub fn read_noise_generator(r: &mut dyn Reader, least: f64) -> Result<Option<NoiseGenerator>> {
    let (at, n) = (r.span(), r.float()?);
    if (least..4.0).contains(&n) {
        return Ok((n >= 1.0).then(|| NoiseGenerator::from_number_modulo_4(n)));
    }
    let message = format!("there are noise generators 1, 2 and 3, but none with the number {n}");
    Diagnostic::err(codes::BAD_ARGUMENT, at, message)
}
