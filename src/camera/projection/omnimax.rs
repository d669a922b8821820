//! `omnimax`: 180° in a disc for cinemas with a dome; directions more than 45° below the axis are black (manual,
//! "Omnimax", quirk: `omnimax_formula`).

use super::LocalRay;
use super::fisheye::ray_through_disc;
use crate::math::{DVec2, DVec3};

/// Coefficients of an omnimax camera's polynomial for the angle to the axis by the distance from the centre of the
/// disc, which is 1 at its edge; accurate to 1e-9.
const ANGLE: [f64; 3] = [1.411_269, -0.094_390, 0.256_740];
/// Width of the visible part of the omnimax disc, in units of its height; wider pictures show no more.
const WIDEST: f64 = 1.283_458;

/// Returns the ray of an omnimax camera; `None` outside its disc.
pub(super) fn omnimax_ray(picture_fraction_from_center: DVec2, right_up_direction_lengths: DVec3) -> Option<LocalRay> {
    let p = picture_to_disc(picture_fraction_from_center, right_up_direction_lengths.x / right_up_direction_lengths.y);
    let r = p.length();
    if r > 1.0 {
        return None;
    }
    let angle = r * (ANGLE[0] + r * r * (ANGLE[1] + r * r * ANGLE[2]));
    let sight = ray_through_disc(p, angle);
    (sight.dir.y + sight.dir.z >= 0.0).then_some(sight)
}

/// Maps a position of the picture to the omnimax camera's disc of radius 1; the upper edges of disc and picture
/// coincide if the picture is wider than high.
fn picture_to_disc(picture_fraction_from_center: DVec2, aspect: f64) -> DVec2 {
    if aspect <= 1.0 {
        return DVec2::new(2.0 * picture_fraction_from_center.x, 2.0 * picture_fraction_from_center.y / aspect);
    }
    let scale = 2.0 / aspect.min(WIDEST);
    DVec2::new(
        scale * picture_fraction_from_center.x * aspect,
        scale * picture_fraction_from_center.y + 1.0 - 0.5 * scale,
    )
}
