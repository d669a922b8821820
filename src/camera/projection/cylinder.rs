//! `cylinder N`: projection onto a cylinder about the vertical (types 1 and 3) or horizontal axis (2 and 4); the eye is
//! fixed (1 and 2) or moves along the axis (3 and 4; manual, "Cylindrical").

use super::LocalRay;
use crate::math::{DVec2, DVec3, fp};

/// Returns the ray of a cylindrical camera; `cylinder_type` is its type, from 1 to 4, and `angle` the angle of view about the
/// axis. Bumps are evaluated at the angle and the length along the axis.
pub(super) fn cylindrical_ray(
    cylinder_type: u8,
    fraction_from_center: DVec2,
    window_lengths: DVec3,
    angle: f64,
) -> LocalRay {
    let upright = matches!(cylinder_type, 1 | 3);
    let turn = if upright { fraction_from_center.x } else { fraction_from_center.y };
    let along =
        if upright { fraction_from_center.y * window_lengths.y } else { fraction_from_center.x * window_lengths.x };
    let (sin, cos) = fp::sin_cos(turn * angle);
    // (Along the axis, about the axis, ahead) to (right, up, ahead).
    let turned = |along: f64, about: f64| if upright { DVec2::new(about, along) } else { DVec2::new(along, about) };
    let bump_position = turned(along, turn * angle);
    match cylinder_type {
        1 | 2 => LocalRay::from_eye(turned(along, sin).extend(cos), bump_position),
        _ => LocalRay { origin: turned(along, 0.0), dir: turned(0.0, sin).extend(cos), bump_position },
    }
}
