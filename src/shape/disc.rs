//! `disc { center, normal, radius [, hole_radius] }`: a flat round plate without thickness, which may have a round hole.
//!
//! In CSG its inside is all that lies behind its plane, also beyond the radius.
//!
//! ```pov
//! disc { <0, 1, 0>, <0, 1, 0>, 1, 0.5 pigment { color rgb <0.8, 0.8, 0.2> } }
//! ```

use super::{HalfSpaces, Hit, Hits, Kernel, PacketHits, check_finite, pov_bounds};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::packet::{Flags, Numbers, PACKET, RayPacket, Vectors};
use crate::math::{Aabb, DVec2, DVec3, Lanes, Range, Ray, Transform, fp};
use crate::source::Span;
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// A flat disc, with a concentric round hole if `hole` is above 0.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Disc {
    /// Centre of the disc and of its hole.
    pub center: DVec3,
    /// Normal of the disc, of length 1; zero if the scene gives no direction, and then nothing is rendered.
    pub normal: DVec3,
    /// Outer radius of the disc, not negative.
    pub radius: f64,
    /// Radius of the disc's hole, not negative.
    pub hole: f64,
}

impl Disc {
    /// Creates a disc with a normal of any length.
    pub fn new(center: DVec3, normal: DVec3, radius: f64, hole: f64) -> Self {
        Self { center, normal: normal.normalize_or_zero(), radius: radius.abs(), hole: hole.abs() }
    }

    fn is_empty(&self) -> bool {
        self.normal == DVec3::ZERO || self.hole >= self.radius
    }
}

impl Readable for Disc {
    const SPEC: Spec = Spec {
        name: "disc",
        summary: "a flat round plate without thickness",
        params: &[
            Param { name: "center", kind: ValueKind::Vector, summary: "its middle" },
            Param { name: "normal", kind: ValueKind::Vector, summary: "stands on it, of any length" },
            Param { name: "radius", kind: ValueKind::Float, summary: "its sign does not matter" },
            Param {
                name: "hole_radius",
                kind: ValueKind::Float,
                summary: "of the hole in its middle; may be left out",
            },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (center, normal, radius) = (r.vector()?, r.vector()?, r.float()?);
        let hole = if r.peek_next()? == Next::Value { r.float()? } else { 0.0 };
        check_finite(span, &[center, normal], &[radius, hole])?;
        Ok(Self::new(center, normal, radius, hole))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        let why = match () {
            () if self.normal == DVec3::ZERO => "whose normal is zero",
            () if self.is_empty() => "whose hole is as large as itself",
            () => return Ok(()),
        };
        r.report(Diagnostic::new(codes::NO_SURFACE, span, format!("a `disc` {why} has no surface")));
        Ok(())
    }
}

impl Kernel for Disc {
    const TRACES_PACKETS: bool = true;

    fn bounds(&self) -> Aabb {
        if self.is_empty() {
            return Aabb::EMPTY;
        }
        // A circle with normal n extends r·√(1 - nᵢ²) along axis i.
        let reach = (DVec3::ONE - self.normal * self.normal).max(DVec3::ZERO).map(f64::sqrt) * self.radius;
        Aabb { min: self.center - reach, max: self.center + reach }
    }

    fn pov_bounds(&self, m: &Transform) -> Aabb {
        let corner = DVec3::new(self.radius, self.radius, pov_bounds::THIN);
        pov_bounds::transformed_frame_bounds(m, self.normal, self.center, &Aabb { min: -corner, max: corner })
    }

    fn is_solid_unbounded(&self) -> bool {
        true
    }

    fn half_spaces(&self) -> HalfSpaces {
        smallvec::smallvec![(self.normal, self.normal.dot(self.center))]
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        out.extend(self.closest(ray, range));
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        // t = n·(c - p₀) / n·v
        let t = self.normal.dot(self.center - ray.origin) / self.normal.dot(ray.dir);
        let across = (ray.at(t) - self.center).length_squared();
        let on_it = across <= self.radius * self.radius && across >= self.hole * self.hole && !self.is_empty();
        (on_it && range.contains(t)).then(|| Hit::on_single_piece(t))
    }

    #[inline(always)]
    fn closest_of_packet(&self, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
        // The operations of `closest`, in the same order
        let (normal, center) = (Vectors::splat(self.normal), Vectors::splat(self.center));
        let t = normal.dot(center - rays.origin) / normal.dot(rays.dir);
        let across = (rays.at(t) - center).length_squared();
        let is_on_it = across.at_most(Lanes::splat(self.radius * self.radius))
            & Lanes::splat(self.hole * self.hole).at_most(across)
            & Lanes::splat(min).less_than(t)
            & t.less_than(*max);
        let is_hit = if self.is_empty() { Flags::NONE } else { is_on_it };
        PacketHits { is_hit, t, part: [0; PACKET] }
    }

    fn inside(&self, p: DVec3) -> bool {
        self.normal.dot(p - self.center) < 0.0
    }

    fn normal(&self, _: DVec3, _: &Hit) -> DVec3 {
        self.normal
    }

    /// Returns the polar coordinates of a point of the disc: angle and radius. POV-Ray defines no uv mapping for a
    /// disc.
    fn uv(&self, p: DVec3, _: &Hit) -> DVec2 {
        let (e1, e2) = self.normal.any_orthonormal_pair();
        let d = p - self.center;
        let u = fp::positive_angle_in_turns(d.dot(e2), d.dot(e1));
        DVec2::new(u, d.length() / self.radius)
    }

    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, assert_hits, read_shape};

    #[test]
    fn packets_match_single_rays() {
        for normal in [DVec3::Z, DVec3::new(0.3, 1.0, -0.5)] {
            crate::shape::testing::assert_packets_match_single_rays(&Disc::new(
                DVec3::new(0.0, 0.1, -0.2),
                normal,
                1.2,
                0.3,
            ));
        }
    }

    #[test]
    fn ring() {
        let ring = Disc::new(DVec3::Z, DVec3::Z * 3.0, 2.0, -1.0);
        let at = |x: f64| all_hits(&ring, &Ray::new(DVec3::new(x, 0.0, -1.0), DVec3::Z * 4.0));
        assert_hits(&at(1.5), &[(0.5, 0)]);
        assert_hits(&at(0.5), &[]);
        assert_hits(&at(2.5), &[]);
        assert_hits(&all_hits(&ring, &Ray::new(DVec3::new(-5.0, 0.0, 1.0), DVec3::X)), &[]);
        assert!(ring.inside(DVec3::X * 99.0) && !ring.inside(DVec3::Z * 2.0));
        let tilted = Disc::new(DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0), 1.0, 0.0).bounds();
        assert!(tilted.max.distance(DVec3::new(0.5_f64.sqrt(), 0.5_f64.sqrt(), 1.0)) < 1e-15);
    }

    #[test]
    fn reading() {
        assert_eq!(read_shape::<Disc>("0 <0,2,0> -1").0.unwrap(), Disc::new(DVec3::ZERO, DVec3::Y, 1.0, 0.0));
        assert_eq!(read_shape::<Disc>("0 <0,2,0> 1 0.5").0.unwrap().hole, 0.5);
        let (nothing, reports) = read_shape::<Disc>("0 0 1");
        assert_eq!(reports[0].code, codes::NO_SURFACE);
        assert_hits(&all_hits(&nothing.unwrap(), &Ray::new(DVec3::Z, -DVec3::Z)), &[]);
        assert_eq!(read_shape::<Disc>("0 <0,1,0> 1 2").1[0].code, codes::NO_SURFACE);
    }
}
