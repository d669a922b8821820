//! `pigment`: colour and transparency of every point (manual, "Pigment").

use super::blend::{self, Blend, Entry, Map};
use super::doubts::warn_if_color_in_bytes;
use super::words::{PIGMENT, PIGMENT_ROWS, words_of_pigment_block};
use super::{ColorMap, ImageMap, Texture};
use crate::color::Color;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::pattern::{CellPattern, Cells, Field, Pattern, PatternKind};
use crate::value::words::read_row;
use crate::value::{Next, Reader, ReaderExt, SharedDefault, Thing};
use serde::Serialize;
use std::sync::Arc;

/// Source of a pigment's colour.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Paint {
    /// Pigment of one colour; where a pattern follows, its default colours.
    Solid(Color),
    /// Pigment whose colour is that of a map at the pattern's number.
    Colors(Arc<ColorMap>),
    /// Pigment that selects from other pigments, with their transforms.
    Pigments(Blend<Pigment>),
    /// Pigment that is a picture, projected onto the points.
    Image(Arc<ImageMap>),
}

/// Pigment: colours in a space of their own.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pigment {
    /// Pattern whose number or cell selects the pigment's colour.
    pub pattern: SharedDefault<Pattern>,
    /// Source of the pigment's colour.
    pub paint: Paint,
    /// Colour of the pigment at quality 5 and below, from `quick_color`; `None` for the usual colours.
    pub quick_color: Option<Box<Color>>,
}

impl Default for Pigment {
    fn default() -> Self {
        Self::solid(Color::BLACK)
    }
}

impl Pigment {
    /// Returns a pigment of one colour.
    pub fn solid(color: Color) -> Self {
        Self { pattern: SharedDefault::DEFAULT, paint: Paint::Solid(color), quick_color: None }
    }

    /// Creates a pigment that is mapped by surface coordinates.
    pub fn mapped_by_uv(paint: Paint) -> Self {
        let mut pigment = Self { paint, ..Self::default() };
        pigment.pattern.uv = true;
        pigment.pattern.separate_uv_space();
        pigment
    }

