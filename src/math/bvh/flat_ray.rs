//! Rays in the single precision of a BVH's boxes.

use super::node::Wide;
use super::{SLACK, pad_down};
use crate::math::{DVec3, Range, Ray};
use glam::Vec3;

/// The ray of a BVH traversal in single precision, once for the planes of entry and once for those of exit, so that it
/// enters earlier and leaves later: origins are shifted away, and distances of planes in front are scaled.
#[derive(Debug, PartialEq)]
pub(super) struct FlatRay {
    pub enter: [f32; 3],
    pub leave: [f32; 3],
    pub enter_inverse: [f32; 3],
    pub leave_inverse: [f32; 3],
    /// For each axis, 1 where the ray's direction is negative, so that the ray enters through the upper plane; 0
    /// otherwise.
    pub side: [usize; 3],
    pub min: f32,
}

impl FlatRay {
    #[inline(always)]
    pub fn new(ray: &Ray, range: Range, root: &Wide) -> Self {
        // Larger than the origin's rounding error, and never zero: then no plane has the distance 0, which 1/0 would
        // turn into NaN.
        let mut error = (ray.origin.abs() * 2.5e-7).max(DVec3::splat(1e-19));
        let mut slack = SLACK;
        if range.min < 0.0 {
            // For planes behind the origin, distances can't be scaled: shift all planes instead.
            error += (ray.origin.abs() + f64::from(root.max_abs_coordinate())) * SLACK;
            slack = 0.0;
        }
        let error = error.copysign(ray.dir);
        let inverse = ray.dir.recip();
        let scaled = |factor: f64, least: f32| {
            (inverse * factor)
                .as_vec3()
                .abs()
                .clamp(Vec3::splat(least), Vec3::splat(f32::MAX))
                .copysign(inverse.as_vec3())
        };
        Self {
            enter: (ray.origin + error).as_vec3().to_array(),
            leave: (ray.origin - error).as_vec3().to_array(),
            enter_inverse: scaled(1.0 - slack, 0.0).to_array(),
            leave_inverse: scaled(1.0 + slack, f32::MIN_POSITIVE).to_array(),
            side: ray.dir.to_array().map(|x| usize::from(x.is_sign_negative())),
            min: pad_down(range.min),
        }
    }
}

/// Construction for AVX2, with the three axes at once: the same operations, and so the same bits.
#[cfg(target_arch = "x86_64")]
pub(super) mod avx2 {
    use super::{FlatRay, Range, Ray, SLACK, Wide, pad_down};
    use crate::math::DVec3;
    use glam::Vec4;
    use std::arch::x86_64::*;

    /// Returns the coordinates along the three axes; the fourth number is unused.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn lanes(v: DVec3) -> __m256d {
        _mm256_setr_pd(v.x, v.y, v.z, 1.0)
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn array(v: __m128) -> [f32; 3] {
        Vec4::from(v).truncate().to_array()
    }

    /// Returns the ray for a range that begins behind its origin. (Not inlined: [`flat_ray`] then is.)
    #[cold]
    #[inline(never)]
    fn flat_ray_backwards(ray: &Ray, range: Range, root: &Wide) -> FlatRay {
        FlatRay::new(ray, range, root)
    }

    /// Returns the same as [`FlatRay::new`].
    #[target_feature(enable = "avx2")]
    #[inline]
    pub fn flat_ray(ray: &Ray, range: Range, root: &Wide) -> FlatRay {
        if range.min < 0.0 {
            return flat_ray_backwards(ray, range, root);
        }
        let (origin, dir) = (lanes(ray.origin), lanes(ray.dir));
        let sign = _mm256_set1_pd(-0.0);
        let error = _mm256_mul_pd(_mm256_andnot_pd(sign, origin), _mm256_set1_pd(2.5e-7));
        let error = _mm256_or_pd(_mm256_max_pd(error, _mm256_set1_pd(1e-19)), _mm256_and_pd(sign, dir));
        let inverse = _mm256_div_pd(_mm256_set1_pd(1.0), dir);
        let sign = _mm_and_ps(_mm256_cvtpd_ps(inverse), _mm_set1_ps(-0.0));
        let scaled = |factor: f64, least: f32| {
            let size =
                _mm_andnot_ps(_mm_set1_ps(-0.0), _mm256_cvtpd_ps(_mm256_mul_pd(inverse, _mm256_set1_pd(factor))));
            array(_mm_or_ps(_mm_min_ps(_mm_max_ps(size, _mm_set1_ps(least)), _mm_set1_ps(f32::MAX)), sign))
        };
        let negative = _mm256_movemask_pd(dir) as usize;
        FlatRay {
            enter: array(_mm256_cvtpd_ps(_mm256_add_pd(origin, error))),
            leave: array(_mm256_cvtpd_ps(_mm256_sub_pd(origin, error))),
            enter_inverse: scaled(1.0 - SLACK, 0.0),
            leave_inverse: scaled(1.0 + SLACK, f32::MIN_POSITIVE),
            side: [negative & 1, negative >> 1 & 1, negative >> 2 & 1],
            min: pad_down(range.min),
        }
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    #[test]
    fn avx2_gives_the_same_numbers() {
        if !is_x86_feature_detected!("avx2") {
            return;
        }
        let numbers = [0.0, -0.0, 1.0, -0.3, 1e-300, -1e-40, 1e40, -1e300, 16_777_217.0];
        for k in 0..numbers.len().pow(3) {
            let pick = |shift: usize| numbers[(k / numbers.len().pow(shift as u32) + shift * k) % numbers.len()];
            let dir = DVec3::new(pick(0), pick(1), pick(2));
            let ray = Ray::new(DVec3::new(dir.y, dir.z, dir.x) * 0.7, dir);
            for range in [Range::ALL, Range::FORWARD, Range { min: 0.5, max: 3.0 }] {
                // SAFETY: the processor has the feature.
                #[expect(unsafe_code, reason = "the compiler can't know the processor")]
                let wide = unsafe { avx2::flat_ray(&ray, range, &Wide::EMPTY) };
                assert_eq!(wide, FlatRay::new(&ray, range, &Wide::EMPTY), "{ray:?} {range:?}");
            }
        }
    }
}
