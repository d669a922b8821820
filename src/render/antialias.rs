//! Adaptive anti-aliasing (manual, "Anti-Aliasing Options"): a first pass takes one sample for each pixel, or one for each corner; the
//! second one takes more where those differ.

use super::blocks::{BLOCK, Blocks};
use super::corners::Corners;
use super::grid::{Grid, Pixel};
use super::trace::{Sample, Setup, Tracer};
use super::{Options, Region, Sampling, Spread, blur, net};
use crate::camera::Lens;
use crate::color::Gamma;
use crate::math::fp;

/// How the pixels of a picture come to be.
pub(super) struct Method {
    kind: Kind,
    sampling: Sampling,
    difference: Difference,
    width: usize,
    height: usize,
}

#[derive(Clone)]
enum Kind {
    /// One sample a pixel.
    Once,
    /// What is blurred needs no second pass.
    Blurred(Lens),
    Adaptive(Spread),
}

impl Method {
    pub fn new(setup: &Setup, options: &Options) -> Self {
        let sampling = options.sampling;
        // From 1 on no difference counts (measured on 3.7).
        let threshold = options.antialias.filter(|threshold| *threshold < 1.0 || sampling.spread == Spread::Corners);
        let kind = match (setup.world.eye.lens.clone(), threshold) {
            (Some(lens), _) => Kind::Blurred(lens),
            (None, Some(_)) => Kind::Adaptive(sampling.spread),
            (None, None) => Kind::Once,
        };
        let difference = Difference::new(threshold.unwrap_or(0.0), sampling.gamma, setup.world.gamma, options.alpha);
        Self { kind, sampling, difference, width: options.width, height: options.height }
    }

    /// What the first pass goes over, if there is one: also the pixels around a region, whose differences count too. So a region
    /// looks as it does in the whole picture.
    pub fn first_area(&self, region: Region) -> Option<Region> {
        match self.kind {
            Kind::Once | Kind::Blurred(_) => None,
            Kind::Adaptive(Spread::Grid) => Some(self.blocks().first_area(region)),
            Kind::Adaptive(Spread::Corners) => {
                Some(Region { width: region.width + 1, height: region.height + 1, ..region })
            }
            Kind::Adaptive(Spread::Net) => {
                let (x, y) = (region.x.saturating_sub(1), region.y.saturating_sub(1));
                let (right, bottom) = (region.x + region.width + 1, region.y + region.height + 1);
                Some(Region { x, y, width: right.min(self.width) - x, height: bottom.min(self.height) - y })
            }
        }
    }

    /// A pixel or corner of the first pass.
    pub fn first(&self, tracer: &mut Tracer, x: usize, y: usize) -> Pixel {
        match self.kind {
            Kind::Adaptive(Spread::Corners) => return self.corners().sample(tracer, [x, y], [0, 0]),
            Kind::Adaptive(Spread::Grid) => return self.blocks().first(tracer, x, y),
            _ => {}
        }
        tracer.begin(self.number(x, y), 0);
        pixel(&tracer.see(x as f64 + 0.5, y as f64 + 0.5))
    }

    /// Tiles of the second pass begin at multiples of this; and the first pass must know all that lies in a tile's rows down to one.
    pub fn tile_edge(&self) -> Option<usize> {
        matches!(self.kind, Kind::Adaptive(Spread::Grid)).then_some(BLOCK)
    }

    /// Some pixels of the picture, row by row, from what the first pass saw there and around them.
    pub fn tile(&self, tracer: &mut Tracer, seen: &Grid, area: Region) -> Vec<Pixel> {
        if let Kind::Adaptive(Spread::Grid) = self.kind {
            return self.blocks().tile(tracer, seen, area).into_iter().map(finished).collect();
        }
        let mut pixels = Vec::with_capacity(area.width * area.height);
        for y in area.y..area.y + area.height {
            pixels.extend((area.x..area.x + area.width).map(|x| self.second(tracer, seen, x, y)));
            if tracer.stopped() {
                break;
            }
        }
        pixels
    }

    /// A pixel of the picture, from what the first pass saw there and around it.
    fn second(&self, tracer: &mut Tracer, seen: &Grid, x: usize, y: usize) -> Pixel {
        finished(match &self.kind {
            Kind::Once => self.first(tracer, x, y),
            Kind::Blurred(lens) => blur::pixel(tracer, lens, self.number(x, y), x, y),
            Kind::Adaptive(Spread::Corners) => self.corners().pixel(tracer, seen, x, y),
            Kind::Adaptive(_) if self.is_rough(seen, x, y) => {
                net::pixel(tracer, &self.difference, self.number(x, y), [x, y], seen.at(x, y))
            }
            Kind::Adaptive(_) => *seen.at(x, y),
        })
    }

    fn blocks(&self) -> Blocks<'_> {
        let Sampling { depth, jitter, .. } = self.sampling;
        Blocks { difference: &self.difference, depth, jitter, size: [self.width, self.height] }
    }

    fn corners(&self) -> Corners<'_> {
        let Sampling { depth, jitter, .. } = self.sampling;
        Corners { difference: &self.difference, depth, jitter, width: self.width }
    }

    /// Does the pixel differ from one of those around?
    fn is_rough(&self, seen: &Grid, x: usize, y: usize) -> bool {
        let middle = seen.at(x, y);
        let place = |[right, down]: &[isize; 2]| (x.wrapping_add_signed(*right), y.wrapping_add_signed(*down));
        let mut others = AROUND.iter().map(place).filter_map(|(x, y)| seen.get(x, y));
        others.any(|other| self.difference.counts(middle, other))
    }

    /// A number for each pixel of the whole picture, whatever part of it is drawn.
    fn number(&self, x: usize, y: usize) -> u64 {
        y as u64 * self.width as u64 + x as u64
    }
}

