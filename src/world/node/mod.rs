//! Solids: shapes combined by `union`, `intersection`, `difference`, `merge`, `inverse` and `clipped_by`.
//!
//! A hit of a composite solid is a hit of one of its parts, which is kept or dropped by testing whether the point is
//! inside the other parts. Open and infinite shapes therefore need no special case. `inverse` is pushed down to the
//! leaves by De Morgan's laws; clipping solids stay unchanged.

mod bounded;
mod boxes;
mod clips;
mod convex_parts;
mod parts_on_ray;

use super::child_bvh::ChildBvh;
use super::leaf::{Intersection, Intersections, Leaf};
use crate::math::{Aabb, DVec3, Range, Ray};
use crate::shape::Hits;
use boxes::Boxes;
use parts_on_ray::PartNumbers;
use serde::Serialize;
use std::ops::ControlFlow;

/// A shape or a composite solid, with its object number.
#[derive(Clone, Debug, Serialize)]
pub struct SolidNode {
    kind: SolidKind,
    /// Index of the object in [`crate::world::World::objects`].
    pub object: u32,
    /// Clipping, bounds and boxes of a composite solid; `None` for a bare, unclipped shape.
    #[serde(flatten)]
    composite: Option<Box<CompositeData>>,
}

/// Clipping, bounds and boxes of a composite or clipped solid.
#[derive(Clone, Debug, Serialize)]
struct CompositeData {
    /// Clipping solids: points outside of any of them are removed.
    clip: Box<[SolidNode]>,
    /// Bounding solids, all of which a ray must intersect; see [`SolidNode::bounded`].
    #[serde(skip_serializing_if = "<[SolidNode]>::is_empty")]
    bounds: Box<[SolidNode]>,
    /// Parts of a union or merge that are invisible in this view but still belong to its inside.
    #[serde(skip_serializing_if = "<[SolidNode]>::is_empty")]
    unseen: Box<[SolidNode]>,
    #[serde(flatten)]
    boxes: Boxes,
    /// Numbers of the parts, for [`SolidNode::closest_of_parts`].
    #[serde(skip)]
    parts: PartNumbers,
    /// True for an intersection or merge of a few unclipped shapes that can compute their intervals along a ray.
    #[serde(skip)]
    convex_parts: bool,
    /// True if [`SolidNode::closest_of_packet`] computes hits.
    #[serde(skip)]
    traces_packets: bool,
    /// Boxes of children that most rays miss; see [`SolidNode::skip_boxes`].
    #[serde(skip)]
    skip_boxes: Box<[Option<Aabb>]>,
    /// Hierarchy over the children; `None` for few children.
    #[serde(skip)]
    child_bvh: Option<Box<ChildBvh>>,
}

/// Structure of a node.
#[derive(Clone, Debug, Serialize)]
pub enum SolidKind {
    /// A single shape.
    Leaf(Leaf),
    /// Union: all surfaces of all children.
    Union(Vec<SolidNode>),
    /// Intersection: the points inside all children.
    Intersection(Vec<SolidNode>),
    /// Merge: a union without its inner surfaces.
    Merge(Vec<SolidNode>),
}

/// Result of splitting a node into its children.
pub(super) enum NodeParts {
    One(SolidNode),
    Many(Vec<SolidNode>),
}

impl SolidNode {
    /// Creates the node of a bare shape.
    pub fn leaf(leaf: Leaf, object: u32) -> Self {
        Self::new(SolidKind::Leaf(leaf), object)
    }

    /// Creates a union, which keeps all surfaces of all children.
    pub fn union(children: Vec<SolidNode>, object: u32) -> Self {
        Self::new(SolidKind::Union(children), object)
    }

