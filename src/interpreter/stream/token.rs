//! Tokens, as the readers of blocks and expressions receive them.

use crate::source::Span;
use crate::syntax::ast::*;

/// One token of the stream; an expression or a body that needs no splitting is a single token.
#[derive(Clone, Copy, Debug)]
pub enum Token<'a> {
    /// Token that is a keyword without a `{` after it.
    Word(&'static str),
    /// Token that is a built-in function's name, whose arguments follow.
    Callee(&'static str),
    /// Token that is a word with the `{` after it.
    Block(BlockName<'a>),
    /// An expression without macro calls; nothing that follows continues it.
    Expr(&'a Expr),
    /// An item of a literal list: one number, or a vector of several.
    Numbers(&'a [f64]),
    /// Token that is `{`, `[` or `(`, with the elements up to the matching bracket if the parser found it.
    Open(Bracket, Option<&'a [Element]>),
    /// Token that is a function definition `function { … }`; `None` for the word `function` alone.
    Function(Option<&'a Function>),
    /// An array's element; its indices are evaluated, and [`super::TokenStream::element`] returns the location.
    Element(Span),
    /// Token that is a closing bracket or an operator.
    Sign(Sign),
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
    /// The elements between the braces; `None` where the block's tokens come one by one.
    pub body: Option<&'a [Element]>,
}

impl Token<'_> {
    /// True for a closing bracket and for the end of the text.
    pub fn ends(self) -> bool {
        matches!(self, Token::End | Token::Sign(Sign::Close(_)))
    }

    /// True if the token is the closing bracket of this kind.
    pub fn closes(self, bracket: Bracket) -> bool {
        matches!(self, Token::Sign(Sign::Close(found)) if found == bracket)
    }
}

/// A token that precedes those of the frames; its text is consumed.
pub(super) struct PushedBack<'a> {
    pub(super) token: Token<'a>,
    pub(super) span: Span,
    /// True if a comma follows the token.
    pub(super) comma: bool,
}
