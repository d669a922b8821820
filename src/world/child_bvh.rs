//! Bounding volume hierarchy over the children of one CSG node that has many.

use crate::math::bvh::{self, Bvh};
use crate::math::{Aabb, DVec3, Range, Ray};
use std::ops::ControlFlow;

/// Minimum number of children for a hierarchy; below it, testing each child is faster.
const MANY: usize = 8;

/// Hierarchy that finds the children whose boxes a ray intersects or a point is in.
#[derive(Clone, Debug)]
pub struct ChildBvh {
    bvh: Bvh,
    /// Numbers of the children with finite boxes, in the order of the hierarchy.
    order: Vec<u32>,
    /// Numbers of the children with infinite boxes or with coordinates of 1e30 or more, which are always visited.
    rest: Vec<u32>,
}

impl ChildBvh {
    /// Builds a hierarchy over the children's boxes; `None` if there are too few children.
    pub fn build_if_many(boxes: &[Aabb]) -> Option<Box<ChildBvh>> {
        let (inner, rest): (Vec<u32>, Vec<u32>) =
            (0..boxes.len() as u32).partition(|&i| bvh::fits_single_precision(&boxes[i as usize]));
        if inner.len() < MANY {
            return None;
        }
        let (bvh, order) = Bvh::build(inner.iter().map(|&i| boxes[i as usize]));
        let order = order.into_iter().map(|i| inner[i as usize]).collect();
        Some(Box::new(ChildBvh { bvh, order, rest }))
    }

    /// Calls `visit` with each child whose box the ray intersects, and with those whose boxes are infinite or huge.
    /// `visit` returns the range in which further hits count; if that is empty, no further child is visited.
    pub fn visit_children_on_ray(&self, ray: &Ray, range: Range, mut visit: impl FnMut(usize, Range) -> Range) {
        let mut range = range;
        for &child in &self.rest {
            range = visit(child as usize, range);
            if range.is_empty() {
                return;
            }
        }
        self.bvh.traverse(ray, range, |i, max| {
            let further = visit(self.order[i] as usize, Range { max, ..range });
            if further.is_empty() { ControlFlow::Break(()) } else { ControlFlow::Continue(further.max) }
        });
    }

    /// Calls `visit` with each child whose box contains the point, and with those whose boxes are infinite or huge,
    /// until it returns `Break`.
    pub fn visit_children_around(&self, p: DVec3, mut visit: impl FnMut(usize) -> ControlFlow<()>) -> ControlFlow<()> {
        self.rest.iter().try_for_each(|&child| visit(child as usize))?;
        let mut flow = ControlFlow::Continue(());
        self.bvh.visit_items_near_point(p, |i| {
            flow = visit(self.order[i] as usize);
            flow
        });
        flow
    }
}
