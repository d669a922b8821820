//! All objects that rays can hit, with a bounding volume hierarchy.

mod coherence;
mod packet;
mod shadow;

pub use coherence::Coherence;
pub use packet::{ClosestHits, PacketOcclusion, PacketSurfaces, surfaces_of_packet};
pub use shadow::{LightFilters, ShadowRole};

use super::halfspace::HalfSpaces;
use super::instance::Instance;
use super::leaf::{Intersection, Intersections, Leaf};
use super::node::{NodeParts, SolidKind, SolidNode};
use crate::math::bvh::{self, Bvh, Shaft};
use crate::math::{Aabb, DVec3, Range, Ray};
use crate::value::Family;
use serde::Serialize;
use std::ops::ControlFlow;

/// All objects that rays can hit, and a bounding volume hierarchy over the finite ones.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Geometry {
    /// All objects: first the finite ones, in the order of the hierarchy.
    items: Vec<Item>,
    finite: usize,
    /// Numbers of finite items whose inside extends beyond their box, such as an inverted sphere.
    unbounded: Vec<u32>,
    #[serde(skip)]
    bvh: Bvh,
}

/// Object or instance in the geometry's list.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
enum Item {
    Solid(SolidNode),
    /// Instance of solids that many objects share. All of its solids are visible to the same kinds of rays.
    Instance(Instance),
}

/// Memory for the search of a closest hit.
#[derive(Debug, Default)]
pub struct HitBuffer<'a> {
    /// The closest hit on infinite objects, and the two last hits on finite ones.
    hits: [Option<Intersection<'a>>; 3],
}

/// Index of the object that occluded a shadow ray.
#[derive(Clone, Copy, Debug)]
pub struct Blocker(usize);

/// An object that a shaft may hit.
#[derive(Clone, Copy, Debug)]
pub struct ShaftOccluder {
    index: usize,
    /// Box of the object, which every shaft from a point in the box may hit; `None` for an object with flat faces, whose
    /// box such a shaft can leave without a hit.
    bounds: Option<Aabb>,
}

impl ShaftOccluder {
    /// True if every shaft from the point may hit the object.
    #[inline]
    pub fn surrounds(&self, p: DVec3) -> bool {
        self.bounds.is_some_and(|bounds| bounds.contains(p))
    }
}

/// A solid with the instance that it belongs to.
#[derive(Clone, Copy, Debug)]
pub struct PlacedSolid<'a> {
    /// The solid, in the space of the instance `instance` if there is one.
    node: &'a SolidNode,
    instance: Option<&'a Instance>,
}

/// Collects objects before the hierarchy is built.
#[derive(Debug, Default)]
pub(super) struct GeometryBuilder {
    finite: Vec<Item>,
    infinite: Vec<SolidNode>,
}

impl GeometryBuilder {
    /// Creates an empty builder with room for `count` objects.
    pub fn with_capacity(count: usize) -> Self {
        Self { finite: Vec::with_capacity(count), infinite: vec![] }
    }

    /// Adds an object, unless it has neither a surface nor an inside. A union without clipping is split, so that each
    /// child has its own place in the hierarchy. Properties of the union must therefore also be stored with each child.
    pub fn add(&mut self, object: SolidNode) {
        match object.into_parts() {
            NodeParts::Many(children) => children.into_iter().for_each(|child| self.add(child)),
            NodeParts::One(node) => match node.bounds() {
                bounds if bounds.is_empty() && !node.inside_exceeds_bounds() => {}
                bounds if bounds.is_empty() => self.infinite.push(node),
                bounds if bvh::fits_single_precision(&bounds) => self.finite.push(Item::Solid(node)),
                _ => self.infinite.push(node),
            },
        }
    }

    /// Adds an instance, whose box must satisfy [`bvh::fits_single_precision`].
    pub fn add_instance(&mut self, instance: Instance) {
        self.finite.push(Item::Instance(instance));
    }
}

impl Extend<SolidNode> for GeometryBuilder {
    fn extend<T: IntoIterator<Item = SolidNode>>(&mut self, objects: T) {
        objects.into_iter().for_each(|object| self.add(object));
    }
}

impl From<GeometryBuilder> for Geometry {
    fn from(GeometryBuilder { finite: mut items, infinite }: GeometryBuilder) -> Self {
        let (bvh, order) = Bvh::build(items.iter().map(Item::bounds));
        permute_by_source_indices(&mut items, order);
        let finite = items.len();
        let unbounded = (0..finite as u32).filter(|&i| items[i as usize].inside_exceeds_bounds()).collect();
        items.extend(infinite.into_iter().map(Item::Solid));
        items.shrink_to_fit();
        Self { items, finite, unbounded, bvh }
    }
}

