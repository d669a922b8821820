//! Boxes as POV-Ray tells them by `min_extent` and `max_extent` (measured on 3.7): scenes place things by these numbers, so they are
//! not always the smallest ones.

use crate::math::{Aabb, DAffine3, DQuat, DVec3, Transform};

/// What POV-Ray tells of things without end.
pub const HUGE: Aabb = Aabb { min: DVec3::splat(-1e10), max: DVec3::splat(1e10) };
/// What it tells of shapes without any part.
pub(super) const NOTHING: Aabb = Aabb { min: DVec3::splat(2e10), max: DVec3::splat(-2e10) };
/// Flat things are this thick to both sides.
pub(super) const THIN: f64 = 0.001;

/// The box around a moved box; what has no end has none wherever it is.
pub fn moved_box(by: &Transform, b: &Aabb) -> Aabb {
    let endless = b.min.x <= HUGE.min.x && b.max.x >= HUGE.max.x;
    if endless { HUGE } else { by.aabb(b) }
}

/// The box of something round under M, given in the frame at `origin` whose z axis is turned to `axis` on the shortest way.
pub(super) fn framed(m: &Transform, axis: DVec3, origin: DVec3, b: &Aabb) -> Aabb {
    let turn = DQuat::from_rotation_arc(DVec3::Z, axis.normalize_or(DVec3::Z));
    let turned = Transform::from_affine(DAffine3::from_rotation_translation(turn, origin));
    moved_box(&turned.unwrap_or_else(|_| Transform::translate(origin)).then(m), b)
}
