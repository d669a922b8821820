//! Evaluates expressions of the syntax tree. Expressions in which a macro produces tokens, or that following tokens
//! continue, are read token by token in [`super::token_expr`].

use super::Interpreter;
use super::evaluator::{
    TOLERANCE, apply_prefix, as_float, combine, component, divides_by_zero, not_text_error, vector_value,
};

use super::evaluator::{Contents, Quick};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::Value;
use smallvec::SmallVec;

impl<'a> Interpreter<'a> {
    /// Evaluates an expression of the syntax tree to a value.
    pub(super) fn evaluate(&mut self, e: &'a Expr) -> Result<Value> {
        if let Some(value) = self.evaluator.quick::<Quick>(e) {
            return Ok(value.into());
        }
        match &e.kind {
            ExprKind::Number(x) => Ok(Value::Float(*x)),
            ExprKind::Text(text) => Ok(Value::Text((**text).into())),
            ExprKind::Name(symbol) => self.evaluate_name(*symbol, e.span),
            ExprKind::Literal(data) => vector_value(data, e.span),
            ExprKind::Vector(parts) => self.evaluate_vector(parts, e.span),
            ExprKind::Paren(inner) => self.evaluate(inner),
            ExprKind::Chain(chain) => self.evaluate_operator_chain(chain),
            ExprKind::Prefix(prefix, inner) => {
                let value = self.evaluate(inner)?;
                apply_prefix(*prefix, value, inner.span)
            }
            ExprKind::Call(name, arguments) => self.call_declared(*name, arguments, e.span),
            ExprKind::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                // quirk: choices_evaluate_all
                let (is_true, yes, no) = (self.is_true(condition)?, self.evaluate(yes)?, self.evaluate(no)?);
                Ok(if is_true { yes } else { no })
            }
            ExprKind::Builtin(name, arguments) => self.call_builtin(name, arguments, e.span),
            ExprKind::Dot(..) => self.evaluate_member_access(e),
            ExprKind::Index(array, indices) => {
                let contents = self.evaluate_array_access(array, indices, e.span)?;
                self.value_of_contents(contents, e.span)
            }
            ExprKind::Apply(function, arguments) => {
                let function = self.evaluate(function)?;
                self.call_array_element(&function, arguments, e.span)
            }
            ExprKind::Function(_) | ExprKind::Block(_) => {
                Diagnostic::err(codes::EXPECTED_VALUE, e.span, "expected a number or text, found a block")
            }
        }
    }

    /// Evaluates a member access such as `A.x`, without recursion for a chain such as `A.B.C`.
    fn evaluate_member_access(&mut self, e: &'a Expr) -> Result<Value> {
        if let Some(lvalue) = self.dictionary_lvalue(e)? {
            let contents = self.evaluator.contents_at(&lvalue, e.span)?;
            return self.value_of_contents(contents, e.span);
        }
        let (mut base, mut names) = (e, vec![]);
        while let ExprKind::Dot(inner, name, _) = &base.kind
            && self.evaluator.prefixed_lvalue(base).is_none()
        {
            names.push((name, inner.span));
            base = inner;
        }
        let value = self.evaluate(base)?;
        names.iter().rev().try_fold(value, |value, (name, span)| component(&value, name, *span))
    }

    /// True if the expression's number differs from 0 by more than [`TOLERANCE`].
    pub(super) fn is_true(&mut self, e: &'a Expr) -> Result<bool> {
        Ok(self.evaluate_number(e)?.abs() > TOLERANCE)
    }

    /// Evaluates an expression to a number.
    pub(super) fn evaluate_number(&mut self, e: &'a Expr) -> Result<f64> {
        if let Some(x) = self.evaluator.quick_number(e) {
            return Ok(x);
        }
        let value = self.evaluate(e)?;
        as_float(&value, e.span)
    }

    /// Evaluates an expression to a string.
    pub(super) fn evaluate_text(&mut self, e: &'a Expr) -> Result<String> {
        match self.evaluate(e)? {
            Value::Text(text) => Ok(text.to_string()),
            other => not_text_error(&other, e.span),
        }
    }

    /// Returns the value of a name. The first use reports the warnings about the name's declaration. An error for an
    /// undeclared name, after a failed declaration, and for the name of an array, a file or a macro.
    pub(super) fn evaluate_name(&mut self, symbol: Symbol, span: Span) -> Result<Value> {
        match self.evaluator.scopes().get(symbol) {
            Some(Contents::Value(Value::Thing(thing))) => {
                let thing = thing.clone();
                self.report_first_use(symbol, span);
                Ok(Value::Thing(thing))
            }
            Some(Contents::Value(value)) => {
                let value = value.clone();
                if self.evaluator.has_deprecations() {
                    self.report_first_use(symbol, span);
                }
                Ok(value)
            }
            Some(contents @ (Contents::Faulty(_) | Contents::Macro(_) | Contents::Array(_) | Contents::File(_))) => {
                let contents = contents.clone();
                self.value_of_contents(contents, span)
            }
            Some(Contents::Alias(_)) | None => match self.evaluator.constant(symbol) {
                Some(value) => Ok(value),
                None => self.undeclared_name_error(symbol, span).into(),
            },
        }
    }

    /// Returns the value in `contents`; an error for an array, a file, a macro and a failed declaration, whose faults
    /// are reported here.
    pub(super) fn value_of_contents(&mut self, contents: Contents<'a>, span: Span) -> Result<Value> {
        match contents {
            Contents::Value(value) => Ok(value),
            Contents::Faulty(faults) => {
                for fault in faults.iter() {
                    self.reporter.report(fault.clone());
                }
                Diagnostic::err(codes::FOLLOWS, span, "")
            }
            Contents::Macro(definition) => {
                let name = self.inputs.names.text(definition.name);
                Diagnostic::new(codes::EXPECTED_VALUE, span, format!("`{name}` is a macro"))
                    .help(format!("a call needs parentheses: `{name}()`"))
                    .into()
            }
            Contents::File(_) => {
                let name = self.inputs.sources.snippet(span);
                Diagnostic::err(codes::EXPECTED_VALUE, span, format!("`{name}` is a file"))
            }
            Contents::Array(_) | Contents::Alias(_) => {
                let name = self.inputs.sources.snippet(span);
                Diagnostic::new(codes::EXPECTED_VALUE, span, format!("`{name}` is an array"))
                    .help(format!("`{name}[0]` is its first element"))
                    .into()
            }
        }
    }

    /// Reports the warnings about a declaration, at the first use of the declared name.
    pub(super) fn report_first_use(&mut self, symbol: Symbol, span: Span) {
        for warning in self.evaluator.scopes().pending_warnings(symbol).iter().flat_map(|p| p.iter()) {
            self.reporter.report(warning.clone());
        }
        if let Some(why) = self.evaluator.take_deprecation(symbol) {
            let message = format!("`{}` is deprecated: {}", self.inputs.names.text(symbol), why.trim());
            self.reporter.report(Diagnostic::new(codes::DEPRECATED, span, message));
        }
    }

    /// Applies a binary operator, and reports a division by zero.
    pub(super) fn combine(&mut self, op: Operator, left: (Value, Span), right: (Value, Span)) -> Result<Value> {
        if divides_by_zero(op, &right.0) {
            let value = combine(op, left.0, right.0, left.1, right.1)?;
            self.report_division_by_zero(right.1);
            return Ok(value);
        }
        combine(op, left.0, right.0, left.1, right.1)
    }

    /// Evaluates operators of one precedence from left to right.
    fn evaluate_operator_chain(&mut self, chain: &'a Chain) -> Result<Value> {
        let mut span = chain.first.span;
        let mut left = self.evaluate(&chain.first)?;
        for (op, operand) in &chain.rest {
            let right = self.evaluate(operand)?;
            left = self.combine(*op, (left, span), (right, operand.span))?;
            span = span.to(operand.span);
        }
        Ok(left)
    }

    /// Evaluates a vector `< … >`.
    fn evaluate_vector(&mut self, parts: &'a [Element], span: Span) -> Result<Value> {
        let mut data = SmallVec::<[f64; 5]>::new();
        for part in parts {
            if let ElementKind::Expr(e) = &part.kind {
                data.push(self.evaluate_number(e)?);
            }
        }
        vector_value(&data, span)
    }

    /// Evaluates a list of numbers, such as the arguments of a function.
    pub(super) fn evaluate_numbers(&mut self, parts: &'a [Element]) -> Result<Vec<f64>> {
        let mut all = Vec::with_capacity(parts.len());
        for part in parts {
            match &part.kind {
                ElementKind::Expr(e) => all.push(self.evaluate_number(e)?),
                ElementKind::Numbers(list) => all.extend(list.data.iter()),
                _ => return Diagnostic::err(codes::EXPECTED_VALUE, part.span, "expected a number"),
            }
        }
        Ok(all)
    }
}
