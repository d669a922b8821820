//! Accessors: typed views of a glTF file's buffers.

use super::super::ReadResult;
use super::document::{Accessor, Document};

/// Rows of a glTF accessor, converted to numbers.
pub struct Rows<'a> {
    bytes: &'a [u8],
    stride: usize,
    component: u32,
    normalized: bool,
    /// Number of rows of the glTF accessor; all are within its bytes.
    pub count: usize,
}

impl<'a> Rows<'a> {
    /// Returns the rows of the glTF accessor with this index, which has `width` numbers in a row.
    ///
    /// # Errors
    /// The reason why the accessor can't be read.
    pub fn new(document: &Document, buffers: &'a [Vec<u8>], number: usize, width: usize) -> ReadResult<Self> {
        let accessor = document.accessors.get(number).ok_or_else(|| format!("there is no accessor {number}"))?;
        Self::from_accessor(document, buffers, accessor, width).map_err(|why| format!("accessor {number}: {why}"))
    }

    fn from_accessor(
        document: &Document,
        buffers: &'a [Vec<u8>],
        accessor: &Accessor,
        width: usize,
    ) -> ReadResult<Self> {
        if accessor.sparse.is_some() {
            return Err("sparse ones are not read".into());
        }
        let shape = ["SCALAR", "VEC2", "VEC3", "VEC4"].get(width - 1).copied().unwrap_or_default();
        if accessor.shape != shape {
            return Err(format!("expected `{shape}`, found `{}`", accessor.shape));
        }
        let size = width
            * match accessor.component_type {
                5120 | 5121 => 1,
                5122 | 5123 => 2,
                5125 | 5126 => 4,
                other => return Err(format!("there is no type of numbers {other}")),
            };
        let number = accessor.buffer_view.ok_or("it has no buffer view")?;
        let view = document.buffer_views.get(number).ok_or_else(|| format!("there is no buffer view {number}"))?;
        let buffer = buffers.get(view.buffer).ok_or_else(|| format!("there is no buffer {}", view.buffer))?;
        let part = |from: usize, length: usize| buffer.get(from..from.checked_add(length)?);
        let bytes = part(view.byte_offset, view.byte_length).ok_or_else(|| {
            format!(
                "its bytes from {} on are {}, and buffer {} ends at {}",
                view.byte_offset,
                view.byte_length,
                view.buffer,
                buffer.len()
            )
        })?;
        let bytes = bytes.get(accessor.byte_offset..).unwrap_or_default();
        let stride = view.byte_stride.unwrap_or(size).max(size);
        let room = if bytes.len() < size { 0 } else { (bytes.len() - size) / stride + 1 };
        if accessor.count > room {
            return Err(format!("it has {} rows, and its bytes are enough for {room}", accessor.count));
        }
        Ok(Self {
            bytes,
            stride,
            component: accessor.component_type,
            normalized: accessor.normalized,
            count: accessor.count,
        })
    }

    /// Returns the numbers of row `i` of the glTF accessor.
    pub fn row_numbers<const N: usize>(&self, i: usize) -> [f64; N] {
        let row = &self.bytes[i * self.stride..];
        macro_rules! take {
            ($type:ty, $whole:expr) => {{
                const SIZE: usize = size_of::<$type>();
                std::array::from_fn(|k| {
                    let bytes = row[k * SIZE..].first_chunk().copied().unwrap_or_default();
                    let number = f64::from(<$type>::from_le_bytes(bytes));
                    if self.normalized { (number / $whole).max(-1.0) } else { number }
                })
            }};
        }
        match self.component {
            5120 => take!(i8, 127.0),
            5121 => take!(u8, 255.0),
            5122 => take!(i16, 32767.0),
            5123 => take!(u16, 65535.0),
            5125 => take!(u32, 1.0),
            _ => take!(f32, 1.0),
        }
    }
}
