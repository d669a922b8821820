//! Complex numbers, so far as fractals need them.

use std::ops::{Add, Div, Mul};

/// A complex number, x + iy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    /// The real part.
    pub x: f64,
    /// The imaginary part.
    pub y: f64,
}

impl Complex {
    /// x + iy.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// z².
    pub fn square(self) -> Self {
        Self::new(self.x * self.x - self.y * self.y, (self.x + self.x) * self.y)
    }

    /// |z|².
    pub fn length_squared(self) -> f64 {
        self.x * self.x + self.y * self.y
    }

    /// z to the n-th, by squares.
    pub fn power(self, mut n: u32) -> Self {
        let (mut result, mut base) = (Self::new(1.0, 0.0), self);
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

impl Add for Complex {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl Add<f64> for Complex {
    type Output = Self;
    fn add(self, real: f64) -> Self {
        Self::new(self.x + real, self.y)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.x * other.x - self.y * other.y, self.x * other.y + self.y * other.x)
    }
}

impl Mul<Complex> for f64 {
    type Output = Complex;
    fn mul(self, z: Complex) -> Complex {
        Complex::new(self * z.x, self * z.y)
    }
}

impl Div for Complex {
    type Output = Self;
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
        assert!((z.power(5).x - (z * z * z * z * z).x).abs() < 1e-15);
    }
}
