//! Shapes in the world, and what `union`, `intersection`, `difference`, `merge`, `inverse` and `clipped_by` make of them.
//!
//! A hit of a solid made of others is a hit of one of them, which is kept or dropped by asking whether its point lies
//! inside the others: so open and infinite shapes take part like any other. `inverse` is never kept for a group: as in
//! POV-Ray, it goes down to the leaves by De Morgan's laws, and clipping objects stay as they are.

use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform, tolerance};
use crate::shape::{Hit, Hits, Kernel, Shape};
use serde::Serialize;
use smallvec::SmallVec;
use std::sync::Arc;

/// A shape and where it stands.
#[derive(Clone, Debug, Serialize)]
pub struct Leaf {
    /// In its own space; shared between copies.
    pub shape: Arc<Shape>,
    /// World from object; `None` is the identity.
    place: Option<Box<Transform>>,
    /// Turned inside out.
    pub inverse: bool,
    /// The caller's number for its material and source.
    pub id: u32,
}

/// A leaf, or a solid made of others.
#[derive(Clone, Debug, Serialize)]
pub struct Node {
    kind: NodeKind,
    /// Only what lies inside all of these is there.
    clip: Box<[Node]>,
    /// The caller's number for the object, for what belongs to an object as a whole, such as `no_shadow`.
    pub object: u32,
    /// All its hits are in here.
    surface: Aabb,
    /// All points inside it are in here.
    solid: Aabb,
}

/// What a node is.
#[derive(Clone, Debug, Serialize)]
pub enum NodeKind {
    /// A shape.
    Leaf(Leaf),
    /// All surfaces of all children.
    Union(Vec<Node>),
    /// What is inside all children.
    Intersection(Vec<Node>),
    /// A union without the surfaces inside it.
    Merge(Vec<Node>),
}

/// What a node falls into.
pub(super) enum Parts {
    One(Node),
    Many(Vec<Node>),
}

/// A hit and whose it is.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a> {
    /// In the leaf's object space, except for `t`.
    pub hit: Hit,
    /// The shape that was hit.
    pub leaf: &'a Leaf,
    /// [`Node::object`] of the outermost node that was asked.
    pub object: u32,
}

/// Hits of a tree.
pub type FoundList<'a> = SmallVec<[Found<'a>; 8]>;

/// The place of a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// In world space.
    pub point: DVec3,
    /// In world space, length 1, out of the solid.
    pub normal: DVec3,
    /// In object space.
    pub object_point: DVec3,
}

impl Leaf {
    /// The shape under `transform`, world from object.
    pub fn new(shape: Arc<Shape>, transform: &Transform, id: u32) -> Self {
        let place = (!transform.is_identity()).then(|| Box::new(*transform));
        Self { shape, place, inverse: false, id }
    }

    /// World from object.
    pub fn transform(&self) -> Transform {
        self.place.as_deref().copied().unwrap_or(Transform::IDENTITY)
    }

    /// M⁻¹·ray.
    fn local(&self, ray: &Ray) -> Ray {
        self.place.as_ref().map_or(*ray, |m| m.inverse_ray(ray))
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        self.shape.closest(&self.local(ray), range)
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.shape.hits(&self.local(ray), range, out);
    }

    fn inside(&self, p: DVec3) -> bool {
        let local = self.place.as_ref().map_or(p, |m| m.inverse_point(p));
        !self.shape.is_patch() && self.shape.inside(local) != self.inverse
    }

    fn surface_bounds(&self) -> Aabb {
        loosened(match &self.place {
            Some(m) => self.shape.bounds_under(m),
            None => self.shape.bounds(),
        })
    }
}

impl Found<'_> {
    /// Distance along the ray.
    pub fn t(&self) -> f64 {
        self.hit.t
    }

    /// Was the leaf turned inside out on its way?
    pub fn inverted(&self) -> bool {
        self.leaf.inverse
    }

    /// The shape's own coordinates on its surface, at `object_point` of [`Found::surface`].
    pub fn uv(&self, object_point: DVec3) -> DVec2 {
        self.leaf.shape.uv(object_point, &self.hit)
    }

    /// Point and normal of this hit of `ray`, in world space (lecture, "Ray – transformed object
    /// intersection": points by M, normals by M⁻ᵀ).
    pub fn surface(&self, ray: &Ray) -> Surface {
        let Leaf { shape, place, inverse, .. } = self.leaf;
        let object_point = self.leaf.local(ray).at(self.hit.t);
        let normal = shape.normal(object_point, &self.hit);
        let (point, normal) = match place {
            Some(m) => (m.point(object_point), m.normal(normal)),
            None => (object_point, normal),
        };
        let normal = if *inverse { -normal } else { normal };
        Surface { point, normal: normal.try_normalize().unwrap_or(-ray.dir), object_point }
    }
}

