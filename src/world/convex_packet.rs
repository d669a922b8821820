//! Closest hits of packets of rays on intersections and merges of a few shapes that know their intervals along a ray, and on clipped
//! shapes: [`super::convex_interval`] for several rays side by side.

use super::convex_interval::SLACK;
use super::leaf::Leaf;
use super::node::{SolidKind, SolidNode};
use crate::math::packet::{Flags, Numbers, PACKET, RayPacket, set_lanes};
use crate::math::registers::wide_versions;
use crate::math::{Aabb, Lanes, Mask};
use crate::shape::{Kernel, PacketCrossings};
use smallvec::SmallVec;

/// A solid whose surface belongs to shapes that know their intervals along rays.
pub(super) struct ConvexSolid<'a> {
    /// The shapes, none of which is clipped.
    pub shapes: &'a [SolidNode],
    /// True for a merge of the shapes, false for their intersection.
    pub is_merge: bool,
    /// Clipping solids: points outside of any of them are removed.
    pub clips: &'a [SolidNode],
    /// Box around all hits.
    pub bounds: &'a Aabb,
    /// Boxes around those shapes that most rays miss; see [`SolidNode::skip_boxes`].
    pub skip_boxes: &'a [Option<Aabb>],
}

/// Closest hits of the rays of a packet on a solid.
pub(super) struct PacketEnds<'a> {
    /// True for the rays that hit the solid.
    pub is_hit: Flags,
    /// Parameter of each ray at its hit.
    pub t: Numbers,
    /// Part of the shape's surface that each ray hits; see [`crate::shape::Hit::part`].
    pub part: [u32; PACKET],
    /// Shape that each ray hits.
    pub leaf: [Option<&'a Leaf>; PACKET],
    /// True for the rays whose interval in some shape is not known, so that they must be traced one by one.
    pub is_unknown: Flags,
}

/// Intervals of the rays of a packet inside a convex shape, or their complements; see
/// [`super::convex_interval::ConvexInterval`].
struct PacketInterval {
    crossings: PacketCrossings,
    /// True for the rays that are inside the shape outside of the interval.
    is_inverse: Flags,
    /// [`SLACK`] in units of `t`.
    slack: Numbers,
}

wide_versions! {
    /// Returns where the rays of a packet are inside a shape.
    fn interval_inside_shape(leaf: &Leaf, rays: &RayPacket) -> PacketInterval {
        let mut buffer = None;
        let local_rays = leaf.local_rays(rays, &mut buffer);
        let crossings = leaf.shape.crossings_of_packet(local_rays);
        let is_inverse = if leaf.inverse { !crossings.is_around } else { crossings.is_around };
        let dir = local_rays.dir;
        let slack = Lanes::splat(SLACK) / (dir.x.abs() + dir.y.abs() + dir.z.abs());
        PacketInterval { crossings, is_inverse, slack }
    }
}

impl PacketInterval {
    /// True for the rays whose points from `min` to `max` are all inside the shape, and none of them near an end.
    #[inline(always)]
    fn contains_all_between(&self, min: Numbers, max: Numbers) -> Flags {
        let ([start, end], slack) = (self.crossings.t, self.slack);
        let is_outside_interval = max.less_than(start - slack) | (end + slack).less_than(min);
        let is_in_interval = (start + slack).less_than(min) & max.less_than(end - slack);
        self.is_inverse & is_outside_interval | !self.is_inverse & is_in_interval
    }

    /// Returns for which rays the point at `t` is inside the shape, and for which it is near an end, where the shape's `inside` must
    /// decide.
    #[inline(always)]
    fn contains(&self, t: Numbers) -> (Flags, Flags) {
        let [start, end] = self.crossings.t;
        let near = (t - start).abs().less_than(self.slack) | (t - end).abs().less_than(self.slack);
        let is_between = start.less_than(t) & t.less_than(end);
        (is_between & !self.is_inverse | !is_between & self.is_inverse, near)
    }
}

/// A shape or a clipping solid that has an effect on some rays.
struct PacketPart<'a> {
    interval: PacketInterval,
    node: &'a SolidNode,
    leaf: &'a Leaf,
    is_clip: bool,
    /// True for the rays on which the part has an effect.
    matters: Flags,
}

