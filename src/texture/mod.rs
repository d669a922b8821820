//! Appearance of a surface: pigment, normal, finish, layered textures.

mod blend;
mod color_map;
mod density;
mod doubts;
mod finish;
mod image_map;
mod layers;
mod normal;
mod normal_program;
mod of_file;
mod pigment;
mod pigment_program;
pub mod words;

pub use blend::{Blend, Map, Shares};
pub use color_map::ColorMap;
pub use density::{DENSITY, Density};
pub use doubts::warn_if_color_in_bytes;
pub use finish::{Finish, Irid, Reflection, Uncommon};
pub use image_map::ImageMap;
pub use layers::{Choice, Layer, Texture};
pub use normal::{Normal, Relief, Slope, SlopeMap};
pub use normal_program::NormalProgram;
pub use pigment::{Paint, Pigment};
pub use pigment_program::{Brightness, PigmentProgram};

use crate::value::Thing;

macro_rules! things {
    ($($name:ident $kind:literal)*) => { $(impl Thing for $name {
        fn kind(&self) -> &'static str { $kind }
    })* };
}

things! { Finish "finish" ColorMap "color_map" Pigment "pigment" Texture "texture"
Normal "normal" SlopeMap "slope_map" PigmentMap "pigment_map" NormalMap "normal_map" TextureMap "texture_map"
Density "density" DensityMap "density_map" }

/// Pigment map: a map from numbers to pigments.
pub type PigmentMap = Map<Pigment>;
/// Density map: a map from numbers to densities.
pub type DensityMap = Map<Density>;
/// Normal map: a map from numbers to normals.
pub type NormalMap = Map<Normal>;
/// Texture map: a map from numbers to textures.
pub type TextureMap = Map<Texture>;