    /// Reads the items of a `pigment` block, on top of `base`; nested pigments begin with the default one.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(r: &mut dyn Reader, base: &Pigment, defaults: &Texture) -> Result<Self> {
        let uv = read_uv_mapping(r)?;
        let declared = r.take_declared::<Pigment>()?;
        let mut after_name = declared.is_some();
        let mut pigment = declared.map_or_else(|| base.clone(), |declared| (*declared).clone()).wrap_if_uv_mapped();
        if let Some(on) = uv {
            pigment.pattern.uv = on;
        }
        loop {
            match r.peek_next()? {
                Next::End => break,
                Next::Word("uv_mapping") if after_name => pigment.reset_by_uv_mapping(r)?,
                next => pigment.read_element::<Pigment>(r, next, defaults)?,
            }
            after_name = false;
        }
        if uv == Some(true) && base.pattern.around.is_none() && base.quick_color.is_some() {
            // Parameters here apply to the surface around the mapping; a default one hides them unless it has
            // `uv_mapping` too (quirk: uv_mapping_pigments).
            pigment.quick_color = base.quick_color.clone();
        }
        pigment = pigment.unwrap_uv_mapped();
        pigment.set_default_colors();
        // (A default pattern takes no memory.)
        if pigment.pattern.uv {
            pigment.pattern.separate_uv_space();
        }
        Ok(pigment)
    }

    /// Wraps a pigment that was mapped by uv, as the only entry of a map with the pattern `Surface`; returns any other
    /// pigment unchanged. The quick colour of a wrapped pigment belongs to the entry, and is lost with it (quirk:
    /// `uv_mapping_pigments`).
    fn wrap_if_uv_mapped(mut self) -> Self {
        if self.pattern.around.is_none() {
            return self;
        }
        let around = self.pattern.take_space_outside_uv();
        let map = Map { entries: vec![(0.0, self)] };
        Self {
            pattern: around.map_or(SharedDefault::DEFAULT, SharedDefault::new),
            paint: Paint::Pigments(Blend::Map(Arc::new(map))),
            quick_color: None,
        }
    }

    /// Removes the one-entry map that [`Self::wrap_if_uv_mapped`] added, if no other pattern or map was named for the
    /// pigment.
    fn unwrap_uv_mapped(self) -> Self {
        match &self.paint {
            Paint::Pigments(Blend::Map(map)) if self.pattern.kind == PatternKind::Surface && map.entries.len() == 1 => {
                let mut inner = map.entries[0].1.clone();
                inner.pattern.restore_space_outside_uv((*self.pattern).clone());
                inner.quick_color = self.quick_color.or(inner.quick_color);
                inner
            }
            _ => self,
        }
    }

    /// Begins a new, black pigment for `uv_mapping` after the name of a declared pigment (quirk:
    /// `uv_mapping_pigments`).
    fn reset_by_uv_mapping(&mut self, r: &mut dyn Reader) -> Result<()> {
        let at = r.take_token()?;
        r.flag()?;
        self.forget_pattern();
        self.paint = Paint::Solid(Color::BLACK);
        let message = "`uv_mapping` after the name of a pigment makes the pigment black";
        r.report(Diagnostic::new(codes::MISPLACED, at, message).help("it belongs before the name"));
        Ok(())
    }

    /// Reads one element of a pigment: a word of its pattern, a map, a list, a colour. `E` is the value of maps and
    /// lists: a pigment or a density.
    pub(super) fn read_element<E: PigmentEntry>(
        &mut self,
        r: &mut dyn Reader,
        next: Next,
        defaults: &Texture,
    ) -> Result<()>
    where
        Map<E>: Thing,
    {
        if Pattern::begins_pattern(next) && self.has_default_paint() {
            self.paint = Paint::Solid(Color::BLACK);
        }
        if self.pattern.modify_if(|pattern| pattern.read_element(next, r))? {
            let default = |cells: &CellPattern, cell| E::from(Pigment::solid(cells.default_color(cell)));
            if let Some(list) = blend::read_list(r, next, &self.pattern, defaults, &default)? {
                self.paint = Paint::Pigments(list.map(|entry| entry.clone().into()));
            }
            return Ok(());
        }
        match next {
            next if read_row(PIGMENT_ROWS, self, next, r)? => Ok(()),
            Next::Word(word) if PIGMENT.ignores(word) => {
                r.take_token()?;
                r.flag().map(drop)
            }
            Next::Block("color_map" | "colour_map") => {
                let at = r.take_token()?;
                let map = ColorMap::read(r)?;
                if let Some((_, color)) =
                    map.entries.iter().max_by(|(_, a), (_, b)| max_channel(a).total_cmp(&max_channel(b)))
                {
                    warn_if_color_in_bytes(r, at, color);
                }
                self.paint = Paint::Colors(Arc::new(map));
                r.leave_block()
            }
            Next::Block("image_map") => {
                r.take_token()?;
                self.paint = Paint::Image(Arc::new(ImageMap::read(r)?));
                self.forget_pattern();
                // A pattern named later begins with frequency 0 (quirk: uv_mapping_pigments).
                self.pattern.modifiers.frequency = Some(0.0);
                r.leave_block()
            }
            Next::Thing("color_map") => {
                if let Some(map) = r.take_declared::<ColorMap>()? {
                    self.paint = Paint::Colors(map);
                }
                Ok(())
            }
            Next::Block(word) if word == E::MAP => {
                r.take_token()?;
                let map = Map::<E>::read_entries(r, defaults, self.pattern.is_average())?;
                let entries = map.entries.into_iter().map(|(number, entry)| (number, entry.into())).collect();
                self.paint = Paint::Pigments(Blend::Map(Arc::new(Map { entries })));
                r.leave_block()
            }
            Next::Word(_) if !r.may_be_at_color()? => Err(r.unknown_word("pigment", &words_of_pigment_block()).into()),
            Next::Word(_) | Next::Value => {
                let at = r.span();
                let color = r.color()?.with_infinities_as_zero();
                warn_if_color_in_bytes(r, at, &color);
                self.paint = Paint::Solid(color);
                self.forget_pattern();
                Ok(())
            }
            _ => Err(r.unknown_word("pigment", &words_of_pigment_block()).into()),
        }
    }

    fn forget_pattern(&mut self) {
        if !matches!(self.pattern.kind, PatternKind::Plain) {
            self.pattern.kind = PatternKind::Plain;
        }
    }

    /// True if the pigment has only its pattern's default colours, or a picture, which another pattern replaces.
    fn has_default_paint(&self) -> bool {
        match (&self.pattern.kind, &self.paint) {
            (_, Paint::Image(_)) => true,
            (PatternKind::Field(field), Paint::Colors(map)) => map.entries == field.default_colors(),
            _ => false,
        }
    }

    /// Sets the default colours of a pigment whose pattern of numbers has no map.
    pub(super) fn set_default_colors(&mut self) {
        if let (PatternKind::Field(field), Paint::Solid(_)) = (&self.pattern.kind, &self.paint) {
            self.paint = Paint::Colors(Arc::new(Map { entries: field.default_colors() }));
        }
    }

    /// Returns the pigment at low quality, in which `quick_color` replaces the pigment or those nested in it; `None` if
    /// no `quick_color` is stated.
    pub fn low_quality_replacement(&self) -> Option<Pigment> {
        if let Some(color) = &self.quick_color {
            return Some(Self::solid(**color));
        }
        let Paint::Pigments(parts) = &self.paint else { return None };
        if !parts.iter().any(|part| part.low_quality_replacement().is_some()) {
            return None;
        }
        let parts = parts.map(|part| part.low_quality_replacement().unwrap_or_else(|| part.clone()));
        Some(Self { paint: Paint::Pigments(parts), ..self.clone() })
    }

    /// Returns the pigment's constant colour; `None` if a map, a picture or other pigments give the colour.
    pub fn as_solid(&self) -> Option<Color> {
        match &self.paint {
            Paint::Solid(color) => Some(*color),
            _ => None,
        }
    }

    /// True if both pigments are certainly equal, see [`Texture::is_certainly_equal`].
    pub(super) fn is_certainly_equal(&self, other: &Self) -> bool {
        let paint = match (&self.paint, &other.paint) {
            (Paint::Solid(a), Paint::Solid(b)) => a == b,
            (Paint::Colors(a), Paint::Colors(b)) => Arc::ptr_eq(a, b),
            (Paint::Image(a), Paint::Image(b)) => Arc::ptr_eq(a, b),
            (Paint::Pigments(a), Paint::Pigments(b)) => a.shares_allocation_with(b),
            _ => false,
        };
        paint && self.pattern.shares_with(&other.pattern) && self.quick_color == other.quick_color
    }

    /// True if `is` holds for any pattern of the pigment.
    pub fn any_pattern(&self, is: &dyn Fn(&Pattern) -> bool) -> bool {
        let inner = matches!(&self.paint, Paint::Pigments(parts) if parts.iter().any(|part| part.any_pattern(is)));
        is(&self.pattern) || inner
    }

    /// True if no point of the pigment transmits light.
    pub fn is_opaque(&self) -> bool {
        self.is_opaque_if(&ImageMap::is_opaque)
    }

    /// True if POV-Ray lets a surface with this pigment cast a full shadow (see [`ImageMap::is_opaque_in_blend`]).
    pub fn is_opaque_for_shadows(&self) -> bool {
        match &self.paint {
            Paint::Pigments(parts) => parts.iter().all(|part| part.is_opaque_if(&ImageMap::is_opaque_in_blend)),
            _ => self.is_opaque(),
        }
    }

    fn is_opaque_if(&self, image_is: &dyn Fn(&ImageMap) -> bool) -> bool {
        let opaque = |c: &Color| c.filter == 0.0 && c.transmit == 0.0;
        match &self.paint {
            Paint::Solid(color) => opaque(color),
            Paint::Colors(map) => map.entries.iter().all(|(_, color)| opaque(color)),
            Paint::Pigments(parts) => parts.iter().all(|part| part.is_opaque_if(image_is)),
            Paint::Image(image) => image_is(image),
        }
    }
}

