//! Axis-aligned boxes, possibly infinite.

use super::{DVec3, Range, Ray};
use serde::Serialize;

/// Axis-aligned box; `min > max` means that it is empty, infinite coordinates are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Aabb {
    /// Corner of the box with the smallest coordinates.
    pub min: DVec3,
    /// Corner of the box with the largest coordinates.
    pub max: DVec3,
}

impl Aabb {
    /// The empty box, which contains no point.
    pub const EMPTY: Aabb = Aabb { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
    /// The box that contains every point.
    pub const INFINITE: Aabb = Aabb { min: DVec3::NEG_INFINITY, max: DVec3::INFINITY };

    /// The box between two corners given in any order.
    pub fn from_corners(a: DVec3, b: DVec3) -> Self {
        Self { min: a.min(b), max: a.max(b) }
    }

    /// The smallest box around some points.
    pub fn from_points(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::including)
    }

    /// Returns the smallest box that contains this one and a point.
    pub fn including(self, p: DVec3) -> Self {
        Self { min: self.min.min(p), max: self.max.max(p) }
    }

    /// Returns the smallest box that contains both boxes.
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The intersection of two boxes.
    pub fn intersection(self, other: Self) -> Self {
        Self { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// Returns the box enlarged by `d` on every side.
    pub fn grown(self, d: f64) -> Self {
        Self { min: self.min - d, max: self.max + d }
    }

    /// True if the box contains no point.
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// True if all coordinates of the box are finite.
    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// Returns the centre of the box.
    pub fn center(&self) -> DVec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// Lengths of the box's edges.
    pub fn size(&self) -> DVec3 {
        self.max - self.min
    }

    /// Half the surface area of the box, for the surface-area heuristic.
    pub fn half_area(&self) -> f64 {
        let s = self.size();
        if self.is_empty() { 0.0 } else { s.x * s.y + s.y * s.z + s.z * s.x }
    }

    /// True if the closed box contains the point.
    pub fn contains(&self, p: DVec3) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// Returns the eight corners of the box.
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|i| {
            let pick = |bit: usize, lo: f64, hi: f64| if i >> bit & 1 == 0 { lo } else { hi };
            DVec3::new(
                pick(0, self.min.x, self.max.x),
                pick(1, self.min.y, self.max.y),
                pick(2, self.min.z, self.max.z),
            )
        })
    }

    /// Returns the values of `t` between which the ray is in the box, limited to the range, by slabs (lecture, "Ray –
    /// AAB intersection"); `None` if the ray misses the box within the range. Where a component of the direction is
    /// zero, the origin must be between the two planes.
    pub fn slabs(&self, ray: &Ray, range: Range) -> Option<(f64, f64)> {
        let (mut near, mut far) = (range.min, range.max);
        for axis in 0..3 {
            let (o, inverse) = (ray.origin[axis], 1.0 / ray.dir[axis]);
            let (lo, hi) = ((self.min[axis] - o) * inverse, (self.max[axis] - o) * inverse);
            // The ray enters through the lower plane where v is positive. (Sorting t₁ and t₂ would give hits with an
            // empty box.)
            let (enter, leave) = if inverse < 0.0 { (hi, lo) } else { (lo, hi) };
            // For a parallel ray they are infinite, or NaN in one of the planes, which the comparisons ignore.
            near = if enter > near { enter } else { near };
            far = if leave < far { leave } else { far };
        }
        (near <= far).then_some((near, far))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slabs() {
        let cube = Aabb::from_corners(DVec3::ONE, DVec3::NEG_ONE);
        let ray = Ray::new(DVec3::new(-3.0, 0.5, 0.0), DVec3::X * 2.0);
        assert_eq!(cube.slabs(&ray, Range::ALL), Some((1.0, 2.0)));
        assert_eq!(cube.slabs(&ray, Range { min: 1.5, max: 9.0 }), Some((1.5, 2.0)));
        assert_eq!(cube.slabs(&ray, Range { min: 2.5, max: 9.0 }), None);
        assert_eq!(cube.slabs(&Ray::new(DVec3::Y * 1.5, DVec3::X), Range::ALL), None);
        assert_eq!(Aabb::INFINITE.slabs(&ray, Range::FORWARD), Some((0.0, f64::INFINITY)));
        assert_eq!(Aabb::EMPTY.slabs(&ray, Range::ALL), None);
        let empty_along_y = Aabb { min: DVec3::new(-1.0, 1.0, -1.0), max: DVec3::new(1.0, -1.0, 1.0) };
        assert_eq!(empty_along_y.slabs(&Ray::new(DVec3::splat(-3.0), DVec3::ONE), Range::ALL), None);
    }
}
