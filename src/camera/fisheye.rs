//! `fisheye`: directions in a disc, the farther from its middle the larger their angle to the axis; outside of it the picture is black
//! (manual, "Fisheye"). Where `right` or `up` is 1 long, the disc touches the picture's sides (measured on POV-Ray 3.7).

use super::lowered::LocalRay;
use crate::math::{DVec2, DVec3, fp};
use std::f64::consts::PI;

/// The ray; `angle` is that of the whole disc.
pub(super) fn ray(at: DVec2, lengths: DVec3, angle: f64) -> Option<LocalRay> {
    let p = at * lengths.truncate() * 2.0;
    let r = p.length();
    if r > 1.0 {
        return None;
    }
    Some(on_disc(p, r * angle / 2.0))
}

/// The ray at an angle to the axis, towards a place of the disc. Bumps are asked at the angle of that place and at this one.
pub(super) fn on_disc(p: DVec2, angle: f64) -> LocalRay {
    let (sin, cos) = fp::sin_cos(angle);
    // from -½π to 1½π
    let around = if p.x < 0.0 { PI - fp::atan2(p.y, -p.x) } else { fp::atan2(p.y, p.x) };
    LocalRay::from_eye((p.normalize_or_zero() * sin).extend(cos), DVec2::new(around, angle))
}
