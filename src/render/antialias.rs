//! Adaptive anti-aliasing (manual, "Anti-Aliasing Options"): the first pass takes one sample for each pixel or corner;
//! the final pass takes more where neighbours differ.

use super::blocks::{BLOCK, Blocks};
use super::corners::Corners;
use super::pixel_area::{Pixel, PixelArea};
use super::sampler::{SamplePoint, Sampler};
use super::{Options, Region, SampleLayout, Sampling, blur, lattice};
use crate::camera::Lens;
use crate::color::Gamma;
use crate::math::fp;
use crate::transport::{Radiance, Random};
use crate::world::World;
use glam::{Vec3A, Vec4};

/// Method that turns samples into the pixels of a picture.
pub(super) struct Method {
    kind: MethodKind,
    sampling: Sampling,
    difference: Difference,
    width: usize,
    height: usize,
}

#[derive(Clone)]
enum MethodKind {
    /// One sample for each pixel.
    Single,
    /// Focal blur: many samples for each pixel, in one pass.
    Blurred(Lens),
    /// Adaptive anti-aliasing in two passes.
    Adaptive(SampleLayout),
}

/// Returns the edge of the blocks that the final pass computes together; `None` without blocks.
pub(super) fn antialias_block_edge(options: &Options) -> Option<usize> {
    (options.antialias.is_some() && options.sampling.layout == SampleLayout::Grid).then_some(BLOCK)
}

impl Method {
    pub fn new(world: &World, lens: Option<&Lens>, options: &Options) -> Self {
        let sampling = options.sampling;
        // quirk: antialias_threshold_1
        let threshold = options.antialias.map(|threshold| threshold.min(1.0));
        let kind = match (lens, threshold) {
            (Some(lens), _) => MethodKind::Blurred(lens.clone()),
            (None, Some(_)) => MethodKind::Adaptive(sampling.layout),
            (None, None) => MethodKind::Single,
        };
        let difference = Difference::new(threshold.unwrap_or(0.0), sampling.gamma, world.gamma, options.alpha);
        Self { kind, sampling, difference, width: options.width, height: options.height }
    }

    /// Area of the first pass for a region; `None` for methods of one pass. The area includes the neighbours of the region, so that a
    /// region looks the same as in the whole picture.
    pub fn first_area(&self, region: Region) -> Option<Region> {
        match self.kind {
            MethodKind::Single | MethodKind::Blurred(_) => None,
            MethodKind::Adaptive(SampleLayout::Grid) => Some(self.blocks().first_area(region)),
            MethodKind::Adaptive(SampleLayout::Corners) => {
                Some(Region { width: region.width + 1, height: region.height + 1, ..region })
            }
            MethodKind::Adaptive(SampleLayout::Lattice) => {
                let (x, y) = (region.x.saturating_sub(1), region.y.saturating_sub(1));
                let (right, bottom) = (region.x + region.width + 1, region.y + region.height + 1);
                Some(Region { x, y, width: right.min(self.width) - x, height: bottom.min(self.height) - y })
            }
        }
    }

    /// Returns the point of the first pass's sample at a pixel or corner.
    fn first_point(&self, random: &Random, x: usize, y: usize) -> SamplePoint {
        match self.kind {
            MethodKind::Adaptive(SampleLayout::Corners) => self.corners().point(random, [x, y], [0, 0]),
            MethodKind::Adaptive(SampleLayout::Grid) => self.blocks().first_point(x, y),
            _ => {
                let (x_pixels, y_pixels) = (x as f64 + 0.5, y as f64 + 0.5);
                SamplePoint { x_pixels, y_pixels, pixel: self.pixel_key(x, y), sample: 0 }
            }
        }
    }

