//! `ultra_wide_angle`: a fisheye that fills the picture (manual, "Ultra wide angle", quirk:
//! `ultra_wide_angle_formula`).

use super::LocalRay;
use crate::math::{DVec2, DVec3, fp};

/// Returns the ray of an ultra wide angle camera; `angle` is the horizontal angle of view. Bumps are evaluated at the
/// horizontal and vertical angles of the ray.
pub(super) fn ultra_wide_angle_ray(fraction_from_center: DVec2, window_lengths: DVec3, angle: f64) -> LocalRay {
    let bump_position = fraction_from_center * angle * DVec2::new(1.0, window_lengths.y / window_lengths.x);
    let ((sin_x, cos_x), (sin_y, cos_y)) = (fp::sin_cos(bump_position.x), fp::sin_cos(bump_position.y));
    LocalRay::from_eye(DVec3::new(sin_x, sin_y, cos_x * cos_y), bump_position)
}
