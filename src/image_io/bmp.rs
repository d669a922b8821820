//! The parts of a bmp that the crate `image` drops: palette indices, and the bytes that POV-Ray 3.7 takes for alpha.

/// Fields of a BMP file's header that are needed.
struct Header {
    /// Offset of the pixels in the BMP file.
    start: usize,
    width: usize,
    height: usize,
    /// True if the lowest row of the BMP file comes first.
    up: bool,
    bits: usize,
    compression: u32,
}

const PLAIN: u32 = 0;
const RUNS_OF_BYTES: u32 = 1;
const RUNS_OF_HALVES: u32 = 2;

impl Header {
    /// Reads the header at the start of a BMP file; `None` if the file is too short.
    fn read(file: &[u8]) -> Option<Self> {
        let long = |at: usize| file.get(at..)?.first_chunk().copied().map(u32::from_le_bytes);
        let height = long(22)? as i32;
        Some(Self {
            start: long(10)? as usize,
            width: long(18)? as usize,
            height: height.unsigned_abs() as usize,
            up: height > 0,
            bits: (long(26)? >> 16) as usize,
            compression: long(30)?,
        })
    }

    /// Reorders a BMP file's rows from the file's order to top first.
    fn top_first<T: Copy>(&self, rows: Vec<T>) -> Vec<T> {
        if self.up { rows.chunks(self.width).rev().flatten().copied().collect() } else { rows }
    }
}

/// Palette index of each pixel of a complete BMP file, from the top left; `None` without a palette, if the file is
/// broken, or if its header has another width and height than `expected_size`.
pub(super) fn bmp_palette_indices(file: &[u8], expected_size: [usize; 2]) -> Option<Vec<u8>> {
    let header = Header::read(file)?;
    if [header.width, header.height] != expected_size || header.width == 0 {
        return None;
    }
    let data = file.get(header.start..)?;
    let rows = match (header.compression, header.bits) {
        (PLAIN, 1 | 4 | 8) => decode_uncompressed_indices(&header, data)?,
        (RUNS_OF_BYTES, 8) | (RUNS_OF_HALVES, 4) => decode_index_runs(&header, data)?,
        _ => return None,
    };
    Some(header.top_first(rows))
}

/// Decodes uncompressed palette indices from a BMP file's pixel data, in which each row is padded to a multiple of four
/// bytes; `None` if `data` is too short.
fn decode_uncompressed_indices(header: &Header, data: &[u8]) -> Option<Vec<u8>> {
    let stride = header.width.checked_mul(header.bits)?.div_ceil(32) * 4;
    let data = data.get(..stride.checked_mul(header.height)?)?;
    if data.is_empty() {
        return None;
    }
    let per_byte = 8 / header.bits;
    let number = |row: &[u8], x: usize| {
        let shift = 8 - header.bits * (x % per_byte + 1);
        ((u16::from(row[x / per_byte]) >> shift) & ((1 << header.bits) - 1)) as u8
    };
    Some(data.chunks(stride).flat_map(|row| (0..header.width).map(move |x| number(row, x))).collect())
}

/// Decodes run-length pixel data of a BMP file: pairs of a count and a byte that is repeated; a count of 0 ends a row
/// (0), ends the picture (1), moves the position (2), or precedes literal bytes. `None` if `data` ends within a code.
fn decode_index_runs(header: &Header, data: &[u8]) -> Option<Vec<u8>> {
    let (width, halves) = (header.width, header.bits == 4);
    let mut out = vec![0; width.checked_mul(header.height)?];
    let (mut x, mut y, mut at) = (0, 0, 0);
    let mut put = |x: usize, y: usize, value: u8| {
        if x < width && y < header.height {
            out[y * width + x] = value;
        }
    };
    let half = |byte: u8, i: usize| {
        if !halves {
            byte
        } else if i.is_multiple_of(2) {
            byte >> 4
        } else {
            byte & 15
        }
    };
    while let Some(&[count, value]) = data.get(at..at + 2) {
        at += 2;
        match (count, value) {
            (0, 0) => (x, y) = (0, y + 1),
            (0, 1) => break,
            (0, 2) => {
                let &[right, down] = data.get(at..at + 2)? else { return None };
                (x, y, at) = (x + usize::from(right), y + usize::from(down), at + 2);
            }
            (0, n) => {
                let n = usize::from(n);
                let size = if halves { n.div_ceil(2) } else { n };
                let bytes = data.get(at..at + size)?;
                (0..n).for_each(|i| put(x + i, y, half(bytes[if halves { i / 2 } else { i }], i)));
                (x, at) = (x + n, at + size + size % 2);
            }
            (n, value) => {
                (0..usize::from(n)).for_each(|i| put(x + i, y, half(value, i)));
                x += usize::from(n);
            }
        }
    }
    Some(out)
}

/// The fourth byte of each pixel of a complete, uncompressed BMP file with 32 bits a pixel, from the top left; `None`
/// for any other file.
pub(super) fn bmp_alpha(file: &[u8]) -> Option<Vec<u8>> {
    let header = Header::read(file)?;
    if header.bits != 32 || header.compression != PLAIN {
        return None;
    }
    let size = header.width.checked_mul(header.height)?.checked_mul(4)?;
    let data = file.get(header.start..)?.get(..size)?;
    if data.is_empty() {
        return None;
    }
    Some(header.top_first(data.iter().skip(3).step_by(4).copied().collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of 3 by 2 pixels, the lower row first.
    fn file(bits: u8, compression: u8, data: &[u8]) -> Vec<u8> {
        let mut out = vec![0; 54];
        (out[10], out[18], out[22], out[26], out[28], out[30]) = (54, 3, 2, 1, bits, compression);
        out.extend(data);
        out
    }

    fn indices(bytes: &[u8]) -> Option<Vec<u8>> {
        bmp_palette_indices(bytes, [3, 2])
    }

    #[test]
    fn the_same_numbers_in_all_ways() {
        let expected = Some(vec![1, 2, 1, 3, 3, 3]);
        assert_eq!(indices(&file(8, 0, &[3, 3, 3, 0, 1, 2, 1, 0])), expected);
        assert_eq!(indices(&file(4, 0, &[0x33, 0x30, 0, 0, 0x12, 0x10, 0, 0])), expected);
        assert_eq!(indices(&file(8, 1, &[3, 3, 0, 0, 0, 3, 1, 2, 1, 0, 0, 1])), expected);
        assert_eq!(indices(&file(4, 2, &[3, 0x33, 0, 0, 3, 0x12, 0, 1])), expected);
        assert_eq!(indices(&file(1, 0, &[0b1010_0000, 0, 0, 0, 0, 0, 0, 0])), Some(vec![0, 0, 0, 1, 0, 1]));
        assert_eq!(indices(&file(24, 0, &[0; 24])), None);
    }

    #[test]
    fn broken_files_have_none() {
        let whole = file(8, 1, &[3, 3, 0, 2, 1, 1, 0, 3, 1, 2, 1, 0]);
        for end in 0..whole.len() {
            drop(indices(&whole[..end]));
        }
        assert_eq!(indices(&file(8, 0, &[3])), None);
        // The size of another decoder decides how much memory is reserved.
        let mut huge = file(8, 1, &[0, 1]);
        huge[18..26].fill(0x7f);
        assert_eq!(indices(&huge), None);
        assert_eq!(bmp_palette_indices(&file(8, 1, &[0, 1]), [0, 2]), None);
    }
}
