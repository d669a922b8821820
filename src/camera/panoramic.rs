//! `panoramic`: half a turn about the axis that goes up, on a cylinder (manual, "Panoramic"). It takes no `angle`: the lengths of `right`,
//! `up` and `direction` say how far it is stretched (formula fitted on POV-Ray 3.7).

use crate::math::{DVec2, DVec3, fp};
use std::f64::consts::PI;

/// The direction, not normalised.
pub(super) fn direction(at: DVec2, lengths: DVec3) -> DVec3 {
    let (sin, cos) = fp::sin_cos(PI * at.x);
    lengths * DVec3::new(sin, fp::tan(PI * at.y), cos)
}
