//! Cells and interpolation of both lattice noises.

/// The number 1.5·2⁵²: adding it to an `f64` rounds to the nearest integer and leaves its two's complement in the low
/// bits, without call or branch.
pub const ROUND: f64 = 6_755_399_441_055_744.0;

/// Returns the index of the lattice cell that contains a coordinate (exact in its low bits for any coordinate below
/// 2⁵¹), and the position in the cell, 0 to 1.
#[inline(always)]
pub fn lattice_cell_and_position(x: f64) -> (usize, f64) {
    let rounded = x + ROUND;
    let nearest = rounded - ROUND;
    let above = nearest > x;
    let floor = nearest - f64::from(u8::from(above));
    ((rounded.to_bits() as usize).wrapping_sub(usize::from(above)), x - floor)
}

/// The s-curve 3t² - 2t³ (Perlin 1985).
#[inline(always)]
pub fn s_curve(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}

/// Linear interpolation between a and b.
#[inline(always)]
fn lerp(a: f64, b: f64, s: f64) -> f64 {
    a + s * (b - a)
}

/// Interpolates the contributions of a lattice cell's corners at the point `t` of the cell. Corner i is at x = bit 0, y
/// = bit 1, z = bit 2 of i.
#[inline(always)]
pub fn blend_corners(corners: [f64; 8], t: [f64; 3]) -> f64 {
    let [sx, sy, sz] = t.map(s_curve);
    let x = |i: usize| lerp(corners[i], corners[i + 1], sx);
    lerp(lerp(x(0), x(2), sy), lerp(x(4), x(6), sy), sz)
}

/// Returns the vector from corner i of a lattice cell to the point `t` of the cell.
#[inline(always)]
pub fn offset_from_corner(i: usize, t: [f64; 3]) -> [f64; 3] {
    let along = |axis: usize| if i >> axis & 1 == 1 { t[axis] - 1.0 } else { t[axis] };
    [along(0), along(1), along(2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_floors() {
        for x in [0.0, 0.5, 1.0, -0.5, -1.0, 2.5, 3.5, -2.5, 1e9 + 0.75, -1e9 - 0.25, -1e-18, 4095.999] {
            let (number, t) = lattice_cell_and_position(x);
            assert_eq!((number & 0xfff) as i64, (x.floor() as i64).rem_euclid(4096), "{x}");
            assert_eq!(t, x - x.floor(), "{x}");
        }
    }

    #[test]
    fn corners_keep_their_values() {
        let values = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
        for (i, value) in values.into_iter().enumerate() {
            assert_eq!(blend_corners(values, [0, 1, 2].map(|axis| f64::from((i >> axis & 1) as u8))), value);
        }
    }
}
