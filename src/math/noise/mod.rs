//! POV-Ray's noise: smooth random functions of space.
//!
//! Two lattice noises in the manner of K. Perlin, "An Image Synthesizer" (SIGGRAPH 1985), with POV-Ray's tables,
//! offsets and ranges (quirk: `noise_tables`). `value` is the one of generators 1 and 2 and of the vector noise,
//! `perlin` the one of generator 3. Results agree with POV-Ray to about 1e-15 for coordinates below 2³¹, where
//! POV-Ray's own cells overflow; here they do not. No input panics; infinite and undefined coordinates give NaN or a
//! bound of the range.

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
mod cells;
mod lattice;
mod perlin;
mod tables;
mod value;
mod wide;

pub use cells::{Around, Cell};

use super::DVec3;
use serde::Serialize;
use std::ops::ControlFlow;

/// Noise generator of a scene, the argument of `noise_generator` (manual, "Noise Generators").
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum NoiseGenerator {
    /// Noise generator 1, original: the range is clamped to [0, 1], which leaves flat spots.
    Original,
    /// Noise generator 2, range corrected: the default.
    #[default]
    RangeCorrected,
    /// Noise generator 3, Perlin: gradients alone, no values at the lattice points.
    Perlin,
}

impl NoiseGenerator {
    /// Upper bound of the gradient of [`noise`]: the longest gradients, found by hill climbing from the steepest of a
    /// million points, have 2.98, 1.46 and 1.58.
    pub fn max_gradient(self) -> f64 {
        match self.number() {
            1 => 3.2,
            2 => 1.6,
            _ => 1.75,
        }
    }

    /// Upper bound of the change of the gradient of [`noise`] per unit of length, where the noise is strictly between 0
    /// and 1: the largest spectral norms of the second derivatives, found by hill climbing from the largest of three
    /// million points, are 7.25 and 8.08 for the last two. The first is 1/0.48985582 times the second, except where it
    /// is clamped: 14.8.
    pub fn max_gradient_change_per_unit(self) -> f64 {
        match self.number() {
            1 => 16.2,
            2 => 7.9,
            _ => 8.9,
        }
    }

    /// Number of the noise generator in scenes, 1 to 3.
    pub fn number(self) -> u8 {
        match self {
            Self::Original => 1,
            Self::RangeCorrected => 2,
            Self::Perlin => 3,
        }
    }

    /// Returns the noise generator for the last argument of `f_noise_generator`, which POV-Ray truncates to an integer
    /// of two bits: 2.7 and 6 count as 2, 7 as 3. Then 0 counts as 1.
    pub fn from_number_modulo_4(n: f64) -> Self {
        match (n as i64) & 3 {
            2 => Self::RangeCorrected,
            3 => Self::Perlin,
            _ => Self::Original,
        }
    }
}

/// Maximum number of octaves of noise in POV-Ray.
const MAX_OCTAVES: usize = 10;

/// Parameters of turbulence, a sum of octaves of noise (manual, "Turbulence").
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turbulence {
    lambda: f64,
    omega: f64,
    octaves: u32,
}

impl Default for Turbulence {
    fn default() -> Self {
        Self { lambda: 2.0, omega: 0.5, octaves: 6 }
    }
}

impl Turbulence {
    /// Creates the parameters of turbulence: each octave is `lambda` times finer and `omega` times weaker than the one
    /// before. Like POV-Ray, this keeps `lambda` and `omega` in single precision (visible from the 8th digit on), and
    /// the integer part of `octaves`, from 1 to 10.
    pub fn new(lambda: f64, omega: f64, octaves: f64) -> Self {
        let single = |x: f64| f64::from(x as f32);
        Self { lambda: single(lambda), omega: single(omega), octaves: (octaves as u32).clamp(1, MAX_OCTAVES as u32) }
    }

    /// Returns the frequency and weight of each octave of the turbulence.
    fn octaves(self) -> impl Iterator<Item = (f64, f64)> {
        let mut next = (1.0, 1.0);
        (0..self.octaves).map(move |_| {
            let this = next;
            next = (this.0 * self.lambda, this.1 * self.omega);
            this
        })
    }
}

/// Noise of `f_noise_generator(x, y, z, generator)`: between 0 and 1, about 0.5 on average. `f_noise3d` is this
/// function with the scene's generator, `f_snoise3d` is twice that minus 1.
pub fn noise(p: DVec3, generator: NoiseGenerator) -> f64 {
    let raw =
        if generator == NoiseGenerator::Perlin { perlin::scalar_noise(p) } else { wide::scalar_at(p.x, p.y, p.z) };
    to_generator_range(raw, generator)
}

/// Folds octaves of [`noise`] until `step` breaks: the noise at the point, and at its multiples by the powers of
/// `lacunarity`. (This is faster than single calls of [`noise`].)
#[inline]
pub fn fold_octaves<T>(
    p: DVec3,
    lacunarity: f64,
    generator: NoiseGenerator,
    start: T,
    step: impl Fn(T, f64) -> ControlFlow<T, T>,
) -> T {
    // Each generator has its own loop, so that the loop does not test the generator for each octave.
    match generator {
        NoiseGenerator::Original => wide::fold_octaves(p.x, p.y, p.z, lacunarity, start, |state, raw| {
            step(state, to_generator_range(raw, NoiseGenerator::Original))
        }),
        NoiseGenerator::RangeCorrected => wide::fold_octaves(p.x, p.y, p.z, lacunarity, start, |state, raw| {
            step(state, to_generator_range(raw, NoiseGenerator::RangeCorrected))
        }),
        NoiseGenerator::Perlin => {
            let (mut frequency, mut state) = (1.0, start);
            loop {
                match step(state, to_generator_range(perlin::scalar_noise(p * frequency), generator)) {
                    ControlFlow::Continue(next) => state = next,
                    ControlFlow::Break(end) => return end,
                }
                frequency *= lacunarity;
            }
        }
    }
}