impl Node {
    /// A shape by itself.
    pub fn leaf(leaf: Leaf, object: u32) -> Self {
        Self::new(NodeKind::Leaf(leaf), object)
    }

    /// All surfaces of all children.
    pub fn union(children: Vec<Node>, object: u32) -> Self {
        Self::new(NodeKind::Union(children), object)
    }

    /// What is inside all children.
    pub fn intersection(children: Vec<Node>, object: u32) -> Self {
        Self::new(NodeKind::Intersection(children), object)
    }

    /// A union without the surfaces inside it.
    pub fn merge(children: Vec<Node>, object: u32) -> Self {
        Self::new(NodeKind::Merge(children), object)
    }

    /// The first child without the others: the intersection with their inverses.
    pub fn difference(children: Vec<Node>, object: u32) -> Self {
        let turned = children.into_iter().enumerate().map(|(i, c)| if i == 0 { c } else { c.inverted() });
        Self::intersection(turned.collect(), object)
    }

    fn new(kind: NodeKind, object: u32) -> Self {
        let mut node = Self { kind, clip: Box::default(), object, surface: Aabb::EMPTY, solid: Aabb::EMPTY };
        node.measure();
        node
    }

    /// Cut to what is inside all of `by`, and of what clipped it before.
    pub fn clipped(mut self, by: Vec<Node>) -> Self {
        self.clip = self.clip.into_iter().chain(by).collect();
        self.measure();
        self
    }

    /// Turned inside out. What clips it stays; triangles and polygons, which have no inside, stay too.
    pub fn inverted(mut self) -> Self {
        let turned = |children: Vec<Node>| children.into_iter().map(Node::inverted).collect();
        self.kind = match self.kind {
            NodeKind::Leaf(leaf) => {
                let inverse = leaf.inverse != !leaf.shape.is_patch();
                NodeKind::Leaf(Leaf { inverse, ..leaf })
            }
            NodeKind::Union(children) | NodeKind::Merge(children) => NodeKind::Intersection(turned(children)),
            NodeKind::Intersection(children) => NodeKind::Merge(turned(children)),
        };
        self.measure();
        self
    }

    /// What it is made of.
    pub fn kind(&self) -> &NodeKind {
        &self.kind
    }

    /// Its children, if it is nothing but the collection of them: a union that is not clipped. Itself otherwise.
    pub(super) fn into_parts(self) -> Parts {
        match self.kind {
            NodeKind::Union(children) if self.clip.is_empty() => Parts::Many(children),
            _ => Parts::One(self),
        }
    }

    /// Is it inside at places outside [`Node::bounds`]?
    pub(super) fn is_unbounded(&self) -> bool {
        !self.solid.is_empty() && self.solid.union(self.surface) != self.surface
    }

    /// The box around all its hits.
    pub fn bounds(&self) -> Aabb {
        self.surface
    }

    /// Is the point inside?
    pub fn inside(&self, p: DVec3) -> bool {
        let in_kind = match &self.kind {
            NodeKind::Leaf(leaf) => leaf.inside(p),
            _ if !self.solid.contains(p) => false,
            NodeKind::Union(children) | NodeKind::Merge(children) => children.iter().any(|c| c.inside(p)),
            NodeKind::Intersection(children) => children.iter().all(|c| c.inside(p)),
        };
        in_kind && self.in_clip(p)
    }

