//! `fisheye`: directions in a disc, the farther from its middle the larger their angle to the axis; outside of it the picture is black
//! (manual, "Fisheye"). Where `right` or `up` is 1 long, the disc touches the picture's sides (measured on POV-Ray 3.7).

use crate::math::{DVec2, DVec3, fp};

/// The direction; `angle` is that of the whole disc.
pub(super) fn direction(at: DVec2, lengths: DVec3, angle: f64) -> Option<DVec3> {
    let p = at * lengths.truncate() * 2.0;
    let r = p.length();
    if r > 1.0 {
        return None;
    }
    let (sin, cos) = fp::sin_cos(r * angle / 2.0);
    Some((p.normalize_or_zero() * sin).extend(cos))
}
