//! Objects of which there are many that differ in nothing but their place and what they look like: their shapes are kept once. A scene
//! of a million trees has no room for each one's leaves.

use super::geometry::Geometry;
use super::leaf::{Intersection, Intersections, Leaf, loosened};
use super::node::{SolidKind, SolidNode};
use crate::math::{Aabb, DVec3, Range, Ray, Transform};
use crate::shape::Kernel;
use serde::Serialize;
use std::ops::ControlFlow;
use std::sync::Arc;

/// One of many objects that share their shapes.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Instance {
    /// The shapes, whose numbers begin at 0, in the space of this object.
    shared: Arc<Geometry>,
    /// World from this space; `None` is the identity.
    place: Option<Arc<Transform>>,
    /// What is added to [`Leaf::id`].
    first_part: u32,
    /// What is added to [`SolidNode::object`].
    first_object: u32,
}

impl Instance {
    pub fn new(shared: Arc<Geometry>, place: Option<Arc<Transform>>, first_part: u32, first_object: u32) -> Self {
        Self { shared, place, first_part, first_object }
    }

    pub fn shared(&self) -> &Geometry {
        &self.shared
    }

    /// A number that stands for all of its objects.
    pub fn object(&self) -> u32 {
        self.first_object
    }

    /// The number of an object in it.
    pub fn object_of(&self, node: &SolidNode) -> u32 {
        self.first_object + node.object
    }

    /// The number of a shape in it.
    pub fn part_of(&self, leaf: &Leaf) -> u32 {
        self.first_part + leaf.id
    }

    /// World from this space.
    pub fn place(&self) -> Option<&Transform> {
        self.place.as_deref()
    }

    /// M⁻¹·ray.
    pub fn local(&self, ray: &Ray) -> Ray {
        self.place().map_or(*ray, |m| m.inverse_ray(ray))
    }

    /// M⁻¹·p.
    pub fn local_point(&self, p: DVec3) -> DVec3 {
        self.place().map_or(p, |m| m.inverse_point(p))
    }

    /// What was found on the shapes, as found on this object.
    pub fn own<'a>(&'a self, found: Intersection<'a>) -> Intersection<'a> {
        Intersection { object: self.first_object + found.object, copied: Some(self), ..found }
    }

    /// The nearest hit in the range.
    pub fn closest<'a>(&'a self, ray: &Ray, range: Range) -> Option<Intersection<'a>> {
        self.shared.closest(&self.local(ray), range, |_| true).map(|found| self.own(found))
    }

    /// Appends every hit in the range, in no particular order.
    pub fn hits<'a>(&'a self, ray: &Ray, range: Range, out: &mut Intersections<'a>) {
        let _ = self.shared.visit(&self.local(ray), range, |_| true, &mut |found| {
            out.push(self.own(found));
            ControlFlow::Continue(())
        });
    }

    /// The box around all its hits.
    pub fn bounds(&self) -> Aabb {
        self.shared.solids().map(|node| self.bounds_of(node)).fold(Aabb::EMPTY, Aabb::union)
    }

    /// The box around all hits of one of its solids.
    pub fn bounds_of(&self, node: &SolidNode) -> Aabb {
        let Some(m) = self.place() else { return node.bounds() };
        match node.kind() {
            SolidKind::Leaf(leaf) if node.is_whole() => loosened(leaf.shape.bounds_under(&leaf.transform().then(m))),
            _ => loosened(m.aabb(&node.bounds())),
        }
    }
}
