//! Searches by packets of rays. The hits are those that the rays have one by one.

use super::coherence::Coherence;
use super::{Blocker, Geometry, Item, ShadowRole};
use crate::math::packet::{Flags, MIN_RAYS, Numbers, PACKET, RayPacket, Vectors, set_lanes};
use crate::math::registers::wide_versions;
use crate::math::{Lanes, Mask, Range};
use crate::shape::{Hit, Kernel, PacketHits};
use crate::world::convex_packet::PacketEnds;
use crate::world::leaf::{self, Intersection, Leaf, Surface};
use std::ops::ControlFlow;

/// The closest hit of each ray of a packet.
pub type ClosestHits<'a> = [Option<Intersection<'a>>; PACKET];

/// Objects between the points of a packet and a light, by their effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PacketOcclusion {
    /// True for the rays that an object occludes wholly.
    pub occluded: Flags,
    /// True for the rays that may meet an object that filters their light.
    pub may_be_filtered: Flags,
}

impl Geometry {
    /// Finds the closest hits of the rays of a packet for which `counts` is true, in the range, which does not begin before 0, on
    /// the objects for which `accepts_object` returns true: those that [`Self::closest`] returns. `hits` must be empty.
    pub fn find_closest_of_packet<'a>(
        &'a self,
        packet: &RayPacket,
        counts: Flags,
        range: Range,
        accepts_object: impl Fn(u32) -> bool,
        (hits, coherence): (&mut ClosestHits<'a>, &mut Coherence),
    ) {
        if coherence.next_is_single(counts) {
            for i in set_lanes(counts.bits()) {
                hits[i] = self.closest(&packet.ray(i), range, &accepts_object);
            }
        } else {
            coherence.record(find_closest_of_packet(self, packet, counts, range, accepts_object, hits));
        }
    }

    /// Returns the effects of objects on the rays of a packet for which `counts` is true, each in the range from `min`, which is not negative, to
    /// the number in `max`; `role_of_object` returns the effect of an object by its number. Tests the object in `last_occluder`
    /// first, which occluded an earlier ray from nearby, and stores the new occluder there.
    pub fn occlusion_of_packet(
        &self,
        packet: &RayPacket,
        counts: Flags,
        (min, max): (f64, &Numbers),
        role_of_object: impl Fn(u32) -> ShadowRole,
        (last_occluder, coherence): (&mut Option<Blocker>, &mut Coherence),
    ) -> PacketOcclusion {
        if !coherence.next_is_single(counts) {
            let (occlusion, tests) =
                occlusion_of_packet(self, packet, counts, (min, max), role_of_object, last_occluder);
            coherence.record(tests);
            return occlusion;
        }
        let (mut occluded, mut filtered) = (0, 0);
        for i in set_lanes(counts.bits()) {
            let range = Range { min, max: max.0[i] };
            match self.filters_unless_occluded(&packet.ray(i), range, &role_of_object, last_occluder) {
                None => occluded |= 1 << i,
                Some(filters) => filtered |= u32::from(!filters.is_empty()) << i,
            }
        }
        PacketOcclusion { occluded: Mask::from_bits(occluded), may_be_filtered: Mask::from_bits(filtered) }
    }
}

wide_versions! {
    #[inline]
    fn find_closest_of_packet<'a; F: (Fn(u32) -> bool)>(
        geometry: &'a Geometry,
        packet: &RayPacket,
        counts: Flags,
        range: Range,
        accepts_object: F,
        hits: &mut ClosestHits<'a>,
    ) -> [u32; 2] {
        // Rays that do not count have empty ranges, so that shapes need not search for their hits.
        let mut max = counts.select(Lanes::splat(range.max), Lanes::splat(0.0));
        for item in geometry.items[geometry.finite..].iter().filter(|item| accepts_object(item.object())) {
            item.find_closest_of_packet(packet, counts.bits(), (range.min, &mut max), false, hits);
        }
        geometry.bvh.traverse_by_packet(packet, counts, range.min, &mut max, #[inline(always)] |i, rays, max| {
            let item = &geometry.items[i];
            if accepts_object(item.object()) {
                item.find_closest_of_packet(packet, rays, (range.min, max), true, hits);
            }
            ControlFlow::Continue(())
        })
    }
}

