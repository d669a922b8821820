//! OBJ: vertices, polygons and names of materials, line by line. (Alias|Wavefront, Object files, 1995.)

use super::words::{numbered_lines, parse_number};
use super::{FileOpener, MeshFile, NONE, ReadResult, finite_point, mtl, polygon, unit_direction};
use crate::math::DVec2;
use glam::Vec3;

/// Reads an OBJ file. Lines that do not describe polygons are skipped.
pub fn read_obj(bytes: &[u8], open: FileOpener) -> ReadResult<MeshFile> {
    let mut out = MeshFile::default();
    let mut state = State::default();
    for (line, text) in numbered_lines(bytes) {
        let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((&text, ""));
        match word {
            "v" => {
                let [x, y, z, _] = parse_numbers(rest, 3, line)?;
                out.triangles.vertices.push(finite_point([x, y, z], || format!("line {line}"))?);
            }
            "vn" => {
                let [x, y, z, _] = parse_numbers(rest, 3, line)?;
                out.triangles.normals.push(unit_direction([x, y, z]));
            }
            "vt" => {
                let [u, v, ..] = parse_numbers(rest, 1, line)?;
                out.triangles.uvs.push(DVec2::new(u, v));
            }
            "f" => state.read_face(rest, line, &mut out)?,
            "mtllib" => read_material_files(rest.trim(), open, &mut out)?,
            "usemtl" => {
                let name = rest.trim();
                let found = out.materials.iter().rposition(|material| material.name == name);
                // (One remark is enough: a missing material file makes all of its materials missing.)
                if found.is_none() && out.remarks.is_empty() {
                    out.remarks.push(format!("line {line}: there is no material `{name}`"));
                }
                state.material_or_0 = found.map_or(0, |i| i as u32 + 1);
            }
            _ => {}
        }
    }
    Ok(out)
}

/// Reads the material files that a line of an OBJ file names; a missing one becomes a remark.
fn read_material_files(rest: &str, open: FileOpener, out: &mut MeshFile) -> ReadResult<()> {
    // One name, which may contain blanks, or else several.
    if let Ok(bytes) = open(rest) {
        return mtl::read_mtl(&bytes, rest, &mut out.materials);
    }
    for name in rest.split_ascii_whitespace() {
        match open(name) {
            Ok(bytes) => mtl::read_mtl(&bytes, name, &mut out.materials)?,
            Err(why) => out.remarks.push(format!("its materials are left out: {why}")),
        }
    }
    Ok(())
}

/// Reads at least `min_count` numbers from a line of an OBJ file; missing ones are 0.
fn parse_numbers(rest: &str, min_count: usize, line: usize) -> ReadResult<[f64; 4]> {
    let mut out = [0.0; 4];
    let mut count = 0;
    for (x, word) in out.iter_mut().zip(rest.split_ascii_whitespace()) {
        *x = parse_number(word.as_bytes(), || format!("line {line}"))?;
        count += 1;
    }
    if count < min_count { Err(format!("line {line}: expected {min_count} numbers, found {count}")) } else { Ok(out) }
}

/// State of the reader of faces in an OBJ file.
#[derive(Default)]
struct State {
    /// Number of the current material in an OBJ file, from 1 on; 0 without a material.
    material_or_0: u32,
    corners: Vec<[Option<u32>; 3]>,
    points: Vec<Vec3>,
}

impl State {
    /// Reads a face of an OBJ file: `f 1/2/3 4/5/6 …`, indices of corner, surface coordinates and normal.
    fn read_face(&mut self, rest: &str, line: usize, out: &mut MeshFile) -> ReadResult<()> {
        let all = &mut out.triangles;
        let lengths = [all.vertices.len(), all.uvs.len(), all.normals.len()];
        self.corners.clear();
        for word in rest.split_ascii_whitespace() {
            let mut corner = [None; 3];
            for (i, part) in word.split('/').enumerate().take(3).filter(|(_, part)| !part.is_empty()) {
                let what = ["corner", "pair of surface coordinates", "normal"][i];
                corner[i] = Some(parse_index(part, lengths[i], what, line)?);
            }
            if corner[0].is_none() {
                return Err(format!("line {line}: expected the number of a corner, found `{word}`"));
            }
            self.corners.push(corner);
        }
        if self.corners.len() < 3 {
            return Err(format!("line {line}: this face has {} corners", self.corners.len()));
        }
        self.points.clear();
        self.points.extend(self.corners.iter().map(|c| all.vertices[c[0].unwrap_or(0) as usize]));
        let Self { corners, points, material_or_0, .. } = self;
        polygon::triangulate(points, |places| {
            let [corners, uvs, normals] = [0, 1, 2].map(|i| {
                let [a, b, c] = places.map(|place| corners[place][i]);
                a.zip(b).zip(c).map_or(NONE, |((a, b), c)| [a, b, c])
            });
            all.push_triangle(corners, normals, uvs, [*material_or_0; 3]);
        });
        Ok(())
    }
}

/// Reads an index of an OBJ file, counted from 1, or backwards from the end.
fn parse_index(text: &str, items_before: usize, item_name: &str, line: usize) -> ReadResult<u32> {
    let n: i64 =
        text.parse().map_err(|_| format!("line {line}: expected the number of a {item_name}, found `{text}`"))?;
    let place = if n < 0 { items_before as i64 + n } else { n - 1 };
    match u32::try_from(place) {
        Ok(place) if (place as usize) < items_before => Ok(place),
        _ => Err(format!("line {line}: there is no {item_name} {n}: {items_before} stand before")),
    }
}