    /// Takes the samples of the first pass in an area, row by row. They are incomplete if the render is cancelled.
    pub fn first_samples(&self, sampler: &mut Sampler, area: Region) -> Vec<Pixel> {
        let mut samples = vec![[0.0; 4]; area.n_pixels()];
        let random = *sampler.random();
        let row = |y: usize| (area.x..area.x + area.width).map(move |x| (x, y));
        let points = (area.y..area.y + area.height).flat_map(row).map(|(x, y)| self.first_point(&random, x, y));
        sampler.samples_at(points, |i, sample| samples[i] = sample);
        samples
    }

    /// Returns the edge of the blocks that the final pass computes together; `None` without blocks. A block needs all
    /// first samples of its rows and one row around.
    pub fn antialias_block_edge(&self) -> Option<usize> {
        matches!(self.kind, MethodKind::Adaptive(SampleLayout::Grid)).then_some(BLOCK)
    }

    /// Computes the pixels of an area, row by row, from the first samples in and around the area. The rows are
    /// incomplete if the render is cancelled.
    pub fn tile_pixels(&self, sampler: &mut Sampler, first_samples: &PixelArea, area: Region) -> Vec<Pixel> {
        if let MethodKind::Adaptive(SampleLayout::Grid) = self.kind {
            return self.blocks().tile_pixels(sampler, first_samples, area).into_iter().map(without_nan).collect();
        }
        let single_samples;
        let first_samples = match self.kind {
            MethodKind::Single => {
                single_samples = PixelArea { area, pixels: self.first_samples(sampler, area) };
                &single_samples
            }
            _ => first_samples,
        };
        let mut pixels = Vec::with_capacity(area.width * area.height);
        for y in area.y..area.y + area.height {
            pixels.extend((area.x..area.x + area.width).map(|x| self.final_pixel(sampler, first_samples, x, y)));
            if sampler.is_stopped() {
                break;
            }
        }
        pixels
    }

