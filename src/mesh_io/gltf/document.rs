//! The parts of a glTF file's JSON that durer reads, under their JSON names.

use serde::Deserialize;

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Document {
    pub extensions_required: Vec<String>,
    pub scene: usize,
    pub scenes: Vec<Scene>,
    pub nodes: Vec<Node>,
    pub meshes: Vec<Mesh>,
    pub accessors: Vec<Accessor>,
    pub buffer_views: Vec<BufferView>,
    pub buffers: Vec<Buffer>,
    pub materials: Vec<Material>,
    pub textures: Vec<Texture>,
    pub images: Vec<Image>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Scene {
    pub nodes: Vec<usize>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Node {
    pub mesh: Option<usize>,
    pub children: Vec<usize>,
    /// Matrix of a glTF node, column by column.
    pub matrix: Option<[f64; 16]>,
    pub translation: Option<[f64; 3]>,
    /// Rotation of a glTF node: a quaternion, with its real part last.
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
}

#[derive(Deserialize)]
pub struct Mesh {
    pub primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
pub struct Primitive {
    #[serde(default)]
    pub attributes: Attributes,
    pub indices: Option<usize>,
    pub material: Option<usize>,
    /// Mode of a glTF primitive: 4 for triangles, 5 for a strip, 6 for a fan; other modes have no surface.
    #[serde(default = "default_primitive_mode")]
    pub mode: u32,
}

fn default_primitive_mode() -> u32 {
    4
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Attributes {
    #[serde(rename = "POSITION")]
    pub position: Option<usize>,
    #[serde(rename = "NORMAL")]
    pub normal: Option<usize>,
    #[serde(rename = "TEXCOORD_0")]
    pub uv: Option<usize>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Accessor {
    pub buffer_view: Option<usize>,
    #[serde(default)]
    pub byte_offset: usize,
    pub component_type: u32,
    #[serde(default)]
    pub normalized: bool,
    pub count: usize,
    #[serde(rename = "type")]
    pub shape: String,
    pub sparse: Option<serde::de::IgnoredAny>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct BufferView {
    pub buffer: usize,
    #[serde(default)]
    pub byte_offset: usize,
    pub byte_length: usize,
    pub byte_stride: Option<usize>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Buffer {
    pub uri: Option<String>,
}

#[derive(Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Material {
    pub name: Option<String>,
    #[serde(rename = "pbrMetallicRoughness")]
    pub pbr: Pbr,
    pub alpha_mode: Option<String>,
}

#[derive(Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Pbr {
    /// Base colour of a glTF material, in linear light, and alpha.
    pub base_color_factor: [f64; 4],
    pub base_color_texture: Option<TextureInfo>,
}

impl Default for Pbr {
    fn default() -> Self {
        Self { base_color_factor: [1.0; 4], base_color_texture: None }
    }
}

#[derive(Deserialize)]
pub struct TextureInfo {
    pub index: usize,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Texture {
    pub source: Option<usize>,
}

#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Image {
    pub uri: Option<String>,
}
