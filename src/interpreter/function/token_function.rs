//! Compiles functions whose tokens come one by one.

use super::{Compiler, compile_series_call};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::{Id, Operation};
use crate::interpreter::Interpreter;
use crate::interpreter::evaluator::Contents;
use crate::interpreter::evaluator::as_float;
use crate::interpreter::evaluator::is_callable;
use crate::interpreter::stream::Token;
use crate::interpreter::token_expr::{Operands, expect_colon, joined_span_if_near, read_signs};
use crate::source::Span;
use crate::syntax::ast::{Bracket, Expr, ExprKind, Name, Operator, Punctuation};
use crate::value::Value;

/// Operands and operators of a user-defined function, which are compiled while they are read.
pub(super) struct Compiled<'c>(pub(super) &'c mut Compiler);

impl<'a> Operands<'a> for Compiled<'_> {
    type Value = Id;

    fn operand(&mut self, me: &mut Interpreter<'a>) -> Result<(Id, Span)> {
        let signs = read_signs(me)?;
        let (mut id, mut span) = me.compile_primary(self.0)?;
        for (prefix, at) in signs {
            id = self.0.prefixed(prefix, id);
            span = joined_span_if_near(at, span);
        }
        Ok((id, span))
    }

    fn combine(&mut self, _: &mut Interpreter<'a>, op: Operator, left: (Id, Span), right: (Id, Span)) -> Result<Id> {
        Ok(self.0.graph.add_operation(Operation::Binary(op, left.0, right.0)))
    }

    fn read_choice(&mut self, me: &mut Interpreter<'a>, condition: (Id, Span)) -> Result<(Id, Span)> {
        let (yes, _) = me.read_by_precedence(self, true)?;
        expect_colon(me)?;
        let (no, span) = me.read_by_precedence(self, true)?;
        Ok((self.0.graph.add_operation(Operation::Choice(condition.0, yes, no)), span))
    }

    fn precedence(&self, op: Operator) -> u8 {
        op.precedence_in_functions()
    }
}

impl<'a> Interpreter<'a> {
    /// Compiles an operand without signs: a number, parameter or call.
    fn compile_primary(&mut self, c: &mut Compiler) -> Result<(Id, Span)> {
        loop {
            let token = self.peek()?;
            let span = self.stream.next_span();
            return match token {
                Token::Expr(e) => match &e.kind {
                    // A component may follow the call.
                    ExprKind::Call(..) | ExprKind::Apply(..) if !self.next_value_is_complete(true) => {
                        self.stream.split_next_element();
                        continue;
                    }
                    ExprKind::Name(symbol) => {
                        self.stream.advance();
                        let callee = match self.evaluator.scopes().get(*symbol) {
                            Some(Contents::Value(value)) => is_callable(value),
                            _ => false,
                        };
                        if callee && self.call_follows()? {
                            let callee = self.evaluate_name(*symbol, span)?;
                            return self.compile_call_by_tokens(c, &callee, span);
                        }
                        Ok((self.compile_name(c, *symbol, e)?, span))
                    }
                    _ => {
                        self.stream.advance();
                        Ok((self.compile(c, e)?, span))
                    }
                },
                Token::Numbers([x]) => {
                    self.stream.advance();
                    Ok((c.graph.add_constant(*x), span))
                }
                Token::Open(Bracket::Paren, _) => {
                    self.open_bracket()?;
                    let (id, _) = self.read_by_precedence(&mut Compiled(c), true)?;
                    let end = self.stream.next_span();
                    self.close_bracket("`)`")?;
                    Ok((id, joined_span_if_near(span, end)))
                }
                Token::Element(_) => {
                    let contents = self.take_array_element()?;
                    let value = self.value_of_contents(contents, span)?;
                    if is_callable(&value) && self.call_follows()? {
                        return self.compile_call_by_tokens(c, &value, span);
                    }
                    Ok((c.graph.add_constant(as_float(&value, span)?), span))
                }
                Token::Callee(word) => {
                    self.stream.advance();
                    self.expect_paren(word)?;
                    let id = self.compile_builtin_by_tokens(c, word, span)?;
                    let end = self.stream.next_span();
                    self.close_bracket("`)`")?;
                    Ok((id, joined_span_if_near(span, end)))
                }
                _ => Err(self.unexpected_token("a number, a parameter or a function").into()),
            };
        }
    }

    /// Compiles the call of a function or spline, from the `(` on, and the component selected after it.
    fn compile_call_by_tokens(&mut self, c: &mut Compiler, callee: &Value, span: Span) -> Result<(Id, Span)> {
        self.open_bracket()?;
        let mut ids = vec![];
        while !self.peek()?.is_closer_or_end() {
            ids.push(self.read_by_precedence(&mut Compiled(c), true)?.0);
        }
        let mut whole = joined_span_if_near(span, self.stream.next_span());
        self.close_bracket("`)`")?;
        let mut component: Option<Name> = None;
        if matches!(self.peek_after_value()?, Some(Token::Punctuation(Punctuation::Dot))) {
            self.stream.advance();
            let name = self.read_component_name()?;
            whole = joined_span_if_near(whole, name.span);
            component = Some(name);
        }
        Ok((self.compile_call_of(c, callee, ids, component.as_ref(), whole)?, whole))
    }

    /// Compiles the arguments of a built-in function.
    fn compile_builtin_by_tokens(&mut self, c: &mut Compiler, word: &str, span: Span) -> Result<Id> {
        if word == "sum" || word == "prod" {
            return self.compile_series_by_tokens(c, word == "prod", span);
        }
        let mut ids = vec![];
        while !self.peek()?.is_closer_or_end() {
            ids.push(self.read_by_precedence(&mut Compiled(c), true)?.0);
        }
        self.compile_builtin_of(c, word, &ids, span)
    }

    /// Compiles the arguments `I, 1, 10, x/I` of `sum` or `prod`.
    fn compile_series_by_tokens(&mut self, c: &mut Compiler, product: bool, span: Span) -> Result<Id> {
        let Token::Expr(Expr { kind: ExprKind::Name(counter), .. }) = self.peek()? else {
            return Diagnostic::err(
                codes::WRONG_COUNT,
                span,
                "expected a counter, a first and a last value, and a term",
            );
        };
        self.stream.advance();
        let first = self.read_by_precedence(&mut Compiled(c), true)?.0;
        let last = self.read_by_precedence(&mut Compiled(c), true)?.0;
        let mut inner = c.with_counter(*counter);
        inner.graph.result = self.read_by_precedence(&mut Compiled(&mut inner), true)?.0;
        compile_series_call(c, product, vec![first, last], inner, span)
    }
}
