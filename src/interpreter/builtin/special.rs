//! Functions whose arguments are names, arrays, objects or files, or values of any type.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::argument::{Argument, ArgumentForm};
use crate::source::Span;
use crate::value::Value;
use std::ops::RangeInclusive;

/// Table row of a built-in function with a syntax of its own.
pub(super) struct Special {
    /// Name of the built-in function.
    pub name: &'static str,
    /// Arguments of the built-in function as the manual prints them.
    pub usage: &'static str,
    /// Summary of the built-in function for the manual.
    pub summary: &'static str,
    /// Numbers of arguments that the built-in function takes.
    pub arity: RangeInclusive<usize>,
    /// Function that computes the built-in function's result.
    pub run: Run,
}

/// Function that computes a built-in function's result from the arguments and the span of the call.
pub(super) type Run = for<'a> fn(&mut Interpreter<'a>, &[Argument<'a>], Span) -> Result<Value>;

pub(super) const TABLE: &[Special] = &[
    Special {
        name: "defined",
        usage: "(Name)",
        summary: "is there something of this name?",
        arity: 1..=1,
        run: |me, a, span| me.is_defined(&a[0], span),
    },
    Special {
        name: "select",
        usage: "(A, B, C [, D])",
        summary: "B if A < 0, C if A = 0, D if A > 0; without D, C if A >= 0",
        arity: 3..=4,
        run: |me, a, _| me.select(&a[0], &a[1..]),
    },
    Special {
        name: "file_exists",
        usage: "(Text)",
        summary: "is there a file of this name that the scene may read?",
        arity: 1..=1,
        run: |me, a, _| me.file_exists(&a[0]),
    },
    Special {
        name: "dimensions",
        usage: "(Array)",
        summary: "how many indices it takes",
        arity: 1..=1,
        run: |me, a, _| me.array_argument(&a[0]).map(|array| Value::Float(array.sizes.len() as f64)),
    },
    Special {
        name: "dimension_size",
        usage: "(Array, N)",
        summary: "how many elements it has along its N-th index, counted from 1",
        arity: 2..=2,
        run: |me, a, _| me.dimension_size(&a[0], &a[1]),
    },
    Special {
        name: "trace",
        usage: "(Object, From, Direction [, Normal])",
        summary: "where a ray meets the object; the name Normal is set to the surface's normal there, or to <0, 0, 0> if it misses",
        arity: 3..=4,
        run: |me, a, _| me.trace_object(&a[0], &a[1], &a[2], a.get(3)),
    },
    Special {
        name: "inside",
        usage: "(Object, Point)",
        summary: "is the point in the object?",
        arity: 2..=2,
        run: |me, a, _| me.inside_object(&a[0], &a[1]),
    },
    Special {
        name: "min_extent",
        usage: "(Object)",
        summary: "the corner of the box around it with the smallest x, y and z",
        arity: 1..=1,
        run: |me, a, _| me.extent_corner(&a[0], false),
    },
    Special {
        name: "max_extent",
        usage: "(Object)",
        summary: "the opposite corner",
        arity: 1..=1,
        run: |me, a, _| me.extent_corner(&a[0], true),
    },
    Special {
        name: "seed",
        usage: "(Number)",
        summary: "a new stream of random numbers, the same for the same number",
        arity: 1..=1,
        run: |me, a, _| me.seed(&a[0]),
    },
    Special {
        name: "rand",
        usage: "(Stream)",
        summary: "the stream's next number, from 0 to 1",
        arity: 1..=1,
        run: |me, a, _| me.rand(&a[0]),
    },
];

impl<'a> Interpreter<'a> {
    fn is_defined(&mut self, argument: &Argument<'a>, span: Span) -> Result<Value> {
        match argument.given {
            ArgumentForm::Contents(_) => Diagnostic::err(codes::WRONG_TYPE, span, "`defined` takes a name"),
            _ => Ok(Value::Float(f64::from(self.is_argument_defined(argument)))),
        }
    }

    /// Evaluates `file_exists(Path)`: 1 if the file exists and the scene may read it, else 0.
    fn file_exists(&mut self, path: &Argument<'a>) -> Result<Value> {
        let name = self.argument_text(path)?;
        let found = self
            .inputs
            .options
            .search
            .find_exact(self.inputs.files, &name)
            .filter(|path| self.inputs.files.may_read(path));
        Ok(Value::Float(f64::from(found.is_some())))
    }

    /// Evaluates `select(A, B, C [, D])`: B if A < 0, C if A = 0 (or A ≥ 0 without D), else D.
    fn select(&mut self, condition: &Argument<'a>, rest: &[Argument<'a>]) -> Result<Value> {
        let a = self.argument_number(condition)?;
        match rest {
            [b, _] | [b, _, _] if a < 0.0 => self.argument_value(b),
            [_, c] => self.argument_value(c),
            [_, c, _] if a == 0.0 => self.argument_value(c),
            [.., d] => self.argument_value(d),
            [] => Ok(Value::Float(0.0)),
        }
    }
}