wide_versions! {
    #[inline]
    fn occlusion_of_packet<'a; F: (Fn(u32) -> ShadowRole)>(
        geometry: &'a Geometry,
        packet: &RayPacket,
        counts: Flags,
        range: (f64, &Numbers),
        role_of_object: F,
        last_occluder: &mut Option<Blocker>,
    ) -> (PacketOcclusion, [u32; 2]) {
        let (min, mut max) = (range.0, counts.select(*range.1, Lanes::splat(0.0)));
        let mut search = OcclusionSearch { geometry, packet, min, counting: counts.bits(), occluded: 0, filtered: 0, last_occluder };
        let hint = search.last_occluder.map(|Blocker(i)| i);
        let boundless = geometry.finite..geometry.items.len();
        for i in hint.into_iter().chain(boundless.filter(|i| Some(*i) != hint)) {
            search.visit(i, search.counting, &mut max, &role_of_object);
        }
        let mut tests = [0, 0];
        if search.occluded != search.counting {
            tests = geometry.bvh.traverse_by_packet(packet, counts, min, &mut max, #[inline(always)] |i, rays, max| {
                if Some(i) != hint {
                    search.visit(i, rays, max, &role_of_object);
                }
                if search.occluded == search.counting { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
        }
        let OcclusionSearch { occluded, filtered, .. } = search;
        let may_be_filtered = Mask::from_bits(filtered & !occluded);
        (PacketOcclusion { occluded: Mask::from_bits(occluded), may_be_filtered }, tests)
    }
}

/// Points and normals of the hits of a packet's rays, side by side; see [`Surface`].
#[derive(Clone, Copy, Debug)]
pub struct PacketSurfaces {
    point: Vectors,
    normal: Vectors,
    object_point: Vectors,
}

impl PacketSurfaces {
    /// Returns point and normal of one ray's hit.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> Surface {
        let Self { point, normal, object_point } = self;
        Surface { point: point.lane(i), normal: normal.lane(i), object_point: object_point.lane(i) }
    }
}

wide_versions! {
    /// Returns points and normals of the hits of those rays of a packet that `lanes` has as bits, as [`Intersection::surface`] does
    /// for each.
    pub fn surfaces_of_packet<'a>(rays: &RayPacket, hits: &ClosestHits<'a>, lanes: u32) -> PacketSurfaces {
        let zero = Vectors::ZERO;
        let mut all = PacketSurfaces { point: zero, normal: zero, object_point: zero };
        let (mut own_hits, mut t, mut left) = ([Hit::on_single_piece(0.0); PACKET], Lanes::splat(0.0), 0);
        for i in set_lanes(lanes) {
            let Some(found) = &hits[i] else { continue };
            (own_hits[i], t.0[i]) = (found.hit, found.hit.t);
            left |= 1 << i;
        }
        // All rays that hit the same shape at once
        while left != 0 {
            let first = u32::trailing_zeros(left) as usize % PACKET;
            let Some(found) = &hits[first] else { break };
            if found.instance.is_some() {
                let Surface { point, normal, object_point } = found.surface(&rays.ray(first));
                all.point.set_lane(first, point);
                all.normal.set_lane(first, normal);
                all.object_point.set_lane(first, object_point);
                left &= !(1 << first);
                continue;
            }
            let mut lanes = 0;
            for i in set_lanes(left) {
                let is_same = |other: &Intersection| std::ptr::eq(other.leaf, found.leaf) && other.instance.is_none();
                lanes |= u32::from(hits[i].as_ref().is_some_and(is_same)) << i;
            }
            let own = surfaces_of_leaf(found.leaf, rays, t, &own_hits, lanes);
            let flags = Flags::from_bits(lanes);
            all.point = Vectors::select(flags, own.point, all.point);
            all.normal = Vectors::select(flags, own.normal, all.normal);
            all.object_point = Vectors::select(flags, own.object_point, all.object_point);
            left &= !lanes;
        }
        all
    }
}

