//! Real roots of polynomials of any degree, by the signs of their Bernstein coefficients.
//!
//! With Σ bᵢ·C(n,i)·tⁱ·(1-t)ⁿ⁻ⁱ on [0, 1], there are no more roots than the bᵢ change their sign (Descartes' rule):
//! none without a change, one with one. Any other interval is bisected (Lane & Riesenfeld, Bounds on a Polynomial,
//! 1981). All operations are averages of neighbours, which lose nothing to rounding. Zero counts as positive
//! everywhere, as if the polynomial were a trifle larger: a root at the boundary between two intervals, or two pieces
//! of a curve, is thus found in exactly one of them.

use super::solve_quadratic;
use crate::math::tolerance;

/// Maximum degree of a polynomial whose roots are searched.
pub const MAX_DEGREE: usize = 35;

/// Inverses of the binomial coefficients: 1/C(n, i) at row n and column i.
static INVERSE_BINOMIALS: [[f64; MAX_DEGREE + 1]; MAX_DEGREE + 1] = inverse_binomials();

const fn inverse_binomials() -> [[f64; MAX_DEGREE + 1]; MAX_DEGREE + 1] {
    let mut table = [[0.0; MAX_DEGREE + 1]; MAX_DEGREE + 1];
    let mut n = 0;
    while n <= MAX_DEGREE {
        let (mut i, mut c) = (0, 1.0);
        while i <= n {
            table[n][i] = 1.0 / c;
            c = c * (n - i) as f64 / (i + 1) as f64;
            i += 1;
        }
        n += 1;
    }
    table
}

/// Function that receives each root of a polynomial and returns true to end the search.
type StopsAt<'a> = &'a mut dyn FnMut(f64) -> bool;

/// Arrays of coefficients up to this length have exactly the size for the polynomial's degree, which is known at
/// compile time.
const EXACT: usize = 8;

/// Margin of the clipped window around the interval of wanted roots: far more than the rounding error of a root.
const WINDOW_SLACK: f64 = 1e-9;
/// Share of the interval: a window of wanted roots that is wider than this is not clipped.
const MOST_OF_IT: f64 = 0.8;

/// Search for a polynomial's roots on [0, 1]. Arrays have at least one coefficient more than the degree.
struct Search<'a> {
    /// Degree of the polynomial, for arrays of coefficients that are larger than needed.
    degree: usize,
    /// Absolute value below which a coefficient of the polynomial is a rounding error.
    noise: f64,
    /// Interval of the polynomial's wanted roots.
    window: (f64, f64),
    /// True to search the roots from 1 to 0.
    backwards: bool,
    stops_at: StopsAt<'a>,
}

/// True if a coefficient is negative; zero counts as positive.
fn is_negative(x: f64) -> bool {
    x < 0.0
}

fn sign_changes(b: &[f64]) -> usize {
    b.windows(2).filter(|w| is_negative(w[0]) != is_negative(w[1])).count()
}

/// Returns the coefficients that de Casteljau's algorithm leaves of a Bernstein polynomial at t before its last two steps:
/// those of a polynomial of degree 2 with the same value, and with slope and curvature divided by n/2 and n(n-1)/2, where n
/// is the degree, at least 2.
#[inline(always)]
fn quadratic_at<const N: usize>(b: &[f64; N], degree: usize, t: f64) -> [f64; 3] {
    let mut b = *b;
    // (Here and below without `..=`, whose loops the compiler does not unroll.)
    for last in (2..degree).rev() {
        for i in 0..last + 1 {
            b[i] += (b[i + 1] - b[i]) * t;
        }
    }
    [b[0], b[1], b[2]]
}

/// Returns the value of a Bernstein polynomial, of degree 2 or more, at t.
#[inline(always)]
fn value<const N: usize>(b: &[f64; N], degree: usize, t: f64) -> f64 {
    let [b0, b1, b2] = quadratic_at(b, degree, t);
    let (left, right) = (b0 + (b1 - b0) * t, b1 + (b2 - b1) * t);
    left + (right - left) * t
}

