//! Bounding boxes of solids: around their surfaces and around their insides.

use super::parts_on_ray::PartNumbers;
use super::{CompositeData, SolidKind, SolidNode};
use crate::math::{Aabb, DVec3, bvh};
use crate::shape::Kernel;
use crate::world::child_bvh::ChildBvh;
use crate::world::halfspace::{self, HalfSpaces};
use crate::world::leaf::Leaf;
use serde::Serialize;
use smallvec::SmallVec;

/// Bounding boxes of a solid.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Boxes {
    /// Box around all hits on the solid's surface.
    pub(super) surface: Aabb,
    /// Box around all points that are inside the solid.
    pub(super) solid: Aabb,
    /// Box around all points that are outside of the solid; finite for an inverted shape.
    #[serde(skip)]
    pub(super) outside: Aabb,
}

impl SolidNode {
    /// Returns the boxes around surface and inside. Boxes of a bare shape are computed on each call, which happens only
    /// while the world is built.
    pub(super) fn boxes(&self) -> Boxes {
        match (&self.composite, &self.kind) {
            (Some(composite), _) => composite.boxes,
            (None, SolidKind::Leaf(leaf)) => {
                let (surface, solid) = leaf.surface_and_solid_bounds();
                let is_unbounded = leaf.shape.is_open() || leaf.shape.is_solid_unbounded() || !leaf.inverse;
                Boxes { surface, solid, outside: if is_unbounded { Aabb::INFINITE } else { surface } }
            }
            (None, _) => Boxes { surface: Aabb::EMPTY, solid: Aabb::EMPTY, outside: Aabb::INFINITE },
        }
    }

    /// True if inside points exist outside of the box [`SolidNode::bounds`].
    pub(in crate::world) fn inside_exceeds_bounds(&self) -> bool {
        let Boxes { surface, solid, .. } = self.boxes();
        !solid.is_empty() && solid.union(surface) != surface
    }

    /// True if a camera at the point, which is inside the node, counts as inside: it is within the bounding solids and,
    /// if the node's inside extends beyond its bounds, within POV-Ray's box (quirk: `camera_inside_box`).
    pub(in crate::world) fn contains_camera_at(&self, p: DVec3) -> bool {
        self.bounding_solids().iter().all(|bound| bound.bounds().contains(p))
            && (!self.inside_exceeds_bounds() || self.bounds_for_camera_inside().contains(p))
    }

    /// Returns the box within which a camera can be inside a node whose inside extends beyond its bounds: POV-Ray's box
    /// of its shapes, before they are inverted.
    fn bounds_for_camera_inside(&self) -> Aabb {
        match &self.kind {
            SolidKind::Leaf(leaf)
                if leaf.shape.solid_bounds().is_some() || !bvh::fits_single_precision(&self.bounds()) =>
            {
                Aabb::INFINITE
            }
            SolidKind::Leaf(leaf) => leaf.shape.pov_bounds(&leaf.transform()),
            SolidKind::Union(c) | SolidKind::Merge(c) => {
                c.iter().map(Self::bounds_for_camera_inside).fold(Aabb::EMPTY, Aabb::union)
            }
            SolidKind::Intersection(c) => {
                let upright = c.iter().filter(|c| !matches!(&c.kind, SolidKind::Leaf(leaf) if leaf.inverse));
                upright.map(Self::bounds_for_camera_inside).fold(Aabb::INFINITE, Aabb::intersection)
            }
        }
    }

    /// Returns a box around all hits of the solid.
    pub fn bounds(&self) -> Aabb {
        self.boxes().surface
    }

    /// Returns half-spaces that contain the surface of the solid; none for most solids without flat faces.
    pub(in crate::world) fn half_spaces(&self) -> HalfSpaces {
        let mut planes = HalfSpaces::new();
        let mut push =
            |leaf: &Leaf, inverse| halfspace::push_half_spaces_of(&leaf.shape, &leaf.transform(), inverse, &mut planes);
        match &self.kind {
            // A plane's surface is in the half-spaces on both of its sides.
            SolidKind::Leaf(leaf) => [false, true].into_iter().for_each(|inverse| push(leaf, inverse)),
            SolidKind::Intersection(parts) => parts.iter().for_each(|part| {
                if let SolidKind::Leaf(leaf) = &part.kind {
                    push(leaf, leaf.inverse);
                }
            }),
            SolidKind::Union(_) | SolidKind::Merge(_) => {}
        }
        planes
    }

