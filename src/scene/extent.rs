//! The box that `min_extent` and `max_extent` tell. It is not always the smallest one: scenes place things by these
//! numbers, so they are made as POV-Ray makes them (measured on 3.7). A shape's box is that of its own frame, moved once;
//! a CSG object's is the union or intersection of its parts', moved as a box by each transform that follows.

use super::{CsgOp, Object, ObjectKind};
use crate::math::{Aabb, DAffine3, DQuat, DVec3, Transform};
use crate::shape::{Frustum, Kernel, Shape};

/// What POV-Ray tells of things without end.
const HUGE: Aabb = Aabb { min: DVec3::splat(-1e10), max: DVec3::splat(1e10) };
/// Flat things are this thick to both sides.
const THIN: f64 = 0.001;

impl Object {
    /// The box around the object where it is now.
    pub fn extent(&self) -> Aabb {
        let own = match &self.kind {
            ObjectKind::Shape(shape) => shape_box(shape, &self.transform),
            ObjectKind::Csg(..) => self.bulk.as_ref().and_then(|bulk| bulk.extent).unwrap_or(HUGE),
            ObjectKind::Undrawn(shape) => moved_box(&self.transform, &shape.bounds),
            ObjectKind::Light(_) => HUGE,
        };
        let bounds = [&self.rare.clipped_by, &self.rare.bounded_by].into_iter().flatten();
        bounds.fold(own, |own, parts| {
            let clip = shared(parts.iter().map(side));
            if !clip.is_empty() && volume(&clip) < volume(&own) { clip } else { own }
        })
    }

    /// The box around a CSG object before it is moved.
    pub(super) fn parts_box(op: CsgOp, parts: &[Object]) -> Aabb {
        match op {
            CsgOp::Union | CsgOp::Merge => {
                let all = parts.iter().map(Object::extent).reduce(Aabb::union);
                all.map_or(Aabb::from_corners(DVec3::ZERO, DVec3::ZERO), |b| b.intersection(HUGE))
            }
            CsgOp::Intersection => or_huge(shared(parts.iter().map(side))),
            CsgOp::Difference => {
                let others = parts.iter().skip(1).map(|part| outer_side(part, true));
                or_huge(shared(parts.iter().take(1).map(side).chain(others)))
            }
        }
    }
}

fn shared(boxes: impl Iterator<Item = Aabb>) -> Aabb {
    boxes.fold(Aabb::INFINITE, Aabb::intersection)
}

fn or_huge(b: Aabb) -> Aabb {
    let beyond = b.min.min_element() < HUGE.min.x || b.max.max_element() > HUGE.max.x;
    if b.is_empty() || beyond { HUGE } else { b }
}

fn volume(b: &Aabb) -> f64 {
    let size = b.max - b.min;
    size.x * size.y * size.z
}

/// What a part leaves of space in an intersection.
fn side(part: &Object) -> Aabb {
    outer_side(part, false)
}

fn outer_side(part: &Object, taken_away: bool) -> Aabb {
    let inverse = part.rare.flags.inverse != taken_away;
    match &part.kind {
        ObjectKind::Shape(shape) => match (shape, inverse) {
            (Shape::Plane(plane), inverse) if part.rare.clipped_by.is_none() => {
                let normal = part.transform.normal(plane.normal).normalize();
                let point = part.transform.point(plane.normal * plane.distance);
                half_space(if inverse { -normal } else { normal }, point)
            }
            (_, true) => Aabb::INFINITE,
            (_, false) => part.extent(),
        },
        _ if inverse => Aabb::INFINITE,
        _ => part.extent(),
    }
}

/// What lies behind a plane that faces along an axis; everything for any other plane.
fn half_space(normal: DVec3, point: DVec3) -> Aabb {
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

/// A shape's box in its own frame, and where that frame lies.
fn shape_box(shape: &Shape, transform: &Transform) -> Aabb {
    let framed = |axis: DVec3, origin: DVec3, b: Aabb| moved_box(&frame(axis, origin).then(transform), &b);
    let round = |c: &Frustum| {
        let (r, length) = (c.base_radius.max(c.cap_radius), (c.cap - c.base).length());
        framed(c.cap - c.base, c.base, Aabb { min: DVec3::new(-r, -r, 0.0), max: DVec3::new(r, r, length) })
    };
    match shape {
        Shape::Plane(_) => HUGE,
        Shape::Sphere(s) => {
            // A sphere that stays one is as wide as before.
            let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|a| transform.vector(a));
            let same = |a: DVec3, b: DVec3| {
                (a.length() - b.length()).abs() < 1e-9 * a.length() && a.dot(b).abs() < 1e-9 * a.length_squared()
            };
            if same(axes[0], axes[1]) && same(axes[1], axes[2]) && same(axes[0], axes[2]) {
                let (center, r) = (transform.point(s.center), DVec3::splat(s.radius * axes[0].length()));
                return Aabb { min: center - r, max: center + r };
            }
            moved_box(transform, &shape.bounds())
        }
        Shape::Cylinder(cylinder) => round(&cylinder.0),
        Shape::Cone(cone) => round(&cone.0),
        Shape::Disc(d) => {
            let corner = DVec3::new(d.radius, d.radius, THIN);
            framed(d.normal, d.center, Aabb { min: -corner, max: corner })
        }
        Shape::Polygon(p) => {
            let thick = p.normal.abs() * THIN;
            let b = shape.bounds();
            moved_box(transform, &Aabb { min: b.min - thick, max: b.max + thick })
        }
        _ => moved_box(transform, &shape.bounds()),
    }
}

/// The frame whose z axis is turned to `axis` on the shortest way.
fn frame(axis: DVec3, origin: DVec3) -> Transform {
    let turn = DQuat::from_rotation_arc(DVec3::Z, axis.normalize_or(DVec3::Z));
    let turned = Transform::from_affine(DAffine3::from_rotation_translation(turn, origin));
    turned.unwrap_or_else(|_| Transform::translate(origin))
}

/// The box around a moved box; what has no end has none wherever it is.
pub(super) fn moved_box(by: &Transform, b: &Aabb) -> Aabb {
    let endless = b.min.x <= HUGE.min.x && b.max.x >= HUGE.max.x;
    if endless { HUGE } else { by.aabb(b) }
}