    /// Creates an intersection of the children.
    pub fn intersection(children: Vec<SolidNode>, object: u32) -> Self {
        // Flatten nested intersections.
        let parts = children.into_iter().flat_map(|child| match (child.has_no_clips_or_bounds(), child.kind) {
            (true, SolidKind::Intersection(parts)) => parts,
            (_, kind) => vec![Self { kind, ..child }],
        });
        let mut parts: Vec<SolidNode> = parts.collect();
        parts.shrink_to_fit();
        Self::new(SolidKind::Intersection(parts), object)
    }

    /// Creates a merge, a union without its inner surfaces.
    pub fn merge(children: Vec<SolidNode>, object: u32) -> Self {
        Self::new(SolidKind::Merge(children), object)
    }

    /// Creates a difference: the first child without the others.
    pub fn difference(children: Vec<SolidNode>, object: u32) -> Self {
        let turned = children.into_iter().enumerate().map(|(i, c)| if i == 0 { c } else { c.inverted() });
        Self::intersection(turned.collect(), object)
    }

    fn new(kind: SolidKind, object: u32) -> Self {
        let mut node = Self { kind, object, composite: None };
        node.set_solids_and_boxes(Box::default(), Box::default(), Box::default());
        node
    }

    /// Clips the solid by `by`: points outside of any of these solids are removed.
    pub fn clipped(mut self, by: Vec<SolidNode>) -> Self {
        self.add_clips_and_bounds(by, Box::default());
        self
    }

    /// Exchanges inside and outside. Clipping solids and open surfaces stay unchanged.
    pub fn inverted(mut self) -> Self {
        let turned = |children: Vec<SolidNode>| children.into_iter().map(SolidNode::inverted).collect();
        self.kind = match self.kind {
            SolidKind::Leaf(leaf) => SolidKind::Leaf(leaf.inverted()),
            SolidKind::Union(children) | SolidKind::Merge(children) => SolidKind::Intersection(turned(children)),
            SolidKind::Intersection(children) => SolidKind::Merge(turned(children)),
        };
        self.add_clips_and_bounds(vec![], Box::default());
        self
    }

    /// Returns the view of the solid without the parts of unions and merges for which `hidden` is true, by the kind of
    /// the union or merge and the object number of the part. Hidden parts remove no others from view, but still belong
    /// to the inside of the solid (quirk: `no_image_in_union`). `None` if nothing is hidden, so that the solid itself
    /// is the view.
    pub fn without_hidden_if_any(&self, hidden: &dyn Fn(&SolidKind, u32) -> bool) -> Option<Self> {
        let children = self.children();
        let seen: Vec<Option<Self>> = children.iter().map(|c| c.without_hidden_if_any(hidden)).collect();
        let joins = matches!(self.kind, SolidKind::Union(_) | SolidKind::Merge(_));
        let shows = |part: &SolidNode| !joins || !hidden(&self.kind, part.object);
        if children.iter().all(shows) && seen.iter().all(Option::is_none) {
            return None;
        }
        let parts = children.iter().zip(seen).map(|(child, seen)| seen.unwrap_or_else(|| child.clone()));
        let (shown, unseen): (Vec<SolidNode>, Vec<SolidNode>) = parts.partition(shows);
        let kind = match &self.kind {
            SolidKind::Leaf(leaf) => SolidKind::Leaf(leaf.clone()),
            SolidKind::Union(_) => SolidKind::Union(shown),
            SolidKind::Intersection(_) => SolidKind::Intersection(shown),
            SolidKind::Merge(_) => SolidKind::Merge(shown),
        };
        let mut node = Self { kind, object: self.object, composite: None };
        node.set_solids_and_boxes(self.clip().into(), self.bounding_solids().into(), unseen.into());
        Some(node)
    }

    /// Returns the structure of the node.
    pub fn kind(&self) -> &SolidKind {
        &self.kind
    }

    /// True for a union without clipping, which can be replaced by its children.
    pub(super) fn can_be_split_into_children(&self) -> bool {
        matches!(self.kind, SolidKind::Union(_)) && self.clip().is_empty()
    }