/// Returns the largest of a colour's red, green and blue.
fn max_channel(color: &Color) -> f64 {
    color.rgb.max_element()
}

/// Reads `uv_mapping`, once or more, which may precede a declared pigment, normal or texture; returns `None` if it is
/// absent, else its value.
pub(super) fn read_uv_mapping(r: &mut dyn Reader) -> Result<Option<bool>> {
    let mut uv = None;
    while r.accept("uv_mapping")? {
        uv = Some(r.flag()?);
    }
    Ok(uv)
}

/// Value of a pigment's maps and lists, which becomes a pigment.
pub(super) trait PigmentEntry: Entry + From<Pigment> + Into<Pigment> {}

impl PigmentEntry for Pigment {}

impl Entry for Pigment {
    const MAP: &'static str = "pigment_map";
    const BLOCK: &'static str = "pigment";

    fn read_entry(r: &mut dyn Reader, defaults: &Texture) -> Result<Self> {
        Self::read(r, &defaults.layers[0].pigment, defaults)
    }

    /// Reads a declared pigment, or a colour, which is a pigment too; `None` if neither comes next.
    fn read_declared_or_color(r: &mut dyn Reader) -> Result<Option<Self>> {
        Ok(match r.take_declared::<Pigment>()? {
            Some(pigment) => Some((*pigment).clone()),
            None if r.may_be_at_color()? => Some(Self::solid(r.color()?)),
            None => None,
        })
    }
}
