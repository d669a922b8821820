//! Textures from the materials of mesh files.

use super::{ImageMap, Paint, Pigment, Texture};
use crate::color::{Color, Rgb};
use crate::image_io::Picture;
use crate::mesh_io::MeshMaterial;
use crate::pattern::bitmap::{Bitmap, Mapping, PixelInterpolation};
use crate::value::Reader;
use std::sync::Arc;

impl Texture {
    /// Creates the texture of a mesh file's material: the default texture with the material's colour or picture, and
    /// its highlight.
    pub fn from_mesh_material(
        material: &MeshMaterial,
        picture: Option<&Arc<Picture>>,
        r: &dyn Reader,
        defaults: &Texture,
    ) -> Self {
        let mut layer = defaults.layers[0].clone();
        let transmit = 1.0 - material.opacity;
        layer.pigment = match picture {
            Some(picture) => {
                let mapping = Mapping { between: PixelInterpolation::Bilinear, ..Mapping::default() };
                let bitmap = Bitmap { picture: picture.clone(), gamma: None, premultiplied: false, mapping };
                let mut image = ImageMap { texels: bitmap.color_texels(r), mapping, clearness: Default::default() };
                image.clearness.transmit = (transmit > 0.0).then_some(transmit);
                Pigment::mapped_by_uv(Paint::Image(Arc::new(image)))
            }
            None => {
                let language = r.language();
                let scene = language.assumed_gamma.unwrap_or(language.other_gamma);
                let number = |x: f64| if material.is_linear { scene.encode(x) } else { x };
                Pigment::solid(Color { rgb: Rgb::from_array(material.color.map(number)), filter: 0.0, transmit })
            }
        };
        if material.specular > 0.0 {
            let finish = Arc::make_mut(&mut layer.finish);
            (finish.phong, finish.phong_size) = (material.specular, material.shininess);
        }
        Self { layers: vec![layer] }
    }
}
