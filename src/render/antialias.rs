//! Adaptive anti-aliasing (manual, "Anti-Aliasing", sampling method 1): first every pixel gets one sample; then those
//! that differ from a neighbour get more. Both passes go over the whole picture, so that no tile sees its own border.

use super::tiles::{Pixel, Workers};
use super::trace::{Sample, Setup, Tracer};
use super::{Cancelled, Options, Rays, Region, blur};
use crate::math::fp;

/// A pixel that differs gets GRID² samples and keeps the one that it had.
const GRID: usize = 3;
/// Differences are judged after this (`Antialias_Gamma`).
const GAMMA: f64 = 2.5;

/// Draws a region of the picture. What is blurred needs no second pass.
pub(super) fn draw(
    setup: &Setup,
    workers: &Workers,
    options: &Options,
    region: Region,
    rays: &mut Rays,
) -> Result<Vec<Pixel>, Cancelled> {
    let once = |tracer: &mut Tracer, x: usize, y: usize| {
        tracer.begin(number(options, x, y), 0);
        pixel(&tracer.see(x as f64 + 0.5, y as f64 + 0.5))
    };
    if let Some(lens) = &setup.world.eye.lens {
        let blurred = |tracer: &mut Tracer, x: usize, y: usize| blur::pixel(tracer, lens, number(options, x, y), x, y);
        return workers.draw(setup, region, rays, |tracer, x, y| finished(blurred(tracer, x, y)));
    }
    let Some(threshold) = threshold(options) else {
        return workers.draw(setup, region, rays, |tracer, x, y| finished(once(tracer, x, y)));
    };
    let area = with_border(options, region);
    let first = workers.draw(setup, area, rays, once)?;
    let rough = rough(&first, area.width, threshold, options.alpha);
    let again = |tracer: &mut Tracer, x: usize, y: usize| {
        let at = (y - area.y) * area.width + x - area.x;
        finished(if rough[at] { resample(tracer, options, x, y, &first[at]) } else { first[at] })
    };
    workers.draw(setup, region, rays, again)
}

/// The least difference that does not count; from 1 on nothing counts (measured on 3.7).
fn threshold(options: &Options) -> Option<f64> {
    options.antialias.filter(|threshold| *threshold < 1.0)
}

/// How many pixels both passes have.
pub(super) fn total(setup: &Setup, options: &Options, region: Region) -> usize {
    let twice = threshold(options).filter(|_| setup.world.eye.lens.is_none());
    let interface = twice.map_or(0, |_| {
        let area = with_border(options, region);
        area.width * area.height
    });
    region.width * region.height + interface
}

/// A region and the pixels around it, whose differences count too: so a region looks as it does in the whole picture.
fn with_border(options: &Options, region: Region) -> Region {
    let (x, y) = (region.x.saturating_sub(1), region.y.saturating_sub(1));
    let (right, bottom) = (region.x + region.width + 1, region.y + region.height + 1);
    Region { x, y, width: right.min(options.width) - x, height: bottom.min(options.height) - y }
}

/// Which pixels differ from the one beside or the one above; both of such a pair do.
fn rough(pixels: &[Pixel], width: usize, threshold: f64, alpha: bool) -> Vec<bool> {
    let mut rough = vec![false; pixels.len()];
    for i in 0..pixels.len() {
        if i % width > 0 && differ(&pixels[i], &pixels[i - 1], threshold, alpha) {
            (rough[i], rough[i - 1]) = (true, true);
        }
        if i >= width && differ(&pixels[i], &pixels[i - width], threshold, alpha) {
            (rough[i], rough[i - width]) = (true, true);
        }
    }
    rough
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

/// The mean of one sample in each cell of a grid, at a random place of it, and of the sample in the middle.
fn resample(tracer: &mut Tracer, options: &Options, x: usize, y: usize, middle: &Pixel) -> Pixel {
    let mut sum = middle.map(f64::from);
    for cell in 0..GRID * GRID {
        tracer.begin(number(options, x, y), cell as u64 + 1);
        let (column, row) = ((cell % GRID) as f64, (cell / GRID) as f64);
        let dx = (column + tracer.random()) / GRID as f64;
        let dy = (row + tracer.random()) / GRID as f64;
        let sample = pixel(&tracer.see(x as f64 + dx, y as f64 + dy));
        sum.iter_mut().zip(sample).for_each(|(sum, c)| *sum += f64::from(c));
    }
    sum.map(|c| (c / (GRID * GRID + 1) as f64) as f32)
}

/// A number for each pixel of the whole picture, whatever part of it is drawn.
fn number(options: &Options, x: usize, y: usize) -> u64 {
    y as u64 * options.width as u64 + x as u64
}

fn pixel(sample: &Sample) -> Pixel {
    let Sample { rgb, passed } = sample;
    [rgb.x as f32, rgb.y as f32, rgb.z as f32, *passed as f32]
}

/// A pixel, one of whose samples is not a number, is black (measured on POV-Ray 3.7).
fn finished(pixel: Pixel) -> Pixel {
    pixel.map(|c| if c.is_nan() { 0.0 } else { c })
}
