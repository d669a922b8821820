//! Tests whether an expression of the syntax tree can be evaluated as a whole, or must be split into tokens.

use super::{Contents, Evaluator};
use crate::syntax::ast::*;
use crate::value::Value;

impl Evaluator<'_> {
    /// True if an expression must be split into tokens: because it calls a macro, or because the name before a
    /// parenthesis is not that of a function.
    #[inline]
    pub fn must_split_into_tokens(&self, e: &Expr) -> bool {
        e.calls && self.has_call_needing_tokens(e)
    }

    fn has_call_needing_tokens(&self, e: &Expr) -> bool {
        let any = |elements: &[Element]| elements.iter().any(|element| self.element_needs_tokens(element));
        match &e.kind {
            ExprKind::Call(name, arguments) => match self.scopes.get(*name) {
                Some(Contents::Value(value)) if is_callable(value) => any(arguments),
                // A value before a parenthesis is no call: `plane { z (-6) }`.
                Some(Contents::Value(_) | Contents::Macro(_)) => true,
                Some(_) => false,
                None => self.is_constant(*name),
            },
            ExprKind::Vector(parts) => any(parts),
            ExprKind::Paren(inner) | ExprKind::Prefix(_, inner) => self.must_split_into_tokens(inner),
            ExprKind::Chain(chain) => {
                self.must_split_into_tokens(&chain.first)
                    || chain.rest.iter().any(|(_, e)| self.must_split_into_tokens(e))
            }
            ExprKind::Choice(parts) => parts.iter().any(|e| self.must_split_into_tokens(e)),
            ExprKind::Builtin(_, arguments) => arguments.iter().any(|e| self.must_split_into_tokens(e)),
            ExprKind::Index(base, indices) => {
                self.must_split_into_tokens(base) || indices.iter().any(|e| self.must_split_into_tokens(e))
            }
            ExprKind::Apply(base, arguments) => self.must_split_into_tokens(base) || any(arguments),
            ExprKind::Dot(base, _, symbol) => self.must_split_into_tokens(base) || self.is_macro(*symbol),
            ExprKind::Block(_) | ExprKind::Function(_) => true,
            ExprKind::Number(_) | ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Literal(_) => false,
        }
    }

    fn element_needs_tokens(&self, element: &Element) -> bool {
        match &element.kind {
            ElementKind::Expr(e) => match &e.kind {
                ExprKind::Name(name) => self.is_macro(*name),
                _ => e.has_bare_condition() || self.must_split_into_tokens(e),
            },
            ElementKind::Numbers(_) => false,
            // `cubic_spline` in the call of a spline.
            ElementKind::Word(_) => false,
            _ => true,
        }
    }

    /// True if a macro's argument is one expression that calls no macro and yields one value.
    pub fn is_plain_argument(&self, element: &Element) -> bool {
        let ElementKind::Expr(e) = &element.kind else { return false };
        match &e.kind {
            ExprKind::Name(symbol) => matches!(self.scopes.get(*symbol), Some(Contents::Value(_))),
            ExprKind::Number(_) | ExprKind::Text(_) | ExprKind::Literal(_) => true,
            ExprKind::Chain(_) | ExprKind::Paren(_) | ExprKind::Vector(_) => {
                !e.has_bare_condition() && !self.must_split_into_tokens(e)
            }
            ExprKind::Prefix(..) | ExprKind::Builtin(..) => !self.must_split_into_tokens(e),
            _ => false,
        }
    }

    /// True if the expression is a macro's name or call.
    pub fn is_macro_call(&self, e: &Expr) -> bool {
        matches!(e.kind, ExprKind::Call(name, _) | ExprKind::Name(name) if self.is_macro(name))
    }

    /// True if a `[` after the name begins an index; false for a declared thing, where it begins a map's entry.
    pub fn bracket_begins_index(&self, symbol: Symbol) -> bool {
        !matches!(self.scopes.get(symbol), Some(Contents::Value(Value::Thing(_))))
    }

    /// True if the expression ends with the name of a function, spline or macro, so that arguments may follow.
    pub fn ends_with_callable(&self, e: &Expr) -> bool {
        let mut last = e;
        while let ExprKind::Chain(chain) = &last.kind {
            let Some((_, operand)) = chain.rest.last() else { return false };
            last = operand;
        }
        match last.kind {
            ExprKind::Name(name) => match self.scopes.get(name) {
                Some(Contents::Value(value)) => is_callable(value),
                contents => matches!(contents, Some(Contents::Macro(_))),
            },
            _ => false,
        }
    }
}

/// True if the value is a function or a spline.
pub fn is_callable(value: &Value) -> bool {
    matches!(value, Value::Thing(thing) if matches!(thing.kind(), "function" | "spline"))
}
