//! Passing over what is known and not drawn yet.

use super::super::Interpreter;
use super::super::stream::Token;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::syntax::ast::Block;
use crate::value::{Next, Reader};

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
            Token::Block(_) => self.advance(),
            Token::Open(_) => {
                self.take()?;
                self.skip_to_end()?;
                self.leave()?;
            }
            Token::Function(_) | Token::Expr(_) => drop(self.rvalue()?),
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
                Next::Function => drop(self.rvalue()?),
                Next::Entry | Next::Group => self.advance(),
                Next::Thing("color_map" | "pigment" | "texture" | "normal") => drop(self.take_thing()?),
                _ => return Ok(()),
            }
        }
    }

    fn skip_to_end(&mut self) -> Result<()> {
        let mut open = 0;
        loop {
            match self.peek()? {
                Token::End if open == 0 => return Ok(()),
                Token::End => {
                    open -= 1;
                    self.leave()?;
                }
                Token::Open(_) => {
                    open += 1;
                    self.take()?;
                }
                _ => self.advance(),
            }
        }
    }
}
