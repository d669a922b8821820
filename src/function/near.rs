//! What is known of a function's numbers around a point, and of its gradients.

use super::Interval;
use crate::math::DVec3;

/// What is known of numbers around a point.
#[derive(Clone, Copy, Debug)]
pub struct Near {
    /// Where they lie.
    pub range: Interval,
    /// Where gradients are about.
    pub about: DVec3,
    /// No gradient is farther from that; infinite where nothing is known.
    pub steepest: f64,
    /// Nearly all gradients are far nearer to it than that.
    pub rough: bool,
}

/// Step of the differences that a gradient is computed by; those of noise are so known to 1e-7.
const STEP: f64 = 1e-4;
/// And what is not known of it is taken for as much.
const SLACK: f64 = 1e-6;

impl Near {
    /// Nothing.
    pub const UNKNOWN: Self = Self { range: Interval::ALL, about: DVec3::ZERO, steepest: f64::INFINITY, rough: false };

    /// No farther than `radius` from a point of this value, where no gradient is longer than `steepest`.
    pub fn of(value: f64, steepest: f64, radius: f64) -> Self {
        let far = steepest * radius;
        if !far.is_finite() {
            return Self::UNKNOWN;
        }
        Self { range: Interval::new(value - far, value + far).widened(), steepest, ..Self::UNKNOWN }
    }

    /// The same where gradients change by no more than `bend` along a way of length 1, as long as numbers are strictly `within`: they are
    /// about that at the point (Taylor's theorem).
    pub fn bent(self, at: impl Fn(DVec3) -> f64, bend: f64, radius: f64, within: Interval) -> Self {
        let turn = bend * radius + SLACK;
        if !(turn < self.steepest && self.range.lo > within.lo && self.range.hi < within.hi) {
            return self;
        }
        let by = |axis: DVec3| (at(axis * STEP) - at(axis * -STEP)) / (2.0 * STEP);
        let about = DVec3::new(by(DVec3::X), by(DVec3::Y), by(DVec3::Z));
        // |f(p) − f(0)| ≤ |g|·r + b·r²/2
        let far = (about.length() + SLACK + 0.5 * bend * radius) * radius;
        let value = 0.5 * (self.range.lo + self.range.hi);
        let range = self.range.shared(Interval::new(value - far, value + far).widened());
        Self { range, about, steepest: turn, ..self }
    }
}