    /// Stores the clipping, bounding and invisible solids of the node, and computes the boxes around its surface and
    /// its inside and the hierarchy over its children.
    pub(super) fn set_solids_and_boxes(
        &mut self,
        clip: Box<[SolidNode]>,
        bounds: Box<[SolidNode]>,
        unseen: Box<[SolidNode]>,
    ) {
        let inner: SmallVec<[Boxes; 8]> = self.children().iter().map(SolidNode::boxes).collect();
        let (surface, solid) = match &self.kind {
            SolidKind::Leaf(leaf) => {
                if clip.is_empty() && bounds.is_empty() {
                    self.composite = None;
                    return;
                }
                leaf.surface_and_solid_bounds()
            }
            SolidKind::Union(_) | SolidKind::Merge(_) => {
                let join = |side: fn(&Boxes) -> Aabb| inner.iter().map(side).fold(Aabb::EMPTY, Aabb::union);
                let hidden = unseen.iter().map(|c| c.boxes().solid).fold(Aabb::EMPTY, Aabb::union);
                (join(|c| c.surface), join(|c| c.solid).union(hidden))
            }
            SolidKind::Intersection(_) => intersection_surface_and_solid(&inner),
        };
        let clipped = clip.iter().map(|c| c.boxes().solid).fold(Aabb::INFINITE, Aabb::intersection);
        let (mut surface, mut solid) = (surface.intersection(clipped), solid.intersection(clipped));
        if !clip.is_empty() || matches!(self.kind, SolidKind::Intersection(_)) {
            // Clip by the half-spaces that contain the solid.
            let mut planes = HalfSpaces::new();
            for_each_enclosing_shape(&self.kind, &clip, &mut |leaf| {
                halfspace::push_half_spaces_of(&leaf.shape, &leaf.transform(), leaf.inverse, &mut planes);
            });
            if !planes.is_empty() {
                let all = halfspace::clip_box(surface.union(solid), &planes);
                (surface, solid) = (surface.intersection(all), solid.intersection(all));
            }
            for_each_enclosing_shape(&self.kind, &clip, &mut |leaf| {
                if let Some(quadratic) = leaf.quadratic() {
                    (surface, solid) =
                        (quadratic.nonpositive_bounds_within(surface), quadratic.nonpositive_bounds_within(solid));
                }
                if let Some(all) = leaf.quadric_bounds_between(&planes) {
                    (surface, solid) = (surface.intersection(all), solid.intersection(all));
                }
            });
        }
        // A child is relevant to a ray within the box of its surface, and to a point where it can be the exception.
        let reach = |boxes: &Boxes| match &self.kind {
            SolidKind::Intersection(_) => boxes.surface.union(boxes.outside),
            _ => boxes.surface.union(boxes.solid),
        };
        let is_known = |c: &SolidNode| matches!(&c.kind, SolidKind::Leaf(leaf) if c.has_no_clips_or_bounds() && leaf.shape.computes_crossings());
        let known = match &self.kind {
            SolidKind::Leaf(_) | SolidKind::Union(_) => false,
            SolidKind::Intersection(children) | SolidKind::Merge(children) => children.iter().all(is_known),
        };
        let child_bvh = ChildBvh::build_if_many(&inner.iter().map(reach).collect::<SmallVec<[Aabb; 8]>>());
        // For many children the hierarchy is faster.
        let convex_parts = known && child_bvh.is_none();
        let outside = inner.iter().map(|boxes| boxes.outside);
        let outside = match &self.kind {
            _ if !clip.is_empty() => Aabb::INFINITE,
            SolidKind::Leaf(_) => self.boxes().outside,
            SolidKind::Intersection(_) => outside.fold(Aabb::EMPTY, Aabb::union),
            SolidKind::Union(_) | SolidKind::Merge(_) => outside.fold(Aabb::INFINITE, Aabb::intersection),
        };
        let boxes = Boxes { surface, solid, outside };
        let parts = PartNumbers::new(self.children());
        let skip_boxes = if child_bvh.is_some() { Box::default() } else { self.skip_boxes(&inner, surface) };
        let crosses_packets =
            |node: &SolidNode| matches!(&node.kind, SolidKind::Leaf(leaf) if leaf.shape.crosses_packets());
        let traces_packets = match &self.kind {
            SolidKind::Leaf(_) => crosses_packets(self),
            _ => convex_parts && self.children().iter().all(crosses_packets),
        };
        let data =
            CompositeData { clip, bounds, unseen, boxes, parts, convex_parts, traces_packets, skip_boxes, child_bvh };
        self.composite = Some(Box::new(data));
    }

