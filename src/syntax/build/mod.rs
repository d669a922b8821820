//! pest's pairs to the tree of [`super::ast`].

mod contextual;
mod directive;
mod expr;

use crate::source::Span;
use crate::syntax::Names;
use crate::syntax::ast::*;
use crate::syntax::lex::{Lexed, Token};
use crate::syntax::parse::Rule;
use crate::syntax::word;
use contextual::split_contextual;
pub use expr::unescape;
use pest::iterators::{Pair, Pairs};
use std::cell::RefCell;

/// Builds the elements of one piece of text. Places in pairs are numbers of tokens, counted from the piece's first.
pub(super) struct Builder<'n> {
    names: &'n Names,
    text: &'n str,
    /// Global offset of the text's first byte.
    base: usize,
    tokens: &'n [Token],
    numbers: &'n [f64],
    lists: RefCell<&'n mut [NumberList]>,
}

impl<'n> Builder<'n> {
    /// For the piece whose first token has the number `first`.
    pub(super) fn new(names: &'n Names, text: &'n str, base: usize, first: usize, lexed: &'n mut Lexed) -> Self {
        let Lexed { tokens, numbers, lists, .. } = lexed;
        Self { names, text, base, tokens: &tokens[first..], numbers, lists: RefCell::new(lists) }
    }

    /// The first token of a pair.
    pub(super) fn token(&self, pair: &Pair<Rule>) -> Token {
        self.tokens[pair.as_span().start()]
    }

    /// The text that a token stands for.
    pub(super) fn token_text(&self, token: Token) -> &'n str {
        &self.text[token.start as usize..token.end as usize]
    }

    /// The text of a pair's first token.
    pub(super) fn text_of(&self, pair: &Pair<Rule>) -> &'n str {
        self.token_text(self.token(pair))
    }

    pub(super) fn number(&self, pair: &Pair<Rule>) -> f64 {
        self.numbers[self.token(pair).data as usize]
    }

    pub(super) fn list(&self, pair: &Pair<Rule>) -> NumberList {
        let nothing = NumberList { data: Box::new([]), widths: Widths::Uniform(1) };
        std::mem::replace(&mut self.lists.borrow_mut()[self.token(pair).data as usize], nothing)
    }

    /// Appends elements; `block` is the word before the brace they stand in, for the words that mean something only there.
    pub(super) fn elements_into(&self, pairs: Pairs<Rule>, block: &str, out: &mut Vec<Element>) {
        let context = word::contextual(block);
        for pair in pairs.filter(|p| p.as_rule() != Rule::EOI) {
            let end = pair.as_span().end();
            let (element, rest) = split_contextual(self.element(pair, block), context, self.names);
            // Textures in a row are layers of one, unless a comma stands between them.
            let ends = is_texture(&element) && self.tokens.get(end).is_some_and(|t| self.token_text(*t) == ",");
            out.push(element);
            out.extend(rest);
            if ends {
                let at = self.token_span(self.tokens[end]);
                out.push(Element { span: at, kind: ElementKind::Semicolon });
            }
        }
    }

    pub(super) fn elements(&self, pairs: Pairs<Rule>, block: &str) -> Box<[Element]> {
        let mut out = vec![];
        self.elements_into(pairs, block, &mut out);
        out.into_boxed_slice()
    }

    pub(super) fn span(&self, pair: &Pair<Rule>) -> Span {
        let span = pair.as_span();
        let (first, last) = (self.tokens[span.start()], self.tokens[(span.end().max(1) - 1).max(span.start())]);
        Span::new(self.base + first.start as usize, self.base + last.end as usize)
    }

    pub(super) fn token_span(&self, token: Token) -> Span {
        Span::new(self.base + token.start as usize, self.base + token.end as usize)
    }

    pub(super) fn element(&self, pair: Pair<Rule>, block: &str) -> Element {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::keyword => ElementKind::Word(word::by_number(self.token(&pair).data)),
            Rule::NUMBERS => ElementKind::Numbers(Box::new(self.list(&pair))),
            Rule::expr => ElementKind::Expr(Box::new(self.chain(pair))),
            Rule::block => ElementKind::Block(Box::new(self.block(pair))),
            Rule::open => ElementKind::Open(Box::new(self.name(&pair))),
            Rule::close => ElementKind::Close,
            Rule::group => ElementKind::Group(self.elements(pair.into_inner(), block)),
            Rule::entry => ElementKind::Entry(self.elements(pair.into_inner(), block)),
            Rule::function => ElementKind::Function(Box::new(self.function(pair))),
            Rule::semicolon => ElementKind::Semicolon,
            Rule::key => ElementKind::Key(self.names.intern(self.token_text(self.tokens[pair.as_span().start() + 1]))),
            Rule::colon => ElementKind::Colon,
            Rule::values => ElementKind::Values(self.elements(pair.into_inner(), "")),
            Rule::fcondition => ElementKind::Expr(Box::new(self.chain(pair))),
            _ => ElementKind::Directive(Box::new(self.directive(pair, block))),
        };
        Element { span, kind }
    }

    pub(super) fn block(&self, pair: Pair<Rule>) -> Block {
        let name = self.name(&pair);
        Block { name, body: self.elements(pair.into_inner(), name.word.unwrap_or("")) }
    }

    /// The word that a pair starts with.
    pub(super) fn name(&self, pair: &Pair<Rule>) -> Name {
        let token = self.token(pair);
        Name { word: known_word(self.token_text(token)), span: self.token_span(token) }
    }

    pub(super) fn symbol(&self, pair: &Pair<Rule>) -> Symbol {
        self.names.intern(self.text_of(pair))
    }

    pub(super) fn function(&self, pair: Pair<Rule>) -> Function {
        let mut function = Function { parameters: Box::new([]), size: Box::new([]), body: Box::new([]) };
        let (mut size, mut body) = (vec![], vec![]);
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::parameters => function.parameters = part.into_inner().map(|p| self.symbol(&p)).collect(),
                Rule::expr => size.push(self.chain(part)),
                _ => body.push(self.element(part, "")),
            }
        }
        function.size = size.into_boxed_slice();
        function.body = body.into_boxed_slice();
        function
    }
}

fn is_texture(element: &Element) -> bool {
    matches!(&element.kind, ElementKind::Block(block) if block.name.word == Some("texture"))
}

fn known_word(text: &str) -> Option<&'static str> {
    word::lookup(text).map(|(word, _)| word)
}
