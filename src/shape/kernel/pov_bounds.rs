//! Boxes that `min_extent` and `max_extent` return (quirk: `extent_boxes`): scenes place objects by these numbers, so
//! they must be POV-Ray's, which are not always the smallest ones.

use crate::math::{Aabb, DAffine3, DQuat, DVec3, Transform};

/// Box that POV-Ray reports for an infinite object.
pub const HUGE: Aabb = Aabb { min: DVec3::splat(-1e10), max: DVec3::splat(1e10) };
/// Box that POV-Ray reports for a shape without any part.
pub const NOTHING: Aabb = Aabb { min: DVec3::splat(2e10), max: DVec3::splat(-2e10) };
/// Thickness of the box that POV-Ray reports for a flat shape, to both sides.
pub const THIN: f64 = 0.001;

/// Returns the box around a transformed box; an infinite box stays infinite.
pub fn transformed_box(by: &Transform, b: &Aabb) -> Aabb {
    let endless = b.min.x <= HUGE.min.x && b.max.x >= HUGE.max.x;
    if endless { HUGE } else { by.transform_aabb(b) }
}

/// Returns the box that POV-Ray reports for a round shape under M; `b` is in the frame at `origin` whose z axis is
/// rotated to `axis` by the shortest arc.
pub fn transformed_frame_bounds(m: &Transform, axis: DVec3, origin: DVec3, b: &Aabb) -> Aabb {
    let turn = DQuat::from_rotation_arc(DVec3::Z, axis.normalize_or(DVec3::Z));
    let turned = Transform::from_affine(DAffine3::from_rotation_translation(turn, origin));
    transformed_box(&turned.unwrap_or_else(|_| Transform::translate(origin)).then(m), b)
}
