//! STL, as text or as bytes: triangles without topology. (Marshall Burns, Automated Fabrication, 1993, section 6.5.)

use super::words::{Words, parse_number};
use super::{MeshFile, NONE, ReadResult, Triangles, finite_point, polygon};
use glam::Vec3;
use rustc_hash::FxHashMap;

/// Size of a triangle in a binary STL file, in bytes.
const SIZE: usize = 50;

/// Reads an STL file, binary or text.
pub fn read_stl(bytes: &[u8]) -> ReadResult<MeshFile> {
    let mut joined = Joined::default();
    // Binary files may begin like text; then their length decides.
    let count = bytes.get(80..84).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]) as usize);
    let fits = count.is_some_and(|count| bytes.len() == 84 + count * SIZE);
    if bytes.trim_ascii_start().starts_with(b"solid") && !fits {
        read_text(bytes, &mut joined)?;
    } else {
        read_binary(bytes, count, &mut joined)?;
    }
    Ok(MeshFile { triangles: joined.triangles, ..MeshFile::default() })
}

/// Triangles of an STL file that share vertices with equal bits.
#[derive(Default)]
struct Joined {
    triangles: Triangles,
    known: FxHashMap<[u32; 3], u32>,
}

impl Joined {
    fn push_triangle(&mut self, corners: [Vec3; 3]) {
        let list = &mut self.triangles.vertices;
        let numbers = corners.map(|p| {
            *self.known.entry(p.to_array().map(f32::to_bits)).or_insert_with(|| {
                list.push(p);
                list.len() as u32 - 1
            })
        });
        self.triangles.push_triangle(numbers, NONE, NONE, [0; 3]);
    }
}

fn read_binary(bytes: &[u8], count: Option<usize>, out: &mut Joined) -> ReadResult<()> {
    let Some(count) = count else { return Err("it ends within its first 84 bytes".into()) };
    let all = bytes[84..].chunks_exact(SIZE);
    if all.len() < count {
        let message = format!("byte {}: it ends after {} of {count} triangles", bytes.len(), all.len());
        return Err(message);
    }
    for (i, triangle) in all.take(count).enumerate() {
        let float = |k: usize| f32::from_le_bytes(std::array::from_fn(|b| triangle[12 + 4 * k + b]));
        let mut corners = [Vec3::ZERO; 3];
        for (k, corner) in corners.iter_mut().enumerate() {
            let place = || format!("byte {}", 84 + i * SIZE + 12 + 12 * k);
            *corner = finite_point([3 * k, 3 * k + 1, 3 * k + 2].map(|k| f64::from(float(k))), place)?;
        }
        out.push_triangle(corners);
    }
    Ok(())
}

fn read_text(bytes: &[u8], out: &mut Joined) -> ReadResult<()> {
    let mut words = Words::new(bytes, 1);
    let mut corners: Vec<Vec3> = vec![];
    while let Some(word) = words.next_word() {
        if word.eq_ignore_ascii_case(b"vertex") {
            let mut p = [0.0; 3];
            for x in &mut p {
                let word = words
                    .next_word()
                    .ok_or_else(|| format!("{}: it ends within a corner", words.line_for_message()))?;
                *x = parse_number(word, || words.line_for_message())?;
            }
            corners.push(finite_point(p, || words.line_for_message())?);
        } else if word.eq_ignore_ascii_case(b"endloop") {
            if corners.len() < 3 {
                return Err(format!("{}: this facet has {} corners", words.line_for_message(), corners.len()));
            }
            polygon::triangulate(&corners, |places| out.push_triangle(places.map(|i| corners[i])));
            corners.clear();
        }
    }
    if corners.is_empty() { Ok(()) } else { Err(format!("{}: it ends within a facet", words.line_for_message())) }
}
