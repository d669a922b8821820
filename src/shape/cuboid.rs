//! `box { corner_1, corner_2 }`: a brick with its faces parallel to the coordinate planes.
//!
//! The corners are any two opposite ones. A box without thickness is a rectangle. A box with an infinite corner has no
//! end there.
//!
//! ```pov
//! box { <-1, 0, -1>, <1, 0.5, 1> pigment { color rgb <0.6, 0.4, 0.2> } }
//! ```

use super::{
    Crossing, End, HUGE, HalfSpaces, Hit, Hits, Kernel, PacketCrossings, PacketHits, Shape, check_finite,
    transformed_box,
};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::packet::{Numbers, PACKET, RayPacket};
use crate::math::{Aabb, DVec2, DVec3, Lanes, Range, Ray, Transform};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Axis-aligned box of the scene language (`Box` is a type of Rust).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cuboid {
    /// Corner of the box with the smaller coordinates, which are finite or -∞.
    pub min: DVec3,
    /// Corner of the box with the larger coordinates, which are finite or ∞.
    pub max: DVec3,
}

impl Cuboid {
    /// Creates the box between two opposite corners.
    pub fn new(a: DVec3, b: DVec3) -> Self {
        Self { min: a.min(b), max: a.max(b) }
    }

    /// Reads a box whose corners must be finite.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not a finite vector.
    pub fn read_finite(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self::new(r.vector()?, r.vector()?))
    }

    /// Returns where the ray enters and leaves the box, each with its face: axis · 2, plus 1 on the side of `max`
    /// (lecture, "Ray – AAB intersection").
    fn entry_and_exit(&self, ray: &Ray) -> Option<[End; 2]> {
        let mut near = End::on_single_piece(f64::NEG_INFINITY);
        let mut far = End::on_single_piece(f64::INFINITY);
        for axis in 0..3 {
            let (o, v) = (ray.origin[axis], ray.dir[axis]);
            let (lo, hi) = ((self.min[axis] - o) / v, (self.max[axis] - o) / v);
            let side = u32::from(v.is_sign_negative());
            let (enter, leave) = if side == 1 { (hi, lo) } else { (lo, hi) };
            // For a parallel ray both are infinite, or NaN within one of the planes, which the comparison ignores.
            if enter > near.t {
                near = End::on_piece(enter, axis as u32 * 2 + side);
            }
            if leave < far.t {
                far = End::on_piece(leave, axis as u32 * 2 + (1 - side));
            }
        }
        (near.t <= far.t && near.t < f64::INFINITY && far.t > f64::NEG_INFINITY).then_some([near, far])
    }
}

impl From<Aabb> for Shape {
    fn from(Aabb { min, max }: Aabb) -> Self {
        Cuboid { min, max }.into()
    }
}

