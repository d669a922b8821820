//! Expressions.

use super::{Builder, known_word};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::parse::Rule;
use crate::syntax::word::{self, Category};
use pest::iterators::Pair;

impl Builder<'_> {
    /// `expr`, `condition` and `fcondition`: terms and operators in a row, perhaps a choice.
    pub(super) fn chain(&self, pair: Pair<Rule>) -> Expr {
        let span = self.span(&pair);
        let precedence = if pair.as_rule() == Rule::fcondition { in_functions } else { Operator::precedence };
        let mut inner = pair.into_inner().peekable();
        let first = inner.next().map_or(Expr { span, kind: ExprKind::Number(0.0) }, |term| self.term(term));
        let mut rest = vec![];
        while inner.peek().is_some_and(|p| matches!(p.as_rule(), Rule::arithmetic | Rule::operator)) {
            if let (Some(op), Some(term)) = (inner.next(), inner.next()) {
                rest.push((operator(self.text_of(&op)), self.term(term)));
            }
        }
        let value = climb(first, rest, precedence);
        match (inner.next(), inner.next()) {
            (Some(yes), Some(no)) => {
                Expr { span, kind: ExprKind::Choice(Box::new([value, self.chain(yes), self.chain(no)])) }
            }
            _ => value,
        }
    }

    /// `term` and `fterm`: signs, a primary, components and indices.
    pub(super) fn term(&self, pair: Pair<Rule>) -> Expr {
        let span = self.span(&pair);
        let mut prefixes = vec![];
        let mut value = None;
        let mut parts = pair.into_inner().peekable();
        while let Some(part) = parts.next() {
            match (part.as_rule(), value.take()) {
                (Rule::prefix, _) => prefixes.push(self.token(&part)),
                (Rule::dot, Some(base)) => value = Some(self.dot(base, part)),
                (Rule::index, Some(base)) => {
                    let mut all = vec![part];
                    while let Some(next) = parts.next_if(|p| p.as_rule() == Rule::index) {
                        all.push(next);
                    }
                    value = Some(self.index(base, all));
                }
                (Rule::arguments, Some(base)) => {
                    let span = base.span.to(self.span(&part));
                    let arguments = self.elements(part.into_inner(), "");
                    value = Some(Expr { span, kind: ExprKind::Apply(Box::new(base), arguments) });
                }
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

    /// `[i]` after an array or after another index.
    fn index(&self, array: Expr, pairs: Vec<Pair<Rule>>) -> Expr {
        let span = pairs.last().map_or(array.span, |last| array.span.to(self.span(last)));
        let indices = pairs.into_iter().flat_map(Pair::into_inner).map(|p| self.chain(p)).collect();
        Expr { span, kind: ExprKind::Index(Box::new(array), indices) }
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
            Rule::fcall => match word::lookup(self.text_of(&pair)) {
                Some((name, Category::Function)) => {
                    ExprKind::Builtin(name, pair.into_inner().map(|argument| self.chain(argument)).collect())
                }
                _ => ExprKind::Call(self.symbol(&pair), self.elements(pair.into_inner(), "")),
            },
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

/// Inside `function { … }`, `&` binds tighter than `|` (measured on POV-Ray 3.7).
fn in_functions(op: Operator) -> u8 {
    if op == Operator::And { 2 } else { op.precedence() }
}

/// Operators and their right operands.
type Tail = Vec<(Operator, Expr)>;

/// Groups a row of operands by precedence; operators of one precedence make one flat chain.
fn climb(first: Expr, rest: Tail, precedence: fn(Operator) -> u8) -> Expr {
    if rest.is_empty() {
        return first;
    }
    // The loosest binding operators split the row; what lies between them is grouped on its own.
    let loosest = rest.iter().map(|(op, _)| precedence(*op)).min().unwrap_or(0);
    let (mut head, mut groups): (Tail, Vec<(Operator, Expr, Tail)>) = (vec![], vec![]);
    for (op, term) in rest {
        match groups.last_mut() {
            _ if precedence(op) == loosest => groups.push((op, term, vec![])),
            Some((_, _, inner)) => inner.push((op, term)),
            None => head.push((op, term)),
        }
    }
    let first = climb(first, head, precedence);
    let rest: Box<[(Operator, Expr)]> =
        groups.into_iter().map(|(op, term, inner)| (op, climb(term, inner, precedence))).collect();
    let span = rest.iter().fold(first.span, |span, (_, e)| span.to(e.span));
    Expr { span, kind: ExprKind::Chain(Box::new(Chain { first, rest })) }
}

/// Resolves the escapes of a string in its quotes (manual, "String Literals").
pub fn unescape(quoted: &str) -> Box<str> {
    let inner = quoted.strip_prefix('"').unwrap_or(quoted);
    let inner = inner.strip_suffix('"').unwrap_or(inner);
    if !inner.contains(['\\', '\r']) {
        return inner.into();
    }
    let mut out = String::with_capacity(inner.len());
    let mut chars = inner.chars();
    while let Some(c) = chars.next() {
        if c == '\r' {
            // However a file's lines end, in a string it is one character.
            out.push('\n');
            chars = chars.as_str().strip_prefix('\n').unwrap_or(chars.as_str()).chars();
            continue;
        }
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
