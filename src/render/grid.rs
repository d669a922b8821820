//! Pixels of some rows of an area.

use super::Region;

/// Red, green, blue and what shows of the background, in the numbers of the scene.
pub(super) type Pixel = [f32; 4];

/// Rows that lie below each other; those above can be forgotten, and others added below.
pub(super) struct Grid {
    /// The rows that are here.
    pub area: Region,
    /// Row by row.
    pub pixels: Vec<Pixel>,
}

impl Grid {
    /// As wide as the area, from its top; without any row yet.
    pub fn new(area: Region) -> Self {
        Self { area: Region { height: 0, ..area }, pixels: vec![] }
    }

    /// The row below the last one.
    pub fn bottom(&self) -> usize {
        self.area.y + self.area.height
    }

    /// So many more rows.
    pub fn add(&mut self, rows: usize) {
        self.area.height += rows;
        self.pixels.resize(self.area.width * self.area.height, [0.0; 4]);
    }

    /// Lets go of the rows above this one.
    pub fn forget(&mut self, above: usize) {
        let rows = above.saturating_sub(self.area.y).min(self.area.height);
        self.pixels.drain(..rows * self.area.width);
        (self.area.y, self.area.height) = (self.area.y + rows, self.area.height - rows);
    }

    /// Takes the pixels of a tile of it.
    pub fn put(&mut self, tile: Region, pixels: &[Pixel]) {
        for (row, line) in pixels.chunks(tile.width).enumerate() {
            let start = self.index(tile.x, tile.y + row);
            self.pixels[start..start + tile.width].copy_from_slice(line);
        }
    }

    /// The pixel at a place of the picture.
    pub fn at(&self, x: usize, y: usize) -> &Pixel {
        &self.pixels[self.index(x, y)]
    }

    /// The pixel at a place, if it is here.
    pub fn get(&self, x: usize, y: usize) -> Option<&Pixel> {
        let Region { x: left, y: top, width, height } = self.area;
        ((left..left + width).contains(&x) && (top..top + height).contains(&y)).then(|| self.at(x, y))
    }

    fn index(&self, x: usize, y: usize) -> usize {
        (y - self.area.y) * self.area.width + x - self.area.x
    }
}
