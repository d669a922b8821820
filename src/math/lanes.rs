//! Numbers that are computed side by side.

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Sub};

/// A real number, or several side by side.
pub trait Real: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {}

impl Real for f64 {}

impl<const N: usize> Real for Lanes<N> {}

/// Numbers that are computed side by side, each with the bits that it has alone. The compiler puts several into one
/// register; and long chains of operations take little more time for several numbers than for one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    /// Returns the smaller number in each lane; of a number and NaN, the number.
    #[inline]
    pub fn min(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i].min(other.0[i])))
    }
}

impl<const N: usize> Add for Lanes<N> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl<const N: usize> Sub for Lanes<N> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] - other.0[i]))
    }
}

impl<const N: usize> Mul for Lanes<N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] * other.0[i]))
    }
}

impl<const N: usize> Div for Lanes<N> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        Self(from_fn(|i| self.0[i] / other.0[i]))
    }
}

impl<const N: usize> Add<f64> for Lanes<N> {
    type Output = Self;
    #[inline]
    fn add(self, number: f64) -> Self {
        Self(self.0.map(|x| x + number))
    }
}

impl<const N: usize> Mul<Lanes<N>> for f64 {
    type Output = Lanes<N>;
    #[inline]
    fn mul(self, lanes: Lanes<N>) -> Lanes<N> {
        Lanes(lanes.0.map(|x| self * x))
    }
}
