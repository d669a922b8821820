//! Values that are read but not evaluated, such as the branch of a choice that is not taken.

use super::{Operands, expect_colon, read_signs};
use crate::diagnostic::Result;
use crate::interpreter::Interpreter;
use crate::interpreter::stream::Token;
use crate::source::Span;
use crate::syntax::ast::*;

/// Skips operands and operators without evaluation, so that their faults are ignored.
pub(super) struct Skipped;

impl Skipped {
    /// Skips a bracket with its contents.
    fn brackets(&self, me: &mut Interpreter) -> Result<()> {
        me.open()?;
        loop {
            match me.peek()? {
                Token::Sign(Sign::Close(_)) => return me.close("the end of this"),
                Token::End => return Err(me.unexpected_token("a value").into()),
                Token::Open(..) | Token::Block(_) => self.brackets(me)?,
                _ => me.stream.advance(),
            }
        }
    }
}

impl<'a> Operands<'a> for Skipped {
    type Value = ();

    fn operand(&mut self, me: &mut Interpreter<'a>) -> Result<((), Span)> {
        let span = me.in_mode(|mode| mode.skips = true, |me| self.skip(me))?;
        Ok(((), span))
    }

    fn combine(&mut self, _: &mut Interpreter<'a>, _: Operator, _: ((), Span), _: ((), Span)) -> Result<()> {
        Ok(())
    }

    fn choose(&mut self, me: &mut Interpreter<'a>, condition: ((), Span)) -> Result<((), Span)> {
        me.climb(self, true)?;
        expect_colon(me)?;
        me.climb(self, true)?;
        Ok(condition)
    }
}

impl Skipped {
    /// Skips one operand of an expression without evaluating it.
    fn skip(&mut self, me: &mut Interpreter) -> Result<Span> {
        read_signs(me)?;
        let token = me.peek()?;
        let span = me.stream.next_span();
        match token {
            Token::Open(..) | Token::Block(_) => self.brackets(me)?,
            Token::Sign(Sign::Operator(Operator::Less)) => {
                me.stream.advance();
                while !matches!(me.peek()?, Token::Sign(Sign::Operator(Operator::Greater))) {
                    me.climb(self, false)?;
                }
                me.stream.advance();
            }
            Token::Sign(_) | Token::End => return Err(me.unexpected_token("a value").into()),
            _ => me.stream.advance(),
        }
        loop {
            match me.peek_after()? {
                Some(Token::Sign(Sign::Dot)) => {
                    me.stream.advance();
                    me.component_name()?;
                }
                Some(Token::Open(Bracket::Paren | Bracket::Square, _)) => self.brackets(me)?,
                Some(Token::Expr(Expr { kind: ExprKind::Paren(_), .. })) => me.stream.advance(),
                _ => return Ok(span),
            }
        }
    }
}
