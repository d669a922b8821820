//! List of the tokens of a file, for code that reads the text instead of the tree: the formatter and editors.

use super::lex::{Lexed, Token};
use crate::source::Span;

/// All tokens and comments of a file, in order.
#[derive(Debug, Default)]
pub struct Tokens {
    /// Tokens of the text in ascending order of their offsets; at the end, an empty one for each directive without
    /// `#end`.
    pub(super) tokens: Vec<Token>,
    /// Lexical class of each token.
    pub(super) classes: Vec<u8>,
    /// Ranges of comments, with their delimiters, ascending.
    pub(super) comments: Vec<(u32, u32)>,
    /// Global offset of the first byte of the file.
    pub(super) base_in_sources: usize,
}

/// Piece of a source text: a token or a comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Piece that is a word, literal, sign or directive.
    Token(Span),
    /// Piece that is a comment, `// …` or `/* … */`.
    Comment(Span),
}

impl Piece {
    /// Returns the span of a token or comment.
    pub fn span(self) -> Span {
        match self {
            Piece::Token(span) | Piece::Comment(span) => span,
        }
    }
}

impl Tokens {
    pub(super) fn new(lexed: Lexed, base_in_sources: usize) -> Self {
        Self { tokens: lexed.tokens, classes: lexed.classes, comments: lexed.comments, base_in_sources }
    }

    /// Returns the number of tokens in the text.
    pub fn len(&self) -> usize {
        self.tokens.len()
    }

    /// True if the text has no tokens.
    pub fn is_empty(&self) -> bool {
        self.tokens.is_empty()
    }

    /// Returns the tokens and comments in the order of the text. Blanks and the characters of
    /// [`super::is_ignored_char`] are left out; any other character without meaning is a token.
    pub fn tokens_and_comments(&self) -> impl Iterator<Item = Piece> + '_ {
        let span = |lo: u32, hi: u32| Span::new(self.base_in_sources + lo as usize, self.base_in_sources + hi as usize);
        let token = move |t: &Token| Piece::Token(span(t.start, t.end));
        let comment = move |&(lo, hi): &(u32, u32)| Piece::Comment(span(lo, hi));
        let (mut tokens, mut comments) = (self.tokens.iter().peekable(), self.comments.iter().peekable());
        std::iter::from_fn(move || match (tokens.peek(), comments.peek()) {
            (Some(next), Some(before)) if before.0 < next.start => comments.next().map(comment),
            (Some(_), _) => tokens.next().map(token),
            (None, _) => comments.next().map(comment),
        })
    }
}
