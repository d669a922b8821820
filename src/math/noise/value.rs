//! The noise of generators 1 and 2, and the vector noise: each lattice point has a value and a gradient.

use super::super::DVec3;
use super::lattice::{blend, cell, from_corner};
use super::tables::{CORNERS, HASH};

/// POV-Ray adds 10000 to the number of a cell before it looks it up.
const OFFSET: usize = 10_000;

/// Which row of [`CORNERS`] belongs to each corner of the cell, and where the point lies in the cell.
#[inline]
fn corners(p: DVec3) -> ([usize; 8], [f64; 3]) {
    let ((ix, tx), (iy, ty), (iz, tz)) = (cell(p.x), cell(p.y), cell(p.z));
    let at = |i: usize, corner: usize| i.wrapping_add(OFFSET + corner);
    // A permutation of 4096 numbers, applied in turn to x, y and z (Perlin 1985).
    let hash = |i: usize| HASH[i & 0xfff] as usize;
    let hx = [hash(at(ix, 0)), hash(at(ix, 1))];
    let hxy = [hx[0] ^ at(iy, 0), hx[1] ^ at(iy, 0), hx[0] ^ at(iy, 1), hx[1] ^ at(iy, 1)].map(hash);
    let row = |i: usize| hash(hxy[i & 3] ^ at(iz, i >> 2)) & 0xff;
    ([row(0), row(1), row(2), row(3), row(4), row(5), row(6), row(7)], [tx, ty, tz])
}

/// One component of the noise, whose corners have these rows.
#[inline]
fn component(rows: [usize; 8], shift: usize, t: [f64; 3]) -> f64 {
    let mut values = [0.0; 8];
    for (i, (value, row)) in values.iter_mut().zip(rows).enumerate() {
        let ([x, y, z], [v, gx, gy, gz]) = (from_corner(i, t), CORNERS[row + shift]);
        *value = v + gx * x + gy * y + gz * z;
    }
    blend(values, t)
}

/// The first component of [`vector`].
pub fn scalar(p: DVec3) -> f64 {
    let (rows, t) = corners(p);
    component(rows, 0, t)
}

/// Three noises on the same lattice: each takes its values and gradients four entries further on in the table.
pub fn vector(p: DVec3) -> DVec3 {
    let (rows, t) = corners(p);
    DVec3::new(component(rows, 0, t), component(rows, 4, t), component(rows, 8, t))
}