    fn final_pixel(&self, sampler: &mut Sampler, first_samples: &PixelArea, x: usize, y: usize) -> Pixel {
        without_nan(match &self.kind {
            MethodKind::Blurred(lens) => blur::pixel(sampler, lens, self.pixel_key(x, y), x, y),
            MethodKind::Adaptive(SampleLayout::Corners) => self.corners().pixel(sampler, first_samples, x, y),
            MethodKind::Adaptive(_) if self.differs_from_neighbours(first_samples, x, y) => {
                let middle = first_samples.at(x, y);
                lattice::pixel(sampler, &self.difference, self.pixel_key(x, y), [x, y], middle)
            }
            MethodKind::Adaptive(_) | MethodKind::Single => *first_samples.at(x, y),
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

    fn differs_from_neighbours(&self, first_samples: &PixelArea, x: usize, y: usize) -> bool {
        let middle = first_samples.at(x, y);
        let position = |[right, down]: &[isize; 2]| (x.wrapping_add_signed(*right), y.wrapping_add_signed(*down));
        let mut neighbours = NEIGHBOURS.iter().map(position).filter_map(|(x, y)| first_samples.get(x, y));
        neighbours.any(|other| self.difference.reaches_threshold(middle, other))
    }

    /// Returns the key of a pixel's random numbers: its index in the whole picture.
    fn pixel_key(&self, x: usize, y: usize) -> u64 {
        y as u64 * self.width as u64 + x as u64
    }
}

/// Offsets of a pixel's neighbours, those that share an edge first.
const NEIGHBOURS: [[isize; 2]; 8] = [[-1, 0], [1, 0], [0, -1], [0, 1], [-1, -1], [1, -1], [-1, 1], [1, 1]];

/// Test whether two samples differ visibly.
pub(super) struct Difference {
    threshold: f64,
    /// Gamma with which differences are measured (`Antialias_Gamma`).
    gamma: f64,
    /// True if the scene's colour values follow the sRGB curve.
    is_srgb: bool,
    alpha: bool,
    /// Slopes of the gamma curve, which decrease, at the starts of the half octaves from [`DARK`] on: bounds that avoid
    /// most powers. Empty for a curve whose slope increases anywhere.
    slopes: Vec<f64>,
    /// Difference of two values that is at most a quarter of the threshold after the gamma curve.
    negligible: f64,
}

/// Start of the first half octave with known slopes of the gamma curve.
const DARK: f32 = 1.0 / 4096.0;
/// Factor, above 1, by which the rounding of a sum of three numbers in single precision is outweighed.
const ROUNDING_RESERVE: f64 = 1.0 + 1e-6;
/// Number of half octaves from [`DARK`] to 16.
const HALF_OCTAVES: usize = 32;

/// Returns the number of half octaves from [`DARK`] to the one of `x`, which is at least [`DARK`]. The half octaves of an octave
/// are [1, 1.5) and [1.5, 2) times its start.
fn half_octaves_above_dark(x: f32) -> usize {
    ((x.to_bits() - DARK.to_bits()) >> (f32::MANTISSA_DIGITS - 2)) as usize
}

impl Difference {
    /// Creates the test for a threshold. Differences are measured on light to the power of 1/`gamma`; `scene_gamma`
    /// converts the scene's values to light (quirk: `antialias_gamma`).
    fn new(threshold: f64, gamma: f64, scene_gamma: Gamma, alpha: bool) -> Self {
        let (gamma, is_srgb) = match scene_gamma {
            Gamma::Power(power) => (gamma / power, false),
            Gamma::Raw => (gamma, false),
            Gamma::Srgb => (gamma, true),
        };
        // For γ > 1 the slope of x^(1/γ) decreases with x, and a step of a given size is largest at 0.
        let starts = (0..=HALF_OCTAVES as u32).map(|i| f64::from(f32::from_bits(DARK.to_bits() + (i << 22))));
        let (slopes, negligible) = match gamma >= 1.0 && !is_srgb {
            true => {
                let slopes = starts.map(|x| fp::pow(x, 1.0 / gamma - 1.0) / gamma);
                (slopes.collect(), fp::pow(threshold * 0.25, gamma))
            }
            false => (vec![], 0.0),
        };
        Self { threshold, gamma, is_srgb, alpha, slopes, negligible }
    }

    /// True if the sum of the channels' differences, after the gamma curve, reaches the threshold; always true for a
    /// threshold of 0.
    pub fn reaches_threshold(&self, a: &Pixel, b: &Pixel) -> bool {
        self.reaches_threshold_times(a, b, 1.0)
    }

    /// True if the sum of the channels' differences reaches `times` the threshold.
    pub fn reaches_threshold_times(&self, a: &Pixel, b: &Pixel, times: f64) -> bool {
        let threshold = self.threshold * times;
        let opacity = if self.alpha { f64::from((a[3] - b[3]).abs()) } else { 0.0 };
        // quirk: antialias_threshold_0
        if threshold <= 0.0 || a == b {
            return threshold <= 0.0;
        }
        if self.rough_bound_of_distance(a, b) + opacity < threshold {
            return false;
        }
        let (mut most, mut least) = (opacity, opacity);
        for c in 0..3 {
            let [least_of_channel, most_of_channel] = self.distance_bounds(a[c].max(0.0), b[c].max(0.0), threshold);
            (least, most) = (least + least_of_channel, most + most_of_channel);
        }
        if most < threshold || least > threshold * 1.000_001 {
            return most >= threshold;
        }
        self.distance(a, b) + opacity >= threshold
    }

    /// Returns the sum of the colour channels' differences after the gamma curve.
    fn distance(&self, a: &Pixel, b: &Pixel) -> f64 {
        let light = |x: f64| if self.is_srgb { Gamma::Srgb.decode(x) } else { x };
        let curve = |x: f32| fp::quick_pow(light(f64::from(x.max(0.0))), 1.0 / self.gamma);
        (0..3).map(|c| (curve(a[c]) - curve(b[c])).abs()).sum()
    }

    /// Returns an upper bound of [`Self::distance`], which suffices for most neighbours, since they are nearly equal: the
    /// slope of the gamma curve at the least value of all channels times the sum of the differences. Infinite for dark
    /// values.
    #[inline]
    fn rough_bound_of_distance(&self, a: &Pixel, b: &Pixel) -> f64 {
        let rgb = |pixel: &Pixel| Vec3A::from_vec4(Vec4::from_array(*pixel));
        let (a, b) = (rgb(a), rgb(b));
        let least = a.min(b).min_element();
        let Some(last) = self.slopes.len().checked_sub(1).filter(|_| least >= DARK) else { return f64::INFINITY };
        let difference = f64::from((a - b).abs().element_sum()) * ROUNDING_RESERVE;
        self.slopes[half_octaves_above_dark(least).min(last)] * difference
    }

    /// Returns bounds below and above of the difference of two values after the gamma curve.
    #[inline]
    fn distance_bounds(&self, a: f32, b: f32, threshold: f64) -> [f64; 2] {
        let (low, high) = (a.min(b), a.max(b));
        let difference = f64::from(high) - f64::from(low);
        let Some(last) = self.slopes.len().checked_sub(1) else { return [0.0, f64::INFINITY] };
        let most = match low >= DARK {
            true => self.slopes[half_octaves_above_dark(low).min(last)] * difference,
            false if difference <= self.negligible => threshold * 0.25,
            false => f64::INFINITY,
        };
        let after = if high >= DARK { half_octaves_above_dark(high) + 1 } else { 0 };
        [self.slopes.get(after).map_or(0.0, |slope| slope * difference), most]
    }
}

/// Converts the radiance of a camera ray to single precision: red, green and blue in the scene's colour space, and
/// transparency.
pub(super) fn rgb_and_transparency(sample: &Radiance) -> Pixel {
    let Radiance { rgb, transparency } = sample;
    [rgb.x as f32, rgb.y as f32, rgb.z as f32, *transparency as f32]
}

/// Replaces NaN by black (quirk: `nan_pixel_is_black`).
fn without_nan(pixel: Pixel) -> Pixel {
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
            let counts = |by: f64| judge.reaches_threshold(&gray(from), &gray(from + by));
            assert!(counts(difference + 1e-4) && !counts(difference - 1e-4), "{numbers:?} {gamma} {threshold} {from}");
        }
    }
    proptest::proptest! {
        /// The bounds that avoid powers decide as the powers do.
        #[test]
        fn bounds_contain_the_difference(
            exponents in proptest::array::uniform6(-16.0..6.0_f32),
            gamma in 1.0..3.0_f64,
            threshold in 0.05..1.0_f64,
        ) {
            let judge = Difference::new(threshold, gamma, Gamma::Power(1.0), false);
            let [r, g, b, red, green, blue] = exponents.map(|e| fp::exp2(f64::from(e)) as f32);
            let (one, other) = ([r, g, b, 0.0], [red, green, blue, 0.0]);
            let distance = judge.distance(&one, &other);
            let sides = (0..3).map(|c| judge.distance_bounds(one[c], other[c], threshold));
            let [least, most] = sides.fold([0.0, 0.0], |sum, side| [sum[0] + side[0], sum[1] + side[1]]);
            let negligible = (0..3).any(|c| f64::from((one[c] - other[c]).abs()) <= judge.negligible);
            proptest::prop_assert!(least <= distance * (1.0 + 1e-12), "{least} {distance}");
            proptest::prop_assert!(most >= distance * (1.0 - 1e-12) || negligible, "{most} {distance}");
            let rough = judge.rough_bound_of_distance(&one, &other);
            proptest::prop_assert!(rough >= distance * (1.0 - 1e-12), "{rough} {distance}");
            if (distance - threshold).abs() > 1e-9 {
                proptest::prop_assert_eq!(judge.reaches_threshold(&one, &other), distance >= threshold);
            }
        }
    }
}
