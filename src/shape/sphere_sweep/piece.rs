//! One piece of a sweep: a sphere whose centre and radius are polynomials of a parameter from 0 to 1.
//!
//! On a ray o + s·v with |v| = 1, the sphere at the parameter t covers b(t) ± √Δ(t), where b is the position of its
//! centre along the ray and Δ = r² - |vector from the ray to the centre|². Where Δ ≥ 0 on an interval of t, all these
//! spheres together cover one interval of the ray, from the minimum of b - √Δ to the maximum of b + √Δ. There Δ'² =
//! 4·b'²·Δ; an error in such a t has only a quadratic effect.

use crate::math::{Aabb, DVec3, bernstein_roots};
use serde::Serialize;
use smallvec::SmallVec;

/// Binomial coefficients C(n, k) for n up to 10.
const BINOMIALS: [[f64; 11]; 11] = {
    let mut table = [[0.0; 11]; 11];
    let mut n = 0;
    while n <= 10 {
        table[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            table[n][k] = table[n - 1][k - 1] + table[n - 1][k];
            k += 1;
        }
        n += 1;
    }
    table
};

/// Piece of a sphere sweep's path: Bernstein coefficients of centre and radius.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Piece {
    /// Bernstein coefficients of the sphere's centre along the piece.
    pub centers: [DVec3; 4],
    /// Bernstein coefficients of the sphere's radius along the piece.
    pub radii: [f64; 4],
    /// Degree of the piece, 1 or 3; at 1 the last two coefficients are unused.
    pub degree: usize,
}

/// Interval of a ray that spheres of one piece of a sphere sweep cover without a gap; each end with its position on the
/// piece.
pub type Cover = [(f64, f64); 2];

/// Function that receives each interval of a ray that a sphere sweep covers.
type Visit<'a> = &'a mut dyn FnMut(Cover);

/// A polynomial of degree N - 1: its Bernstein coefficients, each multiplied by C(n, k), so that products are plain
/// sums.
#[derive(Clone, Copy)]
struct Scaled<const N: usize>([f64; N]);

impl<const N: usize> Scaled<N> {
    fn new(b: &[f64; N]) -> Self {
        Self(std::array::from_fn(|k| b[k] * BINOMIALS[N - 1][k]))
    }

    fn coefficients(&self) -> [f64; N] {
        std::array::from_fn(|k| self.0[k] / BINOMIALS[N - 1][k])
    }

    fn times<const M: usize, const R: usize>(&self, other: &Scaled<M>) -> Scaled<R> {
        let mut out = [0.0; R];
        for (i, x) in self.0.iter().enumerate() {
            for (j, y) in other.0.iter().enumerate() {
                out[i + j] += x * y;
            }
        }
        Scaled(out)
    }

    fn minus_multiple(mut self, other: Self, factor: f64) -> Self {
        self.0.iter_mut().zip(other.0).for_each(|(x, y)| *x -= factor * y);
        self
    }
}

/// Value at t of a polynomial with these Bernstein coefficients, by de Casteljau's algorithm.
fn evaluate_bernstein<const N: usize>(mut b: [f64; N], t: f64) -> f64 {
    for last in (1..N).rev() {
        for i in 0..last {
            b[i] += (b[i + 1] - b[i]) * t;
        }
    }
    b[0]
}

/// Bernstein coefficients of a polynomial's derivative.
fn bernstein_derivative<const N: usize, const M: usize>(b: &[f64; N]) -> [f64; M] {
    std::array::from_fn(|k| (b[k + 1] - b[k]) * M as f64)
}

impl Piece {
    /// Creates a piece of a sphere sweep whose spheres are on a straight path.
    pub fn straight(from: (DVec3, f64), to: (DVec3, f64)) -> Self {
        Self { centers: [from.0, to.0, to.0, to.0], radii: [from.1, to.1, to.1, to.1], degree: 1 }
    }

    /// Creates a piece of a sphere sweep from Bernstein coefficients.
    pub fn curved(b: [(DVec3, f64); 4]) -> Self {
        Self { centers: b.map(|ball| ball.0), radii: b.map(|ball| ball.1), degree: 3 }
    }

