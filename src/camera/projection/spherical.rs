//! `spherical`: longitude across the picture, latitude up (manual, "Spherical").

use crate::math::{DVec2, DVec3, fp};

/// Returns the direction of a spherical camera's ray, of length 1, and the position for bumps: longitude and latitude.
/// `angles` are the horizontal and vertical angles of view, in radians; `axes` are the unit vectors right, up and
/// ahead. The direction ahead is rotated about right and then about up, even if these are not orthogonal (quirk:
/// `spherical_skew`).
pub(super) fn direction_and_bump_position(
    picture_fraction_from_center: DVec2,
    angles: DVec2,
    [right, up, ahead]: [DVec3; 3],
) -> (DVec3, DVec2) {
    let bump_position = picture_fraction_from_center * angles;
    (rotate_about(rotate_about(ahead, right, -bump_position.y), up, bump_position.x), bump_position)
}

/// Rotates a vector about an axis of length 1 (Rodrigues 1840).
fn rotate_about(v: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    let (sin, cos) = fp::sin_cos(angle);
    v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// POV-Ray's directions with `matrix <1, .5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0>`, shown by the colours of a sky.
    #[test]
    fn axes_that_are_no_right_angle() {
        let right = DVec3::new(1.0, 0.5, 0.0).normalize();
        let angles = DVec2::new(300f64.to_radians(), 150f64.to_radians());
        for (at, expected) in [
            ([-0.35416666666666663, 0.3611111111111111], [-0.4606, 0.7251, -0.5119]),
            ([0.35416666666666663, 0.25], [0.8378, 0.5445, 0.0394]),
            ([-0.0625, -0.36111111111111116], [0.1552, -0.7251, 0.6709]),
        ] {
            let (dir, _) = direction_and_bump_position(DVec2::from(at), angles, [right, DVec3::Y, DVec3::Z]);
            assert!(dir.abs_diff_eq(DVec3::from(expected), 1e-4), "{dir}");
        }
    }
}
