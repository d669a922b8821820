//! `ultra_wide_angle`: a fisheye that fills the picture (manual, "Ultra wide angle", quirk:
//! `ultra_wide_angle_formula`).

use super::LocalRay;
use crate::math::{DVec2, DVec3, fp};

/// Returns the ray of an ultra wide angle camera; `full_angle_radians` is the horizontal angle of view. Bumps are
/// evaluated at the horizontal and vertical angles of the ray.
pub(super) fn ultra_wide_angle_ray(
    picture_fraction_from_center: DVec2,
    right_up_direction_lengths: DVec3,
    full_angle_radians: f64,
) -> LocalRay {
    let bump_position = picture_fraction_from_center
        * full_angle_radians
        * DVec2::new(1.0, right_up_direction_lengths.y / right_up_direction_lengths.x);
    let ((sin_x, cos_x), (sin_y, cos_y)) = (fp::sin_cos(bump_position.x), fp::sin_cos(bump_position.y));
    LocalRay::from_eye(DVec3::new(sin_x, sin_y, cos_x * cos_y), bump_position)
}
