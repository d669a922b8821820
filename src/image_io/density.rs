//! Density files: numbers on a three-dimensional grid (manual, "df3 file format").

use crate::diagnostic::{Diagnostic, Result, codes, file};
use crate::source::{Files, ReadError, Span};
use std::path::Path;

/// Densities from 0 to 1 on a three-dimensional grid, the contents of a df3 file.
#[derive(Clone, Debug, PartialEq)]
pub struct Voxels {
    /// Number of the grid's samples along x, y and z.
    pub size: [usize; 3],
    numbers: Numbers,
}

#[derive(Clone, Debug, PartialEq)]
enum Numbers {
    U8(Vec<u8>),
    U16(Vec<u16>),
    U32(Vec<u32>),
}

impl Voxels {
    /// Reads a df3 density file.
    ///
    /// # Errors
    /// E0002 if the file does not exist, E0003 if it can't be read, E0007 if its length is wrong.
    pub fn read(files: &dyn Files, path: &Path) -> Result<Self> {
        let bytes = files.read(path).map_err(|e| file::unreadable(files, path, &ReadError::Io(e)))?;
        Self::decode_df3(&bytes).map_err(|reason| {
            let text = format!("`{}` can't be decoded: {reason}", path.display());
            Box::new(Diagnostic::new(codes::PICTURE_BROKEN, Span::NONE, text))
        })
    }

    /// Decodes a df3 density file: three sizes of two bytes, then all densities, x fastest, of one, two or four bytes,
    /// as the file's length implies; all are big-endian.
    ///
    /// # Errors
    /// The reason why the bytes are not a df3 file, in words.
    pub fn decode_df3(bytes: &[u8]) -> std::result::Result<Self, String> {
        let Some((&header, body)) = bytes.split_first_chunk::<6>() else { return Err("it is too short".into()) };
        let [a, b, c, d, e, f] = header;
        let size = [[a, b], [c, d], [e, f]].map(|pair| usize::from(u16::from_be_bytes(pair)));
        let count = size[0] * size[1] * size[2];
        if count == 0 {
            return Err(format!("its size is {} × {} × {}", size[0], size[1], size[2]));
        }
        let numbers = match body.len() / count {
            0 => return Err(format!("{count} numbers were announced, but it has {} bytes", body.len())),
            1 => Numbers::U8(body[..count].to_vec()),
            2 | 3 => Numbers::U16(map_words(&body[..2 * count], u16::from_be_bytes)),
            _ => Numbers::U32(map_words(&body[..4 * count], u32::from_be_bytes)),
        };
        Ok(Self { size, numbers })
    }

    /// Returns the density at a grid position, 0 to 1.
    pub fn density_at(&self, [x, y, z]: [usize; 3]) -> f64 {
        let i = (z * self.size[1] + y) * self.size[0] + x;
        match &self.numbers {
            Numbers::U8(n) => f64::from(n[i]) / f64::from(u8::MAX),
            Numbers::U16(n) => f64::from(n[i]) / f64::from(u16::MAX),
            Numbers::U32(n) => f64::from(n[i]) / f64::from(u32::MAX),
        }
    }
}

fn map_words<const N: usize, T>(bytes: &[u8], word: impl Fn([u8; N]) -> T) -> Vec<T> {
    bytes.chunks_exact(N).filter_map(|chunk| chunk.try_into().ok()).map(word).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_length_decides_the_sample_size() {
        let header = [0, 2, 0, 1, 0, 1];
        let at = |body: &[u8]| Voxels::decode_df3(&[&header, body].concat()).map(|v| v.density_at([1, 0, 0]));
        assert_eq!(at(&[0, 51]), Ok(0.2));
        assert_eq!(at(&[0, 0, 51, 51]), Ok(0.2));
        assert_eq!(at(&[0, 0, 0, 0, 51, 51, 51, 51]), Ok(0.2));
        assert!(at(&[0]).is_err());
        assert!(Voxels::decode_df3(&[0, 0, 0, 0, 0, 0, 1]).is_err());
    }
}