/// Returns the value of a Bernstein polynomial, of degree 2 or more, at t, and the step from t to Halley's better
/// approximation of a root: f/f' / (1 - f·f''/2f'²). Far from a root, where the divisor would be below 1/2 or above 3/2, and
/// where f'² could underflow or overflow, the step is Newton's, f/f'.
#[inline(always)]
fn value_and_step<const N: usize>(b: &[f64; N], degree: usize, t: f64) -> (f64, f64) {
    let n = degree as f64;
    let [b0, b1, b2] = quadratic_at(b, degree, t);
    let (left, right) = (b0 + (b1 - b0) * t, b1 + (b2 - b1) * t);
    // f' = n·rise and f'' = n(n-1)·bend
    let (rise, bend) = (right - left, (b2 - b1) - (b1 - b0));
    let value = left + rise * t;
    let (slope_squared, correction) = (n * rise * rise, 0.5 * (n - 1.0) * value * bend);
    if correction.abs() < 0.5 * slope_squared && (1e-280..1e280).contains(&slope_squared) {
        (value, value * rise / (slope_squared - correction))
    } else {
        (value, value / (n * rise))
    }
}

/// Returns the only root in [0, 1] of a polynomial whose signs differ at both ends: Halley's step where it stays in the
/// bracket and converges fast enough, bisection otherwise (as Press et al., Numerical Recipes, "rtsafe", with a step of
/// third order).
#[inline(always)]
fn only_root<const N: usize>(b: &[f64; N], degree: usize) -> f64 {
    let rising = is_negative(b[0]);
    let (mut lo, mut hi) = (0.0, 1.0);
    let mut t = (b[0] / (b[0] - b[degree])).clamp(0.01, 0.99);
    let mut last_step = 1.0;
    for _ in 0..100 {
        let (f, change) = value_and_step(b, degree, t);
        if is_negative(f) == rising {
            lo = t;
        } else {
            hi = t;
        }
        let (improved, step) = (t - change, change.abs());
        let shrinks = improved >= lo && improved <= hi && step <= 0.5 * last_step;
        // Such a short step triples the number of correct digits; a step that does not get shorter is rounding.
        if step <= 1e-8 * t && (shrinks || last_step <= 1e-8 * t) {
            return improved.clamp(lo, hi);
        }
        let next = if shrinks { improved } else { 0.5 * (lo + hi) };
        last_step = (next - t).abs();
        t = next;
        if hi - lo <= f64::EPSILON {
            break;
        }
    }
    t
}

/// Returns the Bernstein coefficients on both halves of an interval.
#[inline(always)]
fn split_in_half<const N: usize>(b: &[f64; N], degree: usize) -> ([f64; N], [f64; N]) {
    let (mut left, mut right) = (*b, *b);
    for (k, end) in left.iter_mut().enumerate().take(degree) {
        *end = right[0];
        for i in 0..degree - k {
            right[i] = 0.5 * (right[i] + right[i + 1]);
        }
    }
    left[degree] = right[0];
    (left, right)
}

/// Returns the Bernstein coefficients on the interval from t0 to t1.
#[inline(always)]
fn restrict_to_interval<const N: usize>(mut b: [f64; N], degree: usize, (t0, t1): (f64, f64)) -> [f64; N] {
    if t0 > 0.0 {
        for last in (0..degree).rev() {
            for i in 0..last + 1 {
                b[i] += (b[i + 1] - b[i]) * t0;
            }
        }
    }
    if t1 < 1.0 {
        // Cut at t1, in units of the remaining interval.
        let back = (1.0 - t1) / (1.0 - t0);
        for first in 1..degree + 1 {
            for i in (first..degree + 1).rev() {
                b[i] += (b[i - 1] - b[i]) * back;
            }
        }
    }
    b
}