impl Geometry {
    /// Builds the hierarchy over the solids; unions are split.
    pub fn new(roots: Vec<SolidNode>) -> Self {
        let mut builder = GeometryBuilder::default();
        builder.extend(roots);
        builder.into()
    }

    /// True if the geometry has no object.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Returns all objects, in no particular order.
    pub fn items(&self) -> impl Iterator<Item = PlacedSolid<'_>> {
        self.items.iter().flat_map(|item| {
            let (solid, instance) = match item {
                Item::Solid(node) => (Some(PlacedSolid { node, instance: None }), None),
                Item::Instance(instance) => (None, Some(instance)),
            };
            // (The shared geometry of an instance contains no instances.)
            let shared = instance.into_iter().flat_map(|instance| {
                instance.shared().non_instanced_solids().map(|node| PlacedSolid { node, instance: Some(instance) })
            });
            solid.into_iter().chain(shared)
        })
    }

    /// Returns the objects that are not instances; those in instances are left out.
    pub(super) fn non_instanced_solids(&self) -> impl Iterator<Item = &SolidNode> {
        self.items.iter().filter_map(|item| match item {
            Item::Solid(node) => Some(node),
            Item::Instance(_) => None,
        })
    }

    /// True if all surfaces and insides are in boxes that satisfy [`bvh::fits_single_precision`].
    pub(super) fn is_finite(&self) -> bool {
        self.finite == self.items.len() && self.unbounded.is_empty()
    }

    /// Returns the closest hit in the range on the objects for which `accepts_object` returns true. Of several hits at
    /// one point, an infinite object wins, then the object that was declared first (quirk: `first_object_wins`).
    pub fn closest(&self, ray: &Ray, range: Range, accepts_object: impl Fn(u32) -> bool) -> Option<Intersection<'_>> {
        self.closest_in(&mut HitBuffer::default(), ray, range, accepts_object).copied()
    }

    /// Returns the same as [`Self::closest`], but the hit stays in the buffer. (The copy of a hit can begin only when all of its
    /// numbers are stored, and would delay every ray.)
    #[inline]
    pub fn closest_in<'a, 'b>(
        &'a self,
        buffer: &'b mut HitBuffer<'a>,
        ray: &Ray,
        mut range: Range,
        accepts_object: impl Fn(u32) -> bool,
    ) -> Option<&'b Intersection<'a>> {
        let [infinite, finite @ ..] = &mut buffer.hits;
        for item in self.items[self.finite..].iter().filter(|item| accepts_object(item.object())) {
            if item.find_closest(ray, range, infinite)
                && let Some(found) = infinite
            {
                range.max = found.t();
            }
        }
        // The closest hit on finite objects is in one place, and the next one is found in the other.
        let (mut best, mut is_found) = (0, false);
        self.bvh.traverse(ray, range, |i, max| {
            let item = &self.items[i];
            if accepts_object(item.object())
                && item.find_closest(ray, Range { max, ..range }, &mut finite[1 - best])
                && let Some(found) = &finite[1 - best]
                && finite[best].as_ref().is_none_or(|before| found.wins_against(before))
            {
                (best, is_found) = (1 - best, true);
                return ControlFlow::Continue(found.t().next_up());
            }
            ControlFlow::Continue(max)
        });
        if is_found { finite[best].as_ref() } else { infinite.as_ref() }
    }

    /// True if the ray hits any object in the range for which `accepts_object` returns true.
    pub fn any(&self, ray: &Ray, range: Range, accepts_object: impl Fn(u32) -> bool) -> bool {
        let mut is_hit = false;
        self.visit_intersected_boxes(ray, range, |i, range| {
            let item = &self.items[i];
            is_hit = accepts_object(item.object()) && item.any(ray, range);
            if is_hit { ControlFlow::Break(()) } else { ControlFlow::Continue(range.max) }
        });
        is_hit
    }

    /// Returns true only if no ray of the shaft hits an accepted object at the distance `min` or farther away. Returns
    /// false in other cases and for many shafts without hits, because only boxes and flat faces of objects are tested.
    /// Tests the object `last_occluder` first, which was in an earlier shaft from nearby, and stores the new one there.
    pub fn is_shaft_clear(
        &self,
        shaft: &Shaft,
        min: f64,
        accepts_object: impl Fn(u32) -> bool,
        last_occluder: &mut Option<ShaftOccluder>,
    ) -> bool {
        let before = last_occluder.map(|occluder| occluder.index);
        let mut is_missed = |index: usize| {
            let item = &self.items[index];
            if !accepts_object(item.object()) {
                return true;
            }
            let (bounds, planes) = (item.bounds(), item.half_spaces());
            if !shaft.may_intersect(&bounds) || planes.iter().any(|plane| plane.shaft_exits_before(shaft, min)) {
                return true;
            }
            *last_occluder = Some(ShaftOccluder { index, bounds: planes.is_empty().then_some(bounds) });
            false
        };
        let unbounded = self.finite..self.items.len();
        let mut is_clear = before.into_iter().chain(unbounded).all(&mut is_missed);
        if is_clear {
            self.bvh.visit_items_near_shaft(shaft, |i| {
                is_clear = is_missed(i);
                if is_clear { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            });
        }
        is_clear
    }

    /// Calls `visit` with each hit in the range on accepted objects, in no particular order, until it returns `Break`.
    pub fn visit_hits<'a>(
        &'a self,
        ray: &Ray,
        range: Range,
        accepts_object: impl Fn(u32) -> bool,
        visit: &mut dyn FnMut(Intersection<'a>) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut flow = ControlFlow::Continue(());
        let mut list = Intersections::new();
        self.visit_intersected_boxes(ray, range, |i, range| {
            let item = &self.items[i];
            if accepts_object(item.object()) {
                list.clear();
                item.hits(ray, range, &mut list);
                flow = list.iter().try_for_each(|found| visit(*found));
            }
            if flow.is_break() { ControlFlow::Break(()) } else { ControlFlow::Continue(range.max) }
        });
        flow
    }

    /// Calls `visit` with each hit in the range on any shape, and with the object that contains the shape, even if the
    /// hit is not on the object's surface.
    pub fn visit_all_shape_hits<'a>(
        &'a self,
        ray: &Ray,
        range: Range,
        visit: &mut dyn FnMut(PlacedSolid<'a>, Intersection<'a>),
    ) {
        self.visit_intersected_boxes(ray, range, |i, range| {
            match &self.items[i] {
                Item::Solid(node) => {
                    node.visit_all_shape_hits(ray, range, &mut |found| {
                        visit(PlacedSolid { node, instance: None }, found)
                    });
                }
                Item::Instance(instance) => {
                    instance.shared().visit_all_shape_hits(&instance.local(ray), range, &mut |part, found| {
                        visit(PlacedSolid { instance: Some(instance), ..part }, instance.hit_on_instance(found));
                    })
                }
            }
            ControlFlow::Continue(range.max)
        });
    }

    /// Calls `visit` with each object that contains the point, in no particular order.
    pub fn visit_containing<'a>(&'a self, p: DVec3, visit: &mut dyn FnMut(PlacedSolid<'a>)) {
        let mut ask = |item: &'a Item| match item {
            Item::Solid(node) if node.inside(p) => visit(PlacedSolid { node, instance: None }),
            Item::Solid(_) => {}
            Item::Instance(instance) => instance.shared().visit_containing(instance.local_point(p), &mut |part| {
                visit(PlacedSolid { instance: Some(instance), ..part });
            }),
        };
        self.items[self.finite..].iter().for_each(&mut ask);
        self.unbounded.iter().for_each(|&i| ask(&self.items[i as usize]));
        self.bvh.visit_items_near_point(p, |i| {
            if self.unbounded.binary_search(&(i as u32)).is_err() {
                ask(&self.items[i]);
            }
            ControlFlow::Continue(())
        });
    }

    /// Calls `visit` with each object that contains a camera at the point (quirk: `camera_inside_box`).
    pub fn visit_containing_camera<'a>(&'a self, p: DVec3, visit: &mut dyn FnMut(PlacedSolid<'a>)) {
        self.visit_containing(p, &mut |solid| {
            if solid.instance.is_some() || solid.node.contains_camera_at(p) {
                visit(solid);
            }
        });
    }

    /// Calls `visit` with the index of each object whose box the ray intersects, and of each infinite object. `visit`
    /// returns the distance up to which further hits count.
    #[inline]
    fn visit_intersected_boxes(
        &self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(usize, Range) -> ControlFlow<(), f64>,
    ) {
        let mut max = range.max;
        for i in self.finite..self.items.len() {
            match visit(i, Range { max, ..range }) {
                ControlFlow::Continue(new_max) => max = new_max,
                ControlFlow::Break(()) => return,
            }
        }
        self.bvh.traverse(ray, Range { max, ..range }, |i, max| visit(i, Range { max, ..range }));
    }
}