/// Maps raw noise to the generator's range.
#[inline(always)]
fn to_generator_range(raw: f64, generator: NoiseGenerator) -> f64 {
    let unbounded = match generator {
        NoiseGenerator::Original => raw + 0.5,
        NoiseGenerator::RangeCorrected => (raw + 1.05242) * 0.48985582,
        NoiseGenerator::Perlin => 0.4925 + 0.795 * raw,
    };
    unbounded.clamp(0.0, 1.0)
}

/// Returns the vector noise that displaces points (`vturbulence` with one octave): components about -1 to 1, 0 on
/// average. It is independent of the generator.
pub fn noise_vector(p: DVec3) -> DVec3 {
    wide::vector_at(p.x, p.y, p.z)
}

/// Scalar turbulence at a point, as in `agate`: octaves of noise. For generators 2 and 3 each octave is stretched to 2
/// noise - 0.5, of which POV-Ray clamps the first one only.
pub fn turbulence(p: DVec3, turbulence: Turbulence, generator: NoiseGenerator) -> f64 {
    let (omega, count) = (turbulence.omega, turbulence.octaves);
    let step = |(sum, weight, done): (f64, f64, u32), noise| {
        let sum = sum + weight * stretch_octave(noise, generator, done == 0);
        continue_if(done + 1 < count, (sum, weight * omega, done + 1))
    };
    fold_octaves(p, turbulence.lambda, generator, (0.0, 1.0, 0), step).0
}

/// Folds octaves of noise until `step` breaks, for `granite` and `wrinkles`: each is clamped to [0, 1] and twice as fine
/// as the one before.
#[inline]
pub fn fold_clamped_octaves<T>(
    p: DVec3,
    generator: NoiseGenerator,
    start: T,
    step: impl Fn(T, f64) -> ControlFlow<T, T>,
) -> T {
    fold_octaves(p, 2.0, generator, start, |state, noise| step(state, stretch_octave(noise, generator, true)))
}

/// Continues a fold with a state if the condition is true, else ends it.
#[inline]
pub fn continue_if<T>(condition: bool, state: T) -> ControlFlow<T, T> {
    if condition { ControlFlow::Continue(state) } else { ControlFlow::Break(state) }
}

/// Stretches an octave of [`noise`] for turbulence: to 2 noise - 0.5 for generators 2 and 3, clamped to [0, 1] if
/// `clamp` is true; returns the noise of generator 1 unchanged.
#[inline(always)]
fn stretch_octave(noise: f64, generator: NoiseGenerator, clamp: bool) -> f64 {
    match (generator, clamp) {
        (NoiseGenerator::Original, _) => noise,
        (_, true) => (2.0 * noise - 0.5).clamp(0.0, 1.0),
        (_, false) => 2.0 * noise - 0.5,
    }
}

/// Returns the vector turbulence of `vturbulence(lambda, omega, octaves, p)`: octaves of the vector noise; `turbulence
/// T` displaces p by T times this vector.
pub fn vturbulence(p: DVec3, turbulence: Turbulence) -> DVec3 {
    wide::turbulence(p.x, p.y, p.z, turbulence)
}

#[cfg(test)]
mod tests {
    use super::*;
    use NoiseGenerator::{Original, Perlin, RangeCorrected};

    #[test]
    fn numbers_choose_generators_as_in_pov_ray() {
        let numbers = [(0.0, Original), (1.9, Original), (2.7, RangeCorrected), (3.0, Perlin), (4.0, Original)];
        for (n, generator) in numbers.into_iter().chain([(-1.5, Perlin), (-2.0, RangeCorrected), (-0.5, Original)]) {
            assert_eq!(NoiseGenerator::from_number_modulo_4(n), generator, "{n}");
        }
    }

    #[test]
    fn octaves_are_bounded() {
        let counts = [-3.0, 0.5, 2.99, 12.0, f64::NAN].map(|n| Turbulence::new(2.0, 0.5, n).octaves().count());
        assert_eq!(counts, [1, 1, 2, 10, 1]);
    }

    #[test]
    fn extreme_points_do_not_panic() {
        for x in [f64::NAN, f64::INFINITY, -f64::INFINITY, f64::MAX, 1e18, -1e300, f64::MIN_POSITIVE, -0.0] {
            let p = DVec3::new(x, 0.5, -x);
            for generator in [Original, RangeCorrected, Perlin] {
                let n = noise(p, generator);
                assert!(n.is_nan() || (0.0..=1.0).contains(&n), "{x}");
            }
            noise_vector(p);
        }
    }

    #[test]
    fn noise_is_continuous_across_cells() {
        for generator in [Original, RangeCorrected, Perlin] {
            for i in -9..9 {
                let plane = f64::from(i) - if generator == Perlin { perlin::OFFSET.fract() } else { 0.0 };
                let at = |x| noise(DVec3::new(x, 0.3, 0.7), generator);
                assert!((at(plane - 1e-9) - at(plane + 1e-9)).abs() < 1e-8, "{generator:?} {plane}");
            }
        }
    }

    #[test]
    fn lattice_repeats() {
        let p = DVec3::new(0.25, -3.5, 7.125);
        for axis in DVec3::AXES {
            assert_eq!(noise_vector(p), noise_vector(p + 4096.0 * axis));
            assert_eq!(noise(p, Perlin), noise(p + 2048.0 * axis, Perlin));
        }
    }
}
