//! Rays, and the interval of a ray that is searched.

use super::{DVec3, tolerance};

/// Ray p(t) = origin + t·dir (lecture, "Ray").
///
/// `dir` has length 1 in world space only: a ray transformed to object space by M⁻¹ is **not** renormalised, so `t` is
/// the distance in world space everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Origin p₀ of the ray.
    pub origin: DVec3,
    /// Direction v of the ray, of length 1 in world space only.
    pub dir: DVec3,
}

impl Ray {
    /// Creates the ray from `origin` along `dir`, which the caller normalises where that matters.
    pub fn new(origin: DVec3, dir: DVec3) -> Self {
        Self { origin, dir }
    }

    /// True if all coordinates of origin and direction are finite.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        // 0·x is 0 for a finite x, and NaN otherwise: one comparison instead of six.
        (self.origin * 0.0 + self.dir * 0.0).element_sum() == 0.0
    }

    /// Returns the point p(t) = p₀ + t·v of the ray.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.dir * t
    }
}

/// Open interval of the ray parameter `t` in which a hit counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower end of the interval: hits with `t` at or below it do not count.
    pub min: f64,
    /// Upper end of the interval: hits with `t` at or above it do not count.
    pub max: f64,
}

impl Range {
    /// Interval of every `t`, also negative, as CSG needs.
    pub const ALL: Range = Range { min: f64::NEG_INFINITY, max: f64::INFINITY };
    /// Interval of the half-line: t > 0, as in the lecture.
    pub const FORWARD: Range = Range { min: 0.0, max: f64::INFINITY };
    /// Interval that contains no `t`.
    pub const EMPTY: Range = Range { min: f64::INFINITY, max: f64::NEG_INFINITY };

    /// Returns the intersection of two intervals of `t`.
    pub fn intersection(self, other: Range) -> Range {
        Range { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// Returns the interval with a `min` of `min_distance` or more. If `min` is less than [`tolerance::SURFACE`], as in
    /// a tiny scene, `min_distance` is reduced in the same proportion. A range that begins at or before 0 is unchanged.
    pub fn raised_to_min_distance(self, min_distance: f64) -> Range {
        let min_distance = min_distance * (self.min / tolerance::SURFACE).min(1.0);
        if self.min > 0.0 { Range { min: self.min.max(min_distance), ..self } } else { self }
    }

    /// True if the interval of `t` is empty.
    pub fn is_empty(&self) -> bool {
        self.min >= self.max
    }

    /// True if t is strictly inside the interval. (False for NaN.)
    pub fn contains(&self, t: f64) -> bool {
        t > self.min && t < self.max
    }
}
