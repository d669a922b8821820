//! pest's pairs to the tree of [`super::ast`].

use super::Names;
use super::ast::*;
use super::lex::{Lexed, Token};
use super::parse::Rule;
use super::word::{self, Category};
use crate::source::Span;
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
    fn token(&self, pair: &Pair<Rule>) -> Token {
        self.tokens[pair.as_span().start()]
    }

    /// The text that a token stands for.
    fn token_text(&self, token: Token) -> &'n str {
        &self.text[token.start as usize..token.end as usize]
    }

    /// The text of a pair's first token.
    fn text_of(&self, pair: &Pair<Rule>) -> &'n str {
        self.token_text(self.token(pair))
    }

    fn number(&self, pair: &Pair<Rule>) -> f64 {
        self.numbers[self.token(pair).data as usize]
    }

    fn list(&self, pair: &Pair<Rule>) -> NumberList {
        let nothing = NumberList { data: Box::new([]), widths: Widths::Uniform(1) };
        std::mem::replace(&mut self.lists.borrow_mut()[self.token(pair).data as usize], nothing)
    }

    /// Appends elements; `block` is the word before the brace they stand in, for the words that mean something only there.
    pub(super) fn elements_into(&self, pairs: Pairs<Rule>, block: &str, out: &mut Vec<Element>) {
        let context = word::contextual(block);
        for pair in pairs.filter(|p| p.as_rule() != Rule::EOI) {
            let (element, rest) = split_contextual(self.element(pair, block), context, self.names);
            out.push(element);
            out.extend(rest);
        }
    }

    fn elements(&self, pairs: Pairs<Rule>, block: &str) -> Box<[Element]> {
        let mut out = vec![];
        self.elements_into(pairs, block, &mut out);
        out.into_boxed_slice()
    }

    fn span(&self, pair: &Pair<Rule>) -> Span {
        let span = pair.as_span();
        let (first, last) = (self.tokens[span.start()], self.tokens[(span.end().max(1) - 1).max(span.start())]);
        Span::new(self.base + first.start as usize, self.base + last.end as usize)
    }

    fn token_span(&self, token: Token) -> Span {
        Span::new(self.base + token.start as usize, self.base + token.end as usize)
    }

    fn element(&self, pair: Pair<Rule>, block: &str) -> Element {
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
            Rule::fcondition => ElementKind::Expr(Box::new(self.chain(pair))),
            _ => ElementKind::Directive(Box::new(self.directive(pair, block))),
        };
        Element { span, kind }
    }

    fn block(&self, pair: Pair<Rule>) -> Block {
        let name = self.name(&pair);
        Block { name, body: self.elements(pair.into_inner(), name.word.unwrap_or("")) }
    }

    /// The word that a pair starts with.
    fn name(&self, pair: &Pair<Rule>) -> Name {
        let token = self.token(pair);
        Name { word: known_word(self.token_text(token)), span: self.token_span(token) }
    }

    fn symbol(&self, pair: &Pair<Rule>) -> Symbol {
        self.names.intern(self.text_of(pair))
    }

    // ------------------------------------------------------------ expressions

    /// `expr`, `condition` and `fcondition`: terms and operators in a row, perhaps a choice.
    fn chain(&self, pair: Pair<Rule>) -> Expr {
        let span = self.span(&pair);
        let mut inner = pair.into_inner().peekable();
        let first = inner.next().map_or(Expr { span, kind: ExprKind::Number(0.0) }, |term| self.term(term));
        let mut rest = vec![];
        while inner.peek().is_some_and(|p| matches!(p.as_rule(), Rule::arithmetic | Rule::operator)) {
            if let (Some(op), Some(term)) = (inner.next(), inner.next()) {
                rest.push((operator(self.text_of(&op)), self.term(term)));
            }
        }
        let value = climb(first, rest);
        match (inner.next(), inner.next()) {
            (Some(yes), Some(no)) => {
                Expr { span, kind: ExprKind::Choice(Box::new([value, self.chain(yes), self.chain(no)])) }
            }
            _ => value,
        }
    }

    /// `term` and `fterm`: signs, a primary, components and indices.
    fn term(&self, pair: Pair<Rule>) -> Expr {
        let span = self.span(&pair);
        let mut prefixes = vec![];
        let mut value = None;
        for part in pair.into_inner() {
            match (part.as_rule(), value.take()) {
                (Rule::prefix, _) => prefixes.push(self.token(&part)),
                (Rule::dot, Some(base)) => value = Some(self.dot(base, part)),
                (Rule::index, Some(base)) => value = Some(self.index(base, part)),
                (_, _) => value = Some(self.primary(part)),
            }
        }
        let mut value = value.unwrap_or(Expr { span, kind: ExprKind::Number(0.0) });
        // A row of signs is folded to at most two, so that `- - - … 1` does not nest.
        let mut folded: Vec<(Span, Prefix)> = vec![];
        for token in prefixes.into_iter().rev() {
            let prefix = match self.token_text(token) {
                "-" => Prefix::Minus,
                "+" => Prefix::Plus,
                _ => Prefix::Not,
            };
            let span = self.token_span(token).to(value.span);
            match folded.last() {
                Some(&(_, last)) if last == prefix && prefix == Prefix::Minus => {
                    folded.pop();
                    folded.push((span, Prefix::Plus));
                }
                Some(&(_, Prefix::Plus)) => *folded.last_mut().unwrap_or(&mut (span, prefix)) = (span, prefix),
                Some(_) if prefix == Prefix::Plus => {}
                Some(&(_, Prefix::Not)) if prefix == Prefix::Not && folded.len() > 1 => {
                    folded.pop();
                }
                _ => folded.push((span, prefix)),
            }
        }
        for (span, prefix) in folded {
            value = match (prefix, value.kind) {
                (Prefix::Minus, ExprKind::Number(x)) => Expr { span, kind: ExprKind::Number(-x) },
                (prefix, kind) => {
                    let inner = Expr { span: value.span, kind };
                    Expr { span, kind: ExprKind::Prefix(prefix, Box::new(inner)) }
                }
            };
        }
        value
    }

    fn dot(&self, base: Expr, pair: Pair<Rule>) -> Expr {
        let span = base.span.to(self.span(&pair));
        let token = self.tokens[pair.as_span().start() + 1];
        let text = self.token_text(token);
        let name = Name { word: known_word(text), span: self.token_span(token) };
        Expr { span, kind: ExprKind::Dot(Box::new(base), name, self.names.intern(text)) }
    }

    fn index(&self, base: Expr, pair: Pair<Rule>) -> Expr {
        let span = base.span.to(self.span(&pair));
        let index = pair.into_inner().map(|p| self.chain(p));
        let kind = match base.kind {
            ExprKind::Index(array, indices) => {
                ExprKind::Index(array, indices.into_vec().into_iter().chain(index).collect())
            }
            kind => ExprKind::Index(Box::new(Expr { span: base.span, kind }), index.collect()),
        };
        Expr { span, kind }
    }

    fn primary(&self, pair: Pair<Rule>) -> Expr {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::NUMBER => ExprKind::Number(self.number(&pair)),
            Rule::LITERAL => ExprKind::Literal(self.list(&pair).data),
            Rule::STRING => ExprKind::Text(unescape(self.text_of(&pair))),
            Rule::vector => self.vector(pair),
            Rule::paren | Rule::fparen => self.paren(pair),
            Rule::function => ExprKind::Function(Box::new(self.function(pair))),
            Rule::nested => match pair.into_inner().next() {
                Some(block) => ExprKind::Block(Box::new(self.block(block))),
                None => ExprKind::Number(0.0),
            },
            Rule::spliced => ExprKind::Spliced(self.elements(pair.into_inner(), "")),
            Rule::call => ExprKind::Call(self.symbol(&pair), self.elements(pair.into_inner(), "")),
            Rule::builtin => {
                let name = word::by_number(self.token(&pair).data);
                ExprKind::Builtin(name, pair.into_inner().map(|argument| self.chain(argument)).collect())
            }
            Rule::fcall => ExprKind::Call(self.symbol(&pair), self.elements(pair.into_inner(), "")),
            _ => match word::lookup(self.text_of(&pair)) {
                Some((word, Category::Keyword | Category::Function)) => ExprKind::Keyword(word),
                _ => ExprKind::Name(self.symbol(&pair)),
            },
        };
        Expr { span, kind }
    }

    fn vector(&self, pair: Pair<Rule>) -> ExprKind {
        let parts: Vec<Element> = pair
            .into_inner()
            .map(|p| match p.as_rule() {
                Rule::expr => Element { span: self.span(&p), kind: ElementKind::Expr(Box::new(self.chain(p))) },
                _ => self.element(p, ""),
            })
            .collect();
        let literal = |e: &Element| match &e.kind {
            ElementKind::Expr(expr) => match expr.kind {
                ExprKind::Number(x) => Some(x),
                _ => None,
            },
            _ => None,
        };
        match parts.iter().map(literal).collect::<Option<Vec<f64>>>() {
            Some(data) if data.len() > 1 => ExprKind::Literal(data.into_boxed_slice()),
            _ => ExprKind::Vector(parts.into_boxed_slice()),
        }
    }

    fn paren(&self, pair: Pair<Rule>) -> ExprKind {
        let mut inner = pair.into_inner().peekable();
        match inner.peek().map(Pair::as_rule) {
            Some(Rule::condition | Rule::fcondition) => match inner.next() {
                Some(condition) => ExprKind::Paren(Box::new(self.chain(condition))),
                None => ExprKind::Number(0.0),
            },
            _ => ExprKind::ParenSpliced(inner.map(|p| self.directive_or_expr(p)).collect()),
        }
    }

    fn directive_or_expr(&self, pair: Pair<Rule>) -> Element {
        match pair.as_rule() {
            Rule::condition => Element { span: self.span(&pair), kind: ElementKind::Expr(Box::new(self.chain(pair))) },
            _ => self.element(pair, ""),
        }
    }

    fn function(&self, pair: Pair<Rule>) -> Function {
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

    // ------------------------------------------------------------ directives

    fn directive(&self, pair: Pair<Rule>, block: &str) -> Directive {
        match pair.as_rule() {
            Rule::declare => self.declare(pair),
            Rule::conditional => self.conditional(pair, block),
            Rule::loop_while => self.loop_while(pair, block),
            Rule::loop_for => self.loop_for(pair, block),
            Rule::switch => self.switch(pair, block),
            Rule::end_of_loop => Directive::Break,
            Rule::undef => {
                let target = pair.into_inner().next().map(|p| self.declared(p));
                Directive::Undef(target.map_or(Expr { span: Span::NONE, kind: ExprKind::Number(0.0) }, |t| Expr {
                    span: t.span,
                    kind: ExprKind::Name(t.symbol),
                }))
            }
            Rule::simple => self.simple(pair),
            Rule::default => Directive::Default(self.elements(pair.into_inner(), "default")),
            Rule::macro_definition => self.macro_definition(pair),
            rule => {
                let name = match rule {
                    Rule::file_open => "fopen",
                    Rule::file_close => "fclose",
                    _ if self.text_of(&pair).ends_with("read") => "read",
                    _ => "write",
                };
                Directive::File(name, self.file_arguments(pair))
            }
        }
    }

    fn file_arguments(&self, pair: Pair<Rule>) -> Box<[Element]> {
        let mut out = vec![];
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::arguments => self.elements_into(part.into_inner(), "", &mut out),
                Rule::name => {
                    let span = self.span(&part);
                    let kind = ElementKind::Expr(Box::new(Expr { span, kind: ExprKind::Name(self.symbol(&part)) }));
                    out.push(Element { span, kind });
                }
                _ => out.push(self.element(part, "")),
            }
        }
        out.into_boxed_slice()
    }

    fn declare(&self, pair: Pair<Rule>) -> Directive {
        let local = self.text_of(&pair).ends_with("local");
        let mut deprecated = None;
        let mut target = None;
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::deprecated => {
                    let span = part.as_span();
                    let once = self.tokens[span.start()..span.end()].iter().any(|t| self.token_text(*t) == "once");
                    let why = part.into_inner().next().map_or("".into(), |s| unescape(self.text_of(&s)));
                    deprecated = Some((once, why));
                }
                _ => target = Some(self.declared(part)),
            }
        }
        let nothing =
            || Target { symbol: self.names.intern(""), span: Span::NONE, keyword: None, indices: Box::new([]) };
        Directive::Declare(Declare { local, deprecated, target: target.unwrap_or_else(nothing) })
    }

    fn declared(&self, pair: Pair<Rule>) -> Target {
        let name = self.name(&pair);
        let category = word::lookup(self.text_of(&pair)).filter(|(_, category)| *category != Category::Contextual);
        let keyword = category.map(|(word, _)| word);
        let symbol = self.symbol(&pair);
        let indices = pair.into_inner().flat_map(|part| part.into_inner()).map(|p| self.chain(p)).collect();
        Target { symbol, span: name.span, keyword, indices }
    }

    fn conditional(&self, pair: Pair<Rule>, block: &str) -> Directive {
        let (kind, mut branches, mut condition) = (self.text_of(&pair), vec![], None);
        let kind = kind[1..].trim_start();
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::condition => condition = Some(self.chain(part)),
                _ => {
                    let body = self.elements(part.into_inner(), block);
                    let condition = match (condition.take(), kind, branches.is_empty()) {
                        (None, ..) => Condition::Always,
                        (Some(e), "ifdef", true) => Condition::Declared(e),
                        (Some(e), "ifndef", true) => Condition::NotDeclared(e),
                        (Some(e), ..) => Condition::True(e),
                    };
                    branches.push(Branch { condition, body });
                }
            }
        }
        Directive::If(branches.into_boxed_slice())
    }

    fn loop_while(&self, pair: Pair<Rule>, block: &str) -> Directive {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let nothing = Expr { span, kind: ExprKind::Number(0.0) };
        let condition = inner.next().map_or(nothing, |p| self.chain(p));
        let body = inner.next().map_or(Box::default(), |b| self.elements(b.into_inner(), block));
        Directive::While(condition, body)
    }

    fn loop_for(&self, pair: Pair<Rule>, block: &str) -> Directive {
        let (mut counter, mut range, mut body) = (Symbol(0), vec![], Box::default());
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::name => counter = self.symbol(&part),
                Rule::condition => range.push(self.chain(part)),
                _ => body = self.elements(part.into_inner(), block),
            }
        }
        Directive::For(For { counter, range: range.into_boxed_slice(), body })
    }

    fn switch(&self, pair: Pair<Rule>, block: &str) -> Directive {
        let mut value = Expr { span: self.span(&pair), kind: ExprKind::Number(0.0) };
        let mut arms = vec![];
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::condition => value = self.chain(part),
                // Elements before the first `#case` never run.
                Rule::arm => {
                    let mut inner = part.into_inner();
                    let mut tested =
                        inner.next().map_or(vec![], |p| p.into_inner().map(|e| self.chain(e)).collect::<Vec<_>>());
                    let when = match (tested.pop(), tested.pop()) {
                        (Some(b), Some(a)) => When::Range(a, b),
                        (Some(a), None) => When::Case(a),
                        _ => When::Otherwise,
                    };
                    let body = inner.next().map_or(Box::default(), |b| self.elements(b.into_inner(), block));
                    arms.push(Arm { when, body });
                }
                _ => {}
            }
        }
        Directive::Switch(value, arms.into_boxed_slice())
    }

    fn macro_definition(&self, pair: Pair<Rule>) -> Directive {
        let mut out = Macro { name: Symbol(0), span: Span::NONE, parameters: Box::new([]), body: Box::new([]) };
        let mut parameters = vec![];
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::name => (out.name, out.span) = (self.symbol(&part), self.span(&part)),
                Rule::macro_parameter => {
                    let mut inner = part.into_inner().rev();
                    let name = inner.next().map(|p| self.symbol(&p));
                    parameters.extend(name.map(|name| (name, inner.next().is_some())));
                }
                _ => out.body = self.elements(part.into_inner(), ""),
            }
        }
        out.parameters = parameters.into_boxed_slice();
        Directive::Macro(out)
    }

    fn simple(&self, pair: Pair<Rule>) -> Directive {
        let (span, word) = (self.span(&pair), self.text_of(&pair));
        let expr = pair.into_inner().find(|part| part.as_rule() == Rule::expr);
        let value = expr.map_or(Expr { span, kind: ExprKind::Number(0.0) }, |e| self.chain(e));
        match word[1..].trim_start() {
            "include" => Directive::Include(value),
            "version" => Directive::Version(value),
            "warning" => Directive::Message("warning", value),
            "error" => Directive::Message("error", value),
            "render" => Directive::Message("render", value),
            "statistics" => Directive::Message("statistics", value),
            _ => Directive::Message("debug", value),
        }
    }
}

