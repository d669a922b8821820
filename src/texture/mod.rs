//! What a surface looks like: pigment, finish, texture; what is behind it: interior.

mod finish;
mod interior;
mod layers;
mod map;
mod pigment;
pub mod words;

pub use finish::{Finish, Reflection};
pub use interior::Interior;
pub use layers::{Layer, Material, Texture};
pub use map::ColorMap;
pub use pigment::{Paint, Pigment};

use crate::value::Thing;

macro_rules! things {
    ($($name:ident $kind:literal)*) => { $(impl Thing for $name {
        fn kind(&self) -> &'static str { $kind }
    })* };
}

things! { Finish "finish" Interior "interior" ColorMap "color_map" Pigment "pigment" Texture "texture" Material "material" }
