//! [`super::value`] for processors that compute four numbers at once (AVX2). The operations are those of the plain code in the same
//! order, and none are fused: so pictures have the same bytes on every machine.

use super::super::DVec3;
use super::lattice::ease;
use super::tables::{CORNERS, Row};
use super::value::{LANES, corners};
use std::arch::x86_64::*;

#[target_feature(enable = "avx2")]
#[inline]
fn load(&Row([a, b, c, d]): &Row) -> __m256d {
    _mm256_setr_pd(a, b, c, d)
}

/// sum + g·x
#[target_feature(enable = "avx2")]
#[inline]
fn add(sum: __m256d, g: __m256d, x: __m256d) -> __m256d {
    _mm256_add_pd(sum, _mm256_mul_pd(g, x))
}

#[target_feature(enable = "avx2")]
#[inline]
fn lerp(a: __m256d, b: __m256d, s: __m256d) -> __m256d {
    add(a, s, _mm256_sub_pd(b, a))
}

/// What four corners with one z suggest; a lane for each corner. `x` and `y` are from each corner to the point.
#[target_feature(enable = "avx2")]
#[inline]
fn side(hashes: &[usize; 4], x: __m256d, y: __m256d, z: f64) -> __m256d {
    let [r0, r1, r2, r3] = [0, 1, 2, 3].map(|i: usize| load(&CORNERS[hashes[i] & 0xff]));
    // Rows of v, gx, gy, gz become columns.
    let (a, b) = (_mm256_unpacklo_pd(r0, r1), _mm256_unpackhi_pd(r0, r1));
    let (c, d) = (_mm256_unpacklo_pd(r2, r3), _mm256_unpackhi_pd(r2, r3));
    let (v, gx) = (_mm256_permute2f128_pd::<0x20>(a, c), _mm256_permute2f128_pd::<0x20>(b, d));
    let (gy, gz) = (_mm256_permute2f128_pd::<0x31>(a, c), _mm256_permute2f128_pd::<0x31>(b, d));
    add(add(add(v, gx, x), gy, y), gz, _mm256_set1_pd(z))
}

/// [`super::value::scalar`]
#[target_feature(enable = "avx2")]
#[inline]
pub fn scalar(p: DVec3) -> f64 {
    let (hashes, [tx, ty, tz]) = corners(p);
    let (x, y) = (_mm256_setr_pd(tx, tx - 1.0, tx, tx - 1.0), _mm256_setr_pd(ty, ty, ty - 1.0, ty - 1.0));
    let (near, far) = (side(&hashes[0], x, y, tz), side(&hashes[1], x, y, tz - 1.0));
    // Corners 0, 4, 2, 6 and their neighbours along x.
    let along_x = lerp(_mm256_unpacklo_pd(near, far), _mm256_unpackhi_pd(near, far), _mm256_set1_pd(ease(tx)));
    let (low, high) = (_mm256_castpd256_pd128(along_x), _mm256_extractf128_pd::<1>(along_x));
    let along_y = _mm_add_pd(low, _mm_mul_pd(_mm_set1_pd(ease(ty)), _mm_sub_pd(high, low)));
    let (a, b) = (_mm_cvtsd_f64(along_y), _mm_cvtsd_f64(_mm_unpackhi_pd(along_y, along_y)));
    a + ease(tz) * (b - a)
}

/// [`super::value::vector`]
#[target_feature(enable = "avx2")]
#[inline]
pub fn vector(p: DVec3) -> DVec3 {
    let (hashes, t) = corners(p);
    let near = t.map(|t| _mm256_set1_pd(t));
    let far = t.map(|t| _mm256_set1_pd(t - 1.0));
    let along = |axis: usize, i: usize| if i >> axis & 1 == 1 { far[axis] } else { near[axis] };
    let corner = |i: usize| {
        let [v, gx, gy, gz] = &LANES[hashes[i >> 2][i & 3] & 0xff];
        let (v, gx, gy, gz) = (load(v), load(gx), load(gy), load(gz));
        add(add(add(v, gx, along(0, i)), gy, along(1, i)), gz, along(2, i))
    };
    let [sx, sy, sz] = t.map(|t| _mm256_set1_pd(ease(t)));
    let along_x = |i: usize| lerp(corner(i), corner(i + 1), sx);
    let sum = lerp(lerp(along_x(0), along_x(2), sy), lerp(along_x(4), along_x(6), sy), sz);
    let (xy, z) = (_mm256_castpd256_pd128(sum), _mm256_extractf128_pd::<1>(sum));
    DVec3::new(_mm_cvtsd_f64(xy), _mm_cvtsd_f64(_mm_unpackhi_pd(xy, xy)), _mm_cvtsd_f64(z))
}
