//! Nodes with eight children, and the test of a ray against their boxes.

use super::flat_ray::FlatRay;
use glam::{Vec3A, Vec4};

/// Number of children of a BVH node.
pub(super) const WIDTH: usize = 8;

/// BVH node with eight children side by side; unused children have a box that no ray hits.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(64))]
pub(super) struct Wide {
    /// Planes of the children's boxes: `planes[0]` contains the lower ends along x, y, z, `planes[1]` the upper ones.
    pub planes: [[[Vec4; 2]; 3]; 2],
    pub child: [Child; WIDTH],
}

/// Child of a BVH node: index of a node, or the first item's index and the number of items.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Child(u32);

/// Decoded child of a BVH node.
pub(super) enum Kind {
    Node(usize),
    Items(std::ops::Range<usize>),
}

impl Child {
    /// Unused child of a BVH node: it has no items.
    pub const NONE: Child = Child(Self::LEAF);
    const LEAF: u32 = 1 << 31;
    const COUNT: u32 = 28;

    pub fn node(number: usize) -> Self {
        Child(number as u32)
    }

    /// Creates a child of a BVH node with at most seven items, whose indices are below 2²⁸.
    pub fn items(first: usize, count: usize) -> Self {
        Child(Self::LEAF | (count as u32) << Self::COUNT | first as u32)
    }

    #[inline]
    pub fn kind(self) -> Kind {
        if self.0 < Self::LEAF {
            return Kind::Node(self.0 as usize);
        }
        let first = (self.0 & ((1 << Self::COUNT) - 1)) as usize;
        Kind::Items(first..first + (self.0 >> Self::COUNT & 7) as usize)
    }
}

impl Wide {
    pub const EMPTY: Wide =
        Wide { planes: [[[Vec4::INFINITY; 2]; 3], [[Vec4::NEG_INFINITY; 2]; 3]], child: [Child::NONE; WIDTH] };

    /// Maximum absolute coordinate of all planes of the BVH node.
    pub fn max_abs_coordinate(&self) -> f32 {
        let used = |plane: Vec4| Vec4::select(plane.is_finite_mask(), plane.abs(), Vec4::ZERO).max_element();
        self.planes.as_flattened().as_flattened().iter().map(|plane| used(*plane)).fold(0.0, f32::max)
    }

    pub fn set_child(&mut self, slot: usize, (lo, hi): (Vec3A, Vec3A), child: Child) {
        for axis in 0..3 {
            self.planes[0][axis][slot / 4][slot % 4] = lo[axis];
            self.planes[1][axis][slot / 4][slot % 4] = hi[axis];
        }
        self.child[slot] = child;
    }
}

/// Returns the children of a BVH node whose boxes a ray hits before `max`, as bits, and the values of `t` where it
/// enters them: the portable implementation.
#[inline]
pub(super) fn slabs(node: &Wide, ray: &FlatRay, max: f32) -> (u32, [f32; WIDTH]) {
    let (a, near_a) = half_slabs(node, ray, max, 0);
    let (b, near_b) = half_slabs(node, ray, max, 1);
    let mut near = [0.0; WIDTH];
    near[..4].copy_from_slice(&near_a);
    near[4..].copy_from_slice(&near_b);
    (a | b << 4, near)
}

#[inline]
fn half_slabs(node: &Wide, ray: &FlatRay, max: f32, which_half: usize) -> (u32, [f32; 4]) {
    let at = |side: usize, axis: usize, origin: f32, inverse: f32| {
        (node.planes[side & 1][axis][which_half] - Vec4::splat(origin)) * Vec4::splat(inverse)
    };
    let enter = |axis: usize| at(ray.side[axis], axis, ray.enter[axis], ray.enter_inverse[axis]);
    let leave = |axis: usize| at(ray.side[axis] ^ 1, axis, ray.leave[axis], ray.leave_inverse[axis]);
    let near = enter(0).max(enter(1)).max(enter(2).max(Vec4::splat(ray.min)));
    let far = leave(0).min(leave(1)).min(leave(2).min(Vec4::splat(max)));
    (near.cmple(far).bitmask(), near.to_array())
}

/// Slab test of a BVH node for AVX2, with eight numbers at once: the same operations in the same order, and none are
/// fused.
#[cfg(target_arch = "x86_64")]
pub(super) mod avx2 {
    use super::{FlatRay, WIDTH, Wide};
    use glam::Vec4;
    use std::arch::x86_64::*;

    #[target_feature(enable = "avx2")]
    #[inline]
    fn load(&[a, b]: &[Vec4; 2]) -> __m256 {
        _mm256_setr_m128(a.into(), b.into())
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn plane_distances(node: &Wide, side: usize, axis: usize, origin: f32, inverse: f32) -> __m256 {
        let planes = load(&node.planes[side & 1][axis]);
        _mm256_mul_ps(_mm256_sub_ps(planes, _mm256_set1_ps(origin)), _mm256_set1_ps(inverse))
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    pub fn slabs(node: &Wide, ray: &FlatRay, max: f32) -> (u32, [f32; WIDTH]) {
        let enter = |axis: usize| plane_distances(node, ray.side[axis], axis, ray.enter[axis], ray.enter_inverse[axis]);
        let leave =
            |axis: usize| plane_distances(node, ray.side[axis] ^ 1, axis, ray.leave[axis], ray.leave_inverse[axis]);
        let z = _mm256_max_ps(enter(2), _mm256_set1_ps(ray.min));
        let near = _mm256_max_ps(_mm256_max_ps(enter(0), enter(1)), z);
        let z = _mm256_min_ps(leave(2), _mm256_set1_ps(max));
        let far = _mm256_min_ps(_mm256_min_ps(leave(0), leave(1)), z);
        let mask = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(near, far));
        (mask as u32, store(near))
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn store(v: __m256) -> [f32; WIDTH] {
        let halves = [_mm256_castps256_ps128(v), _mm256_extractf128_ps::<1>(v)].map(Vec4::from);
        let mut out = [0.0; WIDTH];
        halves[0].write_to_slice(&mut out[..4]);
        halves[1].write_to_slice(&mut out[4..]);
        out
    }
}

/// Prefetches an element of a list into the processor's cache.
#[inline(always)]
pub(super) fn prefetch<T>(list: &[T], at: usize) {
    #[cfg(target_arch = "x86_64")]
    if let Some(thing) = list.get(at) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        for line in 0..size_of::<T>() / 64 {
            let place = std::ptr::from_ref(thing).cast::<i8>().wrapping_add(64 * line);
            // SAFETY: a prefetch does not read.
            #[expect(unsafe_code, reason = "nothing else makes the processor read ahead")]
            unsafe {
                _mm_prefetch::<_MM_HINT_T0>(place);
            }
        }
    }
}
