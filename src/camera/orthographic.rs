//! `orthographic`: parallel rays, so that nothing gets smaller with the distance (manual, "Orthographic"). Its window stands at the
//! camera's location, and is `right` wide and `up` high.

use crate::math::{DVec2, DVec3};

/// Where the ray begins, along right and up, and its direction.
pub(super) fn ray(at: DVec2, lengths: DVec3) -> (DVec2, Option<DVec3>) {
    (at * lengths.truncate(), Some(DVec3::Z))
}
