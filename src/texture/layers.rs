//! `texture` and `material` (manual, "Texture", "Material").

use super::blend::{self, Blend, Entry, Map};
use super::pigment::read_uv_mapping;
use super::words::{FINISH, TEXTURE};
use super::{Finish, Normal, Pigment};
use crate::diagnostic::Result;
use crate::math::Transform;
use crate::pattern::{CellPattern, MaterialMap, Pattern, PatternKind};
use crate::value::{Language, Next, Readable, Reader, ReaderExt};
use serde::Serialize;
use std::sync::Arc;

/// Layer of a texture; a transparent one shows the layer below.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Layer {
    /// Colour of the texture's layer.
    pub pigment: Pigment,
    /// Bumps of the texture's layer; `None` without bumps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal: Option<Arc<Normal>>,
    /// Reflection and emission of light by the texture's layer.
    pub finish: Arc<Finish>,
    /// Patterned textures of the layer, which replace its pigment, normal and finish.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub choice: Option<Box<Choice>>,
}

/// A pattern and the textures that it chooses from (manual, "Patterned Textures").
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Choice {
    /// Pattern that chooses the texture at each point.
    pub pattern: Pattern,
    /// Textures from which the pattern chooses.
    pub parts: Blend<Texture>,
}

impl Choice {
    /// True if a `material_map` selects the texture.
    pub fn is_material_map(&self) -> bool {
        matches!(self.pattern.kind, PatternKind::Cells(CellPattern::MaterialMap(_)))
    }
}

impl Layer {
    /// Appends a transform to those of the texture's layer.
    fn transform(&mut self, by: &Transform) {
        self.pigment.pattern.transform(by);
        if let Some(normal) = &mut self.normal {
            Arc::make_mut(normal).pattern.transform(by);
        }
        if let Some(choice) = &mut self.choice {
            choice.pattern.transform(by);
        }
    }
}

/// Texture of a surface: layers from the lowest to the topmost.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Texture {
    /// Layers of the texture from the lowest to the topmost; never empty.
    pub layers: Vec<Layer>,
}

impl Default for Texture {
    fn default() -> Self {
        Self { layers: vec![Layer::default()] }
    }
}

/// State of the reader of a texture.
#[derive(Default)]
struct Draft {
    /// Pattern that selects from several textures.
    pattern: Pattern,
    parts: Option<Blend<Texture>>,
    /// True if `uv_mapping` precedes the texture's part that it is for.
    uv: bool,
}

impl Texture {
    /// Reads the items of a `texture` block, on top of `base` (the default texture).
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(r: &mut dyn Reader, base: &Texture) -> Result<Self> {
        let mut draft = Draft { uv: read_uv_mapping(r)?.unwrap_or(false), ..Draft::default() };
        let declared = if r.peek_next()? == Next::Thing("texture") { r.take_declared::<Texture>()? } else { None };
        let mut out = declared.map_or_else(|| base.clone(), |declared| (*declared).clone());
        loop {
            match r.peek_next()? {
                Next::End => break,
                next => out.read_element(r, next, &mut draft, base)?,
            }
        }
        let top = out.top_layer();
        top.pigment.set_default_colors();
        if let Some(parts) = draft.parts {
            top.choice = Some(Box::new(Choice { pattern: draft.pattern, parts }));
        }
        if draft.uv {
            out.use_uv();
        }
        Ok(out)
    }

