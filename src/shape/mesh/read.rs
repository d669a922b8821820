//! Notation of meshes (manual, "Mesh", "Mesh2").
//!
//! ```pov
//! mesh { triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> } triangle { <1, 0, 0>, <1, 1, 0>, <0, 1, 0> } pigment { color rgb 1 } }
//! mesh2 {
//!   vertex_vectors { 4, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 1, 0> }
//!   face_indices { 2, <0, 1, 2>, <0, 2, 3> }
//!   pigment { color rgb 1 }
//! }
//! ```

use super::file::{FILE, FileMesh};
use super::hierarchy::TriangleHierarchy;
use super::{TriangleMesh, mesh_kernel};
use crate::diagnostic::{Diagnostic, Fault, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use crate::mesh_io::{NONE, Triangles};
use crate::shape::{Hit, Hits, Paints, TextureWeights, Triangle};
use crate::source::Span;
use crate::value::words::{Row, word};
use crate::value::{Next, Readable, Reader, Spec, Value, ValueKind, WordSpec};
use glam::Vec3;
use rustc_hash::FxHashMap;
use serde::Serialize;
use std::sync::Arc;

/// Maximum number of a list's elements for which memory is reserved before they are read.
const BELIEVED: usize = 1 << 16;

const INSIDE_VECTOR: WordSpec = word(
    "inside_vector",
    ValueKind::Vector,
    "",
    "a direction in which no line only touches it; then a closed mesh has an inside",
);

/// Shape `mesh`, whose triangles are written one by one.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Mesh(pub TriangleMesh, #[serde(skip)] Draft);

/// Triangles of a `mesh` that are read so far.
#[derive(Clone, Debug, Default, PartialEq)]
struct Draft {
    triangles: Triangles,
    /// File of a `mesh` with the word `file`, which excludes triangles; `None` for a mesh of triangles.
    file: Option<Arc<FileMesh>>,
    known: Known,
}

/// Indices of a mesh's known vertices and normals, by the bits of their coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
struct Known {
    vertices: FxHashMap<[u32; 3], u32>,
    normals: FxHashMap<[u32; 3], u32>,
}

/// Shape `mesh2`, whose triangles are written as indices into lists.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Mesh2(pub TriangleMesh, #[serde(skip)] Lists);

/// Lists of a `mesh2` that are read so far.
#[derive(Clone, Debug, Default, PartialEq)]
struct Lists {
    triangles: Triangles,
    /// The object's numbers of the textures in the `texture_list` of a `mesh2`.
    textures: Vec<u32>,
    /// Span of the `face_indices` of a `mesh2`, which are checked at the end; `None` before the list is read.
    faces: Option<Span>,
    /// Span of the `normal_indices`; `None` before the list is read.
    normals: Option<Span>,
    /// Span of the `uv_indices`; `None` before the list is read.
    uvs: Option<Span>,
}

mesh_kernel!(Mesh);
mesh_kernel!(Mesh2);

impl Readable for Mesh {
    const SPEC: Spec = Spec {
        name: "mesh",
        summary: "triangles that are one object",
        words: &[
            word(
                "triangle",
                ValueKind::Block,
                "",
                "three corners; `uv_vectors` and a `texture` or `texture_list` of its own may follow",
            ),
            word("smooth_triangle", ValueKind::Block, "", "three times a corner and the normal there"),
            FILE,
            INSIDE_VECTOR,
        ],
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[INSIDE_VECTOR.sets(|mesh, r| mesh.0.read_inside_vector(r))];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self::default())
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        let Draft { triangles, file, .. } = std::mem::take(&mut self.1);
        self.0.triangles = match file {
            Some(file) => file.triangles.clone(),
            None => Arc::new(TriangleHierarchy::new(triangles)),
        };
        self.0.warn_if_empty("mesh", span, r);
        Ok(())
    }
}

impl Draft {
    fn check_has_no_geometry(&self, file: Span) -> Result<()> {
        if self.triangles.corners.is_empty() && self.file.is_none() {
            return Ok(());
        }
        Err(file_and_triangles_error(file))
    }

    fn check_has_no_file(&self, triangle: Span) -> Result<()> {
        if self.file.is_none() { Ok(()) } else { Err(file_and_triangles_error(triangle)) }
    }
}

fn file_and_triangles_error(span: Span) -> Fault {
    let d = Diagnostic::new(codes::TWO_FORMS, span, "a `mesh` has one `file`, or triangles, not both");
    Box::new(d.help("write two meshes, in a `union { … }`"))
}

impl Mesh {
    /// Creates a mesh of existing triangles.
    pub fn from_triangles(triangles: Triangles) -> Self {
        let triangles = Arc::new(TriangleHierarchy::new(triangles));
        Self(TriangleMesh { triangles, ..TriangleMesh::default() }, Draft::default())
    }

