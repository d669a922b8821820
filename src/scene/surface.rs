//! Surfaces of objects: textures with their spaces, layers, materials (manual, "Texture", "Material").

use super::Defaults;
use crate::diagnostic::Result;
use crate::math::Transform;
use crate::medium::Interior;
use crate::texture::Texture;
use crate::value::{Next, Reader, ReaderExt, Thing};
use serde::Serialize;
use std::sync::{Arc, LazyLock};

/// Identity transform, shared by all textures that were set on a transformed object which was not transformed since.
static IDENTITY: LazyLock<Arc<Transform>> = LazyLock::new(Arc::default);

/// A texture on an object.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Painted {
    /// Texture, shared by all objects that use it.
    pub texture: Arc<Texture>,
    /// Transform of the object since the texture was set; `None` if it equals the object's whole transform, because the
    /// texture was set first.
    pub moved: Option<Arc<Transform>>,
}

impl Painted {
    /// Sets a texture on an object that already has the transform `block_from_object`.
    pub fn new(texture: Arc<Texture>, block_from_object: &Transform) -> Self {
        Self { texture, moved: (!block_from_object.is_identity()).then(|| IDENTITY.clone()) }
    }

    /// Appends a transform of the object, which also transforms the texture.
    pub(super) fn transform_by(&mut self, step: &Transform) {
        if let Some(moved) = &mut self.moved {
            *moved = Arc::new(moved.then(step));
        }
    }

    /// Returns the transform from the texture's space to the block around the object; `block_from_object` is the
    /// object's transform.
    pub fn block_from_texture<'t>(&'t self, block_from_object: &'t Transform) -> &'t Transform {
        self.moved.as_deref().unwrap_or(block_from_object)
    }
}

/// Reads consecutive `texture` blocks as layers, the lowest first.
///
/// # Errors
/// A diagnostic at the first item that is not understood.
pub fn read_layers(r: &mut dyn Reader, defaults: &Defaults) -> Result<Texture> {
    let mut layers = vec![];
    let mut next = r.peek_next()?;
    loop {
        match next {
            Next::Block("texture") => {
                r.take_token()?;
                let read = Texture::read(r, &defaults.texture)?.layers;
                r.leave_block()?;
                // Most textures have one block.
                if layers.is_empty() { layers = read } else { layers.extend(read) }
            }
            Next::Thing("texture") => match r.take_declared::<Texture>()? {
                Some(texture) => layers.extend(texture.layers.iter().cloned()),
                None => break,
            },
            _ => break,
        }
        next = r.peek_next_unless_separated()?;
    }
    layers.shrink_to_fit();
    let mut texture = Texture { layers };
    texture.untint_upper_layers(&r.language());
    Ok(texture)
}

/// A texture without layers.
fn texture_without_layers() -> Arc<Texture> {
    Arc::new(Texture { layers: vec![] })
}

/// Contents of a `material` block (manual, "Material").
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Material {
    /// Texture of the outside of the surface.
    pub texture: Option<Arc<Texture>>,
    /// Texture of the inside of the surface.
    pub interior_texture: Option<Arc<Texture>>,
    /// Interior of the solid.
    pub interior: Option<Arc<Interior>>,
}

impl Thing for Material {
    fn kind(&self) -> &'static str {
        "material"
    }
}

/// Reads the contents of a `material` block; `interior` is what the object has so far.
///
/// # Errors
/// A diagnostic at the first item that is not understood.
pub fn read_material(r: &mut dyn Reader, defaults: &Defaults, interior: Option<Arc<Interior>>) -> Result<Material> {
    let mut out = Material { interior, ..Material::default() };
    loop {
        match r.peek_next()? {
            Next::End => return Ok(out),
            Next::Thing("material") => {
                if let Some(declared) = r.take_declared::<Material>()? {
                    out = Material { interior: declared.interior.clone().or(out.interior), ..(*declared).clone() };
                }
            }
            Next::Block("texture") | Next::Thing("texture") => {
                let layers = read_layers(r, defaults)?.layers;
                Arc::make_mut(out.texture.get_or_insert_with(texture_without_layers)).layers.extend(layers);
            }
            Next::Block("interior_texture") => {
                r.take_token()?;
                let layers = Texture::read(r, &defaults.texture)?.layers;
                Arc::make_mut(out.interior_texture.get_or_insert_with(texture_without_layers)).layers.extend(layers);
                r.leave_block()?;
            }
            Next::Block("interior") => {
                r.take_token()?;
                out.interior = Some(Arc::new(Interior::read(r, out.interior.as_deref())?));
                r.leave_block()?;
            }
            Next::Thing("interior") => out.interior = r.take_declared::<Interior>()?,
            next if next.is_transform() => {
                if let Some(step) = r.transform()? {
                    for texture in [&mut out.texture, &mut out.interior_texture].into_iter().flatten() {
                        Arc::make_mut(texture).transform(&step);
                    }
                }
            }
            _ => {
                let words = ["texture", "interior_texture", "interior", "translate", "rotate", "scale", "transform"];
                return Err(r.unknown_word("material", &words).into());
            }
        }
    }
}
