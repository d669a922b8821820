//! Where a function of one number is 0, by bounds of its derivative.

use crate::function::Interval;
use crate::math::crossing;

/// A place on the line, and the function's value there.
pub type Point = (f64, f64);

/// A function on a line.
pub struct Search<'a> {
    /// The value.
    pub value: &'a dyn Fn(f64) -> f64,
    /// Roots nearer together than this may count as none.
    pub apart: f64,
    /// Roots are known as well as this.
    pub exact: f64,
}

impl Search<'_> {
    /// Tells all roots between two places, ascending, until `found` says that it has enough. The derivative lies in `rate` there.
    ///
    /// From an end on, the value can't come to 0 sooner than by the rate: what is left between both ends is halved (as in Kalra and Barr,
    /// "Guaranteed Ray Intersections with Implicit Surfaces", 1989).
    pub fn between(&self, a: Point, b: Point, rate: Interval, found: &mut dyn FnMut(f64) -> bool) -> bool {
        let differ = (a.1 < 0.0) != (b.1 < 0.0);
        // How quickly the value can come nearer to 0, forwards from a and backwards from b.
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
            return found(crossing(self.value, a, b, self.exact));
        }
        let middle = 0.5 * (lo + hi);
        let m = (middle, (self.value)(middle));
        self.between(a, m, rate, found) || self.between(m, b, rate, found)
    }
}
