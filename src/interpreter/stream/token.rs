//! Tokens that the readers of blocks and expressions receive.

use crate::source::Span;
use crate::syntax::ast::*;

/// One token of the stream. A complete expression or body that needs no splitting is a single token.
#[derive(Clone, Copy, Debug)]
pub enum Token<'a> {
    /// Token that is a keyword without a `{` after it.
    Word(&'static str),
    /// Token that is a built-in function's name, whose arguments follow.
    Callee(&'static str),
    /// Token that is the start of a block: the word before a `{`.
    Block(BlockName<'a>),
    /// Token that is a complete expression without macro calls.
    Expr(&'a Expr),
    /// Token that is an item of a list of literals: one number, or a vector.
    Numbers(&'a [f64]),
    /// Token that is `{`, `[` or `(`, with the elements up to the matching bracket if the parser found it.
    Open(Bracket, Option<&'a [Element]>),
    /// Token that is a function definition `function { … }`; `None` for the word `function` alone.
    Function(Option<&'a Function>),
    /// Token that is an array's element with evaluated indices; [`super::TokenStream::element`] returns its location.
    Element(Span),
    /// Token that is a closing bracket or an operator.
    Punctuation(Punctuation),
    /// End of the scene text, after the last token.
    End,
}

/// The word before the `{` of a block.
#[derive(Clone, Copy, Debug)]
pub struct BlockName<'a> {
    /// Keyword before the `{`; `None` if that word is not a keyword.
    pub word: Option<&'static str>,
    /// Span of the word before the `{`.
    pub span: Span,
    /// Elements between the braces; `None` where the block's tokens come one by one.
    pub body: Option<&'a [Element]>,
}

impl Token<'_> {
    /// True for a closing bracket and for the end of the text.
    pub fn is_closer_or_end(self) -> bool {
        matches!(self, Token::End | Token::Punctuation(Punctuation::Close(_)))
    }

    /// True if the token is the closing bracket of this kind.
    pub fn closes(self, bracket: Bracket) -> bool {
        matches!(self, Token::Punctuation(Punctuation::Close(found)) if found == bracket)
    }
}

/// A token that is read before the elements of the frames, although its text is consumed.
pub(super) struct PushedBack<'a> {
    pub(super) token: Token<'a>,
    pub(super) span: Span,
    /// True if a comma follows the token.
    pub(super) comma: bool,
}
