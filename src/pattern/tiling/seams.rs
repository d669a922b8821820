//! What some tilings show on a line through the origin (measured on POV-Ray 3.7): neither of the tiles beside it, or one of them as it
//! is nowhere else. All of a surface lies on z = 0 where `uv_mapping` hands its (u, v, 0) to a tiling, which looks at x and z.

use crate::math::DVec2;

/// The number of the tiling where that is not the one that its tiles have, of which `value` is.
pub fn value_on_seam(number: usize, p: DVec2, value: f64) -> Option<f64> {
    let (on_x, along) = (p.y == 0.0, p.x.rem_euclid(7.0));
    match number {
        // Up is down there.
        3 if p.x == p.x.trunc() => Some(if value > 0.5 { value - 0.5 } else { value + 0.5 }),
        // (Shown as 1/3; a `frequency` tells what it is.)
        12 if p.x % 6.0 == 0.0 || p.y % 6.0 == 0.0 => Some(7.0 / 3.0),
        13 | 14 if on_x => Some(0.0),
        19 if on_x && ((2.5..3.0).contains(&along) || (4.0..5.0).contains(&along)) => Some(2.0 / 3.0),
        20 if on_x && (4.0..7.0).contains(&along) => Some(2.0 / 3.0),
        _ => None,
    }
}
