//! Everything that a ray can hit.

use super::bvh::{self, Bvh};
use super::leaf::{Found, FoundList};
use super::node::{Node, Parts};
use crate::math::{DVec3, Range, Ray};
use serde::Serialize;
use std::ops::ControlFlow;

/// All objects of the world, and the hierarchy over those of finite size.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Geometry {
    /// First the finite ones, in the hierarchy's order.
    items: Vec<Node>,
    finite: usize,
    /// Finite ones whose inside reaches beyond their box, as that of an inverted sphere.
    unbounded: Vec<u32>,
    #[serde(skip)]
    bvh: Bvh,
}

impl Geometry {
    /// Over these objects. Unions that keep all surfaces of their children are taken apart, so that each child has its
    /// own place in the hierarchy: what holds for the union as a whole must be said of each child.
    pub fn new(roots: Vec<Node>) -> Self {
        let mut parts = vec![];
        take_apart(roots, &mut parts);
        let (finite, infinite): (Vec<Node>, Vec<Node>) = parts.into_iter().partition(|n| bvh::fits(&n.bounds()));
        let boxes: Vec<_> = finite.iter().map(Node::bounds).collect();
        let (bvh, order) = Bvh::build(&boxes);
        let mut slots: Vec<Option<Node>> = finite.into_iter().map(Some).collect();
        let mut items: Vec<Node> = order.iter().filter_map(|&i| slots[i as usize].take()).collect();
        let finite = items.len();
        let unbounded = (0..finite as u32).filter(|&i| items[i as usize].is_unbounded()).collect();
        items.extend(infinite);
        Self { items, finite, unbounded, bvh }
    }

    /// All objects, in no particular order.
    pub fn items(&self) -> &[Node] {
        &self.items
    }

    /// The nearest hit in the range of an object that `accept` takes by its number.
    pub fn closest(&self, ray: &Ray, range: Range, accept: impl Fn(u32) -> bool) -> Option<Found<'_>> {
        let mut best = None;
        self.meet(ray, range, |item, range| {
            if accept(item.object)
                && let Some(found) = item.closest(ray, range)
            {
                best = Some(found);
                return ControlFlow::Continue(found.t());
            }
            ControlFlow::Continue(range.max)
        });
        best
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
        visit: &mut dyn FnMut(Found<'a>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut flow = ControlFlow::Continue(());
        let mut list = FoundList::new();
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

    /// Tells `visit` every object that the point is inside of, in no particular order.
    pub fn containing<'a>(&'a self, p: DVec3, visit: &mut dyn FnMut(&'a Node)) {
        let mut ask = |item: &'a Node| {
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

    /// Hands every object whose box the ray meets to `visit`, which returns how far hits still count.
    fn meet<'a>(&'a self, ray: &Ray, range: Range, mut visit: impl FnMut(&'a Node, Range) -> ControlFlow<(), f64>) {
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

fn take_apart(nodes: Vec<Node>, out: &mut Vec<Node>) {
    for node in nodes {
        match node.into_parts() {
            Parts::Many(children) => take_apart(children, out),
            Parts::One(node) if node.bounds().is_empty() => {}
            Parts::One(node) => out.push(node),
        }
    }
}
