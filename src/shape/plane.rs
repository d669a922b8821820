//! `plane { normal, distance }`: everything on one side of an infinite flat surface.
//!
//! `normal` points outwards; `distance` counts along it from the origin, whatever the normal's length.
//! durer also takes the forms of the lecture: `implicit <A, B, C, D>` for A·x + B·y + C·z + D = 0, `point q normal n`, and
//! `point q span i, j` for q + u·i + v·j, whose outside is where i × j points and whose surface coordinates are (u, v).
//!
//! ```pov
//! plane { <0, 1, 0>, 0.1 pigment { checker color rgb 1 color rgb 0 } }
//! ```

use super::{
    Bounding, Crossing, End, HUGE, HalfSpace, Hit, Hits, Kernel, PacketCrossings, PacketHits, Quirks, check_finite,
};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::packet::{Numbers, PACKET, RayPacket, Vectors};
use crate::math::{Aabb, DVec2, DVec3, Lanes, Range, Ray, Transform, tolerance};
use crate::source::Span;
use crate::value::words::{Row, specs, word};
use crate::value::{Next, Param, Readable, Reader, ReaderExt, Spec, ValueKind};
use serde::Serialize;

/// Plane: a half-space that the plane bounds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Plane {
    /// Outward normal of the plane, length 1.
    pub normal: DVec3,
    /// Distance of the plane from the origin along the normal.
    pub distance: f64,
    /// Spanning vectors of the plane, if it is given by them.
    pub span: Option<Box<Spanned>>,
}

/// A plane as the points q + u·i + v·j for all numbers u and v.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spanned {
    /// Point q of the plane, where u = v = 0.
    pub point: DVec3,
    /// Vector i, which u multiplies.
    pub i: DVec3,
    /// Vector j, which v multiplies.
    pub j: DVec3,
}

impl Plane {
    /// Creates a plane in POV-Ray's form; `None` if the normal has no direction.
    pub fn new(normal: DVec3, distance: f64) -> Option<Self> {
        Some(Self { normal: normal.try_normalize()?, distance, span: None })
    }

    /// Creates the plane A·x + B·y + C·z + D = 0, which is negative inside; `None` if the normal has no direction.
    pub fn from_implicit(abcd: [f64; 4]) -> Option<Self> {
        let n = DVec3::new(abcd[0], abcd[1], abcd[2]);
        Self::new(n, -abcd[3] / n.length())
    }

    /// Creates the plane n·(x - q) = 0; `None` if the normal n has no direction.
    pub fn through_point(point: DVec3, normal: DVec3) -> Option<Self> {
        let plane = Self::new(normal, 0.0)?;
        Some(Self { distance: plane.normal.dot(point), ..plane })
    }

    /// Creates the plane q + u·i + v·j; `None` if i and j are parallel.
    pub fn spanned(point: DVec3, i: DVec3, j: DVec3) -> Option<Self> {
        let plane = Self::through_point(point, i.normalize_or_zero().cross(j.normalize_or_zero()))?;
        Some(Self { span: Some(Box::new(Spanned { point, i, j })), ..plane })
    }
}

impl Spanned {
    /// Returns (u, v) of a point of the plane: its distances from two lines, as multiples of the other vector's.
    fn span_coordinates(&self, p: DVec3) -> DVec2 {
        let (d, n) = (p - self.point, self.i.cross(self.j));
        DVec2::new(d.cross(self.j).dot(n), self.i.cross(d).dot(n)) / n.length_squared()
    }
}

