//! Powers with real exponents, in software: xʸ = exp(y·ln x), where ln x has 65 correct bits.
//!
//! Logarithm and exponential are table-driven (P. T. P. Tang, "Table-driven implementation of the exponential function in IEEE
//! floating-point arithmetic", 1989, and "… of the logarithm function …", 1990). Numbers of more than 53 bits are pairs, whose sum
//! is the number (T. J. Dekker, "A floating-point technique for extending the available precision", 1971). No step uses a fused
//! multiply-add, which not all processors have.

/// Number of rows of the table of logarithms, and of the table of 2^(i/128).
const ROWS: usize = 128;

/// Bits of a number from which on the exponent and the table's row are counted: 0.703125, so that the reduced number is between
/// 0.703125 and 1.40625 and the logarithm of a number near 1 needs no subtraction.
const FIRST: u64 = 0x3fe6_8000_0000_0000;

/// ln 2: a multiple of 2⁻⁴², whose products with exponents are exact, and the rest.
const LN_2: Pair = Pair { high: f64::from_bits(0x3fe6_2e42_fefa_3800), low: f64::from_bits(0x3d2e_f357_93c7_6730) };

/// ln 2 / 128: a multiple of 2⁻⁴², whose products with numbers of 18 bits are exact, and the rest.
const STEP: Pair = Pair { high: f64::from_bits(0x3f76_2e42_fef8_0000), low: f64::from_bits(0x3d41_cf79_abc9_e3b4) };

/// Maximum magnitude of y·ln x for which the result is a normal number.
const MAX_EXPONENT: f64 = 700.0;

static LOGS: [LogRow; ROWS] = log_table();
static ROOTS: [Pair; ROWS] = power_of_two_table();

/// x to the power of y, with an error of at most 0.6 units in the last place; 1 unit where x or the result is not a positive normal
/// number.
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    let is_normal = x.to_bits().wrapping_sub(1 << 52) < 0x7fe0 << 48;
    // The second comparison is false for NaN.
    if is_normal && y.abs() < 1e18 {
        let log = ln(x);
        let product = Pair::product(y, log.high);
        let exponent = Pair { high: product.high, low: product.low + y * log.low };
        if exponent.high.abs() < MAX_EXPONENT {
            return exp(exponent);
        }
    }
    unusual_pow(x, y)
}

/// The power where the base or the result is zero, negative, subnormal, infinite or NaN.
#[cold]
fn unusual_pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// x to the power of y, rounded to single precision: the same as `pow(x, y) as f32`, in half the time.
#[inline]
pub fn pow_f32(x: f64, y: f64) -> f32 {
    if let Some(power) = approximate_pow(x, y) {
        let (low, high) = ((power * (1.0 - APPROXIMATE_ERROR)) as f32, (power * (1.0 + APPROXIMATE_ERROR)) as f32);
        if low == high {
            return low;
        }
    }
    pow(x, y) as f32
}

/// x to the power of y with a relative error below 10⁻¹², in half the time of [`pow`]: for comparisons and for searches that
/// end at a coarser tolerance.
#[inline]
pub fn quick_pow(x: f64, y: f64) -> f64 {
    approximate_pow(x, y).unwrap_or_else(|| pow(x, y))
}

/// Maximum relative error of [`approximate_pow`], with a reserve of a factor of ten.
const APPROXIMATE_ERROR: f64 = 1e-12;

/// Approximation of x to the power of y, with a relative error below 10⁻¹²: the steps of [`pow`] without pairs of
/// numbers. `None` where x is neither 0 nor a positive normal number, and for some powers that are very large or very small.
#[inline]
fn approximate_pow(x: f64, y: f64) -> Option<f64> {
    if x.to_bits() == 0 && y > 0.0 {
        return Some(0.0);
    }
    let is_normal = x.to_bits().wrapping_sub(1 << 52) < 0x7fe0 << 48;
    let (k, row, z) = reduce(x);
    let r = z * row.reciprocal - 1.0;
    let series = (0.5 - r * (1.0 / 3.0)) + r * r * ((0.25 - r * 0.2) + r * r * (1.0 / 6.0 - r * (1.0 / 7.0)));
    let exponent = y * (k * LN_2.value() + row.log.value() + (r - r * r * series));
    // The absolute error of the logarithm, a few 2⁻⁵³, is multiplied by y.
    if !(is_normal && y.abs() < 100.0 && exponent.abs() < 100.0) {
        return None;
    }
    let (power, scale) = exp_and_scale(Pair::of(exponent));
    Some((power.high + power.low) * scale)
}

