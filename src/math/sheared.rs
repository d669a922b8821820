//! A ray and triangles: the test of Woop, Benthin and Wald (Watertight ray/triangle intersection, Journal of Computer
//! Graphics Techniques, 2013). A ray never passes between two triangles with a common side.

use super::{DVec2, DVec3, Ray};

/// A ray prepared for tests against triangles: sheared along the longest axis of its direction, so that it is parallel
/// to that axis.
pub struct Sheared {
    /// Indices of the coordinate axes; the longest axis of the ray's direction is last.
    pub(super) axes: [usize; 3],
    /// Origin of the sheared ray, with its coordinates in the order of `axes`.
    pub(super) from: DVec3,
    /// Shear along the first two axes, and the inverse of the last component of the ray's direction.
    pub(super) shear: DVec3,
}

impl Sheared {
    /// Prepares a ray, whose direction is not zero, for tests against triangles.
    #[inline(always)]
    pub fn new(ray: &Ray) -> Self {
        let z = ray.dir.abs().max_position();
        // (The orientation does not matter: the signs of all three areas change together.)
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let from = DVec3::new(ray.origin[x], ray.origin[y], ray.origin[z]);
        let shear = DVec3::new(ray.dir[x] / ray.dir[z], ray.dir[y] / ray.dir[z], 1.0 / ray.dir[z]);
        Self { axes: [x, y, z], from, shear }
    }

    /// Returns the sheared position of a triangle's corner with these coordinates in the order of `axes`.
    #[inline(always)]
    pub(super) fn shear_reordered_corner(&self, corner: [f64; 3]) -> DVec3 {
        let [x, y, z] = corner;
        let z = z - self.from.z;
        DVec3::new((x - self.from.x) - self.shear.x * z, (y - self.from.y) - self.shear.y * z, z)
    }

    /// Returns twice the signed areas between the ray and each side of a triangle.
    #[inline(always)]
    pub(super) fn doubled_signed_areas(a: DVec3, b: DVec3, c: DVec3) -> [f64; 3] {
        let side = |p: DVec3, q: DVec3| p.x * q.y - p.y * q.x;
        [side(c, b), side(a, c), side(b, a)]
    }

    /// True if the ray is on the same side of all three sides of a triangle, whose signed areas these are.
    #[inline(always)]
    pub(super) fn have_equal_signs([u, v, w]: [f64; 3]) -> bool {
        (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0)
    }

    /// Returns t and the barycentric weights of the second and third corner, where the ray's line hits the triangle.
    pub fn intersect(&self, corners: [DVec3; 3]) -> Option<(f64, DVec2)> {
        let [a, b, c] = corners.map(|p| self.shear_reordered_corner(self.axes.map(|axis| p[axis])));
        let [u, v, w] = Self::doubled_signed_areas(a, b, c);
        let det = u + v + w;
        if !Self::have_equal_signs([u, v, w]) || det == 0.0 {
            return None;
        }
        let t = self.shear.z * (u * a.z + v * b.z + w * c.z) / det;
        Some((t, DVec2::new(v, w) / det))
    }
}
