//! Hits and intervals of packets of rays on a frustum, with the bits of single rays.

use super::{BASE, CAP, Frustum, Precomputed, WALL};
use crate::math::packet::{Flags, Numbers, PACKET, RayPacket, Vectors};
use crate::math::{Lanes, quadratic_roots_of_lanes};
use crate::shape::{PacketCrossings, PacketHits};

impl Frustum {
    /// Closest hits of the rays of a packet, see [`crate::shape::Kernel::closest_of_packet`].
    #[inline(always)]
    pub fn closest_of_packet(&self, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
        if self.is_empty() {
            return PacketHits::NONE;
        }
        let (shift, local) = self.packet_near_center(rays);
        if self.is_closed_cylinder() {
            return Self::cylinder_crossings(self.base_radius, &local, shift).first_in_range(min, max);
        }
        let mut hits = PacketHits { t: *max, ..PacketHits::NONE };
        for (is_hit, t, part) in self.meetings_of_wall_and_ends(&local, shift) {
            hits.keep_if_closer(is_hit, t, part, min);
        }
        hits
    }

    /// Intervals of the lines of a packet inside the frustum, see [`Self::crossing`].
    #[inline(always)]
    pub fn crossings_of_packet(&self, rays: &RayPacket) -> PacketCrossings {
        if !self.is_convex() {
            return PacketCrossings::UNKNOWN;
        }
        let (shift, local) = self.packet_near_center(rays);
        if self.base_radius == self.cap_radius {
            return Self::cylinder_crossings(self.base_radius, &local, shift);
        }
        // The first two of at most four meetings
        let (mut t, mut part) = ([Lanes::splat(0.0); 2], [[0; PACKET]; 2]);
        let (mut has_one, mut has_two, mut has_three) = (Flags::NONE, Flags::NONE, Flags::NONE);
        for (is_hit, s, piece) in self.meetings_of_wall_and_ends(&local, shift) {
            let is_hit = is_hit & s.is_finite();
            let (first, second) = (is_hit & !has_one, is_hit & has_one & !has_two);
            t = [first.select(s, t[0]), second.select(s, t[1])];
            part = [first.select_u32([piece; PACKET], part[0]), second.select_u32([piece; PACKET], part[1])];
            has_three = has_three | is_hit & has_two;
            (has_one, has_two) = (has_one | first, has_two | second);
        }
        let in_order = t[0].at_most(t[1]);
        let ends = [in_order.select(t[0], t[1]), in_order.select(t[1], t[0])];
        let parts = [in_order.select_u32(part[0], part[1]), in_order.select_u32(part[1], part[0])];
        // The rim belongs to the wall and to a disc.
        let is_known = !has_one | has_two & !has_three;
        PacketCrossings { is_known, ..PacketCrossings::through(has_two, ends, parts) }
    }

    /// Returns [`Self::t_point_direction_near_center`] for each ray, with w as z.
    #[inline(always)]
    fn packet_near_center(&self, rays: &RayPacket) -> (Numbers, RayPacket) {
        // The operations of `t_point_direction_near_center`, in the same order
        let Precomputed { along, across, middle } = &self.frame;
        let (along, x, y) = (Vectors::splat(*along), Vectors::splat(across.0), Vectors::splat(across.1));
        let shift = (Vectors::splat(*middle) - rays.origin).dot(rays.dir) / rays.dir.length_squared();
        let point = rays.origin + rays.dir * shift - Vectors::splat(self.base);
        let origin = Vectors { x: point.dot(x), y: point.dot(y), z: point.dot(along) };
        let dir = Vectors { x: rays.dir.dot(x), y: rays.dir.dot(y), z: rays.dir.dot(along) };
        (shift, RayPacket { origin, dir })
    }