/// Splits a positive normal number into 2ᵏ·z with z between 0.703125 and 1.40625, and returns k, the row of the table of
/// logarithms for z, and z.
#[inline]
fn reduce(x: f64) -> (f64, &'static LogRow, f64) {
    let offset = x.to_bits().wrapping_sub(FIRST);
    let k = (offset as i64 >> 52) as f64;
    let row = &LOGS[(offset >> 45) as usize % ROWS];
    (k, row, f64::from_bits(x.to_bits().wrapping_sub(offset & (0xfff << 52))))
}

/// Natural logarithm of a positive normal number, with a relative error below 2⁻⁶⁵.
#[inline]
pub(super) fn ln(x: f64) -> Pair {
    // x = 2ᵏ·z, and r = z·reciprocal - 1, exactly.
    let (k, row, z) = reduce(x);
    let upper_half = f64::from_bits(z.to_bits() & !0x3ff_ffff);
    let lower_half = z - upper_half;
    let r = Pair::sum(upper_half * row.reciprocal - 1.0, lower_half * row.reciprocal);

    // ln(1 + r) = r - r²/2 + r³/3 - …, where r² = a² + b·(a + r) with r = a + b, and a² is exact.
    let (a, b) = split(r.high);
    let square = 0.5 * a * a;
    let rest_of_square = 0.5 * b * (a + r.high) + r.high * r.low;
    let t = r.high;
    let t2 = t * t;
    let series = (1.0 / 3.0 - t * 0.25)
        + t2 * ((0.2 - t * (1.0 / 6.0)) + t2 * ((1.0 / 7.0 - t * 0.125) + t2 * (1.0 / 9.0 - t * 0.1)));

    let sum = Pair::sum(k * LN_2.high + row.log.high, r.high);
    let difference = Pair::sum(sum.high, -square);
    let low = sum.low + difference.low + (r.low - rest_of_square + (k * LN_2.low + row.log.low) + t * t2 * series);
    Pair::sum(difference.high, low)
}

/// e to the power of a pair whose first number is below [`MAX_EXPONENT`].
#[inline]
fn exp(x: Pair) -> f64 {
    let (power, scale) = exp_and_scale(x);
    (power.high + power.low) * scale
}

/// e to the power of a pair whose first number is below [`MAX_EXPONENT`], as a pair with a relative error below 2⁻⁶⁰.
pub(super) fn exp_pair(x: Pair) -> Pair {
    let (power, scale) = exp_and_scale(x);
    Pair::sum(power.high * scale, power.low * scale)
}

/// Returns e to the power of a pair as a sum of two numbers, and the power of 2 that it is to be multiplied by.
#[inline]
fn exp_and_scale(x: Pair) -> (Pair, f64) {
    /// The sum with it rounds a number to an integer, which is then in the lowest bits.
    const ROUNDER: f64 = 6_755_399_441_055_744.0;
    let rounded = x.high * (1.0 / (STEP.high + STEP.low)) + ROUNDER;
    let n = rounded.to_bits() as i32;
    let steps = rounded - ROUNDER;
    let r = (x.high - steps * STEP.high) - steps * STEP.low + x.low;
    let r2 = r * r;
    let growth = r + r2 * ((0.5 + r * (1.0 / 6.0)) + r2 * (1.0 / 24.0 + r * (1.0 / 120.0)));
    let root = ROOTS[n as usize % ROWS];
    let scale = f64::from_bits((((n >> 7) + 1023) as u64) << 52);
    (Pair { high: root.high, low: root.low + root.high * growth }, scale)
}

/// Row of the table of logarithms, for numbers of an interval whose centre is c.
#[derive(Clone, Copy)]
struct LogRow {
    /// 1/c, rounded to a multiple of 2⁻⁹, so that its products with the halves of a number are exact.
    reciprocal: f64,
    /// -ln `reciprocal`: a multiple of 2⁻⁴², as that of [`LN_2`], so that their sums are exact; and the rest.
    log: Pair,
}

