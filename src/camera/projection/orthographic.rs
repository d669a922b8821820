//! `orthographic`: parallel rays through a window at the camera's location, `right` wide and `up` high (manual,
//! "Orthographic").

use super::LocalRay;
use crate::math::{DVec2, DVec3};

/// Returns the ray of an orthographic camera.
pub(super) fn orthographic_ray(picture_fraction_from_center: DVec2, right_up_direction_lengths: DVec3) -> LocalRay {
    LocalRay {
        origin: picture_fraction_from_center * right_up_direction_lengths.truncate(),
        dir: DVec3::Z,
        bump_position: picture_fraction_from_center,
    }
}
