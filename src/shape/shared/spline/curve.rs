//! A chain of Bézier segments with parameters from 0 to 1; all segments of a chain have one degree, 1 to 3.

use crate::math::{DVec2, bernstein_roots, solve_quadratic};
use serde::Serialize;

/// Curve of a lathe's or prism's outline. Each segment starts at exactly the end of the one before, unless it belongs
/// to another outline.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Curve {
    /// Degree of the curve: number of control points of a segment after the first.
    pub degree: usize,
    /// Control points of each segment of the curve; those beyond the degree are unused.
    pub segments: Vec<[DVec2; 4]>,
}

/// Value at t of a polynomial with these Bernstein coefficients, by de Casteljau's algorithm.
#[inline]
pub fn evaluate_bernstein(b: &[f64], t: f64) -> f64 {
    let between = |a: f64, b: f64| a + (b - a) * t;
    match *b {
        [a, b] => between(a, b),
        [a, b, c] => between(between(a, b), between(b, c)),
        [a, b, c, d] => {
            let (ab, bc, cd) = (between(a, b), between(b, c), between(c, d));
            between(between(ab, bc), between(bc, cd))
        }
        _ => evaluate_bernstein_of_any_degree(b, t),
    }
}

fn evaluate_bernstein_of_any_degree(b: &[f64], t: f64) -> f64 {
    let mut b: smallvec::SmallVec<[f64; 8]> = b.into();
    for last in (1..b.len()).rev() {
        for i in 0..last {
            b[i] += (b[i + 1] - b[i]) * t;
        }
    }
    b[0]
}

/// Derivative, by t, of the polynomial with the Bernstein coefficients `b`.
pub fn bernstein_derivative_at(b: &[f64], t: f64) -> f64 {
    let rises: smallvec::SmallVec<[f64; 8]> = b.windows(2).map(|w| w[1] - w[0]).collect();
    rises.len() as f64 * evaluate_bernstein(&rises, t)
}

/// Binomial coefficient C(n, k).
fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64)
}

/// Bernstein coefficients of a product of two polynomials. The first and last are exactly the products of the first and
/// last factors.
pub fn bernstein_product(f: &[f64], g: &[f64]) -> Vec<f64> {
    let (m, n) = (f.len() - 1, g.len() - 1);
    let term = |i: usize, k: usize| binomial(m, i) * binomial(n, k - i) / binomial(m + n, k) * (f[i] * g[k - i]);
    (0..=m + n).map(|k| (k.saturating_sub(n)..=k.min(m)).map(|i| term(i, k)).sum()).collect()
}

impl Curve {
    /// Control points of a segment of the curve.
    #[inline]
    pub fn control_points(&self, segment: usize) -> &[DVec2] {
        &self.segments[segment][..=self.degree]
    }

    /// Point of the curve's segment at t.
    #[inline]
    pub fn point_at(&self, segment: usize, t: f64) -> DVec2 {
        let along = |axis: usize| evaluate_bernstein(&self.affine_bernstein_coefficients(segment, |p| p[axis]), t);
        DVec2::new(along(0), along(1))
    }

    /// Derivative of the curve's segment at t, not normalized; where the derivative is zero, the chord from the first
    /// to the last control point. Zero if both are.
    pub fn tangent(&self, segment: usize, t: f64) -> DVec2 {
        let along = |axis: usize| bernstein_derivative_at(&self.affine_bernstein_coefficients(segment, |p| p[axis]), t);
        let tangent = DVec2::new(along(0), along(1));
        if tangent != DVec2::ZERO {
            return tangent;
        }
        // A cusp, or coinciding control points.
        let c = self.control_points(segment);
        c[self.degree] - c[0]
    }

    /// Bernstein coefficients, along a segment of the curve, of an affine function of the point.
    #[inline]
    pub fn affine_bernstein_coefficients(
        &self,
        segment: usize,
        f: impl Fn(DVec2) -> f64,
    ) -> smallvec::SmallVec<[f64; 4]> {
        let mut all = [0.0; 4];
        all.iter_mut().zip(self.control_points(segment)).for_each(|(to, p)| *to = f(*p));
        smallvec::SmallVec::from_buf_and_len(all, self.control_points(segment).len())
    }

