//! `bounded_by`, a hint that POV-Ray trusts: a ray that misses the bounding object hits nothing inside it (quirk:
//! `bounded_by_trusted`).

use super::{SolidKind, SolidNode};
use crate::math::bvh;
use crate::math::{Aabb, Range, Ray, Transform};
use crate::shape::{Kernel, Shape};
use crate::world::Leaf;

impl SolidNode {
    /// Restricts the node to rays that intersect each bounding object or start inside it (quirk: `bounded_by_trusted`).
    /// Bounds that contain the whole node are dropped.
    pub fn bounded(mut self, by: impl IntoIterator<Item = SolidNode>) -> Self {
        let bounds: Vec<SolidNode> = by.into_iter().filter(|bound| !bound.surrounds(&self)).collect();
        if !bounds.is_empty() {
            self.add_clips_and_bounds(vec![], bounds.into());
        }
        self
    }

    /// Replaces the node's bounding solids by one box, or removes them for `None`; a node without bounding solids stays
    /// unchanged.
    pub fn with_bounds_replaced_by_box(mut self, around: Option<Aabb>) -> Self {
        if self.take_bounding_solids().is_empty() {
            return self;
        }
        self.add_clips_and_bounds(vec![], Box::default());
        self.bounded(around.map(|b| SolidNode::leaf(Leaf::new(Shape::from(b), &Transform::IDENTITY, 0), 0)))
    }

    /// Restricts the node to rays that intersect the box that POV-Ray computes for it (quirk: `intersection_box`),
    /// which can be smaller than the node.
    pub fn visible_to_rays_through(self, pov_bounds: Aabb) -> Self {
        // Slack for the rounding margins of the parts' boxes.
        let pov_bounds = pov_bounds.grown(1e-6 * pov_bounds.max.abs().max(pov_bounds.min.abs()).max_element().max(1.0));
        if pov_bounds.is_empty() || pov_bounds.union(self.bounds()) == pov_bounds {
            return self;
        }
        self.bounded([SolidNode::leaf(Leaf::new(Shape::from(pov_bounds), &Transform::IDENTITY, 0), 0)])
    }

    /// True if the ray intersects every bound or starts inside it, so that it can hit the node.
    #[inline]
    pub(super) fn crosses_all_bounds(&self, ray: &Ray) -> bool {
        self.bounding_solids()
            .iter()
            .all(|bound| bound.inside(ray.origin) || bound.closest(ray, Range::FORWARD).is_some())
    }

    /// True only if this solid contains all hits of `other`. False is no proof of the contrary, because boxes are
    /// tested.
    fn surrounds(&self, other: &SolidNode) -> bool {
        let SolidKind::Leaf(leaf) = &self.kind else { return false };
        if !self.has_no_clips_or_bounds() || leaf.inverse || !leaf.shape.is_convex() {
            return false;
        }
        let holds = |b: Aabb| {
            b.is_empty() || (bvh::fits_single_precision(&b) && b.corners().into_iter().all(|p| leaf.inside(p)))
        };
        let parts = |parts: &[SolidNode]| parts.iter().all(|part| self.surrounds(part));
        holds(other.bounds())
            || matches!(&other.kind, SolidKind::Union(c) | SolidKind::Merge(c) if parts(c))
            || matches!(&other.kind, SolidKind::Intersection(c) if c.iter().any(|c| !c.inside_exceeds_bounds() && self.surrounds(c)))
    }
}
