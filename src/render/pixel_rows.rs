//! Consecutive rows of a picture, a window that moves down while the picture is rendered.

use super::Region;

/// Red, green, blue and transparency of a pixel, in the scene's colour space.
pub(super) type Pixel = [f32; 4];

/// Consecutive rows of an area; rows are added at the bottom and dropped at the top.
pub(super) struct PixelRows {
    /// Rectangle of the picture that the stored rows of pixels cover.
    pub area: Region,
    /// Pixels of the stored rows, row by row.
    pub pixels: Vec<Pixel>,
}

impl PixelRows {
    /// Creates a store for the pixel rows of an area, which begins at the area's top and holds no row yet.
    pub fn new(area: Region) -> Self {
        Self { area: Region { height: 0, ..area }, pixels: vec![] }
    }

    /// Returns the row number below the last stored row.
    pub fn end_row(&self) -> usize {
        self.area.y + self.area.height
    }

    /// Adds black rows below the last row.
    pub fn add_black_rows(&mut self, rows: usize) {
        self.area.height += rows;
        self.pixels.resize(self.area.width * self.area.height, [0.0; 4]);
    }

    /// Drops the rows above row `y`.
    pub fn drop_above(&mut self, y: usize) {
        let rows = y.saturating_sub(self.area.y).min(self.area.height);
        self.pixels.drain(..rows * self.area.width);
        (self.area.y, self.area.height) = (self.area.y + rows, self.area.height - rows);
    }

    /// Stores the pixels of a tile that lies within the area.
    pub fn put(&mut self, tile: Region, pixels: &[Pixel]) {
        for (row, line) in pixels.chunks(tile.width).enumerate() {
            let start = self.index(tile.x, tile.y + row);
            self.pixels[start..start + tile.width].copy_from_slice(line);
        }
    }

    /// Returns the pixel at (x, y) of the picture.
    ///
    /// # Panics
    /// If the pixel is not stored.
    pub fn at(&self, x: usize, y: usize) -> &Pixel {
        &self.pixels[self.index(x, y)]
    }

    /// Returns the pixel at (x, y) of the picture; `None` if the pixel is not stored.
    pub fn get(&self, x: usize, y: usize) -> Option<&Pixel> {
        let Region { x: left, y: top, width, height } = self.area;
        ((left..left + width).contains(&x) && (top..top + height).contains(&y)).then(|| self.at(x, y))
    }

    fn index(&self, x: usize, y: usize) -> usize {
        (y - self.area.y) * self.area.width + x - self.area.x
    }
}
