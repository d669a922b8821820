//! A rendered picture in memory.

use super::quantize;

/// Picture of linear light, row by row from the top left; four numbers a pixel: red, green, blue (linear sRGB
/// primaries, 1 is white, not clamped, not multiplied by alpha) and alpha (1 is opaque).
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Width of the picture in pixels.
    pub width: usize,
    /// Height of the picture in pixels.
    pub height: usize,
    /// Pixels of the picture, `width * height` in number.
    pub pixels: Vec<[f32; 4]>,
}

impl Frame {
    /// Creates a transparent black picture.
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![[0.0; 4]; width * height] }
    }

    /// Composites the picture over black.
    pub fn over_black(&self) -> Self {
        let opaque = |&p: &[f32; 4]| {
            let [r, g, b] = quantize::composite_over_black(p);
            [r, g, b, 1.0]
        };
        Self { width: self.width, height: self.height, pixels: self.pixels.iter().map(opaque).collect() }
    }

    /// Encodes the picture as in an 8-bit file: the sRGB curve, red, green, blue and alpha.
    pub fn rgba8(&self) -> Vec<[u8; 4]> {
        quantize::encode_srgb8(&self.pixels, true).as_chunks().0.to_vec()
    }
}
