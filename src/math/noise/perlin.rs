//! The noise of generator 3: each lattice point has a gradient of length 1 (Perlin 1985; the version with an additive
//! permutation in Ebert et al., "Texturing and Modeling").

use super::super::DVec3;
use super::lattice::{blend_corners, lattice_cell_and_position, offset_from_corner};
use super::tables::{GRADIENTS, PERMUTATION};

/// Number that noise generator 3 adds to each coordinate: the lattice points are thus just below the integers, and
/// coordinates are rounded to 2⁻²⁹.
pub(super) const OFFSET: f64 = 10_000_000.023157213;

/// Returns the noise of generator 3 before its range is mapped: about -0.76 to 0.76, and 0 at each lattice point.
#[inline(always)]
pub fn scalar_noise(p: DVec3) -> f64 {
    let ((ix, tx), (iy, ty), (iz, tz)) = (
        lattice_cell_and_position(p.x + OFFSET),
        lattice_cell_and_position(p.y + OFFSET),
        lattice_cell_and_position(p.z + OFFSET),
    );
    let t = [tx, ty, tz];
    let permuted = |i: usize| PERMUTATION[i & 0x7ff] as usize;
    let (px, qx) = (permuted(ix), permuted(ix.wrapping_add(1)));
    let y = iy & 0x7ff;
    let xy = [permuted(px + y), permuted(qx + y), permuted(px + y + 1), permuted(qx + y + 1)];
    let corner = |i: usize| {
        // The gradients of corners with neighbouring z are adjacent; the first follows the last.
        let ([x, y, z], [gx, gy, gz]) =
            (offset_from_corner(i, t), GRADIENTS[(xy[i & 3].wrapping_add(iz) & 0x7ff) + (i >> 2)]);
        gx * x + gy * y + gz * z
    };
    blend_corners([corner(0), corner(1), corner(2), corner(3), corner(4), corner(5), corner(6), corner(7)], t)
}