    /// Intervals of lines inside a closed cylinder of this radius, in the frustum's frame, with w as z; `shift` is added to their
    /// parameters.
    #[inline(always)]
    fn cylinder_crossings(radius: f64, rays: &RayPacket, shift: Numbers) -> PacketCrossings {
        // The operations of `cylinder_interval`, in the same order
        let RayPacket { origin: o, dir: v } = rays;
        let (zero, one, infinity) = (Lanes::splat(0.0), Lanes::splat(1.0), Lanes::splat(f64::INFINITY));
        let r2 = Lanes::splat(radius * radius);
        let a = v.x * v.x + v.y * v.y;
        let turn = o.x * v.y - o.y * v.x;
        let discriminant = a * r2 - turn * turn;
        let distance = o.x * o.x + o.y * o.y;
        let crosses_wall = zero.less_than(a);
        let is_within = !(crosses_wall & discriminant.less_than(zero)) & (crosses_wall | !r2.at_most(distance));
        if !is_within.any() {
            return PacketCrossings::MISSES;
        }
        let [s1, s2] = quadratic_roots_of_lanes(a, o.x * v.x + o.y * v.y, distance - r2, discriminant);
        let (near, far) = (crosses_wall.select(s1, -infinity), crosses_wall.select(s2, infinity));
        let is_parallel_to_ends = v.z.equals(zero);
        let is_between_ends = !is_parallel_to_ends | (zero.at_most(o.z) & o.z.at_most(one));
        let (base, cap) = (-o.z / v.z, (one - o.z) / v.z);
        let rises = zero.less_than(v.z);
        let (enter, leave) = (rises.select(base, cap), rises.select(cap, base));
        let (enters, leaves) =
            (near.less_than(enter) & !is_parallel_to_ends, leave.less_than(far) & !is_parallel_to_ends);
        let (near, far) = (enters.select(enter, near), leaves.select(leave, far));
        let (wall, base, cap) = ([WALL; PACKET], [BASE; PACKET], [CAP; PACKET]);
        let parts = [
            enters.select_u32(rises.select_u32(base, cap), wall),
            leaves.select_u32(rises.select_u32(cap, base), wall),
        ];
        let crosses = is_within & is_between_ends & near.at_most(far);
        PacketCrossings::through(crosses, [near + shift, far + shift], parts)
    }

    /// Returns where lines in the frustum's frame, with w as z, meet the wall and the ends of a frustum that is not a closed
    /// cylinder: for each of four possible meetings, for which lines there is one, its parameter plus `shift`, and the part.
    #[inline(always)]
    fn meetings_of_wall_and_ends(&self, rays: &RayPacket, shift: Numbers) -> [(Flags, Numbers, u32); 4] {
        // The operations of `hits`, in the same order
        let RayPacket { origin: o, dir: v } = rays;
        let (zero, one) = (Lanes::splat(0.0), Lanes::splat(1.0));
        let dr = self.cap_radius - self.base_radius;
        let (r, slope) = (Lanes::splat(self.base_radius) + o.z * Lanes::splat(dr), v.z * Lanes::splat(dr));
        let (tx, ty) = (v.x * r - o.x * slope, v.y * r - o.y * slope);
        let turn = o.x * v.y - o.y * v.x;
        let discriminant = tx * tx + ty * ty - turn * turn;
        let meets_cone = !discriminant.less_than(zero);
        let mut meetings = [(Flags::NONE, zero, WALL); 4];
        if !meets_cone.any() {
            return meetings;
        }
        let a = v.x * v.x + v.y * v.y - slope * slope;
        let half_b = o.x * v.x + o.y * v.y - slope * r;
        let c = o.x * o.x + o.y * o.y - r * r;
        let has_roots = meets_cone & !(a.equals(zero) & half_b.equals(zero));
        for (meeting, s) in meetings.iter_mut().zip(quadratic_roots_of_lanes(a, half_b, c, discriminant)) {
            let w = o.z + s * v.z;
            *meeting = (has_roots & zero.at_most(w) & w.at_most(one), s + shift, WALL);
        }
        if self.open {
            return meetings;
        }
        let ends = [(zero, self.base_radius, BASE), (one, self.cap_radius, CAP)];
        for (meeting, (w, radius, part)) in meetings[2..].iter_mut().zip(ends) {
            let s = (w - o.z) / v.z;
            let (x, y) = (o.x + s * v.x, o.y + s * v.y);
            let is_on_disc = (x * x + y * y).less_than(Lanes::splat(radius * radius));
            *meeting = (meets_cone & !v.z.equals(zero) & is_on_disc, s + shift, part);
        }
        meetings
    }
}
