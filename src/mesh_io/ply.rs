//! PLY, as text or as bytes of either order (Greg Turk, The PLY Polygon File Format, 1994), read by the crate `ply-rs-bw`.

use super::{MeshFile, NONE, ReadResult, Triangles, finite_point, polygon, unit_direction};
use crate::math::DVec2;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType};
use std::io::{BufRead, ErrorKind, Read};

/// Number of elements of a PLY file that are read at once. A header's count thus reserves no memory for data that the
/// file does not have.
const BATCH: usize = 1 << 12;

/// Reads the `vertex` and `face` elements of a PLY file and skips all others.
///
/// # Errors
/// The reason why the file is not understood, with the line where it is text.
pub fn read_ply(bytes: &[u8]) -> ReadResult<MeshFile> {
    const END: &[u8] = b"end_header";
    // Comments in the header may be in any encoding.
    let length = bytes.windows(END.len()).position(|window| window == END).ok_or("the header has no `end_header`")?;
    let head = String::from_utf8_lossy(&bytes[..length]).into_owned();
    let mut reader = Reader::new(head.as_bytes().chain(&bytes[length..]));
    let header = Parser::<Skipped>::new().read_header(&mut reader).map_err(one_line_message)?;
    let mut out = Triangles::default();
    for element in header.elements.values() {
        match element.name.as_str() {
            "vertex" => read_vertices(&mut reader, element, &header, &mut out)?,
            "face" => read_faces(&mut reader, element, &header, &mut out)?,
            _ => for_each_element(&mut reader, element, &header, |_, _: Skipped| Ok(()))?,
        }
    }
    Ok(MeshFile { triangles: out, ..MeshFile::default() })
}

/// Returns the PLY parser's message in one line of bounded length (the parser quotes whole lines of the file).
fn one_line_message(error: ParseError) -> String {
    let text = error.to_string();
    let words: Vec<&str> = text.split_whitespace().collect();
    let mut text: String = words.join(" ").chars().take(200).collect();
    if let Some(first) = text.get_mut(..1) {
        first.make_ascii_lowercase();
    }
    text
}

/// Calls `visit` with the index and the value of each element of one kind in a PLY file.
fn for_each_element<T: BufRead, E: PropertyAccess>(
    reader: &mut Reader<T>,
    element: &ElementDef,
    header: &Header,
    mut visit: impl FnMut(usize, E) -> ReadResult<()>,
) -> ReadResult<()> {
    // Elements without properties take no bytes: their count has no bound, and no data follow.
    let count = if element.properties.is_empty() { 0 } else { element.count };
    let mut batch = element.clone();
    for first in (0..count).step_by(BATCH) {
        batch.count = BATCH.min(count - first);
        let read =
            Parser::new().read_payload_for_element(reader, &batch, header).map_err(|error| match error.kind() {
                ErrorKind::UnexpectedEof => format!("the file ends within its {count} `{}` elements", element.name),
                _ => format!("in its `{}` elements: {}", element.name, one_line_message(error)),
            })?;
        read.into_iter().enumerate().try_for_each(|(i, value)| visit(first + i, value))?;
    }
    Ok(())
}

/// Element of a PLY file whose properties are ignored.
struct Skipped;

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Self
    }
}

/// Position, normal and surface coordinates of a PLY file's vertex; 0 where the file has no such property.
struct Vertex([f64; 8]);

/// Returns the index in [`Vertex`] of a vertex property, under the names that programs write.
fn vertex_slot(name: &str) -> Option<usize> {
    Some(match name {
        "x" => 0,
        "y" => 1,
        "z" => 2,
        "nx" => 3,
        "ny" => 4,
        "nz" => 5,
        "u" | "s" | "texture_u" => 6,
        "v" | "t" | "texture_v" => 7,
        _ => return None,
    })
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self([0.0; 8])
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let number = match property {
            Property::Char(x) => x.into(),
            Property::UChar(x) => x.into(),
            Property::Short(x) => x.into(),
            Property::UShort(x) => x.into(),
            Property::Int(x) => x.into(),
            Property::UInt(x) => x.into(),
            Property::Float(x) => x.into(),
            Property::Double(x) => x,
            _ => return PropertyAccessResult::Ignored,
        };
        match vertex_slot(name) {
            Some(slot) => self.0[slot] = number,
            None => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }
}

