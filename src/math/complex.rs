//! Complex numbers for fractals.
//!
//! Not `num-complex`: its `exp`, `ln`, `sqrt` and `sinh` call the functions of the system, whose last bits differ between machines, and
//! its methods of these names would hide portable ones.

use super::{Lanes, Real, fp};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A complex number, x + iy; with `T` as [`Lanes`], several complex numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex<T = f64> {
    /// The real part x.
    pub x: T,
    /// The imaginary part y.
    pub y: T,
}

impl<T> Complex<T> {
    /// Returns the complex number x + iy.
    pub const fn new(x: T, y: T) -> Self {
        Self { x, y }
    }
}

impl<T: Real> Complex<T> {
    /// Returns the square z².
    #[inline]
    pub fn square(self) -> Self {
        Self::new(self.x * self.x - self.y * self.y, (self.x + self.x) * self.y)
    }

    /// Returns the squared absolute value |z|².
    #[inline]
    pub fn length_squared(self) -> T {
        self.x * self.x + self.y * self.y
    }
}

impl<const N: usize> Complex<Lanes<N>> {
    /// Puts complex numbers side by side.
    #[inline]
    pub fn side_by_side(numbers: [Complex; N]) -> Self {
        Self::new(Lanes(numbers.map(|z| z.x)), Lanes(numbers.map(|z| z.y)))
    }

    /// Returns the complex number in a lane.
    #[inline]
    pub fn lane(self, index: usize) -> Complex {
        Complex::new(self.x.0[index], self.y.0[index])
    }
}

impl Complex {
    /// Returns i·z: the number turned counter-clockwise by 90°.
    pub fn times_i(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// Returns the exponential eᶻ.
    pub fn exp(self) -> Self {
        let (sin, cos) = fp::sin_cos(self.y);
        fp::exp(self.x) * Self::new(cos, sin)
    }

    /// Returns the natural logarithm of z with an imaginary part between -π and π.
    pub fn ln(self) -> Self {
        Self::new(0.5 * fp::ln(self.length_squared()), fp::atan2(self.y, self.x))
    }

    /// Returns the square root of z with a real part that is not negative.
    pub fn sqrt(self) -> Self {
        let length = self.length_squared().sqrt();
        let (x, y) = (0.5 * (length + self.x), 0.5 * (length - self.x));
        Self::new(x.max(0.0).sqrt(), y.max(0.0).sqrt().copysign(self.y))
    }

    /// Returns sinh z and cosh z.
    pub fn sinh_cosh(self) -> (Self, Self) {
        let ((sin, cos), (sinh, cosh)) = (fp::sin_cos(self.y), (fp::sinh(self.x), fp::cosh(self.x)));
        (Self::new(sinh * cos, cosh * sin), Self::new(cosh * cos, sinh * sin))
    }
}

impl<const N: usize> Complex<Lanes<N>> {
    /// Returns zⁿ in each lane, by repeated squaring.
    #[inline]
    pub fn power(self, mut n: u32) -> Self {
        let (mut result, mut base) = (Self::side_by_side([Complex::new(1.0, 0.0); N]), self);
        while n > 0 {
            if n & 1 == 1 {
                result = result * base;
            }
            base = base.square();
            n >>= 1;
        }
        result
    }
}

impl<T: Real> Add for Complex<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl<T: Real> Sub for Complex<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl<T: Add<f64, Output = T>> Add<f64> for Complex<T> {
    type Output = Self;
    #[inline]
    fn add(self, real: f64) -> Self {
        Self::new(self.x + real, self.y)
    }
}

impl<T: Real> Mul for Complex<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.x * other.x - self.y * other.y, self.x * other.y + self.y * other.x)
    }
}

impl Mul<Complex> for f64 {
    type Output = Complex;
    #[inline]
    fn mul(self, z: Complex) -> Complex {
        Complex::new(self * z.x, self * z.y)
    }
}

impl<const N: usize> Mul<Complex<Lanes<N>>> for f64 {
    type Output = Complex<Lanes<N>>;
    #[inline]
    fn mul(self, z: Complex<Lanes<N>>) -> Complex<Lanes<N>> {
        Complex::new(self * z.x, self * z.y)
    }
}

impl<T: Real> Div for Complex<T> {
    type Output = Self;
    #[inline]
    fn div(self, by: Self) -> Self {
        let d = by.length_squared();
        Self::new((self.x * by.x + self.y * by.y) / d, (self.y * by.x - self.x * by.y) / d)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_by_squares() {
        let z = Complex::new(0.6, -0.7);
        let power = Complex::side_by_side([z, z.square()]).power(5);
        assert!((power.lane(0).x - (z * z * z * z * z).x).abs() < 1e-15);
        assert!((power.lane(1).y - (z * z * z * z * z).square().y).abs() < 1e-15);
    }

    #[test]
    fn inverse_to_each_other() {
        for (x, y) in [(0.6, -0.7), (-1.3, 0.2), (-0.4, -2.0)] {
            let z = Complex::new(x, y);
            let near = |w: Complex| assert!((w - z).length_squared() < 1e-28, "{w:?} {z:?}");
            near(z.ln().exp());
            near(z.exp().ln());
            near(z.sqrt().square());
            let (sinh, cosh) = z.sinh_cosh();
            near((sinh + cosh).ln());
        }
    }
}
