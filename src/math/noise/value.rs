//! The noise of generators 1 and 2, and the vector noise: each lattice point has a value and a gradient.

use super::super::DVec3;
use super::lattice::{blend, cell, from_corner};
use super::tables::{CORNERS, HASH};

/// POV-Ray adds 10000 to the number of a cell before it looks it up.
const OFFSET: usize = 10_000;

/// A permutation of 4096 numbers.
#[inline]
fn hash(i: usize) -> usize {
    HASH[i & 0xfff] as usize
}

/// The hash of each corner of the cell, and where the point lies in the cell.
#[inline]
fn corners(p: DVec3) -> ([[usize; 4]; 2], [f64; 3]) {
    let ((ix, tx), (iy, ty), (iz, tz)) = (cell(p.x), cell(p.y), cell(p.z));
    let sides = |i: usize| [i.wrapping_add(OFFSET), i.wrapping_add(OFFSET + 1)];
    let ([x0, x1], [y0, y1], [z0, z1]) = (sides(ix), sides(iy), sides(iz));
    // The permutation is applied in turn to x, y and z (Perlin 1985).
    let (a, b) = (hash(x0), hash(x1));
    let [c, d, e, f] = [a ^ y0, b ^ y0, a ^ y1, b ^ y1].map(hash);
    let above = |z| [hash(c ^ z), hash(d ^ z), hash(e ^ z), hash(f ^ z)];
    ([above(z0), above(z1)], [tx, ty, tz])
}

/// One component of the noise, for the corners with these hashes.
#[inline]
fn component<const SHIFT: usize>(hashes: &[[usize; 4]; 2], t: [f64; 3]) -> f64 {
    let corner = |i: usize| {
        let ([x, y, z], [v, gx, gy, gz]) = (from_corner(i, t), CORNERS[(hashes[i >> 2][i & 3] & 0xff) + SHIFT]);
        v + gx * x + gy * y + gz * z
    };
    // Written out: `map` over eight corners takes twice the time.
    blend([corner(0), corner(1), corner(2), corner(3), corner(4), corner(5), corner(6), corner(7)], t)
}

/// The first component of [`vector`]; about -1.2 to 1.2.
pub fn scalar(p: DVec3) -> f64 {
    let (hashes, t) = corners(p);
    component::<0>(&hashes, t)
}

/// Three noises on the same lattice: each takes its values and gradients four entries further on in the table.
pub fn vector(p: DVec3) -> DVec3 {
    let (hashes, t) = corners(p);
    DVec3::new(component::<0>(&hashes, t), component::<4>(&hashes, t), component::<8>(&hashes, t))
}