    fn read_element(&mut self, r: &mut dyn Reader, next: Next, draft: &mut Draft, base: &Texture) -> Result<()> {
        let bare = r.language().bare_textures;
        match next {
            next if next.is_transform() => {
                if let Some(step) = r.transform()? {
                    self.transform(&step);
                    draft.pattern.transform(&step);
                }
            }
            Next::Word("uv_mapping") => {
                r.take_token()?;
                draft.uv = r.flag()?;
            }
            Next::Word("no_bump_scale") => {
                r.take_token()?;
                let on = r.flag()?;
                for layer in &mut self.layers {
                    if let Some(normal) = &mut layer.normal {
                        Arc::make_mut(normal).bump_scale = !on;
                    }
                }
            }
            Next::Block("texture_map") => {
                r.take_token()?;
                draft.parts = Some(Blend::Map(Arc::new(Map::read_entries(r, base, draft.pattern.is_average())?)));
                r.leave_block()?;
            }
            Next::Block("tiles") => {
                r.take_token()?;
                draft.parts = Some(read_tiles(r, &mut draft.pattern, base)?);
                r.leave_block()?;
            }
            Next::Word(word) if bare && (FINISH.has_effect(word) || FINISH.ignores(word)) => {
                Arc::make_mut(&mut self.top_layer().finish).read_word(next, r)?;
            }
            // A lone number was the texture's grain.
            Next::Value if bare => drop(r.float()?),
            next if self.read_part(r, next, base)? => {}
            // Before version 3.0, a texture could contain the pigment's words.
            Next::Word(_) | Next::Value | Next::Block("color_map" | "colour_map") if bare => {
                self.top_layer().pigment.read_element::<Pigment>(r, next, base)?;
            }
            Next::Block("material_map") => {
                r.take_token()?;
                draft.parts = Some(read_material_map(r, &mut draft.pattern, base)?);
                r.leave_block()?;
            }
            next if draft.pattern.read_element(next, r)? => {
                if let Some(list) = blend::read_list(r, next, &draft.pattern, base, &|_, _| base.clone())? {
                    draft.parts = Some(list);
                }
            }
            _ => return Err(r.unknown_word_in(&TEXTURE)),
        }
        Ok(())
    }

    fn top_layer(&mut self) -> &mut Layer {
        let top = self.layers.len() - 1;
        &mut self.layers[top]
    }

