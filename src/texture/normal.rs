//! `normal`: bumps that change the shading normal only (manual, "Normal").

use super::Texture;
use super::blend::{self, Blend, Entry, Map};
use super::pigment::read_uv_mapping;
use super::words::{NORMAL, NORMAL_ROWS};
use crate::diagnostic::Result;
use crate::pattern::{FieldPattern, ImagePattern, Pattern, PatternKind};
use crate::value::words::read_row;
use crate::value::{Next, Reader, ReaderExt};
use serde::Serialize;
use std::sync::Arc;

/// A height and a slope of a `slope_map`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Slope {
    /// Apparent height of the surface in a `slope_map`.
    pub height: f64,
    /// Derivative of the height in a `slope_map`.
    pub slope: f64,
}

/// Slope map: a map from numbers to heights and slopes.
pub type SlopeMap = Map<Slope>;

/// Source of a normal's bumps.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Relief {
    /// Bumps whose height is the pattern's number.
    #[default]
    Own,
    /// Bumps from a map from the pattern's numbers to heights and slopes.
    Slopes(Arc<SlopeMap>),
    /// Bumps from other normals, with their transforms.
    Normals(Blend<Normal>),
}

/// Bumps of a texture, from its `normal` block.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Normal {
    /// Pattern that gives the normal's bumps.
    pub pattern: Pattern,
    /// Source of the normal's bumps.
    pub relief: Relief,
    /// Apparent depth of the normal's bumps, from `bump_size` or the number after the pattern's name.
    pub amount: f64,
    /// Half the distance between the points at which the pattern of a normal is sampled.
    pub accuracy: f64,
    /// True if `uv_mapping` is in the normal itself: bumps then ignore the object's rotation (quirk:
    /// `uv_normal_stays`).
    pub stays: bool,
    /// True if `uv_mapping` is in the texture: the pigment then receives the bumped normal in the texture's space, as
    /// within a map (quirk: `uv_normal_stays`).
    pub framed: bool,
    /// False for `no_bump_scale`: scaling a normal then does not change the depth of its bumps.
    pub bump_scale: bool,
}

impl Default for Normal {
    fn default() -> Self {
        Self {
            pattern: Pattern::default(),
            relief: Relief::Own,
            amount: 0.5,
            accuracy: 0.02,
            stays: false,
            framed: false,
            bump_scale: true,
        }
    }
}

