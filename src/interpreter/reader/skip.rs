//! Passing over what is known and not drawn yet.

use super::super::Interpreter;
use super::super::scope::Slot;
use super::super::stream::Token;
use super::color::begins_color;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::syntax::ast::{Block, Expr, ExprKind};
use crate::value::{Next, Reader, Value, VecN};

impl Interpreter<'_> {
    /// A word or block with all that belongs to it.
    pub(super) fn skip_with_warning(&mut self, what: &str) -> Result<()> {
        let token = self.peek()?;
        let (word, span) = match token {
            Token::Block(Block { name, .. }) | Token::Open(name) => (name.word.unwrap_or(what), name.span),
            Token::Word(word) => (word, self.here()),
            _ => (what, self.here()),
        };
        self.report(Diagnostic::new(codes::UNSUPPORTED, span, format!("`{word}` is not drawn yet: it is left out")));
        match token {
            Token::Block(_) | Token::Open(_) | Token::Function(_) | Token::Expr(_) => self.pass_over(&mut |_| {})?,
            _ => {
                self.advance();
                self.skip_arguments()?;
            }
        }
        Ok(())
    }

    /// The values, entries and texts after a word.
    fn skip_arguments(&mut self) -> Result<()> {
        loop {
            match Reader::next(self)? {
                Next::Value => drop(self.value_here()),
                Next::Word(word) if begins_color(word) => drop(self.read_color()?),
                Next::Function => drop(self.rvalue()?),
                Next::Entry | Next::Group => self.advance(),
                Next::Thing("color_map" | "pigment" | "texture" | "normal") => drop(self.take_thing()?),
                _ => return Ok(()),
            }
        }
    }

    /// Whatever comes next, with all that is in it. Directives run and values are computed, so that mistakes are found.
    pub(super) fn pass_over(&mut self, seen: &mut dyn FnMut(&Value)) -> Result<()> {
        match self.peek()? {
            Token::Block(_) | Token::Open(_) | Token::Entry(_) | Token::Group(_) => {
                self.take()?;
                while !matches!(self.peek()?, Token::End) {
                    self.pass_over(seen)?;
                }
                self.leave()
            }
            Token::Numbers(data) => {
                self.advance();
                if (2..=5).contains(&data.len()) {
                    seen(&Value::Vector(VecN::from_slice(data)));
                }
                Ok(())
            }
            // `<a, b, … >` of a quartic has more numbers than a vector.
            Token::Expr(Expr { kind: ExprKind::Literal(data), .. }) if data.len() > 5 => {
                self.advance();
                Ok(())
            }
            Token::Expr(Expr { kind: ExprKind::Vector(parts), span }) => {
                self.advance();
                let data = self.numbers_in(parts, *span)?;
                if (2..=5).contains(&data.len()) {
                    seen(&Value::Vector(VecN::from_slice(&data)));
                }
                Ok(())
            }
            Token::Expr(_) | Token::Element(_) | Token::Function(_) => {
                if let Slot::Value(value) = self.rvalue()? {
                    seen(&value);
                }
                Ok(())
            }
            Token::Word(_) => {
                self.advance();
                Ok(())
            }
            Token::Values(_) | Token::Key(_) | Token::Colon | Token::End => {
                Err(self.unexpected_token("a word, a value or a block").into())
            }
        }
    }
}