    /// Bounding box of the piece of a sphere sweep.
    pub fn bounds(&self) -> Aabb {
        let ball = |k: usize| {
            let reach = DVec3::splat(self.radii[k].abs());
            Aabb { min: self.centers[k] - reach, max: self.centers[k] + reach }
        };
        (0..=self.degree).map(ball).fold(Aabb::EMPTY, Aabb::union)
    }

    /// Centre and radius of the sphere at position t of the piece.
    pub fn sphere_at(&self, t: f64) -> (DVec3, f64) {
        let b = &self.centers;
        if self.degree == 1 {
            return (b[0] + (b[1] - b[0]) * t, self.radii[0] + (self.radii[1] - self.radii[0]) * t);
        }
        let along = |axis: usize| evaluate_bernstein(b.map(|p| p[axis]), t);
        (DVec3::new(along(0), along(1), along(2)), evaluate_bernstein(self.radii, t))
    }

    /// True if the point is in one of the spheres of the piece.
    pub fn contains(&self, p: DVec3) -> bool {
        match self.degree {
            1 => self.contains_by::<2, 3>(p),
            _ => self.contains_by::<4, 7>(p),
        }
    }

    fn contains_by<const N: usize, const D: usize>(&self, p: DVec3) -> bool {
        let depth = self.squared_depth_polynomial::<N, D>(|center| center - p).coefficients();
        let mut holds = depth[0] > 0.0;
        bernstein_roots(&depth, &mut |_| {
            holds = true;
            true
        });
        holds
    }

    /// Bernstein coefficients of r² - |offset|² along the piece of a sphere sweep.
    fn squared_depth_polynomial<const N: usize, const D: usize>(
        &self,
        offset_from_center: impl Fn(DVec3) -> DVec3,
    ) -> Scaled<D> {
        let square = |value: &dyn Fn(usize) -> f64| {
            let scaled = Scaled::<N>::new(&std::array::from_fn(value));
            scaled.times::<N, D>(&scaled)
        };
        let ways: [DVec3; N] = std::array::from_fn(|k| offset_from_center(self.centers[k]));
        let radius2 = square(&|k| self.radii[k]);
        (0..3).fold(radius2, |sum, axis| sum.minus_multiple(square(&|k| ways[k][axis]), 1.0))
    }

    /// Calls `visit` with the intervals of a line that the spheres of the piece cover, in any order; intervals can
    /// overlap.
    pub fn visit_covered(&self, line: &Line, visit: Visit) {
        match self.degree {
            1 => self.visit_covered_by::<2, 1, 1, 3, 2, 3>(line, visit),
            _ => self.visit_covered_by::<4, 3, 5, 7, 6, 11>(line, visit),
        }
    }

    /// Finds the intervals of a line that the piece covers. The type parameters count coefficients: of the centre, of
    /// b', of b'², of Δ, of Δ', and of Δ'² - 4·b'²·Δ.
    fn visit_covered_by<
        const N: usize,
        const B: usize,
        const B2: usize,
        const D: usize,
        const S: usize,
        const Q: usize,
    >(
        &self,
        line: &Line,
        visit: Visit,
    ) {
        // Start from the ray's point nearest to a point of the piece, so that a distant origin costs no digits.
        let start = (self.centers[0] - line.o).dot(line.v);
        let o = line.o + line.v * start;
        let scaled = self.squared_depth_polynomial::<N, D>(|center| {
            let way = center - o;
            way - line.v * way.dot(line.v)
        });
        let delta = scaled.coefficients();
        if delta.iter().all(|d| *d < 0.0) {
            return;
        }
        let along: [f64; N] = std::array::from_fn(|k| (self.centers[k] - o).dot(line.v));
        let (speed, bend): ([f64; B], [f64; S]) = (bernstein_derivative(&along), bernstein_derivative(&delta));
        let (b1, d1) = (Scaled::new(&speed), Scaled::new(&bend));
        let extremes = d1.times::<S, Q>(&d1).minus_multiple(b1.times::<B, B2>(&b1).times::<D, Q>(&scaled), 4.0);
        let mut places: SmallVec<[f64; 16]> = SmallVec::new();
        let mut keep = |t: f64| {
            places.push(t);
            false
        };
        bernstein_roots(&extremes.coefficients(), &mut keep);
        // Where b' is nearly 0, both extrema are here, too close to be separated.
        bernstein_roots(&bend, &mut keep);
        let mut reach = |from: f64, to: f64| {
            let mut cover = [(f64::INFINITY, from), (f64::NEG_INFINITY, from)];
            for t in places.iter().copied().filter(|t| *t > from && *t < to).chain([from, to]) {
                let (middle, half) =
                    (start + evaluate_bernstein(along, t), evaluate_bernstein(delta, t).max(0.0).sqrt());
                if middle - half < cover[0].0 {
                    cover[0] = (middle - half, t);
                }
                if middle + half > cover[1].0 {
                    cover[1] = (middle + half, t);
                }
            }
            visit(cover);
        };
        let mut from = if delta[0] < 0.0 { None } else { Some(0.0) };
        bernstein_roots(&delta, &mut |t| {
            match from.take() {
                Some(from) => reach(from, t),
                None => from = Some(t),
            }
            false
        });
        if let Some(from) = from {
            reach(from, 1.0);
        }
    }
}

