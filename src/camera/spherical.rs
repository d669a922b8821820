//! `spherical`: longitude across the picture, latitude up (manual, "Spherical").

use crate::math::{DVec2, DVec3, fp};

/// The direction; `angles` are those from left to right and from bottom to top.
pub(super) fn direction(at: DVec2, angles: DVec2) -> DVec3 {
    let ((sin_x, cos_x), (sin_y, cos_y)) = (fp::sin_cos(at.x * angles.x), fp::sin_cos(at.y * angles.y));
    DVec3::new(sin_x * cos_y, sin_y, cos_x * cos_y)
}
