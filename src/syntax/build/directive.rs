//! Directives.

use super::Builder;
use super::expr::unescape;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::parse::Rule;
use crate::syntax::word::{self, Category};
use pest::iterators::Pair;

impl Builder<'_> {
    pub(super) fn directive(&self, pair: Pair<Rule>, block: &str) -> Directive {
        match pair.as_rule() {
            Rule::declare => self.declare(pair),
            Rule::conditional => self.conditional(pair, block),
            Rule::loop_while => self.loop_while(pair, block),
            Rule::loop_for => self.loop_for(pair, block),
            Rule::switch => self.switch(pair, block),
            Rule::end_of_loop => Directive::Break,
            Rule::undef => {
                let target = pair.into_inner().next().map(|p| self.declared(p));
                let nothing = || Expr { span: Span::NONE, kind: ExprKind::Number(0.0) };
                Directive::Undef(target.map_or_else(nothing, |t| {
                    let name = Expr { span: t.span, kind: ExprKind::Name(t.symbol) };
                    match t.indices.len() {
                        0 => name,
                        _ => Expr { span: t.span, kind: ExprKind::Index(Box::new(name), t.indices) },
                    }
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
        let (mut target, mut others) = (None, vec![]);
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::deprecated => {
                    let span = part.as_span();
                    let once = self.tokens[span.start()..span.end()].iter().any(|t| self.token_text(*t) == "once");
                    let why = part.into_inner().next().map_or("".into(), |s| unescape(self.text_of(&s)));
                    deprecated = Some((once, why));
                }
                _ if target.is_none() => target = Some(self.declared(part)),
                _ => others.push(self.declared(part)),
            }
        }
        let nothing =
            || Target { symbol: self.names.intern(""), span: Span::NONE, keyword: None, indices: Box::new([]) };
        let target = target.unwrap_or_else(nothing);
        Directive::Declare(Declare { local, deprecated, target, others: others.into() })
    }

    fn declared(&self, pair: Pair<Rule>) -> Target {
        let name = self.name(&pair);
        let category = word::lookup(self.text_of(&pair)).filter(|(_, category)| *category != Category::Contextual);
        let keyword = category.map(|(word, _)| word);
        let symbol = self.symbol(&pair);
        let index = |part: Pair<Rule>| match part.as_rule() {
            Rule::index => part.into_inner().next().map(|p| self.chain(p)),
            // `D.Key` is `D["Key"]`.
            _ => {
                let token = self.tokens[part.as_span().start() + 1];
                let (span, text) = (self.token_span(token), self.token_text(token));
                Some(Expr { span, kind: ExprKind::Text(text.into()) })
            }
        };
        let indices = pair.into_inner().filter_map(index).collect();
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
                    let names: Vec<_> = part.into_inner().collect();
                    let optional = names.len() > 1 && self.text_of(&names[0]) == "optional";
                    let names = names.iter().skip(usize::from(optional));
                    parameters.extend(names.map(|name| (self.symbol(name), optional)));
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
