//! What the author said, after all macros and loops ran: plain data.

mod alike;
mod object;
mod pov_bounds;
mod settings;
mod surface;
mod weight;
pub mod words;

pub use alike::Alike;
pub use object::{
    Bulk, CsgOp, Flags, LIGHT_GROUP, LightSource, Object, ObjectBody, ObjectKind, Uncommon, is_object, read_camera,
};
pub use settings::Settings;
pub use surface::{Material, Painted, read_layers, read_material};
pub use weight::Weight;

use crate::atmosphere::{Background, Fog, Rainbow, SkySphere};
use crate::camera::Camera;
use crate::source::Span;
use crate::texture::Texture;
use crate::value::Unsupported;
use serde::Serialize;
use std::rc::Rc;
use std::sync::Arc;

/// Everything the text put into the scene.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Scene {
    /// The last `#version`, as 100 times the number.
    pub version: u32,
    /// `global_settings`.
    pub settings: Settings,
    /// The last camera; without one, POV-Ray's default.
    pub camera: Camera,
    /// The text of each camera, the one that counts last.
    #[serde(skip)]
    pub cameras: Vec<Span>,
    /// What rays see that hit nothing.
    pub background: Option<Background>,
    /// The sky; the last one counts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sky_sphere: Option<SkySphere>,
    /// All fogs.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fogs: Vec<Fog>,
    /// All rainbows.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub rainbows: Vec<Rainbow>,
    /// Objects and lights in the order they were written.
    pub objects: Vec<Object>,
    /// What was said and is not drawn yet.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unsupported: Vec<Unsupported>,
}

/// What `#default` has set for all that follows.
#[derive(Clone, Debug, Default)]
pub struct Defaults {
    /// Where a block says nothing else.
    pub texture: Arc<Texture>,
    /// What was read last: what is like it is one with it.
    pub alike: Rc<Alike>,
}
