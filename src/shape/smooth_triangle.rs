//! `smooth_triangle { corner_1, normal_1, corner_2, normal_2, corner_3, normal_3 }`: a triangle that looks curved.
//!
//! The normals, of any length, are made unit vectors and interpolated. All three must point to one side of the triangle;
//! otherwise it is left out, as POV-Ray does.
//!
//! ```pov
//! smooth_triangle { <0, 0, 0>, <-1, 0, -2>, <1, 0, 0>, <1, 0, -2>, <0, 1, 0>, <0, 1, -2> pigment { color rgb 1 } }
//! ```

use super::{Hit, Hits, Kernel, Shape, Triangle, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use crate::source::Span;
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Smooth triangle, with a normal at each corner.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SmoothTriangle {
    /// The flat triangle that rays hit; the normals only shade it.
    pub flat: Triangle,
    /// Normals of the smooth triangle, of length 1, in the order of the corners; zero where the scene gives no
    /// direction, and then nothing is rendered.
    pub normals: [DVec3; 3],
}

impl SmoothTriangle {
    /// Creates a smooth triangle with normals of any length.
    pub fn new(flat: Triangle, normals: [DVec3; 3]) -> Self {
        Self { flat, normals: normals.map(DVec3::normalize_or_zero) }
    }

    /// True if the smooth triangle's normals point to both sides of it, or into its plane.
    fn is_twisted(&self) -> bool {
        self.is_twisted_under(&Transform::IDENTITY)
    }

    /// True if the smooth triangle's normals point to both sides under the transform M, which can change their angles
    /// (quirk: `twisted_smooth_triangle`).
    fn is_twisted_under(&self, m: &Transform) -> bool {
        let face = m.transform_normal(self.flat.face_normal());
        let sides = self.normals.map(|n| m.transform_normal(n).dot(face));
        !(sides.iter().all(|s| *s > 0.0) || sides.iter().all(|s| *s < 0.0))
    }
}

impl Readable for SmoothTriangle {
    const SPEC: Spec = Spec {
        name: "smooth_triangle",
        summary: "a triangle that looks curved",
        params: &[
            Param { name: "corner_1", kind: ValueKind::Vector, summary: "first corner" },
            Param { name: "normal_1", kind: ValueKind::Vector, summary: "the surface's direction there" },
            Param { name: "corner_2", kind: ValueKind::Vector, summary: "second corner" },
            Param { name: "normal_2", kind: ValueKind::Vector, summary: "the surface's direction there" },
            Param { name: "corner_3", kind: ValueKind::Vector, summary: "third corner" },
            Param { name: "normal_3", kind: ValueKind::Vector, summary: "the surface's direction there" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (a, na, b, nb) = (r.vector()?, r.vector()?, r.vector()?, r.vector()?);
        let (c, nc) = (r.vector()?, r.vector()?);
        check_finite(span, &[a, na, b, nb, c, nc], &[])?;
        Ok(Self::new(Triangle::new(a, b, c), [na, nb, nc]))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.flat.is_degenerate() {
            let message = "this `smooth_triangle` has no area and is left out";
            r.report(Diagnostic::new(codes::FLAT_TRIANGLE, span, message));
        } else if self.is_twisted() {
            let message = "the normals of this `smooth_triangle` do not all point to one side of it, so it is left out";
            let help = "turn round the normals that point to the other side";
            r.report(Diagnostic::new(codes::TWISTED_TRIANGLE, span, message).help(help));
        }
        Ok(())
    }
}

impl Kernel for SmoothTriangle {
    fn bounds(&self) -> Aabb {
        if self.is_twisted() { Aabb::EMPTY } else { self.flat.bounds() }
    }

    fn bounds_under(&self, m: &Transform) -> Aabb {
        if self.is_twisted() { Aabb::EMPTY } else { self.flat.bounds_under(m) }
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        out.extend(Kernel::closest(self, ray, range));
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let hit = self.flat.intersect_line(ray).filter(|hit| range.contains(hit.t))?;
        (!self.is_twisted()).then_some(hit)
    }

    fn inside(&self, _: DVec3) -> bool {
        false
    }

    fn is_open(&self) -> bool {
        true
    }

    /// Returns the smooth triangle with normals of length 1 under M, so that interpolation weighs them equally (quirk:
    /// `smooth_triangle_normals`).
    fn adapted_to_transform(&self, m: &Transform) -> Option<Shape> {
        let normals = match self.is_twisted_under(m) {
            true => [DVec3::ZERO; 3],
            false => self.normals.map(|n| n / m.transform_normal(n).length().max(f64::MIN_POSITIVE)),
        };
        Some(Self { normals, ..self.clone() }.into())
    }

    fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
        // (1 - u - v)·n₁ + u·n₂ + v·n₃: never zero, because all are on one side
        let [n1, n2, n3] = self.normals;
        (1.0 - hit.uv.x - hit.uv.y) * n1 + hit.uv.x * n2 + hit.uv.y * n3
    }

    /// Surface coordinates of a smooth triangle: the lecture's (u, v). POV-Ray defines no uv mapping for triangles
    /// outside meshes.
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

    #[test]
    fn normals_are_interpolated() {
        // POV-Ray's trace(): the given normals are normalised first.
        let (shape, reports) = read_shape::<SmoothTriangle>("0 <0,0,-3> <1,0,0> <-1,0,-1> <0,1,0> <0,0,-1>");
        let (shape, ray) = (shape.unwrap(), Ray::new(DVec3::new(0.5, 0.25, -5.0), DVec3::Z));
        assert!(reports.is_empty());
        let hit = shape.closest(&ray, Range::FORWARD).unwrap();
        let n = shape.normal(ray.at(hit.t), &hit).normalize();
        assert!(n.distance(DVec3::new(-0.38268, 0.0, -0.92388)) < 1e-5, "{n}");
    }

    #[test]
    fn twisted() {
        let with = |n: &str| read_shape::<SmoothTriangle>(&format!("0 <0,0,1> <1,0,0> <0,0,1> <0,1,0> {n}"));
        for bad in ["<0,0,-1>", "<1,0,0>", "0", "<1,0,-0.01>"] {
            let (shape, reports) = with(bad);
            assert_eq!(reports[0].code, codes::TWISTED_TRIANGLE, "{bad}");
            assert!(shape.unwrap().bounds().is_empty());
        }
        assert!(with("<-3,0,0.01>").1.is_empty());
    }
}