    /// Reads a triangle or the `file` of a `mesh`, if it is next; returns false otherwise.
    fn read_geometry(&mut self, next: Next, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<bool> {
        match next {
            Next::Word("file") => {
                let at = r.take_token()?;
                self.1.check_has_no_geometry(at)?;
                let file = FileMesh::read(r)?;
                self.0.texture_numbers = file.add_material_textures(paints, r)?;
                self.1.file = Some(file);
                Ok(true)
            }
            Next::Block(kind @ ("triangle" | "smooth_triangle")) => {
                let span = r.take_token()?;
                self.1.check_has_no_file(span)?;
                self.read_triangle(kind == "smooth_triangle", span, r, paints)?;
                r.leave_block()?;
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    fn read_triangle(&mut self, smooth: bool, span: Span, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<()> {
        let (mut corners, mut normals, mut uvs, mut texture_numbers) = (NONE, NONE, NONE, [0; 3]);
        let mut points = [DVec3::ZERO; 3];
        let Draft { triangles, known, .. } = &mut self.1;
        for i in 0..3 {
            points[i] = r.vector()?;
            corners[i] = find_or_add_point(&mut known.vertices, &mut triangles.vertices, points[i]);
            if smooth {
                let normal = r.vector()?.normalize_or_zero();
                normals[i] = find_or_add_point(&mut known.normals, &mut triangles.normals, normal);
            }
        }
        loop {
            let next = r.peek_next()?;
            match next {
                Next::End => break,
                Next::Word("uv_vectors") => {
                    r.take_token()?;
                    for uv in &mut uvs {
                        *uv = triangles.uvs.len() as u32;
                        triangles.uvs.push(r.vector2()?);
                    }
                }
                Next::Block("texture_list") => {
                    r.take_token()?;
                    for number in &mut texture_numbers {
                        let next = r.peek_next()?;
                        *number = match paints.read_listed_texture(next, r)? {
                            Some(number) => number,
                            None => return Err(r.unexpected("a texture for each of the three corners").into()),
                        };
                    }
                    r.leave_block()?;
                    texture_numbers = mark_textures_per_corner(texture_numbers);
                }
                Next::Block("texture") | Next::Thing("texture") => {
                    let mut number = 0;
                    paints.read_embedded_texture(&mut number, next, r)?;
                    texture_numbers = [number; 3];
                }
                _ => return Err(r.unknown_word("triangle", &["uv_vectors", "texture", "texture_list"]).into()),
            }
        }
        let [a, b, c] = points;
        if Triangle::new(a, b, c).is_degenerate() {
            r.report(Diagnostic::new(codes::FLAT_TRIANGLE, span, "this `triangle` has no area and is left out"));
        }
        triangles.push_triangle(corners, normals, uvs, texture_numbers);
        Ok(())
    }
}

/// Returns the index of a point in a mesh's list; appends the point if it is new.
fn find_or_add_point(known: &mut FxHashMap<[u32; 3], u32>, list: &mut Vec<Vec3>, p: DVec3) -> u32 {
    let p = p.as_vec3();
    *known.entry(p.to_array().map(f32::to_bits)).or_insert_with(|| {
        list.push(p);
        list.len() as u32 - 1
    })
}

impl Readable for Mesh2 {
    const SPEC: Spec = Spec {
        name: "mesh2",
        summary: "triangles that are one object, written as lists",
        words: &[
            word("vertex_vectors", ValueKind::Block, "", "how many, and the corners"),
            word(
                "normal_vectors",
                ValueKind::Block,
                "",
                "how many, and the directions at the corners, for triangles that look curved",
            ),
            word("uv_vectors", ValueKind::Block, "", "how many, and pairs of surface coordinates for `uv_mapping`"),
            word("texture_list", ValueKind::Block, "", "how many, and textures for faces and corners"),
            word(
                "face_indices",
                ValueKind::Block,
                "",
                "how many, and for each triangle the numbers of its corners from 0 on, perhaps with one or three numbers of textures",
            ),
            word(
                "normal_indices",
                ValueKind::Block,
                "",
                "how many, and for each triangle the numbers of its normals; else those of its corners",
            ),
            word(
                "uv_indices",
                ValueKind::Block,
                "",
                "how many, and for each triangle the numbers of its surface coordinates; else those of its corners",
            ),
            INSIDE_VECTOR,
        ],
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[INSIDE_VECTOR.sets(|mesh, r| mesh.0.read_inside_vector(r))];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self::default())
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        let lists = std::mem::take(&mut self.1);
        let mut mesh = lists.triangles;
        let faces = mesh.corners.len();
        if mesh.smooth.is_empty() && !mesh.normals.is_empty() {
            mesh.smooth = mesh.corners.clone();
        }
        if mesh.mapped.is_empty() && !mesh.uvs.is_empty() {
            mesh.mapped = mesh.corners.clone();
        }
        let at = |own: Option<Span>| own.or(lists.faces).unwrap_or(span);
        check_indices(&mesh.corners, mesh.vertices.len(), faces, ("corner", "vertex_vectors"), at(lists.faces))?;
        check_indices(&mesh.smooth, mesh.normals.len(), faces, ("normal", "normal_vectors"), at(lists.normals))?;
        check_indices(&mesh.mapped, mesh.uvs.len(), faces, ("pair of coordinates", "uv_vectors"), at(lists.uvs))?;
        self.0.triangles = Arc::new(TriangleHierarchy::new(mesh));
        self.0.warn_if_empty("mesh2", span, r);
        Ok(())
    }
}

impl Mesh2 {
    /// Reads one of the lists of a `mesh2`, if it is next; returns false otherwise.
    fn read_geometry(&mut self, next: Next, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<bool> {
        let Next::Block(list) = next else { return Ok(false) };
        let Lists { triangles: mesh, textures, faces, normals, uvs } = &mut self.1;
        let span = match list {
            "vertex_vectors" | "normal_vectors" | "uv_vectors" | "texture_list" | "face_indices" | "normal_indices"
            | "uv_indices" => r.take_token()?,
            _ => return Ok(false),
        };
        match list {
            "vertex_vectors" => mesh.vertices = read_vectors(r, |v| v.as_vec3())?,
            "normal_vectors" => mesh.normals = read_vectors(r, |v| v.normalize_or_zero().as_vec3())?,
            "uv_vectors" => mesh.uvs = read_list(r, |r| r.vector2())?,
            "texture_list" => {
                *textures = read_list(r, |r| {
                    let next = r.peek_next()?;
                    paints.read_listed_texture(next, r)?.ok_or_else(|| r.unexpected("a texture").into())
                })?;
            }
            "face_indices" => {
                *faces = Some(span);
                (mesh.corners, mesh.painted) = read_faces_and_textures(r, textures)?;
            }
            "normal_indices" => {
                *normals = Some(span);
                mesh.smooth = read_triples(r)?;
            }
            _ => {
                *uvs = Some(span);
                mesh.mapped = read_triples(r)?;
            }
        }
        r.leave_block()?;
        Ok(true)
    }
}

/// Reads a count, and that many elements of a mesh's list.
fn read_list<T>(r: &mut dyn Reader, mut read: impl FnMut(&mut dyn Reader) -> Result<T>) -> Result<Vec<T>> {
    let count = read_count(r)?;
    let mut list = Vec::with_capacity(count.min(BELIEVED));
    for _ in 0..count {
        list.push(read(r)?);
    }
    Ok(list)
}

fn read_count(r: &mut dyn Reader) -> Result<usize> {
    let span = r.span();
    let count = r.float()?;
    if !(0.0..f64::from(u32::MAX)).contains(&count) {
        return Diagnostic::err(codes::WRONG_COUNT, span, format!("a list can't have {count} entries"));
    }
    Ok(count as usize)
}

/// Reads a count, and that many vectors of a mesh's list.
fn read_vectors<T>(r: &mut dyn Reader, of: impl Fn(DVec3) -> T) -> Result<Vec<T>> {
    let count = read_count(r)?;
    let mut list = Vec::with_capacity(count.min(BELIEVED));
    while list.len() < count {
        let most = count - list.len();
        let mut literal = |v: &[f64]| {
            let v = DVec3::from_slice(v);
            list.extend(v.is_finite().then(|| of(v)));
            v.is_finite()
        };
        if r.read_literals(3, most, &mut literal) == 0 {
            list.push(of(r.vector()?));
        }
    }
    Ok(list)
}

/// Reads a count, and that many triples of indices of a mesh's list.
fn read_triples(r: &mut dyn Reader) -> Result<Vec<[u32; 3]>> {
    let count = read_count(r)?;
    let mut list = Vec::with_capacity(count.min(BELIEVED));
    while list.len() < count {
        if append_literal_triples(r, count - list.len(), &mut list) == 0 {
            let span = r.span();
            list.push(indices_or_error(&r.vector()?.to_array(), span)?);
        }
    }
    Ok(list)
}

/// Reads triples of indices from a long list of literals, up to the first invalid one; returns their number.
fn append_literal_triples(r: &mut dyn Reader, most: usize, list: &mut Vec<[u32; 3]>) -> usize {
    r.read_literals(3, most, &mut |found| {
        let triple = to_indices(found);
        list.extend(triple);
        triple.is_some()
    })
}

fn indices_or_error(found: &[f64], span: Span) -> Result<[u32; 3]> {
    match to_indices(found) {
        Some(triple) => Ok(triple),
        None if found.len() != 3 => Diagnostic::err(codes::WRONG_COUNT, span, "a triangle has three corners"),
        None => Diagnostic::err(codes::BAD_INDEX, span, "entries of a list are counted from 0"),
    }
}

/// Three indices for each triangle of a mesh.
type Triples = Vec<[u32; 3]>;

/// Converts three numbers to indices; `None` if one is not an index.
fn to_indices(found: &[f64]) -> Option<[u32; 3]> {
    let found: [f64; 3] = found.try_into().ok()?;
    found.iter().all(|x| (0.0..f64::from(u32::MAX)).contains(x)).then(|| found.map(|x| x as u32))
}

/// Reads the corners of each face of a `mesh2`, and its textures: none, one, or one for each corner.
fn read_faces_and_textures(r: &mut dyn Reader, textures: &[u32]) -> Result<(Triples, Triples)> {
    let count = read_count(r)?;
    let mut faces = Vec::with_capacity(count.min(BELIEVED));
    let mut painted: Vec<[u32; 3]> = vec![];
    // Number of textures of the last face.
    let mut given = 0;
    while r.peek_next()? == Next::Value {
        match r.value()? {
            (Value::Float(number), span) => {
                if given == 3 || faces.is_empty() {
                    return Diagnostic::err(codes::WRONG_COUNT, span, "a triangle has one texture, or three");
                }
                let texture = checked_texture_number(number, textures, span)?;
                painted.resize(faces.len(), [0; 3]);
                if let Some(texture_numbers) = painted.last_mut() {
                    // One texture applies to all corners, until another follows.
                    if given == 0 {
                        *texture_numbers = [texture; 3]
                    } else {
                        texture_numbers[given] = texture
                    }
                    if given == 2 {
                        *texture_numbers = mark_textures_per_corner(*texture_numbers);
                    }
                }
                given += 1;
            }
            (Value::Vector(v), span) => {
                faces.push(indices_or_error(&v.c[..v.len as usize], span)?);
                append_literal_triples(r, usize::MAX, &mut faces);
                given = 0;
            }
            (_, span) => {
                return Diagnostic::err(
                    codes::WRONG_TYPE,
                    span,
                    "the three numbers of a triangle's corners are needed here",
                );
            }
        }
    }
    if faces.len() != count {
        let message = format!("{count} triangles were announced, and here are {}", faces.len());
        return Diagnostic::err(codes::WRONG_COUNT, r.span(), message);
    }
    if !painted.is_empty() {
        painted.resize(count, [0; 3]);
    }
    Ok((faces, painted))
}

/// Returns the texture numbers of a face's corners; if all are equal, with a flag which states that they were given for
/// each corner.
fn mark_textures_per_corner([a, b, c]: [u32; 3]) -> [u32; 3] {
    if a == b && b == c { [a | super::EACH_CORNER, b, c] } else { [a, b, c] }
}

/// Returns the object's number of the texture at an index of the `texture_list`, from 0 on.
fn checked_texture_number(index: f64, textures: &[u32], span: Span) -> Result<u32> {
    match textures.get(index as usize).filter(|_| index >= 0.0) {
        Some(number) => Ok(*number),
        None => Err(index_error("texture", index, "texture_list", textures.len(), span).into()),
    }
}

fn index_error(what: &str, number: f64, list: &str, length: usize, span: Span) -> Diagnostic {
    let message = format!("there is no {what} {number}: `{list}` has {length}");
    Diagnostic::new(codes::BAD_INDEX, span, message).help("they are counted from 0")
}

/// Returns an error for an index beyond its list, or if the number of triples is not the number of triangles of the
/// mesh.
fn check_indices(
    numbers: &[[u32; 3]],
    list_length: usize,
    face_count: usize,
    (what, list): (&str, &str),
    span: Span,
) -> Result<()> {
    if !numbers.is_empty() && numbers.len() != face_count {
        let message = format!("these are for {} triangles, and there are {face_count}", numbers.len());
        return Diagnostic::err(codes::WRONG_COUNT, span, message);
    }
    match numbers.iter().flatten().find(|&&i| i as usize >= list_length) {
        Some(&i) => Err(index_error(what, f64::from(i), list, list_length, span).into()),
        None => Ok(()),
    }
}

impl TriangleMesh {
    fn read_inside_vector(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.inside_vector = Some(r.vector()?).filter(|dir| *dir != DVec3::ZERO);
        Ok(())
    }

    fn warn_if_empty(&self, word: &str, span: Span, r: &mut dyn Reader) {
        if self.triangles.is_empty() {
            r.report(Diagnostic::new(codes::NO_SURFACE, span, format!("this `{word}` has no triangles")));
        }
    }
}