impl Readable for Plane {
    const SPEC: Spec = Spec {
        name: "plane",
        summary: "everything on one side of an infinite flat surface",
        params: &[
            Param { name: "normal", kind: ValueKind::Vector, summary: "points outwards, of any length" },
            Param { name: "distance", kind: ValueKind::Float, summary: "from the origin along the normal" },
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word(
            "implicit",
            ValueKind::Block,
            "",
            "in place of normal and distance: four numbers A, B, C, D of A·x + B·y + C·z + D = 0 (durer)",
        )
        .sets(|_, r| form_word_not_first_error("implicit", r)),
        word(
            "point",
            ValueKind::Block,
            "",
            "in place of normal and distance: a point, then `normal n` or `span i, j` (durer)",
        )
        .sets(|_, r| form_word_not_first_error("point", r)),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let start = r.span();
        let plane = if r.accept("implicit")? {
            let n = r.numbers_in_angle_brackets(4)?;
            check_finite(start, &[], &n)?;
            Self::from_implicit([n[0], n[1], n[2], n[3]])
        } else if r.accept("point")? {
            read_point_form_or_degenerate(start, r)?
        } else {
            let (normal, distance) = (r.vector()?, r.float()?);
            check_finite(start, &[normal], &[distance])?;
            Self::new(normal, distance)
        };
        plane.ok_or_else(|| {
            let message = "this `plane` has no direction: its normal is zero";
            let help = "the normal is perpendicular to the surface, for example `y` for a floor";
            Diagnostic::new(codes::NO_DIRECTION, start, message).help(help).into()
        })
    }
}

/// Returns the error for a word of another form of a plane that is not first.
fn form_word_not_first_error(word: &str, r: &mut dyn Reader) -> Result<()> {
    let help = "write either `normal, distance` or one of the forms with words";
    let message = format!("`{word}` must be the first thing in a `plane`");
    Err(Diagnostic::new(codes::TWO_FORMS, r.span(), message).help(help).into())
}

/// Reads the rest of a plane in the form `point q normal n` or `point q span i, j`, after the word `point`. `None` for
/// a normal without a direction.
fn read_point_form_or_degenerate(start: Span, r: &mut dyn Reader) -> Result<Option<Plane>> {
    let point = r.vector()?;
    if r.accept("normal")? {
        let normal = r.vector()?;
        check_finite(start, &[point, normal], &[])?;
        return Ok(Plane::through_point(point, normal));
    }
    if r.peek_next()? != Next::Word("span") {
        return Err(r.unexpected("`normal` or `span` after the `point` of a `plane`").into());
    }
    r.take_token()?;
    let (i, j) = (r.vector()?, r.vector()?);
    check_finite(start, &[point, i, j], &[])?;
    let plane = Plane::spanned(point, i, j);
    if plane.is_none() {
        let message = "the two vectors that span this `plane` are parallel";
        return Diagnostic::err(codes::NO_DIRECTION, start, message);
    }
    Ok(plane)
}

impl Kernel for Plane {
    const QUIRKS: Quirks = Quirks { bounding: Bounding::Ignored, ..Quirks::NONE };
    const TRACES_PACKETS: bool = true;

    fn bounds(&self) -> Aabb {
        // A plane perpendicular to an axis is a half-space with one finite side.
        let mut bounds = Aabb::INFINITE;
        for axis in 0..3 {
            if self.normal[axis] == 1.0 {
                bounds.max[axis] = self.distance;
            } else if self.normal[axis] == -1.0 {
                bounds.min[axis] = -self.distance;
            }
        }
        bounds
    }

    fn pov_bounds(&self, _: &Transform) -> Aabb {
        HUGE
    }

    fn as_half_space(&self) -> Option<HalfSpace> {
        Some((self.normal, self.distance))
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        out.extend(self.closest(ray, range));
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        // t = (d - n·p₀) / n·v; a parallel ray divides by zero, and infinity and NaN are in no range
        let t = (self.distance - self.normal.dot(ray.origin)) / self.normal.dot(ray.dir);
        (range.contains(t) && t <= tolerance::PLANE_ENDS).then(|| Hit::on_single_piece(t))
    }

    #[inline(always)]
    fn closest_of_packet(&self, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
        let normal = Vectors::splat(self.normal);
        let t = (Lanes::splat(self.distance) - normal.dot(rays.origin)) / normal.dot(rays.dir);
        let is_hit =
            Lanes::splat(min).less_than(t) & t.less_than(*max) & t.at_most(Lanes::splat(tolerance::PLANE_ENDS));
        PacketHits { is_hit, t, part: [0; PACKET] }
    }