impl Normal {
    /// Reads the items of a `normal` block, on top of `base`; nested normals begin with the default one.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(r: &mut dyn Reader, base: Option<&Normal>, defaults: &Texture) -> Result<Self> {
        let uv = read_uv_mapping(r)?;
        let begun = match r.take_declared::<Normal>()? {
            Some(declared) => (*declared).clone(),
            None => base.cloned().unwrap_or_default(),
        };
        let mut out = begun.wrap_if_uv_mapped();
        if let Some(on) = uv {
            (out.pattern.uv, out.stays) = (on, out.stays || on);
        }
        loop {
            match r.peek_next()? {
                Next::End => break,
                next => out.read_element(r, next, defaults)?,
            }
        }
        out = out.unwrap_uv_mapped();
        out.pattern.separate_uv_space();
        Ok(out)
    }

    /// Wraps a normal that was mapped by uv, as the only entry of a map with the pattern `Surface`; returns any other
    /// normal unchanged.
    fn wrap_if_uv_mapped(mut self) -> Self {
        match self.pattern.take_space_outside_uv() {
            Some(pattern) => Self {
                pattern,
                relief: Relief::Normals(Blend::Map(Arc::new(Map { entries: vec![(0.0, self)] }))),
                ..Self::default()
            },
            None => self,
        }
    }

    /// Removes the one-entry map that [`Self::wrap_if_uv_mapped`] added, if no other pattern or map was named for the
    /// normal. (Other parameters of the surface have no effect.)
    fn unwrap_uv_mapped(self) -> Self {
        match &self.relief {
            Relief::Normals(Blend::Map(map)) if self.pattern.kind == PatternKind::Surface && map.entries.len() == 1 => {
                let mut inner = map.entries[0].1.clone();
                inner.pattern.restore_space_outside_uv(self.pattern);
                inner.bump_scale &= self.bump_scale;
                inner
            }
            _ => self,
        }
    }

    fn read_element(&mut self, r: &mut dyn Reader, next: Next, defaults: &Texture) -> Result<()> {
        if self.pattern.read_element(next, r)? {
            self.stays |= next == Next::Word("uv_mapping") && self.pattern.uv;
            if Pattern::begins_pattern(next) {
                self.read_bump_amount(r)?;
            }
            // Cells without a list make bumps where their numbers jump.
            let listed = matches!(r.peek_next()?, Next::Block(Self::BLOCK) | Next::Thing(Self::BLOCK));
            let list = blend::read_list(r, next, &self.pattern, defaults, &|_, _| Normal::default())?;
            if let Some(list) = list {
                // The accuracy of a default or declared normal ends there; it stays with other patterns (quirk:
                // cells_reset_accuracy).
                self.accuracy = Self::default().accuracy;
                self.relief = if listed { Relief::Normals(list) } else { Relief::Own };
            }
            return Ok(());
        }
        match next {
            next if read_row(NORMAL_ROWS, self, next, r)? => {}
            Next::Block("bump_map") => {
                r.take_token()?;
                let amount = &mut self.amount;
                let image = ImagePattern::read_words(r, "bump_map", &mut |r, next| {
                    let sized = next == Next::Word("bump_size");
                    if sized {
                        r.take_token()?;
                        *amount = r.float()?;
                    }
                    Ok(sized)
                })?;
                self.relief = Relief::Own;
                self.pattern.kind =
                    PatternKind::Field(FieldPattern::ImagePattern(ImagePattern { bumps: true, ..image }));
                r.leave_block()?;
            }
            Next::Block("slope_map") => {
                r.take_token()?;
                self.relief = Relief::Slopes(Arc::new(Map::read_entries(r, defaults, false)?));
                r.leave_block()?;
            }
            Next::Block("normal_map") => {
                r.take_token()?;
                self.relief =
                    Relief::Normals(Blend::Map(Arc::new(Map::read_entries(r, defaults, self.pattern.is_average())?)));
                r.leave_block()?;
            }
            _ => return Err(r.unknown_word_in(&NORMAL)),
        }
        Ok(())
    }

    /// Reads the amount of a normal's bumps after the pattern's name. (A map of the default or declared normal stays;
    /// quirk: `declared_slope_map_stays`.)
    fn read_bump_amount(&mut self, r: &mut dyn Reader) -> Result<()> {
        if let Some(amount) = r.optional_float()? {
            self.amount = amount;
        }
        Ok(())
    }

    /// True if `is` holds for any pattern of the normal.
    pub fn any_pattern(&self, is: &dyn Fn(&Pattern) -> bool) -> bool {
        let inner = matches!(&self.relief, Relief::Normals(parts) if parts.iter().any(|part| part.any_pattern(is)));
        is(&self.pattern) || inner
    }

    /// True if both normals are certainly equal, see [`Texture::is_certainly_equal`].
    pub fn is_certainly_equal(&self, other: &Self) -> bool {
        let large = matches!(&self.relief, Relief::Normals(_))
            || matches!(
                &self.pattern.kind,
                PatternKind::Field(FieldPattern::ImagePattern(_) | FieldPattern::DensityFile(_))
            );
        !large && self == other
    }

    /// True if the normal has no bumps.
    pub fn is_flat(&self) -> bool {
        match &self.relief {
            Relief::Normals(parts) => parts.iter().all(Normal::is_flat),
            _ => matches!(self.pattern.kind, PatternKind::Plain) || (self.amount == 0.0 && !self.framed),
        }
    }
}

impl Entry for Normal {
    const MAP: &'static str = "normal_map";
    const BLOCK: &'static str = "normal";

    fn read_entry(r: &mut dyn Reader, defaults: &Texture) -> Result<Self> {
        Self::read(r, defaults.layers[0].normal.as_deref(), defaults)
    }

    fn read_declared_or_color(r: &mut dyn Reader) -> Result<Option<Self>> {
        Ok(r.take_declared::<Normal>()?.map(|normal| (*normal).clone()))
    }
}

impl Entry for Slope {
    const MAP: &'static str = "slope_map";
    const BLOCK: &'static str = "<height, slope>";

    fn read_entry(r: &mut dyn Reader, _: &Texture) -> Result<Self> {
        let pair = r.vector2()?;
        Ok(Self { height: pair.x, slope: pair.y })
    }

    fn read_declared_or_color(_: &mut dyn Reader) -> Result<Option<Self>> {
        Ok(None)
    }
}
