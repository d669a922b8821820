//! Roots of a function of one variable, by bounds of its derivative.

use crate::function::Interval;
use crate::math::{Range, root_between};

/// A position on a ray, and the isosurface's function there.
pub type Point = (f64, f64);

/// Search for the roots of an isosurface's function along a ray.
pub struct Search<'a> {
    /// Function of the position on the ray, whose roots are searched.
    pub value: &'a dyn Fn(f64) -> f64,
    /// Distance between roots below which both can be missed.
    pub apart: f64,
    /// Maximum error of a root before the position `ahead`.
    pub exact: f64,
    /// Maximum error of a root from the position `ahead` on.
    pub roughly: f64,
    /// Position of the ray's origin on the line that is searched.
    pub ahead: f64,
    /// Range of positions in which roots count.
    pub range: Range,
}

impl Search<'_> {
    /// Calls `stops_at` with all roots between two points, ascending, until it returns true. `rate` bounds the
    /// derivative there.
    ///
    /// From an end on, the value cannot reach 0 sooner than the rate allows: the rest is bisected (as in Kalra and
    /// Barr, "Guaranteed Ray Intersections with Implicit Surfaces", 1989).
    pub fn any_root_between(&self, a: Point, b: Point, rate: Interval, stops_at: &mut dyn FnMut(f64) -> bool) -> bool {
        if b.0 <= self.range.min || a.0 >= self.range.max {
            return false;
        }
        let differ = (a.1 < 0.0) != (b.1 < 0.0);
        // Maximum rate at which the value approaches 0, forwards from a and backwards from b.
        let from_a = if a.1 < 0.0 { rate.hi } else { -rate.lo };
        let from_b = if b.1 < 0.0 { -rate.lo } else { rate.hi };
        let reach = |value: f64, speed: f64| if speed > 0.0 { value.abs() / speed } else { f64::INFINITY };
        let (lo, hi) = (a.0 + reach(a.1, from_a), b.0 - reach(b.1, from_b));
        if !differ && (hi - lo).is_nan() | (hi - lo <= self.apart) {
            return false;
        }
        let one_way = if a.1 < 0.0 { rate.lo >= 0.0 } else { rate.hi <= 0.0 };
        let (lo, hi) = (lo.clamp(a.0, b.0), hi.clamp(a.0, b.0));
        if differ && (one_way || hi - lo <= self.apart) {
            return self.only_root_between(a, b).is_some_and(stops_at);
        }
        let middle = 0.5 * (lo + hi);
        let m = (middle, (self.value)(middle));
        self.any_root_between(a, m, rate, stops_at) || self.any_root_between(m, b, rate, stops_at)
    }

    /// Returns the only root between two points, if it is in the range.
    fn only_root_between(&self, a: Point, b: Point) -> Option<f64> {
        let Range { min, max } = self.range;
        let is_before = |t: f64| ((self.value)(t) < 0.0) != (a.1 < 0.0);
        if a.0 < min && is_before(min) || b.0 > max && !is_before(max) {
            return None;
        }
        Some(root_between(self.value, a, b, if a.0 < self.ahead { self.exact } else { self.roughly }))
    }
}