    fn inside(&self, p: DVec3) -> bool {
        self.normal.dot(p) - self.distance < tolerance::INSIDE
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn crossing(&self, ray: &Ray) -> Crossing {
        let slope = self.normal.dot(ray.dir);
        // Along a nearly parallel line `t` is inaccurate.
        if slope * slope < 1e-6 * ray.dir.length_squared() {
            return Crossing::Unknown;
        }
        let t = (self.distance - self.normal.dot(ray.origin)) / slope;
        if t > tolerance::PLANE_ENDS {
            return Crossing::Unknown;
        }
        let (enter, leave) = if slope > 0.0 { (f64::NEG_INFINITY, t) } else { (t, f64::INFINITY) };
        Crossing::Through([End::on_single_piece(enter), End::on_single_piece(leave)])
    }

    fn crosses_packets(&self) -> bool {
        true
    }

    #[inline(always)]
    fn crossings_of_packet(&self, rays: &RayPacket) -> PacketCrossings {
        // The operations of `crossing`, in the same order
        let normal = Vectors::splat(self.normal);
        let slope = normal.dot(rays.dir);
        let is_parallel = (slope * slope).less_than(1e-6 * rays.dir.length_squared());
        let t = (Lanes::splat(self.distance) - normal.dot(rays.origin)) / slope;
        let is_far = Lanes::splat(tolerance::PLANE_ENDS).less_than(t);
        let leaves = Lanes::splat(0.0).less_than(slope);
        let infinity = Lanes::splat(f64::INFINITY);
        let t = [leaves.select(-infinity, t), leaves.select(t, infinity)];
        PacketCrossings { is_known: !is_parallel & !is_far, t, ..PacketCrossings::MISSES }
    }

    fn normal(&self, _: DVec3, _: &Hit) -> DVec3 {
        self.normal
    }

    #[inline(always)]
    fn normals_of_packet(&self, _: &Vectors, _: &[Hit; PACKET], _: u32) -> Vectors {
        Vectors::splat(self.normal)
    }

    /// Surface coordinates of a plane: the lecture's (u, v), or coordinates along two directions of the plane. POV-Ray
    /// defines no uv mapping for planes.
    fn uv(&self, p: DVec3, _: &Hit) -> DVec2 {
        match &self.span {
            Some(spanned) => spanned.span_coordinates(p),
            None => {
                let (e1, e2) = self.normal.any_orthonormal_pair();
                DVec2::new(p.dot(e1), p.dot(e2))
            }
        }
    }

    fn has_uv_mapping(&self) -> bool {
        self.span.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::read_shape;
    use proptest::prelude::*;

    fn t(plane: &Plane, ray: &Ray) -> Option<f64> {
        plane.closest(ray, Range::FORWARD).map(|h| h.t)
    }

    #[test]
    fn packets_match_single_rays() {
        for normal in [DVec3::Y, DVec3::new(1.0, 2.0, -0.5)] {
            crate::shape::testing::assert_packets_match_single_rays(&Plane::new(normal, 0.1).unwrap());
        }
    }

    #[test]
    fn implicit_plane() {
        // 2x + 3y - z + 4 = 0 from (1, 1, 1) along (0, -1, 0): 2 + 3(1 - t) - 1 + 4 = 0
        let plane = Plane::from_implicit([2.0, 3.0, -1.0, 4.0]).unwrap();
        let ray = Ray::new(DVec3::ONE, -DVec3::Y);
        assert!((t(&plane, &ray).unwrap() - 8.0 / 3.0).abs() < 1e-14);
        assert!(!plane.inside(DVec3::ONE) && plane.inside(-DVec3::ONE * 9.0));
        assert_eq!(t(&plane, &Ray::new(DVec3::ONE, DVec3::Y)), None, "behind the eye");
        assert_eq!(t(&plane, &Ray::new(DVec3::ONE, DVec3::new(3.0, -2.0, 0.0))), None, "parallel");
    }

    #[test]
    fn point_and_normal() {
        // <n, q - p₀> / <n, v>
        let (q, n) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.0, 3.0, 4.0));
        let plane = Plane::through_point(q, n).unwrap();
        let ray = Ray::new(DVec3::new(-2.0, 0.5, 0.0), DVec3::new(0.6, 0.0, 0.8));
        assert!((t(&plane, &ray).unwrap() - n.dot(q - ray.origin) / n.dot(ray.dir)).abs() < 1e-14);
        let along = Ray::new(q, DVec3::X);
        assert_eq!(t(&plane, &along), None, "the ray runs along the plane");
    }

