//! Builds the syntax tree's nodes of expressions.

use super::{Builder, Context, known_word};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::class;
use crate::syntax::parse::Rule;
use crate::syntax::word;
use pest::iterators::Pair;
use std::ops::Range;

impl Builder<'_> {
    /// Builds an expression; `None` if it is incomplete or contains a directive. Directives are looked for first,
    /// because building their bodies repeatedly would be slow.
    pub(super) fn complete_expr(&self, pair: &Pair<Rule>, context: Context) -> Option<Expr> {
        if self.tokens_hold_directive(&super::token_range(pair)) && !self.is_whole(pair) {
            return None;
        }
        self.expr(pair.clone(), context)
    }

    /// Returns true if a token of the range is a directive.
    pub(super) fn tokens_hold_directive(&self, range: &Range<usize>) -> bool {
        self.classes[range.clone()].iter().any(|class| class.is_ascii_uppercase() || *class == class::PLAIN)
    }

    /// True if all brackets of the expression contain expressions only. Arguments of names may be anything.
    fn is_whole(&self, pair: &Pair<Rule>) -> bool {
        pair.clone().into_inner().all(|part| match part.as_rule() {
            Rule::call | Rule::arguments => true,
            Rule::expr | Rule::term | Rule::choice | Rule::index | Rule::paren | Rule::vector | Rule::builtin => {
                self.is_whole(&part)
            }
            Rule::dot | Rule::prefix | Rule::operator | Rule::NUMBER | Rule::LITERAL | Rule::STRING | Rule::name => {
                true
            }
            _ => false,
        })
    }

    /// Builds an expression of terms, operators and `? :`; `None` if a bracket in it contains anything but expressions.
    pub(super) fn expr(&self, pair: Pair<Rule>, context: Context) -> Option<Expr> {
        let precedence =
            if context == Context::Function { Operator::precedence_in_functions } else { Operator::precedence };
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let first = self.term(inner.next()?, context)?;
        let (mut rest, mut choice) = (vec![], None);
        while let Some(part) = inner.next() {
            match part.as_rule() {
                Rule::operator => {
                    let op = Operator::from_text(self.first_token_text(&part))?;
                    rest.push((op, self.term(inner.next()?, context)?));
                }
                _ => choice = Some(part),
            }
        }
        let condition = group_by_precedence(first, rest, precedence);
        let Some(choice) = choice else { return Some(condition) };
        let [yes, no] = self.branches(choice, context)?;
        let calls = condition.calls || yes.calls || no.calls;
        Some(Expr { span, calls, kind: ExprKind::Choice(Box::new([condition, yes, no])) })
    }

    /// Builds both branches of a conditional expression from `? yes : no`.
    fn branches(&self, choice: Pair<Rule>, context: Context) -> Option<[Expr; 2]> {
        let range = super::token_range(&choice);
        let mut parts: Vec<Pair<Rule>> = choice.into_inner().collect();
        let no = parts.pop().filter(|p| p.as_rule() == Rule::expr && p.as_span().end() == range.end)?;
        let yes = parts.pop().filter(|p| p.as_rule() == Rule::expr && parts.is_empty())?;
        // There is nothing else beside the two signs.
        let whole = yes.as_span().start() == range.start + 1 && yes.as_span().end() + 1 == no.as_span().start();
        if whole { Some([self.expr(yes, context)?, self.expr(no, context)?]) } else { None }
    }

    /// Builds a term: signs, an operand, members and indices.
    fn term(&self, pair: Pair<Rule>, context: Context) -> Option<Expr> {
        let mut prefixes = vec![];
        let mut value: Option<Expr> = None;
        let mut parts = pair.into_inner().peekable();
        while let Some(part) = parts.next() {
            value = match (part.as_rule(), value) {
                (Rule::prefix, _) => {
                    prefixes.push(self.first_token(&part));
                    None
                }
                (Rule::dot, Some(base)) => Some(self.member_access(base, part)),
                (Rule::index, Some(base)) => {
                    let mut all = vec![part];
                    while let Some(next) = parts.next_if(|p| p.as_rule() == Rule::index) {
                        all.push(next);
                    }
                    Some(self.index_access(base, all, context)?)
                }
                (Rule::arguments, Some(base)) => {
                    let span = base.span.to(self.span(&part));
                    let kind = ExprKind::Apply(Box::new(base), self.elements(part, context));
                    Some(Expr { span, calls: true, kind })
                }
                _ => Some(self.primary(part, context)?),
            };
        }
        let mut value = value?;
        let mut signs = SignRow::default();
        for token in prefixes.into_iter().rev() {
            let prefix = match self.token_text(token) {
                "-" => Prefix::Minus,
                "+" => Prefix::Plus,
                _ => Prefix::Not,
            };
            signs.push_outer(prefix, self.token_span(token).to(value.span));
        }
        for (prefix, span) in signs.0 {
            value = match (prefix, value.kind) {
                (Prefix::Minus, ExprKind::Number(x)) => Expr { span, calls: false, kind: ExprKind::Number(-x) },
                (prefix, kind) => {
                    let inner = Expr { span: value.span, calls: value.calls, kind };
                    Expr { span, calls: value.calls, kind: ExprKind::Prefix(prefix, Box::new(inner)) }
                }
            };
        }
        Some(value)
    }

    fn member_access(&self, base: Expr, pair: Pair<Rule>) -> Expr {
        let span = base.span.to(self.span(&pair));
        let token = self.tokens[pair.as_span().start() + 1];
        let text = self.token_text(token);
        let name = Name { word: known_word(text), span: self.token_span(token) };
        // (The name may be a macro's.)
        let calls = base.calls || name.word.is_none();
        Expr { span, calls, kind: ExprKind::Dot(Box::new(base), name, self.names.intern(text)) }
    }

    /// Builds the index `[i]` after an array or after another index.
    fn index_access(&self, array: Expr, pairs: Vec<Pair<Rule>>, context: Context) -> Option<Expr> {
        let span = pairs.last().map_or(array.span, |last| array.span.to(self.span(last)));
        let indices: Box<[Expr]> =
            pairs.into_iter().map(|p| self.expr_in_brackets(p, context)).collect::<Option<_>>()?;
        if indices.iter().any(Expr::has_bare_condition) {
            return None;
        }
        let calls = array.calls || indices.iter().any(|e| e.calls);
        Some(Expr { span, calls, kind: ExprKind::Index(Box::new(array), indices) })
    }

    /// Builds the expression between two brackets; `None` if the brackets contain anything else.
    pub(super) fn expr_in_brackets(&self, brackets: Pair<Rule>, context: Context) -> Option<Expr> {
        let range = super::token_range(&brackets);
        let mut inner = brackets.into_inner();
        let only = inner.next().filter(|p| p.as_rule() == Rule::expr)?;
        let own = super::token_range(&only);
        let alone = own.start == range.start + 1 && own.end + 1 == range.end;
        if alone { self.expr(only, context) } else { None }
    }

    fn primary(&self, pair: Pair<Rule>, context: Context) -> Option<Expr> {
        let span = self.span(&pair);
        let plain = |kind| Some(Expr { span, calls: false, kind });
        match pair.as_rule() {
            Rule::NUMBER => plain(ExprKind::Number(self.number(&pair))),
            Rule::LITERAL => plain(ExprKind::Literal(self.list(self.first_token(&pair)).data)),
            Rule::STRING => plain(ExprKind::Text(unescape(self.first_token_text(&pair)))),
            Rule::name => plain(ExprKind::Name(Symbol(self.first_token(&pair).data))),
            Rule::vector => self.vector(pair, context),
            Rule::paren => {
                let inner = self.expr_in_brackets(pair, context)?;
                Some(Expr { span, calls: inner.calls, kind: ExprKind::Paren(Box::new(inner)) })
            }
            Rule::call => {
                let symbol = Symbol(self.first_token(&pair).data);
                Some(Expr { span, calls: true, kind: ExprKind::Call(symbol, self.elements(pair, context)) })
            }
            _ => self.builtin(pair, context),
        }
    }

    /// Builds a call of a built-in function; `None` unless its arguments are expressions or blocks with one comma
    /// between two of them.
    fn builtin(&self, pair: Pair<Rule>, context: Context) -> Option<Expr> {
        let (span, name) = (self.span(&pair), word::word_of_number(self.first_token(&pair).data));
        let mut arguments = vec![];
        let mut at = pair.as_span().start() + 2;
        let end = pair.as_span().end() - 1;
        for part in pair.into_inner() {
            let (own, at_span) = (super::token_range(&part), self.span(&part));
            let comma = own.start == at + 1 && self.classes[at] == class::COMMA && !arguments.is_empty();
            if !(comma || own.start == at && arguments.is_empty()) {
                return None;
            }
            at = own.end;
            arguments.push(match part.as_rule() {
                Rule::expr => self.expr(part, context)?,
                Rule::block => {
                    let kind = ExprKind::Block(Box::new(self.block(part, context)));
                    Expr { span: at_span, calls: true, kind }
                }
                _ => return None,
            });
        }
        if at != end {
            return None;
        }
        let calls = arguments.iter().any(|e| e.calls);
        Some(Expr { span, calls, kind: ExprKind::Builtin(name, arguments.into_boxed_slice()) })
    }

    fn vector(&self, pair: Pair<Rule>, context: Context) -> Option<Expr> {
        let span = self.span(&pair);
        if pair.clone().into_inner().any(|part| part.as_rule() != Rule::expr) {
            return None;
        }
        let mut data = vec![];
        let parts = self.elements(pair, context);
        let mut calls = false;
        for part in &parts {
            let ElementKind::Expr(e) = &part.kind else { return None };
            if e.has_bare_condition() {
                return None;
            }
            calls |= e.calls;
            if let ExprKind::Number(x) = e.kind {
                data.push(x);
            }
        }
        let literal = data.len() == parts.len() && data.len() > 1;
        let kind = if literal { ExprKind::Literal(Numbers::Short(data.into())) } else { ExprKind::Vector(parts) };
        Some(Expr { span, calls, kind })
    }
}

