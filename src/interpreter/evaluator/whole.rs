//! Tests whether an expression of the syntax tree can be evaluated as a whole, or must be split into tokens.

use super::{Contents, Evaluator};
use crate::syntax::ast::*;
use crate::value::Value;
use std::cell::Cell;

/// Maximum number of calls of value macros to which the call of one may lead; beyond it, calls are expanded to tokens. (The
/// test takes as long as it finds calls, and does not count as steps.)
const MAX_VALUE_CALLS: u32 = 16;

/// Calls of value macros inside each other, the innermost first.
#[derive(Clone, Copy)]
struct ValueCalls<'c> {
    definition: &'c Macro,
    outer: Option<&'c ValueCalls<'c>>,
    /// Number of further calls that may be found in the outermost call.
    calls_left: &'c Cell<u32>,
}

impl<'c> ValueCalls<'c> {
    fn innermost_first(&'c self) -> impl Iterator<Item = &'c Macro> {
        std::iter::successors(Some(self), |call| call.outer).map(|call| call.definition)
    }

    /// True if one of the macros has a parameter of this name, so that its contents are known only in the call.
    fn bind(calls: Option<&Self>, name: Symbol) -> bool {
        let has_parameter = |definition: &Macro| definition.parameters.iter().any(|(parameter, _)| *parameter == name);
        calls.is_some_and(|calls| calls.innermost_first().any(has_parameter))
    }
}

impl Evaluator<'_> {
    /// True if an expression must be split into tokens: because it calls a macro that is no value macro, or because the
    /// name before a parenthesis is not that of a function.
    #[inline]
    pub fn must_split_into_tokens(&self, e: &Expr) -> bool {
        e.calls && self.has_call_needing_tokens(e, None)
    }

    /// Like [`Self::must_split_into_tokens`], for an expression in the body of the innermost of `calls`.
    fn must_split(&self, e: &Expr, calls: Option<&ValueCalls>) -> bool {
        e.calls && self.has_call_needing_tokens(e, calls)
    }

    fn has_call_needing_tokens(&self, e: &Expr, calls: Option<&ValueCalls>) -> bool {
        let any = |elements: &[Element]| elements.iter().any(|element| self.element_needs_tokens(element, calls));
        match &e.kind {
            ExprKind::Call(name, _) if ValueCalls::bind(calls, *name) => true,
            ExprKind::Call(name, arguments) => match self.scopes.get(*name) {
                Some(Contents::Value(value)) if is_callable(value) => any(arguments),
                // A value before a parenthesis is no call: `plane { z (-6) }`.
                Some(Contents::Value(_)) => true,
                Some(Contents::Macro(definition)) => !self.is_value_call(definition, arguments, calls),
                Some(_) => false,
                None => self.is_constant(*name),
            },
            ExprKind::Vector(parts) => any(parts),
            ExprKind::Paren(inner) | ExprKind::Prefix(_, inner) => self.must_split(inner, calls),
            ExprKind::Chain(chain) => {
                self.must_split(&chain.first, calls) || chain.rest.iter().any(|(_, e)| self.must_split(e, calls))
            }
            ExprKind::Choice(parts) => parts.iter().any(|e| self.must_split(e, calls)),
            ExprKind::Builtin(_, arguments) => arguments.iter().any(|e| self.must_split(e, calls)),
            ExprKind::Index(base, indices) => {
                self.must_split(base, calls) || indices.iter().any(|e| self.must_split(e, calls))
            }
            ExprKind::Apply(base, arguments) => self.must_split(base, calls) || any(arguments),
            ExprKind::Dot(base, _, symbol) => self.must_split(base, calls) || self.is_macro(*symbol),
            ExprKind::Block(_) | ExprKind::Function(_) => true,
            ExprKind::Number(_) | ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Literal(_) => false,
        }
    }

    /// True if a macro's call can be evaluated like that of a function, because the body of the macro is a value and all
    /// arguments are plain.
    fn is_value_call(&self, definition: &Macro, arguments: &[Element], outer: Option<&ValueCalls>) -> bool {
        let Some(value) = definition.value().filter(|_| !self.expands_all_macros) else { return false };
        let outermost = Cell::new(MAX_VALUE_CALLS);
        let calls_left = outer.map_or(&outermost, |outer| outer.calls_left);
        let Some(left) = calls_left.get().checked_sub(1) else { return false };
        calls_left.set(left);
        let calls = ValueCalls { definition, outer, calls_left };
        arguments.len() == definition.parameters.len()
            && arguments.iter().all(|argument| self.is_plain(argument, outer))
            && !self.must_split(value, Some(&calls))
    }

    fn element_needs_tokens(&self, element: &Element, calls: Option<&ValueCalls>) -> bool {
        match &element.kind {
            ElementKind::Expr(e) => match &e.kind {
                ExprKind::Name(name) => self.is_macro(*name),
                _ => e.has_bare_condition() || self.must_split(e, calls),
            },
            ElementKind::Numbers(_) => false,
            // `cubic_spline` in the call of a spline.
            ElementKind::Word(_) => false,
            _ => true,
        }
    }

    /// True if a macro's argument is one expression that needs no tokens and yields one value.
    pub fn is_plain_argument(&self, element: &Element) -> bool {
        self.is_plain(element, None)
    }

    fn is_plain(&self, element: &Element, calls: Option<&ValueCalls>) -> bool {
        let ElementKind::Expr(e) = &element.kind else { return false };
        match &e.kind {
            ExprKind::Name(symbol) => {
                ValueCalls::bind(calls, *symbol) || matches!(self.scopes.get(*symbol), Some(Contents::Value(_)))
            }
            ExprKind::Number(_) | ExprKind::Text(_) | ExprKind::Literal(_) => true,
            ExprKind::Chain(_) | ExprKind::Paren(_) | ExprKind::Vector(_) => {
                !e.has_bare_condition() && !self.must_split(e, calls)
            }
            ExprKind::Prefix(..) | ExprKind::Builtin(..) => !self.must_split(e, calls),
            ExprKind::Call(name, _) => self.is_macro(*name) && !self.must_split(e, calls),
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
