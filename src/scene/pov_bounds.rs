//! The boxes that `min_extent` and `max_extent` return. Scenes place objects by these boxes, so they are POV-Ray's
//! boxes, which are not always the smallest (quirk: `csg_extent_boxes`). The box of a shape is its box in object space,
//! transformed once. The box of a CSG object is the union or intersection of its parts' boxes, and each later transform
//! acts on that box.

use super::{CsgOp, Object, ObjectKind};
use crate::math::{Aabb, DVec3};
use crate::shape::{HUGE, Kernel};

impl Object {
    /// Returns the object's box after its transforms, as POV-Ray computes it.
    pub fn pov_bounds(&self) -> Aabb {
        let own = match &self.kind {
            ObjectKind::Shape(shape) => shape.pov_bounds(&self.transform),
            ObjectKind::Csg(..) => self.bulk.as_ref().and_then(|bulk| bulk.pov_bounds).unwrap_or(HUGE),
            ObjectKind::Light(_) => HUGE,
        };
        let bounds = [&self.uncommon.clipped_by, &self.uncommon.bounded_by].into_iter().flatten();
        bounds.fold(own, |own, parts| {
            let clip = intersection_of(parts.iter().map(restriction_box));
            if !clip.is_empty() && volume(&clip) < volume(&own) { clip } else { own }
        })
    }

    /// Returns the bounding box that POV-Ray computes for a CSG object of these parts, before the CSG object's own
    /// transforms.
    pub(super) fn pov_bounds_of_parts(op: CsgOp, parts: &[Object]) -> Aabb {
        match op {
            CsgOp::Union | CsgOp::Merge => {
                let all = parts.iter().map(Object::pov_bounds).reduce(Aabb::union);
                all.map_or(Aabb::from_corners(DVec3::ZERO, DVec3::ZERO), |b| b.intersection(HUGE))
            }
            CsgOp::Intersection => huge_if_empty_or_beyond(intersection_of(parts.iter().map(restriction_box))),
            CsgOp::Difference => {
                let others = parts.iter().skip(1).map(|part| operand_restriction_box(part, true));
                huge_if_empty_or_beyond(intersection_of(parts.iter().take(1).map(restriction_box).chain(others)))
            }
        }
    }
}

fn intersection_of(boxes: impl Iterator<Item = Aabb>) -> Aabb {
    boxes.fold(Aabb::INFINITE, Aabb::intersection)
}

fn huge_if_empty_or_beyond(b: Aabb) -> Aabb {
    let beyond = b.min.min_element() < HUGE.min.x || b.max.max_element() > HUGE.max.x;
    if b.is_empty() || beyond { HUGE } else { b }
}

fn volume(b: &Aabb) -> f64 {
    let size = b.max - b.min;
    size.x * size.y * size.z
}

/// Returns the box to which one part of an intersection limits the whole intersection, as in POV-Ray; infinite if it
/// limits nothing.
fn restriction_box(part: &Object) -> Aabb {
    operand_restriction_box(part, false)
}

fn operand_restriction_box(part: &Object, is_subtracted: bool) -> Aabb {
    let inverse = part.uncommon.flags.inverse != is_subtracted;
    match &part.kind {
        ObjectKind::Shape(shape) => match shape.as_half_space() {
            Some((normal, distance)) if part.uncommon.clipped_by.is_none() => {
                let point = part.transform.transform_point(normal * distance);
                let normal = part.transform.transform_normal(normal).normalize();
                axis_aligned_half_space(if inverse { -normal } else { normal }, point)
            }
            _ if inverse || shape.solid_bounds().is_some() => Aabb::INFINITE,
            _ => part.pov_bounds(),
        },
        _ if inverse => Aabb::INFINITE,
        _ => part.pov_bounds(),
    }
}

/// Returns the half-space below an axis-aligned plane as a box; an infinite box for any other plane.
fn axis_aligned_half_space(normal: DVec3, point: DVec3) -> Aabb {
    let mut out = Aabb::INFINITE;
    for axis in 0..3 {
        if normal[axis] > 1.0 - 1e-9 {
            out.max[axis] = point[axis];
        } else if normal[axis] < -1.0 + 1e-9 {
            out.min[axis] = point[axis];
        }
    }
    out
}