impl Item {
    /// Returns the number of the object, or of the first object of an instance.
    fn object(&self) -> u32 {
        match self {
            Self::Solid(node) => node.object,
            Self::Instance(instance) => instance.object_number(),
        }
    }

    fn bounds(&self) -> Aabb {
        match self {
            Self::Solid(node) => node.bounds(),
            Self::Instance(instance) => instance.bounds(),
        }
    }

    fn inside_exceeds_bounds(&self) -> bool {
        matches!(self, Self::Solid(node) if node.inside_exceeds_bounds())
    }

    /// Returns half-spaces that contain the surface of the object; none for an instance and for most objects without flat
    /// faces.
    fn half_spaces(&self) -> HalfSpaces {
        match self {
            Self::Solid(node) => node.half_spaces(),
            Self::Instance(_) => HalfSpaces::new(),
        }
    }

    /// Stores the closest hit of a ray on the object within the range in `out`, and returns true; false without a hit.
    #[inline]
    fn find_closest<'a>(&'a self, ray: &Ray, range: Range, out: &mut Option<Intersection<'a>>) -> bool {
        let found = match self {
            Self::Solid(node) => match node.bare_leaf() {
                Some(leaf) => return leaf.find_closest(ray, range, node.object, out),
                None => node.closest_of_composite(ray, range),
            },
            Self::Instance(instance) => instance.closest(ray, range),
        };
        let is_hit = found.is_some();
        if is_hit {
            *out = found;
        }
        is_hit
    }

    fn any(&self, ray: &Ray, range: Range) -> bool {
        match self {
            Self::Solid(node) => node.any(ray, range),
            Self::Instance(instance) => instance.shared().any(&instance.local(ray), range, |_| true),
        }
    }

    fn hits<'a>(&'a self, ray: &Ray, range: Range, out: &mut Intersections<'a>) {
        match self {
            Self::Solid(node) => node.hits(ray, range, out),
            Self::Instance(instance) => instance.hits(ray, range, out),
        }
    }
}

