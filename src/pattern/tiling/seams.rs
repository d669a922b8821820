//! Numbers of some tilings on lines through the origin: neither of the adjacent tiles' numbers (quirk:
//! `tiling_joints`). `uv_mapping` hands (u, v, 0) to a tiling, which uses x and z: a whole surface is then on the line
//! z = 0.

use crate::math::DVec2;

/// Returns the number of a tiling on a seam between tiles; `None` where it is `value`, the number of the tiles.
pub fn value_on_seam(tiling_number: usize, p: DVec2, value: f64) -> Option<f64> {
    let (on_x, along) = (p.y == 0.0, p.x.rem_euclid(7.0));
    match tiling_number {
        // The two halves are exchanged there.
        3 if p.x == p.x.trunc() => Some(if value > 0.5 { value - 0.5 } else { value + 0.5 }),
        // (POV-Ray shows 1/3; a `frequency` reveals 7/3.)
        12 if p.x % 6.0 == 0.0 || p.y % 6.0 == 0.0 => Some(7.0 / 3.0),
        13 | 14 if on_x => Some(0.0),
        19 if on_x && ((2.5..3.0).contains(&along) || (4.0..5.0).contains(&along)) => Some(2.0 / 3.0),
        20 if on_x && (4.0..7.0).contains(&along) => Some(2.0 / 3.0),
        _ => None,
    }
}
