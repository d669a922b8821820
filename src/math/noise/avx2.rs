//! [`super::value`] for AVX2, with four numbers at once: the operations of the portable code in the same order, and
//! none are fused, so that pictures have the same bytes on every machine.

#![expect(clippy::extra_unused_type_parameters, reason = "each caller has a copy of its own: see `super::wide`")]

use super::super::DVec3;
use super::lattice::ROUND;
use super::tables::{CORNERS, Row, RowStart};
use super::value::{corner_rows, vector_rows};
use std::arch::x86_64::*;

#[target_feature(enable = "avx2")]
#[inline]
fn load_row(&Row([a, b, c, d]): &Row) -> __m256d {
    _mm256_setr_pd(a, b, c, d)
}

/// Returns sum + g·x for each of the four lanes.
#[target_feature(enable = "avx2")]
#[inline]
fn multiply_add(sum: __m256d, g: __m256d, x: __m256d) -> __m256d {
    _mm256_add_pd(sum, _mm256_mul_pd(g, x))
}

#[target_feature(enable = "avx2")]
#[inline]
fn lerp(a: __m256d, b: __m256d, s: __m256d) -> __m256d {
    multiply_add(a, s, _mm256_sub_pd(b, a))
}

/// A point or another vector: x, y and z in the first three lanes, and 0.
pub type Vector = __m256d;

/// Returns a vector with these components.
#[target_feature(enable = "avx2")]
#[inline]
pub fn vector(x: f64, y: f64, z: f64) -> Vector {
    _mm256_setr_pd(x, y, z, 0.0)
}

/// Returns the product of a number and a vector.
#[target_feature(enable = "avx2")]
#[inline]
pub fn times(factor: f64, v: Vector) -> Vector {
    _mm256_mul_pd(_mm256_set1_pd(factor), v)
}

/// Returns the sum of two vectors.
#[target_feature(enable = "avx2")]
#[inline]
pub fn plus(a: Vector, b: Vector) -> Vector {
    _mm256_add_pd(a, b)
}

/// Returns the components of a vector.
#[target_feature(enable = "avx2")]
#[inline]
pub fn components(v: Vector) -> DVec3 {
    let (xy, z) = (_mm256_castpd256_pd128(v), _mm256_extractf128_pd::<1>(v));
    DVec3::new(_mm_cvtsd_f64(xy), _mm_cvtsd_f64(_mm_unpackhi_pd(xy, xy)), _mm_cvtsd_f64(z))
}

/// A point in the lattice of the noise.
#[derive(Clone, Copy)]
pub struct LatticePoint {
    /// Table rows of the corners of the lattice cell that contains the point.
    rows: [RowStart; 8],
    /// Position of the point in the cell, 0 to 1 along each axis.
    t: Vector,
}

/// Finds the lattice cell that contains a point: [`super::lattice::lattice_cell_and_position`] of all coordinates at
/// once.
#[target_feature(enable = "avx2")]
#[inline]
pub fn locate<Caller>(p: Vector) -> LatticePoint {
    let round = _mm256_set1_pd(ROUND);
    let rounded = _mm256_add_pd(p, round);
    let nearest = _mm256_sub_pd(rounded, round);
    // All bits set, which is -1, where rounding went up.
    let above = _mm256_cmp_pd::<_CMP_GT_OQ>(nearest, p);
    let floor = _mm256_sub_pd(nearest, _mm256_and_pd(above, _mm256_set1_pd(1.0)));
    let cells = _mm256_add_epi64(_mm256_castpd_si256(rounded), _mm256_castpd_si256(above));
    let [x, y, z] =
        [_mm256_extract_epi64::<0>(cells), _mm256_extract_epi64::<1>(cells), _mm256_extract_epi64::<2>(cells)];
    LatticePoint { rows: corner_rows([x as usize, y as usize, z as usize]), t: _mm256_sub_pd(p, floor) }
}