/// Computes the table of logarithms. Both intervals at 1 have the reciprocal 1: the logarithm of 1 is exactly 0.
const fn log_table() -> [LogRow; ROWS] {
    let mut table = [LogRow { reciprocal: 1.0, log: Pair { high: 0.0, low: 0.0 } }; ROWS];
    let mut i = 0;
    while i < ROWS {
        let start = FIRST + ((i as u64) << 45);
        let centre = f64::from_bits(start + (1 << 44));
        if centre < 1.0 - 1.0 / 256.0 || centre > 1.0 + 1.0 / 128.0 {
            let reciprocal = (512.0 / centre + 0.5) as u32 as f64 / 512.0;
            let log = Pair::ln_near_one(reciprocal);
            // All logarithms are between -1 and 1, so that the sum with 3·2⁹ rounds to a multiple of 2⁻⁴².
            let high = (log.high + 1536.0) - 1536.0;
            table[i] = LogRow { reciprocal, log: Pair { high: -high, low: (high - log.high) - log.low } };
        }
        i += 1;
    }
    table
}

/// Computes the table of 2^(i/128).
const fn power_of_two_table() -> [Pair; ROWS] {
    let mut table = [Pair { high: 1.0, low: 0.0 }; ROWS];
    let mut i = 1;
    while i < ROWS {
        let exponent = Pair::product(i as f64, STEP.high);
        table[i] = Pair::sum(exponent.high, exponent.low + i as f64 * STEP.low).exp_of_unit_interval();
        i += 1;
    }
    table
}

/// Unevaluated sum of two numbers, of which the second is small against the first.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    pub high: f64,
    pub low: f64,
}

impl Pair {
    /// The exact sum of two numbers (D. E. Knuth, "The Art of Computer Programming", volume 2, 1969).
    #[inline]
    pub const fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self { high, low: (a - (high - part)) + (b - part) }
    }

    /// The exact product of two numbers whose magnitudes are below 2⁹⁰⁰ (Dekker 1971).
    #[inline]
    pub const fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let ((a1, a2), (b1, b2)) = (split(a), split(b));
        Self { high, low: ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2 }
    }

    /// Returns the sum of two pairs.
    pub const fn plus(self, other: Self) -> Self {
        let sum = Self::sum(self.high, other.high);
        Self::sum(sum.high, sum.low + (self.low + other.low))
    }

    /// Returns the product of two pairs.
    pub const fn times(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::sum(product.high, product.low + (self.high * other.low + self.low * other.high))
    }

    /// Returns the pair whose value is the number, exactly.
    pub const fn of(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// Returns the pair rounded to one number.
    pub const fn value(self) -> f64 {
        self.high + self.low
    }

    /// Returns the pair with the opposite sign.
    pub const fn negated(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }

    /// Returns the quotient of two pairs.
    pub const fn over(self, divisor: Self) -> Self {
        let first = self.high / divisor.high;
        let product = Self::product(first, divisor.high);
        let rest = (self.high - product.high) - product.low + (self.low - first * divisor.low);
        Self::sum(first, rest / divisor.high)
    }

    /// Returns the square root of a positive pair.
    pub fn square_root(self) -> Self {
        let first = self.high.sqrt();
        let square = Self::product(first, first);
        Self::sum(first, ((self.high - square.high) - square.low + self.low) / (2.0 * first))
    }

    /// Returns the quotient of the pair and a number.
    const fn divided_by(self, divisor: f64) -> Self {
        let first = self.high / divisor;
        let product = Self::product(first, divisor);
        Self::sum(first, ((self.high - product.high) - product.low + self.low) / divisor)
    }

    /// The natural logarithm of a number between 0.7 and 1.5, by the series 2·(s + s³/3 + s⁵/5 + …) with s = (x - 1) / (x + 1).
    const fn ln_near_one(x: f64) -> Self {
        let s = Self { high: x - 1.0, low: 0.0 }.divided_by(x + 1.0);
        let square = s.times(s);
        let (mut sum, mut power, mut n) = (s, s, 3.0);
        while n < 61.0 {
            power = power.times(square);
            sum = sum.plus(power.divided_by(n));
            n += 2.0;
        }
        sum.plus(sum)
    }

    /// e to the power of a number between 0 and 1, by its Taylor series.
    const fn exp_of_unit_interval(self) -> Self {
        let one = Self { high: 1.0, low: 0.0 };
        let (mut sum, mut term, mut n) = (one, one, 1.0);
        while n < 31.0 {
            term = term.times(self).divided_by(n);
            sum = sum.plus(term);
            n += 1.0;
        }
        sum
    }
}

