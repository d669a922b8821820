//! POV-Ray's first sampling method: in blocks of pixels, from the top left, each is compared with those to the left and above, as they are by
//! then; what differs gets a grid of samples (manual, "Anti-Aliasing Options"; blocks and order were measured on POV-Ray 3.7). A block
//! also looks at the row above it and the column to the left, even where those lie outside the picture.
//!
//! Places are counted from there: what the first pass saw at (x + 1, y + 1) is the pixel (x, y).

use super::Region;
use super::antialias::{Difference, pixel};
use super::grid::{Grid, Pixel};
use super::random::Purpose;
use super::trace::Tracer;

/// Edge of a block in pixels.
pub(super) const BLOCK: usize = 32;

/// How samples lie.
pub(super) struct Blocks<'m> {
    pub difference: &'m Difference,
    /// Rows and columns of the grid.
    pub depth: u32,
    /// How far samples are off the middles of their cells at random, of half a cell.
    pub jitter: f64,
    /// Of the picture in pixels.
    pub size: [usize; 2],
}

impl Blocks<'_> {
    /// What the first pass goes over for a region: all of its blocks, and what lies above and to the left.
    pub fn first_area(&self, region: Region) -> Region {
        let start = [region.x, region.y].map(|at| at / BLOCK * BLOCK);
        let end = [region.x + region.width, region.y + region.height].map(|at| at.next_multiple_of(BLOCK));
        let [width, height] = [0, 1].map(|i| end[i].min(self.size[i]) - start[i] + 1);
        Region { x: start[0], y: start[1], width, height }
    }

    /// A pixel of the first pass.
    pub fn first(&self, tracer: &mut Tracer, x: usize, y: usize) -> Pixel {
        tracer.begin(self.number(x, y), 0);
        pixel(&tracer.see(x as f64 - 0.5, y as f64 - 0.5))
    }

    /// The pixels of a part of one block.
    pub fn tile(&self, tracer: &mut Tracer, seen: &Grid, part: Region) -> Vec<Pixel> {
        let area = self.first_area(part);
        let mut now = Grid::new(area);
        now.add(area.height);
        for y in area.y..area.y + area.height {
            let row: Vec<Pixel> = (area.x..area.x + area.width).map(|x| *seen.at(x, y)).collect();
            now.put(Region { y, height: 1, ..area }, &row);
        }
        let mut sampled = vec![false; area.width * area.height];
        for y in area.y..area.y + area.height {
            for x in area.x..area.x + area.width {
                self.look(tracer, &mut now, &mut sampled, [x, y]);
            }
            if tracer.stopped() {
                break;
            }
        }
        let row = |y: usize| (part.x..part.x + part.width).map(move |x| (x + 1, y + 1));
        (part.y..part.y + part.height).flat_map(row).map(|(x, y)| *now.at(x, y)).collect()
    }

    /// Compares a pixel with the one to the left and the one above.
    fn look(&self, tracer: &mut Tracer, now: &mut Grid, sampled: &mut [bool], [x, y]: [usize; 2]) {
        let mut differs = false;
        let (left, above) = ((x > now.area.x).then(|| [x - 1, y]), (y > now.area.y).then(|| [x, y - 1]));
        for other in [left, above].into_iter().flatten() {
            if self.difference.counts(now.at(x, y), now.at(other[0], other[1])) {
                differs = true;
                self.sample_once(tracer, now, sampled, other);
            }
        }
        if differs {
            self.sample_once(tracer, now, sampled, [x, y]);
        }
    }

    /// What lies outside of the block stays as it was first seen.
    fn sample_once(&self, tracer: &mut Tracer, now: &mut Grid, sampled: &mut [bool], [x, y]: [usize; 2]) {
        if x == now.area.x || y == now.area.y {
            return;
        }
        let known = &mut sampled[(y - now.area.y) * now.area.width + x - now.area.x];
        if !std::mem::replace(known, true) {
            let pixel = self.resample(tracer, [x, y], now.at(x, y));
            now.put(Region { x, y, width: 1, height: 1 }, &[pixel]);
        }
    }

    /// The mean of one sample in each cell of a grid, at a random place of it, and of the sample in the middle.
    fn resample(&self, tracer: &mut Tracer, [x, y]: [usize; 2], middle: &Pixel) -> Pixel {
        let Self { depth, jitter, .. } = *self;
        let mut sum = middle.map(f64::from);
        for cell in 0..depth * depth {
            tracer.begin(self.number(x, y), u64::from(cell) + 1);
            let random = tracer.random.row(Purpose::Place);
            let off = |i| if jitter == 0.0 { 0.5 } else { 0.5 + (random.at(i) - 0.5) * jitter };
            let dx = (f64::from(cell % depth) + off(0)) / f64::from(depth);
            let dy = (f64::from(cell / depth) + off(1)) / f64::from(depth);
            let sample = pixel(&tracer.see(x as f64 - 1.0 + dx, y as f64 - 1.0 + dy));
            sum.iter_mut().zip(sample).for_each(|(sum, c)| *sum += f64::from(c));
        }
        sum.map(|c| (c / f64::from(depth * depth + 1)) as f32)
    }

    /// A number for each place, whatever part of the picture is drawn.
    fn number(&self, x: usize, y: usize) -> u64 {
        y as u64 * (self.size[0] as u64 + 1) + x as u64
    }
}
