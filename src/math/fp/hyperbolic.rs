//! Hyperbolic functions and their inverses, in software: by Taylor series near 0, and by exponentials and logarithms in pairs of
//! numbers elsewhere. The errors are below 1 unit in the last place. The crate `libm` computes the values of other arguments:
//! infinite or huge ones, NaN, and those outside of the domain.

use super::pow::{Pair, exp_pair, ln};

/// Magnitude up to which the Taylor series of sinh, cosh and tanh are used.
const SMALL: f64 = 0.25;
/// Magnitude up to which the Taylor series of the inverse functions are used.
const SMALL_INVERSE: f64 = 0.1;
/// Magnitude up to which exponentials are finite.
const MAX_EXPONENT: f64 = 700.0;
/// Magnitude from which on exp(-x) does not change exp(x), and tanh is 1.
const NEGLIGIBLE: f64 = 40.0;
/// Magnitude up to which squares are finite.
const MAX_SQUARE: f64 = 1e120;

/// Hyperbolic sine of `x`.
pub fn sinh(x: f64) -> f64 {
    let a = x.abs();
    if a < SMALL {
        return x + x * sinh_ratio_minus_one(x * x);
    }
    if a >= MAX_EXPONENT || x.is_nan() {
        return libm::sinh(x);
    }
    let e = exp_pair(Pair::of(a));
    let sum = if a < NEGLIGIBLE { e.plus(Pair::of(-1.0).over(e)) } else { e };
    (0.5 * sum.value()).copysign(x)
}

/// Hyperbolic cosine of `x`.
pub fn cosh(x: f64) -> f64 {
    let a = x.abs();
    if a >= MAX_EXPONENT || x.is_nan() {
        return libm::cosh(x);
    }
    let e = exp_pair(Pair::of(a));
    let sum = if a < NEGLIGIBLE { e.plus(Pair::of(1.0).over(e)) } else { e };
    0.5 * sum.value()
}

/// Hyperbolic tangent of `x`.
pub fn tanh(x: f64) -> f64 {
    let a = x.abs();
    if a < SMALL {
        let z = x * x;
        // tanh x = sinh x / cosh x
        return Pair::sum(x, x * sinh_ratio_minus_one(z)).over(Pair::sum(1.0, cosh_minus_one(z))).value();
    }
    if a >= NEGLIGIBLE || x.is_nan() {
        return libm::tanh(x);
    }
    let e = exp_pair(Pair::of(a));
    let inverse = Pair::of(1.0).over(e);
    e.plus(inverse.negated()).over(e.plus(inverse)).value().copysign(x)
}

/// Inverse hyperbolic sine of `x`.
pub fn asinh(x: f64) -> f64 {
    let a = x.abs();
    if a < SMALL_INVERSE {
        return x + x * asinh_ratio_minus_one(x * x);
    }
    if a >= MAX_SQUARE || x.is_nan() {
        return libm::asinh(x);
    }
    // ln(a + √(a² + 1))
    let root = Pair::product(a, a).plus(Pair::of(1.0)).square_root();
    ln_of_pair(root.plus(Pair::of(a))).copysign(x)
}

/// Inverse hyperbolic cosine of `x`.
pub fn acosh(x: f64) -> f64 {
    if x == 1.0 {
        return 0.0;
    }
    if !(1.0..MAX_SQUARE).contains(&x) {
        return libm::acosh(x);
    }
    // w = √((x - 1)·(x + 1)); acosh x = asinh w = ln(x + w)
    let w = Pair::sum(x, -1.0).times(Pair::sum(x, 1.0)).square_root();
    if w.high < SMALL_INVERSE {
        return w.high + (w.high * asinh_ratio_minus_one(w.high * w.high) + w.low);
    }
    ln_of_pair(w.plus(Pair::of(x)))
}

/// Inverse hyperbolic tangent of `x`.
pub fn atanh(x: f64) -> f64 {
    let a = x.abs();
    if a < SMALL_INVERSE {
        let z = x * x;
        let series = 1.0 / 11.0 + z * (1.0 / 13.0 + z * (1.0 / 15.0 + z * (1.0 / 17.0)));
        let series = 1.0 / 3.0 + z * (0.2 + z * (1.0 / 7.0 + z * (1.0 / 9.0 + z * series)));
        return x + x * (z * series);
    }
    if a >= 1.0 || x.is_nan() {
        return libm::atanh(x);
    }
    // ½·ln((1 + a) / (1 - a))
    (0.5 * ln_of_pair(Pair::sum(1.0, a).over(Pair::sum(1.0, -a)))).copysign(x)
}

/// Returns sinh(x)/x - 1 by its Taylor series; the argument is x².
fn sinh_ratio_minus_one(x_squared: f64) -> f64 {
    let inner = 1.0 + x_squared * (1.0 / 72.0) * (1.0 + x_squared * (1.0 / 110.0) * (1.0 + x_squared * (1.0 / 156.0)));
    x_squared * (1.0 / 6.0) * (1.0 + x_squared * 0.05 * (1.0 + x_squared * (1.0 / 42.0) * inner))
}

/// Returns cosh(x) - 1 by its Taylor series; the argument is x².
fn cosh_minus_one(x_squared: f64) -> f64 {
    let inner = 1.0 + x_squared * (1.0 / 90.0) * (1.0 + x_squared * (1.0 / 132.0) * (1.0 + x_squared * (1.0 / 182.0)));
    x_squared
        * 0.5
        * (1.0 + x_squared * (1.0 / 12.0) * (1.0 + x_squared * (1.0 / 30.0) * (1.0 + x_squared * (1.0 / 56.0) * inner)))
}

/// Returns asinh(x)/x - 1 by its Taylor series; the argument is x².
fn asinh_ratio_minus_one(x_squared: f64) -> f64 {
    let inner = -63.0 / 2816.0
        + x_squared * (231.0 / 13312.0 + x_squared * (-143.0 / 10240.0 + x_squared * (6435.0 / 557_056.0)));
    x_squared
        * (-1.0 / 6.0
            + x_squared * (0.075 + x_squared * (-5.0 / 112.0 + x_squared * (35.0 / 1152.0 + x_squared * inner))))
}

/// Returns the natural logarithm of a pair: ln(h + l) = ln h + l/h, where l is far below a unit of h.
fn ln_of_pair(x: Pair) -> f64 {
    let log = ln(x.high);
    log.high + (log.low + x.low / x.high)
}