/// Splits a number into two of at most 26 bits (Veltkamp's algorithm; Dekker 1971).
#[inline]
const fn split(a: f64) -> (f64, f64) {
    let scaled = 134_217_729.0 * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tables are computed by the compiler; their rows are here compared with functions that do not use them.
    #[test]
    fn tables_have_the_values_of_their_functions() {
        for row in &LOGS {
            let log = libm::log(row.reciprocal);
            assert!((row.log.high + log + row.log.low).abs() <= 2e-16 * log.abs(), "{}", row.reciprocal);
            assert_eq!((row.reciprocal * 512.0).fract(), 0.0);
            assert_eq!((row.log.high * (1u64 << 42) as f64).fract(), 0.0);
        }
        for (i, root) in ROOTS.iter().enumerate() {
            assert!((root.high - libm::exp2(i as f64 / 128.0)).abs() <= 3e-16 && root.low.abs() < 2e-16, "{i}");
        }
    }

    #[test]
    fn known_powers_are_exact() {
        for n in -60..=60 {
            assert_eq!(pow(2.0, f64::from(n)), libm::ldexp(1.0, n));
            assert_eq!(pow(1.0, f64::from(n)), 1.0);
            assert_eq!(pow(4.0, f64::from(n) / 2.0), libm::ldexp(1.0, n));
        }
        for x in [0.3, 1.0 + f64::EPSILON, 1.0 - f64::EPSILON / 2.0, 7e200, 3e-300] {
            assert_eq!(pow(x, 1.0), x);
            assert_eq!(pow(x, 0.0), 1.0);
        }
        assert_eq!(pow(81.0, 0.25), 3.0);
        assert_eq!(pow(10.0, 22.0), 1e22);
    }

    /// Powers of other numbers have the values of the standard (IEEE 754-2019, section 9.2.1).
    #[test]
    fn unusual_powers() {
        for (x, y, expected) in [
            (-2.0, 3.0, -8.0),
            (0.0, 0.0, 1.0),
            (0.0, 2.5, 0.0),
            (0.0, -1.0, f64::INFINITY),
            (-0.0, -1.0, f64::NEG_INFINITY),
            (f64::INFINITY, 0.5, f64::INFINITY),
            (0.5, f64::INFINITY, 0.0),
            (0.5, f64::NEG_INFINITY, f64::INFINITY),
            (10.0, 400.0, f64::INFINITY),
            (10.0, -400.0, 0.0),
            (10.0, -320.0, 1e-320),
            (5e-324, 0.5, 2.2227587494850775e-162),
            (1.0, f64::NAN, 1.0),
            (1.5, 1e300, f64::INFINITY),
        ] {
            assert_eq!(pow(x, y), expected, "{x} to the power of {y}");
        }
        for x in [0.0, -0.0, f64::INFINITY, 5e-324, -1.0, 1e300] {
            assert_eq!(pow_f32(x, 2.0), pow(x, 2.0) as f32);
        }
        assert!(pow_f32(f64::NAN, 2.0).is_nan());
        assert!(pow(-2.0, 0.5).is_nan());
        assert!(pow(f64::NAN, 1.0).is_nan());
    }

    proptest::proptest! {
        #[test]
        fn approximate_powers_are_close(x in 0.0..1.0_f64, e in -60..60_i32, y in -99.0..99.0_f64) {
            let x = (0.5 + x) * libm::ldexp(1.0, e);
            let exact = pow(x, y);
            if let Some(power) = approximate_pow(x, y) {
                proptest::prop_assert!((power - exact).abs() <= 0.1 * APPROXIMATE_ERROR * exact, "{x} {y}");
            }
            for y in [y, 0.04 * y] {
                proptest::prop_assert_eq!(pow_f32(x, y), pow(x, y) as f32);
            }
            // Numbers in the middle between two of single precision
            let half = f64::from(x as f32) + f64::from((x as f32).next_up());
            proptest::prop_assert_eq!(pow_f32(0.5 * half, 1.0), (0.5 * half) as f32);
        }

        /// `libm`'s powers, by another algorithm, have errors below 1 unit.
        #[test]
        fn powers_equal_those_of_libm(x in 1e-300..1e300_f64, z in 0.5..2.0_f64, y in -1.0..1.0_f64) {
            for (x, y) in [(x, y), (z, 700.0 * y)] {
                proptest::prop_assert!(pow(x, y).to_bits().abs_diff(libm::pow(x, y).to_bits()) <= 1);
            }
        }
    }
}
