//! `cylinder N`: on a cylinder about the axis that goes up (types 1 and 3) or across (2 and 4); the eye stays in the middle (1 and 2) or
//! moves along the axis (3 and 4; manual, "Cylindrical").

use crate::math::{DVec2, DVec3, fp};

/// Where the ray begins, along right and up, and its direction, not normalised; `angle` is that about the axis.
pub(super) fn ray(kind: u8, at: DVec2, lengths: DVec3, angle: f64) -> (DVec2, Option<DVec3>) {
    let upright = matches!(kind, 1 | 3);
    let turn = if upright { at.x } else { at.y };
    let along = if upright { at.y * lengths.y } else { at.x * lengths.x };
    let (sin, cos) = fp::sin_cos(turn * angle);
    // (Along the axis, about it, ahead), turned to (right, up, ahead).
    let place = |along: f64, about: f64| if upright { DVec2::new(about, along) } else { DVec2::new(along, about) };
    match kind {
        1 | 2 => (DVec2::ZERO, Some(place(along, sin).extend(cos))),
        _ => (place(along, 0.0), Some(place(0.0, sin).extend(cos))),
    }
}