    #[test]
    fn two_spanning_vectors() {
        let (q, i, j) = (DVec3::new(1.0, 0.0, -1.0), DVec3::new(2.0, 0.0, 1.0), DVec3::new(1.0, 1.0, 0.0));
        let plane = Plane::spanned(q, i, j).unwrap();
        let target = q + 0.25 * i - 3.0 * j;
        let ray = Ray::new(DVec3::new(5.0, 7.0, -11.0), (target - DVec3::new(5.0, 7.0, -11.0)) / 4.0);
        let hit = plane.closest(&ray, Range::FORWARD).unwrap();
        assert!((hit.t - 4.0).abs() < 1e-12);
        assert!(plane.uv(ray.at(hit.t), &hit).distance(DVec2::new(0.25, -3.0)) < 1e-12);
        assert!(Plane::spanned(q, i, i * -3.0).is_none());
        assert!(!plane.inside(q + i.cross(j)));
    }

    #[test]
    fn reading_every_form() {
        let floor = Plane::new(DVec3::Y, 1.5).unwrap();
        assert_eq!(read_shape::<Plane>("<0,2,0> 1.5").0.unwrap(), floor);
        assert_eq!(read_shape::<Plane>("implicit <0,4,0,-6>").0.unwrap(), floor);
        assert_eq!(read_shape::<Plane>("point <7,1.5,2> normal <0,5,0>").0.unwrap(), floor);
        let spanned = read_shape::<Plane>("point <7,1.5,2> span <0,0,3> <2,0,0>").0.unwrap();
        assert_eq!((spanned.normal, spanned.distance), (floor.normal, floor.distance));
        for bad in ["0 1", "implicit <0,0,0,1>", "point 0 normal 0", "point 0 span <1,0,0> <2,0,0>"] {
            assert_eq!(read_shape::<Plane>(bad).0.unwrap_err().code, codes::NO_DIRECTION, "{bad}");
        }
        assert_eq!(read_shape::<Plane>("<0,1,0> 1 implicit <0,1,0,0>").0.unwrap_err().code, codes::TWO_FORMS);
    }

    proptest! {
        #[test]
        fn all_forms_agree(n in proptest::array::uniform3(-1.0..1.0f64), q in proptest::array::uniform3(-5.0..5.0f64),
                           o in proptest::array::uniform3(-5.0..5.0f64), v in proptest::array::uniform3(-1.0..1.0f64)) {
            let (n, q, ray) = (DVec3::from(n), DVec3::from(q), Ray::new(o.into(), v.into()));
            prop_assume!(n.length() > 0.1 && n.normalize().dot(ray.dir).abs() > 1e-3);
            let (i, j) = n.normalize().any_orthonormal_pair();
            let forms = [Plane::new(n, q.dot(n) / n.length()), Plane::from_implicit([n.x, n.y, n.z, -n.dot(q)]),
                         Plane::through_point(q, n), Plane::spanned(q, i * 2.0, i + j)];
            let want = n.dot(q - ray.origin) / n.dot(ray.dir);
            for plane in forms {
                let hit = plane.as_ref().and_then(|p| p.closest(&ray, Range::ALL)).unwrap();
                prop_assert!((hit.t - want).abs() <= 1e-9 * (1.0 + want.abs()), "{plane:?}");
            }
        }
    }
}
