//! Everything that a ray can hit.

use super::leaf::{Intersection, Intersections};
use super::node::{NodeParts, SolidNode};
use crate::math::bvh::{self, Bvh};
use crate::math::{DVec3, Range, Ray};
use serde::Serialize;
use std::ops::ControlFlow;

/// All objects of the world, and the hierarchy over those of finite size.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Geometry {
    /// First the finite ones, in the hierarchy's order.
    items: Vec<SolidNode>,
    finite: usize,
    /// Finite ones whose inside reaches beyond their box, as that of an inverted sphere.
    unbounded: Vec<u32>,
    #[serde(skip)]
    bvh: Bvh,
}

/// Objects before there is a hierarchy over them.
#[derive(Debug, Default)]
pub(super) struct Heap {
    finite: Vec<SolidNode>,
    infinite: Vec<SolidNode>,
}

impl Heap {
    /// Adds an object. Unions that keep all surfaces of their children are taken apart, so that each child has its own place
    /// in the hierarchy: what holds for the union as a whole must be said of each child.
    pub fn add(&mut self, object: SolidNode) {
        match object.into_parts() {
            NodeParts::Many(children) => children.into_iter().for_each(|child| self.add(child)),
            NodeParts::One(node) => match node.bounds() {
                bounds if bounds.is_empty() => {}
                bounds if bvh::fits(&bounds) => self.finite.push(node),
                _ => self.infinite.push(node),
            },
        }
    }
}

impl Extend<SolidNode> for Heap {
    fn extend<T: IntoIterator<Item = SolidNode>>(&mut self, objects: T) {
        objects.into_iter().for_each(|object| self.add(object));
    }
}

impl From<Heap> for Geometry {
    fn from(Heap { finite: mut items, infinite }: Heap) -> Self {
        let (bvh, order) = Bvh::build(items.iter().map(SolidNode::bounds));
        put_in_order(&mut items, order);
        let finite = items.len();
        let unbounded = (0..finite as u32).filter(|&i| items[i as usize].is_unbounded()).collect();
        items.extend(infinite);
        items.shrink_to_fit();
        Self { items, finite, unbounded, bvh }
    }
}

impl Geometry {
    /// Over these objects; unions among them are taken apart.
    pub fn new(roots: Vec<SolidNode>) -> Self {
        let mut heap = Heap::default();
        heap.extend(roots);
        heap.into()
    }

    /// All objects, in no particular order.
    pub fn items(&self) -> &[SolidNode] {
        &self.items
    }

    /// The nearest hit in the range of an object that `accept` takes by its number. Of several in one place that of an infinite
    /// object is seen, then that of the object that was declared first (as in POV-Ray 3.7, where its hierarchy does not decide).
    pub fn closest(&self, ray: &Ray, range: Range, accept: impl Fn(u32) -> bool) -> Option<Intersection<'_>> {
        let mut range = range;
        let mut infinite = None;
        for item in self.items[self.finite..].iter().filter(|item| accept(item.object)) {
            if let Some(found) = item.closest(ray, range) {
                range.max = found.t();
                infinite = Some(found);
            }
        }
        let mut finite: Option<Intersection> = None;
        self.bvh.traverse(ray, range, |i, max| {
            let item = &self.items[i];
            if accept(item.object)
                && let Some(found) = item.closest(ray, Range { max, ..range })
                && finite.is_none_or(|best| found.goes_before(&best))
            {
                finite = Some(found);
                return ControlFlow::Continue(found.t().next_up());
            }
            ControlFlow::Continue(max)
        });
        finite.or(infinite)
    }

    /// Is there any hit in the range of an object that `accept` takes by its number?
    pub fn any(&self, ray: &Ray, range: Range, accept: impl Fn(u32) -> bool) -> bool {
        let mut found = false;
        self.meet(ray, range, |item, range| {
            if accept(item.object) && item.closest(ray, range).is_some() {
                found = true;
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(range.max)
        });
        found
    }

    /// Hands all hits in the range of objects that `accept` takes to `visit`, in no particular order, until it breaks off.
    pub fn visit<'a>(
        &'a self,
        ray: &Ray,
        range: Range,
        accept: impl Fn(u32) -> bool,
        visit: &mut dyn FnMut(Intersection<'a>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut flow = ControlFlow::Continue(());
        let mut list = Intersections::new();
        self.meet(ray, range, |item, range| {
            if accept(item.object) {
                list.clear();
                item.hits(ray, range, &mut list);
                flow = list.iter().try_for_each(|found| visit(*found));
            }
            if flow.is_break() { ControlFlow::Break(()) } else { ControlFlow::Continue(range.max) }
        });
        flow
    }

    /// Hands every shape that the ray meets in the range to `visit` with the object that it is a part of, whether or not the object
    /// keeps its surface there.
    pub fn shapes_at<'a>(&'a self, ray: &Ray, range: Range, visit: &mut dyn FnMut(&'a SolidNode, Intersection<'a>)) {
        self.meet(ray, range, |item, range| {
            item.shapes_at(ray, range, &mut |found| visit(item, found));
            ControlFlow::Continue(range.max)
        });
    }

    /// Tells `visit` every object that the point is inside of, in no particular order.
    pub fn containing<'a>(&'a self, p: DVec3, visit: &mut dyn FnMut(&'a SolidNode)) {
        let mut ask = |item: &'a SolidNode| {
            if item.inside(p) {
                visit(item);
            }
        };
        self.items[self.finite..].iter().for_each(&mut ask);
        self.unbounded.iter().for_each(|&i| ask(&self.items[i as usize]));
        self.bvh.around(p, |i| {
            if !self.items[i].is_unbounded() {
                ask(&self.items[i]);
            }
            ControlFlow::Continue(())
        });
    }

    /// Tells `visit` the objects that a camera at the point starts in. As POV-Ray 3.7, this forgets what is turned inside out and
    /// lies far from the point: see `SolidNode::reach`.
    pub fn around_camera<'a>(&'a self, p: DVec3, visit: &mut dyn FnMut(&'a SolidNode)) {
        self.containing(p, &mut |item| {
            if !item.is_unbounded() || item.reach().contains(p) {
                visit(item);
            }
        });
    }

    /// Hands every object whose box the ray meets to `visit`, which returns how far hits still count.
    fn meet<'a>(
        &'a self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(&'a SolidNode, Range) -> ControlFlow<(), f64>,
    ) {
        let mut max = range.max;
        for item in &self.items[self.finite..] {
            match visit(item, Range { max, ..range }) {
                ControlFlow::Continue(new_max) => max = new_max,
                ControlFlow::Break(()) => return,
            }
        }
        self.bvh.traverse(ray, Range { max, ..range }, |i, max| visit(&self.items[i], Range { max, ..range }));
    }
}

/// Puts at each place the item whose number `order` has there, without room for a second row of items.
fn put_in_order(items: &mut [SolidNode], mut order: Vec<u32>) {
    for start in 0..items.len() {
        // Around the cycle that begins here; a place that is done has its own number.
        let mut place = start;
        loop {
            let from = std::mem::replace(&mut order[place], place as u32) as usize;
            if from == start {
                break;
            }
            items.swap(place, from);
            place = from;
        }
    }
}
