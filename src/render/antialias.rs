//! Adaptive anti-aliasing (manual, "Anti-Aliasing", sampling method 1): first every pixel gets one sample; then those
//! that differ from a neighbour get more.

use super::grid::{Grid, Pixel};
use super::trace::{Sample, Setup, Tracer};
use super::{Options, Region, blur};
use crate::camera::Lens;
use crate::math::fp;

/// A pixel that differs gets GRID² samples and keeps the one that it had.
const GRID: usize = 3;
/// Differences are judged after this (`Antialias_Gamma`).
const GAMMA: f64 = 2.5;

/// How the pixels of a picture come to be.
pub(super) struct Method {
    kind: Kind,
    width: usize,
    height: usize,
    alpha: bool,
}

enum Kind {
    /// One sample a pixel.
    Once,
    /// What is blurred needs no second pass.
    Blurred(Lens),
    /// The least difference that does not count.
    Adaptive(f64),
}

impl Method {
    pub fn new(setup: &Setup, options: &Options) -> Self {
        // From 1 on no difference counts (measured on 3.7).
        let threshold = options.antialias.filter(|threshold| *threshold < 1.0);
        let kind = match (&setup.world.eye.lens, threshold) {
            (Some(lens), _) => Kind::Blurred(lens.clone()),
            (None, Some(threshold)) => Kind::Adaptive(threshold),
            (None, None) => Kind::Once,
        };
        Self { kind, width: options.width, height: options.height, alpha: options.alpha }
    }

    /// What the first pass goes over, if there is one: also the pixels around a region, whose differences count too. So a region
    /// looks as it does in the whole picture.
    pub fn first_area(&self, region: Region) -> Option<Region> {
        let Kind::Adaptive(_) = self.kind else { return None };
        let (x, y) = (region.x.saturating_sub(1), region.y.saturating_sub(1));
        let (right, bottom) = (region.x + region.width + 1, region.y + region.height + 1);
        Some(Region { x, y, width: right.min(self.width) - x, height: bottom.min(self.height) - y })
    }

    /// A pixel of the first pass.
    pub fn first(&self, tracer: &mut Tracer, x: usize, y: usize) -> Pixel {
        tracer.begin(self.number(x, y), 0);
        pixel(&tracer.see(x as f64 + 0.5, y as f64 + 0.5))
    }

    /// A pixel of the picture, from what the first pass saw there and around it.
    pub fn second(&self, tracer: &mut Tracer, seen: &Grid, x: usize, y: usize) -> Pixel {
        finished(match &self.kind {
            Kind::Once => self.first(tracer, x, y),
            Kind::Blurred(lens) => blur::pixel(tracer, lens, self.number(x, y), x, y),
            Kind::Adaptive(threshold) if self.is_rough(seen, x, y, *threshold) => {
                self.resample(tracer, x, y, seen.at(x, y))
            }
            Kind::Adaptive(_) => *seen.at(x, y),
        })
    }

    /// Does the pixel differ from one of those beside, above and below?
    fn is_rough(&self, seen: &Grid, x: usize, y: usize, threshold: f64) -> bool {
        let middle = seen.at(x, y);
        let around = [(x.wrapping_sub(1), y), (x + 1, y), (x, y.wrapping_sub(1)), (x, y + 1)];
        let mut others = around.iter().filter_map(|&(x, y)| seen.get(x, y));
        others.any(|other| differ(middle, other, threshold, self.alpha))
    }

    /// The mean of one sample in each cell of a grid, at a random place of it, and of the sample in the middle.
    fn resample(&self, tracer: &mut Tracer, x: usize, y: usize, middle: &Pixel) -> Pixel {
        let mut sum = middle.map(f64::from);
        for cell in 0..GRID * GRID {
            tracer.begin(self.number(x, y), cell as u64 + 1);
            let (column, row) = ((cell % GRID) as f64, (cell / GRID) as f64);
            let dx = (column + tracer.random()) / GRID as f64;
            let dy = (row + tracer.random()) / GRID as f64;
            let sample = pixel(&tracer.see(x as f64 + dx, y as f64 + dy));
            sum.iter_mut().zip(sample).for_each(|(sum, c)| *sum += f64::from(c));
        }
        sum.map(|c| (c / (GRID * GRID + 1) as f64) as f32)
    }

    /// A number for each pixel of the whole picture, whatever part of it is drawn.
    fn number(&self, x: usize, y: usize) -> u64 {
        y as u64 * self.width as u64 + x as u64
    }
}

/// Is the sum of the channels' differences larger than the threshold, after the gamma?
fn differ(a: &Pixel, b: &Pixel, threshold: f64, alpha: bool) -> bool {
    let opacity = if alpha { f64::from((a[3] - b[3]).abs()) } else { 0.0 };
    let pairs = [0, 1, 2].map(|c| (f64::from(a[c]).max(0.0), f64::from(b[c]).max(0.0)));
    // The curve's slope falls: above 1/32 it is below 32^0.6/2.5 = 3.2, and most neighbours need no powers.
    let steep: f64 =
        pairs.iter().map(|(a, b)| if a.min(*b) >= 1.0 / 32.0 { 3.2 * (a - b).abs() } else { f64::INFINITY }).sum();
    if steep + opacity <= threshold || (a == b && threshold >= 0.0) {
        return false;
    }
    let curve = |x: f64| fp::pow(x, 1.0 / GAMMA);
    pairs.iter().map(|(a, b)| (curve(*a) - curve(*b)).abs()).sum::<f64>() + opacity > threshold
}

fn pixel(sample: &Sample) -> Pixel {
    let Sample { rgb, passed } = sample;
    [rgb.x as f32, rgb.y as f32, rgb.z as f32, *passed as f32]
}

/// A pixel, one of whose samples is not a number, is black (measured on POV-Ray 3.7).
fn finished(pixel: Pixel) -> Pixel {
    pixel.map(|c| if c.is_nan() { 0.0 } else { c })
}
