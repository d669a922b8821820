//! Hits of a ray on an intersection or merge of any parts.
//!
//! The parts of a composite solid are the shapes in it, at any depth of nested intersections, merges and unions. A nested
//! solid that is clipped or has invisible parts is one part. Parts are numbered in the order of the tree. A ray is
//! intersected with each part once; the intervals of the ray inside the other parts then decide which hits are on the
//! solid's surface.

use super::{SolidKind, SolidNode};
use crate::math::{DVec3, Range, Ray};
use crate::world::convex_interval::ConvexInterval;
use crate::world::leaf::{Intersection, Intersections};
use smallvec::SmallVec;

/// Parts of one composite solid that the current ray may hit, with the hits on them.
struct PartsOnRay<'a> {
    /// Range of distances in which hits count.
    range: Range,
    /// Parts that the ray can hit.
    parts: SmallVec<[PartOnRay<'a>; 16]>,
    /// Hits on parts that can't compute intervals.
    hits: Intersections<'a>,
    /// Hits on the parts within the range, whether or not they are on the solid's surface.
    candidates: SmallVec<[Candidate; 16]>,
}

/// Part of the solid that the current ray may hit, with the ray's interval inside the part.
struct PartOnRay<'a> {
    node: &'a SolidNode,
    /// Number of the part in the solid.
    number: u32,
    /// Interval of the ray inside the part; `None` if the part can't compute it.
    interval: Option<ConvexInterval>,
}

impl PartOnRay<'_> {
    /// True if the point of the ray is inside the part.
    #[inline]
    fn contains(&self, at: &PointOnRay) -> bool {
        let known = self.interval.as_ref().and_then(|interval| interval.contains(at.t));
        known.unwrap_or_else(|| self.node.inside(at.point))
    }
}

/// A hit on a part, before the test whether the hit is on the solid's surface.
#[derive(Clone, Copy)]
struct Candidate {
    t: f64,
    /// Index of the part in [`PartsOnRay::parts`].
    part: u32,
    /// End of the part's interval, 0 or 1; or index in [`PartsOnRay::hits`] if the part has no interval.
    hit: u32,
}

/// A point on a ray.
struct PointOnRay {
    t: f64,
    point: DVec3,
}

impl SolidNode {
    /// Returns the closest hit on an intersection or merge: tests the hits on its parts by distance until one is on the
    /// surface and not clipped away.
    pub(super) fn closest_of_parts<'a>(&'a self, ray: &Ray, range: Range) -> Option<Intersection<'a>> {
        let mut parts = PartsOnRay::new();
        parts.collect(self, ray, range);
        parts.sort_candidates(self);
        let kept = parts.candidates.iter().find(|candidate| {
            let at = PointOnRay { t: candidate.t, point: ray.at(candidate.t) };
            parts.is_on_surface_of_solid(self, candidate, &at) && self.is_inside_all_clips(at.point)
        });
        kept.map(|candidate| parts.intersection(candidate, self.object))
    }

    /// True if any hit on an intersection or merge is on its surface and not clipped away.
    pub(super) fn any_of_parts(&self, ray: &Ray, range: Range) -> bool {
        let mut parts = PartsOnRay::new();
        parts.collect(self, ray, range);
        parts.candidates.iter().any(|candidate| {
            let at = PointOnRay { t: candidate.t, point: ray.at(candidate.t) };
            parts.is_on_surface_of_solid(self, candidate, &at) && self.is_inside_all_clips(at.point)
        })
    }

    /// Appends all hits on an intersection or merge before clipping to `out`, in no particular order.
    pub(super) fn hits_of_parts<'a>(&'a self, ray: &Ray, range: Range, out: &mut Intersections<'a>) {
        let mut parts = PartsOnRay::new();
        parts.collect(self, ray, range);
        let kept = parts.candidates.iter().filter(|candidate| {
            let at = PointOnRay { t: candidate.t, point: ray.at(candidate.t) };
            parts.is_on_surface_of_solid(self, candidate, &at)
        });
        out.extend(kept.map(|candidate| parts.intersection(candidate, self.object)));
    }

    /// True if the node counts as a single part of the solid that contains it: a shape, a clipped solid, or a solid with
    /// invisible parts.
    fn is_single_part(&self) -> bool {
        matches!(self.kind, SolidKind::Leaf(_)) || !self.clip().is_empty() || !self.invisible_parts().is_empty()
    }

    fn part_numbers(&self) -> Option<&PartNumbers> {
        self.composite.as_ref().map(|composite| &composite.parts)
    }

    /// Returns the number of parts in this node; 1 for a single part.
    fn n_parts(&self) -> usize {
        if self.is_single_part() { 1 } else { self.part_numbers().map_or(0, |numbers| numbers.n_parts) }
    }

    /// Returns the number of the first part of child `i`, relative to the first part of this node.
    fn first_part_of_child(&self, i: usize) -> usize {
        let first = self.part_numbers().and_then(|numbers| numbers.first.get(i));
        first.map_or(i, |&number| number as usize)
    }

    /// Returns the index of the child that contains part `number`; parts are counted from the first part of this node.
    fn child_with_part(&self, number: usize) -> usize {
        match self.part_numbers() {
            Some(PartNumbers { first, .. }) if !first.is_empty() => {
                first.partition_point(|&first| first as usize <= number) - 1
            }
            _ => number,
        }
    }
}

