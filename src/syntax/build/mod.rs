//! Converts the pairs of the pest parser to the syntax tree of [`super::ast`].

mod directive;
mod expr;
mod pieces;

use crate::source::Span;
use crate::syntax::Names;
use crate::syntax::ast::*;
use crate::syntax::class;
use crate::syntax::lex::{Lexed, Token};
use crate::syntax::parse::{Rule, Source};
use crate::syntax::word;
pub use expr::{SignRow, unescape};
use pest::iterators::{Pair, Pairs};
pub use pieces::{begins_with_parenthesis, begins_with_sign, split_one_level};
use std::ops::Range;

/// Builder of the syntax tree for one piece of the text. Positions in pairs are token indices within the piece.
pub(super) struct Builder<'n> {
    names: &'n Names,
    text: &'n str,
    /// Global offset of the first byte of the text.
    base_in_sources: usize,
    classes: &'n [u8],
    tokens: &'n [Token],
    numbers: &'n [f64],
    lists: &'n [NumberList],
    /// True if each token is an element of its own.
    single: bool,
}

/// Maximum number of tokens of an incomplete expression whose parts are still built as expressions. In larger ones,
/// repeated attempts could take too long.
const SMALL: usize = 24;

/// Context in which an expression of the syntax tree is built.
#[derive(Clone, Copy, PartialEq)]
enum Context {
    Script,
    /// Context of an expression between the braces of a `function`.
    Function,
}

impl<'n> Builder<'n> {
    /// Creates a builder for the piece that begins at token `first`.
    pub(super) fn new(source: &Source<'n>, lexed: &'n Lexed, first: usize) -> Self {
        let &Source { text, base_in_sources, names, single } = source;
        let Lexed { classes, tokens, numbers, lists, .. } = lexed;
        Self {
            names,
            text,
            base_in_sources,
            classes: &classes[first..],
            tokens: &tokens[first..],
            numbers,
            lists,
            single,
        }
    }

    /// Appends the elements of a whole piece of text to `out`.
    pub(super) fn piece(&self, chunk: Pair<Rule>, out: &mut Vec<Element>) {
        let range = token_range(&chunk);
        self.append_elements(chunk.into_inner(), range, Context::Script, out);
    }

    /// Returns the first token of a parser's pair.
    fn first_token(&self, pair: &Pair<Rule>) -> Token {
        self.tokens[pair.as_span().start()]
    }

