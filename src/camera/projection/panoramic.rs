//! `panoramic`: 180° about the vertical axis, on a cylinder (manual, "Panoramic"). `angle` has no effect; the lengths
//! of `right`, `up` and `direction` determine the scale (quirk: `panoramic_formula`).

use super::LocalRay;
use crate::math::{DVec2, DVec3, fp};
use std::f64::consts::{FRAC_PI_2, PI};

/// Returns the ray of a panoramic camera. Bumps are evaluated at the horizontal angle and the angle to the horizon.
pub(super) fn panoramic_ray(picture_fraction_from_center: DVec2, right_up_direction_lengths: DVec3) -> LocalRay {
    let (sin, cos) = fp::sin_cos(PI * picture_fraction_from_center.x);
    let bump_position =
        DVec2::new(FRAC_PI_2 - PI * picture_fraction_from_center.x, PI * picture_fraction_from_center.y);
    LocalRay::from_eye(
        right_up_direction_lengths * DVec3::new(sin, fp::tan(PI * picture_fraction_from_center.y), cos),
        bump_position,
    )
}
