//! Reads items without effect: the values of old settings, and what follows in a shape that is invisible.

use super::super::Interpreter;
use super::super::evaluator::vector_value;
use super::super::stream::Token;
use super::color::{begins_color, is_color_component};
use crate::diagnostic::Result;
use crate::syntax::ast::{Bracket, Expr, ExprKind, Operator, Punctuation};
use crate::value::{Next, Reader};

impl Interpreter<'_> {
    /// Skips a block, map entry or group up to its closing bracket, while its contents are evaluated.
    fn skip_enclosed(&mut self) -> Result<()> {
        self.take_token()?;
        while !self.peek()?.is_closer_or_end() {
            self.skip_next_item()?;
        }
        self.leave_block()
    }

    /// Reads the next token with its contents. Directives run and values are evaluated, so that errors in them are
    /// reported.
    pub(super) fn skip_next_item(&mut self) -> Result<()> {
        match self.peek()? {
            Token::Block(_) | Token::Open(Bracket::Square | Bracket::Brace, _) => self.skip_enclosed()?,
            Token::Numbers(data) if data.len() > 5 || self.next_value_is_complete(false) => {
                self.stream.advance();
                // Items inside a literal list cannot be continued by what follows the list.
                while self.stream.take_middle_list_item().is_some() {}
            }
            // `<a, b, … >` of a quartic has more components than a vector.
            Token::Expr(Expr { kind: ExprKind::Literal(data), .. })
                if data.len() > 5 || self.next_value_is_complete(false) =>
            {
                self.stream.advance();
            }
            Token::Expr(Expr { kind: ExprKind::Vector(parts), .. })
                if parts.len() > 5 || self.next_value_is_complete(false) =>
            {
                self.stream.advance();
                self.evaluate_numbers(parts)?;
            }
            Token::Punctuation(Punctuation::Operator(Operator::Less)) => {
                let (data, span) = self.read_vector_numbers()?;
                if !self.no_token_continues_value()? {
                    self.continue_value(vector_value(&data, span)?, span)?;
                }
            }
            Token::Expr(_)
            | Token::Numbers(_)
            | Token::Callee(_)
            | Token::Element(_)
            | Token::Function(_)
            | Token::Open(Bracket::Paren, _)
            | Token::Punctuation(Punctuation::Not | Punctuation::Operator(_)) => match Reader::peek_next(self)? {
                Next::Thing(_) | Next::Function => self.read_rvalue().map(drop)?,
                _ => self.read_value().map(drop)?,
            },
            Token::Word(word) if begins_color(word) && !is_color_component(word) => self.read_color().map(drop)?,
            Token::Word(_) => self.stream.advance(),
            Token::Punctuation(_) | Token::End => {
                return Err(self.unexpected_token("a word, a value or a block").into());
            }
        }
        Ok(())
    }
}
