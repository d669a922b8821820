//! Splits parsed expressions and lists of literals into single tokens.

use super::{FrameKind, TokenStream};
use crate::interpreter::Inputs;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::{Granularity, split_one_level};

impl<'a> TokenStream<'a> {
    /// Replaces the expression or literal list that comes next by its parts.
    pub fn split_next_element(&mut self) {
        self.look_ahead = None;
        let inputs = self.inputs;
        let Some(frame) = self.frames.last_mut() else { return };
        let Some(element) = frame.next() else { return };
        let item = frame.item;
        frame.at += 1;
        frame.item = (0, 0);
        let parts = inputs.parsed.cached_parts(element, || match &element.kind {
            ElementKind::Expr(e) => inputs.with_exact_operator_spans(split_one_level(e, inputs.names)),
            ElementKind::Numbers(_) => inputs.tokens_of(element.span),
            _ => vec![element.clone()],
        });
        self.push_elements(parts, None, element.span, element.comma);
        if let (ElementKind::Numbers(list), Some(frame)) = (&element.kind, self.frames.last_mut()) {
            // Skip the items consumed before: each item ends with a comma.
            let behind = parts
                .iter()
                .enumerate()
                .filter(|(_, e)| e.comma && is_last_token_of_item(parts, e))
                .map(|(i, _)| i + 1);
            frame.at = if item.0 == 0 { 0 } else { behind.take(list.len()).nth(item.0 - 1).unwrap_or(0) };
        }
    }

    /// Replaces the elements that the innermost frame has not read yet by single tokens. A loop's frame, which is read
    /// again, stays as it is.
    pub fn retokenize_unread(&mut self) {
        let inputs = self.inputs;
        let Some(frame) = self.frames.last_mut() else { return };
        if !matches!(frame.kind(), FrameKind::File | FrameKind::Include | FrameKind::Branch) {
            return;
        }
        let ([first, ..], [.., last]) = (frame.unread(), frame.unread()) else { return };
        self.look_ahead = None;
        let span = first.span.to(last.span);
        frame.elements = inputs.parsed.cached_rest_tokens(first, || inputs.tokens_of(span));
        frame.at = 0;
    }
}

impl<'a> Inputs<'a> {
    /// Shrinks the spans of operators that were split from an expression to the operator signs.
    fn with_exact_operator_spans(&self, mut parts: Vec<Element>) -> Vec<Element> {
        for part in parts.iter_mut().filter(|part| matches!(part.kind, ElementKind::Punctuation(_))) {
            let text = self.sources.snippet(part.span);
            let lo = part.span.lo + (text.len() - text.trim_start().len()) as u32;
            part.span = Span { lo, hi: lo + text.trim().len() as u32 };
        }
        parts
    }

    /// Returns an expression as a list of one element, which can be split if needed.
    pub fn as_single_element(&self, e: &'a Expr) -> &'a [Element] {
        self.parsed.cached_parts(e, || vec![Element::new(e.span, ElementKind::Expr(Box::new(e.clone())))])
    }

    /// Returns the text at `span` as single tokens.
    pub fn tokens_of(&self, span: Span) -> Vec<Element> {
        let text = self.sources.snippet(span);
        crate::syntax::parse_text(text, span.lo as usize, self.names, Granularity::Tokens).0.elements
    }
}

/// True if an item of a list of literals ends with `token`; false within a vector.
fn is_last_token_of_item(list_tokens: &[Element], token: &Element) -> bool {
    let before = list_tokens.iter().take_while(|e| !std::ptr::eq(*e, token));
    let depth = before.fold(0_i32, |depth, e| match e.kind {
        ElementKind::Punctuation(Punctuation::Operator(Operator::Less)) => depth + 1,
        ElementKind::Punctuation(Punctuation::Operator(Operator::Greater)) => depth - 1,
        _ => depth,
    });
    let closes = matches!(token.kind, ElementKind::Punctuation(Punctuation::Operator(Operator::Greater)));
    depth == i32::from(closes)
}