fn known_word(text: &str) -> Option<&'static str> {
    word::lookup(text).map(|(word, _)| word)
}

fn operator(text: &str) -> Operator {
    use Operator::*;
    match text {
        "+" => Add,
        "-" => Sub,
        "*" => Mul,
        "/" => Div,
        "<" => Less,
        "<=" => LessEqual,
        ">" => Greater,
        ">=" => GreaterEqual,
        "=" => Equal,
        "!=" => NotEqual,
        "&" => And,
        _ => Or,
    }
}

/// Groups a row of operands by precedence; operators of one precedence make one flat chain.
fn climb(first: Expr, rest: Vec<(Operator, Expr)>) -> Expr {
    if rest.is_empty() {
        return first;
    }
    // The loosest binding operators split the row; what lies between them is grouped on its own.
    let loosest = rest.iter().map(|(op, _)| op.precedence()).min().unwrap_or(0);
    let mut groups: Vec<(Operator, Expr, Vec<(Operator, Expr)>)> = vec![];
    let (mut head, mut head_rest) = (Some(first), vec![]);
    for (op, term) in rest {
        if op.precedence() == loosest {
            groups.push((op, term, vec![]));
        } else {
            match groups.last_mut() {
                Some((_, _, inner)) => inner.push((op, term)),
                None => head_rest.push((op, term)),
            }
        }
    }
    let first =
        head.take().map(|h| climb(h, head_rest)).unwrap_or(Expr { span: Span::NONE, kind: ExprKind::Number(0.0) });
    let rest: Box<[(Operator, Expr)]> = groups.into_iter().map(|(op, term, inner)| (op, climb(term, inner))).collect();
    let span = rest.iter().fold(first.span, |span, (_, e)| span.to(e.span));
    Expr { span, kind: ExprKind::Chain(Box::new(Chain { first, rest })) }
}

