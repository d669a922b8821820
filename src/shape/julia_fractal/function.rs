//! Functions of complex numbers that a julia fractal iterates, with their derivatives.

use crate::math::Complex;
use crate::value::words::word;
use crate::value::{ValueKind, WordSpec};
use serde::Serialize;

/// Function that a Julia fractal applies to the hypercomplex number z in each iteration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Function {
    /// Function z² of a Julia fractal.
    Sqr,
    /// Function z³ of a Julia fractal.
    Cube,
    /// Function eᶻ of a Julia fractal.
    Exp,
    /// Function 1/z of a Julia fractal.
    Reciprocal,
    /// Function sin z of a Julia fractal.
    Sin,
    /// Inverse of sin z, a function of a Julia fractal.
    Asin,
    /// Function sinh z of a Julia fractal.
    Sinh,
    /// Inverse of sinh z, a function of a Julia fractal.
    Asinh,
    /// Function cos z of a Julia fractal.
    Cos,
    /// Inverse of cos z, a function of a Julia fractal.
    Acos,
    /// Function cosh z of a Julia fractal.
    Cosh,
    /// Inverse of cosh z, a function of a Julia fractal.
    Acosh,
    /// Function tan z of a Julia fractal.
    Tan,
    /// Inverse of tan z, a function of a Julia fractal.
    Atan,
    /// Function tanh z of a Julia fractal.
    Tanh,
    /// Inverse of tanh z, a function of a Julia fractal.
    Atanh,
    /// Natural logarithm of z, a function of a Julia fractal.
    Ln,
    /// Function z to the power x + iy of a Julia fractal.
    Pwr(f64, f64),
}

use Function::*;

/// Functions of a Julia fractal without arguments, by their words.
pub const WORDS: [(&str, Function); 17] = [
    ("sqr", Sqr),
    ("cube", Cube),
    ("exp", Exp),
    ("reciprocal", Reciprocal),
    ("sin", Sin),
    ("asin", Asin),
    ("sinh", Sinh),
    ("asinh", Asinh),
    ("cos", Cos),
    ("acos", Acos),
    ("cosh", Cosh),
    ("acosh", Acosh),
    ("tan", Tan),
    ("atan", Atan),
    ("tanh", Tanh),
    ("atanh", Atanh),
    ("ln", Ln),
];

const fn function_word(name: &'static str, summary: &'static str) -> WordSpec {
    word(name, ValueKind::Nothing, "", summary)
}

/// Words of all functions of a Julia fractal.
pub const FUNCTIONS: [WordSpec; 18] = [
    function_word("sqr", "each round is h²; so it is without any function"),
    function_word("cube", "each round is h³; of hypercomplex numbers h², as in POV-Ray"),
    function_word("exp", "each round is eʰ"),
    function_word("reciprocal", "each round is 1/h"),
    function_word("sin", "each round is sin h"),
    function_word("asin", "each round is asin h"),
    function_word("sinh", "each round is sinh h"),
    function_word("asinh", "each round is asinh h"),
    function_word("cos", "each round is cos h"),
    function_word("acos", "each round is acos h"),
    function_word("cosh", "each round is cosh h"),
    function_word("acosh", "each round is acosh h"),
    function_word("tan", "each round is tan h"),
    function_word("atan", "each round is atan h"),
    function_word("tanh", "each round is tanh h"),
    function_word("atanh", "each round is atanh h"),
    function_word("ln", "each round is the logarithm of h"),
    word("pwr", ValueKind::Block, "", "`pwr(x, y)`: each round is h to the power x + iy"),
];

const ONE: Complex = Complex::new(1.0, 0.0);

/// Returns -i·z: the complex number turned clockwise by 90°.
fn times_minus_i(z: Complex) -> Complex {
    -z.times_i()
}

/// Returns asinh z = ln(z + √(z² + 1)), and its derivative.
fn asinh_and_slope(z: Complex) -> (Complex, Complex) {
    let root = (z.square() + ONE).sqrt();
    ((z + root).ln(), ONE / root)
}

