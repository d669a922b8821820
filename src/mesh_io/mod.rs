//! Readers of mesh files: PLY, OBJ, STL, glTF. Numbers stay as the file has them: no axis is turned or mirrored.
//!
//! PLY is read by the crate `ply-rs-bw`. The other readers are durer's own; the crates were tried with 5000 mutated files each:
//!
//! - `gltf` 1.4.1 panics on an unknown primitive mode or attribute accessor (27 of 10 000 files);
//! - `tobj` 4.0.5 panics on a material whose `Kd` has one number, rejects lines continued by `\`, gives corners without surface
//!   coordinates those of the corner before, and does not report the name of a missing material;
//! - `stl_io` 0.11.0 takes four times as long for text, and rejects facets with more than three corners.

mod gltf;
mod mtl;
mod obj;
mod ply;
mod polygon;
mod stl;
mod words;

use crate::math::{DVec2, DVec3};
use crate::source::Activity;
use glam::Vec3;
use serde::Serialize;

/// Entry for a triangle in a list with three indices for each triangle: the triangle has no normals, no surface
/// coordinates or no textures.
pub const NONE: [u32; 3] = [u32::MAX; 3];

/// Maximum number of triangles of a mesh file, or its size in bytes if that is larger: a small file may refer to one
/// mesh many times.
const MANY: usize = 1 << 24;

/// Result of the reader of a mesh file; the error is the reason in words, with the line or byte where it is known.
pub type ReadResult<T> = Result<T, String>;

/// Opens a file that a mesh file names, relative to the mesh file.
pub type FileOpener<'a> = &'a mut dyn FnMut(&str) -> ReadResult<Vec<u8>>;

/// Triangles of a mesh file, whose corners, normals and surface coordinates are indices into lists.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Triangles {
    /// Vertices of the triangles in object space; single precision, as in POV-Ray (quirk: `mesh_single_precision`).
    pub vertices: Vec<Vec3>,
    /// Normals of the triangles' corners: unit vectors, or 0 without a direction.
    pub normals: Vec<Vec3>,
    /// Surface coordinates (u, v) of the triangles' corners.
    pub uvs: Vec<DVec2>,
    /// Indices of the vertices of each triangle.
    pub corners: Vec<[u32; 3]>,
    /// Indices of the normals at the corners of each triangle; empty if all are flat.
    pub smooth: Vec<[u32; 3]>,
    /// Indices of the surface coordinates at the corners of each triangle; empty if no triangle has any.
    pub mapped: Vec<[u32; 3]>,
    /// Numbers of the textures at the corners of each triangle, from 1 on; 0 is the texture of the whole mesh. Empty if
    /// no triangle has any.
    pub painted: Vec<[u32; 3]>,
}

impl Triangles {
    /// Adds a triangle to a mesh file's triangles; the optional lists begin when the first triangle has a value for
    /// them. `textures_or_0` are numbers of textures or materials, from 1 on, or 0 without one.
    pub fn push_triangle(&mut self, corners: [u32; 3], normals: [u32; 3], uvs: [u32; 3], textures_or_0: [u32; 3]) {
        let before = self.corners.len();
        let add = |list: &mut Vec<[u32; 3]>, numbers: [u32; 3], none: [u32; 3]| {
            if numbers != none || !list.is_empty() {
                list.resize(before, none);
                list.push(numbers);
            }
        };
        add(&mut self.smooth, normals, NONE);
        add(&mut self.mapped, uvs, NONE);
        add(&mut self.painted, textures_or_0, [0; 3]);
        self.corners.push(corners);
    }
}

/// Contents of a mesh file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshFile {
    /// All triangles of the mesh file; the numbers of their textures are those of the materials.
    pub triangles: Triangles,
    /// Materials of the mesh file; the first has the number 1.
    pub materials: Vec<MeshMaterial>,
    /// Parts of the mesh file that were ignored, in words.
    pub remarks: Vec<String>,
}

/// The rendered part of a material of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshMaterial {
    /// Name of the material in the mesh file.
    pub name: String,
    /// Diffuse colour of a mesh file's material.
    pub color: [f64; 3],
    /// True if the material's colour is linear light; false if it is a number as after `rgb`.
    pub is_linear: bool,
    /// Opacity of a mesh file's material, from 0 for transparent to 1.
    pub opacity: f64,
    /// Strength of the highlight of a mesh file's material.
    pub specular: f64,
    /// Exponent of the highlight of a mesh file's material.
    pub shininess: f64,
    /// File of a picture that gives a material's colour by surface coordinates.
    pub picture: Option<String>,
}

impl MeshMaterial {
    fn new(name: String) -> Self {
        Self { name, color: [0.8; 3], is_linear: false, opacity: 1.0, specular: 0.0, shininess: 40.0, picture: None }
    }
}

/// Endings of the mesh files that can be read.
pub const ENDINGS: &[&str] = &["ply", "obj", "stl", "gltf", "glb"];

/// Reads a mesh file's bytes; materials are dropped if no triangle has one. The first bytes identify PLY and binary
/// glTF; `ending`, that of the file's name, decides otherwise.
///
/// # Errors
/// The reason why the file is not understood, with the line or byte where it is known.
pub fn read_mesh_file(bytes: &[u8], ending: &str, open: FileOpener) -> ReadResult<MeshFile> {
    let _activity = Activity::begin("while a mesh file was read");
    let mut file = match (bytes, ending.to_ascii_lowercase().as_str()) {
        ([b'p', b'l', b'y', b'\r' | b'\n', ..], _) | (_, "ply") => ply::read_ply(bytes),
        ([b'g', b'l', b'T', b'F', ..], _) | (_, "gltf" | "glb") => gltf::read_gltf(bytes, open),
        (_, "stl") => stl::read_stl(bytes),
        (_, "obj") => obj::read_obj(bytes, open),
        _ => Err("it is none of ply, obj, stl, gltf and glb".into()),
    }?;
    if file.triangles.corners.is_empty() {
        return Err("it holds no triangles".into());
    }
    let used = file.triangles.painted.iter().flatten().any(|number| *number != 0);
    if !used {
        file.materials.clear();
        file.triangles.painted.clear();
    }
    Ok(file)
}

/// Returns the unit vector of a mesh file's normal, or 0 if it has no direction.
fn unit_direction(numbers: [f64; 3]) -> Vec3 {
    DVec3::from_array(numbers).normalize_or_zero().as_vec3()
}

/// Returns a point of a mesh file; an error if a coordinate is not finite.
fn finite_point(numbers: [f64; 3], place: impl FnOnce() -> String) -> ReadResult<Vec3> {
    let p = Vec3::from_array(numbers.map(|x| x as f32));
    if p.is_finite() { Ok(p) } else { Err(format!("{}: a corner's place is not a number, or beyond 1e38", place())) }
}
