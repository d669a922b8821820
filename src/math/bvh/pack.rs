//! A few triangles with common corners, which are tested against a ray at once.

use crate::math::{DVec2, Sheared};
use glam::Vec3;
use std::array::from_fn;
use std::ops::Range;

/// Maximum number of corners, and of triangles, in a pack of a BVH.
const MANY: usize = 8;
/// Number of triangles of a pack that are tested at once.
const HALF: usize = 4;

/// Pack of up to eight triangles of a BVH: two cache lines.
#[derive(Clone, Debug, PartialEq)]
#[repr(align(64))]
pub(super) struct Pack {
    /// Coordinates x, y and z of all corners of the pack.
    corners: [[f32; MANY]; 3],
    /// Indices of the first, second and third corners of the pack's triangles.
    numbers: [[[u8; HALF]; 2]; 3],
    first: u32,
    count: u32,
}

/// Results of the ray test for half a pack of triangles: a number for each triangle.
pub(super) struct Areas {
    /// Mask of the pack's triangles that the ray hits, a bit for each.
    mask: u32,
    /// Twice the signed areas between the ray and each side of the pack's triangles.
    areas: [[f64; HALF]; 3],
    /// Depths of the triangles' corners along the longest axis of the ray's direction.
    depths: [[f64; HALF]; 3],
}

impl Pack {
    /// True if triangles with these vertices, given by their numbers in `vertices`, fit into a pack.
    pub fn fit_in_pack(triangles: impl Iterator<Item = [u32; 3]>, vertices: &[Vec3]) -> bool {
        let mut corners = Corners::default();
        triangles.flatten().all(|vertex| corners.find_or_add(vertex, vertices).is_some())
    }

    /// Packs the triangles with these indices, for which [`Pack::fit_in_pack`] must be true. `triangle` returns the numbers of
    /// a triangle's vertices.
    pub fn new(indices: Range<u32>, triangle: impl Fn(u32) -> [u32; 3], vertices: &[Vec3]) -> Self {
        let mut corners = Corners::default();
        let mut numbers = [[[0; HALF]; 2]; 3];
        for (lane, index) in indices.clone().enumerate().take(MANY) {
            for (numbers, vertex) in numbers.iter_mut().zip(triangle(index)) {
                numbers[lane / HALF][lane % HALF] = corners.find_or_add(vertex, vertices).unwrap_or_default();
            }
        }
        let corners = from_fn(|axis| corners.positions.map(|p| p[axis]));
        Self { corners, numbers, first: indices.start, count: indices.end - indices.start }
    }

    /// Returns the indices of the pack's halves that are not empty.
    #[inline(always)]
    pub fn used_halves(&self) -> Range<usize> {
        0..(self.count as usize).div_ceil(HALF)
    }

    /// Returns index, t, and the barycentric weights of the second and third corner of a triangle that the ray hits,
    /// and removes the triangle from `found`.
    #[inline(always)]
    pub fn take_next_hit(&self, line: &Sheared, half: usize, found: &mut Areas) -> Option<(u32, f64, DVec2)> {
        while found.mask != 0 {
            let i = found.mask.trailing_zeros() as usize % HALF;
            found.mask &= found.mask - 1;
            let [u, v, w] = [found.areas[0][i], found.areas[1][i], found.areas[2][i]];
            let det = u + v + w;
            if det != 0.0 {
                let [a, b, c] = [found.depths[0][i], found.depths[1][i], found.depths[2][i]];
                let t = line.shear.z * (u * a + v * b + w * c) / det;
                return Some((self.first + (HALF * half + i) as u32, t, DVec2::new(v, w) / det));
            }
        }
        None
    }

    /// Mask of the triangles in half a pack, a bit for each.
    #[inline(always)]
    fn used_mask(&self, half: usize) -> u32 {
        ((1 << self.count) - 1) >> (HALF * half) & ((1 << HALF) - 1)
    }
}

/// Tests half a pack of triangles as [`Sheared::intersect`] tests one triangle: the portable implementation.
#[inline(always)]
pub(super) fn test_half_pack(pack: &Pack, line: &Sheared, half: usize) -> Areas {
    let (mut areas, mut depths, mut mask) = ([[0.0; HALF]; 3], [[0.0; HALF]; 3], 0);
    for i in 0..HALF {
        let [a, b, c] = pack.numbers.each_ref().map(|numbers| {
            let number = usize::from(numbers[half % 2][i]) % MANY;
            line.shear_reordered_corner(line.axes.map(|axis| pack.corners[axis % 3][number].into()))
        });
        let found = Sheared::doubled_signed_areas(a, b, c);
        mask |= u32::from(Sheared::have_equal_signs(found)) << i;
        (0..3).for_each(|k| (areas[k][i], depths[k][i]) = (found[k], [a, b, c][k].z));
    }
    Areas { mask: mask & pack.used_mask(half), areas, depths }
}

/// Test of half a pack of triangles for AVX2, with four numbers at once: the same operations in the same order, and
/// none are fused. (Without closures: the functions of the standard library that call them are compiled without AVX2, and
/// cannot always inline them.)
#[cfg(target_arch = "x86_64")]
pub(super) mod avx2 {
    use super::{Areas, HALF, MANY, Pack, Sheared};
    use glam::Vec4;
    use std::arch::x86_64::*;

