//! `fisheye`: directions in a disc, whose angle to the axis grows with the distance from the centre; black outside
//! (manual, "Fisheye"). Where `right` or `up` has length 1, the disc touches the picture's edge (quirk:
//! `fisheye_disc`).

use super::LocalRay;
use crate::math::{DVec2, DVec3, fp};
use std::f64::consts::PI;

/// Returns the ray of a fisheye camera; `None` outside its disc. `full_angle_radians` is the angle of view of the whole disc, in
/// radians.
pub(super) fn fisheye_ray(
    picture_fraction_from_center: DVec2,
    right_up_direction_lengths: DVec3,
    full_angle_radians: f64,
) -> Option<LocalRay> {
    let p = picture_fraction_from_center * right_up_direction_lengths.truncate() * 2.0;
    let r = p.length();
    if r > 1.0 {
        return None;
    }
    Some(ray_through_disc(p, r * full_angle_radians / 2.0))
}

/// Returns the camera ray at an angle to the axis of view, towards a point of the disc. Bumps are evaluated at the
/// point's angle and at `angle_to_axis`.
pub(super) fn ray_through_disc(p: DVec2, angle_to_axis: f64) -> LocalRay {
    let (sin, cos) = fp::sin_cos(angle_to_axis);
    // From -½π to 1½π
    let around = if p.x < 0.0 { PI - fp::atan2(p.y, -p.x) } else { fp::atan2(p.y, p.x) };
    LocalRay::from_eye((p.normalize_or_zero() * sin).extend(cos), DVec2::new(around, angle_to_axis))
}
