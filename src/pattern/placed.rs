//! A pattern where it lies: what pigments, normals and textures have in common.

use super::{CellPattern, Field, FieldPattern, FunctionPattern, Modifiers, Readable, Space, Turbulent, Warp};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::Transform;
use crate::math::noise::NoiseGenerator;
use crate::value::words::{is_row, read_row};
use crate::value::{Next, Reader, SharedDefault, StaticDefault};
use serde::Serialize;

/// What tells points apart.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Nothing: it is the same everywhere.
    #[default]
    Plain,
    /// A number for each point, and a map from numbers to what is seen.
    Field(FieldPattern),
    /// A list from which each cell takes its own.
    Cells(CellPattern),
    /// `average`: all entries of the map at once, by their weights.
    Average,
    /// Places on the surface, (u, v, 0), stand for points, and the first entry of the map shows: what a block with `uv_mapping` is
    /// to a pigment or normal that begins with it (see [`Pattern::around`]).
    Surface,
}

/// A pattern with all that is said of it, but for its colours.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Pattern {
    /// What tells points apart.
    pub kind: Kind,
    /// What is done to its numbers.
    pub modifiers: Modifiers,
    /// Where it lies.
    pub space: Space,
    /// Which noise it is made of, if it says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise: Option<NoiseGenerator>,
    /// `uv_mapping`: it sees the place on the surface, (u, v, 0), instead of the point.
    pub uv: bool,
    /// It sees that because all of its texture does, not by a word of its own.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub framed: bool,
    /// Of what was mapped by uv when its block ended: the space around the surface. What moves it later moves this one, which shows
    /// only if a pattern is named over it: that one sees the map of one entry that is left (measured on POV-Ray 3.7).
    #[serde(skip)]
    pub around: Option<Box<Space>>,
}

impl Kind {
    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        match self {
            Kind::Field(pattern) => pattern.read_own(next, r),
            Kind::Cells(pattern) => pattern.read_own(next, r),
            Kind::Plain | Kind::Average | Kind::Surface => Ok(false),
        }
    }
}

impl StaticDefault for Pattern {
    fn static_default() -> &'static Self {
        static PLAIN: Pattern = Pattern {
            kind: Kind::Plain,
            modifiers: Modifiers::NONE,
            space: Space { inner: vec![], transform: SharedDefault::DEFAULT, turbulence: None },
            noise: None,
            uv: false,
            framed: false,
            around: None,
        };
        &PLAIN
    }
}

impl Pattern {
    /// Reads one element if it belongs to the pattern: its name, its words, transforms, warps, turbulence; else false.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read_element(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        match next {
            next if next.is_transform() => {
                if let Some(step) = r.transform()? {
                    self.transform(&step);
                }
            }
            next if self.kind.read_own(next, r)? => {}
            next if read_row(Modifiers::ROWS, &mut self.modifiers, next, r)? => {}
            next if is_row(Turbulent::ROWS, next) => {
                read_row(Turbulent::ROWS, self.space.turbulence_mut(), next, r)?;
            }
            Next::Word("noise_generator") => {
                r.take()?;
                // POV-Ray 3.7 keeps two bits, and adds those of a second number to those of the first, which may be a declared or
                // default pigment's (measured).
                let bits = |noise: Option<NoiseGenerator>| noise.map_or(0, NoiseGenerator::number);
                self.noise = match bits(self.noise) | bits(read_noise_generator(r, 0.0)?) {
                    0 => None,
                    number => Some(NoiseGenerator::from_number(f64::from(number))),
                };
            }
            Next::Word("uv_mapping") => {
                r.take()?;
                self.uv = r.flag()?;
            }
            Next::Block("warp") => {
                r.take()?;
                let warp = Warp::read(r)?;
                r.leave()?;
                self.space.warp(warp);
            }
            Next::Word("average") => {
                r.take()?;
                self.kind = Kind::Average;
            }
            Next::Function => self.kind = Kind::Field(FieldPattern::FunctionPattern(FunctionPattern::read(r)?)),
            Next::Word(word) | Next::Block(word) => return self.read_name(word, r),
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Reads what follows the name of a pattern; false if it is none.
    fn read_name(&mut self, word: &'static str, r: &mut dyn Reader) -> Result<bool> {
        let block = matches!(r.next()?, Next::Block(_));
        if FieldPattern::is_name(word) {
            r.take()?;
            if let Some(pattern) = FieldPattern::read(word, block, r) {
                let pattern = pattern?;
                self.modifiers.wave = pattern.default_wave().unwrap_or(self.modifiers.wave);
                if pattern.begins_still() {
                    self.modifiers.frequency = Some(0.0);
                }
                self.kind = Kind::Field(pattern);
            }
        } else if CellPattern::is_name(word) {
            r.take()?;
            if let Some(pattern) = CellPattern::read(word, block, r) {
                self.kind = Kind::Cells(pattern?);
                self.modifiers.frequency = Some(0.0);
            }
        } else {
            return Ok(false);
        }
        Ok(true)
    }

