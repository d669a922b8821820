//! Reads calls whose name and parentheses come as tokens.

use super::joined_span_if_near;
use crate::diagnostic::Result;
use crate::interpreter::argument::Argument;
use crate::interpreter::stream::Token;
use crate::interpreter::{Interpreter, builtin};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::begins_with_parenthesis;
use crate::value::Value;
use smallvec::SmallVec;

impl<'a> Interpreter<'a> {
    /// True if a `(` follows the name of a function. POV-Ray runs directives between the name and the `(`, even where
    /// directives would wait for the end of a value (quirk: `call_runs_directives`). Declarations wait, because they
    /// cannot produce a `(` and may use the name being declared.
    pub fn call_follows(&mut self) -> Result<bool> {
        let declares = |e: &Directive| matches!(e, Directive::Declare(_) | Directive::DeclarePieces(_));
        let waits =
            matches!(self.stream.next_raw_element().map(|e| &e.kind), Some(ElementKind::Directive(d)) if declares(d));
        let next = self.in_mode(|mode| mode.defers_directives = waits, Self::peek_after_value);
        if matches!(next?, Some(Token::Expr(e)) if begins_with_parenthesis(e)) {
            self.split_to_parenthesis()?;
        }
        Ok(matches!(self.peek_after_value()?, Some(Token::Open(Bracket::Paren, _))))
    }

    /// Reads the call `name ( … )` of a built-in function.
    pub(super) fn read_builtin_call(&mut self, word: &'static str, span: Span) -> Result<(Value, Span)> {
        self.stream.advance();
        self.expect_paren(word)?;
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
        self.close_bracket("`)`")?;
        let span = joined_span_if_near(span, end);
        Ok((self.call_builtin_by_tokens(word, arguments, span)?, span))
    }

    /// Splits the next expression until its leading `(` is a token by itself.
    pub fn split_to_parenthesis(&mut self) -> Result<()> {
        while matches!(self.peek()?, Token::Expr(e) if begins_with_parenthesis(e)) {
            self.stream.split_next_element();
        }
        Ok(())
    }

    /// Consumes the `(` after the name of a function.
    pub fn expect_paren(&mut self, word: &str) -> Result<()> {
        self.split_to_parenthesis()?;
        match self.peek()? {
            Token::Open(Bracket::Paren, _) => self.open_bracket().map(drop),
            _ => Err(self.unexpected_token(&format!("`(` after `{word}`")).into()),
        }
    }

    /// Reads the arguments of a function or spline, from the `(` on, and calls it.
    pub(super) fn read_call(&mut self, callee: &Value, span: Span) -> Result<(Value, Span)> {
        self.open_bracket()?;
        let value = self.read_arguments_and_call(callee, span)?;
        let end = self.stream.next_span();
        self.close_bracket("`)`")?;
        Ok((value, joined_span_if_near(span, end)))
    }
}
