//! The half-line that is cast, and the piece of it that is searched.

use super::{DVec3, tolerance};

/// p(t) = origin + t·dir (lecture, "Ray").
///
/// `dir` has length 1 in world space only: a ray brought into an object's space by M⁻¹ is **not**
/// renormalised, so `t` is the distance in world space everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// p₀.
    pub origin: DVec3,
    /// v.
    pub dir: DVec3,
}

impl Ray {
    /// The ray from `origin` along `dir`, which the caller has normalised where that matters.
    pub fn new(origin: DVec3, dir: DVec3) -> Self {
        Self { origin, dir }
    }

    /// p(t).
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.dir * t
    }
}

/// The open interval of `t` in which a hit counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Hits at or before it do not count.
    pub min: f64,
    /// Hits at or behind it do not count.
    pub max: f64,
}

impl Range {
    /// Every t, also negative: what CSG asks for.
    pub const ALL: Range = Range { min: f64::NEG_INFINITY, max: f64::INFINITY };
    /// The half-line of the lecture: t > 0.
    pub const FORWARD: Range = Range { min: 0.0, max: f64::INFINITY };

    /// What both have in common.
    pub fn and(self, other: Range) -> Range {
        Range { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// Without what lies nearer than `least`, where what lies nearest is left out already; of a range that begins nearer than at
    /// [`tolerance::SURFACE`], as a part of that.
    pub fn ahead(self, least: f64) -> Range {
        let least = least * (self.min / tolerance::SURFACE).min(1.0);
        if self.min > 0.0 { Range { min: self.min.max(least), ..self } } else { self }
    }

    /// Is there nothing between the ends?
    pub fn is_empty(&self) -> bool {
        self.min >= self.max
    }

    /// Is t strictly between the ends? (False for NaN.)
    pub fn contains(&self, t: f64) -> bool {
        t > self.min && t < self.max
    }
}
