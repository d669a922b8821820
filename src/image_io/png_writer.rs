//! PNG files (the specification's third edition, W3C 2025), row by row.

use super::encode::{EncodeError, Encoded, Encoding};
use crate::color::Gamma;
use crate::math::fp;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::Write;

/// Half way between speed and size.
const LEVEL: Compression = Compression::new(6);
/// The packed bytes of a chunk, about.
const CHUNK: usize = 1 << 16;
const SIGNATURE: [u8; 8] = [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n'];

/// A file to be.
pub(super) struct PngWriter<W: Write> {
    out: W,
    packed: ZlibEncoder<Vec<u8>>,
    /// Bytes a row, and a pixel.
    stride: usize,
    pixel: usize,
    /// The last row, as it is.
    above: Vec<u8>,
    /// The row in each of the five ways of writing it.
    filtered: [Vec<u8>; 5],
    measure: Measure,
}

impl<W: Write> PngWriter<W> {
    /// Writes all that stands before the pixels.
    pub fn new(mut out: W, width: usize, height: usize, encoding: &Encoding) -> Encoded<Self> {
        let side = |side: usize| i32::try_from(side).map_err(|_| EncodeError::Format("it is too large".into()));
        // Bit 1 stands for colours, bit 2 for alpha.
        let color = if encoding.gray { 0 } else { 2 } | if encoding.keeps_alpha() { 4 } else { 0 };
        out.write_all(&SIGNATURE)?;
        let mut header = [side(width)?.to_be_bytes(), side(height)?.to_be_bytes()].concat();
        header.extend([encoding.depth, color, 0, 0, 0]);
        chunk(&mut out, b"IHDR", &header)?;
        // What the numbers mean: 1/γ in hundred thousandths, and for the sRGB curve also that it is this one.
        let (gamma, srgb) = match encoding.gamma {
            Gamma::Power(gamma) => (100_000.0 / gamma, false),
            Gamma::Srgb | Gamma::Raw => (45_455.0, true),
        };
        chunk(&mut out, b"gAMA", &(gamma.round() as u32).to_be_bytes())?;
        if srgb {
            chunk(&mut out, b"sRGB", &[0])?;
        }
        let pixel = encoding.channels() * usize::from(encoding.depth / 8);
        let stride = width * pixel;
        let packed = ZlibEncoder::new(Vec::with_capacity(2 * CHUNK), LEVEL);
        Ok(Self {
            out,
            packed,
            stride,
            pixel,
            above: vec![0; stride],
            filtered: [const { vec![] }; 5],
            measure: Measure::new(stride),
        })
    }

    /// Some whole rows; 16-bit samples have the high byte first.
    pub fn rows(&mut self, rows: &[u8]) -> Encoded {
        for row in rows.chunks(self.stride) {
            filter(&mut self.filtered, row, &self.above, self.pixel);
            let orders = self.filtered.each_ref().map(|row| self.measure.order(row));
            let best = (1..5).fold(0, |best, kind| if orders[kind] > orders[best] { kind } else { best });
            self.packed.write_all(&[best as u8])?;
            self.packed.write_all(&self.filtered[best])?;
            self.above.copy_from_slice(row);
            if self.packed.get_ref().len() >= CHUNK {
                chunk(&mut self.out, b"IDAT", self.packed.get_ref())?;
                self.packed.get_mut().clear();
            }
        }
        Ok(())
    }

    /// Ends the file.
    pub fn finish(mut self) -> Encoded {
        let rest = self.packed.finish()?;
        chunk(&mut self.out, b"IDAT", &rest)?;
        chunk(&mut self.out, b"IEND", &[])?;
        Ok(self.out.flush()?)
    }
}

/// Length, name, content, and the checksum of both.
fn chunk(out: &mut impl Write, name: &[u8; 4], content: &[u8]) -> Encoded {
    let mut sum = crc32fast::Hasher::new();
    sum.update(name);
    sum.update(content);
    out.write_all(&(content.len() as u32).to_be_bytes())?;
    out.write_all(name)?;
    out.write_all(content)?;
    Ok(out.write_all(&sum.finalize().to_be_bytes())?)
}

/// A row as it is, and less what its neighbours let expect: to the left, above, the mean of both, and the nearest to left + above − left above.
fn filter(out: &mut [Vec<u8>; 5], row: &[u8], above: &[u8], pixel: usize) {
    out.iter_mut().for_each(|out| out.resize(row.len(), 0));
    let [none, sub, up, average, paeth] = out;
    none.copy_from_slice(row);
    for i in 0..pixel.min(row.len()) {
        let (x, b) = (row[i], above[i]);
        (sub[i], up[i], average[i], paeth[i]) = (x, x.wrapping_sub(b), x.wrapping_sub(b / 2), x.wrapping_sub(b));
    }
    let all = row.iter().zip(&row[pixel..]).zip(above.iter().zip(&above[pixel..]));
    let out = sub[pixel..].iter_mut().zip(&mut up[pixel..]).zip(average[pixel..].iter_mut().zip(&mut paeth[pixel..]));
    for (((sub, up), (average, paeth)), ((&a, &x), (&c, &b))) in out.zip(all) {
        *sub = x.wrapping_sub(a);
        *up = x.wrapping_sub(b);
        *average = x.wrapping_sub(((u16::from(a) + u16::from(b)) / 2) as u8);
        *paeth = x.wrapping_sub(expected(a, b, c));
    }
}

/// The one of three neighbours that is nearest to `a + b - c` (Paeth, Image file compression made easy, Graphics Gems II, 1991).
fn expected(a: u8, b: u8, c: u8) -> u8 {
    let [a, b, c] = [a, b, c].map(i16::from);
    let (to_a, to_b, to_c) = ((b - c).abs(), (a - c).abs(), (a + b - 2 * c).abs());
    let near = if to_a <= to_b && to_a <= to_c {
        a
    } else if to_b <= to_c {
        b
    } else {
        c
    };
    near as u8
}

/// Tells how small deflate will make a row.
struct Measure {
    /// n·ln n, for each number of bytes in a row.
    amounts: Vec<f64>,
}

impl Measure {
    fn new(stride: usize) -> Self {
        let amount = |n: usize| n as f64 * fp::ln(n.max(1) as f64);
        Self { amounts: (0..=stride).map(amount).collect() }
    }

    /// How far the bytes of a row are from being all different: the entropy of n bytes, of which nᵢ are alike, is n·ln n − Σ nᵢ·ln nᵢ
    /// (Shannon 1948).
    fn order(&self, row: &[u8]) -> f64 {
        // Four counts at once: equal bytes in a row would wait for each other.
        let mut counts = [[0u32; 256]; 4];
        for bytes in row.chunks(4) {
            counts.iter_mut().zip(bytes).for_each(|(counts, &byte)| counts[usize::from(byte)] += 1);
        }
        let [a, b, c, d] = &counts;
        (0..256).map(|i| self.amounts[(a[i] + b[i] + c[i] + d[i]) as usize]).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_of_writing_a_row_can_be_read_back() {
        let (above, row) = ([7, 9, 200, 3, 255, 0], [250, 3, 90, 3, 0, 1]);
        let mut filtered = [const { vec![] }; 5];
        filter(&mut filtered, &row, &above, 2);
        for (kind, written) in filtered.iter().enumerate() {
            let mut read: Vec<u8> = vec![];
            for (i, &x) in written.iter().enumerate() {
                let (a, c) = if i < 2 { (0, 0) } else { (read[i - 2], above[i - 2]) };
                let b = above[i];
                let mean = ((u16::from(a) + u16::from(b)) / 2) as u8;
                read.push(x.wrapping_add([0, a, b, mean, expected(a, b, c)][kind]));
            }
            assert_eq!(read, row, "{kind}");
        }
    }

    #[test]
    fn alike_bytes_are_in_order() {
        let measure = Measure::new(8);
        assert!(measure.order(&[1; 8]) > measure.order(&[1, 1, 1, 1, 2, 2, 2, 2]));
        assert_eq!(measure.order(&[0, 1, 2, 3, 4, 5, 6, 7]), 0.0);
    }
}
