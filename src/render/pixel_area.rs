//! Pixels of a rectangle of a picture.

use super::Region;

/// Red, green, blue and transparency of a pixel, in the scene's colour space.
pub(super) type Pixel = [f32; 4];

/// Pixels of a rectangle of a picture.
pub(super) struct PixelArea {
    pub area: Region,
    /// Pixels of the area, row by row.
    pub pixels: Vec<Pixel>,
}

impl PixelArea {
    /// Creates an area of black pixels.
    pub fn black(area: Region) -> Self {
        Self { area, pixels: vec![[0.0; 4]; area.n_pixels()] }
    }

    /// Stores those pixels of a tile that lie within the area.
    pub fn put(&mut self, tile: Region, pixels: &[Pixel]) {
        let overlap = |start: usize, length: usize, other: usize, other_length: usize| {
            start.max(other)..(start + length).min(other + other_length)
        };
        let columns = overlap(self.area.x, self.area.width, tile.x, tile.width);
        for y in overlap(self.area.y, self.area.height, tile.y, tile.height) {
            let (to, from) = (self.index(columns.start, y), (y - tile.y) * tile.width + columns.start - tile.x);
            self.pixels[to..to + columns.len()].copy_from_slice(&pixels[from..from + columns.len()]);
        }
    }

    /// Returns the pixel at (x, y) of the picture.
    ///
    /// # Panics
    /// If the pixel is outside of the area.
    pub fn at(&self, x: usize, y: usize) -> &Pixel {
        &self.pixels[self.index(x, y)]
    }

    /// Returns the pixel at (x, y) of the picture; `None` outside of the area.
    pub fn get(&self, x: usize, y: usize) -> Option<&Pixel> {
        let Region { x: left, y: top, width, height } = self.area;
        ((left..left + width).contains(&x) && (top..top + height).contains(&y)).then(|| self.at(x, y))
    }

    fn index(&self, x: usize, y: usize) -> usize {
        (y - self.area.y) * self.area.width + x - self.area.x
    }
}
