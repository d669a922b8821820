//! Functions of numbers, for scripts and `function { … }` alike (manual, "Float Functions").

use super::Interval;
use crate::math::fp;
use rustc_hash::FxHashMap;
use std::sync::LazyLock;

/// Rust implementation of a built-in numeric function, such as `sin` or `max`.
#[derive(Clone, Copy, Debug)]
pub enum Kernel {
    /// A numeric function of one argument.
    One(fn(f64) -> f64),
    /// A numeric function of two arguments.
    Two(fn(f64, f64) -> f64),
    /// A numeric function of one or more arguments, folded from the left.
    Many(fn(f64, f64) -> f64),
}

/// Arguments for which a script can evaluate a numeric function; in `function { }` all others give NaN.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domain {
    /// Domain of a numeric function that accepts every number.
    All,
    /// Domain of a numeric function for numbers from -1 to 1; a script clamps other numbers.
    Arc,
    /// Domain of a numeric function that accepts 0 and positive numbers.
    FromZero,
    /// Domain of a numeric function that accepts only numbers above 0.
    AboveZero,
    /// Domain of a numeric function whose two arguments must not both be 0, with the reason.
    NotBothZero(&'static str),
    /// Domain of a numeric function for which a second argument of 0 is a division by zero.
    Divides,
}

/// A row of the table of built-in numeric functions.
#[derive(Debug)]
pub struct Numeric {
    /// Name of the function in a scene.
    pub name: &'static str,
    /// Rust function that computes the numeric function.
    pub kernel: Kernel,
    /// Arguments for which a script can evaluate the function.
    pub domain: Domain,
    /// Bounds of the numeric function over two intervals of arguments; for one argument both intervals are equal.
    pub bounds: fn(Interval, Interval) -> Interval,
    /// One line about the numeric function for the manual.
    pub summary: &'static str,
}

const fn unary_row(
    name: &'static str,
    f: fn(f64) -> f64,
    bounds: fn(Interval, Interval) -> Interval,
    summary: &'static str,
) -> Numeric {
    Numeric { name, kernel: Kernel::One(f), domain: Domain::All, bounds, summary }
}

const fn binary_row(
    name: &'static str,
    f: fn(f64, f64) -> f64,
    bounds: fn(Interval, Interval) -> Interval,
    summary: &'static str,
) -> Numeric {
    Numeric { name, kernel: Kernel::Two(f), domain: Domain::All, bounds, summary }
}

const fn folded_row(
    name: &'static str,
    f: fn(f64, f64) -> f64,
    bounds: fn(Interval, Interval) -> Interval,
    summary: &'static str,
) -> Numeric {
    Numeric { name, kernel: Kernel::Many(f), domain: Domain::All, bounds, summary }
}

impl Numeric {
    const fn with_domain(self, domain: Domain) -> Self {
        Self { domain, ..self }
    }
}

/// Returns the bounds of a numeric function that can give any number.
fn unbounded_result(_: Interval, _: Interval) -> Interval {
    Interval::ALL
}