/// `eye -5*z` reads as a name minus something; where `eye` is a word of the block, it is a word and `-5*z`.
fn split_contextual(element: Element, context: &[&'static str], names: &Names) -> (Element, Option<Element>) {
    if context.is_empty() {
        return (element, None);
    }
    let span = element.span;
    let ElementKind::Expr(expr) = element.kind else { return (element, None) };
    let word_of = |symbol: Symbol| context.iter().copied().find(|w| *w == names.text(symbol));
    let word_element = |word: &'static str, at: Span| Element {
        span: Span { lo: at.lo, hi: at.lo + word.len() as u32 },
        kind: ElementKind::Word(word),
    };
    match expr.kind {
        ExprKind::Name(symbol) if word_of(symbol).is_some() => {
            (word_element(word_of(symbol).unwrap_or(""), span), None)
        }
        kind => {
            let (word, kind) = strip_first(kind, &word_of);
            let Some(word) = word else {
                return (Element { span, kind: ElementKind::Expr(Box::new(Expr { span, kind })) }, None);
            };
            let rest_span = Span { lo: span.lo + word.len() as u32, hi: span.hi };
            let rest = Expr { span: rest_span, kind };
            (word_element(word, span), Some(Element { span: rest_span, kind: ElementKind::Expr(Box::new(rest)) }))
        }
    }
}