    /// Returns boxes around the children that rays are tested against before they are intersected with the child. `None`
    /// takes the place of a child that is not tested: of any but a shape that matters only to rays through its box, and of
    /// a shape whose box is nearly as large as that of the whole, `whole`. Empty if no child is tested.
    fn skip_boxes(&self, inner: &[Boxes], whole: Aabb) -> Box<[Option<Aabb>]> {
        let around = |(child, boxes): (&SolidNode, &Boxes)| {
            let leaf = child.bare_leaf()?;
            // Outside of this box the shape contains all points of a ray or none, and that has no effect on the whole.
            let reach = match &self.kind {
                SolidKind::Intersection(_) if leaf.inverse => boxes.surface.union(boxes.outside),
                SolidKind::Union(_) | SolidKind::Merge(_) if !leaf.inverse => boxes.surface.union(boxes.solid),
                _ => return None,
            };
            let is_small = reach.intersection(whole).half_area() < MOST_OF_WHOLE * whole.half_area();
            (bvh::fits_single_precision(&reach) && is_small).then_some(reach)
        };
        let boxes: Box<[_]> = self.children().iter().zip(inner).map(around).collect();
        if boxes.iter().any(Option::is_some) { boxes } else { Box::default() }
    }

    /// Adds clipping and bounding solids to the node, and recomputes the boxes around its surface and its inside.
    /// Invisible parts are dropped.
    pub(super) fn add_clips_and_bounds(&mut self, clips: Vec<SolidNode>, bounds: Box<[SolidNode]>) {
        let bounds = self.take_bounding_solids().into_iter().chain(bounds).collect();
        let clip = self.drop_composite_and_take_clips().into_iter().chain(clips).collect();
        self.set_solids_and_boxes(clip, bounds, Box::default());
    }
}

/// Share of the area of a solid's box from which on the box of a child is not tested: most rays would intersect it.
const MOST_OF_WHOLE: f64 = 0.6;

/// Calls `visit` with shapes each of which contains all hits and inside points of a solid: for a union or merge, only
/// those of its clips.
fn for_each_enclosing_shape(kind: &SolidKind, clip: &[SolidNode], visit: &mut dyn FnMut(&Leaf)) {
    clip.iter().for_each(|c| for_each_enclosing_shape(&c.kind, c.clip(), visit));
    match kind {
        SolidKind::Leaf(leaf) => visit(leaf),
        SolidKind::Intersection(children) => {
            children.iter().for_each(|c| for_each_enclosing_shape(&c.kind, c.clip(), visit))
        }
        SolidKind::Union(_) | SolidKind::Merge(_) => {}
    }
}

/// Returns the boxes around surface and inside of an intersection. A hit is on one child and inside all others, so the
/// surface is in the union of each child's surface box cut by all other solid boxes.
fn intersection_surface_and_solid(children: &[Boxes]) -> (Aabb, Aabb) {
    let mut after = vec![Aabb::INFINITE; children.len() + 1];
    for (i, child) in children.iter().enumerate().rev() {
        after[i] = after[i + 1].intersection(child.solid);
    }
    let mut surface = Aabb::EMPTY;
    let mut before = Aabb::INFINITE;
    for (i, child) in children.iter().enumerate() {
        let piece = child.surface.intersection(before).intersection(after[i + 1]);
        if !piece.is_empty() {
            surface = surface.union(piece);
        }
        before = before.intersection(child.solid);
    }
    (surface, before)
}
