//! PLY, as text or as bytes of either order: elements with properties that the header names. (Greg Turk, The PLY Polygon File Format,
//! 1994.)

use super::words::{Words, number};
use super::{MeshFile, NONE, Reading, Triangles, direction, point, polygon};
use crate::math::DVec2;

/// How a number is stored.
#[derive(Clone, Copy, PartialEq)]
enum Type {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

struct Property {
    name: String,
    /// Of the number that says how many follow.
    length: Option<Type>,
    kind: Type,
}

struct Element {
    name: String,
    count: u64,
    properties: Vec<Property>,
}

enum Format {
    Text,
    Little,
    Big,
}

/// Reads a file.
pub fn read(bytes: &[u8]) -> Reading<MeshFile> {
    let mut rest = bytes;
    let (format, elements, lines) = read_header(&mut rest)?;
    let start = bytes.len() - rest.len();
    let mut numbers = match format {
        Format::Text => Numbers::Text(Words::new(rest, lines + 1)),
        Format::Little | Format::Big => Numbers::Bytes { all: bytes, at: start, big: matches!(format, Format::Big) },
    };
    let mut out = Triangles::default();
    for element in &elements {
        match element.name.as_str() {
            "vertex" => read_vertices(element, &mut numbers, &mut out)?,
            "face" => read_faces(element, &mut numbers, &mut out)?,
            _ => skip(element, &mut numbers)?,
        }
    }
    Ok(MeshFile { triangles: out, ..MeshFile::default() })
}

/// The header's format and elements, and how many lines it has; `rest` is what stands behind.
fn read_header(rest: &mut &[u8]) -> Reading<(Format, Vec<Element>, usize)> {
    let (mut format, mut elements) = (None, Vec::<Element>::new());
    let mut line = 0;
    loop {
        line += 1;
        let Some(end) = rest.iter().position(|b| *b == b'\n') else {
            return Err(format!("line {line}: the header has no `end_header`"));
        };
        let text = String::from_utf8_lossy(&rest[..end]).trim().to_string();
        *rest = &rest[end + 1..];
        let words: Vec<&str> = text.split_ascii_whitespace().collect();
        match words[..] {
            ["ply"] if line == 1 => {}
            _ if line == 1 => return Err("line 1: a PLY file begins with `ply`".into()),
            ["end_header"] => break,
            [] | ["comment" | "obj_info", ..] => {}
            ["format", "ascii", _] => format = Some(Format::Text),
            ["format", "binary_little_endian", _] => format = Some(Format::Little),
            ["format", "binary_big_endian", _] => format = Some(Format::Big),
            ["element", name, count] => {
                let count = count.parse().map_err(|_| format!("line {line}: `{count}` is no count"))?;
                elements.push(Element { name: name.into(), count, properties: vec![] });
            }
            ["property", ref what @ ..] => {
                let property = read_property(what).map_err(|why| format!("line {line}: {why}"))?;
                match elements.last_mut() {
                    Some(element) => element.properties.push(property),
                    None => return Err(format!("line {line}: a property before the first element")),
                }
            }
            _ => return Err(format!("line {line}: `{}` is no line of a header", cut(&text))),
        }
    }
    let format = format.ok_or_else(|| format!("line {line}: the header names no format that is known"))?;
    Ok((format, elements, line))
}

fn read_property(words: &[&str]) -> Reading<Property> {
    match *words {
        ["list", length, kind, name] => {
            Ok(Property { name: name.into(), length: Some(type_of(length)?), kind: type_of(kind)? })
        }
        [kind, name] => Ok(Property { name: name.into(), length: None, kind: type_of(kind)? }),
        _ => Err("a property has a type and a name".into()),
    }
}

fn type_of(name: &str) -> Reading<Type> {
    Ok(match name {
        "char" | "int8" => Type::I8,
        "uchar" | "uint8" => Type::U8,
        "short" | "int16" => Type::I16,
        "ushort" | "uint16" => Type::U16,
        "int" | "int32" => Type::I32,
        "uint" | "uint32" => Type::U32,
        "float" | "float32" => Type::F32,
        "double" | "float64" => Type::F64,
        _ => return Err(format!("`{}` is no type of a number", cut(name))),
    })
}

/// The beginning of what a message shows.
fn cut(text: &str) -> String {
    text.chars().take(40).collect()
}

/// The numbers behind the header.
enum Numbers<'a> {
    Text(Words<'a>),
    Bytes { all: &'a [u8], at: usize, big: bool },
}

impl Numbers<'_> {
    fn place(&self) -> String {
        match self {
            Numbers::Text(words) => words.place(),
            Numbers::Bytes { at, .. } => format!("byte {at}"),
        }
    }

    /// An upper bound of how many things there are still, if each takes a byte or a word.
    fn left(&self) -> usize {
        match self {
            Numbers::Text(words) => words.left(),
            Numbers::Bytes { all, at, .. } => all.len() - at,
        }
    }

    /// `None` at the end.
    fn next(&mut self, kind: Type) -> Reading<Option<f64>> {
        match self {
            Numbers::Text(words) => match words.next() {
                Some(word) => number(word, || words.place()).map(Some),
                None => Ok(None),
            },
            Numbers::Bytes { all, at, big } => {
                macro_rules! take {
                    ($type:ty) => {{
                        let Some(bytes) = all[*at..].first_chunk() else { return Ok(None) };
                        *at += bytes.len();
                        if *big { <$type>::from_be_bytes(*bytes) } else { <$type>::from_le_bytes(*bytes) }.into()
                    }};
                }
                Ok(Some(match kind {
                    Type::I8 => take!(i8),
                    Type::U8 => take!(u8),
                    Type::I16 => take!(i16),
                    Type::U16 => take!(u16),
                    Type::I32 => take!(i32),
                    Type::U32 => take!(u32),
                    Type::F32 => take!(f32),
                    Type::F64 => take!(f64),
                }))
            }
        }
    }

    /// The numbers of a property, of the element of this number.
    fn property(&mut self, property: &Property, element: &Element, i: u64, out: &mut Vec<f64>) -> Reading<()> {
        out.clear();
        let ended = |numbers: &Self| {
            format!("{}: it ends in `{}` {i} of {}", numbers.place(), cut(&element.name), element.count)
        };
        let count = match property.length {
            None => 1.0,
            Some(kind) => self.next(kind)?.ok_or_else(|| ended(self))?,
        };
        if !(0.0..=4294967295.0).contains(&count) {
            return Err(format!("{}: a list can't have {count} entries", self.place()));
        }
        for _ in 0..count as u64 {
            out.push(self.next(property.kind)?.ok_or_else(|| ended(self))?);
        }
        Ok(())
    }
}

/// How many to make room for: what the header says counts only as far as there are bytes.
fn believed(element: &Element, numbers: &Numbers) -> usize {
    usize::try_from(element.count).unwrap_or(usize::MAX).min(numbers.left() / element.properties.len().max(1))
}

fn skip(element: &Element, numbers: &mut Numbers) -> Reading<()> {
    let mut list = vec![];
    // (Without properties there is nothing to pass, however often.)
    for i in 0..if element.properties.is_empty() { 0 } else { element.count } {
        for property in &element.properties {
            numbers.property(property, element, i, &mut list)?;
        }
    }
    Ok(())
}

/// Where a vertex has its numbers: the names that programs write.
const NAMES: [&[&str]; 8] =
    [&["x"], &["y"], &["z"], &["nx"], &["ny"], &["nz"], &["u", "s", "texture_u"], &["v", "t", "texture_v"]];

fn read_vertices(element: &Element, numbers: &mut Numbers, out: &mut Triangles) -> Reading<()> {
    let slots: Vec<Option<usize>> = element
        .properties
        .iter()
        .map(|p| NAMES.iter().position(|names| p.length.is_none() && names.contains(&p.name.as_str())))
        .collect();
    let has = |all: &[usize]| all.iter().all(|i| slots.contains(&Some(*i)));
    let (smooth, mapped) = (has(&[3, 4, 5]), has(&[6, 7]));
    if !has(&[0, 1, 2]) {
        return Err("its `vertex` elements have no `x`, `y` and `z`".into());
    }
    let room = believed(element, numbers);
    out.vertices.reserve(room);
    out.normals.reserve(if smooth { room } else { 0 });
    out.uvs.reserve(if mapped { room } else { 0 });
    let mut list = vec![];
    for i in 0..element.count {
        let mut v = [0.0; 8];
        for (property, slot) in element.properties.iter().zip(&slots) {
            numbers.property(property, element, i, &mut list)?;
            if let (Some(slot), [x]) = (slot, &list[..]) {
                v[*slot] = *x;
            }
        }
        out.vertices.push(point([v[0], v[1], v[2]], || numbers.place())?);
        if smooth {
            out.normals.push(direction([v[3], v[4], v[5]]));
        }
        if mapped {
            out.uvs.push(DVec2::new(v[6], v[7]));
        }
    }
    Ok(())
}

fn read_faces(element: &Element, numbers: &mut Numbers, out: &mut Triangles) -> Reading<()> {
    let is_list = |p: &&Property| p.length.is_some() && matches!(p.name.as_str(), "vertex_indices" | "vertex_index");
    if !element.properties.iter().any(|p| is_list(&p)) {
        return Err("its `face` elements have no list `vertex_indices`".into());
    }
    out.corners.reserve(believed(element, numbers) / 3);
    let (mut list, mut points) = (vec![], vec![]);
    for i in 0..element.count {
        for property in &element.properties {
            numbers.property(property, element, i, &mut list)?;
            if !is_list(&property) {
                continue;
            }
            let count = out.vertices.len();
            if let Some(n) = list.iter().find(|n| !(**n >= 0.0 && **n < count as f64)) {
                return Err(format!("{}: `face` {i} has a corner {n}, and there are {count}", numbers.place()));
            }
            points.clear();
            points.extend(list.iter().map(|n| out.vertices[*n as usize]));
            polygon::triangles(&points, |places| {
                let corners = places.map(|k| list[k] as u32);
                let of = |has: bool| if has { corners } else { NONE };
                out.push(corners, of(!out.normals.is_empty()), of(!out.uvs.is_empty()), [0; 3]);
            });
        }
    }
    Ok(())
}