    /// True if the number of crossings between the curve's outlines and a half-line at height y is odd. `is_on_half_line`
    /// returns true for an x on the half-line; all x between two such x are on it too.
    pub fn is_crossed_oddly(&self, y: f64, is_on_half_line: impl Fn(f64) -> bool) -> bool {
        let mut odd = false;
        for segment in 0..self.segments.len() {
            let height = self.affine_bernstein_coefficients(segment, |p| p.y - y);
            let [mut all, mut none] = [true; 2];
            for p in self.control_points(segment) {
                let counts = is_on_half_line(p.x);
                (all, none) = (all && counts, none && !counts);
            }
            if none {
                continue;
            }
            if all {
                // Between values of different signs there is an odd number of roots, and all of them count.
                odd ^= (height[0] < 0.0) != (height[self.degree] < 0.0);
                continue;
            }
            bernstein_roots(&height, &mut |t| {
                odd ^= is_on_half_line(evaluate_bernstein(&self.affine_bernstein_coefficients(segment, |p| p.x), t));
                false
            });
        }
        odd
    }

    /// Minimum and maximum coordinates of the points of the curve.
    pub fn curve_bounds(&self) -> (DVec2, DVec2) {
        let (mut min, mut max) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let mut reach = |p: DVec2| (min, max) = (min.min(p), max.max(p));
        for segment in 0..self.segments.len() {
            let c = self.control_points(segment);
            reach(c[0]);
            reach(c[self.degree]);
            for axis in 0..2 {
                let b = self.affine_bernstein_coefficients(segment, |p| p[axis]);
                bernstein_derivative_roots(&b).into_iter().flatten().for_each(|t| reach(self.point_at(segment, t)));
            }
        }
        (min, max)
    }

    /// Minimum and maximum coordinates of the curve's control points.
    pub fn control_bounds(&self) -> (DVec2, DVec2) {
        let all = (0..self.segments.len()).flat_map(|segment| self.control_points(segment).iter().copied());
        all.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(min, max), p| (min.min(p), max.max(p)))
    }
}

/// Roots strictly between 0 and 1 of the derivative of the polynomial with the Bernstein coefficients `b`, of degree 2
/// or 3; `None` in place of a missing root, and for other degrees.
pub fn bernstein_derivative_roots(b: &[f64]) -> [Option<f64>; 2] {
    let rise: smallvec::SmallVec<[f64; 4]> = b.windows(2).map(|w| w[1] - w[0]).collect();
    let (x, y) = match rise[..] {
        [a, b] => (a / (a - b), f64::NAN),
        // a·(1-t)² + 2b·t·(1-t) + c·t²
        [a, b, c] => solve_quadratic(a - 2.0 * b + c, 2.0 * (b - a), a).unwrap_or((f64::NAN, f64::NAN)),
        _ => (f64::NAN, f64::NAN),
    };
    [x, y].map(|t| Some(t).filter(|t| *t > 0.0 && *t < 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Curve {
        let p = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (0.0, 0.0)].map(|(x, y)| DVec2::new(x, y));
        Curve { degree: 1, segments: p.windows(2).map(|w| [w[0], w[1], DVec2::ZERO, DVec2::ZERO]).collect() }
    }

    #[test]
    fn products_and_slopes() {
        // (1 + t)·(3 - t²) with t² as 0, 0, 1
        let f = bernstein_product(&[1.0, 2.0], &[3.0, 3.0, 2.0]);
        for t in [0.0, 0.3, 1.0] {
            assert!((evaluate_bernstein(&f, t) - (1.0 + t) * (3.0 - t * t)).abs() < 1e-15);
            assert!((bernstein_derivative_at(&f, t) - (3.0 - t * t - 2.0 * t * (1.0 + t))).abs() < 1e-14);
        }
    }

    #[test]
    fn inside_of_a_square_level_with_its_corners() {
        let inside = |x: f64, y: f64| square().is_crossed_oddly(y, |at| at > x);
        for (x, y, want) in
            [(1.0, 1.0, true), (3.0, 1.0, false), (-1.0, 1.0, false), (-1.0, 0.0, false), (-1.0, 2.0, false)]
        {
            assert_eq!(inside(x, y), want, "{x} {y}");
        }
    }

    #[test]
    fn ends_of_an_arch() {
        let p = [(0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (3.0, 0.0)].map(|(x, y)| DVec2::new(x, y));
        let arch = Curve { degree: 3, segments: vec![p] };
        assert_eq!(arch.curve_bounds(), (DVec2::ZERO, DVec2::new(3.0, 0.75)));
        assert_eq!(arch.control_bounds(), (DVec2::ZERO, DVec2::new(3.0, 1.0)));
        assert!(arch.tangent(0, 0.5).y.abs() < 1e-15);
    }
}
