//! Access to elements of arrays and dictionaries.

use super::{Array, Contents, Evaluator, LValue};
use crate::diagnostic::{Diagnostic, Fault, Result, codes, did_you_mean};
use crate::source::Span;
use crate::syntax::ast::{Expr, ExprKind, Symbol};
use crate::value::Value;

impl<'a> Evaluator<'a> {
    /// True if the element of `symbol` at these keys is a dictionary. Without keys, true if `symbol` itself is one.
    pub fn is_dictionary(&self, symbol: Symbol, keys: &[(Value, Span)]) -> bool {
        let Some(mut lvalue) = self.scopes.resolve(symbol) else { return false };
        for (key, _) in keys {
            let Some(dictionary) = self.scopes.dictionary(&lvalue) else { return false };
            let Value::Text(key) = key else { return false };
            let Some(i) = dictionary.key_index(key) else { return false };
            lvalue = lvalue.element(&[i]);
        }
        self.scopes.dictionary(&lvalue).is_some()
    }

    /// Returns the location of the element `key` of the dictionary at `lvalue`, for the expression `base.key`; `None`
    /// for another expression, or without a dictionary at `lvalue`. An error if the dictionary has no such key.
    pub fn dictionary_element_lvalue(&self, lvalue: &LValue, e: &Expr) -> Result<Option<LValue>> {
        let ExprKind::Dot(_, name, symbol) = &e.kind else { return Ok(None) };
        let Some(dictionary) = self.scopes.dictionary(lvalue) else { return Ok(None) };
        let key = self.inputs.names.text(*symbol);
        match dictionary.key_index(key) {
            Some(i) => Ok(Some(lvalue.element(&[i]))),
            None => Err(missing_key_error(dictionary, key, name.span)),
        }
    }

    /// Returns the level of the scope that a prefix names: `local` of `local.A` or `global` of `global.A` (3.8); `None`
    /// for other names, and for a declared name.
    pub fn scope_level_of_prefix(&self, symbol: Symbol) -> Option<u32> {
        if self.is_declared(symbol) {
            return None;
        }
        match self.inputs.names.text(symbol) {
            "local" => Some(self.scopes.level()),
            "global" => Some(0),
            _ => None,
        }
    }

    /// Returns the location of `local.A` or `global.A` (3.8); `None` for other expressions.
    pub fn prefixed_lvalue(&self, e: &Expr) -> Option<LValue> {
        let ExprKind::Dot(base, _, symbol) = &e.kind else { return None };
        let ExprKind::Name(prefix) = base.kind else { return None };
        self.scope_level_of_prefix(prefix).map(|level| self.scopes.resolve_at(*symbol, level))
    }

    /// Returns the location of a dictionary's element by its keys. With `adds_key`, a new last key is added.
    pub fn key_lvalue(&mut self, lvalue: LValue, keys: &[(Value, Span)], adds_key: bool) -> Result<LValue> {
        let mut lvalue = lvalue;
        for (i, (value, span)) in keys.iter().enumerate() {
            let Value::Text(key) = value else { return not_text_error(value, *span) };
            let Some(dictionary) = self.scopes.dictionary(&lvalue) else {
                return Diagnostic::err(codes::WRONG_TYPE, *span, "this is no dictionary: it has no keys");
            };
            let index = match dictionary.key_index(key) {
                Some(index) => index,
                None if adds_key && i + 1 == keys.len() => self.scopes.add_key(&lvalue, key),
                None => return Err(missing_key_error(dictionary, key, *span)),
            };
            lvalue = lvalue.element(&[index]);
        }
        Ok(lvalue)
    }

    /// Returns the contents of a location; an error if the location has no value.
    pub fn contents_at(&self, lvalue: &LValue, span: Span) -> Result<Contents<'a>> {
        match self.scopes.contents_at(lvalue) {
            Some(contents) => Ok(contents.clone()),
            None => self.no_value_error(span),
        }
    }

    /// Returns the error "… has no value yet".
    pub fn no_value_error<T>(&self, span: Span) -> Result<T> {
        let text = self.inputs.sources.snippet(span);
        let d = Diagnostic::new(codes::UNDECLARED, span, format!("`{text}` has no value yet"));
        d.help(format!("`#declare {text} = …;` gives it one")).into()
    }
}

fn missing_key_error(dictionary: &Array, key: &str, span: Span) -> Fault {
    let d = Diagnostic::new(codes::UNDECLARED, span, format!("the dictionary has no `{key}`"));
    let keys = dictionary.keys.iter().flatten().map(|k| &**k);
    Box::new(d.maybe_help(did_you_mean(key, keys)))
}

/// Returns the error "expected a string" for a value of another type.
pub fn not_text_error<T>(found: &Value, span: Span) -> Result<T> {
    let message = format!("expected a string, found {}", found.describe());
    Diagnostic::new(codes::WRONG_TYPE, span, message).help("`str(A, 0, 3)` makes text of a number").into()
}
