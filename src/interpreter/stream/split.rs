//! What stands whole and is no whole after all: a macro in it gives tokens of its own, or something goes on with it.

use super::{FrameKind, StackFrame};
use crate::interpreter::Interpreter;
use crate::interpreter::evaluator::Slot;
use crate::interpreter::token_expr::is_callable;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::pieces;

impl<'a> Interpreter<'a> {
    /// Does a macro in the expression give tokens of its own, or is something called that can't be? Then it is no whole.
    #[inline]
    pub(in crate::interpreter) fn splits(&self, e: &Expr) -> bool {
        e.calls && self.calls_split(e)
    }

    pub(in crate::interpreter) fn calls_split(&self, e: &Expr) -> bool {
        let any = |elements: &[Element]| elements.iter().any(|element| self.element_splits(element));
        match &e.kind {
            ExprKind::Call(name, arguments) => match self.evaluator.scopes.get(*name) {
                Some(Slot::Value(value)) if is_callable(value) => any(arguments),
                // A value before a parenthesis is no call: `plane { z (-6) }`.
                Some(Slot::Value(_) | Slot::Macro(_)) => true,
                Some(_) => false,
                None => self.is_constant(*name),
            },
            ExprKind::Vector(parts) => any(parts),
            ExprKind::Paren(inner) | ExprKind::Prefix(_, inner) => self.splits(inner),
            ExprKind::Chain(chain) => self.splits(&chain.first) || chain.rest.iter().any(|(_, e)| self.splits(e)),
            ExprKind::Choice(parts) => parts.iter().any(|e| self.splits(e)),
            ExprKind::Builtin(_, arguments) => arguments.iter().any(|e| self.splits(e)),
            ExprKind::Index(base, indices) => self.splits(base) || indices.iter().any(|e| self.splits(e)),
            ExprKind::Apply(base, arguments) => self.splits(base) || any(arguments),
            ExprKind::Dot(base, _, symbol) => self.splits(base) || self.is_macro(*symbol),
            ExprKind::Block(_) | ExprKind::Function(_) => true,
            ExprKind::Number(_) | ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Literal(_) => false,
        }
    }

    pub(in crate::interpreter) fn element_splits(&self, element: &Element) -> bool {
        match &element.kind {
            ElementKind::Expr(e) => match &e.kind {
                ExprKind::Name(name) => self.is_macro(*name),
                _ => e.compares() || self.splits(e),
            },
            ElementKind::Numbers(_) => false,
            // `cubic_spline` of a spline's call.
            ElementKind::Word(_) => false,
            _ => true,
        }
    }

    /// Replaces the expression or list of literals that comes next by its parts.
    pub(in crate::interpreter) fn take_apart(&mut self) {
        self.stream.peeked = None;
        let Some(frame) = self.stream.frames.last_mut() else { return };
        let Some(element) = frame.elements.get(frame.at) else { return };
        let item = frame.item;
        frame.at += 1;
        frame.item = (0, 0);
        let parts = self.inputs.parsed.parts_of(element, || match &element.kind {
            ElementKind::Expr(e) => self.with_exact_signs(pieces(e, self.inputs.names)),
            ElementKind::Numbers(_) => self.tokens_of(element.span),
            _ => vec![element.clone()],
        });
        self.push_piece(parts, None, element.span, element.comma);
        if let (ElementKind::Numbers(list), Some(frame)) = (&element.kind, self.stream.frames.last_mut()) {
            // Those that were read before are passed over: each item ends with a comma.
            let behind = parts.iter().enumerate().filter(|(_, e)| e.comma && item_ends(parts, e)).map(|(i, _)| i + 1);
            frame.at = if item.0 == 0 { 0 } else { behind.take(list.len()).nth(item.0 - 1).unwrap_or(0) };
        }
    }

    /// The place of an operator that was taken out of an expression is all that stands between its operands.
    pub(in crate::interpreter) fn with_exact_signs(&self, mut parts: Vec<Element>) -> Vec<Element> {
        for part in parts.iter_mut().filter(|part| matches!(part.kind, ElementKind::Sign(_))) {
            let text = self.inputs.sources.snippet(part.span);
            let lo = part.span.lo + (text.len() - text.trim_start().len()) as u32;
            part.span = Span { lo, hi: lo + text.trim().len() as u32 };
        }
        parts
    }

    /// Leaves macros that have come to their end.
    pub(in crate::interpreter) fn pop_spent(&mut self) {
        let spent = |f: &StackFrame| {
            let leaves = matches!(f.kind, FrameKind::Macro(_) | FrameKind::Piece | FrameKind::Branch);
            leaves && f.closer.is_none() && f.at >= f.elements.len()
        };
        while self.stream.held.is_empty() && self.stream.frames.last().is_some_and(spent) {
            self.pop_frame();
        }
    }

    /// An expression as the only element of a row, so that it is taken apart where it has to be.
    pub(in crate::interpreter) fn as_elements(&self, e: &'a Expr) -> &'a [Element] {
        self.inputs.parsed.parts_of(e, || vec![Element::new(e.span, ElementKind::Expr(Box::new(e.clone())))])
    }

    /// A piece of text as single tokens.
    pub(in crate::interpreter) fn tokens_of(&self, span: Span) -> Vec<Element> {
        let text = self.inputs.sources.snippet(span);
        crate::syntax::parse_text(text, span.lo as usize, self.inputs.names, crate::syntax::Wholes::TakenApart)
            .0
            .elements
    }
}

/// Does an item of a list of literals end with this element, not a number of a vector?
fn item_ends(parts: &[Element], element: &Element) -> bool {
    let before = parts.iter().take_while(|e| !std::ptr::eq(*e, element));
    let depth = before.fold(0_i32, |depth, e| match e.kind {
        ElementKind::Sign(Sign::Operator(Operator::Less)) => depth + 1,
        ElementKind::Sign(Sign::Operator(Operator::Greater)) => depth - 1,
        _ => depth,
    });
    let closes = matches!(element.kind, ElementKind::Sign(Sign::Operator(Operator::Greater)));
    depth == i32::from(closes)
}
