//! Which of the hits on a solid's parts are hits of the solid: told along the ray, where that is safe.

use super::leaf::{Intersection, Intersections, Leaf};
use super::node::{SolidKind, SolidNode};
use crate::math::{Range, Ray};
use crate::shape::{Crossing, End, Kernel};
use smallvec::SmallVec;

/// So near to where a convex part begins or ends, in units of its own space, its `inside` is asked: what lies in one surface with
/// another is settled there. Far above rounding and above what `inside` tolerates.
const SLACK: f64 = 1e-6;

/// The interval of a ray that lies inside a part, or all that does not.
#[derive(Clone, Copy, Debug)]
struct ConvexInterval {
    /// Where it begins and ends; at an infinite t where it does not, the first behind the second where there is none.
    ends: [End; 2],
    /// The part is what lies outside of that.
    inverse: bool,
    /// In units of t.
    slack: f64,
}

impl ConvexInterval {
    const NONE: [End; 2] = [End { t: f64::INFINITY, part: 0 }, End { t: f64::NEG_INFINITY, part: 0 }];

    /// That of a ray with a leaf, if it is known.
    #[inline]
    fn of(leaf: &Leaf, ray: &Ray) -> Option<Self> {
        let local = leaf.local(ray);
        let (ends, around) = match leaf.shape.crossing(&local) {
            Crossing::Unknown => return None,
            Crossing::Misses => (Self::NONE, false),
            Crossing::Through(ends) => (ends, false),
            Crossing::Around(ends) => (ends, true),
            Crossing::Stays => (Self::NONE, true),
        };
        // (At most the length of the direction, and no root.)
        let slack = SLACK / local.dir.abs().element_sum();
        Some(Self { ends, inverse: leaf.inverse != around, slack })
    }

    /// What of the range can count if only what lies inside does.
    fn reach(&self, range: Range) -> Range {
        if self.inverse {
            return range;
        }
        range.and(Range { min: self.ends[0].t - self.slack, max: self.ends[1].t + self.slack })
    }

    /// Is the point at `t` inside the part? `None` where that is for the part itself to say.
    fn holds(&self, t: f64) -> Option<bool> {
        let [min, max] = self.ends.map(|end| end.t);
        let near = (t - min).abs() < self.slack || (t - max).abs() < self.slack;
        (!near).then_some((t > min && t < max) != self.inverse)
    }
}

/// What of the range can count if only what lies inside the solid does; all of it, if that is not known.
pub(super) fn within(solid: &SolidNode, ray: &Ray, range: Range) -> Range {
    match solid.kind() {
        SolidKind::Leaf(leaf) if !(leaf.inverse && leaf.shape.is_convex()) => {
            ConvexInterval::of(leaf, ray).map_or(range, |interval| interval.reach(range))
        }
        _ => range,
    }
}

/// A part that can't tell where a ray is inside it.
pub(super) struct Unknown;

/// The nearest hit of an intersection, or if `merged` of a merge, whose children all know their crossings, and the shape that it is on.
/// `shows` says of a hit at t whether nothing clips it.
pub(super) fn nearest<'a>(
    children: &'a [SolidNode],
    merged: bool,
    ray: &Ray,
    mut range: Range,
    shows: impl Fn(f64) -> bool,
) -> Result<Option<(End, &'a Leaf)>, Unknown> {
    let mut parts: SmallVec<[(ConvexInterval, &Leaf); 4]> = SmallVec::new();
    for child in children {
        let SolidKind::Leaf(leaf) = child.kind() else { return Err(Unknown) };
        let interval = ConvexInterval::of(leaf, ray).ok_or(Unknown)?;
        if !merged {
            range = interval.reach(range);
            if range.is_empty() {
                return Ok(None);
            }
        }
        parts.push((interval, leaf));
    }
    let mut best = None;
    for (i, &(interval, leaf)) in parts.iter().enumerate() {
        for end in interval.ends {
            let inside = |j: usize, other: &ConvexInterval| match other.holds(end.t) {
                Some(inside) => inside,
                None => children[j].inside(ray.at(end.t)),
            };
            let is_kept = || parts.iter().enumerate().all(|(j, (other, _))| j == i || inside(j, other) != merged);
            if range.contains(end.t) && is_kept() && shows(end.t) {
                // (Of several in one place the last part shows, as in POV-Ray 3.7.)
                range.max = end.t.next_up();
                best = Some((end, leaf));
            }
        }
    }
    Ok(best)
}

/// What a ray finds on the children of an intersection or a merge.
pub(super) struct Gathered<'a> {
    /// Outside of it nothing counts.
    range: Range,
    /// The hits, and the number of the child that each is on.
    pub(super) hits: SmallVec<[(Intersection<'a>, u32); 4]>,
    /// Where the ray is inside the children, so far as that is known.
    intervals: SmallVec<[Option<ConvexInterval>; 4]>,
}

impl<'a> Gathered<'a> {
    /// Nothing. (It is large: it stays where it is made.)
    pub(super) fn new() -> Self {
        Self { range: Range::ALL, hits: SmallVec::new(), intervals: SmallVec::new() }
    }

    /// Makes place for so many children.
    pub(super) fn expect(&mut self, children: usize) {
        self.intervals.resize(children, None);
    }

    /// Looks where the ray is inside a child. If only what lies inside counts, then that is all of the range from now on, which is
    /// returned.
    pub(super) fn look(&mut self, i: usize, child: &SolidNode, ray: &Ray, range: Range, only_inside: bool) -> Range {
        self.range = self.range.and(range);
        if let SolidKind::Leaf(leaf) = child.kind()
            && child.is_whole()
            && let Some(interval) = ConvexInterval::of(leaf, ray)
        {
            if only_inside {
                self.range = interval.reach(self.range);
            }
            self.intervals[i] = Some(interval);
        }
        self.range
    }

    /// Adds the hits of a child in what is left of the range.
    pub(super) fn add(&mut self, i: usize, child: &'a SolidNode, ray: &Ray) {
        if self.range.is_empty() {
            return;
        }
        let number = i as u32;
        match (child.kind(), &self.intervals[i]) {
            (SolidKind::Leaf(leaf), Some(interval)) => {
                for end in interval.ends.into_iter().filter(|end| self.range.contains(end.t)) {
                    self.hits.push((Intersection::new(end.into(), leaf, child.object), number));
                }
            }
            _ => {
                let mut all = Intersections::new();
                child.hits_as(true, ray, self.range, &mut all);
                self.hits.extend(all.iter().map(|found| (*found, number)));
            }
        }
    }

    /// Is the ray at `t` inside child `i`?
    pub(super) fn inside(&self, i: usize, child: &SolidNode, ray: &Ray, t: f64) -> bool {
        self.intervals[i].and_then(|interval| interval.holds(t)).unwrap_or_else(|| child.inside(ray.at(t)))
    }
}
