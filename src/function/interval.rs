//! Interval arithmetic: bounds of a function over a box (Moore, "Interval Analysis", 1966). Results are widened by a
//! few units in the last place, so that rounding never makes one too narrow.

use crate::math::fp;
use std::ops::{Add, Mul, Neg};

/// Interval of all numbers from `lo` to `hi`. A function that is not defined everywhere in a box has the bounds
/// [`Interval::ALL`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Smallest number of the interval.
    pub lo: f64,
    /// Largest number of the interval.
    pub hi: f64,
}

impl Interval {
    /// The interval of all numbers.
    pub const ALL: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
    /// Interval from 0 to 1, which contains both results of a comparison.
    pub const TRUTH: Interval = Interval { lo: 0.0, hi: 1.0 };

    /// Returns the interval from the smaller number to the larger; all numbers if one of both is NaN.
    pub fn new(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() { Self::ALL } else { Self { lo: a.min(b), hi: a.max(b) } }
    }

    /// Returns the interval that contains only `x`.
    pub fn point(x: f64) -> Self {
        Self::new(x, x)
    }

    /// True if the interval contains the number.
    pub fn contains(&self, x: f64) -> bool {
        self.lo <= x && x <= self.hi
    }

    /// The smallest interval that contains both intervals.
    pub fn hull(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The intersection of two intervals; `self` if the intersection is empty.
    pub fn intersection_or_self(self, other: Self) -> Self {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        if lo <= hi { Self { lo, hi } } else { self }
    }

    /// Returns the interval widened by a rounding error, for functions that are not rounded exactly.
    pub fn widened_by_rounding(self) -> Self {
        let margin = |x: f64| x.abs() * 4.0 * f64::EPSILON + f64::MIN_POSITIVE;
        let (lo, hi) = (self.lo - margin(self.lo), self.hi + margin(self.hi));
        if lo.is_nan() || hi.is_nan() { Self::ALL } else { Self { lo, hi } }
    }

    /// Returns the interval of a monotonically increasing function's results over this interval.
    pub fn map_increasing(self, f: impl Fn(f64) -> f64) -> Self {
        Self::new(f(self.lo), f(self.hi)).widened_by_rounding()
    }

    /// Returns the interval of 1 / x; all numbers if 0 is inside.
    pub fn recip(self) -> Self {
        if self.contains(0.0) { Self::ALL } else { Self::new(1.0 / self.lo, 1.0 / self.hi).widened_by_rounding() }
    }

    /// Returns the interval of the squares, which are never negative.
    pub fn square(self) -> Self {
        let (a, b) = (self.lo * self.lo, self.hi * self.hi);
        let lo = if self.contains(0.0) { 0.0 } else { a.min(b) };
        let wide = Self::new(lo, a.max(b)).widened_by_rounding();
        Self { lo: wide.lo.max(0.0), hi: wide.hi }
    }

    /// Returns the interval of the absolute values.
    pub fn abs(self) -> Self {
        let lo = if self.contains(0.0) { 0.0 } else { self.lo.abs().min(self.hi.abs()) };
        Self { lo, hi: self.lo.abs().max(self.hi.abs()) }
    }

    /// Returns the interval of the cosines: their extremes are at the interval's ends or at multiples of π inside.
    pub fn cos(self) -> Self {
        use std::f64::consts::PI;
        let width = self.hi - self.lo;
        if width.is_nan() || width >= 2.0 * PI || self.lo.abs().max(self.hi.abs()) > 1e9 {
            return Self { lo: -1.0, hi: 1.0 };
        }
        let mut out = Self::new(fp::cos(self.lo), fp::cos(self.hi)).widened_by_rounding();
        let first = (self.lo / PI).ceil() as i64;
        let last = (self.hi / PI).floor() as i64;
        for k in first..=last {
            out = out.hull(Self::point(if k % 2 == 0 { 1.0 } else { -1.0 }));
        }
        Self { lo: out.lo.max(-1.0), hi: out.hi.min(1.0) }
    }

    /// Returns the interval of the sines: sin(x) = cos(x - π/2).
    pub fn sin(self) -> Self {
        (self + Self::point(-std::f64::consts::FRAC_PI_2)).cos()
    }

    /// Returns the interval of x to the power of y, for an exponent that is one number and bases that are not negative,
    /// or integer exponents from 0 to 64; all numbers otherwise.
    pub fn pow(self, power: Self) -> Self {
        let p = power.lo;
        if power.lo != power.hi || !p.is_finite() {
            return Self::ALL;
        }
        if self.lo >= 0.0 {
            return match p {
                _ if p > 0.0 => self.map_increasing(|x| fp::pow(x, p)),
                _ if self.lo > 0.0 => Self::new(fp::pow(self.lo, p), fp::pow(self.hi, p)).widened_by_rounding(),
                _ => Self::ALL,
            };
        }
        match p {
            _ if p.fract() != 0.0 || !(0.0..=64.0).contains(&p) => Self::ALL,
            _ if p % 2.0 == 0.0 => self.abs().map_increasing(|x| fp::pow(x, p)),
            _ => self.map_increasing(|x| fp::pow(x, p)),
        }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.lo + other.lo, self.hi + other.hi).widened_by_rounding()
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Interval {
    type Output = Self;

    /// Interval of the products: the hull of the products of the ends.
    fn mul(self, other: Self) -> Self {
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let ends = [
            product(self.lo, other.lo),
            product(self.lo, other.hi),
            product(self.hi, other.lo),
            product(self.hi, other.hi),
        ];
        let (lo, hi) = ends.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), &x| (lo.min(x), hi.max(x)));
        if ends.iter().any(|x| x.is_nan()) { Self::ALL } else { Self { lo, hi }.widened_by_rounding() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cosine_finds_its_extremes() {
        let i = Interval::new(-1.0, 4.0).cos();
        assert_eq!((i.lo, i.hi), (-1.0, 1.0));
        let i = Interval::new(0.5, 1.0).cos();
        assert!(i.contains(fp::cos(0.7_f64)) && i.hi < 0.9 && i.lo > 0.5);
    }

    #[test]
    fn zero_times_anything_is_zero() {
        assert!((Interval::point(0.0) * Interval::ALL).hi < 1e-300);
        assert_eq!(Interval::new(-1.0, 1.0).recip(), Interval::ALL);
    }
}