    /// Does this begin a pattern: its name, or a function?
    pub fn is_named_by(next: Next) -> bool {
        let is_name = |word| FieldPattern::is_name(word) || CellPattern::is_name(word);
        matches!(next, Next::Word(word) | Next::Block(word) if is_name(word)) || next == Next::Function
    }

    /// Does it show all of its map's entries at once?
    pub fn averages(&self) -> bool {
        self.kind == Kind::Average
    }

    /// Moves it after all it has been moved before.
    pub fn transform(&mut self, by: &Transform) {
        self.around.as_deref_mut().unwrap_or(&mut self.space).then(by);
    }

    /// The end of the block that it stands in.
    pub fn end(&mut self) {
        if self.uv {
            self.around.get_or_insert_default();
        }
    }

    /// The surface around what was mapped by uv, which from now on sees points; `None` if it was not.
    pub fn take_around(&mut self) -> Option<Self> {
        let space = *self.around.take()?;
        self.uv = false;
        Some(Self { kind: Kind::Surface, space, ..Self::default() })
    }

    /// Undoes [`Self::take_around`].
    pub fn put_around(&mut self, around: Self) {
        (self.uv, self.around) = (true, Some(Box::new(around.space)));
    }

    /// Does it see the place on the surface, (u, v, 0), instead of the point?
    pub fn by_uv(&self) -> bool {
        self.uv || self.kind == Kind::Surface
    }

    /// Does it, or the pigment of which it is the brightness, ask where the point lies on its shape?
    pub fn asks_uv(&self) -> bool {
        self.by_uv() || matches!(&self.kind, Kind::Field(FieldPattern::PigmentPattern(inner)) if inner.asks_uv())
    }

    /// May it see the surface's normal? (What is in a function or in the pigment of a pattern is not looked at.)
    pub fn may_see_normal(&self) -> bool {
        use FieldPattern::{Aoi, FunctionPattern, PigmentPattern, Slope};
        matches!(self.kind, Kind::Field(Slope(_) | Aoi(_) | FunctionPattern(_) | PigmentPattern(_)))
    }
}

/// `noise_generator N`, after the word; 0, which is less than `least` where it can't be said, is the scene's.
///
/// # Errors
/// With the place of what is not understood, and what was expected there.
pub fn read_noise_generator(r: &mut dyn Reader, least: f64) -> Result<Option<NoiseGenerator>> {
    let (at, n) = (r.span(), r.float()?);
    if (least..4.0).contains(&n) {
        return Ok((n >= 1.0).then(|| NoiseGenerator::from_number(n)));
    }
    let message = format!("there are noise generators 1, 2 and 3, but none with the number {n}");
    Diagnostic::err(codes::BAD_ARGUMENT, at, message)
}
