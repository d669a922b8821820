//! Which of the hits on a solid's parts are hits of the solid: told along the ray, where that is safe.

use super::leaf::{Found, FoundList};
use super::node::{Node, NodeKind};
use crate::math::{Range, Ray};
use crate::shape::{Hits, Kernel};
use smallvec::SmallVec;

/// So near to where a convex part begins or ends, in units of its own space, its `inside` is asked: what lies in one surface with
/// another is settled there. Far above rounding and above what `inside` tolerates.
const SLACK: f64 = 1e-6;

/// The stretch of a ray that lies inside a convex part.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    inside: Range,
    /// The part is what lies outside of that.
    inverse: bool,
    /// In units of t.
    slack: f64,
}

impl Stretch {
    /// Is the point at `t` inside the part? `None` where that is for the part itself to say.
    fn holds(&self, t: f64) -> Option<bool> {
        let Range { min, max } = self.inside;
        let near = (t - min).abs() < self.slack || (t - max).abs() < self.slack;
        (!near).then_some((t > min && t < max) != self.inverse)
    }
}

/// What a ray finds on the children of an intersection or a merge.
pub(super) struct Gathered<'a> {
    /// Outside of it nothing counts.
    range: Range,
    /// The hits, and the number of the child that each is on.
    pub(super) hits: SmallVec<[(Found<'a>, u32); 8]>,
    /// Where the ray is inside the children, so far as that is known.
    stretches: SmallVec<[Option<Stretch>; 8]>,
}

impl<'a> Gathered<'a> {
    /// For so many children.
    pub(super) fn new(children: usize, range: Range) -> Self {
        Self { range, hits: SmallVec::new(), stretches: SmallVec::from_elem(None, children) }
    }

    /// Adds the hits of a child in the range. If only what lies `within` the child will count, then that is all of the range from
    /// now on. Returns the range.
    pub(super) fn add(&mut self, i: usize, child: &'a Node, ray: &Ray, range: Range, within: bool) -> Range {
        let number = i as u32;
        self.range = self.range.and(range);
        let leaf = match child.kind() {
            NodeKind::Leaf(leaf) if child.is_whole() && leaf.shape.is_convex() => leaf,
            _ => {
                let mut all = FoundList::new();
                child.hits(ray, self.range, &mut all);
                self.hits.extend(all.into_iter().map(|found| (found, number)));
                return self.range;
            }
        };
        let local = leaf.local(ray);
        let mut hits = Hits::new();
        leaf.shape.hits(&local, Range::ALL, &mut hits);
        for hit in hits.iter().filter(|hit| self.range.contains(hit.t)) {
            self.hits.push((Found { hit: *hit, leaf, object: child.object }, number));
        }
        let Some(inside) = leaf.shape.stretch(&local, &hits) else { return self.range };
        let stretch = Stretch { inside, inverse: leaf.inverse, slack: SLACK / local.dir.length() };
        self.stretches[i] = Some(stretch);
        if within && !leaf.inverse {
            self.range = self.range.and(Range { min: inside.min - stretch.slack, max: inside.max + stretch.slack });
        }
        self.range
    }

    /// Drops what lies outside of what is left of the range.
    pub(super) fn close(&mut self) {
        self.hits.retain(|(found, _)| self.range.contains(found.t()));
    }

    /// Is the ray at `t` inside child `i`?
    pub(super) fn inside(&self, i: usize, child: &Node, ray: &Ray, t: f64) -> bool {
        self.stretches[i].and_then(|stretch| stretch.holds(t)).unwrap_or_else(|| child.inside(ray.at(t)))
    }
}
