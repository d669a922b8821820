//! Hits of a ray on an intersection or merge of any parts.
//!
//! The parts of a composite solid are its bare shapes, also those of intersections, merges and unions within it, and
//! each clipped solid within it as a whole. They have numbers in the order in which they are written. A ray
//! is intersected with each part once; which of the hits are on the surface of the solid then follows from the
//! intervals of the ray inside the other parts.

use super::{SolidKind, SolidNode};
use crate::math::{DVec3, Range, Ray};
use crate::world::convex_interval::ConvexInterval;
use crate::world::leaf::{Intersection, Intersections};
use smallvec::SmallVec;

/// The parts of one composite solid that a ray can hit, with the hits on them.
struct PartsOnRay<'a> {
    /// Range of distances in which hits count.
    range: Range,
    /// Parts that the ray can hit.
    met: SmallVec<[MetPart<'a>; 16]>,
    /// Hits on parts that can't compute intervals.
    hits: Intersections<'a>,
    candidates: SmallVec<[Candidate; 16]>,
}

/// A part that a ray can hit.
struct MetPart<'a> {
    node: &'a SolidNode,
    number: u32,
    /// Index of the solid's child that is or contains the part.
    child: u32,
    /// Interval of the ray inside the part; `None` if the part can't compute it.
    interval: Option<ConvexInterval>,
}

/// A hit on a part, which is on the surface of the solid or not.
#[derive(Clone, Copy)]
struct Candidate {
    t: f64,
    /// Index of the part in [`PartsOnRay::met`].
    met: u32,
    /// Which end of the part's interval, or index in [`PartsOnRay::hits`] if the part has no interval.
    index: u32,
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
        parts.sort_candidates();
        let kept = parts.candidates.iter().find(|candidate| {
            let at = PointOnRay { t: candidate.t, point: ray.at(candidate.t) };
            parts.is_on_surface_of_solid(self, candidate, &at) && self.is_inside_all_clips(at.point)
        });
        kept.map(|candidate| parts.intersection(candidate, self.object))
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

    /// True if the node is one part of the composite solid around it: a shape, a clipped solid, or one with invisible parts.
    fn is_one_part(&self) -> bool {
        matches!(self.kind, SolidKind::Leaf(_)) || !self.clip().is_empty() || !self.invisible_parts().is_empty()
    }

    fn part_numbers(&self) -> Option<&PartNumbers> {
        self.composite.as_ref().map(|composite| &composite.parts)
    }

    /// Returns the number of parts in this node.
    fn n_parts(&self) -> usize {
        if self.is_one_part() { 1 } else { self.part_numbers().map_or(0, |numbers| numbers.n_parts) }
    }

    /// Returns the number of the first part of child `i`, relative to the first part of this node.
    fn first_part_of_child(&self, i: usize) -> usize {
        let first = self.part_numbers().and_then(|numbers| numbers.first.get(i));
        first.map_or(i, |&number| number as usize)
    }

    /// Returns the index of the child that contains the part with this number, relative to the first part of this node.
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
    /// Number of the first part of each child; an empty list if each child is one part, so that its index is the number.
    first: Box<[u32]>,
    n_parts: usize,
}

