//! Textures embedded in a shape, such as those of a mesh's triangles.

use crate::diagnostic::Result;
use crate::image_io::Picture;
use crate::math::Transform;
use crate::mesh_io::MeshMaterial;
use crate::scene::{Defaults, Painted, read_layers};
use crate::shape::Paints;
use crate::texture::Texture;
use crate::value::{Next, Reader, ReaderExt};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Textures embedded in a shape that is being read; equal textures share a number.
pub(super) struct EmbeddedTextures<'a> {
    defaults: &'a Defaults,
    textures: Vec<Arc<Texture>>,
    /// Numbers of the embedded textures, by the address of the texture.
    numbers: FxHashMap<*const Texture, u32>,
}

impl<'a> EmbeddedTextures<'a> {
    pub fn new(defaults: &'a Defaults) -> Self {
        Self { defaults, textures: vec![], numbers: FxHashMap::default() }
    }

    /// Returns the embedded textures for the object; `None` if the shape has none.
    pub fn painted(self) -> Option<Arc<[Painted]>> {
        let painted = |texture| Painted::new(texture, &Transform::IDENTITY);
        (!self.textures.is_empty()).then(|| self.textures.into_iter().map(painted).collect())
    }

    fn add_texture(&mut self, texture: Texture) -> u32 {
        let mut texture = Arc::new(texture);
        self.defaults.recent.deduplicate(&mut texture);
        *self.numbers.entry(Arc::as_ptr(&texture)).or_insert_with(|| {
            self.textures.push(texture);
            self.textures.len() as u32
        })
    }

    /// Returns a copy of the embedded texture with this number, from 1 on; of the default texture for 0.
    fn texture_or_default(&self, number_or_0: u32) -> Texture {
        (*number_or_0.checked_sub(1).map_or(&self.defaults.texture, |i| &self.textures[i as usize])).as_ref().clone()
    }
}

impl Paints for EmbeddedTextures<'_> {
    fn read_embedded_texture(&mut self, number_or_0: &mut u32, next: Next, r: &mut dyn Reader) -> Result<bool> {
        let texture = match next {
            Next::Block("texture") | Next::Thing("texture") => read_layers(r, self.defaults)?,
            _ => {
                let mut texture = self.texture_or_default(*number_or_0);
                if !texture.read_part(r, next, &self.defaults.texture)? {
                    return Ok(false);
                }
                texture
            }
        };
        *number_or_0 = self.add_texture(texture);
        Ok(true)
    }

    fn read_listed_texture(&mut self, next: Next, r: &mut dyn Reader) -> Result<Option<u32>> {
        let texture = match next {
            Next::Block("texture") => {
                r.take_token()?;
                let texture = Texture::read(r, &self.defaults.texture)?;
                r.leave_block()?;
                texture
            }
            Next::Thing("texture") => match r.take_declared::<Texture>()? {
                Some(texture) => (*texture).clone(),
                None => return Ok(None),
            },
            _ => return Ok(None),
        };
        Ok(Some(self.add_texture(texture)))
    }

    fn add_mesh_material(
        &mut self,
        material: &MeshMaterial,
        picture: Option<&Arc<Picture>>,
        r: &mut dyn Reader,
    ) -> Result<u32> {
        Ok(self.add_texture(Texture::from_mesh_material(material, picture, r, &self.defaults.texture)))
    }

    fn transform(&mut self, number_or_0: &mut u32, by: &Transform) {
        if *number_or_0 != 0 {
            let mut texture = self.texture_or_default(*number_or_0);
            texture.transform(by);
            *number_or_0 = self.add_texture(texture);
        }
    }
}
