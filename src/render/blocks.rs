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
use crate::transport::{Purpose, Random};

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
        let mut block = Block::new(self, sampler, first_samples, self.first_area(part));
        block.resample_pixels_that_differ();
        let row = |y: usize| (part.x..part.x + part.width).map(move |x| (x + 1, y + 1));
        (part.y..part.y + part.height).flat_map(row).map(|(x, y)| *block.pixels.at(x, y)).collect()
    }

    /// Returns the points of a pixel's later samples: one in each cell of a grid, at a random position in the cell.
    fn later_points(&self, random: Random, [x, y]: [usize; 2]) -> impl Iterator<Item = SamplePoint> {
        let Self { depth, jitter, .. } = *self;
        let pixel = self.pixel_key(x, y);
        (0..depth * depth).map(move |cell| {
            let sample = u64::from(cell) + 1;
            let random = random.first_sequence(pixel, sample, Purpose::PixelPosition);
            let off = |i| if jitter == 0.0 { 0.5 } else { 0.5 + (random.at(i) - 0.5) * jitter };
            let dx = (f64::from(cell % depth) + off(0)) / f64::from(depth);
            let dy = (f64::from(cell / depth) + off(1)) / f64::from(depth);
            SamplePoint { x_pixels: x as f64 - 1.0 + dx, y_pixels: y as f64 - 1.0 + dy, pixel, sample }
        })
    }

    /// Returns the key of a position's random numbers: its index in the whole picture.
    fn pixel_key(&self, x: usize, y: usize) -> u64 {
        y as u64 * (self.size[0] as u64 + 1) + x as u64
    }
}

/// A block whose pixels are compared one after the other. Pixels have numbers, row by row.
struct Block<'b, 'm, 't, 'w> {
    blocks: &'b Blocks<'m>,
    sampler: &'t mut Sampler<'w>,
    /// Present values of the pixels.
    pixels: PixelArea,
    /// True for the pixels whose present value is the mean of all of their samples.
    is_resampled: Vec<bool>,
    /// For each pixel, whether its first sample differs from those to the left and above.
    differs: Vec<[bool; 2]>,
    /// Means of the samples of some pixels that will probably be needed; empty if there are none.
    foreseen: Vec<Option<Pixel>>,
}

impl<'b, 'm, 't, 'w> Block<'b, 'm, 't, 'w> {
    fn new(blocks: &'b Blocks<'m>, sampler: &'t mut Sampler<'w>, first_samples: &PixelArea, area: Region) -> Self {
        let mut pixels = PixelArea::black(area);
        pixels.put(first_samples.area, &first_samples.pixels);
        let is_resampled = vec![false; area.n_pixels()];
        Self { blocks, sampler, pixels, is_resampled, differs: vec![], foreseen: vec![] }
    }

    /// Returns the numbers of the pixels to the left of a pixel and above it, where there are some.
    fn neighbours(&self, number: usize) -> [Option<usize>; 2] {
        let width = self.pixels.area.width;
        [(!number.is_multiple_of(width)).then(|| number - 1), number.checked_sub(width)]
    }

    /// True if two pixels differ by their present values.
    fn differ(&self, number: usize, other: usize) -> bool {
        self.blocks.difference.reaches_threshold(&self.pixels.pixels[number], &self.pixels.pixels[other])
    }

    /// Compares each pixel with the pixels to the left and above, and takes more samples of those that differ. The block is
    /// incomplete if the render is cancelled.
    fn resample_pixels_that_differ(&mut self) {
        let differs_from = |i, other: Option<usize>| other.is_some_and(|other| self.differ(i, other));
        let differs = |i| {
            let [left, above] = self.neighbours(i);
            [differs_from(i, left), differs_from(i, above)]
        };
        self.differs = (0..self.is_resampled.len()).map(differs).collect();
        if self.sampler.is_quicker_with_many_points() {
            self.foresee();
        }
        for number in 0..self.differs.len() {
            if self.resample_if_different(number) && self.sampler.is_stopped() {
                break;
            }
        }
    }

    /// Takes more samples of the pixels whose first samples differ, since their means will be needed, except for a few percent of
    /// them: the samples of many pixels together are taken more quickly than those of one pixel after the other.
    fn foresee(&mut self) {
        let mut is_wanted = vec![false; self.differs.len()];
        for (number, differs) in self.differs.iter().enumerate() {
            for (other, differs) in self.neighbours(number).into_iter().zip(*differs) {
                if let Some(other) = other.filter(|_| differs) {
                    (is_wanted[number], is_wanted[other]) = (true, true);
                }
            }
        }
        let wanted: Vec<usize> = (0..is_wanted.len()).filter(|i| is_wanted[*i] && self.may_be_resampled(*i)).collect();
        if !wanted.is_empty() {
            let mut means = vec![None; is_wanted.len()];
            self.visit_means(&wanted, |number, mean| means[number] = Some(mean));
            self.foreseen = means;
        }
    }

    /// Takes more samples of a pixel and of the pixels to the left and above from which it differs. True if there are such pixels.
    fn resample_if_different(&mut self, number: usize) -> bool {
        let mut any_differs = false;
        for (other, first_differ) in self.neighbours(number).into_iter().zip(self.differs[number]) {
            let Some(other) = other else { continue };
            if if self.is_resampled[other] { self.differ(number, other) } else { first_differ } {
                any_differs = true;
                self.resample_once(other);
            }
        }
        if any_differs {
            self.resample_once(number);
        }
        any_differs
    }

    /// True except in the row above and the column to the left of the block.
    fn may_be_resampled(&self, number: usize) -> bool {
        let width = self.pixels.area.width;
        number >= width && !number.is_multiple_of(width)
    }

    /// Replaces a pixel by the mean of all of its samples, once, if it may be resampled.
    fn resample_once(&mut self, number: usize) {
        if !self.may_be_resampled(number) || std::mem::replace(&mut self.is_resampled[number], true) {
            return;
        }
        let mut mean = self.foreseen.get(number).copied().flatten();
        if mean.is_none() {
            self.visit_means(&[number], |_, found| mean = Some(found));
        }
        if let Some(mean) = mean {
            self.pixels.pixels[number] = mean;
        }
    }

    /// Takes the later samples of pixels, and calls `visit` with the number of each and the mean of its samples and the first one.
    /// Pixels are left out after the render was cancelled.
    fn visit_means(&mut self, numbers: &[usize], mut visit: impl FnMut(usize, Pixel)) {
        let (blocks, random, area) = (self.blocks, *self.sampler.random(), self.pixels.area);
        let position = |number: usize| [area.x + number % area.width, area.y + number / area.width];
        let points = numbers.iter().flat_map(|number| blocks.later_points(random, position(*number)));
        let n_later = (blocks.depth * blocks.depth) as usize;
        let mut sum = [0.0; 4];
        self.sampler.samples_at(points, |i, sample| {
            let number = numbers[i / n_later];
            if i.is_multiple_of(n_later) {
                sum = self.pixels.pixels[number].map(f64::from);
            }
            sum.iter_mut().zip(sample).for_each(|(sum, c)| *sum += f64::from(c));
            if (i + 1).is_multiple_of(n_later) {
                visit(number, sum.map(|c| (c / (n_later + 1) as f64) as f32));
            }
        });
    }
}