/// The neighbours, those that share an edge first.
const AROUND: [[isize; 2]; 8] = [[-1, 0], [1, 0], [0, -1], [0, 1], [-1, -1], [1, -1], [-1, 1], [1, 1]];

/// Which differences count.
pub(super) struct Difference {
    threshold: f64,
    /// Differences are judged after this (`Antialias_Gamma`).
    gamma: f64,
    /// Is that to be applied to what the sRGB curve makes of the numbers?
    is_srgb: bool,
    alpha: bool,
    /// How steep that curve is at most from [`DARK`] on, and at least up to 1.
    slopes: [f64; 2],
    /// Numbers that differ by no more than this differ by no more than a quarter of the threshold on the curve, wherever they are.
    little: f64,
}

const DARK: f64 = 1.0 / 32.0;

impl Difference {
    /// It is light to the power of 1/`gamma` that is judged, and `numbers` tells which light they are (both measured on POV-Ray 3.7).
    fn new(threshold: f64, gamma: f64, numbers: Gamma, alpha: bool) -> Self {
        let (gamma, is_srgb) = match numbers {
            Gamma::Power(power) => (gamma / power, false),
            Gamma::Raw => (gamma, false),
            Gamma::Srgb => (gamma, true),
        };
        // The slope of x^(1/γ), which falls where γ is more than 1; and there no step is as high as that from 0. So most neighbours
        // need no powers.
        let (slopes, little) = match gamma >= 1.0 && !is_srgb {
            true => ([fp::pow(DARK, 1.0 / gamma - 1.0) / gamma, 1.0 / gamma], fp::pow(threshold * 0.25, gamma)),
            false => ([f64::INFINITY, 0.0], 0.0),
        };
        Self { threshold, gamma, is_srgb, alpha, slopes, little }
    }

    /// Does the sum of the channels' differences reach the threshold, after the gamma?
    pub fn counts(&self, a: &Pixel, b: &Pixel) -> bool {
        self.exceeds(a, b, 1.0)
    }

    /// Does it reach so many thresholds?
    pub fn exceeds(&self, a: &Pixel, b: &Pixel, times: f64) -> bool {
        let threshold = self.threshold * times;
        let opacity = if self.alpha { f64::from((a[3] - b[3]).abs()) } else { 0.0 };
        // A threshold of 0 lets all count (measured on POV-Ray 3.7).
        if threshold <= 0.0 || a == b {
            return threshold <= 0.0;
        }
        let pairs = [0, 1, 2].map(|c| (f64::from(a[c]).max(0.0), f64::from(b[c]).max(0.0)));
        let (mut most, mut least) = (opacity, opacity);
        for &(a, b) in &pairs {
            let (difference, [low, high]) = ((a - b).abs(), [a.min(b), a.max(b)]);
            most += match low >= DARK {
                true => self.slopes[0] * difference,
                false if difference <= self.little => threshold * 0.25,
                false => f64::INFINITY,
            };
            least += if high <= 1.0 { self.slopes[1] * difference } else { 0.0 };
        }
        if most < threshold || least > threshold * 1.000_001 {
            return most >= threshold;
        }
        let light = |x: f64| if self.is_srgb { Gamma::Srgb.decode(x) } else { x };
        let curve = |x: f64| fp::pow(light(x), 1.0 / self.gamma);
        pairs.iter().map(|(a, b)| (curve(*a) - curve(*b)).abs()).sum::<f64>() + opacity >= threshold
    }
}

pub(super) fn pixel(sample: &Sample) -> Pixel {
    let Sample { rgb, passed } = sample;
    [rgb.x as f32, rgb.y as f32, rgb.z as f32, *passed as f32]
}

/// A pixel, one of whose samples is not a number, is black (measured on POV-Ray 3.7).
fn finished(pixel: Pixel) -> Pixel {
    pixel.map(|c| if c.is_nan() { 0.0 } else { c })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_count_as_in_pov_ray() {
        // The least differences of gray that POV-Ray 3.7 takes more samples for (`+A0.3`, `+A0.6`).
        for (numbers, gamma, threshold, from, difference) in [
            (Gamma::Power(1.0), 2.5, 0.3, 0.0, 0.00317),
            (Gamma::Power(1.0), 2.5, 0.6, 0.2, 0.24803),
            (Gamma::Power(2.2), 2.5, 0.3, 0.0, 0.07306),
            (Gamma::Power(2.2), 2.5, 0.6, 0.5, 0.21391),
            (Gamma::Power(1.5), 2.5, 0.3, 0.2, 0.09502),
            (Gamma::Srgb, 2.5, 0.3, 0.02, 0.09685),
            (Gamma::Srgb, 2.5, 0.3, 0.3, 0.10579),
            (Gamma::Raw, 2.5, 0.3, 0.02, 0.03313),
            (Gamma::Power(1.0), 1.0, 0.3, 0.3, 0.10001),
            (Gamma::Power(2.2), 1.0, 0.3, 0.02, 0.33141),
        ] {
            let judge = Difference::new(threshold, gamma, numbers, false);
            let gray = |x: f64| [x as f32, x as f32, x as f32, 0.0];
            let counts = |by: f64| judge.counts(&gray(from), &gray(from + by));
            assert!(counts(difference + 1e-4) && !counts(difference - 1e-4), "{numbers:?} {gamma} {threshold} {from}");
        }
    }
}
