//! `spherical`: longitude across the picture, latitude up (manual, "Spherical").

use super::eye::Sight;
use crate::math::{DVec2, DVec3, fp};

/// The ray; `angles` are those from left to right and from bottom to top. Bumps are asked at longitude and latitude.
pub(super) fn ray(at: DVec2, angles: DVec2) -> Sight {
    let place = at * angles;
    let ((sin_x, cos_x), (sin_y, cos_y)) = (fp::sin_cos(place.x), fp::sin_cos(place.y));
    Sight::from_eye(DVec3::new(sin_x * cos_y, sin_y, cos_x * cos_y), place)
}