/// Signs before an operand, the innermost first. Signs that cancel each other are dropped, so that the tree does not
/// nest for `- - - … 1`.
#[derive(Debug, Default)]
pub struct SignRow(pub Vec<(Prefix, Span)>);

impl SignRow {
    /// Adds a sign to the left of all others.
    pub fn push_outer(&mut self, prefix: Prefix, span: Span) {
        let row = &mut self.0;
        let many = row.len() > 1;
        match row.last_mut() {
            Some(last) if last.0 == Prefix::Minus && prefix == Prefix::Minus => *last = (Prefix::Plus, span),
            Some(last) if last.0 == Prefix::Plus => *last = (prefix, span),
            Some(_) if prefix == Prefix::Plus => {}
            Some(last) if last.0 == Prefix::Not && prefix == Prefix::Not && many => {
                row.pop();
            }
            _ => row.push((prefix, span)),
        }
    }
}

/// Binary operators with their right operands, after the first operand of a chain.
type Tail = Vec<(Operator, Expr)>;

/// Groups operands into flat chains by the precedence of the operators between them.
fn group_by_precedence(first: Expr, rest: Tail, precedence: fn(Operator) -> u8) -> Expr {
    if rest.is_empty() {
        return first;
    }
    // Split at the operators with the lowest precedence; the parts between them are grouped recursively.
    let loosest = rest.iter().map(|(op, _)| precedence(*op)).min().unwrap_or(0);
    let (mut head, mut groups): (Tail, Vec<(Operator, Expr, Tail)>) = (vec![], vec![]);
    for (op, term) in rest {
        match groups.last_mut() {
            _ if precedence(op) == loosest => groups.push((op, term, vec![])),
            Some((_, _, inner)) => inner.push((op, term)),
            None => head.push((op, term)),
        }
    }
    let first = group_by_precedence(first, head, precedence);
    let rest: Box<[(Operator, Expr)]> =
        groups.into_iter().map(|(op, term, inner)| (op, group_by_precedence(term, inner, precedence))).collect();
    let span = rest.iter().fold(first.span, |span, (_, e)| span.to(e.span));
    let calls = first.calls || rest.iter().any(|(_, e)| e.calls);
    Expr { span, calls, kind: ExprKind::Chain(Box::new(Chain { first, rest })) }
}

/// Resolves the escapes of a quoted string (manual, "String Literals").
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
            // Any line end in a string is one character.
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
