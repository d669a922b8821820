//! Sums of noise: K. Musgrave's multifractals ("Texturing and Modeling: A Procedural Approach", 1994, chapter
//! "Procedural Fractal Terrains") and the ridged turbulence, over [`crate::math::noise`]. POV-Ray keeps the powers of
//! frequencies from one call to the next, and so gives wrong numbers where calls with different parameters alternate;
//! durer always computes the right ones.

use super::super::Interval;
use super::PointFunction;
use crate::math::noise::{self, NoiseGenerator, noise};
use crate::math::{DVec3, fp};
use std::sync::Arc;

/// Maximum number of octaves of noise: more would only add rounding errors, and take too long.
const MOST_OCTAVES: f64 = 64.0;

/// Internal function `f_noise3d`: Noise from 0 to 1 by the default generator.
pub fn f_noise3d([x, y, z]: [f64; 3]) -> f64 {
    noise(DVec3::new(x, y, z), NoiseGenerator::default())
}

/// Noise from 0 to 1, by the generator with this number.
pub fn f_noise_generator([x, y, z, generator]: [f64; 4]) -> f64 {
    noise(DVec3::new(x, y, z), NoiseGenerator::from_number_modulo_4(generator))
}

/// Folds octaves of noise from 0 to 1: that of the point p, and those of its multiples by the powers of `lacunarity`.
/// There is at least one octave, and a fraction counts as one; `step` also receives their indices.
#[inline]
fn fold_octaves<T>(
    p: DVec3,
    lacunarity: f64,
    count: f64,
    generator: NoiseGenerator,
    start: T,
    step: impl Fn(T, f64, f64) -> T,
) -> T {
    let step = |(state, i): (T, f64), noise| {
        let next = i + 1.0;
        noise::continue_if(next < count, (step(state, i, noise), next))
    };
    noise::fold_octaves(p, lacunarity, generator, (start, 0.0), step).0
}

/// Musgrave's `Hetero_Terrain`. The heterogeneity t, truncated, is the power of the altitude that scales the next
/// octave.
#[derive(Debug)]
struct HeteroTerrain {
    lacunarity: f64,
    /// Number of octaves added in full: `octaves` rounded up, at least 1.
    n_full_octaves: f64,
    /// Fraction of an octave that is added after the full ones, as in Musgrave's function.
    rest: f64,
    /// Factor from the weight of an octave to that of the next.
    factor: f64,
    offset: f64,
    power: i32,
    generator: NoiseGenerator,
}

impl HeteroTerrain {
    fn new([h, lacunarity, octaves, offset, t, generator]: [f64; 6]) -> Self {
        let octaves = octaves.min(MOST_OCTAVES);
        Self {
            lacunarity,
            n_full_octaves: octaves.ceil().max(1.0),
            rest: octaves - octaves.floor(),
            factor: fp::pow(lacunarity, -h),
            offset,
            power: t.clamp(0.0, 64.0) as i32,
            generator: NoiseGenerator::from_number_modulo_4(generator),
        }
    }
}

impl PointFunction for HeteroTerrain {
    fn value_at(&self, p: DVec3) -> f64 {
        let count = if self.rest > 0.0 { self.n_full_octaves + 1.0 } else { self.n_full_octaves };
        let step = |(value, weight): (f64, f64), i: f64, noise: f64| {
            let increment = (2.0 * noise - 1.0 + self.offset) * weight;
            let next = if i == 0.0 {
                increment
            } else if i < self.n_full_octaves {
                increment * value.powi(self.power)
            } else {
                self.rest * increment * value
            };
            (value + next, weight * self.factor)
        };
        fold_octaves(p, self.lacunarity, count, self.generator, (0.0, 1.0), step).0
    }
}

/// Musgrave's `RidgedMultifractal`.
#[derive(Debug)]
struct RidgedMultifractal {
    lacunarity: f64,
    octaves: f64,
    /// Factor from the weight of an octave to that of the next.
    factor: f64,
    offset: f64,
    gain: f64,
    generator: NoiseGenerator,
}

impl RidgedMultifractal {
    fn new([h, lacunarity, octaves, offset, gain, generator]: [f64; 6]) -> Self {
        Self {
            lacunarity,
            octaves: octaves.min(MOST_OCTAVES),
            factor: fp::pow(lacunarity, -h),
            offset,
            gain,
            generator: NoiseGenerator::from_number_modulo_4(generator),
        }
    }
}

