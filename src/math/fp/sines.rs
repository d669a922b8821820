//! Sines of several angles at once.

use std::f64::consts::FRAC_2_PI;

/// Half of π to 33 bits, and the rest.
const HALF_PI: [f64; 2] = [1.570_796_326_734_125_6, 6.077_100_506_506_192e-11];
/// A number to which others below 2⁵¹ are added to round them to integers, which then are its last bits.
const ROUNDING: f64 = 1.5 / f64::EPSILON;
/// Coefficients of x³, x⁵, … of the sine from -π/4 to π/4.
const SINE: [f64; 6] = [
    -0.166_666_666_666_666_32,
    0.008_333_333_333_322_49,
    -0.000_198_412_698_298_579_5,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
/// Coefficients of x⁴, x⁶, … of the cosine from -π/4 to π/4.
const COSINE: [f64; 6] = [
    0.041_666_666_666_666_6,
    -0.001_388_888_888_887_411,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];
/// Angles below which [`sine_or_nan`] computes sines.
const MAX_ANGLE: f64 = 1e6;

/// Returns the sines of angles in radians, each with the bits of [`super::sin`].
///
/// The method is that of Sun's fdlibm (1993), which `libm::sin` follows: the angle less a multiple of π/2, then a polynomial. Here
/// no step depends on the angle, so that the compiler can compute several sines at once. The few angles for which `libm::sin`
/// uses another method are passed to it.
#[inline]
pub fn sines<const N: usize>(angles: [f64; N]) -> [f64; N] {
    let mut sines = [0.0; N];
    // (A loop over both arrays; the closures of `from_fn` would be called one by one.)
    for (sine, angle) in sines.iter_mut().zip(&angles) {
        *sine = sine_or_nan(*angle);
    }
    for (sine, angle) in sines.iter_mut().zip(&angles) {
        if sine.is_nan() {
            *sine = super::sin(*angle);
        }
    }
    sines
}

/// Returns the sine of an angle, or NaN for an angle whose sine `libm::sin` computes by another method.
#[inline(always)]
fn sine_or_nan(angle: f64) -> f64 {
    let shifted = angle * FRAC_2_PI + ROUNDING;
    let multiple = shifted - ROUNDING;
    let difference = angle - multiple * HALF_PI[0];
    let correction = multiple * HALF_PI[1];
    let x = difference - correction;
    let rest = (difference - x) - correction;
    let x2 = x * x;
    let x3 = x2 * x;
    let x4 = x2 * x2;
    let tail = SINE[1] + x2 * (SINE[2] + x2 * SINE[3]) + x2 * x4 * (SINE[4] + x2 * SINE[5]);
    let near_0 = x + x3 * (SINE[0] + x2 * tail);
    let sine = x - ((x2 * (0.5 * rest - x3 * tail) - rest) - x3 * SINE[0]);
    let sine = if multiple == 0.0 { near_0 } else { sine };
    let tail = x2 * (COSINE[0] + x2 * (COSINE[1] + x2 * COSINE[2]))
        + x4 * x4 * (COSINE[3] + x2 * (COSINE[4] + x2 * COSINE[5]));
    let half = 0.5 * x2;
    let most = 1.0 - half;
    let cosine = most + (((1.0 - most) - half) + (x2 * tail - x * rest));
    // The last bits of the multiple select the polynomial and the sign.
    let is_odd = 0_u64.wrapping_sub(shifted.to_bits() & 1);
    let sign = (shifted.to_bits() & 2) << 62;
    let value = f64::from_bits((sine.to_bits() & !is_odd | cosine.to_bits() & is_odd) ^ sign);
    // Near odd multiples of π/4, libm may take another multiple of π/2; if 16 bits cancel, it takes more digits of π; and the
    // sine of a tiny angle is the angle.
    let is_certain =
        (angle.abs() < MAX_ANGLE) & (x.abs() < 0.785) & (x.abs() > 1e-7) & (x.abs() * 65536.0 >= angle.abs());
    if is_certain { value } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{fp, rng};

    fn check(angles: [f64; 4]) {
        let bits = angles.map(|angle| fp::sin(angle).to_bits());
        assert_eq!(sines(angles).map(f64::to_bits), bits, "{angles:?}");
    }

    #[test]
    fn sines_have_the_bits_of_single_sines() {
        for i in 0..200_000_u64 {
            let random = |k| rng::random_unit(&[i, k]) * 2.0 - 1.0;
            let size = [0.7, 3.0, 8.0, 60.0, 5e3, 9e5, 1e7, 1e-6][i as usize % 8];
            check([0, 1, 2, 3].map(|k| random(k) * size));
        }
    }

    #[test]
    fn most_sines_are_computed_together() {
        let count = (0..10_000).filter(|i| !sine_or_nan(f64::from(*i) * 0.0123).is_nan()).count();
        assert!(count > 9_900, "{count}");
    }

    #[test]
    fn sines_near_multiples_of_an_eighth_turn_have_the_bits_of_single_sines() {
        for k in -3000..3000 {
            let angle = f64::from(k) * std::f64::consts::FRAC_PI_4;
            check([angle, angle.next_up(), angle * (1.0 + 1e-9), angle * (1.0 - 4e-5)]);
            check([angle + 1e-9, angle - 3e-6, angle + 2e-4, angle - 0.01]);
        }
        check([0.0, -0.0, f64::MIN_POSITIVE, -1e-310]);
        check([1e300, -1e300, 1e6, f64::MAX]);
        for angle in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert!(sines([angle; 4]).iter().all(|sine| sine.is_nan()), "{angle}");
        }
    }
}