/// All built-in numeric functions. `asin` and `acos` are not clamped here: outside of [-1, 1] they are NaN.
pub const TABLE: &[Numeric] = &[
    unary_row("abs", f64::abs, |a, _| a.abs(), "the distance from 0"),
    unary_row("acos", fp::acos_or_nan, unbounded_result, "the angle in radians whose cosine it is")
        .with_domain(Domain::Arc),
    unary_row("acosh", fp::acosh, unbounded_result, "the inverse of cosh"),
    unary_row("asin", fp::asin_or_nan, unbounded_result, "the angle in radians whose sine it is")
        .with_domain(Domain::Arc),
    unary_row("asinh", fp::asinh, |a, _| a.map_increasing(fp::asinh), "the inverse of sinh"),
    unary_row("atan", fp::atan, |a, _| a.map_increasing(fp::atan), "the angle in radians whose tangent it is"),
    binary_row("atan2", fp::atan2, |_, _| Interval::new(-3.2, 3.2), "the angle in radians of the point (B, A)")
        .with_domain(Domain::NotBothZero("<0, 0> has no direction")),
    unary_row("atanh", fp::atanh, unbounded_result, "the inverse of tanh"),
    folded_row(
        "bitwise_and",
        |a, b| bitwise(a, b, |a, b| a & b),
        unbounded_result,
        "bits that are in all of the whole numbers",
    ),
    folded_row(
        "bitwise_or",
        |a, b| bitwise(a, b, |a, b| a | b),
        unbounded_result,
        "bits that are in any of the whole numbers",
    ),
    folded_row(
        "bitwise_xor",
        |a, b| bitwise(a, b, |a, b| a ^ b),
        unbounded_result,
        "bits that are in an odd number of them",
    ),
    unary_row("ceil", f64::ceil, |a, _| Interval { lo: a.lo.ceil(), hi: a.hi.ceil() }, "the next whole number above"),
    unary_row("cos", fp::cos, |a, _| a.cos(), "the cosine of an angle in radians"),
    unary_row("cosh", fp::cosh, |a, _| a.abs().map_increasing(fp::cosh), "the hyperbolic cosine"),
    unary_row("degrees", f64::to_degrees, |a, _| a.map_increasing(f64::to_degrees), "radians to degrees"),
    binary_row("div", |a, b| (a / b).trunc(), unbounded_result, "the whole part of A/B").with_domain(Domain::Divides),
    unary_row("exp", fp::exp, |a, _| a.map_increasing(fp::exp), "e to the power of A"),
    unary_row(
        "floor",
        f64::floor,
        |a, _| Interval { lo: a.lo.floor(), hi: a.hi.floor() },
        "the next whole number below",
    ),
    unary_row(
        "int",
        f64::trunc,
        |a, _| Interval { lo: a.lo.trunc(), hi: a.hi.trunc() },
        "the number without its fraction",
    ),
    unary_row(
        "ln",
        fp::ln,
        |a, _| if a.lo > 0.0 { a.map_increasing(fp::ln) } else { Interval::ALL },
        "the natural logarithm",
    )
    .with_domain(Domain::AboveZero),
    unary_row(
        "log",
        fp::log10,
        |a, _| if a.lo > 0.0 { a.map_increasing(fp::log10) } else { Interval::ALL },
        "the logarithm of base 10",
    )
    .with_domain(Domain::AboveZero),
    folded_row("max", f64::max, |a, b| Interval { lo: a.lo.max(b.lo), hi: a.hi.max(b.hi) }, "the largest"),
    folded_row("min", f64::min, |a, b| Interval { lo: a.lo.min(b.lo), hi: a.hi.min(b.hi) }, "the smallest"),
    binary_row("mod", fp::remainder, unbounded_result, "what A/B leaves over, with the sign of A")
        .with_domain(Domain::Divides),
    binary_row("pow", fp::pow, Interval::pow, "A to the power of B")
        .with_domain(Domain::NotBothZero("0 to the power of 0 is not defined")),
    unary_row("radians", f64::to_radians, |a, _| a.map_increasing(f64::to_radians), "degrees to radians"),
    unary_row("sin", fp::sin, |a, _| a.sin(), "the sine of an angle in radians"),
    unary_row("sinh", fp::sinh, |a, _| a.map_increasing(fp::sinh), "the hyperbolic sine"),
    unary_row(
        "sqrt",
        f64::sqrt,
        |a, _| if a.lo >= 0.0 { a.map_increasing(f64::sqrt) } else { Interval::ALL },
        "the square root",
    )
    .with_domain(Domain::FromZero),
    unary_row("tan", fp::tan, unbounded_result, "the tangent of an angle in radians"),
    unary_row("tanh", fp::tanh, |a, _| a.map_increasing(fp::tanh), "the hyperbolic tangent"),
];

fn bitwise(a: f64, b: f64, f: fn(i64, i64) -> i64) -> f64 {
    f(a as i64, b as i64) as f64
}

/// Finds the index of the row of [`TABLE`] for a function's name.
pub fn find_numeric(name: &str) -> Option<u8> {
    NUMBERS.get(name).copied()
}

static NUMBERS: LazyLock<FxHashMap<&'static str, u8>> =
    LazyLock::new(|| TABLE.iter().enumerate().map(|(i, row)| (row.name, i as u8)).collect());

impl Numeric {
    /// The reason why a script cannot evaluate a numeric function for these arguments; inside `function { }` the result
    /// is NaN instead. `b` equals `a` for one argument. `None` also for a division by zero, which scripts evaluate.
    pub fn domain_fault(&self, a: f64, b: f64) -> Option<String> {
        match self.domain {
            Domain::FromZero if a < 0.0 => Some(format!("{a} has no square root")),
            Domain::AboveZero if a <= 0.0 => Some(format!("`{}` takes numbers above 0, not {a}", self.name)),
            Domain::NotBothZero(why) if a == 0.0 && b == 0.0 => Some(why.into()),
            _ => None,
        }
    }

    /// Returns the argument that a script passes on: clamped to -1..1 for `asin` and `acos`, unchanged for all others.
    pub fn clamp_if_arc_function(&self, argument: f64) -> f64 {
        if self.domain == Domain::Arc { argument.clamp(-1.0, 1.0) } else { argument }
    }
}
