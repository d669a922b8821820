//! Focal blur: many rays a pixel, each through another place of the lens and of the pixel (manual, "Focal Blur").

use super::grid::Pixel;
use super::random::Purpose;
use super::trace::Tracer;
use crate::camera::Lens;
use crate::math::DVec2;

/// Steps of the row of points that fills a square, and a lens, most evenly: powers of 1/φ, where φ⁵ = φ + 1 (Roberts 2018, "R4").
const STEPS: [f64; 4] =
    [0.856_674_883_854_502_9, 0.733_891_856_627_126, 0.628_706_721_038_087_1, 0.538_597_257_223_610_2];
/// It is asked again whether a pixel is exact enough after so many rays.
const ASK_EVERY: u32 = 4;

/// The mean of the rays of a pixel, as many as it takes.
pub(super) fn pixel(tracer: &mut Tracer, lens: &Lens, number: u64, x: usize, y: usize) -> Pixel {
    // Each pixel begins elsewhere in the row.
    tracer.begin(number, 0);
    let random = tracer.random.of_pixel(Purpose::Lens);
    let start = [0, 1, 2, 3].map(|dimension| random.at(dimension));
    let (mut mean, mut spread) = ([0.0; 4], [0.0; 4]);
    for i in 0..lens.samples[1] {
        let at = |dimension: usize| (start[dimension] + STEPS[dimension] * f64::from(i)).fract();
        tracer.begin(number, u64::from(i));
        let sample = tracer.see_through(x as f64 + at(0), y as f64 + at(1), lens, DVec2::new(at(2), at(3)));
        let count = f64::from(i + 1);
        for (c, value) in [sample.rgb.x, sample.rgb.y, sample.rgb.z, sample.passed].into_iter().enumerate() {
            // Mean and sum of squares about it, one value at a time (Welford 1962).
            let before = mean[c];
            mean[c] += (value - before) / count;
            spread[c] += (value - before) * (value - mean[c]);
        }
        let asked = i + 1 >= lens.samples[0] && (i + 1 - lens.samples[0]).is_multiple_of(ASK_EVERY);
        if asked && spread.iter().all(|squares| lens.suffices(i + 1, *squares)) {
            break;
        }
    }
    mean.map(|c| c as f32)
}
