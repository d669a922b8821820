//! A picture in memory.

/// Linear light, row by row from the top left; four numbers a pixel: red, green, blue (linear sRGB primaries, 1 is white, not
/// clamped, not multiplied by alpha) and alpha (1 is opaque).
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// `width * height` pixels.
    pub pixels: Vec<[f32; 4]>,
}

impl Frame {
    /// All transparent black.
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![[0.0; 4]; width * height] }
    }
}
