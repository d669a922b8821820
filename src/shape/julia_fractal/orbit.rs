//! Orbits of four-dimensional points: as a quaternion, or as a pair of complex numbers.
//!
//! A hypercomplex number x + iy + jz + kw is a pair of complex numbers, (x + w) + i(y - z) and (x - w) + i(y + z):
//! sums, products and functions apply to both, and its squared length is half the sum of theirs.

use super::function::Function;
use crate::math::{Complex, fp};
use smallvec::SmallVec;
use std::array::from_fn;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// Maximum number of iterations that are traced back from the escape radius to reduce the radius of the ball around a
/// Julia fractal; more hardly reduce it.
const BALL_ROUNDS: usize = 6;

/// Four-dimensional number of a Julia fractal: x + iy + jz + kw.
pub type Four = [f64; 4];

/// Function of a Julia fractal that is applied to h in each iteration, before the constant is added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// Function h² of a quaternion.
    Square,
    /// Function h³ of a quaternion.
    Cube,
    /// Function of each complex number of a hypercomplex pair.
    Pair(Function),
}

/// Two squared lengths for each iteration of an orbit: of both numbers of a hypercomplex pair, or twice that of a
/// quaternion.
pub type Trail = SmallVec<[[f64; 2]; 24]>;

/// Hamilton's product of two quaternions.
pub fn quaternion_product(a: Four, b: Four) -> Four {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

/// Returns the square h² of a quaternion, whose vector part is twice the product of both parts.
fn quaternion_square([x, y, z, w]: Four) -> Four {
    let twice = x + x;
    [(x * x - y * y) - (z * z + w * w), twice * y, twice * z, twice * w]
}

/// Returns ab + ba for two quaternions, in which the cross products of the vector parts cancel each other.
fn symmetric_product(a: Four, b: Four) -> Four {
    let (two_a, two_b) = (a[0] + a[0], b[0] + b[0]);
    let scalar = two_a * b[0] - 2.0 * (a[1] * b[1] + a[2] * b[2] + a[3] * b[3]);
    [scalar, two_a * b[1] + two_b * a[1], two_a * b[2] + two_b * a[2], two_a * b[3] + two_b * a[3]]
}

fn quaternion_sum(a: Four, b: Four) -> Four {
    from_fn(|i| a[i] + b[i])
}

fn length_squared([x, y, z, w]: Four) -> f64 {
    (x * x + y * y) + (z * z + w * w)
}

/// Returns the pair of complex numbers that represents a hypercomplex number.
pub fn to_complex_pair([x, y, z, w]: Four) -> [Complex; 2] {
    [Complex::new(x + w, y - z), Complex::new(x - w, y + z)]
}

impl Rule {
    /// Returns the next point of a Julia fractal's orbit, and the images of three directions.
    pub fn next_point_and_tangents(self, h: Four, c: Four, tangents: [Four; 3]) -> (Four, [Four; 3]) {
        match self {
            Rule::Square => (quaternion_sum(quaternion_square(h), c), tangents.map(|d| symmetric_product(h, d))),
            Rule::Cube => {
                let h2 = quaternion_square(h);
                // (h + d)³ - h³ = h²d + dh² + hdh + …
                let turn =
                    |d: Four| quaternion_sum(symmetric_product(h2, d), quaternion_product(quaternion_product(h, d), h));
                (quaternion_sum(quaternion_product(h2, h), c), tangents.map(turn))
            }
            Rule::Pair(f) => {
                let both = to_complex_pair(h).map(|z| f.value_and_slope(z));
                let back =
                    |[a, b]: [Complex; 2]| [0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (b.y - a.y), 0.5 * (a.x - b.x)];
                let turn = |d: Four| {
                    let [a, b] = to_complex_pair(d);
                    back([a * both[0].1, b * both[1].1])
                };
                (quaternion_sum(back(both.map(|(value, _)| value)), c), tangents.map(turn))
            }
        }
    }

    /// Iterates a Julia fractal's function at most `count` times, from `h`, with the constant `c`. `continues_at`
    /// receives the squared lengths from h₀ on; false ends the iteration.
    #[inline]
    pub fn iterate_orbit(self, [h, c]: [Four; 2], count: usize, continues_at: impl FnMut([f64; 2]) -> bool) {
        match self {
            Rule::Pair(f) => {
                let c = to_complex_pair(c);
                let squares = |z: [Complex; 2]| z.map(Complex::length_squared);
                if f == Function::Sqr {
                    let next = |z: [Complex; 2]| from_fn(|i| z[i].square() + c[i]);
                    return iterate(to_complex_pair(h), next, squares, count, continues_at);
                }
                let next = |z: [Complex; 2]| from_fn(|i| f.value_and_slope(z[i]).0 + c[i]);
                iterate(to_complex_pair(h), next, squares, count, continues_at);
            }
            Rule::Square => {
                iterate(h, |h| quaternion_sum(quaternion_square(h), c), |h| [length_squared(h); 2], count, continues_at)
            }
            Rule::Cube => {
                iterate(
                    h,
                    |h| quaternion_sum(quaternion_product(quaternion_square(h), h), c),
                    |h| [length_squared(h); 2],
                    count,
                    continues_at,
                );
            }
        }
    }

    /// Returns true if a Julia fractal's orbit stays within `escape_radius`, and a radius around its start within which
    /// all points share that; the radius is 0 where nothing is proven.
    #[inline]
    pub fn stays_with_clearance(
        self,
        start_and_constant: [Four; 2],
        escape_radius: f64,
        count: usize,
        trail: &mut Trail,
    ) -> (bool, f64) {
        trail.clear();
        let (exit, proved) = (escape_radius * escape_radius, self.has_proven_deviation_bound());
        let mut stays = true;
        self.iterate_orbit(start_and_constant, count, |squares| {
            trail.push(squares);
            // One iteration after the escape gives a better radius.
            let goes_on = stays && (proved || mean_of_squared_lengths(squares) <= exit);
            // (NaN has escaped too.)
            stays &= mean_of_squared_lengths(squares) <= exit;
            goes_on && squares.iter().all(|x| x.is_finite())
        });
        (stays, if proved { self.shared_result_radius(trail, stays, escape_radius) } else { 0.0 })
    }

    /// Returns the maximum squared length of a Julia fractal's orbit; infinite for NaN.
    pub fn max_squared_length(self, start_and_constant: [Four; 2], count: usize) -> f64 {
        let mut most = 0.0;
        self.iterate_orbit(start_and_constant, count, |squares| {
            let square = mean_of_squared_lengths(squares);
            most = if square <= most { most } else { square };
            most.is_finite()
        });
        if most.is_nan() { f64::INFINITY } else { most }
    }

    /// Returns the radius of a ball that contains every orbit of a Julia fractal which stays within `escape_radius`.
    ///
    /// |h² + c| ≥ |h|² - |c|: a point that is at most r after an iteration was at most √(r + |c|) before it, and
    /// likewise for cubes.
    pub fn bounding_radius(self, c: Four, escape_radius: f64, count: usize) -> f64 {
        let steps = 0..count.min(BALL_ROUNDS);
        let size = length_squared(c).sqrt();
        match self {
            Rule::Square => steps.fold(escape_radius, |r, _| r.min((r + size).sqrt())),
            Rule::Cube => steps.fold(escape_radius, |r, _| r.min(fp::cbrt(r + size))),
            Rule::Pair(Function::Sqr) => {
                let [a, b] = to_complex_pair(c).map(|c| {
                    let size = c.length_squared().sqrt();
                    steps.clone().fold(SQRT_2 * escape_radius, |r, _| r.min((r + size).sqrt()))
                });
                escape_radius.min(mean_of_squared_lengths([a * a, b * b]).sqrt())
            }
            Rule::Pair(_) => escape_radius,
        }
    }

    /// True if the deviation between neighbouring orbits of a Julia fractal has a proven bound, which
    /// `deviation_before` computes.
    pub fn has_proven_deviation_bound(self) -> bool {
        matches!(self, Rule::Square | Rule::Cube | Rule::Pair(Function::Sqr))
    }

    /// Returns the maximum deviation of a Julia fractal's number before an iteration, such that its deviation after it
    /// is at most `next`.
    ///
    /// |(h + d)² - h²| ≤ (|h| + |d|)² - |h|², and likewise for cubes; both are solved for |d|, or bounded where that is
    /// cheaper.
    fn deviation_before(self, squared_length: f64, next: DeviationBounds) -> DeviationBounds {
        let (length, DeviationBounds { least: e, most }) = (squared_length.sqrt(), next);
        match self {
            _ if e == 0.0 => DeviationBounds::exact(0.0),
            // d = e / (3|h|² + 3|h|d + d²) = m / (1 + x) with m = e / 3|h|² ≥ d and x ≤ m (3|h| + m) / 3|h|², and
            // 1 / (1 + x) ≥ (1 - x)(1 + x²). Here x < 0.38.
            Rule::Cube if most <= squared_length * length => {
                let inverse = 1.0 / (3.0 * squared_length);
                let most = most * inverse;
                let x = most * (3.0 * length + most) * inverse;
                DeviationBounds { least: e * inverse * ((1.0 - x) * (1.0 + x * x)), most }
            }
            Rule::Cube => DeviationBounds::exact((lower_bound_of_cbrt(squared_length * length + e) - length).max(0.0)),
            // d = e / (2|h| + d) ≥ e / (2|h| + e / 2|h|) ≥ e / 2|h| (1 - e / 4|h|²)
            _ if most <= squared_length => {
                let half = 0.5 / length;
                DeviationBounds { least: e * (half * (1.0 - most * (half * half))), most: most * half }
            }
            _ => DeviationBounds::exact((squared_length + e).sqrt() - length),
        }
    }

    /// Returns a radius within which all points share the result of a Julia fractal's orbit: escape in one of its last
    /// iterations, or none.
    fn shared_result_radius(self, trail: &[[f64; 2]], stays: bool, escape_radius: f64) -> f64 {
        let within = match (self, stays) {
            // Both numbers of a pair deviate by √2 times the point's deviation.
            (Rule::Pair(_), true) => self.deviation_while_staying::<2>(trail, escape_radius) * FRAC_1_SQRT_2,
            (Rule::Pair(_), false) => self.deviation_while_escaping::<2>(trail, escape_radius) * FRAC_1_SQRT_2,
            // (Both lengths of a quaternion are equal.)
            (_, true) => self.deviation_while_staying::<1>(trail, escape_radius),
            (_, false) => self.deviation_while_escaping::<1>(trail, escape_radius),
        };
        // (Rounding must not increase the radius.)
        within * (1.0 - 1e-9)
    }

    /// Maximum deviation of N numbers before the first iteration of a Julia fractal, such that they stay within
    /// the escape radius in all iterations.
    fn deviation_while_staying<const N: usize>(self, trail: &[[f64; 2]], escape_radius: f64) -> f64 {
        let mut e = [DeviationBounds::exact(f64::INFINITY); N];
        for squares in trail.iter().rev() {
            let gap = (escape_radius - squared_length_of_point::<N>(*squares).sqrt()).max(0.0);
            e = from_fn(|i| self.deviation_before(squares[i], e[i]).capped_at(gap));
        }
        min_of_lower_bounds(&e)
    }

    /// Maximum deviation of N numbers before the first iteration of a Julia fractal, such that they escape in one of
    /// the last iterations.
    fn deviation_while_escaping<const N: usize>(self, trail: &[[f64; 2]], escape_radius: f64) -> f64 {
        let mut e = [DeviationBounds::exact(0.0); N];
        for squares in trail.iter().rev() {
            e = from_fn(|i| self.deviation_before(squares[i], e[i]));
            let square = squared_length_of_point::<N>(*squares);
            if square > escape_radius * escape_radius {
                let gap = square.sqrt() - escape_radius;
                e = if gap > min_of_lower_bounds(&e) { [DeviationBounds::exact(gap); N] } else { e };
            }
        }
        min_of_lower_bounds(&e)
    }
}

/// Squared length of a point whose orbit has N numbers. (The two squared lengths of a quaternion are equal: one square root
/// then serves both.)
fn squared_length_of_point<const N: usize>(squares: [f64; 2]) -> f64 {
    if N == 1 { squares[0] } else { mean_of_squared_lengths(squares) }
}

/// Returns a number that is at most 0.02 % smaller than the cube root of `x` ≥ 0, and not larger.
fn lower_bound_of_cbrt(x: f64) -> f64 {
    // A third of the exponent, with the fraction's bits in between, is within 4 % of the root (W. Kahan, "Computing a real
    // cube root", 1991). Halley's step makes the error its third power.
    const THIRD_OF_BIAS: u64 = 0x2a9f_7893_0000_0000;
    let y = f64::from_bits(x.to_bits() / 3 + THIRD_OF_BIAS);
    let y3 = y * y * y;
    let root = y * ((y3 + x + x) / (y3 + y3 + x));
    if x < f64::MIN_POSITIVE { 0.0 } else { root * (1.0 - 1e-4) }
}

/// Bounds of the deviation of an orbit. Each is computed from its own predecessor, so that a processor can compute both
/// in parallel.
#[derive(Clone, Copy)]
struct DeviationBounds {
    least: f64,
    most: f64,
}

impl DeviationBounds {
    fn exact(e: f64) -> Self {
        Self { least: e, most: e }
    }

    fn capped_at(self, e: f64) -> Self {
        Self { least: self.least.min(e), most: self.most.min(e) }
    }
}

fn min_of_lower_bounds<const N: usize>(e: &[DeviationBounds; N]) -> f64 {
    e.iter().fold(f64::INFINITY, |least, stray| least.min(stray.least))
}

/// Returns the squared length of a hypercomplex number from those of its pair.
pub fn mean_of_squared_lengths([a, b]: [f64; 2]) -> f64 {
    0.5 * (a + b)
}

fn iterate<T: Copy>(
    mut h: T,
    next: impl Fn(T) -> T,
    squares: impl Fn(T) -> [f64; 2],
    count: usize,
    mut continues_at: impl FnMut([f64; 2]) -> bool,
) {
    for left in (0..=count).rev() {
        if !continues_at(squares(h)) || left == 0 {
            return;
        }
        h = next(h);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn cube_roots_have_a_close_lower_bound(exponent in -300.0..300.0_f64) {
            let x = fp::pow(10.0, exponent);
            let (bound, root) = (lower_bound_of_cbrt(x), fp::cbrt(x));
            prop_assert!(bound <= root && bound >= root * (1.0 - 2e-4), "{x:e}: {bound:e} {root:e}");
        }

        /// A point that deviates by the bound still is within `next` after the iteration.
        #[test]
        fn deviations_before_an_iteration_are_bounded(
            h in prop::array::uniform4(-1.5..1.5),
            d in prop::array::uniform4(-1.0..1.0),
            next in 0.0..4.0,
            cubes in any::<bool>(),
        ) {
            let rule = if cubes { Rule::Cube } else { Rule::Square };
            let bounds = rule.deviation_before(length_squared(h), DeviationBounds::exact(next));
            prop_assert!(0.0 <= bounds.least && bounds.least <= bounds.most * (1.0 + 1e-12));
            let scale = bounds.least / length_squared(d).sqrt();
            let moved = quaternion_sum(h, d.map(|x| x * scale));
            let power = |h: Four| if cubes { quaternion_product(quaternion_square(h), h) } else { quaternion_square(h) };
            let difference = quaternion_sum(power(moved), power(h).map(|x| -x));
            prop_assert!(length_squared(difference).sqrt() <= next * (1.0 + 1e-9));
        }
    }
}
