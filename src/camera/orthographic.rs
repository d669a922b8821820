//! `orthographic`: parallel rays, so that nothing gets smaller with the distance (manual, "Orthographic"). Its window stands at the
//! camera's location, and is `right` wide and `up` high.

use super::lowered::LocalRay;
use crate::math::{DVec2, DVec3};

/// The ray.
pub(super) fn ray(at: DVec2, lengths: DVec3) -> LocalRay {
    LocalRay { origin: at * lengths.truncate(), dir: DVec3::Z, place: at }
}
