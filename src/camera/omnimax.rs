//! `omnimax`: half a turn in a disc for cinemas with a dome; what lies more than 45° below the axis is black (manual, "Omnimax"; all
//! numbers fitted on POV-Ray 3.7).

use super::fisheye::on_disc;
use super::lowered::LocalRay;
use crate::math::{DVec2, DVec3};

/// The angle to the axis at a distance from the middle of the disc, which is 1 at its edge: fitted, to 1e-9.
const ANGLE: [f64; 3] = [1.411_269, -0.094_390, 0.256_740];
/// How wide the disc is down to where that angle is 45°, with that as its height. A picture that is wider shows that and no more.
const WIDEST: f64 = 1.283_458;

/// The ray.
pub(super) fn ray(at: DVec2, lengths: DVec3) -> Option<LocalRay> {
    let p = in_disc(at, lengths.x / lengths.y);
    let r = p.length();
    if r > 1.0 {
        return None;
    }
    let angle = r * (ANGLE[0] + r * r * (ANGLE[1] + r * r * ANGLE[2]));
    let sight = on_disc(p, angle);
    (sight.dir.y + sight.dir.z >= 0.0).then_some(sight)
}

/// Where a place of the picture is in the disc, whose upper edge is the picture's if that is wider than high.
fn in_disc(at: DVec2, aspect: f64) -> DVec2 {
    if aspect <= 1.0 {
        return DVec2::new(2.0 * at.x, 2.0 * at.y / aspect);
    }
    let scale = 2.0 / aspect.min(WIDEST);
    DVec2::new(scale * at.x * aspect, scale * at.y + 1.0 - 0.5 * scale)
}