/// Takes the contextual word off the leftmost end of an expression, if one is there and something is left.
fn strip_first(kind: ExprKind, word_of: &dyn Fn(Symbol) -> Option<&'static str>) -> (Option<&'static str>, ExprKind) {
    match kind {
        ExprKind::Call(symbol, arguments) if word_of(symbol).is_some() => {
            (word_of(symbol), ExprKind::ParenSpliced(arguments))
        }
        ExprKind::Chain(chain) => {
            let Chain { first, rest } = *chain;
            let mut rest = rest.into_vec();
            let sign = rest.first().map(|(op, _)| *op);
            match first.kind {
                ExprKind::Name(symbol)
                    if word_of(symbol).is_some() && matches!(sign, Some(Operator::Add | Operator::Sub)) =>
                {
                    let (_, value) = rest.remove(0);
                    let prefix = if sign == Some(Operator::Sub) { Prefix::Minus } else { Prefix::Plus };
                    let head = Expr { span: value.span, kind: ExprKind::Prefix(prefix, Box::new(value)) };
                    (word_of(symbol), rebuild(head, rest))
                }
                inner => {
                    let (word, inner) = strip_first(inner, word_of);
                    (word, rebuild(Expr { span: first.span, kind: inner }, rest))
                }
            }
        }
        kind => (None, kind),
    }
}

