//! Calls of functions and splines in scripts.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::{Function, ResultType, Spline, SplineKind};
use crate::interpreter::Interpreter;
use crate::interpreter::evaluator::{Contents, as_float};
use crate::interpreter::stream::Token;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::{Reader, Value, VecN, downcast};

impl<'a> Interpreter<'a> {
    /// Calls a declared function or spline. (A call of a built-in function is another kind of expression.)
    ///
    /// # Errors
    /// If `name` is not declared, or declared as anything else.
    pub fn call_declared(&mut self, name: Symbol, arguments: &'a [Element], span: Span) -> Result<Value> {
        if let Some(spline) = self.evaluator.thing_of::<Spline>(name) {
            return self.call_spline(&spline, arguments, span);
        }
        if let Some(&Contents::Macro(definition)) = self.evaluator.scopes().get(name)
            && let Some(value) = self.call_value_macro(definition, arguments, span)?
        {
            return Ok(value);
        }
        let Some(function) = self.evaluator.thing_of::<Function>(name) else {
            self.evaluate_name(name, span)?;
            let text = self.inputs.names.text(name);
            return Diagnostic::err(codes::NOT_CALLABLE, span, format!("`{text}` is neither a macro nor a function"));
        };
        let numbers = self.evaluate_numbers(arguments)?;
        let name = Span { hi: span.lo + self.inputs.names.text(name).len() as u32, ..span };
        self.check_arity(name, numbers.len(), function.arity())?;
        Ok(call_to_value(&function, &numbers))
    }

    /// Calls a function or spline that is an array's element.
    pub fn call_array_element(&mut self, thing: &Value, arguments: &'a [Element], span: Span) -> Result<Value> {
        if let Value::Thing(thing) = thing {
            if let Some(spline) = downcast::<Spline>(thing) {
                return self.call_spline(&spline, arguments, span);
            }
            if let Some(function) = downcast::<Function>(thing) {
                let numbers = self.evaluate_numbers(arguments)?;
                if numbers.len() == function.arity() {
                    return Ok(call_to_value(&function, &numbers));
                }
                let message = format!("this function takes {} arguments, found {}", function.arity(), numbers.len());
                return Diagnostic::err(codes::WRONG_COUNT, span, message);
            }
        }
        Diagnostic::err(codes::NOT_CALLABLE, span, format!("{} can't be called", thing.describe()))
    }

    /// Calls a spline: `S(0.5)` or `S(0.5, cubic_spline)`.
    fn call_spline(&mut self, spline: &Spline, arguments: &'a [Element], span: Span) -> Result<Value> {
        self.read_contents(arguments, Bracket::Paren, span, |me| me.read_spline_arguments(spline))
    }

    fn read_spline_arguments(&mut self, spline: &Spline) -> Result<Value> {
        let t = self.float()?;
        let kind = match self.peek()? {
            Token::Word(word) if SplineKind::from_word(word).is_some() => {
                self.stream.advance();
                SplineKind::from_word(word).unwrap_or(spline.kind)
            }
            _ => spline.kind,
        };
        if self.peek()?.is_closer_or_end() {
            return Ok(Value::Vector(VecN { c: spline.point_at(t, kind), len: spline.len }));
        }
        Err(self.unexpected_token("one number and, at most, the kind of spline").into())
    }

    /// Reads the arguments of a function or spline up to the `)`, and calls it. The `(` has been consumed.
    pub fn read_arguments_and_call(&mut self, callee: &Value, span: Span) -> Result<Value> {
        if let Value::Thing(thing) = callee {
            if let Some(spline) = downcast::<Spline>(thing) {
                return self.read_spline_arguments(&spline);
            }
            if let Some(function) = downcast::<Function>(thing) {
                let mut numbers = vec![];
                while !self.peek()?.is_closer_or_end() {
                    let (value, at) = self.read_value()?;
                    numbers.push(as_float(&value, at)?);
                }
                self.check_arity(span, numbers.len(), function.arity())?;
                return Ok(call_to_value(&function, &numbers));
            }
        }
        Diagnostic::err(codes::NOT_CALLABLE, span, format!("{} can't be called", callee.describe()))
    }
}

fn call_to_value(function: &Function, numbers: &[f64]) -> Value {
    let c = function.call(numbers);
    match function.result_type() {
        ResultType::Number => Value::Float(c[0]),
        ResultType::Vector(len) => Value::Vector(VecN { c, len }),
        ResultType::Color => Value::Color(crate::color::Color::from_array(c)),
    }
}
