//! `sphere { center, radius }`: all points at distance `radius` from `center`.
//!
//! ```pov
//! sphere { <0, 1, 0>, 1 pigment { color rgb <1, 0.5, 0> } }
//! ```

use super::{Crossing, End, Hit, Hits, Kernel, PacketCrossings, PacketHits, check_finite, transformed_box};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::packet::{Numbers, PACKET, RayPacket, Vectors};
use crate::math::{
    Aabb, DVec2, DVec3, Lanes, Range, Ray, Transform, fp, quadratic_roots_of_lanes, solve_quadratic_with_discriminant,
};
use crate::source::Span;
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;
use std::f64::consts::PI;

/// Sphere: a solid ball.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sphere {
    /// Centre of the ball.
    pub center: DVec3,
    /// Radius of the ball, not negative; a ball of radius 0 has no surface.
    pub radius: f64,
}

impl Readable for Sphere {
    const SPEC: Spec = Spec {
        name: "sphere",
        summary: "all points at one distance from a center",
        params: &[
            Param { name: "center", kind: ValueKind::Vector, summary: "its middle" },
            Param { name: "radius", kind: ValueKind::Float, summary: "the distance; its sign does not matter" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (center, radius) = (r.vector()?, r.float()?.abs());
        check_finite(span, &[center], &[radius])?;
        Ok(Self { center, radius })
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.radius == 0.0 {
            r.report(Diagnostic::new(codes::NO_SURFACE, span, "a `sphere` of radius 0 has no surface"));
        }
        Ok(())
    }
}

impl Kernel for Sphere {
    const TRACES_PACKETS: bool = true;

    fn bounds(&self) -> Aabb {
        Aabb { min: self.center - self.radius, max: self.center + self.radius }
    }

    fn bounds_under(&self, m: &Transform) -> Aabb {
        // The image of a ball extends r·|row i of M| along axis i.
        let (x, y, z) = (m.transform_vector(DVec3::X), m.transform_vector(DVec3::Y), m.transform_vector(DVec3::Z));
        let reach = (x * x + y * y + z * z).map(f64::sqrt) * self.radius;
        let center = m.transform_point(self.center);
        Aabb { min: center - reach, max: center + reach }
    }

    /// Box that POV-Ray reports for the sphere: a sphere that stays a sphere keeps its width (quirk: `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        let axes = DVec3::AXES.map(|axis| m.transform_vector(axis));
        let same = |a: DVec3, b: DVec3| {
            (a.length() - b.length()).abs() < 1e-9 * a.length() && a.dot(b).abs() < 1e-9 * a.length_squared()
        };
        if same(axes[0], axes[1]) && same(axes[1], axes[2]) && same(axes[0], axes[2]) {
            let (center, r) = (m.transform_point(self.center), DVec3::splat(self.radius * axes[0].length()));
            return Aabb { min: center - r, max: center + r };
        }
        transformed_box(m, &self.bounds())
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        if let Some((t1, t2)) = self.ray_roots(ray) {
            out.extend([t1, t2].into_iter().filter(|&t| range.contains(t)).map(Hit::on_single_piece));
        }
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let (t1, t2) = self.ray_roots(ray)?;
        [t1, t2].into_iter().find(|&t| range.contains(t)).map(Hit::on_single_piece)
    }

    #[inline(always)]
    fn closest_of_packet(&self, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
        self.crossings_of_packet(rays).first_in_range(min, max)
    }

    fn crosses_packets(&self) -> bool {
        true
    }

    #[inline(always)]
    fn crossings_of_packet(&self, rays: &RayPacket) -> PacketCrossings {
        // The operations of `ray_roots`, in the same order
        let zero = Lanes::splat(0.0);
        let to_origin = rays.origin - Vectors::splat(self.center);
        let r2 = Lanes::splat(self.radius * self.radius);
        let a = rays.dir.length_squared();
        let half_b = rays.dir.dot(to_origin);
        let nearest = to_origin - rays.dir * (half_b / a);
        let discriminant = a * (r2 - nearest.length_squared());
        let crosses = zero.at_most(discriminant);
        if self.radius == 0.0 || !crosses.any() {
            return PacketCrossings::MISSES;
        }
        let c = to_origin.length_squared() - r2;
        let ends = quadratic_roots_of_lanes(a, half_b, c, discriminant);
        PacketCrossings::through(crosses, ends, [[0; PACKET]; 2])
    }

    fn inside(&self, p: DVec3) -> bool {
        p.distance_squared(self.center) < self.radius * self.radius
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn crossing(&self, ray: &Ray) -> Crossing {
        self.ray_roots(ray).map_or(Crossing::Misses, |(t1, t2)| {
            Crossing::Through([End::on_single_piece(t1), End::on_single_piece(t2)])
        })
    }

    fn normal(&self, p: DVec3, _: &Hit) -> DVec3 {
        p - self.center
    }

    #[inline(always)]
    fn normals_of_packet(&self, points: &Vectors, _: &[Hit; PACKET], _: u32) -> Vectors {
        *points - Vectors::splat(self.center)
    }

    fn uv(&self, p: DVec3, _: &Hit) -> DVec2 {
        let n = (p - self.center) / self.radius;
        DVec2::new(fp::positive_angle_in_turns(n.z, n.x), 0.5 + fp::asin(n.y) / PI)
    }
}

impl Sphere {
    /// Returns both roots of |p₀ + t·v - c|² = r², where a ray crosses the sphere (lecture, "Ray – sphere
    /// intersection").
    fn ray_roots(&self, ray: &Ray) -> Option<(f64, f64)> {
        if self.radius == 0.0 {
            return None;
        }
        let to_origin = ray.origin - self.center;
        let r2 = self.radius * self.radius;
        let a = ray.dir.length_squared();
        let half_b = ray.dir.dot(to_origin);
        let c = to_origin.length_squared() - r2;
        // D/4 = a·(r² - d²), where d is the distance of the line from the centre: for a distant eye, b²/4 - a·c loses
        // all digits (Haines et al., Precision Improvements for Ray/Sphere Intersection, 2019)
        let nearest = to_origin - ray.dir * (half_b / a);
        solve_quadratic_with_discriminant(a, half_b, c, a * (r2 - nearest.length_squared()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packets_match_single_rays() {
        crate::shape::testing::assert_packets_match_single_rays(&Sphere {
            center: DVec3::new(0.1, -0.2, 0.3),
            radius: 0.9,
        });
    }

    #[test]
    fn closed_form() {
        let ball = Sphere { center: DVec3::new(0.0, 0.0, 5.0), radius: 1.0 };
        let ray = Ray::new(DVec3::ZERO, DVec3::Z);
        assert_eq!(ball.closest(&ray, Range::FORWARD), Some(Hit::on_single_piece(4.0)));
        let inside = Ray::new(DVec3::new(0.0, 0.0, 5.0), DVec3::Z * 2.0);
        assert_eq!(ball.closest(&inside, Range::FORWARD), Some(Hit::on_single_piece(0.5)));
    }

    #[test]
    fn small_and_far() {
        // Radius 1 at a distance of 10⁸, half a radius off centre.
        let ball = Sphere { center: DVec3::new(0.0, 0.5, 1e8), radius: 1.0 };
        let ray = Ray::new(DVec3::ZERO, DVec3::Z);
        let h = 0.75_f64.sqrt();
        let found = crate::shape::testing::all_hits(&ball, &ray);
        assert!((found[0].t - 1e8 + h).abs() < 3e-8 && (found[1].t - 1e8 - h).abs() < 3e-8, "{found:?}");
        // Just outside the rim, and just inside.
        let past = |d: f64| ball.closest(&Ray::new(DVec3::Y * (1.5 + d), DVec3::Z), Range::FORWARD);
        assert!(past(1e-12).is_none() && past(-1e-12).is_some());
    }

    #[test]
    fn three_cases_of_the_discriminant() {
        let ball = Sphere { center: DVec3::ZERO, radius: 2.0 };
        let count =
            |x: f64| crate::shape::testing::all_hits(&ball, &Ray::new(DVec3::new(x, 0.0, -9.0), DVec3::Z)).len();
        assert_eq!((count(0.0), count(2.5)), (2, 0));
        let touch = crate::shape::testing::all_hits(&ball, &Ray::new(DVec3::new(2.0, 0.0, -9.0), DVec3::Z));
        assert!(touch.iter().all(|h| h.t == 9.0) && !touch.is_empty());
        assert_eq!(ball.closest(&Ray::new(DVec3::Z * 3.0, DVec3::Z), Range::FORWARD), None, "behind the eye");
    }

    #[test]
    fn reading() {
        use crate::shape::testing::read_shape;
        assert_eq!(read_shape::<Sphere>("0 -2").0.unwrap(), Sphere { center: DVec3::ZERO, radius: 2.0 });
        assert_eq!(read_shape::<Sphere>("0 0").1[0].code, codes::NO_SURFACE);
        assert_eq!(read_shape::<Sphere>("0 inf").0.unwrap_err().code, codes::NOT_FINITE);
    }
}