/// Numbers of the parts of a composite solid.
#[derive(Clone, Debug)]
pub(super) struct PartNumbers {
    /// Number of the first part of each child; empty if each child is a single part, whose number is its index.
    first: Box<[u32]>,
    n_parts: usize,
}

impl PartNumbers {
    /// True if the parts are the children themselves.
    fn are_children(&self) -> bool {
        self.first.is_empty()
    }

    /// Numbers the parts of the children of a composite solid.
    pub(super) fn new(children: &[SolidNode]) -> Self {
        if children.iter().all(SolidNode::is_single_part) {
            return Self { first: Box::default(), n_parts: children.len() };
        }
        let mut n_parts = 0;
        let next = |child: &SolidNode| {
            let first = n_parts;
            n_parts += child.n_parts();
            first as u32
        };
        let first = children.iter().map(next).collect();
        Self { first, n_parts }
    }
}

impl<'a> PartsOnRay<'a> {
    /// Creates an empty list. (Built in place, because the struct is large.)
    #[inline(always)]
    fn new() -> Self {
        Self { range: Range::ALL, parts: SmallVec::new(), hits: SmallVec::new(), candidates: SmallVec::new() }
    }

    /// Finds the parts of `solid` that the ray can hit, their intervals and the hits on them within the range.
    fn collect(&mut self, solid: &'a SolidNode, ray: &Ray, range: Range) {
        let only_inside = matches!(solid.kind, SolidKind::Intersection(_));
        solid.each_child_on_ray(ray, range, |i, child, range| {
            self.range = self.range.intersection(range);
            let is_skipped = solid.is_child_skipped(i, ray, self.range);
            self.add_parts(child, solid.first_part_of_child(i), ray, only_inside, is_skipped);
            self.range
        });
        if self.range.is_empty() {
            return;
        }
        // (A hierarchy visits children in an order that depends on the ray.)
        if !self.parts.is_sorted_by_key(|part| part.number) {
            self.parts.sort_unstable_by_key(|part| part.number);
        }
        for i in 0..self.parts.len() {
            self.add_candidates(i, ray);
        }
    }

    /// Adds the parts of `node` that the ray can hit; `first` is the number of the node's first part. With `only_inside`,
    /// hits count only inside `node`: the range shrinks to the node's interval. `is_skipped` is true if the node is a shape
    /// without any surface on the ray.
    fn add_parts(&mut self, node: &'a SolidNode, first: usize, ray: &Ray, only_inside: bool, is_skipped: bool) {
        if !node.is_single_part() {
            if !node.crosses_all_bounds(ray) {
                return;
            }
            node.each_child_on_ray(ray, self.range, |i, part, range| {
                let is_skipped = node.is_child_skipped(i, ray, range);
                self.add_parts(part, first + node.first_part_of_child(i), ray, false, is_skipped);
                range
            });
            return;
        }
        let interval = match &node.kind {
            SolidKind::Leaf(leaf) if is_skipped => Some(ConvexInterval::without_surface(leaf.inverse)),
            SolidKind::Leaf(leaf) if node.composite.is_none() => ConvexInterval::inside_shape_if_known(leaf, ray),
            _ => None,
        };
        if let Some(interval) = interval.as_ref().filter(|_| only_inside) {
            self.range = interval.possible_range(self.range);
        }
        self.parts.push(PartOnRay { node, number: first as u32, interval });
    }