    /// Splits a union without clipping into its children; returns other nodes unchanged.
    pub(super) fn into_parts(mut self) -> NodeParts {
        match (self.clip().is_empty(), self.kind) {
            (true, SolidKind::Union(children)) => {
                let bounds = self.composite.take().map_or_else(Box::default, |composite| composite.bounds);
                // Bounds of all are bounds of each.
                let bounded = |child: SolidNode| if bounds.is_empty() { child } else { child.bounded(bounds.to_vec()) };
                NodeParts::Many(children.into_iter().map(bounded).collect())
            }
            (_, kind) => NodeParts::One(Self { kind, ..self }),
        }
    }

    /// True if the node has no clipping solids and no bounding solids.
    pub(super) fn has_no_clips_or_bounds(&self) -> bool {
        self.clip().is_empty() && self.bounding_solids().is_empty()
    }

    fn bounding_solids(&self) -> &[SolidNode] {
        self.composite.as_ref().map_or(&[], |composite| &composite.bounds)
    }

    /// Removes the bounding solids from the node, and returns them.
    fn take_bounding_solids(&mut self) -> Box<[SolidNode]> {
        self.composite.as_mut().map_or_else(Box::default, |composite| std::mem::take(&mut composite.bounds))
    }

    pub(super) fn clip(&self) -> &[SolidNode] {
        self.composite.as_ref().map_or(&[], |composite| &composite.clip)
    }

    fn invisible_parts(&self) -> &[SolidNode] {
        self.composite.as_ref().map_or(&[], |composite| &composite.unseen)
    }

    /// Removes all data of a composite solid from the node, and returns its clipping solids.
    fn drop_composite_and_take_clips(&mut self) -> Box<[SolidNode]> {
        self.composite.take().map_or_else(Box::default, |composite| composite.clip)
    }

    /// True if the point is inside the solid.
    pub fn inside(&self, p: DVec3) -> bool {
        let is_near = match &self.kind {
            SolidKind::Leaf(_) => true,
            _ => self.composite.as_ref().is_some_and(|composite| composite.boxes.solid.contains(p)),
        };
        if !is_near || !self.is_inside_all_clips(p) {
            return false;
        }
        match &self.kind {
            SolidKind::Leaf(leaf) => leaf.inside(p),
            SolidKind::Union(_) | SolidKind::Merge(_) => {
                !self.all_other_children_near(p, usize::MAX, |_, c| !c.inside(p))
                    || self.invisible_parts().iter().any(|c| c.inside(p))
            }
            SolidKind::Intersection(_) => self.all_other_children_near(p, usize::MAX, |_, c| c.inside(p)),
        }
    }

