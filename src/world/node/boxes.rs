//! Where solids are: the boxes around their surfaces and insides, and where POV-Ray looks for what a camera starts in.

use super::{More, SolidKind, SolidNode};
use crate::math::bvh;
use crate::math::{Aabb, Range, Ray};
use crate::shape::Kernel;
use crate::world::child_bvh::ChildBvh;
use crate::world::halfspace::{self, HalfSpaces};
use crate::world::leaf::Leaf;
use serde::Serialize;
use smallvec::SmallVec;

/// Where a solid is.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Boxes {
    /// All its hits are in here.
    pub(super) surface: Aabb,
    /// All points inside it are in here.
    pub(super) solid: Aabb,
}

/// Where POV-Ray 3.7 asks whether something is inside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    around: Aabb,
    /// Is the whole turned inside out?
    inverted: bool,
    /// Rays that miss it see nothing of the whole, although there is something: of an intersection whose parts have parts that are
    /// turned inside out, which POV-Ray 3.7 takes for none (as was measured).
    cuts: bool,
}

impl Reach {
    /// Does a ray see anything of the whole?
    pub(super) fn is_met(&self, ray: &Ray) -> bool {
        !self.cuts || self.around.slabs(ray, Range::FORWARD).is_some()
    }
}

impl SolidNode {
    /// A shape's are computed: it is asked for them but a few times, when the world is built.
    pub(super) fn boxes(&self) -> Boxes {
        match (&self.more, &self.kind) {
            (Some(more), _) => more.boxes,
            (None, SolidKind::Leaf(leaf)) => {
                let (surface, solid) = leaf.bounds();
                Boxes { surface, solid }
            }
            (None, _) => Boxes { surface: Aabb::EMPTY, solid: Aabb::EMPTY },
        }
    }

    /// Is it inside at places outside [`SolidNode::bounds`]?
    pub(in crate::world) fn is_unbounded(&self) -> bool {
        let Boxes { surface, solid } = self.boxes();
        !solid.is_empty() && solid.union(surface) != surface
    }

    /// The box in which POV-Ray 3.7 asks whether something is inside (as was measured): around the surface of a shape, even of one
    /// that is turned inside out; of an intersection, what the boxes share of those parts that are not; of what is turned inside
    /// out as a whole, the box from before that.
    pub(in crate::world) fn reach(&self) -> Aabb {
        self.more.as_ref().map_or_else(|| self.reach_of_parts(self.bounds()).around, |more| more.reach.around)
    }

    /// Does POV-Ray's box show: is it inside at places outside of its bounds, or do rays pass it by?
    pub(in crate::world) fn shows_reach(&self) -> bool {
        let passed_by = match &self.kind {
            SolidKind::Intersection(_) => self.reach().union(self.bounds()) != self.reach(),
            _ => false,
        };
        passed_by || self.is_unbounded()
    }

    /// Do rays pass it by that miss POV-Ray's box?
    pub(in crate::world) fn is_cut_by_reach(&self) -> bool {
        self.more.as_ref().is_some_and(|more| more.reach.cuts)
    }

    /// The same with the box that POV-Ray tells of it.
    pub(in crate::world) fn reaching(mut self, around: Aabb) -> Self {
        if let Some(more) = &mut self.more {
            let of_all = matches!(self.kind, SolidKind::Intersection(_));
            more.reach = Reach { around, cuts: of_all && around.union(more.boxes.surface) != around, ..more.reach };
        }
        self
    }

    /// The same of what is clipped: the box that POV-Ray tells of it is not cut as closely as that of its hits.
    pub(in crate::world) fn standing_in(mut self, around: Aabb) -> Self {
        if let Some(more) = &mut self.more {
            more.reach.around = around;
        }
        self
    }

    /// The same of an object by itself: POV-Ray's box is the one that it tells of it.
    pub(in crate::world) fn lying_within(mut self, around: Aabb) -> Self {
        let (boxes, own) = (self.boxes(), self.reach_of_parts(self.bounds()));
        self.more.get_or_insert_with(|| Box::new(More::plain(boxes, own))).reach.around = around;
        self
    }

    /// That of its parts, as long as it is not turned inside out.
    fn reach_of_parts(&self, surface: Aabb) -> Reach {
        let around = match &self.kind {
            // (A plane's box is flat.) What has no end is where its bounds are.
            SolidKind::Leaf(_) if !bvh::fits(&surface) && !self.bounds_before().is_empty() => {
                self.bounds_before().iter().map(Self::bounds).fold(Aabb::INFINITE, Aabb::intersection)
            }
            SolidKind::Leaf(_) if !bvh::fits(&surface) => Aabb::INFINITE,
            SolidKind::Leaf(leaf) if leaf.shape.solid_bounds().is_some() => Aabb::INFINITE,
            SolidKind::Leaf(leaf) if leaf.inverse => leaf.shape.extent(&leaf.transform()),
            SolidKind::Leaf(_) => surface,
            SolidKind::Union(c) | SolidKind::Merge(c) => c.iter().map(Self::reach).fold(Aabb::EMPTY, Aabb::union),
            SolidKind::Intersection(children) => {
                let upright = children.iter().filter(|c| !c.is_inverted());
                upright.map(Self::reach).fold(Aabb::INFINITE, Aabb::intersection)
            }
        };
        Reach { around, inverted: false, cuts: false }
    }

    fn is_inverted(&self) -> bool {
        match &self.kind {
            SolidKind::Leaf(leaf) => leaf.inverse,
            _ => self.more.as_ref().is_some_and(|more| more.reach.inverted),
        }
    }

    /// The box around all its hits.
    pub fn bounds(&self) -> Aabb {
        self.boxes().surface
    }