impl PointFunction for RidgedMultifractal {
    fn value_at(&self, p: DVec3) -> f64 {
        let &Self { lacunarity, octaves, factor, offset, gain, generator } = self;
        // `share` is the part of an octave that remains where the one before it is low.
        let step = |(sum, weight, share): (f64, f64, f64), _, noise: f64| {
            let height = offset - (2.0 * noise - 1.0).abs();
            let signal = height * height * share;
            (sum + signal * weight, weight * factor, (signal * gain).clamp(0.0, 1.0))
        };
        fold_octaves(p, lacunarity, octaves, generator, (0.0, 1.0, 1.0), step).0
    }
}

/// Internal function `f_hetero_mf`: Musgrave's `Hetero_Terrain`.
pub fn f_hetero_mf([x, y, z, parameters @ ..]: [f64; 9]) -> f64 {
    HeteroTerrain::new(parameters).value_at(DVec3::new(x, y, z))
}

/// Prepares [`f_hetero_mf`] for these parameters after x, y and z.
pub fn prepared_hetero_mf(parameters: &[f64]) -> Option<Arc<dyn PointFunction>> {
    Some(Arc::new(HeteroTerrain::new(parameters.try_into().ok()?)))
}

/// Internal function `f_ridged_mf`: Ridged multifractal noise, after Musgrave's `RidgedMultifractal`.
pub fn f_ridged_mf([x, y, z, parameters @ ..]: [f64; 9]) -> f64 {
    RidgedMultifractal::new(parameters).value_at(DVec3::new(x, y, z))
}

/// Prepares [`f_ridged_mf`] for these parameters after x, y and z.
pub fn prepared_ridged_mf(parameters: &[f64]) -> Option<Arc<dyn PointFunction>> {
    Some(Arc::new(RidgedMultifractal::new(parameters.try_into().ok()?)))
}

/// Internal function `f_ridge`: The mean of octaves of |noise - ridge|, minus the offset; both differences are divided
/// by the larger of the two parts into which the ridge divides the range from 0 to 1. A fraction of an octave has that
/// weight.
pub fn f_ridge([x, y, z, lambda, octaves, omega, offset, ridge, generator]: [f64; 9]) -> f64 {
    let octaves = octaves.min(MOST_OCTAVES);
    let (whole, rest) = (octaves.floor().max(1.0), octaves - octaves.floor());
    let step = |(sum, weights, weight): (f64, f64, f64), i, noise: f64| {
        let height = (noise - ridge).abs() / ridge.max(1.0 - ridge);
        let share = if i < whole { weight } else { rest * weight };
        (sum + share * height, weights + share, weight * omega)
    };
    let generator = NoiseGenerator::from_number_modulo_4(generator);
    let start = (0.0, 0.0, 1.0);
    let (sum, weights, _) = fold_octaves(DVec3::new(x, y, z), lambda, whole + rest, generator, start, step);
    (sum / weights - offset) / offset.max(1.0 - offset)
}

/// Upper bound of the length of the gradient of noise, by the number of its generator.
pub fn max_noise_gradient(generator: &[f64]) -> f64 {
    generator.first().map_or(f64::INFINITY, |n| NoiseGenerator::from_number_modulo_4(*n).max_gradient())
}

/// Upper bound of the change of the gradient of noise per unit of length, by the number of its generator.
pub fn max_noise_gradient_change(generator: &[f64]) -> f64 {
    generator.first().map_or(f64::INFINITY, |n| NoiseGenerator::from_number_modulo_4(*n).max_gradient_change_per_unit())
}

/// Bounds of the internal functions of noise: 0 to 1.
pub fn noise_bounds(_: &[Interval]) -> Interval {
    Interval::TRUTH
}

/// The parameters after x, y and z of an internal function, if each interval is a single number.
fn constant_parameters_after_point<const N: usize>(a: &[Interval]) -> Option<[f64; N]> {
    let mut all = [0.0; N];
    for (to, i) in all.iter_mut().zip(a.get(3..3 + N)?) {
        *to = i.lo;
    }
    a[3..].iter().all(|i| i.lo == i.hi).then_some(all)
}

/// Bounds of octaves of noise over a box: each octave differs from its value at the centre by at most its steepness
/// times the radius.
struct Octaves {
    p: DVec3,
    /// Distance from the centre of the box to its corners.
    radius: f64,
    generator: NoiseGenerator,
}

impl Octaves {
    fn new(a: &[Interval], generator: f64) -> Option<Self> {
        let &[x, y, z, ..] = a else { return None };
        let (lo, hi) = (DVec3::new(x.lo, y.lo, z.lo), DVec3::new(x.hi, y.hi, z.hi));
        let (p, radius) = (0.5 * (lo + hi), 0.5 * (hi - lo).length());
        (p.is_finite() && radius.is_finite()).then(|| Self {
            p,
            radius,
            generator: NoiseGenerator::from_number_modulo_4(generator),
        })
    }