    /// Appends every hit in the range to `out`, in no particular order.
    pub fn hits<'a>(&'a self, ray: &Ray, range: Range, out: &mut Intersections<'a>) {
        self.hits_as(false, ray, range, out);
    }

    /// Appends the hits in the range to `out`: every hit, or for a part of a CSG object (`in_csg`) the hits of
    /// [`Kernel::limited_hits_for_csg`].
    pub(super) fn hits_as<'a>(&'a self, in_csg: bool, ray: &Ray, range: Range, out: &mut Intersections<'a>) {
        if !self.crosses_all_bounds(ray) {
            return;
        }
        let first = out.len();
        match &self.kind {
            SolidKind::Leaf(leaf) => {
                let mut hits = Hits::new();
                if !self.clip().is_empty() {
                    let Some(range) = self.range_in_box_and_clips(ray, range) else { return };
                    leaf.limited_hits_for_csg(ray, range, &mut hits);
                } else if in_csg {
                    leaf.limited_hits_for_csg(ray, range, &mut hits);
                } else {
                    leaf.hits(ray, range, &mut hits);
                }
                // (A loop, because the compiler makes `extend` a call here.)
                for hit in &hits {
                    out.push(Intersection::new(*hit, leaf, self.object));
                }
            }
            SolidKind::Union(_) => {
                self.each_child_on_ray(ray, range, |_, child, range| {
                    child.hits_as(in_csg, ray, range, out);
                    range
                });
                out[first..].iter_mut().for_each(|found| found.object = self.object);
            }
            _ => self.hits_of_parts(ray, range, out),
        }
        if !self.clip().is_empty() {
            retain_from(out, first, |found| self.is_inside_all_clips(ray.at(found.hit.t)));
        }
    }

    /// Calls `visit` with every hit on any shape of the solid, even if the hit is not on the solid's surface.
    pub(super) fn visit_all_shape_hits<'a>(&'a self, ray: &Ray, range: Range, visit: &mut dyn FnMut(Intersection<'a>)) {
        match &self.kind {
            SolidKind::Leaf(leaf) => {
                let mut hits = Hits::new();
                leaf.hits(ray, range, &mut hits);
                hits.into_iter().for_each(|hit| visit(Intersection::new(hit, leaf, self.object)));
            }
            _ => self.each_child_on_ray(ray, range, |_, child, range| {
                child.visit_all_shape_hits(ray, range, visit);
                range
            }),
        }
    }

    /// Returns the shape of a node that is a bare, unclipped shape; `None` for a composite solid.
    #[inline]
    pub(super) fn bare_leaf(&self) -> Option<&Leaf> {
        match &self.kind {
            SolidKind::Leaf(leaf) if self.composite.is_none() => Some(leaf),
            _ => None,
        }
    }

    /// Returns the closest hit of a ray on the solid within the range; `None` for a miss.
    #[inline]
    pub fn closest<'a>(&'a self, ray: &Ray, range: Range) -> Option<Intersection<'a>> {
        match self.bare_leaf() {
            Some(leaf) => leaf.closest(ray, range).map(|hit| Intersection::new(hit, leaf, self.object)),
            None => self.closest_of_composite(ray, range),
        }
    }

    /// True if the ray hits the solid anywhere in the range.
    #[inline]
    pub fn any(&self, ray: &Ray, range: Range) -> bool {
        match self.bare_leaf() {
            Some(leaf) => leaf.any(ray, range),
            None => self.any_of_composite(ray, range),
        }
    }

    /// True if the ray hits a composite solid anywhere in the range.
    fn any_of_composite(&self, ray: &Ray, range: Range) -> bool {
        if !self.crosses_all_bounds(ray) {
            return false;
        }
        match &self.kind {
            SolidKind::Leaf(leaf) if self.clip().is_empty() => leaf.any(ray, range),
            SolidKind::Leaf(leaf) => self.closest_of_clipped_leaf(leaf, ray, range).is_some(),
            SolidKind::Union(_) => self.any_of_union(ray, range),
            _ if self.has_convex_parts() => self.any_of_convex_parts(ray, range),
            _ => self.any_of_parts(ray, range),
        }
    }

    /// True if a hit on a part of a union is inside all clipping solids of the union.
    fn any_of_union(&self, ray: &Ray, range: Range) -> bool {
        let (mut found, mut hits) = (false, Intersections::new());
        self.each_child_on_ray(ray, range, |_, child, range| {
            found = match self.clip() {
                [] => child.any(ray, range),
                _ => self.first_unclipped_hit(child, ray, range, &mut hits).is_some(),
            };
            if found { Range::EMPTY } else { range }
        });
        found
    }

    /// Returns the closest hit of a composite solid.
    pub(super) fn closest_of_composite<'a>(&'a self, ray: &Ray, range: Range) -> Option<Intersection<'a>> {
        if !self.crosses_all_bounds(ray) {
            return None;
        }
        match &self.kind {
            SolidKind::Leaf(leaf) if self.clip().is_empty() => {
                leaf.closest(ray, range).map(|hit| Intersection::new(hit, leaf, self.object))
            }
            SolidKind::Leaf(leaf) => {
                self.closest_of_clipped_leaf(leaf, ray, range).map(|hit| Intersection::new(hit, leaf, self.object))
            }
            SolidKind::Union(_) if self.clip().is_empty() => self.closest_of_union(ray, range),
            SolidKind::Union(_) => self.closest_of_clipped_union(ray, range),
            _ if self.has_convex_parts() => self.closest_of_convex_parts(ray, range),
            _ => self.closest_of_parts(ray, range),
        }
    }

    fn closest_of_union<'a>(&'a self, ray: &Ray, range: Range) -> Option<Intersection<'a>> {
        let mut best: Option<Intersection> = None;
        self.each_child_on_ray(ray, range, |_, child, range| match child.closest(ray, range) {
            Some(found) if best.is_none_or(|best| found.wins_against(&best)) => {
                best = Some(found);
                Range { max: found.t().next_up(), ..range }
            }
            _ => range,
        });
        best.map(|found| Intersection { object: self.object, ..found })
    }

    /// Calls `visit` with each child that the ray can hit. `visit` returns the range in which further hits count; if that is
    /// empty, no further child is visited.
    fn each_child_on_ray<'a>(
        &'a self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(usize, &'a SolidNode, Range) -> Range,
    ) {
        let children = self.children();
        let Some((min, max)) = self.distances_through_box(ray, range) else { return };
        let mut range = Range { min, max };
        match self.child_bvh() {
            Some(child_bvh) => child_bvh.visit_children_on_ray(ray, range, |i, range| visit(i, &children[i], range)),
            None => {
                for (i, child) in children.iter().enumerate() {
                    range = visit(i, child, range);
                    if range.is_empty() {
                        break;
                    }
                }
            }
        }
    }

    /// True if the condition holds for all children except child `but`. Children far from the point are skipped, so the
    /// condition must be true for them.
    fn all_other_children_near(&self, p: DVec3, but: usize, condition: impl Fn(usize, &SolidNode) -> bool) -> bool {
        let children = self.children();
        let fine = |i: usize| i == but || condition(i, &children[i]);
        match self.child_bvh() {
            Some(child_bvh) => {
                let flow = child_bvh.visit_children_around(p, |i| {
                    if fine(i) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
                });
                flow.is_continue()
            }
            None => (0..children.len()).all(fine),
        }
    }

    /// Returns the distances at which a ray enters and leaves the box around all hits of a composite solid; `None` for a
    /// miss and for a bare shape.
    fn distances_through_box(&self, ray: &Ray, range: Range) -> Option<(f64, f64)> {
        let composite = self.composite.as_ref()?;
        composite.boxes.surface.slabs(ray, range)
    }

    fn child_bvh(&self) -> Option<&ChildBvh> {
        self.composite.as_ref().and_then(|composite| composite.child_bvh.as_deref())
    }

    /// True if the ray misses the box of child `i` within the range, so that the child need not be intersected. False for a
    /// child whose box is not tested.
    #[inline]
    fn is_child_skipped(&self, i: usize, ray: &Ray, range: Range) -> bool {
        let boxes = self.composite.as_ref().map_or(&[][..], |composite| &composite.skip_boxes);
        boxes.get(i).and_then(Option::as_ref).is_some_and(|around| around.slabs(ray, range).is_none())
    }

    fn children(&self) -> &[SolidNode] {
        match &self.kind {
            SolidKind::Leaf(_) => &[],
            SolidKind::Union(c) | SolidKind::Intersection(c) | SolidKind::Merge(c) => c,
        }
    }
}

/// Removes the hits of `list`, from index `first` on, that do not meet the condition.
fn retain_from<'a>(list: &mut Intersections<'a>, first: usize, condition: impl Fn(&Intersection<'a>) -> bool) {
    let mut end = first;
    for i in first..list.len() {
        if condition(&list[i]) {
            list.swap(end, i);
            end += 1;
        }
    }
    list.truncate(end);
}