fn rebuild(first: Expr, rest: Vec<(Operator, Expr)>) -> ExprKind {
    if rest.is_empty() {
        return first.kind;
    }
    ExprKind::Chain(Box::new(Chain { first, rest: rest.into_boxed_slice() }))
}

/// Resolves the escapes of a string in its quotes (manual, "String Literals").
fn unescape(quoted: &str) -> Box<str> {
    let inner = quoted.strip_prefix('"').unwrap_or(quoted);
    let inner = inner.strip_suffix('"').unwrap_or(inner);
    if !inner.contains('\\') {
        return inner.into();
    }
    let mut out = String::with_capacity(inner.len());
    let mut chars = inner.chars();
    while let Some(c) = chars.next() {
        if c != '\\' {
            out.push(c);
            continue;
        }
        match chars.next() {
            Some('n') => out.push('\n'),
            Some('r') => out.push('\r'),
            Some('t') => out.push('\t'),
            Some('a') => out.push('\u{7}'),
            Some('b') => out.push('\u{8}'),
            Some('f') => out.push('\u{c}'),
            Some('v') => out.push('\u{b}'),
            Some('0') => out.push('\0'),
            Some('u') => {
                let hex: String = chars.clone().take(4).take_while(char::is_ascii_hexdigit).collect();
                let code = u32::from_str_radix(&hex, 16).ok().and_then(char::from_u32);
                if let Some(code) = code {
                    out.push(code);
                    chars.nth(hex.len().saturating_sub(1));
                }
            }
            Some(other @ ('"' | '\'' | '\\')) => out.push(other),
            // Any other letter keeps its backslash, so that DOS paths survive.
            Some(other) => out.extend(['\\', other]),
            None => out.push('\\'),
        }
    }
    out.into()
}
