//! Tokens, as the readers of blocks and expressions get them.

use crate::source::Span;
use crate::syntax::ast::*;

/// What the iterator gives.
#[derive(Clone, Copy, Debug)]
pub(in crate::interpreter) enum Token<'a> {
    Word(&'static str),
    /// The name of a built-in function that has arguments behind it.
    Callee(&'static str),
    /// A word and the `{` behind it.
    Block(BlockName<'a>),
    /// An expression without macros: its value is what it is wherever it stands.
    Expr(&'a Expr),
    /// An item of a literal list: one number, or a vector of several.
    Numbers(&'a [f64]),
    /// `{`, `[` or `(`, and what stands between it and its partner, if that is whole.
    Open(Bracket, Option<&'a [Element]>),
    /// `function { … }`; without its parts only the word.
    Function(Option<&'a Function>),
    /// An element of an array alone; its indices are evaluated, and where it is kept stands in `Interpreter::element`.
    Element(Span),
    /// A closing bracket, an operator.
    Sign(Sign),
    /// The end of the text.
    End,
}

/// What stands before a `{`.
#[derive(Clone, Copy, Debug)]
pub(in crate::interpreter) struct BlockName<'a> {
    /// The keyword; `None` for a word that is none.
    pub(in crate::interpreter) word: Option<&'static str>,
    pub(in crate::interpreter) span: Span,
    /// What stands between the braces; `None` where the tokens of the block come one by one.
    pub(in crate::interpreter) body: Option<&'a [Element]>,
}

impl Token<'_> {
    /// Does it close a bracket, or is there no more text?
    pub(in crate::interpreter) fn ends(self) -> bool {
        matches!(self, Token::End | Token::Sign(Sign::Close(_)))
    }

    pub(in crate::interpreter) fn closes(self, bracket: Bracket) -> bool {
        matches!(self, Token::Sign(Sign::Close(found)) if found == bracket)
    }
}

/// A token whose text has been consumed.
pub(in crate::interpreter) struct Held<'a> {
    pub(in crate::interpreter) token: Token<'a>,
    pub(in crate::interpreter) span: Span,
    /// Does a comma follow?
    pub(in crate::interpreter) comma: bool,
}
