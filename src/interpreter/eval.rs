//! Expressions.

use super::Interpreter;
use super::operators::{apply, apply_prefix, component};
use super::quick::Quick;
use super::scope::Slot;
use super::stream::{FrameKind, Token};
use crate::diagnostic::{Diagnostic, Result, codes, did_you_mean};
use crate::math::DVec3;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::word;
use crate::value::{Value, VecN};

/// A value and, where a bare sum comes out of a macro, the rest of its terms: what is multiplied with it binds to the
/// first or last of them.
type Parts = (Value, Vec<(Operator, Value)>);

impl<'a> Interpreter<'a> {
    /// The value of an expression.
    pub(super) fn eval(&mut self, e: &'a Expr) -> Result<Value> {
        match self.quick(e) {
            Some(Quick::Float(x)) => return Ok(Value::Float(x)),
            Some(Quick::Vector(v)) => return Ok(Value::Vector(v)),
            None => {}
        }
        match &e.kind {
            ExprKind::Number(x) => Ok(Value::Float(*x)),
            ExprKind::Text(text) => Ok(Value::Text((**text).into())),
            ExprKind::Name(symbol) => self.name_value(*symbol, e.span),
            ExprKind::Literal(data) => vector_value(data, e.span),
            ExprKind::Vector(parts) => self.vector_parts(parts, e.span),
            ExprKind::Paren(inner) => self.eval(inner),
            ExprKind::Chain(chain) => self.chain(chain),
            ExprKind::Prefix(..) | ExprKind::Call(..) => {
                let parts = self.operand_parts(e)?;
                self.join(parts, e.span)
            }
            ExprKind::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                if self.condition(condition)? { self.eval(yes) } else { self.eval(no) }
            }
            ExprKind::Builtin(name, arguments) => self.builtin(name, arguments, e.span),
            ExprKind::Dot(..) => self.components(e),
            ExprKind::Spliced(elements) | ExprKind::ParenSpliced(elements) => self.operand(elements, e.span),
            ExprKind::Index(array, indices) => {
                let slot = self.indexed(array, indices, e.span)?;
                self.slot_value(slot, e.span)
            }
            ExprKind::Apply(function, arguments) => {
                let function = self.eval(function)?;
                self.call_thing(&function, arguments, e.span)
            }
            ExprKind::Function(_) => {
                Diagnostic::err(codes::EXPECTED_VALUE, e.span, "expected a number or text, found a function")
            }
            ExprKind::Keyword(word) => {
                Diagnostic::err(codes::EXPECTED_VALUE, e.span, format!("expected a value, found the word `{word}`"))
            }
            ExprKind::Block(block) => {
                let name = block.name.word.unwrap_or("this block");
                Diagnostic::err(
                    codes::EXPECTED_VALUE,
                    e.span,
                    format!("expected a number or text, found `{name} {{…}}`"),
                )
            }
        }
    }

    /// `A.x`; a component of a component is no recursion, however many there are.
    fn components(&mut self, e: &'a Expr) -> Result<Value> {
        if let Some(place) = self.dictionary_place(e)? {
            let slot = self.slot_at(&place, e.span)?;
            return self.slot_value(slot, e.span);
        }
        let (mut base, mut names) = (e, vec![]);
        while let ExprKind::Dot(inner, name, _) = &base.kind {
            names.push((name, inner.span));
            base = inner;
        }
        let value = self.eval(base)?;
        names.iter().rev().try_fold(value, |value, (name, span)| component(&value, name, *span))
    }

    /// A number.
    pub(super) fn number(&mut self, e: &'a Expr) -> Result<f64> {
        if let Some(x) = self.simple(e) {
            return Ok(x);
        }
        let value = self.eval(e)?;
        as_float(&value, e.span)
    }

    /// A string.
    pub(super) fn text_value(&mut self, e: &'a Expr) -> Result<String> {
        match self.eval(e)? {
            Value::Text(text) => Ok(text.to_string()),
            other => {
                let message = format!("expected a string, found {}", other.describe());
                Diagnostic::new(codes::WRONG_TYPE, e.span, message).help("`str(A, 0, 3)` makes text of a number").into()
            }
        }
    }

    /// What a name stands for, as a value.
    pub(super) fn name_value(&mut self, symbol: Symbol, span: Span) -> Result<Value> {
        match self.scopes.get(symbol) {
            Some(Slot::Value(Value::Thing(thing))) => {
                let thing = thing.clone();
                self.first_use(symbol, span);
                Ok(Value::Thing(thing))
            }
            Some(Slot::Value(value)) => {
                let value = value.clone();
                if !self.deprecated.is_empty() {
                    self.first_use(symbol, span);
                }
                Ok(value)
            }
            Some(slot @ (Slot::Faulty(_) | Slot::Macro(_) | Slot::Array(_) | Slot::File(_))) => {
                let slot = slot.clone();
                self.slot_value(slot, span)
            }
            Some(Slot::Alias(_)) | None => self.constant(symbol, span),
        }
    }

    /// What a name or an array's element holds, where a value is needed.
    pub(super) fn slot_value(&mut self, slot: Slot<'a>, span: Span) -> Result<Value> {
        match slot {
            Slot::Value(value) => Ok(value),
            Slot::Faulty(faults) => {
                for fault in faults.iter() {
                    self.report_fault(fault.clone());
                }
                Diagnostic::err(codes::FOLLOWS, span, "")
            }
            Slot::Macro(definition) => {
                let name = self.names.text(definition.name);
                Diagnostic::new(codes::EXPECTED_VALUE, span, format!("`{name}` is a macro"))
                    .help(format!("a call needs parentheses: `{name}()`"))
                    .into()
            }
            Slot::File(_) => {
                let name = self.sources.snippet(span);
                Diagnostic::err(codes::EXPECTED_VALUE, span, format!("`{name}` is a file"))
            }
            Slot::Array(_) | Slot::Alias(_) => {
                let name = self.sources.snippet(span);
                Diagnostic::new(codes::EXPECTED_VALUE, span, format!("`{name}` is an array"))
                    .help(format!("`{name}[0]` is its first element"))
                    .into()
            }
        }
    }

    /// Tells the warnings that waited for the use of a declared thing.
    pub(super) fn first_use(&mut self, symbol: Symbol, span: Span) {
        for warning in self.scopes.pending(symbol).iter().flat_map(|p| p.iter()) {
            self.report_fault(warning.clone());
        }
        if let Some(why) = self.deprecated.remove(&symbol) {
            let message = format!("`{}` is deprecated: {}", self.names.text(symbol), why.trim());
            self.report_fault(Diagnostic::new(codes::DEPRECATED, span, message));
        }
    }

    fn constant(&mut self, symbol: Symbol, span: Span) -> Result<Value> {
        if let Some(Some(value)) = self.constants.get(symbol.0 as usize) {
            return Ok(value.clone());
        }
        if let Some(value) = self.constant_value(self.names.text(symbol)) {
            return Ok(value);
        }
        let name = self.names.text(symbol);
        let d = Diagnostic::new(codes::UNDECLARED, span, format!("`{name}` is not declared"));
        if let Some(hint) = super::hints::other_tools(name) {
            return d.help(hint).into();
        }
        let declared: Vec<&str> = self.scopes.names().map(|s| self.names.text(s)).collect();
        if let Some(include) = super::hints::include_of(name) {
            return d.help(format!("`#include \"{include}\"` declares it")).into();
        }
        let words = word::KEYWORDS.iter().chain(word::FUNCTIONS).copied().chain(word::CONSTANTS.iter().map(|c| c.0));
        // Words of the language are in small letters: a name with a capital is a slip of one only if nothing else differs.
        let capital = name.starts_with(char::is_uppercase);
        let words = words.filter(|w| !capital || w.eq_ignore_ascii_case(name));
        let near = did_you_mean(name, declared.into_iter().chain(words));
        d.help(near.unwrap_or_else(|| format!("`#declare {name} = …;` gives it a value; is an `#include` missing?")))
            .into()
    }

    pub(super) fn is_constant(&self, symbol: Symbol) -> bool {
        self.constant_value(self.names.text(symbol)).is_some()
    }

    /// Operands of one precedence from left to right.
    fn chain(&mut self, chain: &'a Chain) -> Result<Value> {
        let span = chain.first.span;
        let parts = self.chain_parts(chain)?;
        self.join(parts, span)
    }

    /// The same with the last operand's sum unfinished. A macro whose body is a bare sum is spliced as tokens would be:
    /// with `#macro F(a) a+1 #end`, `F(2)*3` is 2+1*3.
    fn chain_parts(&mut self, chain: &'a Chain) -> Result<Parts> {
        let mut span = chain.first.span;
        let (mut first, mut rest) = self.operand_parts(&chain.first)?;
        for (op, operand) in &chain.rest {
            let (head, tail) = self.operand_parts(operand)?;
            if op.multiplies() {
                let last = rest.last_mut().map_or(&mut first, |(_, last)| last);
                let left = std::mem::replace(last, Value::Float(0.0));
                *last = apply(*op, left, head, span, operand.span, self)?;
                rest.extend(tail);
            } else {
                first = self.join((first, rest), span)?;
                let (right, after) =
                    if op.adds() { (head, tail) } else { (self.join((head, tail), operand.span)?, vec![]) };
                first = apply(*op, first, right, span, operand.span, self)?;
                rest = after;
            }
            span = span.to(operand.span);
        }
        Ok((first, rest))
    }

    /// An operand's value; a sum that comes bare out of a macro stays in parts.
    fn operand_parts(&mut self, e: &'a Expr) -> Result<Parts> {
        match &e.kind {
            ExprKind::Call(name, arguments) if self.is_macro(*name) => {
                self.call_macro(*name, arguments, e.span)?;
                self.macro_result(*name, e.span)
            }
            ExprKind::Call(name, arguments) => Ok((self.call_value(*name, arguments, e.span)?, vec![])),
            ExprKind::Prefix(prefix, inner) => {
                let (first, rest) = self.operand_parts(inner)?;
                Ok((apply_prefix(*prefix, first, inner.span)?, rest))
            }
            ExprKind::Chain(chain) if chain.rest.iter().all(|(op, _)| op.multiplies()) => self.chain_parts(chain),
            _ => Ok((self.eval(e)?, vec![])),
        }
    }

    /// Finishes a sum.
    fn join(&mut self, (first, rest): Parts, span: Span) -> Result<Value> {
        rest.into_iter().try_fold(first, |sum, (op, term)| apply(op, sum, term, span, span, self))
    }

    /// Runs the macro's body, whose frame lies on top, up to its end; it must give one value.
    fn macro_result(&mut self, name: Symbol, span: Span) -> Result<Parts> {
        let (parts, more) = self.macro_body(name, |me| Ok((me.bare_value()?, !matches!(me.peek()?, Token::End))))?;
        if more {
            let name = self.names.text(name);
            let message = format!("macro `{name}` gives more than the one value that is needed here");
            return Diagnostic::err(codes::WRONG_COUNT, span, message);
        }
        Ok(parts)
    }

    /// All values that a macro gives.
    pub(super) fn macro_values(&mut self, name: Symbol, arguments: &'a [Element], span: Span) -> Result<Vec<Value>> {
        self.call_macro(name, arguments, span)?;
        self.macro_body(name, |me| {
            let mut values = vec![];
            while values.is_empty() || !matches!(me.peek()?, Token::End) {
                values.push(me.value_here()?.0);
            }
            Ok(values)
        })
    }

    /// Reads the body of the macro whose frame lies on top, whose end must stop the reading, not pass over into what
    /// follows the call.
    pub(super) fn macro_body<T>(&mut self, name: Symbol, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        let depth = self.frames.len();
        if let Some(frame) = self.frames.last_mut() {
            frame.kind = FrameKind::Call(name);
        }
        let result = read(self).map_err(|fault| Box::new(self.with_trace(*fault)));
        self.unwind(depth - 1);
        result
    }

    /// The next value; a bare sum in its parts.
    fn bare_value(&mut self) -> Result<Parts> {
        match self.peek()? {
            Token::Expr(Expr { kind: ExprKind::Chain(chain), .. }) if chain.rest.iter().all(|(op, _)| op.adds()) => {
                self.advance();
                let (first, mut rest) = self.operand_parts(&chain.first)?;
                for (op, operand) in &chain.rest {
                    let (head, tail) = self.operand_parts(operand)?;
                    rest.push((*op, head));
                    rest.extend(tail);
                }
                Ok((first, rest))
            }
            Token::Expr(e @ Expr { kind: ExprKind::Chain(_) | ExprKind::Prefix(..), .. }) => {
                self.advance();
                self.operand_parts(e)
            }
            _ => Ok((self.value_here()?.0, vec![])),
        }
    }

    /// Directives that give one value.
    fn operand(&mut self, elements: &'a [Element], span: Span) -> Result<Value> {
        self.enclosed(None, elements, span, |me| {
            let (value, _) = me.value_here()?;
            match me.peek()? {
                Token::End => Ok(value),
                _ => Err(me.unexpected_token("the end of the expression").into()),
            }
        })
    }

    /// `< … >` with anything in it that gives numbers.
    fn vector_parts(&mut self, parts: &'a [Element], span: Span) -> Result<Value> {
        // The common case, without a frame: nothing but expressions that are not macro calls.
        let mut data = [0.0; 5];
        if parts.len() <= 5 && parts.iter().all(|p| self.is_plain(p)) {
            for (slot, part) in data.iter_mut().zip(parts) {
                if let ElementKind::Expr(e) = &part.kind {
                    *slot = self.number(e)?;
                }
            }
            return vector_value(&data[..parts.len()], span);
        }
        let all = self.numbers_in(parts, span)?;
        vector_value(&all, span)
    }

    pub(super) fn is_plain(&self, part: &Element) -> bool {
        match &part.kind {
            ElementKind::Expr(e) => match &e.kind {
                ExprKind::Call(name, _) => !self.is_macro(*name),
                ExprKind::Spliced(_) => false,
                _ => true,
            },
            _ => false,
        }
    }

    /// All numbers that the elements give.
    pub(super) fn numbers_in(&mut self, parts: &'a [Element], span: Span) -> Result<Vec<f64>> {
        self.enclosed(None, parts, span, |me| {
            let mut all = vec![];
            loop {
                match me.peek()? {
                    Token::End => return Ok(all),
                    // Directives may give several numbers.
                    Token::Expr(Expr { kind: ExprKind::Spliced(inner), span }) => {
                        me.advance();
                        all.extend(me.numbers_in(inner, *span)?);
                    }
                    _ => {
                        let (value, span) = me.value_here()?;
                        all.push(as_float(&value, span)?);
                    }
                }
            }
        })
    }
}

