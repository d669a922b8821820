//! `triangle { corner_1, corner_2, corner_3 }`: a flat piece without thickness; it has no inside.
//!
//! ```pov
//! triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> pigment { color rgb <0.3, 0.7, 0.3> } }
//! ```

use super::{Hit, Hits, Kernel, Shape, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use crate::source::Span;
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// A flat triangle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Triangle {
    /// First corner of the triangle.
    pub a: DVec3,
    /// Second corner of the triangle.
    pub b: DVec3,
    /// Third corner of the triangle.
    pub c: DVec3,
}

impl Triangle {
    /// Creates the triangle with these corners.
    pub const fn new(a: DVec3, b: DVec3, c: DVec3) -> Self {
        Self { a, b, c }
    }

    /// Normal of the triangle, (c - a) × (b - a): its length is twice the area (lecture, "Ray and triangle intersection
    /// II"). Seen from its side the corners are clockwise in POV-Ray's left-handed system, as in POV-Ray's `trace()`.
    pub fn face_normal(&self) -> DVec3 {
        (self.c - self.a).cross(self.b - self.a)
    }

    /// True if the triangle's area is zero, to rounding.
    pub fn is_degenerate(&self) -> bool {
        let (ab, ac) = (self.b - self.a, self.c - self.a);
        self.face_normal().length() <= f64::EPSILON * ab.length() * ac.length()
    }

    /// Returns the hit of the ray's line, at any `t`, on the triangle a + u·(b - a) + v·(c - a), `None` for a miss
    /// (lecture, "Ray and triangle intersection I"): Cramer's rule on p₀ - a = -t·v + u·(b - a) + v·(c - a), in the
    /// order of Möller and Trumbore (1997).
    pub fn intersect_line(&self, ray: &Ray) -> Option<Hit> {
        let (ab, ac) = (self.b - self.a, self.c - self.a);
        let p = ray.dir.cross(ac);
        let det = ab.dot(p);
        let s = ray.origin - self.a;
        let u = s.dot(p) / det;
        if !(0.0..=1.0).contains(&u) {
            return None;
        }
        let q = s.cross(ab);
        let v = ray.dir.dot(q) / det;
        let t = ac.dot(q) / det;
        (v >= 0.0 && u + v <= 1.0).then_some(Hit { t, part: 0, uv: DVec2::new(u, v) })
    }

    /// Returns the barycentric coordinates (λ₁, λ₂, λ₃) of a point of the triangle's plane, in the coordinate plane
    /// with the largest projection (lecture, "Point on triangle"). The point is in the triangle if and only if none is
    /// negative.
    pub fn barycentric(&self, p: DVec3) -> DVec3 {
        // Drop the axis along which the normal is longest.
        let drop = self.face_normal().abs().max_position();
        let flat = |q: DVec3| DVec2::new(q[(drop + 1) % 3], q[(drop + 2) % 3]);
        let (a, b, at) = (flat(self.a - self.c), flat(self.b - self.c), flat(p - self.c));
        let det = a.perp_dot(b);
        let (l1, l2) = (at.perp_dot(b) / det, a.perp_dot(at) / det);
        DVec3::new(l1, l2, 1.0 - l1 - l2)
    }

    /// Returns the triangle with its last two corners swapped, if needed, so that its outside after the transform M is
    /// that of POV-Ray: towards -x, +y or -z, whichever axis is closest to the normal in object space (quirk:
    /// `flat_triangle_sides`).
    fn reordered_for_pov_outside(&self, m: &Transform) -> Self {
        let normal = self.face_normal();
        let axis = normal.abs().max_position();
        let is_outward = normal[axis] * [-1.0, 1.0, -1.0][axis] > 0.0;
        let [x, y, z] = DVec3::AXES.map(|axis| m.transform_vector(axis));
        let keeps_orientation = x.cross(y).dot(z) > 0.0;
        if is_outward == keeps_orientation { *self } else { Self { b: self.c, c: self.b, ..*self } }
    }

    /// Bounding box of the triangle; empty without area.
    pub fn bounds(&self) -> Aabb {
        if self.is_degenerate() { Aabb::EMPTY } else { Aabb::from_points([self.a, self.b, self.c]) }
    }
}