    /// Returns the source text of a token.
    fn token_text(&self, token: Token) -> &'n str {
        &self.text[token.start as usize..token.end as usize]
    }

    /// Returns the text of the first token of a parser's pair.
    fn first_token_text(&self, pair: &Pair<Rule>) -> &'n str {
        self.token_text(self.first_token(pair))
    }

    fn number(&self, pair: &Pair<Rule>) -> f64 {
        self.numbers[self.first_token(pair).data as usize]
    }

    /// Returns the numbers of a token that is a literal vector or a list of literals.
    fn list(&self, token: Token) -> NumberList {
        self.lists[token.data as usize].clone()
    }

    /// Appends the elements in a range of tokens to `out`. A comma after an element becomes a flag of the element.
    fn append_elements(&self, pairs: Pairs<Rule>, range: Range<usize>, context: Context, out: &mut Vec<Element>) {
        let (first, mut at) = (out.len(), range.start);
        for pair in pairs.filter(|p| p.as_rule() != Rule::EOI) {
            let own = self::token_range(&pair);
            self.attach_or_append_commas(at..own.start, first, out);
            at = own.end;
            self.element(pair, context, out);
        }
        self.attach_or_append_commas(at..range.end, first, out);
    }

    /// Builds the elements between the brackets of a pair, or in a directive's body.
    fn elements(&self, pair: Pair<Rule>, context: Context) -> Box<[Element]> {
        let mut out = vec![];
        self.append_inner_elements(pair, context, &mut out);
        out.into_boxed_slice()
    }

    /// Appends the elements between the brackets of a parser's pair, or all elements of a directive's body.
    fn append_inner_elements(&self, pair: Pair<Rule>, context: Context, out: &mut Vec<Element>) {
        let mut range = token_range(&pair);
        match pair.as_rule() {
            Rule::body => {}
            Rule::block | Rule::call | Rule::builtin => range = range.start + 2..range.end - 1,
            _ => range = range.start + 1..range.end - 1,
        }
        self.append_elements(pair.into_inner(), range, context, out);
    }

    /// Processes the commas between two elements: each one sets the flag of the element before, or becomes an element
    /// of its own.
    fn attach_or_append_commas(&self, token_range: Range<usize>, first_index_in_out: usize, out: &mut Vec<Element>) {
        for i in token_range.filter(|i| self.classes[*i] == class::COMMA) {
            let behind = out.len() > first_index_in_out;
            match out.last_mut() {
                // What a directive inserts comes before the comma.
                Some(Element { comma: true, .. } | Element { kind: ElementKind::Comma, .. }) if behind => {}
                Some(last) if behind && !matches!(last.kind, ElementKind::Directive(_) | ElementKind::Semicolon) => {
                    last.comma = true;
                }
                _ => out.push(Element::new(self.token_span(self.tokens[i]), ElementKind::Comma)),
            }
        }
    }

    fn span(&self, pair: &Pair<Rule>) -> Span {
        let span = pair.as_span();
        let (first, last) = (self.tokens[span.start()], self.tokens[(span.end().max(1) - 1).max(span.start())]);
        Span::new(self.base_in_sources + first.start as usize, self.base_in_sources + last.end as usize)
    }

    fn token_span(&self, token: Token) -> Span {
        Span::new(self.base_in_sources + token.start as usize, self.base_in_sources + token.end as usize)
    }

    fn element(&self, pair: Pair<Rule>, context: Context, out: &mut Vec<Element>) {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::SEMICOLON => ElementKind::Semicolon,
            Rule::keyword | Rule::word => ElementKind::Word(word::word_of_number(self.first_token(&pair).data)),
            Rule::declare => match self.declare(pair.clone()) {
                Some(declare) => ElementKind::Directive(Box::new(Directive::Declare(declare))),
                None => return self.declare_pieces(pair, out),
            },
            rule if is_directive(rule) => ElementKind::Directive(Box::new(self.directive(pair, context))),
            _ if self.single => return self.flatten(pair, context, out),
            Rule::NUMBERS => ElementKind::Numbers(Box::new(self.list(self.first_token(&pair)))),
            Rule::expr => match self.complete_expr(&pair, context) {
                Some(e) => ElementKind::Expr(Box::new(e)),
                None => return self.flatten(pair, context, out),
            },
            Rule::block => ElementKind::Block(Box::new(self.block(pair, context))),
            Rule::group => ElementKind::Group(Box::new(Group { body: self.elements(pair, context) })),
            Rule::entry => ElementKind::Entry(Box::new(Group { body: self.elements(pair, context) })),
            Rule::function => match self.function(pair.clone()) {
                Some(function) => ElementKind::Function(Box::new(function)),
                None => return self.flatten(pair, context, out),
            },
            _ => return self.flatten(pair, context, out),
        };
        out.push(Element::new(span, kind));
    }

    /// Builds a `#declare` without a plain target: the directive, then the tokens up to the `=` as elements.
    fn declare_pieces(&self, pair: Pair<Rule>, out: &mut Vec<Element>) {
        let (own, token) = (token_range(&pair), self.first_token(&pair));
        let directive = Directive::DeclarePieces(token.data == 1);
        out.push(Element::new(self.token_span(token), ElementKind::Directive(Box::new(directive))));
        let (first, mut at) = (out.len(), own.start + 1);
        for inner in pair.into_inner() {
            let within = token_range(&inner);
            self.tokens_as_elements(at..within.start, first, out);
            at = within.end;
            self.flatten(inner, Context::Script, out);
        }
        self.tokens_as_elements(at..own.end, first, out);
    }

    /// Appends the tokens of `pair` as one element each. A directive, block, group or function becomes a single element;
    /// so does an expression, if `pair` has at most [`SMALL`] tokens or contains a directive.
    fn flatten(&self, pair: Pair<Rule>, context: Context, out: &mut Vec<Element>) {
        let context = if pair.as_rule() == Rule::function { Context::Function } else { context };
        let (first, own) = (out.len(), token_range(&pair));
        let mut at = own.start;
        for inner in pair.into_inner() {
            let within = token_range(&inner);
            self.tokens_as_elements(at..within.start, first, out);
            at = within.end;
            match inner.as_rule() {
                Rule::block | Rule::group | Rule::function => self.element(inner, context, out),
                rule if is_directive(rule) => self.element(inner, context, out),
                Rule::expr if own.len() <= SMALL || self.tokens_hold_directive(&own) => {
                    self.element(inner, context, out)
                }
                _ => self.flatten(inner, context, out),
            }
        }
        self.tokens_as_elements(at..own.end, first, out);
    }

    fn tokens_as_elements(&self, token_range: Range<usize>, first_index_in_out: usize, out: &mut Vec<Element>) {
        for i in token_range {
            let (class, token) = (self.classes[i], self.tokens[i]);
            let (span, text) = (self.token_span(token), self.token_text(token));
            let operand = |kind| ElementKind::Expr(Box::new(Expr { span, calls: false, kind }));
            let kind = match class {
                class::COMMA => {
                    self.attach_or_append_commas(i..i + 1, first_index_in_out, out);
                    continue;
                }
                class::KEYWORD | class::BUILTIN | class::FUNCTION | class::DEPRECATED => {
                    ElementKind::Word(word::word_of_number(token.data))
                }
                class::HEAD => match word::entry(text).filter(|word| word.category.is_reserved()) {
                    Some(word) => ElementKind::Word(word),
                    None => operand(ExprKind::Name(self.names.intern(text))),
                },
                class::NAME => operand(ExprKind::Name(Symbol(token.data))),
                class::NUMBER => operand(ExprKind::Number(self.numbers[token.data as usize])),
                class::STRING => operand(ExprKind::Text(unescape(text))),
                class::LITERAL => operand(ExprKind::Literal(self.list(token).data)),
                class::NUMBERS => ElementKind::Numbers(Box::new(self.list(token))),
                class::SEMICOLON => ElementKind::Semicolon,
                _ => ElementKind::Punctuation(punctuation(text)),
            };
            out.push(Element::new(span, kind));
        }
    }

    fn block(&self, pair: Pair<Rule>, context: Context) -> Block {
        let name = self.name(&pair);
        Block { name, body: self.elements(pair, context) }
    }

    /// Returns the word at the start of a parser's pair, as a keyword if it is one.
    fn name(&self, pair: &Pair<Rule>) -> Name {
        let token = self.first_token(pair);
        Name { word: known_word(self.token_text(token)), span: self.token_span(token) }
    }

    fn symbol(&self, pair: &Pair<Rule>) -> Symbol {
        self.names.intern(self.first_token_text(pair))
    }

    /// Builds a function definition; `None` if its head is incomplete.
    fn function(&self, pair: Pair<Rule>) -> Option<Function> {
        let (mut size, mut parameters, mut body) = (vec![], Box::default(), Box::default());
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::head => {
                    let names = self.elements(part, Context::Script);
                    parameters = names.iter().map(name_of).collect::<Option<_>>()?;
                }
                Rule::expr => size.push(self.expr(part, Context::Script)?),
                Rule::body => body = self.elements(part, Context::Function),
                _ => {}
            }
        }
        Some(Function { parameters, size: size.into_boxed_slice(), body })
    }
}