    /// Adds the hits on the part with the index `i` in the list `parts` within the range.
    fn add_candidates(&mut self, i: usize, ray: &Ray) {
        let part = i as u32;
        match &self.parts[i].interval {
            Some(interval) => {
                let ends = interval.ends.map(|end| end.t);
                for (t, hit) in ends.into_iter().zip(0..).filter(|(t, _)| self.range.contains(*t)) {
                    self.candidates.push(Candidate { t, part, hit });
                }
            }
            None => {
                let first = self.hits.len();
                self.parts[i].node.hits_as(true, ray, self.range, &mut self.hits);
                let added = self.hits[first..].iter().zip(first as u32..);
                self.candidates.extend(added.map(|(found, hit)| Candidate { t: found.t(), part, hit }));
            }
        }
    }

    /// Sorts the candidates by distance; at equal distances, the last child of `solid` comes first (quirk:
    /// `last_part_wins`), and hits on the same child keep the order of their parts.
    fn sort_candidates(&mut self, solid: &SolidNode) {
        let parts = &self.parts;
        let child = |candidate: &Candidate| solid.child_with_part(parts[candidate.part as usize].number as usize);
        self.candidates.sort_by(|a, b| a.t.total_cmp(&b.t).then_with(|| child(b).cmp(&child(a))));
    }

    /// Returns the interval of the part with this number; `None` for a part that can't compute its interval, or that the ray
    /// cannot hit.
    fn interval(&self, number: usize) -> Option<&ConvexInterval> {
        // Usually every part is in the list, so that its number is its index.
        let i = match self.parts.get(number) {
            Some(part) if part.number as usize == number => number,
            _ => self.parts.binary_search_by_key(&number, |part| part.number as usize).ok()?,
        };
        self.parts[i].interval.as_ref()
    }