impl PartNumbers {
    /// Numbers the parts of the children of a composite solid.
    pub(super) fn new(children: &[SolidNode]) -> Self {
        if children.iter().all(SolidNode::is_one_part) {
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
        Self { range: Range::ALL, met: SmallVec::new(), hits: SmallVec::new(), candidates: SmallVec::new() }
    }

    /// Finds the parts of `solid` that the ray can hit, their intervals and the hits on them within the range.
    fn collect(&mut self, solid: &'a SolidNode, ray: &Ray, range: Range) {
        let only_inside = matches!(solid.kind, SolidKind::Intersection(_));
        solid.each_child_on_ray(ray, range, |i, child, range| {
            self.range = self.range.intersection(range);
            self.add_met_parts(child, (i, solid.first_part_of_child(i)), ray, only_inside);
            self.range
        });
        if self.range.is_empty() {
            return;
        }
        for i in 0..self.met.len() {
            self.add_candidates(i, ray);
        }
    }

    /// Adds the parts in `node`, the first of which has the number `first`, as parts of the solid's child `child`. If hits
    /// count only inside of the node (`only_inside`), shrinks the range to its interval.
    fn add_met_parts(&mut self, node: &'a SolidNode, (child, first): (usize, usize), ray: &Ray, only_inside: bool) {
        if !node.is_one_part() {
            if !node.crosses_all_bounds(ray) {
                return;
            }
            node.each_child_on_ray(ray, self.range, |i, part, range| {
                self.add_met_parts(part, (child, first + node.first_part_of_child(i)), ray, false);
                range
            });
            return;
        }
        let interval = match &node.kind {
            SolidKind::Leaf(leaf) if node.composite.is_none() => ConvexInterval::inside_shape_if_known(leaf, ray),
            _ => None,
        };
        if let Some(interval) = interval.as_ref().filter(|_| only_inside) {
            self.range = interval.possible_range(self.range);
        }
        self.met.push(MetPart { node, number: first as u32, child: child as u32, interval });
    }

    /// Adds the hits on part `i` of the list `met` within the range.
    fn add_candidates(&mut self, i: usize, ray: &Ray) {
        let met = i as u32;
        match &self.met[i].interval {
            Some(interval) => {
                let ends = interval.ends.map(|end| end.t);
                for (t, index) in ends.into_iter().zip(0..).filter(|(t, _)| self.range.contains(*t)) {
                    self.candidates.push(Candidate { t, met, index });
                }
            }
            None => {
                let first = self.hits.len();
                self.met[i].node.hits_as(true, ray, self.range, &mut self.hits);
                let added = self.hits[first..].iter().zip(first as u32..);
                self.candidates.extend(added.map(|(hit, index)| Candidate { t: hit.t(), met, index }));
            }
        }
    }

    /// Sorts the candidates by distance. Of candidates at the same distance, those on the last child of the solid come first
    /// (quirk: `last_part_wins`), and those on the same child stay in their order.
    fn sort_candidates(&mut self) {
        let met = &self.met;
        let child = |candidate: &Candidate| met[candidate.met as usize].child;
        self.candidates.sort_by(|a, b| a.t.total_cmp(&b.t).then_with(|| child(b).cmp(&child(a))));
    }

    /// Returns the interval of the part with this number; `None` for a part that can't compute its interval, or that the ray
    /// cannot hit.
    fn interval(&self, number: usize) -> Option<&ConvexInterval> {
        let has_number = |met: &MetPart| met.number as usize == number;
        // Mostly all parts are met in their order.
        let met = match self.met.get(number) {
            Some(met) if has_number(met) => met,
            _ => self.met.iter().find(|met| has_number(met))?,
        };
        met.interval.as_ref()
    }

    /// Returns the hit of a candidate, as a hit on the object with this number.
    fn intersection(&self, candidate: &Candidate, object: u32) -> Intersection<'a> {
        let MetPart { node, interval, .. } = &self.met[candidate.met as usize];
        match (&node.kind, interval) {
            (SolidKind::Leaf(leaf), Some(interval)) => {
                Intersection::new(interval.ends[candidate.index as usize].into(), leaf, object)
            }
            _ => Intersection { object, ..self.hits[candidate.index as usize] },
        }
    }

    /// True if a hit on a part is on the surface of the whole solid before clipping.
    fn is_on_surface_of_solid(&self, solid: &SolidNode, candidate: &Candidate, at: &PointOnRay) -> bool {
        self.is_on_surface(solid, 0, self.met[candidate.met as usize].number as usize, at)
    }

    /// True if a hit on the part with the number `part` is on the surface of `node`, whose first part has the number `first`.
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
            && (hit_child.is_one_part()
                || self.is_on_surface(hit_child, first + node.first_part_of_child(child), part, at))
    }

    /// True if a point of the ray is inside `node`, whose first part has the number `first`.
    fn contains(&self, node: &SolidNode, first: usize, at: &PointOnRay) -> bool {
        if node.is_one_part() {
            let known = self.interval(first).and_then(|interval| interval.contains(at.t));
            return known.unwrap_or_else(|| node.inside(at.point));
        }
        let Some(composite) = &node.composite else { return node.inside(at.point) };
        if !composite.boxes.solid.contains(at.point) {
            return false;
        }
        if !composite.outside.contains(at.point) {
            return true;
        }
        let inside = |i: usize, part: &SolidNode| self.contains(part, first + node.first_part_of_child(i), at);
        match &node.kind {
            SolidKind::Intersection(_) => node.all_other_children_near(at.point, usize::MAX, inside),
            _ => !node.all_other_children_near(at.point, usize::MAX, |i, part| !inside(i, part)),
        }
    }
}