/// The vertex indices of a PLY file's face, in any type of number; `None` without the list.
struct Face(Option<Property>);

fn is_list_of_corners(name: &str) -> bool {
    matches!(name, "vertex_indices" | "vertex_index")
}

impl PropertyAccess for Face {
    fn new() -> Self {
        Self(None)
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if !is_list_of_corners(name) {
            return PropertyAccessResult::Ignored;
        }
        self.0 = Some(property);
        PropertyAccessResult::Set
    }
}

/// Replaces `out` by the numbers of a list property in a PLY file.
fn numbers_of_list(property: &Property, out: &mut Vec<f64>) {
    out.clear();
    match property {
        Property::ListChar(list) => out.extend(list.iter().map(|x| f64::from(*x))),
        Property::ListUChar(list) => out.extend(list.iter().map(|x| f64::from(*x))),
        Property::ListShort(list) => out.extend(list.iter().map(|x| f64::from(*x))),
        Property::ListUShort(list) => out.extend(list.iter().map(|x| f64::from(*x))),
        Property::ListInt(list) => out.extend(list.iter().map(|x| f64::from(*x))),
        Property::ListUInt(list) => out.extend(list.iter().map(|x| f64::from(*x))),
        Property::ListFloat(list) => out.extend(list.iter().map(|x| f64::from(*x))),
        Property::ListDouble(list) => out.extend(list),
        _ => {}
    }
}

fn read_vertices<T: BufRead>(
    reader: &mut Reader<T>,
    element: &ElementDef,
    header: &Header,
    out: &mut Triangles,
) -> ReadResult<()> {
    let scalars = element.properties.values().filter(|p| matches!(p.data_type, PropertyType::Scalar(_)));
    let slots: Vec<usize> = scalars.filter_map(|p| vertex_slot(&p.name)).collect();
    let has = |all: &[usize]| all.iter().all(|slot| slots.contains(slot));
    let (has_normals, has_uvs) = (has(&[3, 4, 5]), has(&[6, 7]));
    if !has(&[0, 1, 2]) {
        return Err("its `vertex` elements have no `x`, `y` and `z`".into());
    }
    for_each_element(reader, element, header, |i, Vertex(v)| {
        out.vertices.push(finite_point([v[0], v[1], v[2]], || format!("`vertex` {i}"))?);
        if has_normals {
            out.normals.push(unit_direction([v[3], v[4], v[5]]));
        }
        if has_uvs {
            out.uvs.push(DVec2::new(v[6], v[7]));
        }
        Ok(())
    })
}

fn read_faces<T: BufRead>(
    reader: &mut Reader<T>,
    element: &ElementDef,
    header: &Header,
    out: &mut Triangles,
) -> ReadResult<()> {
    let is_list = |p: &PropertyType| matches!(p, PropertyType::List(..));
    if !element.properties.values().any(|p| is_list(&p.data_type) && is_list_of_corners(&p.name)) {
        return Err("its `face` elements have no list `vertex_indices`".into());
    }
    let (mut list, mut points) = (vec![], vec![]);
    for_each_element(reader, element, header, |i, Face(property)| {
        let Some(property) = property else { return Ok(()) };
        numbers_of_list(&property, &mut list);
        let count = out.vertices.len();
        if let Some(n) = list.iter().find(|n| !(**n >= 0.0 && **n < count as f64)) {
            return Err(format!("`face` {i} has a corner {n}, and there are {count}"));
        }
        points.clear();
        points.extend(list.iter().map(|n| out.vertices[*n as usize]));
        polygon::triangulate(&points, |places| {
            let corners = places.map(|k| list[k] as u32);
            let of = |has: bool| if has { corners } else { NONE };
            out.push_triangle(corners, of(!out.normals.is_empty()), of(!out.uvs.is_empty()), [0; 3]);
        });
        Ok(())
    })
}