/// Returns points and normals of the hits of the rays `lanes` on one shape.
#[inline(always)]
fn surfaces_of_leaf(leaf: &Leaf, rays: &RayPacket, t: Numbers, hits: &[Hit; PACKET], lanes: u32) -> PacketSurfaces {
    // The operations of `Intersection::surface`, in the same order
    let (object_point, point, normal);
    match &leaf.place {
        Some(m) => {
            object_point = rays.inverse_transformed(m).at(t);
            point = object_point.transformed_as_points(&m.m);
            normal = leaf.shape.normals_of_packet(&object_point, hits, lanes).transformed_as_normals(m);
        }
        None => {
            object_point = rays.at(t);
            point = object_point;
            normal = leaf.shape.normals_of_packet(&object_point, hits, lanes);
        }
    }
    let normal = if leaf.inverse { -normal } else { normal };
    PacketSurfaces { point, normal: normal.normalize_or(-rays.dir), object_point }
}

/// State of the search for objects between the points of a packet and a light.
struct OcclusionSearch<'a> {
    geometry: &'a Geometry,
    packet: &'a RayPacket,
    min: f64,
    /// Rays that count, as bits.
    counting: u32,
    /// Rays that an object occludes, as bits.
    occluded: u32,
    /// Rays that may meet an object that filters their light, as bits.
    filtered: u32,
    last_occluder: &'a mut Option<Blocker>,
}

impl OcclusionSearch<'_> {
    /// Tests an object with the rays `rays`. The ranges of rays that it occludes become empty.
    #[inline(always)]
    fn visit(&mut self, index: usize, rays: u32, max: &mut Numbers, role_of_object: &impl Fn(u32) -> ShadowRole) {
        let item = &self.geometry.items[index];
        match role_of_object(item.object()) {
            ShadowRole::Occludes => {
                let found = item.any_of_packet(self.packet, rays & !self.occluded, self.min, max);
                if found != 0 {
                    (*self.last_occluder, self.occluded) = (Some(Blocker(index)), self.occluded | found);
                    set_lanes(found).for_each(|lane| max.0[lane] = 0.0);
                }
            }
            ShadowRole::Filters => self.filtered |= rays,
            ShadowRole::Ignored => {}
        }
    }
}

/// Replaces the hit of a ray if the hit `found` wins against it, and the end of the ray's range: it then excludes the hit, unless
/// `keeps_hit_in_range` is true.
#[inline(always)]
fn keep_if_closer<'a>(
    found: Intersection<'a>,
    hit: &mut Option<Intersection<'a>>,
    max: &mut f64,
    keeps_hit_in_range: bool,
) {
    if hit.as_ref().is_none_or(|before| found.wins_against(before)) {
        *max = if keeps_hit_in_range { found.t().next_up() } else { found.t() };
        *hit = Some(found);
    }
}

