//! Focal blur: many rays for each pixel, through different points of the lens and of the pixel (manual, "Focal Blur").

use super::pixel_area::Pixel;
use super::sampler::{SamplePoint, Sampler};
use crate::camera::Lens;
use crate::math::DVec2;
use crate::transport::Purpose;

/// Steps of an additive recurrence that fills [0, 1)⁴ evenly: powers of 1/φ, where φ⁵ = φ + 1 (Roberts 2018, "R4").
const STEPS: [f64; 4] =
    [0.856_674_883_854_502_9, 0.733_891_856_627_126, 0.628_706_721_038_087_1, 0.538_597_257_223_610_2];
/// Number of rays between two tests for convergence.
const RAYS_PER_CONVERGENCE_TEST: u32 = 4;

/// Returns the mean of a pixel's rays; stops as soon as the variance is low enough (quirk: `focal_blur_convergence`).
pub(super) fn pixel(sampler: &mut Sampler, lens: &Lens, pixel_key: u64, x: usize, y: usize) -> Pixel {
    // Each pixel has its own start in the sequence.
    let random = sampler.random().pixel_sequence(pixel_key, Purpose::Lens);
    let start = [0, 1, 2, 3].map(|dimension| random.at(dimension));
    let point = |i: u32| {
        let at = |dimension: usize| (start[dimension] + STEPS[dimension] * f64::from(i)).fract();
        let (x_pixels, y_pixels) = (x as f64 + at(0), y as f64 + at(1));
        let point = SamplePoint { x_pixels, y_pixels, pixel: pixel_key, sample: u64::from(i) };
        (point, DVec2::new(at(2), at(3)))
    };
    let [least, most] = lens.samples;
    let (mut mean, mut spread, mut count) = ([0.0; 4], [0.0; 4], 0);
    while count < most && !sampler.is_stopped() {
        // All rays up to the next test for convergence
        let first = count;
        let next_test = if first < least { least } else { first + RAYS_PER_CONVERGENCE_TEST };
        sampler.lens_samples((first..next_test.min(most)).map(point), lens, |sample| {
            count += 1;
            let values = [sample.rgb.x, sample.rgb.y, sample.rgb.z, sample.transparency];
            for (c, value) in values.into_iter().enumerate() {
                // Mean and sum of squares about it, one value at a time (Welford 1962).
                let before = mean[c];
                mean[c] += (value - before) / f64::from(count);
                spread[c] += (value - before) * (value - mean[c]);
            }
        });
        if count == next_test && spread.iter().all(|squares| lens.has_converged(count, *squares)) {
            break;
        }
    }
    mean.map(|c| c as f32)
}