/// Computes the s-curve of [`super::lattice::s_curve`] in each lane.
#[target_feature(enable = "avx2")]
#[inline]
fn s_curve(t: __m256d) -> __m256d {
    let falling = _mm256_sub_pd(_mm256_set1_pd(3.0), _mm256_mul_pd(_mm256_set1_pd(2.0), t));
    _mm256_mul_pd(_mm256_mul_pd(t, t), falling)
}

/// Copies x, y and z of a vector, each to all lanes.
#[target_feature(enable = "avx2")]
#[inline]
fn broadcast_components(v: __m256d) -> [__m256d; 3] {
    [_mm256_permute4x64_pd::<0x00>(v), _mm256_permute4x64_pd::<0x55>(v), _mm256_permute4x64_pd::<0xaa>(v)]
}

/// Returns the value of a lattice point and its three slopes, each times its coordinate from the lattice point; `near` and
/// `far` are (1, x, y, z) from the first and the last corner of the cell. FAR is a bit for each lane that is taken from
/// `far`: twice the number of the corner.
#[target_feature(enable = "avx2")]
#[inline]
fn corner_contributions<const FAR: i32>(rows: &[RowStart; 8], near: __m256d, far: __m256d) -> __m256d {
    let row = load_row(rows[FAR as usize / 2].row_after::<0, _>(&CORNERS));
    _mm256_mul_pd(row, _mm256_blend_pd::<FAR>(near, far))
}

/// Computes [`super::value::scalar_noise`] with AVX2.
#[target_feature(enable = "avx2")]
#[inline]
pub fn scalar_noise<Caller>(LatticePoint { rows, t }: LatticePoint) -> f64 {
    let near = _mm256_blend_pd::<1>(_mm256_permute4x64_pd::<0x93>(t), _mm256_set1_pd(1.0));
    let far = _mm256_sub_pd(near, _mm256_setr_pd(0.0, 1.0, 1.0, 1.0));
    let [sx, sy, sz] = broadcast_components(s_curve(t));
    let along_x = [
        lerp(corner_contributions::<0>(&rows, near, far), corner_contributions::<2>(&rows, near, far), sx),
        lerp(corner_contributions::<4>(&rows, near, far), corner_contributions::<6>(&rows, near, far), sx),
        lerp(corner_contributions::<8>(&rows, near, far), corner_contributions::<10>(&rows, near, far), sx),
        lerp(corner_contributions::<12>(&rows, near, far), corner_contributions::<14>(&rows, near, far), sx),
    ];
    let sum = lerp(lerp(along_x[0], along_x[1], sy), lerp(along_x[2], along_x[3], sy), sz);
    // (value + x) + (y + z)
    let pairs = _mm_hadd_pd(_mm256_castpd256_pd128(sum), _mm256_extractf128_pd::<1>(sum));
    _mm_cvtsd_f64(_mm_add_sd(pairs, _mm_unpackhi_pd(pairs, pairs)))
}

/// Computes [`super::value::vector_noise`] with AVX2.
#[target_feature(enable = "avx2")]
#[inline]
pub fn vector_noise<Caller>(LatticePoint { rows, t }: LatticePoint) -> Vector {
    // Twice the coordinates, so that values need no halving: the sum is halved instead, which rounds nothing.
    let twice = |v: __m256d| broadcast_components(_mm256_add_pd(v, v));
    let (near, far) = (twice(t), twice(_mm256_sub_pd(t, _mm256_set1_pd(1.0))));
    let along = |axis: usize, i: usize| if i >> axis & 1 == 1 { far[axis] } else { near[axis] };
    let corner = |i: usize| {
        let [v, gx, gy, gz] = vector_rows(rows[i]).map(|row| load_row(row));
        multiply_add(multiply_add(multiply_add(v, gx, along(0, i)), gy, along(1, i)), gz, along(2, i))
    };
    let [sx, sy, sz] = broadcast_components(s_curve(t));
    let along_x = |i: usize| lerp(corner(i), corner(i + 1), sx);
    let twice_sum = lerp(lerp(along_x(0), along_x(2), sy), lerp(along_x(4), along_x(6), sy), sz);
    _mm256_mul_pd(twice_sum, _mm256_set1_pd(0.5))
}
