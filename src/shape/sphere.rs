//! `sphere { center, radius }`: all points at distance `radius` from `center`.
//!
//! ```pov
//! sphere { <0, 1, 0>, 1 pigment { color rgb <1, 0.5, 0> } }
//! ```

use super::{Hit, Hits, Kernel, Readable};
use crate::diagnostic::Result;
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, fp, solve_quadratic};
use crate::value::{Kind, Param, Reader, Spec};
use serde::Serialize;
use std::f64::consts::PI;

/// A ball.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sphere {
    /// Its middle.
    pub center: DVec3,
    /// Positive.
    pub radius: f64,
}

impl Readable for Sphere {
    const SPEC: Spec = Spec {
        name: "sphere",
        summary: "all points at one distance from a center",
        params: &[
            Param { name: "center", kind: Kind::Vector, summary: "its middle" },
            Param { name: "radius", kind: Kind::Float, summary: "the distance; its sign does not matter" },
        ],
        words: &[],
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self { center: r.vector()?, radius: r.float()?.abs() })
    }
}

impl Kernel for Sphere {
    fn bounds(&self) -> Aabb {
        Aabb { min: self.center - self.radius, max: self.center + self.radius }
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        if let Some((t1, t2)) = self.roots(ray) {
            out.extend([t1, t2].into_iter().filter(|&t| range.contains(t)).map(Hit::at));
        }
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let (t1, t2) = self.roots(ray)?;
        [t1, t2].into_iter().find(|&t| range.contains(t)).map(Hit::at)
    }

    fn inside(&self, p: DVec3) -> bool {
        p.distance_squared(self.center) < self.radius * self.radius
    }

    fn normal(&self, p: DVec3, _: &Hit) -> DVec3 {
        p - self.center
    }

    fn uv(&self, p: DVec3, _: &Hit) -> DVec2 {
        let n = (p - self.center) / self.radius;
        let u = fp::atan2(n.z, n.x) / (2.0 * PI);
        DVec2::new(if u < 0.0 { u + 1.0 } else { u }, 0.5 + fp::asin(n.y) / PI)
    }
}

impl Sphere {
    /// Both roots of |p₀ + t·v - c|² = r² (lecture, "Ray – sphere intersection").
    fn roots(&self, ray: &Ray) -> Option<(f64, f64)> {
        let to_origin = ray.origin - self.center;
        let a = ray.dir.length_squared();
        let b = 2.0 * ray.dir.dot(to_origin);
        let c = to_origin.length_squared() - self.radius * self.radius;
        solve_quadratic(a, b, c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_form() {
        let ball = Sphere { center: DVec3::new(0.0, 0.0, 5.0), radius: 1.0 };
        let ray = Ray::new(DVec3::ZERO, DVec3::Z);
        assert_eq!(ball.closest(&ray, Range::FORWARD), Some(Hit::at(4.0)));
        let inside = Ray::new(DVec3::new(0.0, 0.0, 5.0), DVec3::Z * 2.0);
        assert_eq!(ball.closest(&inside, Range::FORWARD), Some(Hit::at(0.5)));
    }
}
