//! durer's own words, which are words only inside certain blocks.

use crate::source::Span;
use crate::syntax::Names;
use crate::syntax::ast::*;

/// `eye -5*z` reads as a name minus something; where `eye` is a word of the block, it is a word and `-5*z`.
pub(super) fn split_contextual(
    element: Element,
    context: &[&'static str],
    names: &Names,
) -> (Element, Option<Element>) {
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