impl Search<'_> {
    /// Searches for roots in [0, 1]. If the window is only a part of it, the clipped coefficients decide first whether
    /// there is any root. (Roots are then found from the whole interval: a root is the same to the last bit for any
    /// window.)
    fn search_unit_is_over<const N: usize>(&mut self, b: &[f64; N]) -> bool {
        let (t0, t1) = ((self.window.0 - WINDOW_SLACK).max(0.0), (self.window.1 + WINDOW_SLACK).min(1.0));
        let degree = if N <= EXACT { N - 1 } else { self.degree };
        if t1 - t0 < MOST_OF_IT && sign_changes(&b[..=degree]) > 0 {
            let part = restrict_to_interval(*b, degree, (t0, t1));
            let part = &part[..=degree];
            if part.iter().all(|b| *b > self.noise) || part.iter().all(|b| *b < -self.noise) {
                return false;
            }
        }
        self.search_interval_is_over(b, 0.0, 1.0)
    }

    /// Searches for roots between `lo` and `hi`, where the Bernstein coefficients are `b`. Returns true if the search
    /// is over.
    fn search_interval_is_over<const N: usize>(&mut self, b: &[f64; N], lo: f64, hi: f64) -> bool {
        if hi < self.window.0 || lo > self.window.1 {
            return false;
        }
        let degree = if N <= EXACT { N - 1 } else { self.degree };
        let used = &b[..=degree];
        match sign_changes(used) {
            0 => return false,
            1 if self.is_outside_window(b, degree, lo, hi) => return false,
            1 => return (self.stops_at)(lo + (hi - lo) * only_root(b, degree)),
            _ => {}
        }
        let middle = 0.5 * (lo + hi);
        if hi - lo < tolerance::POLYNOMIAL || used.iter().all(|b| b.abs() <= self.noise) {
            // A cluster of roots that rounding can't separate: crossed, or touched.
            let crossed = is_negative(b[0]) != is_negative(b[degree]);
            return (self.stops_at)(middle) || !crossed && (self.stops_at)(middle);
        }
        let (left, right) = split_in_half(b, degree);
        let (near, far) = ((&left, lo, middle), (&right, middle, hi));
        let (first, then) = if self.backwards { (far, near) } else { (near, far) };
        self.search_interval_is_over(first.0, first.1, first.2) || self.search_interval_is_over(then.0, then.1, then.2)
    }

    /// True if the only root between `lo` and `hi`, where the Bernstein coefficients are `b`, is certainly outside the
    /// window: the signs at the ends of the window show it before the root is computed.
    fn is_outside_window<const N: usize>(&self, b: &[f64; N], degree: usize, lo: f64, hi: f64) -> bool {
        let has_sign_of = |end: f64, at: f64| {
            let value = value(b, degree, (at - lo) / (hi - lo));
            value.abs() > self.noise && is_negative(value) == is_negative(end)
        };
        let (start, end) = (self.window.0 - WINDOW_SLACK, self.window.1 + WINDOW_SLACK);
        start > lo && has_sign_of(b[degree], start) || end < hi && has_sign_of(b[0], end)
    }
}

/// Finds the roots in [0, 1] of the polynomial with these Bernstein coefficients, ascending; a double root counts
/// twice. The degree, at most 11, is one less than their number. `stops_at` receives each root; true ends the search.
pub fn bernstein_roots(b: &[f64], stops_at: &mut dyn FnMut(f64) -> bool) {
    bernstein_roots_in_window(b, (f64::NEG_INFINITY, f64::INFINITY), stops_at);
}

/// As [`bernstein_roots`], for a caller that needs only the roots in `window`. `stops_at` may also receive others. A root
/// is the same to the last bit for any window.
pub fn bernstein_roots_in_window(b: &[f64], window: (f64, f64), stops_at: &mut dyn FnMut(f64) -> bool) {
    debug_assert!((2..=12).contains(&b.len()));
    // (Most pieces of a curve have no hit.)
    if sign_changes(b) == 0 {
        return;
    }
    match *b {
        [b0, b1] => {
            stops_at(b0 / (b0 - b1));
        }
        [b0, b1, b2] => {
            let _ = bernstein_quadratic_roots(b0, b1, b2).into_iter().flatten().any(stops_at);
        }
        [_, _, _, _] => roots_of_zero_padded::<4>(b, window, stops_at),
        [_, _, _, _, _] => roots_of_zero_padded::<5>(b, window, stops_at),
        [_, _, _, _, _, _] => roots_of_zero_padded::<6>(b, window, stops_at),
        [_, _, _, _, _, _, _] => roots_of_zero_padded::<7>(b, window, stops_at),
        [_, _, _, _, _, _, _, _] => roots_of_zero_padded::<8>(b, window, stops_at),
        _ => roots_of_zero_padded::<12>(b, window, stops_at),
    }
}

