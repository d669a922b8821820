//! A ray and triangles, watertight.

use crate::math::{DVec2, DVec3, Ray};

/// A ray as the test wants it: seen along its longest axis, sheared so that it runs along that.
pub struct Sheared {
    pub(super) origin: DVec3,
    /// The longest one last.
    pub(super) axes: [usize; 3],
    /// How far the ray leans along the others, and one over its length along the last.
    pub(super) shear: DVec3,
}

impl Sheared {
    pub fn new(ray: &Ray) -> Self {
        let z = ray.dir.abs().max_position();
        // (Which way round does not matter: the signs of all three areas change together.)
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let shear = DVec3::new(ray.dir[x] / ray.dir[z], ray.dir[y] / ray.dir[z], 1.0 / ray.dir[z]);
        Self { origin: ray.origin, axes: [x, y, z], shear }
    }

    /// t and the weights of the second and third corner, where the line meets the triangle.
    pub fn meet(&self, corners: [DVec3; 3]) -> Option<(f64, DVec2)> {
        let [x, y, z] = self.axes;
        let from = corners.map(|corner| corner - self.origin);
        let [a, b, c] = from.map(|p| DVec2::new(p[x] - self.shear.x * p[z], p[y] - self.shear.y * p[z]));
        // Twice the areas of the parts that each side cuts off with the ray.
        let (u, v, w) = (c.perp_dot(b), a.perp_dot(c), b.perp_dot(a));
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let det = u + v + w;
        if det == 0.0 {
            return None;
        }
        let t = self.shear.z * (u * from[0][z] + v * from[1][z] + w * from[2][z]) / det;
        Some((t, DVec2::new(v, w) / det))
    }
}
