//! `#if`, `#ifdef`, `#while`, `#for`, `#switch`.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::operators::SMALL;
use crate::interpreter::scope::Slot;
use crate::interpreter::stream::FrameKind;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::Value;

impl<'a> Interpreter<'a> {
    pub(in crate::interpreter) fn condition(&mut self, condition: &'a Expr) -> Result<bool> {
        Ok(self.number(condition)?.abs() > SMALL)
    }

    pub(in crate::interpreter) fn branch(&mut self, branches: &'a [Branch], span: Span) -> Result<()> {
        for branch in branches {
            let taken = match &branch.condition {
                Condition::True(e) => self.condition(e)?,
                Condition::Declared(e) => self.is_declared(e)?,
                Condition::NotDeclared(e) => !self.is_declared(e)?,
                Condition::Always => true,
            };
            if taken {
                self.push_frame(&branch.body, FrameKind::Branch, span);
                break;
            }
        }
        Ok(())
    }

    pub(super) fn is_declared(&mut self, e: &'a Expr) -> Result<bool> {
        match &e.kind {
            // The language's own constants are not declared.
            ExprKind::Name(symbol) => Ok(self.scopes.get(*symbol).is_some()),
            ExprKind::Index(array, indices) => {
                if !self.is_declared(array)? {
                    return Ok(false);
                }
                if let Some(place) = self.dictionary_place(array)? {
                    return self.has_keys(place, indices);
                }
                let place = self.element_place(array, indices)?;
                Ok(self.scopes.at(&place).is_some())
            }
            ExprKind::Dot(base, _, symbol) => {
                let place = self.dictionary_place(base)?;
                let key = self.names.text(*symbol);
                Ok(matches!(place.and_then(|p| self.scopes.at(&p)), Some(Slot::Array(array)) if array.has_key(key)))
            }
            ExprKind::Paren(inner) => self.is_declared(inner),
            _ => Diagnostic::err(codes::WRONG_TYPE, e.span, "`#ifdef` takes a name"),
        }
    }

    pub(in crate::interpreter) fn while_loop(
        &mut self,
        condition: &'a Expr,
        body: &'a [Element],
        span: Span,
    ) -> Result<()> {
        if self.condition(condition)? {
            self.push_frame(body, FrameKind::While(condition), span);
        }
        Ok(())
    }

    pub(in crate::interpreter) fn for_loop(&mut self, f: &'a For, span: Span) -> Result<()> {
        let first = self.number(&f.range[0])?;
        let Some(last) = f.range.get(1) else {
            return Diagnostic::err(codes::WRONG_COUNT, span, "`#for` takes a name, a first and a last value");
        };
        let last = self.number(last)?;
        let step = f.range.get(2).map_or(Ok(1.0), |e| self.number(e))?;
        if step.is_nan() || step.abs() < SMALL {
            let at = f.range.get(2).map_or(span, |e| e.span);
            return Diagnostic::err(codes::ZERO_STEP, at, format!("a step of {step} would never reach the last value"));
        }
        self.scopes.set_local(f.counter, Slot::Value(Value::Float(first)), vec![]);
        if within(first, last, step) {
            self.push_frame(&f.body, FrameKind::For { counter: f.counter, last, step }, span);
        }
        Ok(())
    }

    /// Adds the step to the counter, which the body may have changed; is there another pass?
    pub(in crate::interpreter) fn advance_counter(
        &mut self,
        counter: Symbol,
        last: f64,
        step: f64,
        span: Span,
    ) -> Result<bool> {
        let Some(Slot::Value(Value::Float(value))) = self.scopes.get(counter) else {
            let name = self.names.text(counter);
            return Diagnostic::err(codes::WRONG_TYPE, span, format!("the counter `{name}` is no longer a number"));
        };
        let next = value + step;
        self.scopes.set_global(counter, Slot::Value(Value::Float(next)), vec![]);
        Ok(within(next, last, step))
    }

    /// Runs the first arm that fits and all after it until a `#break`.
    pub(in crate::interpreter) fn switch(&mut self, value: &'a Expr, arms: &'a [Arm], span: Span) -> Result<()> {
        let value = self.number(value)?;
        for (i, arm) in arms.iter().enumerate() {
            let fits = match &arm.when {
                When::Case(e) => (self.number(e)? - value).abs() < SMALL,
                When::Range(a, b) => {
                    let (a, b) = (self.number(a)?, self.number(b)?);
                    value >= a - SMALL && value <= b + SMALL
                }
                When::Otherwise => true,
            };
            if fits {
                // Fall-through, also into `#else`: later arms lie below on the stack.
                self.push_frame(&[], FrameKind::Switch, span);
                for arm in arms[i..].iter().rev() {
                    self.push_frame(&arm.body, FrameKind::Branch, span);
                }
                break;
            }
        }
        Ok(())
    }
}

fn within(value: f64, last: f64, step: f64) -> bool {
    if step > 0.0 { value <= last + SMALL } else { value >= last - SMALL }
}
