//! Reads blocks that durer does not render yet, and keeps their contents as plain data.

use super::super::Interpreter;
use super::super::evaluator::Slot;
use super::super::evaluator::vector_value;
use super::super::stream::Token;
use super::color::{begins_color, is_component};
use crate::diagnostic::Result;
use crate::syntax::ast::{Bracket, Expr, ExprKind, Operator, Punctuation};
use crate::value::{Next, Reader, Unsupported, unsupported_warning};

impl Interpreter<'_> {
    /// Reads a word or block with its contents, and warns that it has no effect.
    pub(super) fn read_unsupported_item(&mut self, what: &'static str) -> Result<Unsupported> {
        let token = self.peek()?;
        let (word, span) = match token {
            Token::Block(name) => (name.word.unwrap_or(what), name.span),
            Token::Word(word) => (word, self.stream.next_span()),
            _ => (what, self.stream.next_span()),
        };
        self.report(unsupported_warning(word, span));
        match token {
            Token::Block(_) => self.read_enclosed(word),
            Token::Function(_) | Token::Expr(_) => {
                let mut row = vec![];
                self.read_into(&mut row)?;
                Ok(Unsupported::Block(word, row.into()))
            }
            _ => {
                self.stream.advance();
                let row = self.read_values_after_word()?;
                Ok(if row.is_empty() { Unsupported::Word(word) } else { Unsupported::Block(word, row.into()) })
            }
        }
    }

    /// Reads the values, entries and strings after a word.
    fn read_values_after_word(&mut self) -> Result<Vec<Unsupported>> {
        let mut row = vec![];
        loop {
            match Reader::next(self)? {
                Next::Value | Next::Function | Next::Entry | Next::Group => self.read_into(&mut row)?,
                Next::Word(word) if begins_color(word) => row.push(Unsupported::Color(self.read_color()?)),
                Next::Thing("color_map" | "pigment" | "texture" | "normal") => self.read_into(&mut row)?,
                _ => return Ok(row),
            }
        }
    }

    /// Reads a block, entry or group to its end.
    fn read_enclosed(&mut self, word: &'static str) -> Result<Unsupported> {
        self.take_token()?;
        let mut row = vec![];
        while !self.peek()?.ends() {
            self.read_into(&mut row)?;
        }
        self.leave_block()?;
        Ok(Unsupported::Block(word, row.into()))
    }

    /// Reads the next token with its contents, and appends it to `row`. Directives run and values are evaluated, so
    /// that errors in them are reported.
    pub(super) fn read_into(&mut self, row: &mut Vec<Unsupported>) -> Result<()> {
        match self.peek()? {
            Token::Block(name) => {
                row.push(self.read_enclosed(name.word.unwrap_or("block"))?);
            }
            Token::Open(Bracket::Square, _) => row.push(self.read_enclosed("entry")?),
            Token::Open(Bracket::Brace, _) => row.push(self.read_enclosed("group")?),
            Token::Numbers(data) if data.len() > 5 || self.next_is_complete(false) => {
                self.stream.advance();
                Unsupported::push_numbers(row, data);
                // Items inside a literal list cannot be continued by what follows the list.
                while let Some(data) = self.stream.take_middle_item() {
                    Unsupported::push_numbers(row, data);
                }
            }
            // `<a, b, … >` of a quartic has more components than a vector.
            Token::Expr(Expr { kind: ExprKind::Literal(data), .. })
                if data.len() > 5 || self.next_is_complete(false) =>
            {
                self.stream.advance();
                Unsupported::push_numbers(row, data);
            }
            Token::Expr(Expr { kind: ExprKind::Vector(parts), .. })
                if parts.len() > 5 || self.next_is_complete(false) =>
            {
                self.stream.advance();
                let data = self.evaluate_numbers(parts)?;
                Unsupported::push_numbers(row, &data);
            }
            Token::Punctuation(Punctuation::Operator(Operator::Less)) => {
                let (data, span) = self.read_vector_numbers()?;
                if self.value_ends()? {
                    Unsupported::push_numbers(row, &data);
                } else {
                    let first = vector_value(&data, span)?;
                    Unsupported::push_value(row, &self.continue_value(first, span)?.0);
                }
            }
            Token::Expr(_)
            | Token::Numbers(_)
            | Token::Callee(_)
            | Token::Element(_)
            | Token::Function(_)
            | Token::Open(Bracket::Paren, _)
            | Token::Punctuation(Punctuation::Not | Punctuation::Operator(_)) => {
                let value = match Reader::next(self)? {
                    Next::Thing(_) | Next::Function => self.read_rvalue()?,
                    _ => Slot::Value(self.read_value()?.0),
                };
                if let Slot::Value(value) = value {
                    Unsupported::push_value(row, &value);
                }
            }
            Token::Word(word) if begins_color(word) && !is_component(word) => {
                row.push(Unsupported::Color(self.read_color()?))
            }
            Token::Word(word) => {
                self.stream.advance();
                row.push(Unsupported::Word(word));
            }
            Token::Punctuation(_) | Token::End => {
                return Err(self.unexpected_token("a word, a value or a block").into());
            }
        }
        Ok(())
    }
}
