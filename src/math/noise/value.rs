//! The noise of generators 1 and 2, and the vector noise: each lattice point has a value and a gradient.

#![expect(clippy::extra_unused_type_parameters, reason = "each caller has a copy of its own: see `super::wide`")]

use super::super::DVec3;
use super::lattice::{lattice_cell_and_position, offset_from_corner, s_curve};
use super::tables::{CORNERS, HashIndex, Row, RowStart, table_entry};

/// Number that POV-Ray adds to the index of a lattice cell before the lookup of its hash.
const OFFSET: usize = 10_000;

/// Returns the table row of each corner of a lattice cell with these indices.
#[inline(always)]
pub(super) fn corner_rows([ix, iy, iz]: [usize; 3]) -> [RowStart; 8] {
    let sides = |i: usize| [OFFSET, OFFSET + 1].map(|offset| HashIndex::from_low_bits(i.wrapping_add(offset)));
    let ([x0, x1], [y0, y1], [z0, z1]) = (sides(ix), sides(iy), sides(iz));
    // The permutation is applied to x, y and z in turn (Perlin 1985).
    let (a, b) = (x0.hash(), x1.hash());
    let [c, d, e, f] = [a.xor(y0).hash(), b.xor(y0).hash(), a.xor(y1).hash(), b.xor(y1).hash()];
    [c.xor(z0), d.xor(z0), e.xor(z0), f.xor(z0), c.xor(z1), d.xor(z1), e.xor(z1), f.xor(z1)].map(HashIndex::row)
}

/// A point or another vector.
pub type Vector = DVec3;

/// Returns a vector with these components.
#[inline(always)]
pub fn vector(x: f64, y: f64, z: f64) -> Vector {
    DVec3::new(x, y, z)
}

/// Returns the product of a number and a vector.
#[inline(always)]
pub fn times(factor: f64, v: Vector) -> Vector {
    factor * v
}

/// Returns the sum of two vectors.
#[inline(always)]
pub fn plus(a: Vector, b: Vector) -> Vector {
    a + b
}

/// Returns the components of a vector.
#[inline(always)]
pub fn components(v: Vector) -> DVec3 {
    v
}

/// A point in the lattice of the noise.
#[derive(Clone, Copy)]
pub struct LatticePoint {
    /// Table rows of the corners of the lattice cell that contains the point.
    rows: [RowStart; 8],
    /// Position of the point in the cell, 0 to 1 along each axis.
    t: [f64; 3],
}

/// Finds the lattice cell that contains a point.
#[inline(always)]
pub fn locate<Caller>(p: Vector) -> LatticePoint {
    let ((ix, tx), (iy, ty), (iz, tz)) =
        (lattice_cell_and_position(p.x), lattice_cell_and_position(p.y), lattice_cell_and_position(p.z));
    LatticePoint { rows: corner_rows([ix, iy, iz]), t: [tx, ty, tz] }
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
pub fn scalar_noise<Caller>(LatticePoint { rows, t }: LatticePoint) -> f64 {
    let corner = |i: usize| {
        let ([x, y, z], Row([v, gx, gy, gz])) = (offset_from_corner(i, t), *rows[i].row_after::<0, _>(&CORNERS));
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

/// Returns the rows of the vector noise at a lattice point: its values and the three coordinates of its gradients.
#[inline(always)]
pub(super) fn vector_rows(first: RowStart) -> [&'static Row; 4] {
    [
        first.row_after::<0, _>(&LANES),
        first.row_after::<1, _>(&LANES),
        first.row_after::<2, _>(&LANES),
        first.row_after::<3, _>(&LANES),
    ]
}

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
pub fn vector_noise<Caller>(LatticePoint { rows, t }: LatticePoint) -> Vector {
    let corner = |i: usize| {
        let [x, y, z] = offset_from_corner(i, t);
        let [v, gx, gy, gz] = vector_rows(rows[i]).map(|row| row.0);
        let add = |sum: Lanes, g: Lanes, x: f64| lanewise(sum, g, |sum, g| sum + g * x);
        add(add(add(v.map(|v| 0.5 * v), gx, x), gy, y), gz, z)
    };
    let [x, y, z, _] = blend_lanes(corner, t);
    DVec3::new(x, y, z)
}
