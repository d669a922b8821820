//! `dispersion`: an interior refracts each colour by another angle (manual, "Dispersion").
//!
//! White light splits at a boundary between interiors of different dispersion; each part then keeps its hue. The number
//! of parts changes neither the weight of a ray nor the sum of the colours.

use super::ray_state::RayState;
use super::reflect;
use super::scatter::{Boundary, mirror_direction};
use super::shading_point::MaterialSample;
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::math::Ray;

impl Tracer<'_> {
    /// Pushes one ray for each colour into which white light splits at a boundary. The colours that are totally reflected continue
    /// together, as one ray of white light that the material's film and transmittance tint (quirk: `dispersion_total_reflection`).
    pub(super) fn push_dispersed(
        &mut self,
        state: &RayState,
        boundary: &Boundary,
        material: &MaterialSample,
        samples: u32,
    ) {
        let Boundary { shading, interface, attenuation } = *boundary;
        let (world, own) = (self.context.world, shading.part.interior);
        let throughput = material.share * attenuation * material.transmittance;
        let weight = state.weight * material.transmittance.max_element();
        let mut totally_reflected = Rgb::ZERO;
        for i in 0..samples {
            let color = spectrum_share(i, samples);
            let hue = (f64::from(i) + 0.5) / f64::from(samples);
            let interface = interface.of_hue(hue, &state.inside, own, &world.interiors);
            let Some(dir) = interface.refract(state.ray.dir, material.normal) else {
                totally_reflected += color;
                continue;
            };
            let mut next = state.continued(Ray::new(shading.point, dir), throughput * color);
            interface.update_crossed_interiors(&mut next.inside, own);
            self.counts.transmitted += 1;
            let level = state.level + 1;
            self.queue.push(RayState { level, weight, hue: Some(hue), has_transmitted: true, ..next });
        }
        if totally_reflected != Rgb::ZERO {
            self.counts.reflected += 1;
            let out = mirror_direction(state.ray.dir, material.normal, shading.smooth);
            let share =
                throughput * totally_reflected * reflect::total_reflection_film_factor(shading, material, out, world);
            let next = state.continued(Ray::new(shading.point, out), share);
            self.queue.push(RayState { level: state.level + 1, weight, is_reflected: true, ..next });
        }
    }
}

/// Returns the colour of part `i` of `samples` equal parts of the spectrum; part 0 is red.
fn spectrum_share(i: u32, samples: u32) -> Rgb {
    let steps = SPECTRUM.len() as f64;
    let (from, to) = (f64::from(i) * steps / f64::from(samples), f64::from(i + 1) * steps / f64::from(samples));
    let mut sum = Rgb::ZERO;
    for (k, step) in SPECTRUM.iter().enumerate().take(to.ceil() as usize).skip(from as usize) {
        let overlap = to.min(k as f64 + 1.0) - from.max(k as f64);
        sum += Rgb::from_array(step.map(f64::from)) * overlap;
    }
    sum / 10_000.0
}

/// Red, green and blue of 70 equal steps of the spectrum from red to violet, in 1/10000 (quirk: `dispersion_spectrum`). Each lobe is a
/// parabola but for rounding.
#[rustfmt::skip]
const SPECTRUM: [[u16; 3]; 70] = [
    [98, 0, 0], [142, 0, 0], [182, 0, 0], [219, 0, 0], [254, 0, 0],
    [285, 0, 0], [313, 0, 0], [338, 0, 0], [360, 0, 0], [379, 0, 0],
    [395, 0, 0], [409, 19, 0], [418, 62, 0], [424, 102, 0], [429, 140, 0],
    [429, 176, 0], [427, 208, 0], [422, 239, 0], [413, 268, 0], [401, 292, 0],
    [387, 316, 0], [369, 337, 0], [349, 354, 0], [324, 370, 0], [298, 384, 0],
    [268, 393, 0], [236, 403, 0], [199, 407, 0], [160, 411, 0], [118, 412, 0],
    [73, 410, 0], [25, 406, 0], [0, 399, 3], [0, 390, 41], [0, 378, 78],
    [0, 364, 111], [0, 347, 144], [0, 329, 174], [0, 306, 201], [0, 283, 228],
    [0, 256, 252], [0, 227, 274], [0, 195, 294], [0, 161, 312], [0, 125, 328],
    [0, 86, 342], [0, 45, 354], [0, 0, 364], [0, 0, 372], [0, 0, 378],
    [0, 0, 382], [0, 0, 384], [0, 0, 384], [0, 0, 381], [0, 0, 378],
    [0, 0, 371], [0, 0, 364], [0, 0, 353], [10, 0, 341], [20, 0, 327],
    [30, 0, 310], [36, 0, 293], [41, 0, 272], [44, 0, 250], [45, 0, 226],
    [43, 0, 200], [41, 0, 171], [36, 0, 141], [29, 0, 109], [20, 0, 75],
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::medium::Interior;
    use crate::transport::interface::Interface;

    #[test]
    fn shares_sum_up_to_almost_white() {
        for samples in [2, 3, 7, 70, 100, 1000] {
            let sum = (0..samples).map(|i| spectrum_share(i, samples)).fold(Rgb::ZERO, |a, b| a + b);
            assert!(sum.distance(Rgb::new(0.9938, 1.0, 0.9962)) < 1e-12, "{samples}: {sum}");
        }
        // POV-Ray's colours with 3 and with 100 samples
        assert!(spectrum_share(1, 3).distance(Rgb::new(0.15929, 0.73487, 0.30179)) < 2e-5);
        assert!((spectrum_share(20, 100).x - 0.03003).abs() < 1e-5);
    }

    #[test]
    fn lobes_are_parabolas() {
        let parabola = |k: usize, c: usize| {
            let x = k as f64 + 0.5;
            match c {
                0 => (75.30 + x * (46.505 - x * 1.5272)).max(-4039.8 + x * (126.70 - x * 0.98252)),
                1 => -653.34 + x * (72.720 - x * 1.24119),
                _ => -2331.3 + x * (104.515 - x * 1.00570),
            }
        };
        for (k, step) in SPECTRUM.iter().enumerate() {
            for (c, &found) in step.iter().enumerate() {
                // the ends of a lobe are cut off in a step
                let off = f64::from(found) - parabola(k, c).max(0.0);
                assert!(found < 30 || off.abs() < 1.2, "{k} {c}: {off}");
            }
        }
    }

    #[test]
    fn each_hue_by_snells_law() {
        let glass = [Interior { ior: 1.5, dispersion: 1.2, ..Interior::default() }.into()];
        let outside = Default::default();
        let white = Interface::new(&outside, 0, &glass);
        let ior = |hue| white.of_hue(hue, &outside, 0, &glass).n2;
        assert_eq!(white.n2, 1.5);
        assert!((ior(1.0) / ior(0.0) - 1.2).abs() < 1e-12);
        assert!((ior(0.5) - 1.5).abs() < 1e-12);
        assert_eq!(white.dispersion_samples(&outside, 0, &glass), Some(7));
    }
}