/// Two to five numbers.
fn vector_value(data: &[f64], span: Span) -> Result<Value> {
    match data.len() {
        2..=5 => Ok(Value::Vector(VecN::from_slice(data))),
        n => Diagnostic::err(codes::WRONG_COUNT, span, format!("a vector has two to five numbers, this has {n}")),
    }
}

/// Three numbers; one stands for all, and shorter vectors are filled with zeros.
pub(super) fn as_vector(value: &Value, span: Span) -> Result<DVec3> {
    match value {
        Value::Float(x) => Ok(DVec3::splat(*x)),
        Value::Vector(v) if v.len <= 3 => Ok(v.xyz()),
        other => {
            let message = format!("expected a vector of three numbers, found {}", other.describe());
            Diagnostic::err(codes::WRONG_TYPE, span, message)
        }
    }
}

/// The number in a value.
pub(super) fn as_float(value: &Value, span: Span) -> Result<f64> {
    match value {
        Value::Float(x) => Ok(*x),
        other => {
            let d = Diagnostic::new(codes::WRONG_TYPE, span, format!("expected a number, found {}", other.describe()));
            match other {
                Value::Vector(_) => d.help("`.x`, `.y` or `.z` takes one of its numbers").into(),
                Value::Color(_) => d.help("`.red`, `.green`, `.blue` or `.gray` takes one number of it").into(),
                _ => d.into(),
            }
        }
    }
}