    /// Appends every hit in the range, in no particular order.
    pub fn hits<'a>(&'a self, ray: &Ray, range: Range, out: &mut FoundList<'a>) {
        let first = out.len();
        match &self.kind {
            NodeKind::Leaf(leaf) => {
                let mut hits = Hits::new();
                leaf.hits(ray, range, &mut hits);
                out.extend(hits.into_iter().map(|hit| Found { hit, leaf, object: self.object }));
            }
            NodeKind::Union(children) | NodeKind::Intersection(children) | NodeKind::Merge(children) => {
                let Some(range) = self.confine(ray, range) else { return };
                for (i, child) in children.iter().enumerate() {
                    let from = out.len();
                    child.hits(ray, range, out);
                    keep(out, from, |found| self.survives(i, ray.at(found.hit.t)));
                }
                out[first..].iter_mut().for_each(|found| found.object = self.object);
            }
        }
        if !self.clip.is_empty() {
            keep(out, first, |found| self.in_clip(ray.at(found.hit.t)));
        }
    }

    /// The nearest hit in the range.
    pub fn closest<'a>(&'a self, ray: &Ray, range: Range) -> Option<Found<'a>> {
        let clipped = !self.clip.is_empty();
        match &self.kind {
            NodeKind::Leaf(leaf) if !clipped => {
                leaf.closest(ray, range).map(|hit| Found { hit, leaf, object: self.object })
            }
            NodeKind::Leaf(_) => {
                let mut all = FoundList::new();
                self.hits(ray, range, &mut all);
                all.into_iter().min_by(|a, b| a.t().total_cmp(&b.t()))
            }
            NodeKind::Union(children) if !clipped => self.closest_of_all(children, ray, range),
            NodeKind::Union(children) | NodeKind::Intersection(children) | NodeKind::Merge(children) => {
                self.closest_survivor(children, ray, range)
            }
        }
    }

    fn closest_of_all<'a>(&'a self, children: &'a [Node], ray: &Ray, range: Range) -> Option<Found<'a>> {
        let mut range = self.confine(ray, range)?;
        let mut best = None;
        for child in children {
            if let Some(found) = child.closest(ray, range) {
                range.max = found.t();
                best = Some(Found { object: self.object, ..found });
            }
        }
        best
    }

    /// Gathers the children's hits and asks about them in order, until one is kept.
    fn closest_survivor<'a>(&'a self, children: &'a [Node], ray: &Ray, range: Range) -> Option<Found<'a>> {
        let range = self.confine(ray, range)?;
        let mut all = FoundList::new();
        let mut owners: SmallVec<[(usize, usize); 8]> = SmallVec::new();
        for (i, child) in children.iter().enumerate() {
            let from = all.len();
            child.hits(ray, range, &mut all);
            owners.extend((from..all.len()).map(|hit| (hit, i)));
        }
        owners.sort_by(|a, b| all[a.0].t().total_cmp(&all[b.0].t()));
        let kept = owners.into_iter().find(|&(hit, child)| {
            let p = ray.at(all[hit].t());
            self.survives(child, p) && self.in_clip(p)
        });
        kept.map(|(hit, _)| Found { object: self.object, ..all[hit] })
    }

    /// Is a point of the surface of one child on the surface of the whole?
    fn survives(&self, child: usize, p: DVec3) -> bool {
        let mut others = self.children().iter().enumerate().filter(|(i, _)| *i != child).map(|(_, c)| c);
        match &self.kind {
            NodeKind::Leaf(_) | NodeKind::Union(_) => true,
            NodeKind::Intersection(_) => others.all(|c| c.inside(p)),
            NodeKind::Merge(_) => !others.any(|c| c.inside(p)),
        }
    }

    fn in_clip(&self, p: DVec3) -> bool {
        self.clip.iter().all(|c| c.inside(p))
    }

    fn children(&self) -> &[Node] {
        match &self.kind {
            NodeKind::Leaf(_) => &[],
            NodeKind::Union(c) | NodeKind::Intersection(c) | NodeKind::Merge(c) => c,
        }
    }

    /// The piece of the ray in the box around the surface.
    fn confine(&self, ray: &Ray, range: Range) -> Option<Range> {
        self.surface.slabs(ray, range).map(|(min, max)| Range { min, max })
    }

    /// Computes both boxes from the parts.
    fn measure(&mut self) {
        let (surface, solid) = match &self.kind {
            NodeKind::Leaf(leaf) => {
                let surface = leaf.surface_bounds();
                let solid = match leaf.inverse {
                    _ if leaf.shape.is_patch() => Aabb::EMPTY,
                    true => Aabb::INFINITE,
                    // A disc's inside is a half-space, but POV-Ray cuts an intersection to the disc's own box.
                    false => surface,
                };
                (surface, solid)
            }
            NodeKind::Union(children) | NodeKind::Merge(children) => {
                let join = |side: fn(&Node) -> Aabb| children.iter().map(side).fold(Aabb::EMPTY, Aabb::union);
                (join(|c| c.surface), join(|c| c.solid))
            }
            NodeKind::Intersection(children) => intersection_bounds(children),
        };
        let clip = self.clip.iter().map(|c| c.solid).fold(Aabb::INFINITE, Aabb::intersection);
        self.surface = surface.intersection(clip);
        self.solid = solid.intersection(clip);
    }
}

/// A hit is on one child and inside all others: the union of each one's surface cut to all other solids.
fn intersection_bounds(children: &[Node]) -> (Aabb, Aabb) {
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

/// Drops the hits from `first` on that do not meet the condition.
fn keep<'a>(list: &mut FoundList<'a>, first: usize, condition: impl Fn(&Found<'a>) -> bool) {
    let mut end = first;
    for i in first..list.len() {
        if condition(&list[i]) {
            list.swap(end, i);
            end += 1;
        }
    }
    list.truncate(end);
}

/// The box a little larger, so that rounding never puts a hit outside.
fn loosened(b: Aabb) -> Aabb {
    if b.is_empty() {
        return Aabb::EMPTY;
    }
    let finite = |v: DVec3| v.map(|x| if x.is_finite() { x.abs() } else { 0.0 }).max_element();
    b.grown(tolerance::BOUNDS * finite(b.min).max(finite(b.max)).max(1.0))
}
