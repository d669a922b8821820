//! Builds the syntax tree's nodes of directives.

use super::expr::unescape;
use super::{Builder, Context, name_of};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::class;
use crate::syntax::parse::Rule;
use crate::syntax::word;
use pest::iterators::Pair;

impl Builder<'_> {
    pub(super) fn directive(&self, pair: Pair<Rule>, context: Context) -> Directive {
        match pair.as_rule() {
            Rule::conditional => Directive::If(self.branches_of(pair, context)),
            Rule::while_loop => {
                let (head, body) = self.head_and_body(pair, context);
                Directive::While(self.head(head), body)
            }
            Rule::for_loop => {
                let (head, body) = self.head_and_body(pair, context);
                Directive::For(For { head: self.for_head(head), body })
            }
            Rule::switch => self.switch(pair, context),
            Rule::macro_definition => self.macro_definition(pair),
            _ => Directive::Plain(Symbol(self.first_token(&pair).data)),
        }
    }

    /// Builds the contents of the parentheses after a directive's word.
    fn head(&self, head: Option<Pair<Rule>>) -> Head {
        let Some(head) = head else { return Head::Pieces(None) };
        let whole = if self.single { None } else { self.expr_in_brackets(head.clone(), Context::Script) };
        match whole {
            Some(e) => Head::Whole(e),
            None => Head::Pieces(Some(self.elements(head, Context::Script))),
        }
    }

    fn for_head(&self, head: Option<Pair<Rule>>) -> ForHead {
        let elements = head.map(|head| self.elements(head, Context::Script));
        if let (Some([counter, range @ ..]), false) = (elements.as_deref(), self.single)
            && let (Some(symbol), true) = (name_of(counter), counter.comma)
            && (2..=3).contains(&range.len())
            && range.iter().enumerate().all(|(i, e)| e.comma == (i + 1 < range.len()))
            && !range.iter().any(|e| matches!(&e.kind, ElementKind::Expr(e) if e.calls))
        {
            let expr = |e: &Element| match &e.kind {
                ElementKind::Expr(e) => Some((**e).clone()),
                _ => None,
            };
            if let Some(range) = range.iter().map(expr).collect() {
                return ForHead::Whole(symbol, range);
            }
        }
        ForHead::Pieces(elements)
    }

    fn head_and_body<'i>(&self, pair: Pair<'i, Rule>, context: Context) -> (Option<Pair<'i, Rule>>, Box<[Element]>) {
        let (mut head, mut body) = (None, Box::default());
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::head => head = Some(part),
                _ => body = self.elements(part, context),
            }
        }
        (head, body)
    }

    /// Builds a declaration of one target or several. `None` if a target is not a plain name with indices, or if each
    /// token is an element of its own (`single`).
    pub(super) fn declare(&self, pair: Pair<Rule>) -> Option<Declare> {
        if self.single {
            return None;
        }
        let local = self.first_token(&pair).data == 1;
        let (mut deprecated, mut targets) = (None, vec![]);
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::deprecated => {
                    let tokens = &self.tokens[super::token_range(&part)];
                    let once = tokens.iter().any(|t| self.token_text(*t) == "once");
                    let why = part.into_inner().find(|p| p.as_rule() == Rule::STRING);
                    deprecated = Some((once, why.map_or("".into(), |s| unescape(self.first_token_text(&s)))));
                }
                Rule::targets => targets.extend(part.into_inner().map(|p| self.target(p))),
                _ => targets.push(self.target(part)),
            }
        }
        let mut targets = targets.into_iter().collect::<Option<Vec<Target>>>()?;
        if targets.is_empty() {
            return None;
        }
        let target = targets.remove(0);
        Some(Declare { local, deprecated, target, others: targets.into() })
    }

    fn target(&self, pair: Pair<Rule>) -> Option<Target> {
        let name = self.name(&pair);
        // `local.A` and `global.A` (3.8) are names with a prefix, unless a dictionary is called so: the run knows.
        let may_be_prefix = matches!(self.first_token_text(&pair), "local" | "global");
        if may_be_prefix && pair.clone().into_inner().next().is_some_and(|part| part.as_rule() == Rule::dot) {
            return None;
        }
        let keyword = word::reserved(self.first_token_text(&pair));
        let symbol = self.symbol(&pair);
        let index = |part: Pair<Rule>| match part.as_rule() {
            // (A call there may be a macro's.)
            Rule::index => Some(self.expr_in_brackets(part, Context::Script).filter(|e| !e.calls)),
            // `D.Key` is `D["Key"]`.
            Rule::dot => {
                let token = self.tokens[part.as_span().start() + 1];
                let (span, text) = (self.token_span(token), self.token_text(token));
                Some(Some(Expr { span, calls: false, kind: ExprKind::Text(text.into()) }))
            }
            _ => None,
        };
        let indices = pair.into_inner().filter_map(index).collect::<Option<Box<[Expr]>>>()?;
        Some(Target { symbol, span: name.span, keyword, indices })
    }

    /// Builds the branches of an `#if` directive. Each branch extends from its directive's word to the next one.
    fn branches_of(&self, pair: Pair<Rule>, context: Context) -> Box<[Branch]> {
        let (kind, mut branches, mut head) = (self.first_token_text(&pair), vec![], None);
        let kind = kind[1..].trim_start().to_string();
        let mut start = pair.as_span().start();
        for part in pair.into_inner() {
            let end = part.as_span().end();
            match part.as_rule() {
                Rule::head => head = Some(part),
                Rule::otherwise => {
                    let span = self.span_of_token_indices(start, end);
                    let body = part.into_inner().next().map_or(Box::default(), |b| self.elements(b, context));
                    branches.push(Branch { span, condition: Condition::Always, body });
                    start = end;
                }
                _ => {
                    let given = self.head(head.take());
                    let condition = match (&*kind, branches.is_empty()) {
                        ("ifdef", true) => Condition::Declared(given),
                        ("ifndef", true) => Condition::NotDeclared(given),
                        _ => Condition::True(given),
                    };
                    let span = self.span_of_token_indices(start, end);
                    branches.push(Branch { span, condition, body: self.elements(part, context) });
                    start = end;
                }
            }
        }
        branches.into_boxed_slice()
    }

    fn span_of_token_indices(&self, start_token: usize, token_after_end: usize) -> Span {
        self.token_span(self.tokens[start_token])
            .to(self.token_span(self.tokens[token_after_end.max(start_token + 1) - 1]))
    }

    fn switch(&self, pair: Pair<Rule>, context: Context) -> Directive {
        let (mut value, mut arms) = (None, vec![]);
        for part in pair.into_inner() {
            let (rule, span) = (part.as_rule(), self.span(&part));
            match rule {
                Rule::head => value = Some(part),
                Rule::case | Rule::range | Rule::otherwise => {
                    let (head, body) = self.head_and_body(part, context);
                    let when = match rule {
                        Rule::case => When::Case(self.head(head)),
                        Rule::range => When::Range(head.map(|head| self.elements(head, Context::Script))),
                        _ => When::Otherwise,
                    };
                    arms.push(Arm { span, when, body });
                }
                // Elements before the first `#case` never run.
                _ => {}
            }
        }
        Directive::Switch(self.head(value), arms.into_boxed_slice())
    }

    fn macro_definition(&self, pair: Pair<Rule>) -> Directive {
        let (mut head, mut body) = (None, Box::default());
        let span = self.token_span(self.first_token(&pair));
        let second = pair.as_span().start() + 1;
        let named = matches!(self.classes.get(second), Some(&(class::NAME | class::KEYWORD | class::BUILTIN)));
        let name = named.then(|| self.tokens[second]);
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::head => head = Some(part),
                _ => body = self.elements(part, Context::Script),
            }
        }
        let mut fault = None;
        let mut parameters = vec![];
        let mut optional = false;
        for element in head.map_or(Box::default(), |head| self.elements(head, Context::Script)) {
            match name_of(&element) {
                // `optional A`
                Some(symbol) if self.names.text(symbol) == "optional" && !optional && !element.comma => optional = true,
                Some(symbol) => parameters.push((symbol, std::mem::take(&mut optional))),
                None if matches!(element.kind, ElementKind::Comma) => {}
                None => fault = fault.or(Some(element.span)),
            }
        }
        if optional {
            parameters.push((self.names.intern("optional"), false));
        }
        let (symbol, context) = match name {
            Some(name) => (self.names.intern(self.token_text(name)), self.token_span(name)),
            None => {
                fault = Some(span.end());
                (self.names.intern(""), span)
            }
        };
        Directive::Macro(Macro { name: symbol, span: context, fault, parameters: parameters.into(), body })
    }
}