    /// Computes both boxes from the parts and what clips them.
    pub(super) fn measure(&mut self, clip: Box<[SolidNode]>, bounds: Box<[SolidNode]>, unseen: Box<[SolidNode]>) {
        let inner: SmallVec<[Boxes; 8]> = self.children().iter().map(SolidNode::boxes).collect();
        let (surface, solid) = match &self.kind {
            SolidKind::Leaf(leaf) => {
                if clip.is_empty() && bounds.is_empty() {
                    self.more = None;
                    return;
                }
                leaf.bounds()
            }
            SolidKind::Union(_) | SolidKind::Merge(_) => {
                let join = |side: fn(&Boxes) -> Aabb| inner.iter().map(side).fold(Aabb::EMPTY, Aabb::union);
                let hidden = unseen.iter().map(|c| c.boxes().solid).fold(Aabb::EMPTY, Aabb::union);
                (join(|c| c.surface), join(|c| c.solid).union(hidden))
            }
            SolidKind::Intersection(_) => intersection_bounds(&inner),
        };
        let clipped = clip.iter().map(|c| c.boxes().solid).fold(Aabb::INFINITE, Aabb::intersection);
        let (mut surface, mut solid) = (surface.intersection(clipped), solid.intersection(clipped));
        if !clip.is_empty() || matches!(self.kind, SolidKind::Intersection(_)) {
            // Cut by the half-spaces that all of it lies in.
            let mut planes = HalfSpaces::new();
            each_around(&self.kind, &clip, &mut |leaf| {
                halfspace::push_shape(&leaf.shape, &leaf.transform(), leaf.inverse, &mut planes);
            });
            if !planes.is_empty() {
                let all = halfspace::cut(surface.union(solid), &planes);
                (surface, solid) = (surface.intersection(all), solid.intersection(all));
            }
            each_around(&self.kind, &clip, &mut |leaf| {
                if let Some(quadratic) = leaf.quadratic() {
                    (surface, solid) = (quadratic.bounds_in(surface), quadratic.bounds_in(solid));
                }
            });
        }
        // A child matters to a ray in its surface's box, and to a point where it could be the exception.
        let reach = |(c, boxes): (&SolidNode, &Boxes)| match &self.kind {
            SolidKind::Intersection(_) => boxes.surface.union(c.hole()),
            _ => boxes.surface.union(boxes.solid),
        };
        let is_known =
            |c: &SolidNode| matches!(&c.kind, SolidKind::Leaf(leaf) if c.is_whole() && leaf.shape.knows_crossings());
        let known = match &self.kind {
            SolidKind::Leaf(_) | SolidKind::Union(_) => false,
            SolidKind::Intersection(children) | SolidKind::Merge(children) => children.iter().all(is_known),
        };
        let child_bvh = ChildBvh::over(&self.children().iter().zip(&inner).map(reach).collect::<SmallVec<[Aabb; 8]>>());
        // Many are quicker found by their boxes.
        let convex_parts = known && child_bvh.is_none();
        let boxes = Boxes { surface, solid };
        let reach = Reach { around: Aabb::INFINITE, inverted: false, cuts: false };
        self.more = Some(Box::new(More { clip, bounds, unseen, boxes, reach, convex_parts, child_bvh }));
        let reach = self.reach_of_parts(surface);
        if let Some(more) = &mut self.more {
            more.reach = reach;
        }
    }

    /// The same when its parts are others, or more clips it. The box of [`Self::reach`] stays, as long as nothing but the sides
    /// changes.
    pub(super) fn measure_again(&mut self, by: Vec<SolidNode>, bounds: Box<[SolidNode]>, turns: bool) {
        let before = self.more.as_ref().map(|more| more.reach);
        let bounded = !bounds.is_empty();
        let bounds = self.take_bounds().into_iter().chain(bounds).collect();
        let clip = self.take_clip().into_iter().chain(by).collect();
        self.measure(clip, bounds, Box::default());
        // (What bounds a shape says where it is.)
        let before = before.filter(|_| !(bounded && matches!(self.kind, SolidKind::Leaf(_))));
        if let (Some(more), Some(before)) = (&mut self.more, before) {
            more.reach = Reach { inverted: before.inverted != turns, ..before };
        }
    }

    /// A box that holds every point which is not inside: finite for what was inverted.
    fn hole(&self) -> Aabb {
        match &self.kind {
            _ if !self.is_whole() => Aabb::INFINITE,
            SolidKind::Leaf(leaf) if leaf.shape.is_patch() || leaf.shape.reaches_beyond() || !leaf.inverse => {
                Aabb::INFINITE
            }
            SolidKind::Leaf(_) => self.bounds(),
            SolidKind::Intersection(children) => children.iter().map(SolidNode::hole).fold(Aabb::EMPTY, Aabb::union),
            SolidKind::Union(children) | SolidKind::Merge(children) => {
                children.iter().map(SolidNode::hole).fold(Aabb::INFINITE, Aabb::intersection)
            }
        }
    }
}

/// Shows the shapes that all hits of a solid and all points inside it lie in.
fn each_around(kind: &SolidKind, clip: &[SolidNode], visit: &mut dyn FnMut(&Leaf)) {
    clip.iter().for_each(|c| each_around(&c.kind, c.clip(), visit));
    match kind {
        SolidKind::Leaf(leaf) => visit(leaf),
        SolidKind::Intersection(children) => children.iter().for_each(|c| each_around(&c.kind, c.clip(), visit)),
        SolidKind::Union(_) | SolidKind::Merge(_) => {}
    }
}

/// A hit is on one child and inside all others: the union of each one's surface cut to all other solids.
fn intersection_bounds(children: &[Boxes]) -> (Aabb, Aabb) {
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
