//! Bounds on a function's or pattern's numbers around a point, and on their gradients.

use super::Interval;
use crate::math::DVec3;

/// Bounds of a function or pattern, and of its gradient, over all points within a radius of one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalBounds {
    /// Range of the function's values within the radius.
    pub range: Interval,
    /// Centre of the ball that contains all gradients.
    pub gradient: DVec3,
    /// Radius of the ball that contains all gradients; infinite where the function jumps, or where no useful bound is
    /// known.
    pub steepest: f64,
    /// True if nearly all gradients are far nearer to `gradient` than `steepest`.
    pub rough: bool,
}

/// Step of the central differences that approximate a gradient; gradients of noise are then accurate to 1e-7.
const STEP: f64 = 1e-4;
/// Upper bound of the error of a gradient from central differences.
const SLACK: f64 = 1e-6;

impl LocalBounds {
    /// Local bounds of a function about which nothing is known.
    pub const UNKNOWN: Self =
        Self { range: Interval::ALL, gradient: DVec3::ZERO, steepest: f64::INFINITY, rough: false };

    /// Returns the local bounds of a constant.
    pub fn constant(value: f64) -> Self {
        Self { range: Interval::point(value), steepest: 0.0, ..Self::UNKNOWN }
    }

    /// Returns local bounds of a function within `radius` of a point where it has this value, if no gradient is longer
    /// than `steepest`.
    pub fn from_max_gradient(value: f64, steepest: f64, radius: f64) -> Self {
        let far = steepest * radius;
        if !(value.is_finite() && far.is_finite()) {
            return Self::UNKNOWN;
        }
        Self { range: Interval::new(value - far, value + far).widened_by_rounding(), steepest, ..Self::UNKNOWN }
    }

    /// Returns local bounds of a function that differs by at most `max_deviation` from a value; no gradient is longer
    /// than `steepest`, and nearly all are far shorter.
    pub fn from_deviation(value: f64, max_deviation: f64, steepest: f64) -> Self {
        Self { steepest, rough: true, ..Self::from_max_gradient(value, max_deviation, 1.0) }
    }

    /// Clamps the range of the function's values to [lo, hi].
    pub fn clamp_range(self, lo: f64, hi: f64) -> Self {
        Self { range: Interval { lo: self.range.lo.clamp(lo, hi), hi: self.range.hi.clamp(lo, hi) }, ..self }
    }

    /// Returns the local bounds of the function's fractional part.
    pub fn fractional_part_bounds(self) -> Self {
        let whole = self.range.lo.floor();
        if whole == self.range.hi.floor() {
            let range = Interval { lo: self.range.lo - whole, hi: self.range.hi - whole };
            Self { range, ..self }
        } else {
            Self { range: Interval::TRUTH, ..Self::UNKNOWN }
        }
    }

    /// Returns tighter local bounds where gradients change by at most `max_gradient_change` per unit of length while
    /// the numbers are strictly inside `valid_range`: all gradients are then near the one at the point (Taylor's theorem).
    /// `value_at_offset` gives the number at an offset from the point.
    pub fn tightened_by_gradient_change(
        self,
        value_at_offset: impl Fn(DVec3) -> f64,
        max_gradient_change: f64,
        radius: f64,
        valid_range: Interval,
    ) -> Self {
        let turn = max_gradient_change * radius + SLACK;
        if !(turn < self.steepest && self.range.lo > valid_range.lo && self.range.hi < valid_range.hi) {
            return self;
        }
        let by = |axis: DVec3| (value_at_offset(axis * STEP) - value_at_offset(axis * -STEP)) / (2.0 * STEP);
        let gradient = DVec3::new(by(DVec3::X), by(DVec3::Y), by(DVec3::Z));
        // |f(p) − f(0)| ≤ |g|·r + b·r²/2
        let far = (gradient.length() + SLACK + 0.5 * max_gradient_change * radius) * radius;
        let value = 0.5 * (self.range.lo + self.range.hi);
        let range = self.range.intersection_or_self(Interval::new(value - far, value + far).widened_by_rounding());
        Self { range, gradient, steepest: turn, ..self }
    }
}
