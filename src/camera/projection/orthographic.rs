//! `orthographic`: parallel rays through a window at the camera's location, `right` wide and `up` high (manual,
//! "Orthographic").

use super::LocalRay;
use crate::math::{DVec2, DVec3};

/// Returns the ray of an orthographic camera.
pub(super) fn orthographic_ray(position: DVec2, window_lengths: DVec3) -> LocalRay {
    LocalRay { origin: position * window_lengths.truncate(), dir: DVec3::Z, bump_position: position }
}