/// A line o + s·v with |v| = 1.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Point o of the line, at s = 0.
    pub o: DVec3,
    /// Direction v of the line, of length 1.
    pub v: DVec3,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covers(piece: &Piece, o: [f64; 3], v: DVec3) -> Vec<[f64; 2]> {
        let mut all = vec![];
        piece.visit_covered(&Line { o: o.into(), v: v.normalize() }, &mut |c| all.push([c[0].0, c[1].0]));
        all
    }

    #[test]
    fn straight() {
        let rod = Piece::straight((DVec3::ZERO, 1.0), (DVec3::X * 4.0, 1.0));
        assert_eq!(covers(&rod, [2.0, 0.6, -5.0], DVec3::Z), [[4.2, 5.8]]);
        assert_eq!(covers(&rod, [2.0, 1.1, -5.0], DVec3::Z), [[0.0; 2]; 0]);
        assert_eq!(covers(&rod, [-5.0, 0.0, 0.0], DVec3::X), [[4.0, 10.0]]);
        // A cone that touches the spheres where its sine is 1/4.
        let cone = Piece::straight((DVec3::ZERO, 0.0), (DVec3::X * 4.0, 1.0));
        let tangent = 0.25 / (1.0_f64 - 0.0625).sqrt();
        let [[near, far]] = covers(&cone, [2.0, -5.0, 0.0], DVec3::Y)[..] else { unreachable!() };
        assert!(
            (near - 5.0 + 2.0 * tangent).abs() < 1e-15 && (far - 5.0 - 2.0 * tangent).abs() < 1e-15,
            "{near} {far}"
        );
        assert!(cone.contains(DVec3::new(2.0, 0.516, 0.0)) && !cone.contains(DVec3::new(2.0, 0.517, 0.0)));
        assert!(!cone.contains(DVec3::new(-0.1, 0.0, 0.0)));
    }

    #[test]
    fn an_arch_is_met_twice() {
        let at = |x: f64, y: f64| (DVec3::new(x, y, 0.0), 0.25);
        let arch = Piece::curved([at(0.0, 0.0), at(1.0, 4.0), at(3.0, 4.0), at(4.0, 0.0)]);
        let mut both = covers(&arch, [-5.0, 1.5, 0.0], DVec3::X);
        both.sort_by(|a, b| a[0].total_cmp(&b[0]));
        assert!(both.len() == 2 && both[0][1] < 7.0 && both[1][0] > 7.0, "{both:?}");
        assert!((both[0][0] + both[1][1] - 14.0).abs() < 1e-12, "{both:?}");
        // Compare with a dense row of spheres.
        let nearest = (0..=100_000).filter_map(|k| {
            let (c, r) = arch.sphere_at(f64::from(k) / 1e5);
            let depth = r * r - (c.y - 1.5).powi(2);
            (depth > 0.0).then(|| c.x + 5.0 - depth.sqrt())
        });
        let nearest = nearest.fold(f64::INFINITY, f64::min);
        assert!((nearest - both[0][0]).abs() < 1e-8, "{nearest} {both:?}");
    }
}