/// Returns acosh z = ln(z + √(z + 1)·√(z - 1)), and its derivative.
fn acosh_and_slope(z: Complex) -> (Complex, Complex) {
    let root = (z + ONE).sqrt() * (z - ONE).sqrt();
    ((z + root).ln(), ONE / root)
}

/// Returns atanh z = (ln(1 + z) - ln(1 - z))/2, and its derivative.
fn atanh_and_slope(z: Complex) -> (Complex, Complex) {
    (0.5 * ((ONE + z).ln() - (ONE - z).ln()), ONE / (ONE - z.square()))
}

/// Returns g(z) = -i·f(i·z) and its derivative f'(i·z): sin follows from sinh, and asin from asinh.
fn rotated_value_and_slope(f: fn(Complex) -> (Complex, Complex), z: Complex) -> (Complex, Complex) {
    let (value, slope) = f(z.times_i());
    (times_minus_i(value), slope)
}

fn tanh_and_slope(z: Complex) -> (Complex, Complex) {
    let (sinh, cosh) = z.sinh_cosh();
    let value = sinh / cosh;
    (value, ONE - value.square())
}

impl Function {
    /// Returns the Julia fractal's function f(z) and its derivative f'(z).
    pub fn value_and_slope(self, z: Complex) -> (Complex, Complex) {
        match self {
            Sqr => (z.square(), 2.0 * z),
            Cube => (z.square() * z, 3.0 * z.square()),
            Exp => (z.exp(), z.exp()),
            Reciprocal => (ONE / z, -(ONE / z.square())),
            Sinh => z.sinh_cosh(),
            Cosh => {
                let (sinh, cosh) = z.sinh_cosh();
                (cosh, sinh)
            }
            Sin => rotated_value_and_slope(|z| z.sinh_cosh(), z),
            Cos => {
                // cos z = cosh(i·z), and its derivative is i·sinh(i·z) = -sin z.
                let (sinh, cosh) = z.times_i().sinh_cosh();
                (cosh, sinh.times_i())
            }
            Tan => rotated_value_and_slope(tanh_and_slope, z),
            Tanh => tanh_and_slope(z),
            Asin => rotated_value_and_slope(asinh_and_slope, z),
            Acos => {
                let (asin, slope) = rotated_value_and_slope(asinh_and_slope, z);
                (Complex::new(std::f64::consts::FRAC_PI_2, 0.0) - asin, -slope)
            }
            Atan => rotated_value_and_slope(atanh_and_slope, z),
            Asinh => asinh_and_slope(z),
            Acosh => acosh_and_slope(z),
            Atanh => atanh_and_slope(z),
            Ln => (z.ln(), ONE / z),
            Pwr(x, y) => {
                let power = Complex::new(x, y);
                let value = (power * z.ln()).exp();
                (value, power * value / z)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_finite_differences() {
        let all = WORDS.iter().map(|(_, f)| *f).chain([Pwr(2.5, -0.3)]);
        for f in all {
            for (x, y) in [(0.3, 0.7), (-0.4, 0.2), (0.8, -1.1)] {
                let at = |x: f64, y: f64| f.value_and_slope(Complex::new(x, y));
                let slope = at(x, y).1;
                let along_x = 5e5 * (at(x + 1e-6, y).0 - at(x - 1e-6, y).0);
                let along_y = times_minus_i(5e5 * (at(x, y + 1e-6).0 - at(x, y - 1e-6).0));
                let near = |a: Complex| (a - slope).length_squared() < 1e-16 * (1.0 + slope.length_squared());
                assert!(near(along_x) && near(along_y), "{f:?} {slope:?} {along_x:?} {along_y:?}");
            }
        }
    }

    #[test]
    fn inverses() {
        let both = [(Sin, Asin), (Cos, Acos), (Sinh, Asinh), (Cosh, Acosh), (Tan, Atan), (Tanh, Atanh), (Exp, Ln)];
        for (f, inverse) in both {
            let z = Complex::new(0.4, 0.3);
            let back = f.value_and_slope(inverse.value_and_slope(z).0).0;
            assert!((back - z).length_squared() < 1e-28, "{f:?} {back:?}");
        }
    }
}
