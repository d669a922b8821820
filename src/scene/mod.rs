//! The scene as plain data, after all macros and loops have run.

mod light_file;
mod object;
mod photon_map;
mod pov_bounds;
mod prepared_light;
mod radiosity;
mod recent_parts;
mod saved_light;
mod settings;
mod subsurface;
mod surface;
mod weight;
pub mod words;

pub use light_file::{
    Digest, LightFile, LightFileError, LightHeader, LightKind, LightWriter, decode_numbers, is_light_file_or_empty,
};
pub use object::{
    Bulk, CsgOp, Flags, LIGHT_GROUP, LightSource, OBJECT_RADIOSITY, Object, ObjectBody, ObjectKind, ObjectRadiosity,
    PHOTONS, PhotonSettings, Uncommon, is_object, read_camera,
};
pub use photon_map::{PHOTON_MAP, PhotonMapSettings};
pub use prepared_light::PreparedLight;
pub use radiosity::{RADIOSITY, Radiosity};
pub use recent_parts::RecentParts;
pub use saved_light::{LoadedLight, SaveFile, SavedLight};
pub use settings::Settings;
pub use subsurface::{SUBSURFACE, SubsurfaceSettings};
pub use surface::{Material, Painted, read_layers, read_material};
pub use weight::Weight;

use crate::atmosphere::{Background, Fog, Rainbow, SkySphere};
use crate::camera::Camera;
use crate::medium::Media;
use crate::source::Span;
use crate::texture::Texture;
use serde::Serialize;
use std::rc::Rc;
use std::sync::Arc;

/// Contents of the scene.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Scene {
    /// Language version in force at the end of the text, times 100: that of the last `#version` or of `--language`, or
    /// 370.
    pub version: u32,
    /// Values of `global_settings`.
    pub settings: Settings,
    /// The last camera of the text, that of `#default` included; POV-Ray's default camera if the scene has none.
    pub camera: Camera,
    /// Spans of all cameras in the text; the last camera is used.
    #[serde(skip)]
    pub cameras: Vec<Span>,
    /// Colour of rays without a hit.
    pub background: Option<Background>,
    /// Sky sphere; the last one of the scene is used.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sky_sphere: Option<SkySphere>,
    /// Fogs of the scene.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fogs: Vec<Fog>,
    /// Rainbows of the scene.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub rainbows: Vec<Rainbow>,
    /// Media of the whole scene.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub media: Vec<Media>,
    /// Objects and lights in the order of the text.
    pub objects: Vec<Object>,
}

/// Defaults set by `#default` for the text that follows.
#[derive(Clone, Debug, Default)]
pub struct Defaults {
    /// Texture of objects that state none.
    pub texture: Arc<Texture>,
    /// `radiosity` block of objects that have none; `None` without a default.
    pub radiosity: Option<ObjectRadiosity>,
    /// Camera whose properties a `camera` block starts from.
    pub camera: Arc<Camera>,
    /// Recently read parts of objects, for deduplication.
    pub recent: Rc<RecentParts>,
}