    /// Bounds of noise from 0 to 1 over the box, at this multiple of the frequency.
    fn octave_bounds(&self, frequency: f64) -> Interval {
        let value = noise(self.p * frequency, self.generator);
        let far = self.generator.max_gradient() * self.radius * frequency.abs();
        Interval { lo: value - far, hi: value + far }.widened_by_rounding().intersection_or_self(Interval::TRUTH)
    }

    /// Bounds of noise from -1 to 1 over the box, at this multiple of the frequency.
    fn signed_octave_bounds(&self, frequency: f64) -> Interval {
        Interval::point(2.0) * self.octave_bounds(frequency) + Interval::point(-1.0)
    }
}

/// Replaces bounds that are NaN by the interval of all numbers; widens all others by a rounding error.
fn widened_without_nan(bounds: Interval) -> Interval {
    if bounds.lo.is_nan() || bounds.hi.is_nan() { Interval::ALL } else { bounds.widened_by_rounding() }
}

/// Bounds of the internal function [`f_hetero_mf`] over a box of arguments.
pub fn hetero_bounds(a: &[Interval]) -> Interval {
    let Some([h, lacunarity, octaves, offset, t, generator]) = constant_parameters_after_point(a) else {
        return Interval::ALL;
    };
    let Some(noise) = Octaves::new(a, generator) else { return Interval::ALL };
    let octaves = octaves.min(MOST_OCTAVES);
    let mut value = noise.signed_octave_bounds(1.0) + Interval::point(offset);
    let (mut i, mut frequency, mut weight, factor) = (1.0, 1.0_f64, 1.0, fp::pow(lacunarity, -h));
    let mut increment = || {
        frequency *= lacunarity;
        weight *= factor;
        (noise.signed_octave_bounds(frequency) + Interval::point(offset)) * Interval::point(weight)
    };
    let power = t.clamp(0.0, 64.0) as usize;
    while i < octaves {
        value = value + increment() * (0..power).fold(Interval::point(1.0), |product, _| product * value);
        i += 1.0;
    }
    let rest = octaves - octaves.floor();
    widened_without_nan(if rest > 0.0 { value + Interval::point(rest) * increment() * value } else { value })
}

/// Bounds of the internal function [`f_ridged_mf`] over a box of arguments.
pub fn ridged_bounds(a: &[Interval]) -> Interval {
    let Some([h, lacunarity, octaves, offset, gain, generator]) = constant_parameters_after_point(a) else {
        return Interval::ALL;
    };
    let Some(noise) = Octaves::new(a, generator) else { return Interval::ALL };
    let ridge = |frequency: f64| (Interval::point(offset) + -noise.signed_octave_bounds(frequency).abs()).square();
    let mut signal = ridge(1.0);
    let mut sum = signal;
    let (mut i, mut frequency, mut weight, factor) = (1.0, 1.0_f64, 1.0, fp::pow(lacunarity, -h));
    while i < octaves.min(MOST_OCTAVES) {
        frequency *= lacunarity;
        weight *= factor;
        let share = signal * Interval::point(gain);
        signal = ridge(frequency) * Interval { lo: share.lo.clamp(0.0, 1.0), hi: share.hi.clamp(0.0, 1.0) };
        sum = sum + signal * Interval::point(weight);
        i += 1.0;
    }
    widened_without_nan(sum)
}

/// Bounds of the internal function [`f_ridge`] over a box of arguments.
pub fn ridge_bounds(a: &[Interval]) -> Interval {
    let Some([lambda, octaves, omega, offset, ridge, generator]) = constant_parameters_after_point(a) else {
        return Interval::ALL;
    };
    let Some(noise) = Octaves::new(a, generator) else { return Interval::ALL };
    let octaves = octaves.min(MOST_OCTAVES);
    let part = Interval::point(1.0 / ridge.max(1.0 - ridge));
    let height = |frequency: f64| (noise.octave_bounds(frequency) + Interval::point(-ridge)).abs() * part;
    let (mut sum, mut weights, mut weight, mut frequency) = (height(1.0), 1.0, 1.0, 1.0);
    let mut add = |share: f64| {
        frequency *= lambda;
        weight *= omega;
        sum = sum + Interval::point(share * weight) * height(frequency);
        weights += share * weight;
    };
    let mut i = 1.0;
    while i < octaves.floor() {
        add(1.0);
        i += 1.0;
    }
    let rest = octaves - octaves.floor();
    if rest > 0.0 {
        add(rest);
    }
    let mean = sum * Interval::point(1.0 / weights) + Interval::point(-offset);
    widened_without_nan(mean * Interval::point(1.0 / offset.max(1.0 - offset)))
}
