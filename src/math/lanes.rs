//! Numbers that are computed side by side.

use glam::Vec4;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A real number, or several side by side.
pub trait Real: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {}

impl Real for f64 {}

impl<const N: usize> Real for Lanes<N> {}

/// Numbers that are computed side by side, each with the bits that it has alone. The compiler puts several into one
/// register; and long chains of operations take little more time for several numbers than for one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Lanes<const N: usize>(pub [f64; N]);

/// A truth value for each of several lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(64))]
pub struct Mask<const N: usize>(
    /// All bits of a lane's number are 1 for true, 0 for false.
    [u64; N],
);

/// Returns the results of an expression for the lanes 0 to `$n` - 1. (A loop: the closures of `from_fn` would be called one by
/// one.)
macro_rules! for_each_lane {
    ($i:ident < $n:ident => $result:expr) => {{
        let mut results = [Default::default(); $n];
        for $i in 0..$n {
            results[$i] = $result;
        }
        results
    }};
}
pub(super) use for_each_lane;

impl<const N: usize> Lanes<N> {
    /// Returns lanes with the same number.
    #[inline(always)]
    pub fn splat(x: f64) -> Self {
        Self([x; N])
    }

    /// Returns the smaller number in each lane; of a number and NaN, the number.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i].min(other.0[i])))
    }

    /// Returns the larger number in each lane; of a number and NaN, the number.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i].max(other.0[i])))
    }

    /// Returns the next larger number of each positive, finite number.
    #[inline(always)]
    pub fn next_up_of_positive(self) -> Self {
        Self(for_each_lane!(i < N => f64::from_bits(self.0[i].to_bits() + 1)))
    }

    /// Returns the square root of each number.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self(for_each_lane!(i < N => self.0[i].sqrt()))
    }

    /// Returns the absolute value of each number.
    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(for_each_lane!(i < N => self.0[i].abs()))
    }

    /// Returns numbers with the absolute values of `self` and the signs of `signs`.
    #[inline(always)]
    pub fn copysign(self, signs: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i].copysign(signs.0[i])))
    }

    /// True in the lanes whose sign is negative, also of -0.
    #[inline(always)]
    pub fn has_negative_sign(self) -> Mask<N> {
        Mask(for_each_lane!(i < N => 0_u64.wrapping_sub(self.0[i].to_bits() >> 63)))
    }

    /// True in the lanes in which the number is less than the other.
    #[inline(always)]
    pub fn less_than(self, other: Self) -> Mask<N> {
        Mask(for_each_lane!(i < N => all_bits(self.0[i] < other.0[i])))
    }

    /// True in the lanes in which the number is less than the other or equal.
    #[inline(always)]
    pub fn at_most(self, other: Self) -> Mask<N> {
        Mask(for_each_lane!(i < N => all_bits(self.0[i] <= other.0[i])))
    }

    /// True in the lanes in which the numbers are equal.
    #[inline(always)]
    pub fn equals(self, other: Self) -> Mask<N> {
        Mask(for_each_lane!(i < N => all_bits(self.0[i] == other.0[i])))
    }

    /// True in the lanes with a finite number.
    #[inline(always)]
    pub fn is_finite(self) -> Mask<N> {
        self.abs().less_than(Self::splat(f64::INFINITY))
    }
}

/// Returns a number whose bits are all 1 for true, 0 for false.
#[inline(always)]
fn all_bits(is_true: bool) -> u64 {
    if is_true { u64::MAX } else { 0 }
}

/// Returns the signs of numbers as bits, that of the first in the lowest: 1 for a negative number. Four must divide their number.
#[inline(always)]
pub fn sign_bits<const N: usize>(numbers: [f32; N]) -> u32 {
    let mut bits = 0;
    for (k, four) in numbers.as_chunks::<4>().0.iter().enumerate() {
        bits |= Vec4::from_array(*four).is_negative_bitmask() << (4 * k);
    }
    bits
}

impl<const N: usize> Mask<N> {
    /// Mask that is true in all lanes.
    pub const ALL: Self = Self([u64::MAX; N]);

    /// Mask that is true in no lane.
    pub const NONE: Self = Self([0; N]);

    /// Returns the mask with these truth values.
    #[inline(always)]
    pub fn from_fn(is_true: impl Fn(usize) -> bool) -> Self {
        Self(for_each_lane!(i < N => all_bits(is_true(i))))
    }

    /// Returns the truth values as numbers, whose bits are all 1 for true, 0 for false.
    #[inline(always)]
    pub fn to_u32(self) -> [u32; N] {
        for_each_lane!(i < N => self.0[i] as u32)
    }

    /// Returns the mask with the truth values in the lowest bits of a number, lane 0 in the lowest.
    #[inline(always)]
    pub fn from_bits(bits: u32) -> Self {
        Self::from_fn(|i| bits >> i & 1 == 1)
    }

    /// Returns the truth values of a number of lanes that four divides, as bits, lane 0 in the lowest.
    #[inline(always)]
    pub fn bits(self) -> u32 {
        const { assert!(N.is_multiple_of(4)) };
        sign_bits(for_each_lane!(i < N => f32::from_bits(self.0[i] as u32)))
    }