/// Returns the roots in [0, 1] of b₀(1 - t)² + 2b₁t(1 - t) + b₂t², whose coefficients change their signs.
fn bernstein_quadratic_roots(b0: f64, b1: f64, b2: f64) -> [Option<f64>; 2] {
    // t/(1 - t) is a root of b₂u² + 2b₁u + b₀.
    let discriminant = b1 * b1 - b0 * b2;
    let q = -(b1 + discriminant.max(0.0).sqrt().copysign(b1));
    // u = q/b₂ and u = b₀/q
    let (t1, t2) = (q / (q + b2), b0 / (b0 + q));
    if is_negative(b0) != is_negative(b2) {
        // One of the two is outside of [0, 1]; rounding may hide which.
        let off = |t: f64| if t.is_finite() { (t - 0.5).abs() } else { f64::INFINITY };
        let t = if off(t1) <= off(t2) { t1 } else { t2 };
        return [Some(t.clamp(0.0, 1.0)), None];
    }
    if is_negative(discriminant) {
        return [None; 2];
    }
    [Some(t1.min(t2)), Some(t1.max(t2))]
}

fn roots_of_zero_padded<const N: usize>(b: &[f64], window: (f64, f64), stops_at: StopsAt) {
    let mut padded = [0.0; N];
    padded[..b.len()].copy_from_slice(b);
    let size = b.iter().fold(0.0, |size: f64, b| size.max(b.abs()));
    let noise = tolerance::POLYNOMIAL * size;
    let mut search = Search { degree: b.len() - 1, noise, window, backwards: false, stops_at };
    search.search_interval_is_over(&padded, 0.0, 1.0);
}

/// Finds the roots between `lo` and `hi`, which may be infinite, of the polynomial c₀ + c₁·x + …, whose coefficients
/// start with the constant c₀, up to degree [`MAX_DEGREE`]. `stops_at` receives the roots in ascending order; true ends
/// the search. A double root, unless rounding hides it, counts twice.
pub fn polynomial_roots_between(
    ascending_coefficients: &[f64],
    lo: f64,
    hi: f64,
    stops_at: &mut dyn FnMut(f64) -> bool,
) {
    let c = ascending_coefficients;
    let Some(degree) = c.iter().rposition(|c| *c != 0.0).filter(|n| (1..=MAX_DEGREE).contains(n)) else { return };
    let mut report_root = |x: f64| x >= lo && x <= hi && stops_at(x);
    match *c {
        [b, a, ..] if degree == 1 => {
            report_root(-b / a);
        }
        [c, b, a, ..] if degree == 2 => {
            let both = solve_quadratic(a, b, c).map_or([f64::NAN; 2], |(x1, x2)| [x1, x2]);
            let _ = both.into_iter().any(report_root);
        }
        _ if degree == 3 => search_roots_between::<4>(&c[..=degree], lo, hi, &mut report_root),
        _ if degree == 4 => search_roots_between::<5>(&c[..=degree], lo, hi, &mut report_root),
        _ if degree == 5 => search_roots_between::<6>(&c[..=degree], lo, hi, &mut report_root),
        _ if degree == 6 => search_roots_between::<7>(&c[..=degree], lo, hi, &mut report_root),
        _ if degree == 7 => search_roots_between::<8>(&c[..=degree], lo, hi, &mut report_root),
        _ => search_roots_between::<{ MAX_DEGREE + 1 }>(&c[..=degree], lo, hi, &mut report_root),
    }
}