/// Search for the closest hits of the rays of a packet.
struct PacketSearch<'a, 'p> {
    packet: &'p RayPacket,
    /// True for the rays that may hit the solid.
    is_alive: Flags,
    is_unknown: Flags,
    /// Ends of the ranges in which hits count.
    min: Numbers,
    max: Numbers,
    parts: SmallVec<[PacketPart<'a>; 4]>,
}

impl<'a> PacketSearch<'a, '_> {
    /// Adds a part for the rays `considered`, and restricts their ranges to the intervals in it if `restricts` is true.
    #[inline(always)]
    fn add(&mut self, (node, leaf): (&'a SolidNode, &'a Leaf), considered: Flags, is_clip: bool, restricts: bool) {
        let interval = interval_inside_shape(leaf, self.packet);
        self.is_unknown = self.is_unknown | considered & !interval.crossings.is_known;
        self.is_alive = self.is_alive & !self.is_unknown;
        let mut matters = considered & self.is_alive;
        if restricts {
            let [start, end] = interval.crossings.t;
            let is_bounded = matters & !interval.is_inverse;
            self.min = is_bounded.select(self.min.max(start - interval.slack), self.min);
            self.max = is_bounded.select(self.max.min(end + interval.slack), self.max);
            self.is_alive = self.is_alive & self.min.less_than(self.max);
            matters = matters & self.is_alive & !interval.contains_all_between(self.min, self.max);
        }
        if matters.any() {
            self.parts.push(PacketPart { interval, node, leaf, is_clip, matters });
        }
    }

    /// Returns for which of the rays `candidates`, whose points at `t` are on the surface of part `number`, these points are on
    /// the surface of the solid.
    #[inline(always)]
    fn kept(&self, number: usize, t: Numbers, mut candidates: Flags, is_merge: bool) -> Flags {
        for (j, other) in self.parts.iter().enumerate() {
            if j == number || !candidates.any() {
                continue;
            }
            let (mut inside, near) = other.interval.contains(t);
            let undecided = (near & candidates & other.matters).bits();
            if undecided != 0 {
                let mut bits = inside.bits() & !undecided;
                for i in set_lanes(undecided) {
                    bits |= u32::from(other.node.inside(self.packet.ray(i).at(t.0[i]))) << i;
                }
                inside = Mask::from_bits(bits);
            }
            let fits = if is_merge && !other.is_clip { !inside } else { inside };
            candidates = candidates & (fits | !other.matters);
        }
        candidates
    }
}

/// Returns the shape of a clipping solid if its intervals along the rays of a packet can be computed.
fn shape_of_known_clip(clip: &SolidNode) -> Option<&Leaf> {
    clip.bare_leaf().filter(|leaf| leaf.shape.crosses_packets())
}

wide_versions! {
    /// Returns the closest hits of those rays of a packet that `lanes` has as bits, each in the range from `min` to the number in
    /// `max`: those that the rays have one by one.
    pub(super) fn closest_of_packet_on_convex_solid<'a>(
        solid: &ConvexSolid<'a>,
        packet: &RayPacket,
        lanes: u32,
        min: f64,
        max: &Numbers,
    ) -> PacketEnds<'a> {
        let (is_alive, min, max) = packet.slabs(solid.bounds, Lanes::splat(min), *max);
        let is_alive = is_alive & Flags::from_bits(lanes);
        let mut search =
            PacketSearch { packet, is_alive, is_unknown: Flags::NONE, min, max, parts: SmallVec::new() };
        for clip in solid.clips {
            if let Some(leaf) = shape_of_known_clip(clip) {
                search.add((clip, leaf), search.is_alive, true, true);
            }
        }
        for (i, shape) in solid.shapes.iter().enumerate() {
            let mut considered = search.is_alive;
            if let Some(Some(around)) = solid.skip_boxes.get(i) {
                considered = considered & packet.slabs(around, search.min, search.max).0;
            }
            if considered.any() && let SolidKind::Leaf(leaf) = shape.kind() {
                search.add((shape, leaf), considered, false, !solid.is_merge);
            }
        }
        let mut found = PacketEnds {
            is_hit: Flags::NONE,
            t: Lanes::splat(0.0),
            part: [0; PACKET],
            leaf: [None; PACKET],
            is_unknown: search.is_unknown,
        };
        let mut max = search.max;
        for (number, part) in search.parts.iter().enumerate() {
            if part.is_clip {
                continue;
            }
            for (t, piece) in part.interval.crossings.t.into_iter().zip(&part.interval.crossings.part) {
                let in_range = search.min.less_than(t) & t.less_than(max);
                let candidates = search.is_alive & part.matters & in_range;
                let mut kept = search.kept(number, t, candidates, solid.is_merge);
                if !kept.any() {
                    continue;
                }
                for clip in solid.clips.iter().filter(|clip| shape_of_known_clip(clip).is_none()) {
                    for i in set_lanes(kept.bits()) {
                        if !clip.inside(packet.ray(i).at(t.0[i])) {
                            kept = kept & !Flags::from_bits(1 << i);
                        }
                    }
                }
                set_lanes(kept.bits()).for_each(#[inline(always)] |i| found.leaf[i] = Some(part.leaf));
                found.is_hit = found.is_hit | kept;
                found.part = kept.select_u32(*piece, found.part);
                found.t = kept.select(t, found.t);
                // quirk: last_part_wins
                max = kept.select(t.next_up_of_positive(), max);
            }
        }
        found
    }
}