    /// True if any lane is true.
    #[inline(always)]
    pub fn any(self) -> bool {
        let mut all = 0;
        for i in 0..N {
            all |= self.0[i];
        }
        all != 0
    }

    /// Returns the numbers of `if_true` in the lanes that are true, and those of `if_false` in the others.
    #[inline(always)]
    pub fn select(self, if_true: Lanes<N>, if_false: Lanes<N>) -> Lanes<N> {
        Lanes(for_each_lane!(i < N => if self.0[i] != 0 { if_true.0[i] } else { if_false.0[i] }))
    }

    /// Returns the whole numbers of `if_true` in the lanes that are true, and those of `if_false` in the others.
    #[inline(always)]
    pub fn select_u32(self, if_true: [u32; N], if_false: [u32; N]) -> [u32; N] {
        let marks = self.to_u32();
        for_each_lane!(i < N => if_true[i] & marks[i] | if_false[i] & !marks[i])
    }
}

impl<const N: usize> BitAnd for Mask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i] & other.0[i]))
    }
}

impl<const N: usize> BitOr for Mask<N> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i] | other.0[i]))
    }
}

impl<const N: usize> Not for Mask<N> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(for_each_lane!(i < N => !self.0[i]))
    }
}

impl<const N: usize> Add for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i] + other.0[i]))
    }
}

impl<const N: usize> Sub for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i] - other.0[i]))
    }
}

impl<const N: usize> Mul for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i] * other.0[i]))
    }
}

impl<const N: usize> Div for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(for_each_lane!(i < N => self.0[i] / other.0[i]))
    }
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(for_each_lane!(i < N => -self.0[i]))
    }
}

impl<const N: usize> Add<f64> for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, number: f64) -> Self {
        self + Self::splat(number)
    }
}

impl<const N: usize> Sub<f64> for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, number: f64) -> Self {
        self - Self::splat(number)
    }
}

impl<const N: usize> Mul<Lanes<N>> for f64 {
    type Output = Lanes<N>;
    #[inline(always)]
    fn mul(self, lanes: Lanes<N>) -> Lanes<N> {
        Lanes::splat(self) * lanes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::array::from_fn;

    /// Numbers of all kinds, in pairs.
    const NUMBERS: [f64; 8] = [0.0, -0.0, 1.5, -2.25, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 5e-324];

    #[test]
    fn lanes_have_the_bits_of_single_numbers() {
        for shift in 0..8 {
            let (a, b) = (Lanes(NUMBERS), Lanes(from_fn::<f64, 8, _>(|i| NUMBERS[(i + shift) % 8])));
            let check = |found: Lanes<8>, expected: fn(f64, f64) -> f64| {
                for i in 0..8 {
                    let expected = expected(a.0[i], b.0[i]);
                    assert!(found.0[i] == expected || found.0[i].is_nan() && expected.is_nan(), "{shift} {i}");
                }
            };
            check(a + b, |a, b| a + b);
            check(a - b, |a, b| a - b);
            check(a * b, |a, b| a * b);
            check(a / b, |a, b| a / b);
            check(-a, |a, _| -a);
            check(a.min(b), f64::min);
            check(a.max(b), f64::max);
            check(a.sqrt(), |a, _| a.sqrt());
            check(a.abs(), |a, _| a.abs());
            let signs = |x: Lanes<8>| x.0.map(f64::is_sign_negative);
            assert_eq!(signs(a.copysign(b)), signs(b));
            let truth = |mask: Mask<8>| from_fn::<bool, 8, _>(|i| mask.bits() >> i & 1 == 1);
            assert_eq!(truth(a.less_than(b)), from_fn(|i| a.0[i] < b.0[i]));
            assert_eq!(truth(a.at_most(b)), from_fn(|i| a.0[i] <= b.0[i]));
            assert_eq!(truth(a.equals(b)), from_fn(|i| a.0[i] == b.0[i]));
            assert_eq!(truth(a.is_finite()), a.0.map(f64::is_finite));
            assert_eq!(truth(a.has_negative_sign()), signs(a));
            let numbers = a.less_than(b).select_u32([7; 8], [9; 8]);
            assert_eq!(numbers, from_fn(|i| if a.0[i] < b.0[i] { 7 } else { 9 }));
            let smaller = a.less_than(b).select(a, b);
            check(smaller, |a, b| if a < b { a } else { b });
        }
    }

    #[test]
    fn masks_are_bits() {
        for bits in 0..256 {
            let mask = Mask::<8>::from_bits(bits);
            assert_eq!((mask.bits(), mask.any()), (bits, bits != 0));
            assert_eq!((!mask).bits(), 255 - bits);
            let other = Mask::from_fn(|i| i % 2 == 0);
            assert_eq!(((mask & other).bits(), (mask | other).bits()), (bits & 0x55, bits | 0x55));
            assert_eq!(mask.to_u32().map(|number| number == u32::MAX), from_fn(|i| bits >> i & 1 == 1));
        }
    }
}
