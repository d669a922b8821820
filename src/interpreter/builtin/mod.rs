//! Calls of built-in functions in scripts, with one table for each group of functions.

mod geometry;
mod numeric;
mod random;
mod special;
mod text;
mod vector;

pub(super) use text::leading_number_and_length;

use super::Interpreter;
use super::argument::Argument;
use super::evaluator::{VECTOR_FUNCTIONS, VectorFunction, as_float, as_vector};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::numeric::{self as numeric_table, Domain, Numeric};
use crate::math::DVec3;
use crate::source::Span;
use crate::syntax::ast::Expr;
use crate::syntax::word::{Word, WordTable};
use crate::value::Value;
use smallvec::SmallVec;
use special::Special;
use std::ops::RangeInclusive;
use std::sync::LazyLock;

/// Maximum length of a string in bytes.
const MAX_TEXT: usize = 16_000_000;

/// Built-in function whose arguments and result are values of any type.
pub(super) struct Builtin {
    name: &'static str,
    /// Arguments of the built-in function as the manual prints them.
    usage: &'static str,
    /// Summary of the built-in function for the manual.
    summary: &'static str,
    arity: RangeInclusive<usize>,
    run: fn(&Arguments) -> Result<Value>,
}

/// Table row of a built-in function, by the type of its arguments.
#[derive(Clone, Copy)]
enum Function {
    /// Built-in function whose arguments and result are numbers.
    Numeric(&'static Numeric),
    /// Built-in function whose arguments are vectors.
    Vector(&'static VectorFunction),
    /// Built-in function whose arguments are values of any type.
    Plain(&'static Builtin),
    /// Built-in function whose arguments are names, array elements or objects.
    Special(&'static Special),
}

/// All built-in functions of the scene language by word.
static FUNCTIONS: LazyLock<WordTable<Function>> = LazyLock::new(|| {
    let numeric = numeric_table::TABLE.iter().map(|row| (row.name, Function::Numeric(row)));
    let special = special::TABLE.iter().map(|row| (row.name, Function::Special(row)));
    let vector = VECTOR_FUNCTIONS.iter().map(|row| (row.name, Function::Vector(row)));
    let plain = plain_builtins().map(|row| (row.name, Function::Plain(row)));
    WordTable::new(numeric.chain(vector).chain(plain).chain(special))
});

fn plain_builtins() -> impl Iterator<Item = &'static Builtin> {
    [vector::TABLE, text::TABLE].into_iter().flatten()
}

/// Evaluated arguments of a built-in function with their spans.
pub(super) struct Arguments {
    values: Vec<(Value, Span)>,
}

impl Arguments {
    fn float(&self, i: usize) -> Result<f64> {
        as_float(&self.values[i].0, self.values[i].1)
    }

    fn vector(&self, i: usize) -> Result<DVec3> {
        as_vector(&self.values[i].0, self.values[i].1)
    }

    fn text(&self, i: usize) -> Result<&str> {
        match &self.values[i].0 {
            Value::Text(text) => Ok(text),
            other => self.wrong_type_error(i, "a string", other),
        }
    }

    fn wrong_type_error<T>(&self, i: usize, wanted: &str, found: &Value) -> Result<T> {
        let message = format!("expected {wanted}, found {}", found.describe());
        Diagnostic::err(codes::WRONG_TYPE, self.values[i].1, message)
    }

    /// Returns the error for an argument outside of the function's domain.
    fn domain_error<T>(&self, i: usize, message: String) -> Result<T> {
        Diagnostic::err(codes::BAD_ARGUMENT, self.values[i].1, message)
    }

    fn len(&self) -> usize {
        self.values.len()
    }
}

impl<'a> Interpreter<'a> {
    /// Calls a built-in function with parsed arguments.
    pub(super) fn call_builtin(&mut self, word: &'static Word, arguments: &'a [Expr], span: Span) -> Result<Value> {
        let name = word.name;
        match found_or_error(FUNCTIONS.get(word), name, span)? {
            Function::Special(row) => {
                check_argument_count(name, &row.arity, arguments.len(), span)?;
                let mut given = SmallVec::<[Argument<'a>; 4]>::new();
                for argument in arguments {
                    given.push(self.argument_of_expression(argument)?);
                }
                (row.run)(self, &given, span)
            }
            function => {
                let mut values = Vec::with_capacity(arguments.len());
                for argument in arguments {
                    values.push((self.evaluate(argument)?, argument.span));
                }
                self.compute(name, function, Arguments { values }, span)
            }
        }
    }

    /// Calls a built-in function with arguments read token by token.
    pub(super) fn call_builtin_by_tokens(
        &mut self,
        name: &'static str,
        arguments: SmallVec<[Argument<'a>; 4]>,
        span: Span,
    ) -> Result<Value> {
        match found_or_error(FUNCTIONS.get_by_spelling(name), name, span)? {
            Function::Special(Special { run, arity, .. }) => {
                check_argument_count(name, arity, arguments.len(), span)?;
                run(self, &arguments, span)
            }
            function => {
                let value = |argument: &Argument<'a>| Ok((self.argument_value(argument)?, argument.span));
                let values = arguments.iter().map(value).collect::<Result<_>>()?;
                self.compute(name, function, Arguments { values }, span)
            }
        }
    }

    /// Calls a built-in function with evaluated arguments of any type.
    fn compute(&mut self, name: &str, function: Function, arguments: Arguments, span: Span) -> Result<Value> {
        let found = arguments.values.len();
        match function {
            Function::Numeric(row) => {
                check_argument_count(name, &numeric::arity(row), found, span)?;
                if let (Domain::Divides, Some((Value::Float(0.0), at))) = (row.domain, arguments.values.last()) {
                    self.report_division_by_zero(*at);
                }
                numeric::compute(row, &arguments)
            }
            Function::Vector(row) => {
                check_argument_count(name, &(row.arity()..=row.arity()), found, span)?;
                row.call(|i| arguments.vector(i)).map(Value::from)
            }
            Function::Plain(row) => {
                check_argument_count(name, &row.arity, found, span)?;
                let value = (row.run)(&arguments)?;
                self.count_and_limit_text(&value, span)?;
                Ok(value)
            }
            Function::Special(_) => Ok(Value::Float(0.0)),
        }
    }

    /// Counts the bytes of a string result, and limits its length.
    fn count_and_limit_text(&mut self, value: &Value, span: Span) -> Result<()> {
        match value {
            Value::Text(text) if text.len() > MAX_TEXT => {
                let message = format!("this string is longer than {} million bytes", MAX_TEXT / 1_000_000);
                self.reporter.limit_error(codes::MEMORY_LIMIT, span, message, "does a loop make it longer and longer?")
            }
            Value::Text(text) => self.reporter.check_limits_after_text(text.len(), span),
            _ => Ok(()),
        }
    }
}

/// True if commas between the arguments are mandatory.
pub(super) fn needs_commas(name: &str) -> bool {
    matches!(FUNCTIONS.get_by_spelling(name), Some(Function::Numeric(row)) if matches!(row.kernel, numeric_table::Kernel::Many(_)))
}

/// Returns the built-in function; an error for `None`, with which a word is not a function of scripts.
fn found_or_error(function: Option<&Function>, name: &str, span: Span) -> Result<Function> {
    match function {
        Some(&function) => Ok(function),
        None => Diagnostic::err(codes::NOT_YET, span, format!("the function `{name}` is not supported yet")),
    }
}

/// Checks the number of arguments of a function's call.
fn check_argument_count(name: &str, arity: &RangeInclusive<usize>, found: usize, span: Span) -> Result<()> {
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

/// Returns name, arguments and summary of each function that scripts have and `function { }` does not.
pub(super) fn script_only_usages() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    let vector = VECTOR_FUNCTIONS.iter().map(|f| (f.name, f.usage, f.summary));
    vector
        .chain(plain_builtins().map(|f| (f.name, f.usage, f.summary)))
        .chain(special::TABLE.iter().map(|f| (f.name, f.usage, f.summary)))
}

fn float(x: f64) -> Result<Value> {
    Ok(Value::Float(x))
}
