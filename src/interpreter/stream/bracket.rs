//! Brackets that are open while the text is read.

use super::{BlockName, Token};
use crate::diagnostic::{Result, codes};
use crate::interpreter::Interpreter;
use crate::source::Span;
use crate::syntax::ast::*;

/// A bracket that is open.
pub(in crate::interpreter) struct Opened {
    /// The word before it.
    pub(in crate::interpreter) word: Option<&'static str>,
    /// The word's place, or the bracket's.
    pub(in crate::interpreter) span: Span,
    /// The place of the bracket alone, where it is a token by itself.
    pub(in crate::interpreter) alone: Option<Span>,
    pub(in crate::interpreter) bracket: Bracket,
    /// durer's own words inside this block.
    pub(in crate::interpreter) own_words: &'static [&'static str],
    /// How many frames there were.
    pub(in crate::interpreter) frames: usize,
    /// What [`Interpreter::closed`] was outside.
    pub(in crate::interpreter) closed: bool,
}

/// Brackets and values that are read inside each other.
const MAX_NESTING: usize = 5_000;

impl<'a> Interpreter<'a> {
    /// Consumes the opening bracket that comes next, perhaps with the word before it.
    pub(in crate::interpreter) fn open(&mut self) -> Result<Span> {
        let token = self.peek()?;
        let span = self.here();
        if self.stream.opened.len() >= MAX_NESTING {
            let message = format!("more than {MAX_NESTING} brackets are open here");
            return self.limit(codes::TOO_DEEP, span, message, "does a macro open one without closing it?");
        }
        let (word, name, body, bracket) = match token {
            Token::Block(BlockName { word, span: name, body }) => (word, name, body, Bracket::Brace),
            Token::Open(bracket, body) => (None, span, body, bracket),
            _ => {
                self.advance();
                return Ok(span);
            }
        };
        let comma = self.element_comma();
        // (What stands whole ends with the bracket that a message may speak of.)
        let whole = self.raw().map_or(span, |element| element.span);
        self.advance();
        let closed = std::mem::replace(&mut self.stream.closed, false);
        let own_words = word.map_or(&[][..], crate::syntax::word::contextual);
        let mut opened =
            Opened { word, span: name, alone: None, bracket, own_words, frames: self.stream.frames.len(), closed };
        match body {
            Some(body) => {
                self.push_piece(body, Some(bracket), whole, comma);
                self.stream.comma = false;
            }
            // The bracket is a token by itself.
            None if matches!(token, Token::Block(_)) => match self.peek()? {
                Token::Open(Bracket::Brace, body) => {
                    let (at, comma) = (self.here(), self.element_comma());
                    let whole = self.raw().map_or(at, |element| element.span);
                    self.advance();
                    opened.frames = self.stream.frames.len();
                    match body {
                        Some(body) => self.push_piece(body, Some(Bracket::Brace), whole, comma),
                        None => opened.alone = Some(at),
                    }
                }
                _ => return Err(self.unexpected_token("`{`").into()),
            },
            None => opened.alone = Some(span),
        }
        self.stream.opened.push(opened);
        Ok(name)
    }

    pub(in crate::interpreter) fn element_comma(&self) -> bool {
        self.stream.held.is_empty()
            && self.stream.frames.last().and_then(|f| f.elements.get(f.at)).is_some_and(|e| e.comma)
    }

    /// Consumes the bracket that closes what was opened last; anything else is a fault.
    pub(in crate::interpreter) fn close(&mut self, expected: &str) -> Result<()> {
        let token = self.peek()?;
        let Some(opened) = self.stream.opened.last() else { return Err(self.unexpected_token(expected).into()) };
        if !token.closes(opened.bracket) {
            return Err(match token {
                Token::Sign(Sign::Close(_)) | Token::End => self.not_closed().into(),
                _ => self.unexpected_token(expected).into(),
            });
        }
        self.stream.closed = opened.closed;
        self.stream.opened.pop();
        self.advance();
        Ok(())
    }

    /// Reads what stands between brackets, of which the opening one is consumed, to its end.
    pub(in crate::interpreter) fn within<T>(
        &mut self,
        elements: &'a [Element],
        bracket: Bracket,
        span: Span,
        read: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        let mark = self.mark();
        self.push_piece(elements, Some(bracket), span, false);
        let closed = std::mem::replace(&mut self.stream.closed, false);
        let frames = self.stream.frames.len();
        self.stream.opened.push(Opened { word: None, span, alone: None, bracket, own_words: &[], frames, closed });
        let result = read(self).and_then(|value| self.close(bracket.text()[1]).map(|()| value));
        result.map_err(|fault| {
            let fault = self.with_trace(*fault);
            self.unwind(mark);
            Box::new(fault)
        })
    }
}
