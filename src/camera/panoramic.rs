//! `panoramic`: half a turn about the axis that goes up, on a cylinder (manual, "Panoramic"). It takes no `angle`: the lengths of `right`,
//! `up` and `direction` say how far it is stretched (formula fitted on POV-Ray 3.7).

use super::lowered::LocalRay;
use crate::math::{DVec2, DVec3, fp};
use std::f64::consts::{FRAC_PI_2, PI};

/// The ray. Bumps are asked at the angles to the right and to the horizon.
pub(super) fn ray(at: DVec2, lengths: DVec3) -> LocalRay {
    let (sin, cos) = fp::sin_cos(PI * at.x);
    let place = DVec2::new(FRAC_PI_2 - PI * at.x, PI * at.y);
    LocalRay::from_eye(lengths * DVec3::new(sin, fp::tan(PI * at.y), cos), place)
}