impl Readable for Cuboid {
    const SPEC: Spec = Spec {
        name: "box",
        summary: "a brick with its faces parallel to the coordinate planes",
        params: &[
            Param { name: "corner_1", kind: ValueKind::Vector, summary: "any corner" },
            Param { name: "corner_2", kind: ValueKind::Vector, summary: "the corner opposite to it" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (a, b) = (r.unchecked_vector()?, r.unchecked_vector()?);
        if a.is_finite() && b.is_finite() {
            return Ok(Self::new(a, b));
        }
        // quirk: infinite_box
        let is_at_infinity = |axis: usize| a[axis] == b[axis] && a[axis].is_infinite();
        if a.is_nan() || b.is_nan() || (0..3).any(is_at_infinity) {
            check_finite(span, &[a, b], &[])?;
        }
        let warning = Diagnostic::new(codes::INFINITE, span, "this `box` has no end: a corner is infinite");
        r.report(warning.help("look for a division by zero; for a half-space take `plane`"));
        Ok(Self::new(a, b))
    }
}

impl Kernel for Cuboid {
    const TRACES_PACKETS: bool = true;

    fn bounds(&self) -> Aabb {
        Aabb { min: self.min, max: self.max }
    }

    fn pov_bounds(&self, m: &Transform) -> Aabb {
        let around = transformed_box(m, &self.bounds());
        if self.bounds().is_finite() { around } else { around.intersection(HUGE) }
    }

    fn half_spaces(&self) -> HalfSpaces {
        let sides = |axis: usize| [(DVec3::AXES[axis], self.max[axis]), (-DVec3::AXES[axis], -self.min[axis])];
        (0..3).flat_map(sides).collect()
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        if let Some(faces) = self.entry_and_exit(ray) {
            out.extend(faces.into_iter().filter(|end| range.contains(end.t)).map(Hit::from));
        }
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        self.entry_and_exit(ray)?.into_iter().find(|end| range.contains(end.t)).map(Hit::from)
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
        // The operations of `entry_and_exit`, in the same order
        let (mut near, mut far) = (Lanes::splat(f64::NEG_INFINITY), Lanes::splat(f64::INFINITY));
        let (mut entered, mut left) = ([0; PACKET], [0; PACKET]);
        for (axis, (o, v)) in rays.origin.axes().into_iter().zip(rays.dir.axes()).enumerate() {
            let (lo, hi) = ((Lanes::splat(self.min[axis]) - o) / v, (Lanes::splat(self.max[axis]) - o) / v);
            let is_reversed = v.has_negative_sign();
            let (enter, leave) = (is_reversed.select(hi, lo), is_reversed.select(lo, hi));
            let (is_later, is_earlier) = (near.less_than(enter), leave.less_than(far));
            (near, far) = (is_later.select(enter, near), is_earlier.select(leave, far));
            let (lower, upper) = ([axis as u32 * 2; PACKET], [axis as u32 * 2 + 1; PACKET]);
            entered = is_later.select_u32(is_reversed.select_u32(upper, lower), entered);
            left = is_earlier.select_u32(is_reversed.select_u32(lower, upper), left);
        }
        let infinity = Lanes::splat(f64::INFINITY);
        let crosses = near.at_most(far) & near.less_than(infinity) & (-infinity).less_than(far);
        PacketCrossings::through(crosses, [near, far], [entered, left])
    }

    fn inside(&self, p: DVec3) -> bool {
        self.bounds().contains(p)
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn crossing(&self, ray: &Ray) -> Crossing {
        self.entry_and_exit(ray).map_or(Crossing::Misses, Crossing::Through)
    }

    fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
        let axis = DVec3::AXES[(hit.part / 2).min(2) as usize];
        if hit.part % 2 == 1 { axis } else { -axis }
    }

    /// Returns surface coordinates on a cross of six squares, into which the box is unfolded, four wide and three high
    /// (manual, picture "UV Boxmap").
    fn uv(&self, p: DVec3, hit: &Hit) -> DVec2 {
        // 0 … 1 along each edge; 0 along an edge without length or end.
        let size = self.max - self.min;
        let has_length = size.cmpgt(DVec3::ZERO) & size.cmplt(DVec3::INFINITY);
        let f = DVec3::select(has_length, (p - self.min) / size, DVec3::ZERO);
        let (u, v) = match hit.part {
            0 => (f.z, 1.0 + f.y),
            1 => (3.0 - f.z, 1.0 + f.y),
            2 => (1.0 + f.x, f.z),
            3 => (1.0 + f.x, 3.0 - f.z),
            4 => (4.0 - f.x, 1.0 + f.y),
            _ => (1.0 + f.x, 1.0 + f.y),
        };
        DVec2::new(u / 4.0, v / 3.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, read_shape};

    fn unit() -> Cuboid {
        Cuboid::new(DVec3::ONE, DVec3::NEG_ONE)
    }

    #[test]
    fn packets_match_single_rays() {
        for corner in [DVec3::ONE, DVec3::new(0.7, 0.9, 0.0), DVec3::new(f64::INFINITY, 0.5, 0.5)] {
            crate::shape::testing::assert_packets_match_single_rays(&Cuboid::new(corner, DVec3::new(-0.6, -0.5, 0.0)));
        }
    }

    #[test]
    fn slabs() {
        // A diagonal ray enters by x = -1 at t = 2, and leaves by y = 1 where 0.5·t = 1 + 0.5.
        let ray = Ray::new(DVec3::new(-3.0, -0.5, 0.0), DVec3::new(1.0, 0.5, 0.0));
        assert_eq!(all_hits(&unit(), &ray), [Hit::on_piece(2.0, 0), Hit::on_piece(3.0, 3)]);
        assert_eq!(unit().normal(ray.at(3.0), &Hit::on_piece(3.0, 3)), DVec3::Y);
        // Backwards along the same line, twice as fast.
        let back = Ray::new(ray.at(5.0), ray.dir * -2.0);
        assert_eq!(all_hits(&unit(), &back), [Hit::on_piece(1.0, 3), Hit::on_piece(1.5, 0)]);
    }

    #[test]
    fn zero_components() {
        let along_z = |x, y| all_hits(&unit(), &Ray::new(DVec3::new(x, y, -5.0), DVec3::Z));
        assert_eq!(along_z(0.5, -0.5), [Hit::on_piece(4.0, 4), Hit::on_piece(6.0, 5)]);
        assert_eq!(along_z(1.0, -1.0).len(), 2, "a ray in a face's plane");
        assert_eq!(along_z(1.5, 0.0), []);
        assert_eq!(along_z(0.0, -1.5), []);
        let minus_zero = Ray::new(DVec3::new(0.0, 0.0, -5.0), DVec3::new(-0.0, -0.0, 1.0));
        assert_eq!(all_hits(&unit(), &minus_zero).len(), 2);
    }

    #[test]
    fn eye_inside() {
        let ray = Ray::new(DVec3::new(0.25, 0.0, 0.0), DVec3::X);
        assert_eq!(unit().closest(&ray, Range::FORWARD), Some(Hit::on_piece(0.75, 1)));
        assert_eq!(all_hits(&unit(), &ray), [Hit::on_piece(-1.25, 0), Hit::on_piece(0.75, 1)]);
        assert!(unit().inside(ray.origin) && unit().inside(DVec3::ONE) && !unit().inside(DVec3::X * 1.01));
    }

    #[test]
    fn flat_box_is_a_rectangle() {
        let flat = Cuboid::new(DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0));
        let ray = Ray::new(DVec3::new(0.5, 0.25, -2.0), DVec3::Z);
        assert_eq!(flat.closest(&ray, Range::FORWARD), Some(Hit::on_piece(2.0, 4)));
        assert!(flat.uv(ray.at(2.0), &Hit::on_piece(2.0, 4)).is_finite());
    }

    #[test]
    fn uv_is_a_cross_of_squares() {
        // POV-Ray's colours at pixel centres of box { -2, 2 } (sRGB bytes, so to 0.01).
        let cube = Cuboid::new(DVec3::splat(-2.0), DVec3::splat(2.0));
        let uv = |x: f64, y: f64, z: f64, part| cube.uv(DVec3::new(x, y, z), &Hit::on_piece(0.0, part));
        let near = |a: DVec2, u: f64, v: f64| assert!(a.distance(DVec2::new(u, v)) < 0.011, "{a} {u} {v}");
        near(uv(-1.5, 1.5, -2.0, 4), 0.96, 0.62);
        near(uv(1.5, 1.5, 2.0, 5), 0.47, 0.62);
        near(uv(2.0, 1.5, -1.5, 1), 0.72, 0.62);
        near(uv(-2.0, 1.5, 1.5, 0), 0.22, 0.62);
        near(uv(-1.5, 2.0, 1.5, 3), 0.28, 0.71);
        near(uv(-1.5, -2.0, -1.5, 2), 0.28, 0.04);
    }

    #[test]
    fn endless() {
        let beam = read_shape::<Cuboid>("<-inf,-1,-1> <inf,1,1>").0.unwrap();
        let across = Ray::new(DVec3::new(1e9, 0.5, -5.0), DVec3::Z);
        assert_eq!(all_hits(&beam, &across), [Hit::on_piece(4.0, 4), Hit::on_piece(6.0, 5)]);
        assert_eq!(all_hits(&beam, &Ray::new(DVec3::ZERO, DVec3::X)), []);
        assert_eq!(beam.closest(&Ray::new(DVec3::ZERO, -DVec3::X), Range::FORWARD), None);
        assert!(beam.inside(DVec3::X * -1e300) && !beam.inside(DVec3::Y * 2.0));
        assert_eq!(beam.uv(DVec3::new(7.0, 0.5, -1.0), &Hit::on_piece(4.0, 4)), DVec2::new(1.0, 1.75 / 3.0));
        let turned = Transform::rotate(DVec3::new(10.0, 20.0, 30.0));
        assert_eq!(beam.bounds_under(&turned), Aabb::INFINITE);
        assert_eq!(beam.pov_bounds(&turned), HUGE);
    }

    #[test]
    fn reading() {
        let shape = read_shape::<Cuboid>("1 -1").0.unwrap();
        assert_eq!(shape, unit());
        for bad in ["<1,nan,0> 0", "<inf,1,1> <inf,-1,-1>"] {
            assert_eq!(read_shape::<Cuboid>(bad).0.unwrap_err().code.0, "E0210", "{bad}");
        }
    }
}