impl<'a> PlacedSolid<'a> {
    /// Returns the object's index in [`super::World::objects`].
    pub fn object(&self) -> u32 {
        self.instance.map_or(self.node.object, |instance| instance.object_number_of(self.node))
    }

    /// Returns the solid, in world space or, for an instance, in the instance's space.
    pub fn node(&self) -> &'a SolidNode {
        self.node
    }

    /// Returns a box around all hits on the solid, in world space.
    pub fn bounds(&self) -> Aabb {
        self.instance.map_or_else(|| self.node.bounds(), |instance| instance.bounds_of(self.node))
    }

    /// True if the point is inside the solid.
    pub fn inside(&self, p: DVec3) -> bool {
        self.node.inside(self.instance.map_or(p, |instance| instance.local_point(p)))
    }

    /// Returns the name of the solid's first shape, and the shape's index in [`super::World::parts`]; `None` for a
    /// solid without a shape.
    pub fn first_shape_name_and_part(&self) -> Option<(&'static str, u32)> {
        let leaf = first_leaf(self.node)?;
        Some((leaf.shape.spec().name, self.instance.map_or(leaf.id, |instance| instance.part_number_of(leaf))))
    }
}

fn first_leaf(node: &SolidNode) -> Option<&Leaf> {
    match node.kind() {
        SolidKind::Leaf(leaf) => Some(leaf),
        SolidKind::Union(parts) | SolidKind::Intersection(parts) | SolidKind::Merge(parts) => {
            parts.iter().find_map(first_leaf)
        }
    }
}

/// Permutes the items in place: position `i` receives item `source_indices[i]`.
fn permute_by_source_indices<T>(items: &mut [T], mut source_indices: Vec<u32>) {
    for start in 0..items.len() {
        // Follow the cycle of the permutation that starts here; finished positions hold their own number.
        let mut place = start;
        loop {
            let from = std::mem::replace(&mut source_indices[place], place as u32) as usize;
            if from == start {
                break;
            }
            items.swap(place, from);
            place = from;
        }
    }
}
