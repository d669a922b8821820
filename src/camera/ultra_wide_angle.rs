//! `ultra_wide_angle`: a fisheye that fills the picture (manual, "Ultra wide angle"; formula fitted on POV-Ray 3.7).

use crate::math::{DVec2, DVec3, fp};

/// The direction, not normalised; `angle` is that from left to right.
pub(super) fn direction(at: DVec2, lengths: DVec3, angle: f64) -> DVec3 {
    let (sin_x, cos_x) = fp::sin_cos(at.x * angle);
    let (sin_y, cos_y) = fp::sin_cos(at.y * angle * lengths.y / lengths.x);
    DVec3::new(sin_x, sin_y, cos_x * cos_y)
}
