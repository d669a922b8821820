//! Instances: objects that differ only in transform and appearance share their shapes, so that a scene of a million
//! trees stores the leaves of one tree.

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
    /// Shared shapes in instance space, numbered from 0.
    shared: Arc<Geometry>,
    /// Transform from instance to world space; `None` for the identity.
    place: Option<Arc<Transform>>,
    /// Number that is added to [`Leaf::id`] of the shared shapes.
    first_part: u32,
    /// Number that is added to [`SolidNode::object`] of the shared solids.
    first_object: u32,
}

impl Instance {
    pub fn new(shared: Arc<Geometry>, place: Option<Arc<Transform>>, first_part: u32, first_object: u32) -> Self {
        Self { shared, place, first_part, first_object }
    }

    pub fn shared(&self) -> &Geometry {
        &self.shared
    }

    /// Returns the number of the instance's first object.
    pub fn object_number(&self) -> u32 {
        self.first_object
    }

    /// Returns the object number of one of the shared solids in this instance.
    pub fn object_number_of(&self, node: &SolidNode) -> u32 {
        self.first_object + node.object
    }

    /// Returns the part number of one of the shared shapes in this instance.
    pub fn part_number_of(&self, leaf: &Leaf) -> u32 {
        self.first_part + leaf.id
    }

    /// Returns the transform from instance to world space; `None` for the identity.
    pub fn world_from_instance(&self) -> Option<&Transform> {
        self.place.as_deref()
    }

    /// Transforms a ray from world to instance space, M⁻¹·ray.
    pub fn local(&self, ray: &Ray) -> Ray {
        self.world_from_instance().map_or(*ray, |m| m.inverse_transform_ray(ray))
    }

    /// Transforms a point from world to instance space, M⁻¹·p.
    pub fn local_point(&self, p: DVec3) -> DVec3 {
        self.world_from_instance().map_or(p, |m| m.inverse_transform_point(p))
    }

    /// Converts a hit on the shared shapes to a hit on this instance.
    pub fn hit_on_instance<'a>(&'a self, found: Intersection<'a>) -> Intersection<'a> {
        Intersection { object: self.first_object + found.object, instance: Some(self), ..found }
    }

    /// Returns the closest hit of a ray in world space on the instance, within the range.
    pub fn closest<'a>(&'a self, ray: &Ray, range: Range) -> Option<Intersection<'a>> {
        self.shared.closest(&self.local(ray), range, |_| true).map(|found| self.hit_on_instance(found))
    }

    /// Appends every hit of a ray in world space on the instance, within the range, in no particular order.
    pub fn hits<'a>(&'a self, ray: &Ray, range: Range, out: &mut Intersections<'a>) {
        let _ = self.shared.visit_hits(&self.local(ray), range, |_| true, &mut |found| {
            out.push(self.hit_on_instance(found));
            ControlFlow::Continue(())
        });
    }

    /// Returns a box around all hits on the instance, in world space.
    pub fn bounds(&self) -> Aabb {
        self.shared.non_instanced_solids().map(|node| self.bounds_of(node)).fold(Aabb::EMPTY, Aabb::union)
    }

    /// Returns a box around all hits of one of the shared solids, in world space.
    pub fn bounds_of(&self, node: &SolidNode) -> Aabb {
        let Some(m) = self.world_from_instance() else { return node.bounds() };
        match node.kind() {
            SolidKind::Leaf(leaf) if node.has_no_clips_or_bounds() => {
                loosened(leaf.shape.bounds_under(&leaf.transform().then(m)))
            }
            _ => loosened(m.transform_aabb(&node.bounds())),
        }
    }
}