fn is_directive(rule: Rule) -> bool {
    use Rule::{conditional, declare, for_loop, macro_definition, plain, switch, while_loop};
    matches!(rule, declare | conditional | while_loop | for_loop | switch | macro_definition | plain)
}

/// Returns the range of token indices that a parser's pair covers.
fn token_range(pair: &Pair<Rule>) -> Range<usize> {
    let span = pair.as_span();
    span.start()..span.end()
}

/// Returns the name, if the syntax element is a name alone.
pub(super) fn name_of(element: &Element) -> Option<Symbol> {
    match &element.kind {
        ElementKind::Expr(e) => match e.kind {
            ExprKind::Name(symbol) => Some(symbol),
            _ => None,
        },
        _ => None,
    }
}

fn known_word(text: &str) -> Option<&'static str> {
    word::lookup(text).map(|(word, _)| word)
}

fn punctuation(text: &str) -> Punctuation {
    match text {
        "{" => Punctuation::Open(Bracket::Brace),
        "(" => Punctuation::Open(Bracket::Paren),
        "[" => Punctuation::Open(Bracket::Square),
        "}" => Punctuation::Close(Bracket::Brace),
        ")" => Punctuation::Close(Bracket::Paren),
        "]" => Punctuation::Close(Bracket::Square),
        "!" => Punctuation::Not,
        "." => Punctuation::Dot,
        "?" => Punctuation::Question,
        ":" => Punctuation::Colon,
        _ => Operator::from_text(text).map_or(Punctuation::Other, Punctuation::Operator),
    }
}
