//! Hits on intersections and merges of a few shapes that know their intervals along a ray.

use super::{SolidKind, SolidNode};
use crate::math::packet::{Numbers, RayPacket, set_lanes};
use crate::math::{Range, Ray};
use crate::shape::End;
use crate::world::convex_interval;
use crate::world::convex_packet::{ConvexSolid, PacketEnds, closest_of_packet_on_convex_solid};
use crate::world::leaf::{Intersection, Leaf};
use std::ops::ControlFlow;
use std::slice;

impl SolidNode {
    pub(super) fn has_convex_parts(&self) -> bool {
        self.composite.as_ref().is_some_and(|composite| composite.convex_parts)
    }

    pub(super) fn closest_of_convex_parts<'a>(&'a self, ray: &Ray, range: Range) -> Option<Intersection<'a>> {
        let mut nearest = None;
        let found = self.visit_unclipped_ends(ray, range, |end, leaf| {
            nearest = Some((end, leaf));
            // quirk: last_part_wins
            ControlFlow::Continue(end.t.next_up())
        });
        match found {
            Ok(()) => nearest.map(|(end, leaf)| Intersection::new(end.into(), leaf, self.object)),
            Err(convex_interval::UnknownInterval) => self.closest_of_parts(ray, range),
        }
    }

    /// Returns the closest hits of those rays of a packet that `rays` has as bits, each in the range from `min` to the number in
    /// `max`. `None` for a solid whose hits are computed ray by ray.
    pub(in crate::world) fn closest_of_packet(
        &self,
        packet: &RayPacket,
        mut rays: u32,
        (min, max): (f64, &Numbers),
    ) -> Option<PacketEnds<'_>> {
        let composite = self.composite.as_ref().filter(|composite| composite.traces_packets)?;
        if !composite.bounds.is_empty() {
            for i in set_lanes(rays) {
                rays &= !(u32::from(!self.crosses_all_bounds(&packet.ray(i))) << i);
            }
        }
        let solid = ConvexSolid {
            shapes: if let SolidKind::Leaf(_) = self.kind { slice::from_ref(self) } else { self.children() },
            is_merge: matches!(self.kind, SolidKind::Merge(_)),
            clips: &composite.clip,
            bounds: &composite.boxes.surface,
            skip_boxes: &composite.skip_boxes,
        };
        Some(closest_of_packet_on_convex_solid(&solid, packet, rays, min, max))
    }

    /// True if the ray hits, in the range, the surface of an intersection or merge.
    pub(super) fn any_of_convex_parts(&self, ray: &Ray, range: Range) -> bool {
        let mut is_hit = false;
        let found = self.visit_unclipped_ends(ray, range, |_, _| {
            is_hit = true;
            ControlFlow::Break(())
        });
        match found {
            Ok(()) => is_hit,
            Err(convex_interval::UnknownInterval) => self.any_of_parts(ray, range),
        }
    }

    /// Calls `visit` with the hits in the range on an intersection or merge that are not clipped away, and the shape that is
    /// hit. `visit` returns the distance up to which further hits count.
    fn visit_unclipped_ends<'a>(
        &'a self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(End, &'a Leaf) -> ControlFlow<(), f64>,
    ) -> Result<(), convex_interval::UnknownInterval> {
        let Some((min, max)) = self.distances_through_box(ray, range) else { return Ok(()) };
        let merged = matches!(self.kind, SolidKind::Merge(_));
        let is_skipped = |i: usize, range: Range| self.is_child_skipped(i, ray, range);
        convex_interval::visit_ends_on_surface(
            self.children(),
            merged,
            ray,
            Range { min, max },
            is_skipped,
            |end, leaf| {
                if self.is_inside_all_clips(ray.at(end.t)) {
                    visit(end, leaf)
                } else {
                    ControlFlow::Continue(f64::INFINITY)
                }
            },
        )
    }
}
