//! Polynomials of the second order in x, y and z, and the bounding box of the set where one is not positive: a
//! hyperboloid between two planes across its axis is bounded on all sides.

use super::{Aabb, DMat3, DVec3, Transform, solve_quadratic, tolerance};

/// Relative rounding error of sums and products of a few numbers, with a large reserve.
const ROUNDING: f64 = 1e-13;

/// Quadratic function of a point p: w·Qw + 2·h·w + c with w = p - center.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic {
    /// Symmetric matrix Q of the quadratic terms.
    pub q: DMat3,
    /// Half of the coefficients of the quadratic function's linear terms.
    pub h: DVec3,
    /// Value of the quadratic function at its centre.
    pub c: f64,
    /// Point about which the quadratic function is expanded; numbers are small if it is near the middle of the surface.
    pub center: DVec3,
}

impl Quadratic {
    /// Returns the transformed quadratic function: q(M⁻¹·p) at a point p of the outer space.
    pub fn transformed(&self, transform: &Transform) -> Self {
        let a = transform.inv.matrix3;
        Self {
            q: a.transpose() * self.q * a,
            h: a.transpose() * self.h,
            c: self.c,
            center: transform.transform_point(self.center),
        }
    }

    /// Returns the quadratic function with the opposite sign, which exchanges inside and outside.
    pub fn negated(&self) -> Self {
        Self { q: -self.q, h: -self.h, c: -self.c, ..*self }
    }

    /// Bounding box of all points in `around` where the quadratic function is not positive.
    pub fn nonpositive_bounds_within(&self, around: Aabb) -> Aabb {
        let numbers = [self.q.x_axis, self.q.y_axis, self.q.z_axis, self.h, self.center];
        if around.is_empty() || !numbers.iter().all(|v| v.is_finite()) || !self.c.is_finite() {
            return around;
        }
        let squares = self.diagonal_lower_bound_coefficients();
        let mut within = Aabb { min: around.min - self.center, max: around.max - self.center };
        // A tighter interval along one axis may tighten another.
        for _ in 0..2 {
            for axis in 0..3 {
                let Some((lo, hi)) = self.nonpositive_interval_along(axis, squares, &within) else {
                    return Aabb::EMPTY;
                };
                within.min[axis] = within.min[axis].max(lo);
                within.max[axis] = within.max[axis].min(hi);
            }
        }
        let found = Aabb { min: within.min + self.center, max: within.max + self.center };
        let finite = |v: DVec3| v.map(|x| if x.is_finite() { x.abs() } else { 0.0 }).max_element();
        let size = finite(found.min).max(finite(found.max)).max(finite(self.center)).max(1.0);
        found.grown(tolerance::BOUNDS * size).intersection(around)
    }

    /// Returns coefficients s of a lower bound without mixed terms: s with s·w² ≤ w·Qw: 2·q·x·y is at least -|q|·(x² +
    /// y²). Zeros stay zeros, all else is rounded downwards.
    fn diagonal_lower_bound_coefficients(&self) -> DVec3 {
        let columns = [self.q.x_axis, self.q.y_axis, self.q.z_axis];
        let size = columns.iter().map(|c| c.abs().max_element()).fold(0.0, f64::max);
        let least = |i: usize| match columns[i] {
            column if column == DVec3::ZERO => 0.0,
            column => column[i] - (column.abs().element_sum() - column[i].abs()) - ROUNDING * size,
        };
        DVec3::new(least(0), least(1), least(2))
    }

    /// Returns the interval along an axis where the quadratic function can be 0 or less, given the intervals along the
    /// other axes; `None` if it is empty.
    fn nonpositive_interval_along(
        &self,
        axis: usize,
        diagonal_coefficients: DVec3,
        within: &Aabb,
    ) -> Option<(f64, f64)> {
        let others = [(axis + 1) % 3, (axis + 2) % 3];
        let least = others
            .map(|i| quadratic_minimum_value(diagonal_coefficients[i], 2.0 * self.h[i], within.min[i], within.max[i]));
        let sizes = self.c.abs() + least[0].abs() + least[1].abs();
        // a·x² + b·x + rest ≤ 0
        let (a, b, rest) =
            (diagonal_coefficients[axis], 2.0 * self.h[axis], self.c + least[0] + least[1] - ROUNDING * sizes);
        let everywhere = Some((f64::NEG_INFINITY, f64::INFINITY));
        if !rest.is_finite() || a < 0.0 {
            return everywhere;
        }
        match (a == 0.0, b == 0.0) {
            (true, true) if rest > 0.0 => None,
            (true, true) => everywhere,
            (true, false) if b > 0.0 => Some((f64::NEG_INFINITY, -rest / b)),
            (true, false) => Some((-rest / b, f64::INFINITY)),
            (false, _) => solve_quadratic(a, b, rest),
        }
    }
}

