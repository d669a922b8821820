//! `cylinder N`: projection onto a cylinder about the vertical (types 1 and 3) or horizontal axis (2 and 4); the eye is
//! fixed (1 and 2) or moves along the axis (3 and 4; manual, "Cylindrical").

use super::LocalRay;
use crate::math::{DVec2, DVec3, fp};

/// Returns the ray of a cylindrical camera; `cylinder_type` is its type, from 1 to 4, and `full_angle_radians` the
/// angle of view about the axis. Bumps are evaluated at the angle and the length along the axis.
pub(super) fn cylindrical_ray(
    cylinder_type: u8,
    picture_fraction_from_center: DVec2,
    right_up_direction_lengths: DVec3,
    full_angle_radians: f64,
) -> LocalRay {
    let upright = matches!(cylinder_type, 1 | 3);
    let turn = if upright { picture_fraction_from_center.x } else { picture_fraction_from_center.y };
    let along = if upright {
        picture_fraction_from_center.y * right_up_direction_lengths.y
    } else {
        picture_fraction_from_center.x * right_up_direction_lengths.x
    };
    let (sin, cos) = fp::sin_cos(turn * full_angle_radians);
    // (Along the axis, about the axis, ahead) to (right, up, ahead).
    let turned = |along: f64, about: f64| if upright { DVec2::new(about, along) } else { DVec2::new(along, about) };
    let bump_position = turned(along, turn * full_angle_radians);
    match cylinder_type {
        1 | 2 => LocalRay::from_eye(turned(along, sin).extend(cos), bump_position),
        _ => LocalRay { origin: turned(along, 0.0), dir: turned(0.0, sin).extend(cos), bump_position },
    }
}