    /// Reads a `pigment`, `normal` or `finish` of a texture, in braces or declared; returns false if something else
    /// comes next.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read_part(&mut self, r: &mut dyn Reader, next: Next, base: &Texture) -> Result<bool> {
        let layer = self.top_layer();
        match next {
            Next::Block("pigment") => {
                r.take_token()?;
                layer.pigment = Pigment::read(r, &layer.pigment, base)?;
                r.leave_block()?;
            }
            Next::Block("finish") => {
                r.take_token()?;
                layer.finish = Arc::new(Finish::read(r, &layer.finish)?);
                r.leave_block()?;
            }
            Next::Block("normal") => {
                r.take_token()?;
                layer.normal = Some(Arc::new(Normal::read(r, layer.normal.as_deref(), base)?));
                r.leave_block()?;
            }
            Next::Thing("normal") => match r.take_declared::<Normal>()? {
                Some(normal) => layer.normal = Some(normal),
                None => return Ok(false),
            },
            Next::Thing("pigment") => match r.take_declared::<Pigment>()? {
                Some(pigment) => layer.pigment = (*pigment).clone(),
                None => return Ok(false),
            },
            Next::Thing("finish") => match r.take_declared::<Finish>()? {
                Some(finish) => layer.finish = finish,
                None => return Ok(false),
            },
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// True if both textures are certainly equal. Parts that take long to compare, such as pictures, must be the same
    /// allocation.
    pub fn is_certainly_equal(&self, other: &Self) -> bool {
        let same = |a: &Layer, b: &Layer| {
            let normal = match (&a.normal, &b.normal) {
                (Some(a), Some(b)) => Arc::ptr_eq(a, b),
                (a, b) => a.is_none() && b.is_none(),
            };
            let choice = match (&a.choice, &b.choice) {
                (Some(a), Some(b)) => a.parts.shares_allocation_with(&b.parts) && a.pattern == b.pattern,
                (a, b) => a.is_none() && b.is_none(),
            };
            normal && choice && Arc::ptr_eq(&a.finish, &b.finish) && a.pigment.is_certainly_equal(&b.pigment)
        };
        self.layers.len() == other.layers.len() && self.layers.iter().zip(&other.layers).all(|(a, b)| same(a, b))
    }

    /// True if `is` holds for any layer of the texture, including those of patterned textures.
    pub fn any_layer(&self, is: &dyn Fn(&Layer) -> bool) -> bool {
        let inner = |choice: &Choice| choice.parts.iter().any(|part| part.any_layer(is));
        self.layers.iter().any(|layer| is(layer) || layer.choice.as_deref().is_some_and(inner))
    }

    /// True if `is` holds for any pattern of the texture.
    pub fn any_pattern(&self, is: &dyn Fn(&Pattern) -> bool) -> bool {
        self.any_layer(&|layer| {
            layer.pigment.any_pattern(is)
                || layer.normal.as_ref().is_some_and(|normal| normal.any_pattern(is))
                || layer.choice.as_ref().is_some_and(|choice| is(&choice.pattern))
        })
    }

    /// Transforms every layer of the texture.
    pub fn transform(&mut self, by: &Transform) {
        for layer in &mut self.layers {
            layer.transform(by);
        }
    }

    /// Makes the filters of all layers but the lowest transmit light untinted, where the language version asks for it.
    pub fn untint_upper_layers(&mut self, language: &Language) {
        if language.untinted_layers {
            self.layers.iter_mut().skip(1).for_each(|layer| layer.pigment.pattern.untinted = true);
        }
    }

    /// Makes every layer of the texture receive (u, v, 0) instead of points.
    pub fn use_uv(&mut self) {
        for layer in &mut self.layers {
            layer.pigment.pattern.framed = !layer.pigment.pattern.uv;
            map_by_uv(&mut layer.pigment.pattern);
            if let Some(normal) = &mut layer.normal {
                let normal = Arc::make_mut(normal);
                map_by_uv(&mut normal.pattern);
                normal.framed = true;
            }
            if let Some(choice) = &mut layer.choice {
                map_by_uv(&mut choice.pattern);
            }
        }
    }
}

fn map_by_uv(pattern: &mut Pattern) {
    pattern.uv = true;
    pattern.separate_uv_space();
}

/// Reads `tiles { texture A tile2 texture B }`, a checker of textures in old scenes.
fn read_tiles(r: &mut dyn Reader, pattern: &mut Pattern, base: &Texture) -> Result<Blend<Texture>> {
    let mut list = vec![];
    loop {
        match r.peek_next()? {
            Next::End => break,
            Next::Word("tile2") => drop(r.take_token()?),
            Next::Block("texture") => {
                r.take_token()?;
                list.push(Texture::read(r, base)?);
                r.leave_block()?;
            }
            _ => match r.take_declared::<Texture>()? {
                Some(texture) => list.push((*texture).clone()),
                None => return Err(r.unknown_word("tiles", &["texture", "tile2"]).into()),
            },
        }
    }
    list.resize(2, base.clone());
    // The second texture is at the origin (quirk: tiles_order).
    list.swap(0, 1);
    pattern.kind = PatternKind::Cells(CellPattern::Checker(crate::pattern::Checker {}));
    Ok(Blend::List(list.into()))
}

/// Reads the block `material_map { "file" … texture … texture … }`.
fn read_material_map(r: &mut dyn Reader, pattern: &mut Pattern, base: &Texture) -> Result<Blend<Texture>> {
    let mut map = MaterialMap::read(r)?;
    let mut list = vec![];
    loop {
        match r.peek_next()? {
            Next::Block("texture") => {
                r.take_token()?;
                list.push(Texture::read(r, base)?);
                r.leave_block()?;
            }
            Next::Thing("texture") => list.extend(r.take_declared::<Texture>()?.map(|texture| (*texture).clone())),
            Next::End if !list.is_empty() => break,
            _ => return Err(r.unexpected("`texture`").into()),
        }
    }
    map.count = list.len();
    pattern.kind = PatternKind::Cells(CellPattern::MaterialMap(map));
    Ok(Blend::List(list.into()))
}

impl Entry for Texture {
    const MAP: &'static str = "texture_map";
    const BLOCK: &'static str = "texture";

    /// Reads one layer of a texture without braces, or several with them.
    fn read_entry(r: &mut dyn Reader, base: &Texture) -> Result<Self> {
        let mut out: Option<Texture> = None;
        while r.peek_next()? == Next::Block("texture") {
            r.take_token()?;
            let layer = Texture::read(r, base)?;
            r.leave_block()?;
            match &mut out {
                Some(out) => out.layers.extend(layer.layers),
                None => out = Some(layer),
            }
        }
        match out {
            Some(out) => Ok(out),
            None => Texture::read(r, base),
        }
    }

    fn read_declared_or_color(r: &mut dyn Reader) -> Result<Option<Self>> {
        Ok(r.take_declared::<Texture>()?.map(|texture| (*texture).clone()))
    }
}