/// Finds the roots between `lo` and `hi`, which may be infinite, in ascending order, until `stops_at` returns true.
/// `stops_at` may also receive roots outside. Works in a unit that makes the first and the last coefficient similar,
/// and searches (-∞, -1], [-1, 0], [0, 1] and [1, ∞) one after another; where |x| is above 1, by xⁿ·p(1/x), whose
/// coefficients have the reverse order.
fn search_roots_between<const N: usize>(c: &[f64], lo: f64, hi: f64, stops_at: StopsAt) {
    let degree = if N <= EXACT { N - 1 } else { c.len() - 1 };
    let lowest = c.iter().position(|c| *c != 0.0).unwrap_or(0);
    let exponent = |x: f64| (x.to_bits() >> 52 & 0x7ff) as i32;
    let unit = match degree - lowest {
        0 => 1.0,
        n => power_of_two((exponent(c[lowest]) - exponent(c[degree])) / n as i32),
    };
    let mut a = [0.0; N];
    let mut power = 1.0;
    for (a, c) in a.iter_mut().zip(c) {
        *a = c * power;
        power *= unit;
    }
    let noise = tolerance::POLYNOMIAL * a.iter().map(|a| a.abs()).sum::<f64>();
    if !(noise.is_finite() && noise > 0.0) {
        return;
    }
    let mut below = a;
    below.iter_mut().skip(1).step_by(2).for_each(|a| *a = -*a);
    let (lo, hi) = (lo / unit, hi / unit);
    let done = std::cell::Cell::new(false);
    let mut report_root = |x: f64| {
        done.set(stops_at(x));
        done.get()
    };
    for (side, a) in [(-1.0, below), (1.0, a)] {
        let (near, far) = if side < 0.0 { (-hi, -lo) } else { (lo, hi) };
        if done.get() || far < 0.0 || sign_changes(&a[..=degree]) == 0 {
            continue;
        }
        let at_one: f64 = a.iter().sum();
        let inner = |stops_at: StopsAt, backwards| {
            let mut on_side = |t: f64| stops_at(side * unit * t);
            let mut search = Search { degree, noise, window: (near, far), backwards, stops_at: &mut on_side };
            near <= 1.0 && search.search_unit_is_over(&to_bernstein(a, degree, at_one))
        };
        let outer = |stops_at: StopsAt, backwards| {
            let mut turned = a;
            turned[..=degree].reverse();
            let mut on_side = |t: f64| stops_at(side * unit / t);
            let window = (1.0 / far, if near > 1.0 { 1.0 / near } else { 1.0 });
            let mut search = Search { degree, noise, window, backwards, stops_at: &mut on_side };
            far >= 1.0 && search.search_unit_is_over(&to_bernstein(turned, degree, at_one))
        };
        if side < 0.0 {
            let _ = outer(&mut report_root, false) || inner(&mut report_root, true);
        } else {
            let _ = inner(&mut report_root, false) || outer(&mut report_root, true);
        }
    }
}

/// Returns 2ᵏ, limited to the range of `f64`.
fn power_of_two(k: i32) -> f64 {
    f64::from_bits(((k.clamp(-1000, 1000) + 1023) as u64) << 52)
}

/// Returns the Bernstein coefficients bⱼ = Σᵢ C(j,i)/C(n,i)·aᵢ of a₀ + a₁·t + … on [0, 1]. The last one is the value at
/// 1, which the intervals on both sides must share to the last bit.
#[inline(always)]
fn to_bernstein<const N: usize>(mut a: [f64; N], degree: usize, value_at_one: f64) -> [f64; N] {
    for (a, inverse) in a.iter_mut().zip(&INVERSE_BINOMIALS[degree][..=degree]) {
        *a *= inverse;
    }
    for k in 1..degree + 1 {
        for j in (k..degree + 1).rev() {
            a[j] += a[j - 1];
        }
    }
    a[degree] = value_at_one;
    a
}

#[cfg(test)]
mod tests;
