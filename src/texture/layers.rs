//! `texture` and `material` (manual, "Texture", "Material").

use super::pigment::Draft;
use super::words::{FINISH, TEXTURE};
use super::{Finish, Interior, Pigment};
use crate::diagnostic::Result;
use crate::math::Transform;
use crate::value::{Next, Reader, ReaderExt};
use serde::Serialize;
use std::sync::Arc;

/// One layer: the light that a see-through one lets pass comes from the layer below.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Layer {
    /// Its colour.
    pub pigment: Pigment,
    /// Its answer to light.
    pub finish: Finish,
}

/// Layers from the lowest to the topmost.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Texture {
    /// Never empty.
    pub layers: Vec<Layer>,
}

impl Default for Texture {
    fn default() -> Self {
        Self { layers: vec![Layer::default()] }
    }
}

impl Texture {
    /// Reads what stands between the braces, on top of `base` (the default texture).
    pub fn read(r: &mut dyn Reader, base: &Texture) -> Result<Self> {
        let declared = if r.next()? == Next::Thing("texture") { r.thing::<Texture>()? } else { None };
        let mut out = declared.map_or_else(|| base.clone(), |declared| (*declared).clone());
        let bare = r.language().bare_textures;
        let mut draft: Option<Draft> = None;
        // Textures stand inside a texture only behind the pattern that chooses among them.
        let mut chooses = false;
        loop {
            match r.next()? {
                Next::End => break,
                Next::Block("texture") | Next::Thing("texture") if !chooses => {
                    return Err(r.unknown_word("texture", &TEXTURE.names()).into());
                }
                next if out.read_part(r, next, base)? => {}
                Next::Word("translate" | "rotate" | "scale" | "matrix" | "transform")
                | Next::Block("transform")
                | Next::Thing("transform") => {
                    if let Some(step) = r.transform()? {
                        out.transform(&step);
                    }
                }
                Next::Word(word) if bare && FINISH.obeys(word) => {
                    let top = out.layers.len() - 1;
                    out.layers[top].finish.read_word(word, r)?;
                }
                // A lone number was the texture's grain.
                Next::Value if bare && draft.is_none() && !chooses => drop(r.float()?),
                next @ (Next::Word(_) | Next::Value | Next::Block("color_map" | "colour_map"))
                    if bare && !matches!(next, Next::Word("tiles" | "texture_map" | "material_map" | "uv_mapping")) =>
                {
                    let top = out.layers.len() - 1;
                    draft.get_or_insert_with(|| Draft::of(&out.layers[top].pigment.paint)).read_element(r, next)?;
                }
                Next::Word(word) | Next::Block(word)
                    if TEXTURE.leaves_out(word)
                        || crate::pattern::NOT_DRAWN.contains(&word)
                        || crate::pattern::WORDS_NOT_DRAWN.contains(&word) =>
                {
                    r.skip_unsupported(word)?;
                    chooses = true;
                }
                _ => return Err(r.unknown_word("texture", &TEXTURE.names()).into()),
            }
        }
        if let (Some(draft), Some(layer)) = (draft, out.layers.last_mut()) {
            layer.pigment.paint = draft.finish();
        }
        Ok(out)
    }

    /// Reads a `pigment`, `normal` or `finish`, in braces or declared; false if something else comes next.
    pub fn read_part(&mut self, r: &mut dyn Reader, next: Next, base: &Texture) -> Result<bool> {
        let top = self.layers.len() - 1;
        let layer = &mut self.layers[top];
        match next {
            Next::Block("pigment") => {
                r.take()?;
                layer.pigment = Pigment::read(r, &base.layers[0].pigment)?;
                r.leave()?;
            }
            Next::Block("finish") => {
                r.take()?;
                layer.finish = Finish::read(r, &layer.finish)?;
                r.leave()?;
            }
            Next::Block("normal") => r.skip_unsupported("normal")?,
            Next::Thing("normal") => drop(r.take_thing()?),
            Next::Thing("pigment") => match r.thing::<Pigment>()? {
                Some(pigment) => layer.pigment = (*pigment).clone(),
                None => return Ok(false),
            },
            Next::Thing("finish") => match r.thing::<Finish>()? {
                Some(finish) => layer.finish = (*finish).clone(),
                None => return Ok(false),
            },
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Moves every layer.
    pub fn transform(&mut self, by: &Transform) {
        for layer in &mut self.layers {
            layer.pigment.transform = layer.pigment.transform.then(by);
        }
    }
}

/// A texture and what is inside it.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Material {
    /// The outside.
    pub texture: Option<Arc<Texture>>,
    /// Seen from inside.
    pub interior_texture: Option<Arc<Texture>>,
    /// What fills it.
    pub interior: Option<Arc<Interior>>,
}
