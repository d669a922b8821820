//! Rays in the single precision of a BVH's boxes.

use super::node::Wide;
use super::{SLACK, pad_down};
use crate::math::{DVec3, Range, Ray};
use glam::Vec3;

/// The ray of a BVH traversal in single precision, once for the planes of entry and once for those of exit, so that it
/// enters earlier and leaves later: origins are shifted away, and distances of planes in front are scaled.
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
