//! Calls of which the name and the parentheses come as tokens.

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
    /// True if a `(` follows the name of a function. POV-Ray runs directives before it to find out, even where they
    /// would wait for the end of a value (quirk: `call_runs_directives`). Declarations wait: they cannot give a `(`,
    /// and may use the name being declared.
    pub fn call_follows(&mut self) -> Result<bool> {
        let declares = |e: &Directive| matches!(e, Directive::Declare(_) | Directive::DeclarePieces(_));
        let waits =
            matches!(self.stream.next_element().map(|e| &e.kind), Some(ElementKind::Directive(d)) if declares(d));
        let next = self.in_mode(|mode| mode.defers = waits, Self::peek_after);
        if matches!(next?, Some(Token::Expr(e)) if begins_with_parenthesis(e)) {
            self.expose_parenthesis()?;
        }
        Ok(matches!(self.peek_after()?, Some(Token::Open(Bracket::Paren, _))))
    }

    /// Reads the call `name ( … )` of a built-in function.
    pub(super) fn read_builtin_call(&mut self, word: &'static str, span: Span) -> Result<(Value, Span)> {
        self.stream.advance();
        self.expect_paren(word)?;
        if word == "select" {
            return self.read_select(span);
        }
        let mut arguments = SmallVec::<[Argument<'a>; 4]>::new();
        while !self.peek()?.closes(Bracket::Paren) {
            // Commas are mandatory only in functions of any number of arguments (quirk: `optional_argument_commas`).
            if !arguments.is_empty() && !self.stream.has_comma() && builtin::needs_commas(word) {
                let at = self.stream.next_span();
                return Err(self.syntax_error_at(at).into());
            }
            arguments.push(self.read_argument()?);
        }
        let end = self.stream.next_span();
        self.close("`)`")?;
        let span = joined(span, end);
        Ok((self.builtin_of(word, arguments, span)?, span))
    }

    /// Splits the next expression until its `(` is a token.
    pub fn expose_parenthesis(&mut self) -> Result<()> {
        while matches!(self.peek()?, Token::Expr(e) if begins_with_parenthesis(e)) {
            self.stream.split_next();
        }
        Ok(())
    }

    /// Consumes the `(` after the name of a function.
    pub fn expect_paren(&mut self, word: &str) -> Result<()> {
        self.expose_parenthesis()?;
        match self.peek()? {
            Token::Open(Bracket::Paren, _) => self.open().map(drop),
            _ => Err(self.unexpected_token(&format!("`(` after `{word}`")).into()),
        }
    }

    /// Reads `A, B, C [, D])` of a `select`, and evaluates only the argument that is selected.
    fn read_select(&mut self, span: Span) -> Result<(Value, Span)> {
        let (value, at) = self.read_expression(true)?;
        let a = as_float(&value, at)?;
        let below = a < 0.0;
        let mut found = None;
        let mut count = 0;
        while !self.peek()?.closes(Bracket::Paren) {
            // Without a fourth argument the third is selected for 0, too.
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
        let end = self.stream.next_span();
        self.close("`)`")?;
        match found.filter(|_| (2..=3).contains(&count)) {
            Some(value) => Ok((value, joined(span, end))),
            None => {
                let message = format!("`select` takes 3 to 4 arguments, found {}", count + 1);
                Diagnostic::err(codes::WRONG_COUNT, joined(span, end), message)
            }
        }
    }

    /// Reads the arguments of a function or spline, whose `(` comes next, and calls it.
    pub(super) fn read_call(&mut self, callee: &Value, span: Span) -> Result<(Value, Span)> {
        self.open()?;
        let value = self.read_arguments_and_call(callee, span)?;
        let end = self.stream.next_span();
        self.close("`)`")?;
        Ok((value, joined(span, end)))
    }
}
