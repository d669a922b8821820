//! Built-in functions of the language: one table a group.

mod geometry;
mod numeric;
mod random;
mod special;
mod text;
mod vector;

use super::Interpreter;
use super::eval::as_float;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::numeric::{self as numeric_table, Numeric};
use crate::math::DVec3;
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind};
use crate::value::Value;

/// The longest string.
const MAX_TEXT: usize = 16_000_000;

/// A function of values: its name, how many arguments it takes, and what computes it.
pub(super) struct Builtin {
    name: &'static str,
    /// Its arguments, for the manual.
    usage: &'static str,
    /// One line for the manual.
    summary: &'static str,
    arity: std::ops::RangeInclusive<usize>,
    run: fn(&Arguments) -> Result<Value>,
}

/// Where a function is found.
enum Function {
    Numeric(&'static Numeric),
    Other(&'static Builtin),
}

impl Function {
    fn find(name: &str) -> Option<Self> {
        if let Some(row) = numeric_table::find(name) {
            return Some(Self::Numeric(&numeric_table::TABLE[row as usize]));
        }
        [vector::TABLE, text::TABLE].into_iter().flatten().find(|f| f.name == name).map(Self::Other)
    }

    fn arity(&self) -> std::ops::RangeInclusive<usize> {
        match self {
            Self::Numeric(row) => numeric::arity(row),
            Self::Other(function) => function.arity.clone(),
        }
    }

    fn run(&self, arguments: &Arguments) -> Result<Value> {
        match self {
            Self::Numeric(row) => numeric::compute(row, arguments),
            Self::Other(function) => (function.run)(arguments),
        }
    }
}

/// Evaluated arguments with their places.
pub(super) struct Arguments {
    values: Vec<(Value, Span)>,
}

impl Arguments {
    fn float(&self, i: usize) -> Result<f64> {
        as_float(&self.values[i].0, self.values[i].1)
    }

    fn vector(&self, i: usize) -> Result<DVec3> {
        match &self.values[i].0 {
            Value::Float(x) => Ok(DVec3::splat(*x)),
            Value::Vector(v) if v.len <= 3 => Ok(v.xyz()),
            other => self.wrong(i, "a vector of three numbers", other),
        }
    }

    fn text(&self, i: usize) -> Result<&str> {
        match &self.values[i].0 {
            Value::Text(text) => Ok(text),
            other => self.wrong(i, "a string", other),
        }
    }

    fn wrong<T>(&self, i: usize, wanted: &str, found: &Value) -> Result<T> {
        let message = format!("expected {wanted}, found {}", found.describe());
        Diagnostic::err(codes::WRONG_TYPE, self.values[i].1, message)
    }

    /// The function can't be computed for this argument.
    fn bad<T>(&self, i: usize, message: String) -> Result<T> {
        Diagnostic::err(codes::BAD_ARGUMENT, self.values[i].1, message)
    }

    fn len(&self) -> usize {
        self.values.len()
    }
}

impl<'a> Interpreter<'a> {
    /// Calls the built-in function of this name.
    pub(super) fn builtin(&mut self, name: &'static str, arguments: &'a [Expr], span: Span) -> Result<Value> {
        if let Some(special) = special::TABLE.iter().find(|f| f.name == name) {
            check_count(name, &special.arity, arguments.len(), span)?;
            return (special.run)(self, arguments, span);
        }
        let Some(function) = Function::find(name) else {
            return Diagnostic::err(codes::NOT_YET, span, format!("the function `{name}` is not supported yet"));
        };
        let arity = function.arity();
        let mut values = Vec::with_capacity(arguments.len());
        for argument in arguments {
            self.argument_values(argument, &mut values)?;
        }
        check_count(name, &arity, values.len(), span)?;
        if let ("div" | "mod", Some((Value::Float(0.0), at))) = (name, values.last()) {
            self.division_by_zero(*at);
        }
        let value = function.run(&Arguments { values })?;
        match &value {
            Value::Text(text) if text.len() > MAX_TEXT => {
                let message = format!("this string is longer than {} million bytes", MAX_TEXT / 1_000_000);
                self.limit(codes::MEMORY_LIMIT, span, message, "does a loop make it longer and longer?")
            }
            Value::Text(text) => {
                self.made(text.len(), span)?;
                Ok(value)
            }
            _ => Ok(value),
        }
    }

    /// One argument; a macro may give several.
    fn argument_values(&mut self, argument: &'a Expr, out: &mut Vec<(Value, Span)>) -> Result<()> {
        let values = match &argument.kind {
            ExprKind::Call(name, arguments) if self.is_macro(*name) => {
                self.macro_values(*name, arguments, argument.span)?
            }
            _ => vec![self.eval(argument)?],
        };
        out.extend(values.into_iter().map(|value| (value, argument.span)));
        Ok(())
    }
}

/// An error unless the function takes so many arguments.
fn check_count(name: &str, arity: &std::ops::RangeInclusive<usize>, found: usize, span: Span) -> Result<()> {
    if arity.contains(&found) {
        return Ok(());
    }
    let (low, high) = (arity.start(), arity.end());
    let takes = match high {
        &usize::MAX => format!("at least {low}"),
        high if low == high => low.to_string(),
        high => format!("{low} to {high}"),
    };
    let plural = if takes == "1" { "" } else { "s" };
    let message = format!("`{name}` takes {takes} argument{plural}, found {found}");
    Diagnostic::err(codes::WRONG_COUNT, span, message)
}

/// Every function of scripts that is in none of `function { }`'s tables: name, arguments, one line.
pub(super) fn usages() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    let plain = [vector::TABLE, text::TABLE].into_iter().flatten().map(|f| (f.name, f.usage, f.summary));
    plain.chain(special::TABLE.iter().map(|f| (f.name, f.usage, f.summary)))
}

fn float(x: f64) -> Result<Value> {
    Ok(Value::Float(x))
}