impl Item {
    /// Finds the closest hits of the rays `rays` of a packet on the object, each in the range from `min` to the number in `max`,
    /// and replaces worse ones in `hits`. The new ends of the ranges exclude the hits themselves, unless `keeps_hit_in_range`.
    #[inline(always)]
    fn find_closest_of_packet<'a>(
        &'a self,
        packet: &RayPacket,
        rays: u32,
        (min, max): (f64, &mut Numbers),
        keeps_hit_in_range: bool,
        hits: &mut ClosestHits<'a>,
    ) {
        if let Self::Solid(node) = self
            && let Some(leaf) = node.bare_leaf()
            && leaf.shape.traces_packets()
        {
            let PacketHits { is_hit, t, part } = leaf::closest_of_packet(leaf, packet, min, max);
            for lane in set_lanes(is_hit.bits() & rays) {
                let found = Intersection::new(Hit::on_piece(t.0[lane], part[lane]), leaf, node.object);
                keep_if_closer(found, &mut hits[lane], &mut max.0[lane], keeps_hit_in_range);
            }
            return;
        }
        let single_rays = match self.closest_of_packet_on_composite(packet, rays, (min, max)) {
            Some((object, ends)) => {
                for lane in set_lanes(ends.is_hit.bits()) {
                    let Some(leaf) = ends.leaf[lane] else { continue };
                    let found = Intersection::new(Hit::on_piece(ends.t.0[lane], ends.part[lane]), leaf, object);
                    keep_if_closer(found, &mut hits[lane], &mut max.0[lane], keeps_hit_in_range);
                }
                ends.is_unknown.bits()
            }
            None => rays,
        };
        for lane in set_lanes(single_rays) {
            let mut found = None;
            if self.find_closest(&packet.ray(lane), Range { min, max: max.0[lane] }, &mut found)
                && let Some(found) = found
            {
                keep_if_closer(found, &mut hits[lane], &mut max.0[lane], keeps_hit_in_range);
            }
        }
    }

    /// Returns those of the rays `rays` of a packet that hit the object, each in the range from `min` to the number in `max`.
    #[inline(always)]
    fn any_of_packet(&self, packet: &RayPacket, rays: u32, min: f64, max: &Numbers) -> u32 {
        if let Self::Solid(node) = self
            && let Some(leaf) = node.bare_leaf()
            && leaf.shape.traces_packets()
        {
            return leaf::closest_of_packet(leaf, packet, min, max).is_hit.bits() & rays;
        }
        let (found, single_rays) = match self.closest_of_packet_on_composite(packet, rays, (min, max)) {
            Some((_, ends)) => (ends.is_hit.bits(), ends.is_unknown.bits()),
            None => (0, rays),
        };
        let is_hit = |lane: usize| self.any(&packet.ray(lane), Range { min, max: max.0[lane] });
        set_lanes(single_rays).filter(|lane| is_hit(*lane)).fold(found, |bits, lane| bits | 1 << lane)
    }

    /// Returns the number and the closest hits of the rays `rays` of a packet on a composite solid, each in the range from `min` to
    /// the number in `max`. `None` if they must be computed ray by ray, which is quicker for few rays.
    #[inline]
    fn closest_of_packet_on_composite(
        &self,
        packet: &RayPacket,
        rays: u32,
        range: (f64, &Numbers),
    ) -> Option<(u32, PacketEnds<'_>)> {
        match self {
            Self::Solid(node) if rays.count_ones() as usize >= MIN_RAYS => {
                node.closest_of_packet(packet, rays, range).map(|ends| (node.object, ends))
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::registers::testing::for_all_registers;
    use crate::math::{Aabb, DVec3, Ray, Transform, rng};
    use crate::shape::Shape;
    use crate::world::SolidNode;

    fn random(i: usize, n: u64) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|axis| rng::random_unit(&[i as u64, n, axis]) * 2.0 - 1.0))
    }

    /// A box, or the difference of two, or an inverted one; some at the same places as others.
    fn object(i: usize) -> SolidNode {
        let p = random(i / 2, 1) * 3.0;
        let cuboid = |size: f64| Shape::from(Aabb::from_corners(p - size, p + (random(i / 2, 2) + 1.5) * size));
        let place = match i % 3 {
            0 => Transform::IDENTITY,
            _ => Transform::rotate(random(i, 5) * 90.0).then(&Transform::translate(random(i, 6))),
        };
        let leaf = |shape, number: usize| SolidNode::leaf(Leaf::new(shape, &place, number as u32), i as u32);
        match i % 11 {
            4 => SolidNode::difference(vec![leaf(cuboid(0.5), i), leaf(cuboid(0.3), i + 100)], i as u32),
            7 => leaf(cuboid(0.4), i).inverted(),
            _ => leaf(cuboid(0.4), i),
        }
    }

    /// Thirty objects, and an endless one.
    fn geometry() -> Geometry {
        let endless =
            Shape::from(Aabb { min: DVec3::NEG_INFINITY, max: DVec3::new(f64::INFINITY, -4.0, f64::INFINITY) });
        let endless = SolidNode::leaf(Leaf::new(endless, &Transform::IDENTITY, 31), 31);
        Geometry::new((0..30).map(object).chain([endless]).collect())
    }

    fn packet(number: usize) -> RayPacket {
        let (from, to) = (random(number, 20) * 8.0, random(number, 21) * 2.0);
        RayPacket::new(PACKET, |lane| {
            let shift = random(number * PACKET + lane, 22) * [0.02, 2.0][number % 2];
            Ray::new(from, (to + shift - from).normalize())
        })
    }

    #[test]
    fn packets_have_the_closest_hits_of_single_rays() {
        let geometry = geometry();
        let range = Range { min: 1e-4, max: 20.0 };
        let mut n_hits = 0;
        for number in 0..150 {
            let rays = packet(number);
            let counting = [0xff, 0x6d][number % 2];
            for_all_registers(|registers| {
                let mut hits = ClosestHits::default();
                let accepts = |object: u32| !object.is_multiple_of(5);
                let coherence = &mut Coherence::default();
                geometry.find_closest_of_packet(
                    &rays,
                    Mask::from_bits(counting),
                    range,
                    accepts,
                    (&mut hits, coherence),
                );
                let surfaces = surfaces_of_packet(&rays, &hits, counting);
                for (i, found) in hits.iter().enumerate() {
                    let ray = rays.ray(i);
                    let alone = geometry.closest(&ray, range, accepts).filter(|_| counting >> i & 1 == 1);
                    let [a, b] = [found, &alone].map(|hit| hit.as_ref().map(|hit| (hit.hit, hit.leaf.id, hit.object)));
                    assert_eq!(a, b, "{registers:?} {number} {i}");
                    if let Some(alone) = alone {
                        assert_eq!(surfaces.lane(i), alone.surface(&ray), "{registers:?} {number} {i}");
                        n_hits += 1;
                    }
                }
            });
        }
        assert!(n_hits > 1000, "{n_hits}");
    }

    #[test]
    fn packets_are_occluded_as_single_rays() {
        let geometry = geometry();
        let role = |object: u32| match object % 5 {
            0 => ShadowRole::Ignored,
            1 => ShadowRole::Filters,
            _ => ShadowRole::Occludes,
        };
        let (mut n_occluded, mut n_filtered) = (0, 0);
        let mut last_occluder = None;
        for number in 0..150 {
            let rays = packet(number);
            let max = Lanes(std::array::from_fn(|lane| [15.0, 6.0, 1e-4][(number + lane) % 3]));
            let counting: u32 = [0xff, 0x6d][number % 2];
            for_all_registers(|registers| {
                let found = geometry.occlusion_of_packet(
                    &rays,
                    Mask::from_bits(counting),
                    (1e-3, &max),
                    role,
                    (&mut last_occluder, &mut Coherence::default()),
                );
                for i in set_lanes(counting) {
                    let (ray, range) = (rays.ray(i), Range { min: 1e-3, max: max.0[i] });
                    let alone = geometry.filters_unless_occluded(&ray, range, role, &mut None);
                    let is_occluded = found.occluded.bits() >> i & 1 == 1;
                    assert_eq!(is_occluded, alone.is_none(), "{registers:?} {number} {i}");
                    let has_filters = geometry.any(&ray, range, |object| role(object) == ShadowRole::Filters);
                    let may_be_filtered = found.may_be_filtered.bits() >> i & 1 == 1;
                    assert!(is_occluded || may_be_filtered || !has_filters, "{registers:?} {number} {i}");
                    (n_occluded, n_filtered) =
                        (n_occluded + u32::from(is_occluded), n_filtered + u32::from(may_be_filtered));
                }
                assert_eq!((found.occluded | found.may_be_filtered).bits() & !counting, 0);
            });
        }
        assert!(n_occluded > 500 && n_filtered > 100, "{n_occluded} {n_filtered}");
    }
}
