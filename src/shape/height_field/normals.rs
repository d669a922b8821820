//! Normals at the corners of a smooth height field, each computed at its first use.

use super::grid::Grid;
use crate::math::DVec3;
use std::sync::atomic::{AtomicU64, Ordering};

/// Flag of a height field's normal that is already computed.
const KNOWN: u64 = 1 << 48;

/// Normals of a height field: three coordinates of 16 bits for each corner, row by row (quirk: `height_field_normals`).
#[derive(Debug)]
pub struct Normals(Box<[AtomicU64]>);

impl Normals {
    /// Allocates memory for the normals of this number of corners.
    pub fn new(count: usize) -> Self {
        Self((0..count).map(|_| AtomicU64::new(0)).collect())
    }

    /// Returns the height field's normal at a corner in object space, with a length of about 32767 steps. Any thread
    /// may compute it first; all compute the same.
    pub fn unnormalized_normal_at(&self, grid: &Grid, column: usize, row: usize) -> DVec3 {
        let kept = &self.0[row * (grid.across + 1) + column];
        let mut packed = kept.load(Ordering::Relaxed);
        if packed == 0 {
            packed = KNOWN | pack_normal(mean_normal(grid, column, row));
            kept.store(packed, Ordering::Relaxed);
        }
        unpack_unnormalized_normal(packed)
    }
}

/// Mean of the normals that a height field's corner has towards its neighbours on each side, in cells and steps (quirk:
/// `height_field_normals`).
fn mean_normal(grid: &Grid, column: usize, row: usize) -> DVec3 {
    let here = grid.corner_height_in_steps(column, row);
    let left = (column > 0).then(|| here - grid.corner_height_in_steps(column - 1, row));
    let right = (column < grid.across).then(|| grid.corner_height_in_steps(column + 1, row) - here);
    let before = (row > 0).then(|| here - grid.corner_height_in_steps(column, row - 1));
    let behind = (row < grid.deep).then(|| grid.corner_height_in_steps(column, row + 1) - here);
    let mut sum = DVec3::ZERO;
    for along_x in [left, right].into_iter().flatten() {
        for along_z in [before, behind].into_iter().flatten() {
            sum += DVec3::new(-along_x, 1.0, -along_z).normalize_or_zero();
        }
    }
    sum.normalize_or_zero()
}

fn pack_normal(n: DVec3) -> u64 {
    let [x, y, z] = (n * 32767.0).to_array().map(|c| u64::from((c as i16).cast_unsigned()));
    x | y << 16 | z << 32
}

fn unpack_unnormalized_normal(packed: u64) -> DVec3 {
    let at = |bits: u32| f64::from(((packed >> bits) as u16).cast_signed());
    DVec3::new(at(0), at(16), at(32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_lose_what_is_behind_the_point() {
        let n = DVec3::new(-0.6, 0.0, 0.8);
        assert_eq!(unpack_unnormalized_normal(pack_normal(n)), (n * 32767.0).trunc());
    }

    #[test]
    fn kept_normals_are_those_of_planes() {
        // Heights of 3 i + 2 k
        let grid = Grid::new(4, (0..16).map(|at| 3 * (at % 4) + 2 * (at / 4)).collect());
        let normals = Normals::new(16);
        let expected = (DVec3::new(-3.0, 1.0, -2.0).normalize() * 32767.0).trunc();
        for (i, k) in [(0, 0), (3, 3), (1, 2), (1, 2)] {
            assert_eq!(normals.unnormalized_normal_at(&grid, i, k), expected);
        }
    }
}
