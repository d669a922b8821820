//! Reading of opening and closing brackets.

use crate::diagnostic::{Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::stream::{BlockName, OpenBracket, Token};
use crate::source::Span;
use crate::syntax::ast::*;

/// Maximum number of simultaneously open brackets in a scene.
const MAX_NESTING: usize = 5_000;

impl<'a> Interpreter<'a> {
    /// Consumes the next token and returns its span. An opening bracket, or a word with its `{`, is pushed on the stack
    /// of open brackets; any other token is only consumed.
    pub fn open_bracket(&mut self) -> Result<Span> {
        let token = self.peek()?;
        let span = self.stream.next_span();
        if self.stream.bracket_count() >= MAX_NESTING {
            let message = format!("more than {MAX_NESTING} brackets are open here");
            return self.reporter.limit_error(
                codes::TOO_DEEP,
                span,
                message,
                "does a macro open one without closing it?",
            );
        }
        let (word, name, body, bracket) = match token {
            Token::Block(BlockName { word, span: name, body }) => (word, name, body, Bracket::Brace),
            Token::Open(bracket, body) => (None, span, body, bracket),
            _ => {
                self.stream.advance();
                return Ok(span);
            }
        };
        let comma = self.stream.comma_follows_element();
        // A parsed group ends with the bracket that a message may speak of.
        let whole = self.stream.next_raw_element().map_or(span, |element| element.span);
        self.stream.advance();
        let mode = self.stream.stop_deferring_directives();
        let own_words = word.map_or(&[][..], crate::syntax::word::durer_words_of_block);
        let frame_count = self.stream.frames().len();
        let mut opened = OpenBracket { word, span: name, alone: None, bracket, own_words, frame_count, mode };
        match body {
            Some(body) => {
                self.stream.push_elements(body, Some(bracket), whole, comma);
                self.stream.set_comma(false);
            }
            // The bracket is a token by itself.
            None if matches!(token, Token::Block(_)) => match self.peek()? {
                Token::Open(Bracket::Brace, body) => {
                    let (at, comma) = (self.stream.next_span(), self.stream.comma_follows_element());
                    let whole = self.stream.next_raw_element().map_or(at, |element| element.span);
                    self.stream.advance();
                    opened.frame_count = self.stream.frames().len();
                    match body {
                        Some(body) => self.stream.push_elements(body, Some(Bracket::Brace), whole, comma),
                        None => opened.alone = Some(at),
                    }
                }
                _ => return Err(self.unexpected_token("`{`").into()),
            },
            None => opened.alone = Some(span),
        }
        self.stream.push_bracket(opened);
        Ok(name)
    }

    /// Consumes the bracket that closes the innermost open one; any other token is an error.
    pub fn close_bracket(&mut self, expected: &str) -> Result<()> {
        let token = self.peek()?;
        let Some(opened) = self.stream.innermost_open_bracket() else {
            return Err(self.unexpected_token(expected).into());
        };
        if !token.closes(opened.bracket) {
            return Err(match token {
                Token::Punctuation(Punctuation::Close(_)) | Token::End => self.unclosed_error().into(),
                _ => self.unexpected_token(expected).into(),
            });
        }
        self.stream.pop_bracket();
        self.stream.advance();
        Ok(())
    }

    /// Reads `elements`, the contents of a bracket, to the end. After an error, restores the state of the stream.
    pub fn read_contents<T>(
        &mut self,
        elements: &'a [Element],
        bracket: Bracket,
        span: Span,
        read: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        let checkpoint = self.stream.checkpoint();
        self.stream.push_elements(elements, Some(bracket), span, false);
        let mode = self.stream.stop_deferring_directives();
        let frame_count = self.stream.frames().len();
        self.stream.push_bracket(OpenBracket {
            word: None,
            span,
            alone: None,
            bracket,
            own_words: &[],
            frame_count,
            mode,
        });
        let result = read(self).and_then(|value| self.close_bracket(bracket.text()[1]).map(|()| value));
        result.map_err(|fault| {
            let fault = self.stream.with_call_trace(*fault);
            self.unwind(checkpoint);
            Box::new(fault)
        })
    }
}
