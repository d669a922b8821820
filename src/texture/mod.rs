//! What a surface looks like: pigment, finish, texture; what is behind it: interior.

mod finish;
mod interior;
mod map;
mod pigment;
#[allow(clippy::module_inception)]
mod texture;

pub use finish::{Finish, Reflection};
pub use interior::Interior;
pub use map::ColorMap;
pub use pigment::{Paint, Pigment};
pub use texture::{Layer, Material, Texture};

use crate::value::Thing;

macro_rules! things {
    ($($name:ident $kind:literal)*) => { $(impl Thing for $name {
        fn kind(&self) -> &'static str { $kind }
    })* };
}

things! { Finish "finish" Interior "interior" ColorMap "color_map" Pigment "pigment" Texture "texture" Material "material" }
