//! All transcendental functions. They are computed by software that uses the exactly rounded operations of IEEE 754 alone, so that
//! all processors and C libraries give the same bits. (The functions of the standard library call the system's, whose last bits
//! differ; clippy.toml forbids them everywhere.)
//!
//! The crate `libm` is a port of musl's functions by the Rust project. Its errors are below 1 unit in the last place. `pow`
//! is ours, because `libm`'s takes three times as long as the system's, and so are the hyperbolic functions, since `libm`'s have
//! errors up to 2 units.

mod hyperbolic;
mod pow;
mod remainder;
mod sines;

use super::Lanes;
use std::f64::consts::TAU;

pub use hyperbolic::{acosh, asinh, atanh, cosh, sinh, tanh};
pub use pow::{pow, pow_f32, quick_pow};
pub use remainder::remainder;
pub use sines::sines;

/// Sine of an angle in radians; `sines` computes several at once.
#[inline]
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// Cosine of an angle in radians.
#[inline]
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// Sine and cosine of an angle in radians.
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// Tangent of an angle in radians.
#[inline]
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

/// Arc sine in radians; the argument is clamped to [-1, 1].
#[inline]
pub fn asin(x: f64) -> f64 {
    libm::asin(x.clamp(-1.0, 1.0))
}

/// Arc cosine in radians; the argument is clamped to [-1, 1].
#[inline]
pub fn acos(x: f64) -> f64 {
    libm::acos(x.clamp(-1.0, 1.0))
}

/// Arc sine in radians; NaN outside of [-1, 1].
#[inline]
pub fn asin_or_nan(x: f64) -> f64 {
    libm::asin(x)
}

/// Arc cosine in radians; NaN outside of [-1, 1].
#[inline]
pub fn acos_or_nan(x: f64) -> f64 {
    libm::acos(x)
}

/// Arc tangent in radians.
#[inline]
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// Angle of the point (x, y) in radians.
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// Length of the vector (x, y).
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

/// Returns x - ⌊x⌋, in [0, 1). (For a negative `x`, `f64::fract` has another sign.)
#[inline]
pub fn fraction_above_floor(x: f64) -> f64 {
    x - x.floor()
}

/// Angle of the point (x, y) as a fraction of a turn, in [0, 1].
#[inline]
pub fn positive_angle_in_turns(y: f64, x: f64) -> f64 {
    fraction_above_floor(atan2(y, x) / TAU)
}

/// Computes xⁿ by products alone, which are equal on all machines.
#[inline]
pub fn integer_power(x: f64, n: u32) -> f64 {
    let (mut out, mut square, mut rest) = (1.0, x, n);
    while rest > 0 {
        if rest & 1 == 1 {
            out *= square;
        }
        square *= square;
        rest >>= 1;
    }
    out
}

/// x to the power of an exponent that a scene states: mostly a small whole number, for which a few products suffice.
#[inline]
pub fn power(x: f64, exponent: f64) -> f64 {
    match small_whole_exponent(exponent) {
        Some(whole) => integer_power(x, whole),
        None => pow(x, exponent),
    }
}

/// Returns an exponent that is a small whole number, for which [`power`] multiplies.
#[inline]
pub fn small_whole_exponent(exponent: f64) -> Option<u32> {
    let whole = exponent as u32;
    (f64::from(whole) == exponent && whole < 4096).then_some(whole)
}

/// Returns [`integer_power`] of several numbers.
#[inline(always)]
pub fn integer_power_of_lanes<const N: usize>(x: Lanes<N>, n: u32) -> Lanes<N> {
    let (mut out, mut square, mut rest) = (Lanes::splat(1.0), x, n);
    while rest > 0 {
        if rest & 1 == 1 {
            out = out * square;
        }
        square = square * square;
        rest >>= 1;
    }
    out
}

/// e to the power of x.
#[inline]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// 2 to the power of x.
#[inline]
pub fn exp2(x: f64) -> f64 {
    libm::exp2(x)
}

/// Natural logarithm of `x`.
#[inline]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// Cube root of `x`.
#[inline]
pub fn cbrt(x: f64) -> f64 {
    libm::cbrt(x)
}

/// Logarithm of `x` to base 10.
#[inline]
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(name: &str, arguments: &[f64]) -> f64 {
        match (name, arguments) {
            ("sin", &[x]) => sin(x),
            ("cos", &[x]) => cos(x),
            ("tan", &[x]) => tan(x),
            ("asin", &[x]) => asin(x),
            ("acos", &[x]) => acos(x),
            ("atan", &[x]) => atan(x),
            ("exp", &[x]) => exp(x),
            ("exp2", &[x]) => exp2(x),
            ("ln", &[x]) => ln(x),
            ("log10", &[x]) => log10(x),
            ("cbrt", &[x]) => cbrt(x),
            ("sinh", &[x]) => sinh(x),
            ("cosh", &[x]) => cosh(x),
            ("tanh", &[x]) => tanh(x),
            ("asinh", &[x]) => asinh(x),
            ("acosh", &[x]) => acosh(x),
            ("atanh", &[x]) => atanh(x),
            ("atan2", &[y, x]) => atan2(y, x),
            ("hypot", &[x, y]) => hypot(x, y),
            ("pow", &[x, y]) => pow(x, y),
            _ => panic!("no function {name}"),
        }
    }

    #[test]
    fn errors_are_at_most_a_unit_in_the_last_place() {
        let mut tested = std::collections::BTreeSet::new();
        for line in include_str!("../../../tests/math/known_values.txt").lines().filter(|line| !line.starts_with('#')) {
            let (name, numbers) = line.split_once(' ').unwrap();
            let numbers: Vec<_> =
                numbers.split(' ').map(|bits| f64::from_bits(u64::from_str_radix(bits, 16).unwrap())).collect();
            let (expected, arguments) = numbers.split_last().unwrap();
            let found = value(name, arguments);
            let error = found.to_bits().abs_diff(expected.to_bits());
            assert!(error <= 1, "{name}{arguments:?}: {found:e} instead of {expected:e}, {error} units");
            tested.insert(name);
        }
        assert_eq!(tested.len(), 20);
    }
}