    /// Sheared x, y and z of a corner of each of four triangles.
    type Corner = [__m256d; 3];

    #[target_feature(enable = "avx2")]
    #[inline]
    fn load(values: &[f32; MANY]) -> __m256 {
        let (first, second) = (Vec4::from_slice(values), Vec4::from_slice(&values[HALF..]));
        _mm256_setr_m128(first.into(), second.into())
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn store(v: __m256d) -> [f64; HALF] {
        let [low, high] = [_mm256_castpd256_pd128(v), _mm256_extractf128_pd::<1>(v)];
        [
            _mm_cvtsd_f64(low),
            _mm_cvtsd_f64(_mm_unpackhi_pd(low, low)),
            _mm_cvtsd_f64(high),
            _mm_cvtsd_f64(_mm_unpackhi_pd(high, high)),
        ]
    }

    /// Computes the component of a × b along the ray for four triangles.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn cross_along_ray(a: &Corner, b: &Corner) -> __m256d {
        _mm256_sub_pd(_mm256_mul_pd(a[0], b[1]), _mm256_mul_pd(a[1], b[0]))
    }

    /// A ray for the test of triangles, with each number in all lanes.
    struct Line {
        /// Origin of the ray, with its axes in the order of the shear.
        from: Corner,
        /// Shear of x and of y.
        lean: [__m256d; 2],
    }

    /// Returns the sheared corners with these numbers in the pack; `values` are the coordinates of its corners.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn sheared_corner(values: &[__m256; 3], numbers: [u8; HALF], line: &Line) -> Corner {
        let numbers = _mm256_cvtepu8_epi32(_mm_cvtsi32_si128(i32::from_le_bytes(numbers)));
        let (x, y, z) = (
            relative_coordinate(values[0], numbers, line.from[0]),
            relative_coordinate(values[1], numbers, line.from[1]),
            relative_coordinate(values[2], numbers, line.from[2]),
        );
        [_mm256_sub_pd(x, _mm256_mul_pd(line.lean[0], z)), _mm256_sub_pd(y, _mm256_mul_pd(line.lean[1], z)), z]
    }

    /// Returns one coordinate of four corners, less that of the ray's origin.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn relative_coordinate(values: __m256, numbers: __m256i, from: __m256d) -> __m256d {
        let at = _mm256_castps256_ps128(_mm256_permutevar8x32_ps(values, numbers));
        _mm256_sub_pd(_mm256_cvtps_pd(at), from)
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    pub fn test_half_pack(pack: &Pack, line: &Sheared, half: usize) -> Areas {
        let [i, j, k] = line.axes;
        let values = [load(&pack.corners[i % 3]), load(&pack.corners[j % 3]), load(&pack.corners[k % 3])];
        let wide = Line {
            from: [_mm256_set1_pd(line.from.x), _mm256_set1_pd(line.from.y), _mm256_set1_pd(line.from.z)],
            lean: [_mm256_set1_pd(line.shear.x), _mm256_set1_pd(line.shear.y)],
        };
        let (a, b, c) = (
            sheared_corner(&values, pack.numbers[0][half % 2], &wide),
            sheared_corner(&values, pack.numbers[1][half % 2], &wide),
            sheared_corner(&values, pack.numbers[2][half % 2], &wide),
        );
        let (u, v, w) = (cross_along_ray(&c, &b), cross_along_ray(&a, &c), cross_along_ray(&b, &a));
        let least = _mm256_min_pd(_mm256_min_pd(u, v), w);
        let most = _mm256_max_pd(_mm256_max_pd(u, v), w);
        let zero = _mm256_setzero_pd();
        let within = _mm256_or_pd(_mm256_cmp_pd::<_CMP_GE_OQ>(least, zero), _mm256_cmp_pd::<_CMP_LE_OQ>(most, zero));
        Areas {
            mask: _mm256_movemask_pd(within) as u32 & pack.used_mask(half),
            areas: [store(u), store(v), store(w)],
            depths: [store(a[2]), store(b[2]), store(c[2])],
        }
    }
}

/// Corners of a pack's triangles, each position once.
#[derive(Default)]
struct Corners {
    /// Number of a vertex at each corner; vertices with other numbers can be at the same position.
    vertices: [u32; MANY],
    positions: [Vec3; MANY],
    count: usize,
}

impl Corners {
    /// Returns the number of the corner at the position of a vertex, which is added if it is new; `None` if the pack is full.
    fn find_or_add(&mut self, vertex: u32, vertices: &[Vec3]) -> Option<u8> {
        let known = &self.vertices[..self.count];
        if let Some(corner) = known.iter().position(|other| *other == vertex) {
            return Some(corner as u8);
        }
        let position = vertices[vertex as usize];
        if let Some(corner) = self.positions[..self.count].iter().position(|other| *other == position) {
            return Some(corner as u8);
        }
        *self.vertices.get_mut(self.count)? = vertex;
        self.positions[self.count] = position;
        self.count += 1;
        Some(self.count as u8 - 1)
    }
}