/// The least value of a·x² + b·x between two positions, which may be infinite.
fn quadratic_minimum_value(a: f64, b: f64, lo: f64, hi: f64) -> f64 {
    let value = |x: f64| match x.is_finite() {
        true => (a * x + b) * x,
        false if a != 0.0 => a * f64::INFINITY,
        false if b != 0.0 => b * x,
        false => 0.0,
    };
    let apex = -b / (2.0 * a);
    let ends = value(lo).min(value(hi));
    if a > 0.0 && apex > lo && apex < hi { value(apex) } else { ends }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ROUND_Y: Quadratic =
        Quadratic { q: DMat3::from_diagonal(DVec3::new(1.0, -1.0, 1.0)), h: DVec3::ZERO, c: -1.0, center: DVec3::ZERO };

    fn slab(lo: f64, hi: f64) -> Aabb {
        Aabb {
            min: DVec3::new(f64::NEG_INFINITY, lo, f64::NEG_INFINITY),
            max: DVec3::new(f64::INFINITY, hi, f64::INFINITY),
        }
    }

    fn near(found: Aabb, min: DVec3, max: DVec3) -> bool {
        found.min.distance(min) < 1e-5 && found.max.distance(max) < 1e-5
    }

    #[test]
    fn cut_across_the_axis() {
        // x² + z² ≤ 1 + y²
        let r = 5f64.sqrt();
        assert!(near(
            ROUND_Y.nonpositive_bounds_within(slab(-1.0, 2.0)),
            DVec3::new(-r, -1.0, -r),
            DVec3::new(r, 2.0, r)
        ));
        // Rotated about its axis, scaled, translated.
        let m = Transform::rotate(DVec3::Y * 33.0).then(&Transform::scale(DVec3::splat(2.0)).unwrap());
        let m = m.then(&Transform::translate(DVec3::new(1000.0, 5.0, 0.0)));
        let found = ROUND_Y.transformed(&m).nonpositive_bounds_within(slab(3.0, 9.0));
        assert!(near(found, DVec3::new(1000.0 - 2.0 * r, 3.0, -2.0 * r), DVec3::new(1000.0 + 2.0 * r, 9.0, 2.0 * r)));
        // Unbounded along the axis, it is unbounded across; its outside is unbounded.
        assert_eq!(ROUND_Y.nonpositive_bounds_within(Aabb::INFINITE), Aabb::INFINITE);
        assert_eq!(ROUND_Y.negated().nonpositive_bounds_within(slab(-1.0, 2.0)), slab(-1.0, 2.0));
        assert!(ROUND_Y.nonpositive_bounds_within(Aabb::EMPTY).is_empty());
    }

    #[test]
    fn bowls_and_pipes() {
        // x² + z² ≤ y, bounded above: the lower bound follows.
        let bowl =
            Quadratic { q: DMat3::from_diagonal(DVec3::new(1.0, 0.0, 1.0)), h: DVec3::Y * -0.5, c: 0.0, ..ROUND_Y };
        let found = bowl.nonpositive_bounds_within(slab(f64::NEG_INFINITY, 4.0));
        assert!(near(found, DVec3::new(-2.0, 0.0, -2.0), DVec3::new(2.0, 4.0, 2.0)), "{found:?}");
        assert!(bowl.nonpositive_bounds_within(slab(-9.0, -1.0)).is_empty());
        let pipe = Quadratic { h: DVec3::ZERO, c: -4.0, ..bowl };
        let found = pipe.nonpositive_bounds_within(Aabb::INFINITE);
        assert!(found.min.x < -2.0 && found.min.x > -2.1 && found.max.y == f64::INFINITY && found.max.z < 2.1);
    }

    fn vector() -> impl Strategy<Value = DVec3> {
        (-3.0..3.0, -3.0..3.0, -3.0..3.0f64).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    proptest! {
        #[test]
        fn bounds_contain_the_inside(d in vector(), m in vector(), h in vector(), c in -3.0..3.0f64, p in vector(), center in vector()) {
            let q = DMat3::from_cols_array(&[d.x, m.x, m.y, m.x, d.y, m.z, m.y, m.z, d.z]);
            let quadratic = Quadratic { q, h, c, center };
            let w = p - center;
            let around = Aabb::from_corners(DVec3::NEG_ONE, DVec3::new(3.0, f64::INFINITY, 2.0));
            if around.contains(p) && w.dot(q * w + 2.0 * h) + c <= 0.0 {
                prop_assert!(quadratic.nonpositive_bounds_within(around).contains(p));
            }
        }
    }
}