impl Readable for Triangle {
    const SPEC: Spec = Spec {
        name: "triangle",
        summary: "a flat piece with three corners",
        params: &[
            Param { name: "corner_1", kind: ValueKind::Vector, summary: "first corner" },
            Param { name: "corner_2", kind: ValueKind::Vector, summary: "second corner" },
            Param { name: "corner_3", kind: ValueKind::Vector, summary: "third corner" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (a, b, c) = (r.vector()?, r.vector()?, r.vector()?);
        check_finite(span, &[a, b, c], &[])?;
        Ok(Self::new(a, b, c))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.is_degenerate() {
            r.report(Diagnostic::new(codes::FLAT_TRIANGLE, span, "this `triangle` has no area and is left out"));
        }
        Ok(())
    }
}

impl Kernel for Triangle {
    fn bounds(&self) -> Aabb {
        self.bounds()
    }

    fn bounds_under(&self, m: &Transform) -> Aabb {
        let corners = [self.a, self.b, self.c].map(|p| m.transform_point(p));
        if self.is_degenerate() { Aabb::EMPTY } else { Aabb::from_points(corners) }
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        out.extend(Kernel::closest(self, ray, range));
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        self.intersect_line(ray).filter(|hit| range.contains(hit.t))
    }

    fn inside(&self, _: DVec3) -> bool {
        false
    }

    fn is_open(&self) -> bool {
        true
    }

    fn adapted_to_transform(&self, m: &Transform) -> Option<Shape> {
        let ordered = self.reordered_for_pov_outside(m);
        (!m.is_identity() && ordered != *self).then(|| ordered.into())
    }

    fn normal(&self, _: DVec3, _: &Hit) -> DVec3 {
        self.face_normal()
    }

    /// Surface coordinates of a triangle: the lecture's (u, v). POV-Ray defines no uv mapping for triangles outside
    /// meshes.
    fn uv(&self, _: DVec3, hit: &Hit) -> DVec2 {
        hit.uv
    }

    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::read_shape;
    use proptest::prelude::*;

    fn corner() -> Triangle {
        Triangle::new(DVec3::ZERO, DVec3::X, DVec3::Y)
    }

    #[test]
    fn spanning_version() {
        let ray = Ray::new(DVec3::new(0.25, 0.5, -3.0), DVec3::Z * 2.0);
        let hit = corner().intersect_line(&ray).unwrap();
        assert_eq!((hit.t, hit.uv), (1.5, DVec2::new(0.25, 0.5)));
        for (x, y) in [(-0.01, 0.5), (0.5, -0.01), (0.51, 0.5)] {
            assert_eq!(corner().intersect_line(&Ray::new(DVec3::new(x, y, -3.0), DVec3::Z)), None);
        }
        assert_eq!(corner().intersect_line(&Ray::new(DVec3::new(-1.0, 0.25, 0.0), DVec3::X)), None, "in its plane");
    }

    #[test]
    fn projected_version() {
        let t = Triangle::new(DVec3::new(1.0, 5.0, 2.0), DVec3::new(4.0, 5.5, 2.0), DVec3::new(1.0, 5.0, 8.0));
        let want = DVec3::new(0.5, 0.3, 0.2);
        let p = want.x * t.a + want.y * t.b + want.z * t.c;
        assert!(t.barycentric(p).distance(want) < 1e-14);
        assert!(t.barycentric(t.a + (t.a - t.b) * 0.1).y < 0.0);
    }

    /// With the normals of POV-Ray's `trace()`.
    #[test]
    fn outside_of_transformed_triangle() {
        let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
        let turn = Transform::rotate(DVec3::new(0.0, 180.0, 0.0));
        let mirror = Transform::scale(DVec3::splat(-1.0)).unwrap();
        for (a, b, plain, turned, mirrored) in
            [(x, y, -z, z, -z), (y, x, z, z, -z), (z, y, x, x, -x), (x, z, y, y, y), (z, x, -y, y, y)]
        {
            let triangle = Triangle::new(o, a, b);
            let normal_under = |m: &Transform| {
                let adapted = match triangle.adapted_to_transform(m) {
                    Some(Shape::Triangle(adapted)) => *adapted,
                    _ => triangle,
                };
                m.transform_normal(adapted.face_normal()).normalize()
            };
            assert_eq!(normal_under(&Transform::IDENTITY), plain);
            assert!(normal_under(&turn).distance(turned) < 1e-12);
            assert!(normal_under(&mirror).distance(mirrored) < 1e-12);
        }
    }

    #[test]
    fn degenerate() {
        assert_eq!(read_shape::<Triangle>("0 <1,0,0> <2,0,0>").1[0].code, codes::FLAT_TRIANGLE);
        assert_eq!(read_shape::<Triangle>("0 0 <2,0,0>").1[0].code, codes::FLAT_TRIANGLE);
        assert!(read_shape::<Triangle>("0 <1,0,0> <0,1e-7,0>").1.is_empty(), "thin is not degenerate");
        let line = Triangle::new(DVec3::ZERO, DVec3::X, DVec3::X * 2.0);
        assert!(line.bounds().is_empty());
        assert_eq!(line.intersect_line(&Ray::new(DVec3::new(0.5, 0.0, -1.0), DVec3::Z)), None);
        assert_eq!(corner().face_normal(), -DVec3::Z, "as POV-Ray's trace() has it");
    }

    proptest! {
        #[test]
        fn both_versions_agree(p in proptest::array::uniform9(-3.0..3.0f64), o in proptest::array::uniform3(-5.0..5.0f64),
                               w in proptest::array::uniform2(-0.5..1.5f64)) {
            let t = Triangle::new(DVec3::from_slice(&p[0..]), DVec3::from_slice(&p[3..]), DVec3::from_slice(&p[6..]));
            let at = t.a + w[0] * (t.b - t.a) + w[1] * (t.c - t.a);
            let ray = Ray::new(o.into(), at - DVec3::from(o));
            let n = t.face_normal();
            prop_assume!(n.length() > 0.1 && n.normalize().dot(ray.dir.normalize()).abs() > 0.01);
            let l = t.barycentric(at);
            prop_assert!(l.distance(DVec3::new(1.0 - w[0] - w[1], w[0], w[1])) < 1e-9);
            prop_assume!(l.abs().min_element() > 1e-6);
            let hit = t.intersect_line(&ray);
            prop_assert_eq!(hit.is_some(), l.min_element() >= 0.0);
            if let Some(hit) = hit {
                prop_assert!((hit.t - 1.0).abs() < 1e-9 && hit.uv.distance(DVec2::new(l.y, l.z)) < 1e-9);
            }
        }
    }
}
