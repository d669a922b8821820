//! Calls of functions and splines in scripts.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::{Function, Gives, Spline, SplineKind};
use crate::interpreter::Interpreter;
use crate::interpreter::stream::Token;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::{Reader, Value, VecN, downcast};

impl<'a> Interpreter<'a> {
    /// A call of a function or spline in a script.
    pub(in crate::interpreter) fn call_value(
        &mut self,
        name: Symbol,
        arguments: &'a [Element],
        span: Span,
    ) -> Result<Value> {
        if let Some(spline) = self.thing_of::<Spline>(name) {
            return self.call_spline(&spline, arguments, span);
        }
        let Some(function) = self.thing_of::<Function>(name) else {
            self.name_value(name, span)?;
            let text = self.names.text(name);
            return Diagnostic::err(codes::NOT_CALLABLE, span, format!("`{text}` is neither a macro nor a function"));
        };
        let numbers = self.call_numbers(arguments, span)?;
        self.check_count(name, numbers.len(), function.arity(), span)?;
        Ok(answer(&function, &numbers))
    }

    /// A call of an array's element.
    pub(in crate::interpreter) fn call_thing(
        &mut self,
        thing: &Value,
        arguments: &'a [Element],
        span: Span,
    ) -> Result<Value> {
        if let Value::Thing(thing) = thing {
            if let Some(spline) = downcast::<Spline>(thing) {
                return self.call_spline(&spline, arguments, span);
            }
            if let Some(function) = downcast::<Function>(thing) {
                let numbers = self.call_numbers(arguments, span)?;
                if numbers.len() == function.arity() {
                    return Ok(answer(&function, &numbers));
                }
                let message = format!("this function takes {} arguments, found {}", function.arity(), numbers.len());
                return Diagnostic::err(codes::WRONG_COUNT, span, message);
            }
        }
        Diagnostic::err(codes::NOT_CALLABLE, span, format!("{} can't be called", thing.describe()))
    }

    fn call_numbers(&mut self, arguments: &'a [Element], span: Span) -> Result<Vec<f64>> {
        // The common case, without a frame.
        if arguments.iter().all(|a| self.is_plain(a)) {
            let number = |a: &'a Element| match &a.kind {
                ElementKind::Expr(e) => self.number(e),
                _ => Ok(0.0),
            };
            return arguments.iter().map(number).collect();
        }
        self.numbers_in(arguments, span)
    }

    /// `S(0.5)`, `S(0.5, cubic_spline)`
    fn call_spline(&mut self, spline: &Spline, arguments: &'a [Element], span: Span) -> Result<Value> {
        self.enclosed(None, arguments, span, |me| {
            let t = me.float()?;
            let kind = match me.peek()? {
                Token::Word(word) if SplineKind::of(word).is_some() => {
                    me.advance();
                    SplineKind::of(word).unwrap_or(spline.kind)
                }
                _ => spline.kind,
            };
            match me.peek()? {
                Token::End => Ok(Value::Vector(VecN { c: spline.at(t, kind), len: spline.len })),
                _ => Err(me.unexpected_token("one number and, at most, the kind of spline").into()),
            }
        })
    }
}

fn answer(function: &Function, numbers: &[f64]) -> Value {
    let c = function.call(numbers);
    match function.gives() {
        Gives::Number => Value::Float(c[0]),
        Gives::Vector(len) => Value::Vector(VecN { c, len }),
        Gives::Color => Value::Color(crate::color::Color::from_array(c)),
    }
}
