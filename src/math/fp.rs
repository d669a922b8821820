//! Every transcendental function goes through here, so that one edit can make them the same on all
//! platforms.

use std::f64::consts::TAU;

/// Sine of an angle in radians.
pub fn sin(x: f64) -> f64 {
    x.sin()
}

/// Cosine of an angle in radians.
pub fn cos(x: f64) -> f64 {
    x.cos()
}

/// Sine and cosine together.
pub fn sin_cos(x: f64) -> (f64, f64) {
    x.sin_cos()
}

/// Tangent of an angle in radians.
pub fn tan(x: f64) -> f64 {
    x.tan()
}

/// Arc sine in radians; the argument is clamped to [-1, 1].
pub fn asin(x: f64) -> f64 {
    x.clamp(-1.0, 1.0).asin()
}

/// Arc cosine in radians; the argument is clamped to [-1, 1].
pub fn acos(x: f64) -> f64 {
    x.clamp(-1.0, 1.0).acos()
}

/// Angle of the point (x, y) in radians.
pub fn atan2(y: f64, x: f64) -> f64 {
    y.atan2(x)
}

/// What is left of a number above the whole number below it, in [0, 1].
pub fn fraction(x: f64) -> f64 {
    x - x.floor()
}

/// Angle of the point (x, y) as a part of a whole turn, in [0, 1].
pub fn turn(y: f64, x: f64) -> f64 {
    fraction(atan2(y, x) / TAU)
}

/// x to the power of y.
pub fn pow(x: f64, y: f64) -> f64 {
    x.powf(y)
}

/// xⁿ by products alone, which are the same on all machines.
pub fn power_of(x: f64, n: u32) -> f64 {
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

/// e to the power of x.
pub fn exp(x: f64) -> f64 {
    x.exp()
}

/// Natural logarithm.
pub fn ln(x: f64) -> f64 {
    x.ln()
}
