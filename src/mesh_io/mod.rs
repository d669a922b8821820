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
use glam::Vec3;
use serde::Serialize;

/// In a list of three numbers: this triangle has none.
pub const NONE: [u32; 3] = [u32::MAX; 3];

/// No file gives more triangles than this, or than it has bytes, if those are more: a small one may name one mesh many times.
const MANY: usize = 1 << 24;

/// What a reader gives: else why the file is not understood, in words, with the line or byte.
pub type Reading<T> = Result<T, String>;

/// Opens a file that the mesh's file names, beside it.
pub type Open<'a> = &'a mut dyn FnMut(&str) -> Reading<Vec<u8>>;

/// Triangles whose corners, normals and surface coordinates are numbers into lists.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Triangles {
    /// In object space. (POV-Ray 3.7 keeps no more digits of the corners of a mesh: measured.)
    pub vertices: Vec<Vec3>,
    /// Length 1, or 0 where there is none.
    pub normals: Vec<Vec3>,
    /// Surface coordinates.
    pub uvs: Vec<DVec2>,
    /// Numbers of the corners of each triangle.
    pub corners: Vec<[u32; 3]>,
    /// Numbers of the normals at the corners, of each triangle; empty if all are flat.
    pub smooth: Vec<[u32; 3]>,
    /// Numbers of the surface coordinates at the corners, of each triangle; empty if no triangle has any.
    pub mapped: Vec<[u32; 3]>,
    /// Numbers of the textures at the corners, from 1 on, of each triangle; 0 is that of the whole. Empty if no triangle has any.
    pub painted: Vec<[u32; 3]>,
}

impl Triangles {
    /// Adds a triangle; the lists that most meshes do not have begin where the first triangle has something for them.
    pub fn push(&mut self, corners: [u32; 3], normals: [u32; 3], uvs: [u32; 3], slots: [u32; 3]) {
        let before = self.corners.len();
        let add = |list: &mut Vec<[u32; 3]>, numbers: [u32; 3], none: [u32; 3]| {
            if numbers != none || !list.is_empty() {
                list.resize(before, none);
                list.push(numbers);
            }
        };
        add(&mut self.smooth, normals, NONE);
        add(&mut self.mapped, uvs, NONE);
        add(&mut self.painted, slots, [0; 3]);
        self.corners.push(corners);
    }
}

/// What a file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshFile {
    /// All its triangles; their textures are the looks.
    pub triangles: Triangles,
    /// Its materials; number 1 is the first.
    pub looks: Vec<Look>,
    /// What was left out, in words.
    pub remarks: Vec<String>,
}

/// A material of a file, as far as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Its name in the file.
    pub name: String,
    /// Its colour.
    pub color: [f64; 3],
    /// Is the colour linear light? Else it is what the scene would write behind `rgb`.
    pub is_linear: bool,
    /// 1 lets no light pass.
    pub opacity: f64,
    /// Strength of the highlight.
    pub specular: f64,
    /// The highlight's exponent.
    pub shininess: f64,
    /// The file of a picture that gives the colour by surface coordinates.
    pub picture: Option<String>,
}

impl Look {
    fn new(name: String) -> Self {
        Self { name, color: [0.8; 3], is_linear: false, opacity: 1.0, specular: 0.0, shininess: 40.0, picture: None }
    }
}

/// The endings of the files that are read.
pub const ENDINGS: &[&str] = &["ply", "obj", "stl", "gltf", "glb"];

/// Reads a file's bytes; `ending` is that of its name, which counts where the bytes do not tell.
///
/// # Errors
/// Why it is not understood, with the line or byte.
pub fn read(bytes: &[u8], ending: &str, open: Open) -> Reading<MeshFile> {
    let mut file = match (bytes, ending.to_ascii_lowercase().as_str()) {
        ([b'p', b'l', b'y', b'\r' | b'\n', ..], _) | (_, "ply") => ply::read(bytes),
        ([b'g', b'l', b'T', b'F', ..], _) | (_, "gltf" | "glb") => gltf::read(bytes, open),
        (_, "stl") => stl::read(bytes),
        (_, "obj") => obj::read(bytes, open),
        _ => Err("it is none of ply, obj, stl, gltf and glb".into()),
    }?;
    if file.triangles.corners.is_empty() {
        return Err("it holds no triangles".into());
    }
    let used = file.triangles.painted.iter().flatten().any(|slot| *slot != 0);
    if !used {
        file.looks.clear();
        file.triangles.painted.clear();
    }
    Ok(file)
}

/// A direction, made 1 long.
fn direction(numbers: [f64; 3]) -> Vec3 {
    DVec3::from_array(numbers).normalize_or_zero().as_vec3()
}

/// A point, unless one of its numbers is none.
fn point(numbers: [f64; 3], place: impl FnOnce() -> String) -> Reading<Vec3> {
    let p = Vec3::from_array(numbers.map(|x| x as f32));
    if p.is_finite() { Ok(p) } else { Err(format!("{}: a corner's place is not a number, or beyond 1e38", place())) }
}
