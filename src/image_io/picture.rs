//! A picture that a scene uses: its samples, and the information in its file about them.

use super::{Decoded, Pixels, Samples, decode_picture_bytes};
use crate::color::GRAY_WEIGHTS;
use crate::diagnostic::Result;
use crate::diagnostic::file;
use crate::source::{Files, ReadError};
use std::path::Path;

/// Relation of a picture file's sample numbers to light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stored {
    /// Samples are used as they are: the formats ppm, tiff, hdr, exr.
    Plain,
    /// The file names no transfer curve; png, jpeg, gif, tga and bmp usually follow the sRGB curve.
    Unsaid,
    /// Samples follow the sRGB curve, according to the file.
    Srgb,
    /// Light is the sample to the power of this, according to the file.
    Power(f64),
}

/// A decoded picture file.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels of the decoded picture.
    pub pixels: Pixels,
    /// Relation of the picture's samples to light.
    pub stored: Stored,
    /// Palette index of each pixel of the decoded picture, row by row from the top, if the file has a palette.
    pub indices: Option<Vec<u8>>,
    /// True if the picture file is a png of grays alone, of up to eight bits each.
    pub gray_bytes: bool,
}

impl Picture {
    /// Decodes a picture file.
    ///
    /// # Errors
    /// E0002 if the file does not exist, E0003 if it can't be read, E0007 if it is not a picture.
    pub fn read(files: &dyn Files, path: &Path) -> Result<Self> {
        let bytes = files.read(path).map_err(|e| file::unreadable(files, path, &ReadError::Io(e)))?;
        let Decoded { mut pixels, mut indices } = decode_picture_bytes(&bytes, path)?;
        let (mut stored, mut gray_bytes) = (Stored::Unsaid, false);
        match &bytes[..] {
            [0x89, b'P', b'N', b'G', ..] => {
                let has_transparent_color;
                PngChunks { stored, indices, has_transparent_color } = read_png_chunks(&bytes);
                if has_transparent_color {
                    pixels = pixels.without_alpha();
                }
                gray_bytes = pixels.channels == 1 && indices.is_none() && matches!(pixels.samples, Samples::U8(_));
            }
            [b'G', b'I', b'F', ..] => indices = gif_indices(&bytes),
            [b'P', b'1'..=b'7', ..] | [b'I', b'I', ..] | [b'M', b'M', ..] | [b'#', b'?', ..] => stored = Stored::Plain,
            [0x76, 0x2f, 0x31, 0x01, ..] => stored = Stored::Plain,
            _ => {}
        }
        let indices = indices.filter(|indices| indices.len() == pixels.width * pixels.height);
        Ok(Self { pixels, stored, indices, gray_bytes })
    }
}

/// Returns POV-Ray's value for a gray sample of a png of grays: rounded down to a byte after the weights have reduced
/// it (quirk: `gray_png_rounds_down`).
pub fn round_gray_like_povray(gray: f32) -> f32 {
    let [r, g, b] = GRAY_WEIGHTS.map(|weight| weight as f32 * gray);
    (((r + g) + b) * 255.0).floor().clamp(0.0, 255.0) / 255.0
}

/// Multiplies a function's number by 65535, for the 16 bits of a picture that a function fills. The product is
/// truncated, and wraps for numbers below 0 or above 1 (quirk: `function_picture_wraps`): 0.25 is 16383, 1.001 is 64,
/// and -0.3 is 45876.
pub fn scale_and_wrap_to_u16(x: f32) -> u16 {
    // (the product is rounded to 24 bits before)
    (x * 65535.0) as i64 as u16
}

/// Data in the chunks of a PNG file apart from its colours.
struct PngChunks {
    /// Relation of the samples to light.
    stored: Stored,
    /// Palette index of each pixel; `None` for a file without a palette.
    indices: Option<Vec<u8>>,
    /// True if one colour is declared transparent, which has no effect (quirk: `png_transparent_color`).
    has_transparent_color: bool,
}

impl PngChunks {
    const ABSENT: Self = Self { stored: Stored::Unsaid, indices: None, has_transparent_color: false };
}

/// Reads the chunks of a PNG file; those of a damaged file are as if they were absent.
fn read_png_chunks(bytes: &[u8]) -> PngChunks {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::IDENTITY);
    let Ok(mut reader) = decoder.read_info() else { return PngChunks::ABSENT };
    let info = reader.info();
    let stored = match (info.srgb, info.gama_chunk) {
        (Some(_), _) => Stored::Srgb,
        (None, Some(gamma)) => Stored::Power(1.0 / f64::from(gamma.into_value())),
        (None, None) => Stored::Unsaid,
    };
    if info.color_type != png::ColorType::Indexed {
        return PngChunks { stored, indices: None, has_transparent_color: info.trns.is_some() };
    }
    let (width, depth) = (info.width as usize, info.bit_depth as usize);
    let Some(size) = reader.output_buffer_size() else { return PngChunks { stored, ..PngChunks::ABSENT } };
    let mut packed = vec![0; size];
    let Ok(frame) = reader.next_frame(&mut packed) else { return PngChunks { stored, ..PngChunks::ABSENT } };
    let rows = packed.chunks(frame.line_size).take(frame.height as usize);
    let indices = rows.flat_map(|row| (0..width).map(move |x| packed_sample(row, x, depth))).collect();
    PngChunks { stored, indices: Some(indices), has_transparent_color: false }
}

/// Returns the sample at column `x` of a picture's row with `bits_per_sample` bits a sample (1, 2, 4 or 8), the first in the
/// highest bits.
fn packed_sample(row: &[u8], x: usize, bits_per_sample: usize) -> u8 {
    let per_byte = 8 / bits_per_sample;
    let shift = 8 - bits_per_sample * (x % per_byte + 1);
    let byte = row.get(x / per_byte).copied().unwrap_or(0);
    if bits_per_sample == 8 { byte } else { (byte >> shift) & ((1 << bits_per_sample) - 1) }
}

/// Returns the palette indices of a gif's first frame.
fn gif_indices(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::Indexed);
    let mut decoder = options.read_info(bytes).ok()?;
    let frame = decoder.read_next_frame().ok()??;
    Some(frame.buffer.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_numbers_share_a_byte() {
        let row = [0b1101_0010, 0b0100_0000];
        assert_eq!([0, 1, 2, 3, 4].map(|x| packed_sample(&row, x, 2)), [3, 1, 0, 2, 1]);
        assert_eq!([0, 1, 2].map(|x| packed_sample(&row, x, 4)), [13, 2, 4]);
        assert_eq!([0, 1].map(|x| packed_sample(&row, x, 8)), [210, 64]);
    }
}
