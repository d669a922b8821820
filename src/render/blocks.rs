//! POV-Ray's first sampling method (manual, "Anti-Aliasing Options"): each pixel of a block, from the top left, is
//! compared with the present values of the pixels to its left and above; pixels that differ get a grid of samples
//! (quirk: `antialias_blocks`). A block also samples the row above and the column to the left, even outside the
//! picture.
//!
//! Coordinates of first samples are shifted: the first sample at (x + 1, y + 1) is the pixel (x, y).

use super::Region;
use super::antialias::Difference;
use super::pixel_area::{Pixel, PixelArea};
use super::sampler::{SamplePoint, Sampler};
use crate::transport::Purpose;

/// Edge of a block in pixels.
pub(super) const BLOCK: usize = 32;

/// Settings of the sampling method with a grid in each pixel.
pub(super) struct Blocks<'m> {
    pub difference: &'m Difference,
    /// Number of rows, and of columns, of the grid.
    pub depth: u32,
    /// Random displacement of samples from the centres of their cells, as a share of half a cell.
    pub jitter: f64,
    /// Width and height of the picture in pixels.
    pub size: [usize; 2],
}

impl Blocks<'_> {
    /// Area of the first pass for a region: all of its blocks, with one row above and one column to the left.
    pub fn first_area(&self, region: Region) -> Region {
        let start = [region.x, region.y].map(|at| at / BLOCK * BLOCK);
        let end = [region.x + region.width, region.y + region.height].map(|at| at.next_multiple_of(BLOCK));
        let [width, height] = [0, 1].map(|i| end[i].min(self.size[i]) - start[i] + 1);
        Region { x: start[0], y: start[1], width, height }
    }

    /// Returns the point of the first pass's sample at (x, y), which is the pixel (x - 1, y - 1).
    pub fn first_point(&self, x: usize, y: usize) -> SamplePoint {
        let (x_pixels, y_pixels) = (x as f64 - 0.5, y as f64 - 0.5);
        SamplePoint { x_pixels, y_pixels, pixel: self.pixel_key(x, y), sample: 0 }
    }

    /// Computes the pixels of a part of one block.
    pub fn tile_pixels(&self, sampler: &mut Sampler, first_samples: &PixelArea, part: Region) -> Vec<Pixel> {
        let area = self.first_area(part);
        let mut current_pixels = PixelArea::black(area);
        current_pixels.put(first_samples.area, &first_samples.pixels);
        let mut sampled = vec![false; area.width * area.height];
        for y in area.y..area.y + area.height {
            for x in area.x..area.x + area.width {
                self.resample_if_different(sampler, &mut current_pixels, &mut sampled, [x, y]);
            }
            if sampler.is_stopped() {
                break;
            }
        }
        let row = |y: usize| (part.x..part.x + part.width).map(move |x| (x + 1, y + 1));
        (part.y..part.y + part.height).flat_map(row).map(|(x, y)| *current_pixels.at(x, y)).collect()
    }

    /// Compares a pixel with the pixels to the left and above, and takes more samples of those that differ.
    fn resample_if_different(
        &self,
        sampler: &mut Sampler,
        current_pixels: &mut PixelArea,
        sampled: &mut [bool],
        [x, y]: [usize; 2],
    ) {
        let mut differs = false;
        let (left, above) =
            ((x > current_pixels.area.x).then(|| [x - 1, y]), (y > current_pixels.area.y).then(|| [x, y - 1]));
        for other in [left, above].into_iter().flatten() {
            if self.difference.reaches_threshold(current_pixels.at(x, y), current_pixels.at(other[0], other[1])) {
                differs = true;
                self.resample_once(sampler, current_pixels, sampled, other);
            }
        }
        if differs {
            self.resample_once(sampler, current_pixels, sampled, [x, y]);
        }
    }

    /// Takes more samples of a pixel, once, and not in the row above and the column to the left of the block.
    fn resample_once(
        &self,
        sampler: &mut Sampler,
        current_pixels: &mut PixelArea,
        sampled: &mut [bool],
        [x, y]: [usize; 2],
    ) {
        if x == current_pixels.area.x || y == current_pixels.area.y {
            return;
        }
        let known = &mut sampled[(y - current_pixels.area.y) * current_pixels.area.width + x - current_pixels.area.x];
        if !std::mem::replace(known, true) {
            let pixel = self.resample(sampler, [x, y], current_pixels.at(x, y));
            current_pixels.put(Region { x, y, width: 1, height: 1 }, &[pixel]);
        }
    }

    /// Returns the mean of one sample in each cell of a grid, at a random position in the cell, and of the first sample.
    fn resample(&self, sampler: &mut Sampler, [x, y]: [usize; 2], middle: &Pixel) -> Pixel {
        let Self { depth, jitter, .. } = *self;
        let pixel = self.pixel_key(x, y);
        let random = *sampler.random();
        let point = |cell: u32| {
            let sample = u64::from(cell) + 1;
            let random = random.first_sequence(pixel, sample, Purpose::PixelPosition);
            let off = |i| if jitter == 0.0 { 0.5 } else { 0.5 + (random.at(i) - 0.5) * jitter };
            let dx = (f64::from(cell % depth) + off(0)) / f64::from(depth);
            let dy = (f64::from(cell / depth) + off(1)) / f64::from(depth);
            SamplePoint { x_pixels: x as f64 - 1.0 + dx, y_pixels: y as f64 - 1.0 + dy, pixel, sample }
        };
        let mut sum = middle.map(f64::from);
        sampler.samples_at((0..depth * depth).map(point), |_, sample| {
            sum.iter_mut().zip(sample).for_each(|(sum, c)| *sum += f64::from(c));
        });
        sum.map(|c| (c / f64::from(depth * depth + 1)) as f32)
    }

    /// Returns the key of a position's random numbers: its index in the whole picture.
    fn pixel_key(&self, x: usize, y: usize) -> u64 {
        y as u64 * (self.size[0] as u64 + 1) + x as u64
    }
}
