//! Calls in pieces: a function's name, and its parentheses from wherever they come.

use super::joined;
use super::skipped::Skipped;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::argument::Argument;
use crate::interpreter::evaluator::as_float;
use crate::interpreter::stream::Token;
use crate::interpreter::{Interpreter, builtin};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::begins_with_parenthesis;
use crate::value::Value;
use smallvec::SmallVec;

impl<'a> Interpreter<'a> {
    /// Does a `(` come next, behind the name of a function? To see it, POV-Ray runs what stands there even where it would
    /// wait for the end of a value. (A declaration could be of no use for that, and may use the name that is being declared.)
    pub(in crate::interpreter) fn call_follows(&mut self) -> Result<bool> {
        let declares = |e: &Directive| matches!(e, Directive::Declare(_) | Directive::DeclarePieces(_));
        let waits = matches!(self.stream.raw().map(|e| &e.kind), Some(ElementKind::Directive(d)) if declares(d));
        let next = self.in_mode(|mode| mode.defers = waits, Self::peek_after);
        if matches!(next?, Some(Token::Expr(e)) if begins_with_parenthesis(e)) {
            self.expose_parenthesis()?;
        }
        Ok(matches!(self.peek_after()?, Some(Token::Open(Bracket::Paren, _))))
    }

    /// `name ( … )` of a built-in function.
    pub(super) fn read_builtin_call(&mut self, word: &'static str, span: Span) -> Result<(Value, Span)> {
        self.stream.advance();
        self.expect_paren(word)?;
        if word == "select" {
            return self.read_select(span);
        }
        let mut arguments = SmallVec::<[Argument<'a>; 4]>::new();
        while !self.peek()?.closes(Bracket::Paren) {
            // (Only where there may be any number of arguments, the commas have to be there: measured on POV-Ray 3.7.)
            if !arguments.is_empty() && !self.stream.has_comma() && builtin::needs_commas(word) {
                let at = self.stream.here();
                return Err(self.misplaced(at).into());
            }
            arguments.push(self.read_argument()?);
        }
        let end = self.stream.here();
        self.close("`)`")?;
        let span = joined(span, end);
        Ok((self.builtin_of(word, arguments, span)?, span))
    }

    /// Takes apart what comes next, until its `(` is a token.
    pub(in crate::interpreter) fn expose_parenthesis(&mut self) -> Result<()> {
        while matches!(self.peek()?, Token::Expr(e) if begins_with_parenthesis(e)) {
            self.stream.split_next();
        }
        Ok(())
    }

    /// The `(` behind the name of a function, which is consumed.
    pub(in crate::interpreter) fn expect_paren(&mut self, word: &str) -> Result<()> {
        self.expose_parenthesis()?;
        match self.peek()? {
            Token::Open(Bracket::Paren, _) => self.open().map(drop),
            _ => Err(self.unexpected_token(&format!("`(` behind `{word}`")).into()),
        }
    }

    /// `A, B, C [, D])`: only the one that is meant is computed.
    fn read_select(&mut self, span: Span) -> Result<(Value, Span)> {
        let (value, at) = self.read_expression(true)?;
        let a = as_float(&value, at)?;
        let below = a < 0.0;
        let mut found = None;
        let mut count = 0;
        while !self.peek()?.closes(Bracket::Paren) {
            // Without a fourth argument the third stands for 0 as well.
            let meant = match count {
                0 => below,
                1 => !below,
                _ => !below && a != 0.0,
            };
            count += 1;
            if meant {
                found = Some(self.read_value()?.0);
            } else {
                self.climb(&mut Skipped, false)?;
            }
        }
        let end = self.stream.here();
        self.close("`)`")?;
        match found.filter(|_| (2..=3).contains(&count)) {
            Some(value) => Ok((value, joined(span, end))),
            None => {
                let message = format!("`select` takes 3 to 4 arguments, found {}", count + 1);
                Diagnostic::err(codes::WRONG_COUNT, joined(span, end), message)
            }
        }
    }

    /// The arguments of a function or spline, whose `(` comes next.
    pub(super) fn read_call(&mut self, callee: &Value, span: Span) -> Result<(Value, Span)> {
        self.open()?;
        let value = self.read_arguments_and_call(callee, span)?;
        let end = self.stream.here();
        self.close("`)`")?;
        Ok((value, joined(span, end)))
    }
}
