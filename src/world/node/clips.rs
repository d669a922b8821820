//! `clipped_by`: the parts of a solid's surface that are inside all of its clipping solids.

use super::SolidNode;
use crate::math::{DVec3, Range, Ray};
use crate::shape::{Hit, Hits};
use crate::world::convex_interval;
use crate::world::leaf::{Intersection, Intersections, Leaf};

impl SolidNode {
    /// True if the point is inside all clipping solids of the node.
    pub(super) fn is_inside_all_clips(&self, p: DVec3) -> bool {
        self.clip().iter().all(|c| c.inside(p))
    }

    /// Returns the part of the range in the box and in those clipping solids that can compute their interval; `None` if
    /// it is empty.
    pub(super) fn range_in_box_and_clips(&self, ray: &Ray, range: Range) -> Option<Range> {
        let (min, max) = self.distances_through_box(ray, range)?;
        let within = self
            .clip()
            .iter()
            .fold(Range { min, max }, |range, c| convex_interval::range_possibly_inside(c, ray, range));
        (!within.is_empty()).then_some(within)
    }

    /// Returns the closest hit on a clipped shape that is inside all clipping solids.
    pub(super) fn closest_of_clipped_leaf(&self, leaf: &Leaf, ray: &Ray, range: Range) -> Option<Hit> {
        let range = self.range_in_box_and_clips(ray, range)?;
        let mut hits = Hits::new();
        leaf.limited_hits_for_csg(ray, range, &mut hits);
        let mut best: Option<Hit> = None;
        for hit in &hits {
            if best.is_none_or(|best| hit.t < best.t) && self.is_inside_all_clips(ray.at(hit.t)) {
                best = Some(*hit);
            }
        }
        best
    }

    /// Returns the first hit of a ray on a child that is not clipped away. `buffer` is overwritten.
    pub(super) fn first_unclipped_hit<'a>(
        &self,
        child: &'a SolidNode,
        ray: &Ray,
        range: Range,
        buffer: &mut Intersections<'a>,
    ) -> Option<Intersection<'a>> {
        // Usually the first hit on a shape decides.
        if let Some(leaf) = child.bare_leaf() {
            let hit = leaf.closest(ray, range)?;
            if self.is_inside_all_clips(ray.at(hit.t)) {
                return Some(Intersection::new(hit, leaf, child.object));
            }
        }
        buffer.clear();
        child.hits(ray, range, buffer);
        let mut first: Option<Intersection> = None;
        for hit in buffer.iter() {
            if first.is_none_or(|first| hit.t() < first.t()) && self.is_inside_all_clips(ray.at(hit.t())) {
                first = Some(*hit);
            }
        }
        first
    }

    /// Returns the closest hit of a clipped union: the first one that is not clipped away. Of several hits at one point
    /// the last part wins (quirk: `last_part_wins`).
    pub(super) fn closest_of_clipped_union<'a>(&'a self, ray: &Ray, range: Range) -> Option<Intersection<'a>> {
        let mut best: Option<(usize, Intersection)> = None;
        let mut hits = Intersections::new();
        self.each_child_on_ray(ray, range, |i, child, range| {
            let Some(found) = self.first_unclipped_hit(child, ray, range, &mut hits) else { return range };
            let wins = |(j, best): (usize, Intersection)| found.t() < best.t() || (found.t() == best.t() && i > j);
            if best.is_none_or(wins) {
                best = Some((i, found));
            }
            best.map_or(range, |(_, found)| Range { max: range.max.min(found.t().next_up()), ..range })
        });
        best.map(|(_, found)| Intersection { object: self.object, ..found })
    }
}