    /// Returns the hit of a candidate, as a hit on the object with this number.
    fn intersection(&self, candidate: &Candidate, object: u32) -> Intersection<'a> {
        let PartOnRay { node, interval, .. } = &self.parts[candidate.part as usize];
        match (&node.kind, interval) {
            (SolidKind::Leaf(leaf), Some(interval)) => {
                Intersection::new(interval.ends[candidate.hit as usize].into(), leaf, object)
            }
            _ => Intersection { object, ..self.hits[candidate.hit as usize] },
        }
    }

    /// True if a hit on a part is on the surface of the whole solid before clipping.
    fn is_on_surface_of_solid(&self, solid: &SolidNode, candidate: &Candidate, at: &PointOnRay) -> bool {
        let hit = candidate.part as usize;
        if !solid.part_numbers().is_some_and(PartNumbers::are_children) {
            return self.is_on_surface(solid, 0, self.parts[hit].number as usize, at);
        }
        // Children that the ray cannot hit decide nothing.
        let merged = matches!(solid.kind, SolidKind::Merge(_));
        self.parts.iter().enumerate().all(|(i, other)| i == hit || other.contains(at) != merged)
    }

    /// True if a hit on part `part` of the solid is on the surface of `node`, which contains that part. `first` is the number
    /// of the node's first part.
    fn is_on_surface(&self, node: &SolidNode, first: usize, part: usize, at: &PointOnRay) -> bool {
        let child = node.child_with_part(part - first);
        let inside = |i: usize, other: &SolidNode| self.contains(other, first + node.first_part_of_child(i), at);
        let is_kept = match &node.kind {
            SolidKind::Leaf(_) | SolidKind::Union(_) => true,
            SolidKind::Intersection(_) => node.all_other_children_near(at.point, child, inside),
            SolidKind::Merge(_) => node.all_other_children_near(at.point, child, |i, other| !inside(i, other)),
        };
        let hit_child = &node.children()[child];
        is_kept
            && (hit_child.is_single_part()
                || self.is_on_surface(hit_child, first + node.first_part_of_child(child), part, at))
    }

    /// True if the point of the ray is inside `node`, whose first part has the number `first`.
    fn contains(&self, node: &SolidNode, first: usize, at: &PointOnRay) -> bool {
        if node.is_single_part() {
            let known = self.interval(first).and_then(|interval| interval.contains(at.t));
            return known.unwrap_or_else(|| node.inside(at.point));
        }
        let Some(composite) = &node.composite else { return node.inside(at.point) };
        if !composite.boxes.solid.contains(at.point) {
            return false;
        }
        if !composite.boxes.outside.contains(at.point) {
            return true;
        }
        let inside = |i: usize, part: &SolidNode| self.contains(part, first + node.first_part_of_child(i), at);
        match &node.kind {
            SolidKind::Intersection(_) => node.all_other_children_near(at.point, usize::MAX, inside),
            _ => !node.all_other_children_near(at.point, usize::MAX, |i, part| !inside(i, part)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::rng::Stream;
    use crate::math::{Aabb, Transform};
    use crate::shape::Shape;
    use crate::world::Leaf;

    /// Returns a box that is turned about two axes.
    fn brick(min: [f64; 3], max: [f64; 3]) -> SolidNode {
        let shape = Shape::from(Aabb { min: DVec3::from_array(min), max: DVec3::from_array(max) });
        SolidNode::leaf(Leaf::new(shape, &Transform::rotate(DVec3::new(20.0, 0.0, 35.0)), 0), 0)
    }

    /// Returns overlapping bricks in a row along x. No two of different rows have a face in common.
    fn row(n: usize) -> SolidNode {
        let size = 0.013 * n as f64;
        let bricks = (0..n).map(|i| {
            let x = 0.3 * i as f64 - 1.4 + size;
            brick([x, -0.7 - 0.01 * x, -0.61 - size], [x + 0.37, 0.5 + 0.02 * x, 0.63 + size])
        });
        SolidNode::merge(bricks.collect(), 0)
    }

    fn nested_solids() -> [SolidNode; 4] {
        let whole = || brick([-1.03, -1.02, -1.01], [1.04, 1.05, 1.06]);
        let clipped = || {
            brick([-0.2, -2.0, -0.21], [0.22, 2.0, 0.23]).clipped(vec![brick([-0.5, -0.52, -0.53], [0.54, 0.55, 0.56])])
        };
        let empty = || SolidNode::union(vec![], 0);
        let mixed = || SolidNode::merge(vec![empty(), row(3), clipped(), empty(), row(10), empty()], 0);
        [
            SolidNode::intersection(vec![whole(), mixed()], 0),
            SolidNode::difference(vec![whole(), mixed(), row(2)], 0),
            SolidNode::merge(vec![clipped(), SolidNode::difference(vec![whole(), row(9)], 0), row(2)], 0),
            SolidNode::difference(vec![whole(), SolidNode::intersection(vec![row(11), mixed()], 0)], 0),
        ]
    }

    /// Returns the distances at which a ray enters or leaves the solid: those of hits on any shape of the solid, close to
    /// which one point of the ray is inside and another is outside.
    fn expected_distances(solid: &SolidNode, ray: &Ray, range: Range) -> Vec<f64> {
        let mut all = vec![];
        solid.visit_all_shape_hits(ray, range, &mut |hit| all.push(hit.t()));
        all.retain(|t| solid.inside(ray.at(t - 1e-7)) != solid.inside(ray.at(t + 1e-7)));
        all.sort_by(f64::total_cmp);
        all
    }

    #[test]
    fn hits_are_where_a_ray_enters_or_leaves_the_solid() {
        let (mut random, mut n_hits) = (Stream::new(&[41]), 0);
        for (number, solid) in nested_solids().into_iter().enumerate() {
            for _ in 0..2000 {
                let mut any = || DVec3::from_array([(); 3].map(|()| 4.0 * random.next_random() - 2.0));
                let (origin, target) = (any(), 0.5 * any());
                let ray = Ray::new(origin, (target - origin).normalize());
                let expected = expected_distances(&solid, &ray, Range::FORWARD);
                let mut found = Intersections::new();
                solid.hits(&ray, Range::FORWARD, &mut found);
                assert_eq!(solid.any(&ray, Range::FORWARD), !found.is_empty(), "{number}: {ray:?}");
                let mut found: Vec<f64> = found.iter().map(Intersection::t).collect();
                found.sort_by(f64::total_cmp);
                // (Rays through the edge of two bricks have hits that are too close together for the comparison.)
                if expected.windows(2).all(|pair| pair[1] - pair[0] > 1e-6) {
                    assert_eq!(found, expected, "{number}: {ray:?}");
                    assert_eq!(solid.closest(&ray, Range::FORWARD).map(|hit| hit.t()), expected.first().copied());
                    n_hits += found.len();
                }
            }
        }
        assert!(n_hits > 8000, "{n_hits}");
    }

    #[test]
    fn numbers_of_parts_skip_empty_solids() {
        for solid in nested_solids() {
            let mut next = 0;
            for (i, child) in solid.children().iter().enumerate() {
                assert_eq!(solid.first_part_of_child(i), next);
                for number in next..next + child.n_parts() {
                    assert_eq!(solid.child_with_part(number), i);
                }
                next += child.n_parts();
            }
            assert_eq!(solid.n_parts(), next);
        }
    }
}
