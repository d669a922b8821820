//! Functions of numbers (manual, "Float Functions").

use super::{Arguments, Builtin, float};
use crate::diagnostic::Result;
use crate::math::fp;
use crate::value::Value;

const fn one(name: &'static str, run: fn(&Arguments) -> Result<Value>) -> Builtin {
    Builtin { name, arity: 1..=1, run }
}

const fn two(name: &'static str, run: fn(&Arguments) -> Result<Value>) -> Builtin {
    Builtin { name, arity: 2..=2, run }
}

const fn many(name: &'static str, run: fn(&Arguments) -> Result<Value>) -> Builtin {
    Builtin { name, arity: 1..=usize::MAX, run }
}

pub(super) const TABLE: &[Builtin] = &[
    one("abs", |a| float(a.float(0)?.abs())),
    one("acos", |a| float(fp::acos(a.float(0)?))),
    one("acosh", |a| float(a.float(0)?.acosh())),
    one("asin", |a| float(fp::asin(a.float(0)?))),
    one("asinh", |a| float(a.float(0)?.asinh())),
    one("atan", |a| float(a.float(0)?.atan())),
    two("atan2", |a| {
        let (y, x) = (a.float(0)?, a.float(1)?);
        if x == 0.0 && y == 0.0 {
            return a.bad(0, "<0, 0> has no direction".into());
        }
        float(fp::atan2(y, x))
    }),
    one("atanh", |a| float(a.float(0)?.atanh())),
    many("bitwise_and", |a| bits(a, |x, y| x & y)),
    many("bitwise_or", |a| bits(a, |x, y| x | y)),
    many("bitwise_xor", |a| bits(a, |x, y| x ^ y)),
    one("ceil", |a| float(a.float(0)?.ceil())),
    one("cos", |a| float(fp::cos(a.float(0)?))),
    one("cosh", |a| float(a.float(0)?.cosh())),
    one("degrees", |a| float(a.float(0)?.to_degrees())),
    two("div", |a| float((a.float(0)? / a.float(1)?).trunc())),
    one("exp", |a| float(fp::exp(a.float(0)?))),
    one("floor", |a| float(a.float(0)?.floor())),
    one("int", |a| float(a.float(0)?.trunc())),
    one("ln", |a| logarithm(a, "ln").map(|x| Value::Float(fp::ln(x)))),
    one("log", |a| logarithm(a, "log").map(|x| Value::Float(x.log10()))),
    many("max", |a| fold(a, f64::max)),
    many("min", |a| fold(a, f64::min)),
    two("mod", |a| float(a.float(0)? % a.float(1)?)),
    two("pow", |a| {
        let (x, y) = (a.float(0)?, a.float(1)?);
        if x == 0.0 && y == 0.0 {
            return a.bad(0, "0 to the power of 0 is not defined".into());
        }
        float(fp::pow(x, y))
    }),
    one("radians", |a| float(a.float(0)?.to_radians())),
    one("sin", |a| float(fp::sin(a.float(0)?))),
    one("sinh", |a| float(a.float(0)?.sinh())),
    one("sqrt", |a| {
        let x = a.float(0)?;
        if x < 0.0 {
            return a.bad(0, format!("{x} has no square root"));
        }
        float(x.sqrt())
    }),
    one("tan", |a| float(fp::tan(a.float(0)?))),
    one("tanh", |a| float(a.float(0)?.tanh())),
];

fn logarithm(a: &Arguments, name: &str) -> Result<f64> {
    let x = a.float(0)?;
    if x <= 0.0 { a.bad(0, format!("`{name}` takes numbers above 0, not {x}")) } else { Ok(x) }
}

fn fold(a: &Arguments, f: fn(f64, f64) -> f64) -> Result<Value> {
    let mut out = a.float(0)?;
    for i in 1..a.len() {
        out = f(out, a.float(i)?);
    }
    float(out)
}

fn bits(a: &Arguments, f: fn(i64, i64) -> i64) -> Result<Value> {
    let mut out = a.float(0)? as i64;
    for i in 1..a.len() {
        out = f(out, a.float(i)? as i64);
    }
    float(out as f64)
}
