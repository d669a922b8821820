//! The noise of generators 1 and 2, and the vector noise: each lattice point has a value and a gradient.

use super::super::DVec3;
use super::lattice::{lattice_cell_and_position, offset_from_corner, s_curve};
use super::tables::{CORNERS, HASH, Row, table_entry};

/// Number that POV-Ray adds to the index of a lattice cell before the lookup of its hash.
const OFFSET: usize = 10_000;

/// Hash of a lattice index: a permutation of 4096 numbers.
#[inline(always)]
fn hash_index(i: usize) -> usize {
    HASH[i & 0xfff] as usize
}

/// Returns the hash of each corner of a lattice cell with these indices.
#[inline(always)]
pub(super) fn corner_hashes([ix, iy, iz]: [usize; 3]) -> [[usize; 4]; 2] {
    let sides = |i: usize| [i.wrapping_add(OFFSET), i.wrapping_add(OFFSET + 1)];
    let ([x0, x1], [y0, y1], [z0, z1]) = (sides(ix), sides(iy), sides(iz));
    // The permutation is applied to x, y and z in turn (Perlin 1985).
    let (a, b) = (hash_index(x0), hash_index(x1));
    let [c, d, e, f] = [a ^ y0, b ^ y0, a ^ y1, b ^ y1].map(hash_index);
    let above = |z| [hash_index(c ^ z), hash_index(d ^ z), hash_index(e ^ z), hash_index(f ^ z)];
    [above(z0), above(z1)]
}

/// Returns the hash of each corner of the lattice cell that contains a point, and the point's position in the cell.
#[inline(always)]
fn corner_hashes_and_position(p: DVec3) -> ([[usize; 4]; 2], [f64; 3]) {
    let ((ix, tx), (iy, ty), (iz, tz)) =
        (lattice_cell_and_position(p.x), lattice_cell_and_position(p.y), lattice_cell_and_position(p.z));
    (corner_hashes([ix, iy, iz]), [tx, ty, tz])
}

/// Four numbers that the processor computes side by side.
type Lanes = [f64; 4];

#[inline(always)]
fn lanewise(a: Lanes, b: Lanes, f: impl Fn(f64, f64) -> f64) -> Lanes {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])]
}

#[inline(always)]
fn lerp(a: Lanes, b: Lanes, s: f64) -> Lanes {
    lanewise(a, b, |a, b| a + s * (b - a))
}

/// Interpolates the contributions of a lattice cell's corners, lane by lane, at the point `t` of the cell.
#[inline(always)]
fn blend_lanes(corner: impl Fn(usize) -> Lanes, t: [f64; 3]) -> Lanes {
    let [sx, sy, sz] = t.map(s_curve);
    let along_x = |i: usize| lerp(corner(i), corner(i + 1), sx);
    lerp(lerp(along_x(0), along_x(2), sy), lerp(along_x(4), along_x(6), sy), sz)
}

/// Returns the noise of generators 1 and 2 before its range is mapped: the first component of [`vector_noise`], about
/// -1.2 to 1.2. The value and the three slopes of the lattice points are interpolated side by side and added last.
#[inline(always)]
pub fn scalar_noise<const CALLER: u8>(p: DVec3) -> f64 {
    let (hashes, t) = corner_hashes_and_position(p);
    let corner = |i: usize| {
        let ([x, y, z], Row([v, gx, gy, gz])) = (offset_from_corner(i, t), CORNERS[hashes[i >> 2][i & 3] & 0xff]);
        [v, gx * x, gy * y, gz * z]
    };
    let [v, x, y, z] = blend_lanes(corner, t);
    (v + x) + (y + z)
}

/// Table of noise with the entries of the three components of [`vector_noise`] side by side; the last lane is unused. A
/// lattice point's values are at its hash and are halved, its gradients' coordinates are at the next three entries. (A
/// row for each lattice point would need four times the memory, and not fit into the first-level cache beside the other
/// tables.)
pub(super) static LANES: [Row; 259] = lane_table();

/// Computes the table of vector noise: each component takes its values and gradients four entries later in the table.
const fn lane_table() -> [Row; 259] {
    let mut out = [Row([0.0; 4]); 259];
    let mut i = 0;
    while i < 259 {
        out[i] = Row([table_entry(i), table_entry(i + 4), table_entry(i + 8), 0.0]);
        i += 1;
    }
    out
}

/// Returns the vector noise at a point: three noises on the same lattice, computed at once.
#[inline(always)]
pub fn vector_noise<const CALLER: u8>(p: DVec3) -> DVec3 {
    let (hashes, t) = corner_hashes_and_position(p);
    let corner = |i: usize| {
        let ([x, y, z], at) = (offset_from_corner(i, t), hashes[i >> 2][i & 3] & 0xff);
        let add = |sum: Lanes, place: usize, x: f64| lanewise(sum, LANES[at + place].0, |sum, g| sum + g * x);
        add(add(add(LANES[at].0.map(|v| 0.5 * v), 1, x), 2, y), 3, z)
    };
    let [x, y, z, _] = blend_lanes(corner, t);
    DVec3::new(x, y, z)
}
