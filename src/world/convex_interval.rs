//! Decides by intervals along a ray which hits on parts are hits of the solid, where rounding can't change the result.

use super::leaf::Leaf;
use super::node::{SolidKind, SolidNode};
use crate::math::{Range, Ray};
use crate::shape::{Crossing, End, Kernel};
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Distance from the end of an interval below which the part's `inside` decides, in units of the part's own space, so
/// that coincident surfaces are treated alike. Far above rounding errors and the tolerance of `inside`.
pub(super) const SLACK: f64 = 1e-6;

/// Interval of a ray inside a convex part, or the complement of such an interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct ConvexInterval {
    /// Ends of the interval, which may be infinite. The first is after the second if the interval is empty.
    pub(super) ends: [End; 2],
    /// True if the part is inverted, so that the ray is inside it outside of the interval.
    inverse: bool,
    /// [`SLACK`] in units of `t`.
    slack: f64,
}

impl ConvexInterval {
    const NONE: [End; 2] = [End { t: f64::INFINITY, part: 0 }, End { t: f64::NEG_INFINITY, part: 0 }];

    /// Returns the interval of a ray that is nowhere inside a part, or everywhere if the part is inverted.
    pub(super) fn without_surface(inverse: bool) -> Self {
        Self { ends: Self::NONE, inverse, slack: 0.0 }
    }

    /// Returns where a ray is inside a shape: in an interval, or outside of it; `None` if the shape can't compute intervals.
    #[inline]
    pub(super) fn inside_shape_if_known(leaf: &Leaf, ray: &Ray) -> Option<Self> {
        leaf.with_local_ray(ray, |local| {
            let (ends, around) = match leaf.shape.crossing(local) {
                Crossing::Unknown => return None,
                Crossing::Misses => (Self::NONE, false),
                Crossing::Through(ends) => (ends, false),
                Crossing::Around(ends) => (ends, true),
                Crossing::Stays => (Self::NONE, true),
            };
            // (An upper bound of the direction's length, without a root.)
            let slack = SLACK / local.dir.abs().element_sum();
            Some(Self { ends, inverse: leaf.inverse != around, slack })
        })
    }

    /// Returns the part of the range in which the ray can be inside the part.
    pub(super) fn possible_range(&self, range: Range) -> Range {
        if self.inverse {
            return range;
        }
        range.intersection(Range { min: self.ends[0].t - self.slack, max: self.ends[1].t + self.slack })
    }

    /// True if all points of the ray within the range are certainly inside the part, and none is near an end.
    fn contains_all_of(&self, range: Range) -> bool {
        let [start, end] = self.ends.map(|end| end.t);
        match self.inverse {
            true => start - self.slack > range.max || end + self.slack < range.min,
            false => start + self.slack < range.min && end - self.slack > range.max,
        }
    }

    /// Returns whether the point at `t` is inside the part; `None` near an end, where the part's `inside` must decide.
    pub(super) fn contains(&self, t: f64) -> Option<bool> {
        let [min, max] = self.ends.map(|end| end.t);
        let near = (t - min).abs() < self.slack || (t - max).abs() < self.slack;
        (!near).then_some((t > min && t < max) != self.inverse)
    }
}

/// Returns the part of the range in which the ray can be inside the solid; the whole range without intervals.
pub(super) fn range_possibly_inside(solid: &SolidNode, ray: &Ray, range: Range) -> Range {
    match solid.kind() {
        SolidKind::Leaf(leaf) if !(leaf.inverse && leaf.shape.is_convex()) => {
            ConvexInterval::inside_shape_if_known(leaf, ray).map_or(range, |interval| interval.possible_range(range))
        }
        _ => range,
    }
}

/// Error of a part that can't compute the interval of a ray inside it.
pub(super) struct UnknownInterval;

/// Calls `visit` with each hit in the range on an intersection, or on a merge if `merged`, and the shape that is hit, in the
/// order of the shapes, not of the distances. `visit` returns the distance up to which further hits count. `is_skipped`
/// is true for the index of a child without effect on the ray within the range. An error, without any call, if a child is
/// no shape or cannot compute its interval.
pub(super) fn visit_ends_on_surface<'a>(
    children: &'a [SolidNode],
    merged: bool,
    ray: &Ray,
    mut range: Range,
    is_skipped: impl Fn(usize, Range) -> bool,
    mut visit: impl FnMut(End, &'a Leaf) -> ControlFlow<(), f64>,
) -> Result<(), UnknownInterval> {
    // Children that neither have a hit in the range nor remove one are left out.
    let mut parts: SmallVec<[(ConvexInterval, &'a Leaf, &'a SolidNode); 4]> = SmallVec::new();
    for (i, child) in children.iter().enumerate() {
        if is_skipped(i, range) {
            continue;
        }
        let SolidKind::Leaf(leaf) = child.kind() else { return Err(UnknownInterval) };
        let interval = ConvexInterval::inside_shape_if_known(leaf, ray).ok_or(UnknownInterval)?;
        if !merged {
            range = interval.possible_range(range);
            if range.is_empty() {
                return Ok(());
            }
            if interval.contains_all_of(range) {
                continue;
            }
        }
        parts.push((interval, leaf, child));
    }
    for (i, &(interval, leaf, _)) in parts.iter().enumerate() {
        for end in interval.ends {
            let inside = |(other, _, child): &(ConvexInterval, &Leaf, &SolidNode)| match other.contains(end.t) {
                Some(inside) => inside,
                None => child.inside(ray.at(end.t)),
            };
            let is_kept = || parts.iter().enumerate().all(|(j, other)| j == i || inside(other) != merged);
            if range.contains(end.t) && is_kept() {
                match visit(end, leaf) {
                    ControlFlow::Continue(max) => range.max = range.max.min(max),
                    ControlFlow::Break(()) => return Ok(()),
                }
            }
        }
    }
    Ok(())
}
