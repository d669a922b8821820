//! A hierarchy over the children of one node, for a solid that is made of many.

use crate::math::bvh::{self, Bvh};
use crate::math::{Aabb, DVec3, Range, Ray};
use std::ops::ControlFlow;

/// With fewer children, asking each one is faster.
const MANY: usize = 8;

/// Which children a ray or a point has to do with.
#[derive(Clone, Debug)]
pub struct ChildBvh {
    bvh: Bvh,
    /// The numbers of the children in the hierarchy, in its order.
    order: Vec<u32>,
    /// The others, which always have to be asked.
    rest: Vec<u32>,
}

impl ChildBvh {
    /// Over the children's boxes; `None` if there are too few to be worth it.
    pub fn over(boxes: &[Aabb]) -> Option<Box<ChildBvh>> {
        let (inner, rest): (Vec<u32>, Vec<u32>) = (0..boxes.len() as u32).partition(|&i| bvh::fits(&boxes[i as usize]));
        if inner.len() < MANY {
            return None;
        }
        let (bvh, order) = Bvh::build(inner.iter().map(|&i| boxes[i as usize]));
        let order = order.into_iter().map(|i| inner[i as usize]).collect();
        Some(Box::new(ChildBvh { bvh, order, rest }))
    }

    /// Hands the children that the ray may meet to `visit`, which returns where hits count from now on.
    pub fn along(&self, ray: &Ray, range: Range, mut visit: impl FnMut(usize, Range) -> Range) {
        let mut range = range;
        for &child in &self.rest {
            range = visit(child as usize, range);
        }
        self.bvh.traverse(ray, range, |i, max| {
            ControlFlow::Continue(visit(self.order[i] as usize, Range { max, ..range }).max)
        });
    }

    /// Hands the children whose boxes may hold the point to `visit`, until it breaks off.
    pub fn around(&self, p: DVec3, mut visit: impl FnMut(usize) -> ControlFlow<()>) -> ControlFlow<()> {
        self.rest.iter().try_for_each(|&child| visit(child as usize))?;
        let mut flow = ControlFlow::Continue(());
        self.bvh.around(p, |i| {
            flow = visit(self.order[i] as usize);
            flow
        });
        flow
    }
}
