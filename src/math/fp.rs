//! All transcendental functions, so that one file makes them equal on all platforms. (clippy.toml forbids those of the
//! standard library everywhere else.)
#![allow(clippy::disallowed_methods)]

use std::f64::consts::TAU;

/// Sine of an angle in radians.
#[inline]
pub fn sin(x: f64) -> f64 {
    x.sin()
}

/// Cosine of an angle in radians.
#[inline]
pub fn cos(x: f64) -> f64 {
    x.cos()
}

/// Sine and cosine of an angle in radians.
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    x.sin_cos()
}

/// Tangent of an angle in radians.
#[inline]
pub fn tan(x: f64) -> f64 {
    x.tan()
}

/// Arc sine in radians; the argument is clamped to [-1, 1].
#[inline]
pub fn asin(x: f64) -> f64 {
    x.clamp(-1.0, 1.0).asin()
}

/// Arc cosine in radians; the argument is clamped to [-1, 1].
#[inline]
pub fn acos(x: f64) -> f64 {
    x.clamp(-1.0, 1.0).acos()
}

/// Arc sine in radians; NaN outside of [-1, 1].
#[inline]
pub fn asin_or_nan(x: f64) -> f64 {
    x.asin()
}

/// Arc cosine in radians; NaN outside of [-1, 1].
#[inline]
pub fn acos_or_nan(x: f64) -> f64 {
    x.acos()
}

/// Arc tangent in radians.
#[inline]
pub fn atan(x: f64) -> f64 {
    x.atan()
}

/// Angle of the point (x, y) in radians.
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    y.atan2(x)
}

/// Length of the vector (x, y).
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    x.hypot(y)
}

/// Fractional part of `x`, in [0, 1): x - ⌊x⌋.
#[inline]
pub fn fraction(x: f64) -> f64 {
    x - x.floor()
}

/// Angle of the point (x, y) as a fraction of a turn, in [0, 1].
#[inline]
pub fn angle_in_turns(y: f64, x: f64) -> f64 {
    fraction(atan2(y, x) / TAU)
}

/// x to the power of y.
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    x.powf(y)
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
    let whole = exponent as u32;
    if f64::from(whole) == exponent && whole < 4096 { integer_power(x, whole) } else { pow(x, exponent) }
}

/// e to the power of x.
#[inline]
pub fn exp(x: f64) -> f64 {
    x.exp()
}

/// 2 to the power of x.
#[inline]
pub fn exp2(x: f64) -> f64 {
    x.exp2()
}

/// Natural logarithm of `x`.
#[inline]
pub fn ln(x: f64) -> f64 {
    x.ln()
}

/// Cube root of `x`.
#[inline]
pub fn cbrt(x: f64) -> f64 {
    x.cbrt()
}

/// Logarithm of `x` to base 10.
#[inline]
pub fn log10(x: f64) -> f64 {
    x.log10()
}

/// Hyperbolic cosine of `x`.
#[inline]
pub fn cosh(x: f64) -> f64 {
    x.cosh()
}

/// Hyperbolic sine of `x`.
#[inline]
pub fn sinh(x: f64) -> f64 {
    x.sinh()
}

/// Hyperbolic tangent of `x`.
#[inline]
pub fn tanh(x: f64) -> f64 {
    x.tanh()
}

/// Inverse hyperbolic cosine of `x`.
#[inline]
pub fn acosh(x: f64) -> f64 {
    x.acosh()
}

/// Inverse hyperbolic sine of `x`.
#[inline]
pub fn asinh(x: f64) -> f64 {
    x.asinh()
}

/// Inverse hyperbolic tangent of `x`.
#[inline]
pub fn atanh(x: f64) -> f64 {
    x.atanh()
}
