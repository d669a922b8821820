//! Reads expressions whose tokens come one by one, from macros, branches, loops or files. Rules and precedences are
//! those of parsed expressions.

mod call;

use super::Interpreter;
use super::evaluator::{TOLERANCE, apply_prefix, as_float, component, is_callable, vector_value};
use super::stream::{BlockName, Token};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::word;
use crate::syntax::{SignRow, begins_with_sign};
use crate::value::{Reader, Value, VecN};

/// Action on operands and operators: evaluation, or compilation of functions.
pub(super) trait Operands<'a> {
    /// Result of reading one operand of an expression.
    type Value;

    /// Reads the next operand with its signs, components and indices.
    fn operand(&mut self, me: &mut Interpreter<'a>) -> Result<(Self::Value, Span)>;

    /// Applies a binary operator to two operands of an expression.
    fn combine(
        &mut self,
        me: &mut Interpreter<'a>,
        op: Operator,
        left: (Self::Value, Span),
        right: (Self::Value, Span),
    ) -> Result<Self::Value>;

    /// Reads the two branches after a `?`, with the `:` between them, and returns the result of the choice.
    fn read_choice(&mut self, me: &mut Interpreter<'a>, condition: (Self::Value, Span)) -> Result<(Self::Value, Span)>;

    /// Returns the precedence of an operator in an expression.
    fn precedence(&self, op: Operator) -> u8 {
        op.precedence()
    }
}

/// Precedence below that of all operators, at which an expression begins.
const LOOSEST: u8 = 0;

impl<'a> Interpreter<'a> {
    /// Reads operands and operators by precedence climbing. `compares` allows comparisons, `&`, `|` and `?`.
    pub(super) fn read_by_precedence<O: Operands<'a>>(
        &mut self,
        operands: &mut O,
        compares: bool,
    ) -> Result<(O::Value, Span)> {
        if self.stream.mode().nesting >= MAX_NESTED {
            let message = format!("more than {MAX_NESTED} values are read inside each other here");
            let at = self.stream.next_span();
            return self.reporter.limit_error(codes::TOO_DEEP, at, message, "does a macro give one without end?");
        }
        self.in_mode(|mode| mode.nesting += 1, |me| me.read_from_precedence(operands, compares, LOOSEST))
    }

    fn read_from_precedence<O: Operands<'a>>(
        &mut self,
        operands: &mut O,
        compares: bool,
        least: u8,
    ) -> Result<(O::Value, Span)> {
        let (mut left, mut span) = operands.operand(self)?;
        while let Some(op) = self.operator_ahead(compares)? {
            let strength = operands.precedence(op);
            if strength < least {
                break;
            }
            self.stream.advance();
            if let Token::Word(word) | Token::Block(BlockName { word: Some(word), .. }) = self.peek()?
                && !super::reader::begins_color(word)
            {
                let message = format!("expected a value, found the word `{word}`");
                let at = self.stream.next_span();
                return Diagnostic::err(codes::EXPECTED_VALUE, at, message);
            }
            let (right, right_span) = self.read_from_precedence(operands, compares, strength + 1)?;
            left = operands.combine(self, op, (left, span), (right, right_span))?;
            span = joined_span_if_near(span, right_span);
        }
        if least == LOOSEST
            && compares
            && matches!(self.peek_after_value()?, Some(Token::Punctuation(Punctuation::Question)))
        {
            self.stream.advance();
            let (value, end) = operands.read_choice(self, (left, span))?;
            return Ok((value, joined_span_if_near(span, end)));
        }
        Ok((left, span))
    }

    /// Returns the operator that continues the value that was just read.
    fn operator_ahead(&mut self, compares: bool) -> Result<Option<Operator>> {
        // quirk: operators_before_1_5
        if !compares && !self.builder.language().bare_operators {
            return Ok(None);
        }
        loop {
            return Ok(match self.peek_after_value()? {
                Some(Token::Punctuation(Punctuation::Operator(op)))
                    if compares || op.is_addition_or_subtraction() || op.is_multiplication_or_division() =>
                {
                    Some(op)
                }
                Some(Token::Expr(e)) if begins_with_sign(e) => {
                    self.stream.split_next_element();
                    continue;
                }
                Some(Token::Numbers([x])) if x.is_sign_negative() => {
                    self.stream.split_next_element();
                    continue;
                }
                _ => None,
            });
        }
    }

    /// Reads a value and returns it with its span: a number, vector, colour or string, or anything else that a name can
    /// be declared as, such as a texture. The caller checks the kind.
    pub(super) fn read_value(&mut self) -> Result<(Value, Span)> {
        self.read_expression(false)
    }

    /// Reads a value. With `compares`, as in a condition, `<` after an operand is a comparison and begins no vector.
    pub(super) fn read_expression(&mut self, compares: bool) -> Result<(Value, Span)> {
        let token = self.peek()?;
        let may_be_called = |e: &Expr| self.stream.mode().defers_directives && self.evaluator.ends_with_callable(e);
        if self.next_value_is_complete(compares) && !matches!(token, Token::Expr(e) if may_be_called(e)) {
            match token {
                Token::Expr(e) if compares || !e.has_bare_condition() => {
                    self.stream.advance();
                    return Ok((self.evaluate(e)?, e.span));
                }
                Token::Numbers(data) => {
                    let span = self.stream.next_span();
                    self.stream.advance();
                    return Ok((numbers_value(data, span)?, span));
                }
                _ => {}
            }
        }
        self.read_by_precedence(&mut Computed::default(), compares)
    }

    /// Reads the rest of a value whose first operand has been read.
    pub(super) fn continue_value(&mut self, first: Value, span: Span) -> Result<(Value, Span)> {
        self.read_by_precedence(&mut Computed(Some((first, span))), false)
    }

    /// Reads a number, vector, string, name or call without signs.
    pub(super) fn read_primary(&mut self) -> Result<(Value, Span)> {
        self.split_to_operand()?;
        let token = self.peek()?;
        let span = self.stream.next_span();
        match token {
            Token::Expr(e) => {
                self.stream.advance();
                Ok((self.evaluate(e)?, span))
            }
            Token::Numbers(data) => {
                self.stream.advance();
                Ok((numbers_value(data, span)?, span))
            }
            Token::Element(_) => {
                let contents = self.take_array_element()?;
                Ok((self.value_of_contents(contents, span)?, span))
            }
            Token::Punctuation(Punctuation::Operator(Operator::Less)) => self.read_vector(),
            Token::Open(Bracket::Paren, _) => {
                self.open_bracket()?;
                let (value, _) = self.read_expression(true)?;
                let next = self.peek()?;
                if !next.is_closer_or_end() && !matches!(next, Token::Punctuation(_)) {
                    let d = Diagnostic::new(codes::EXPECTED, span, "expected a value, found a list in parentheses");
                    return d.help("vectors are written in angle brackets: `<1, 2, 3>`").into();
                }
                let end = self.stream.next_span();
                self.close_bracket("`)`")?;
                Ok((value, joined_span_if_near(span, end)))
            }
            Token::Callee(word) => self.read_builtin_call(word, span),
            Token::Word(word) if super::reader::begins_color(word) => {
                let color = self.color()?;
                Ok((Value::Color(color), span))
            }
            // One of durer's own words may also be a declared name: `camera { eye eye }`.
            Token::Word(word) if let Some(symbol) = self.evaluator.declared_symbol_of_keyword(word) => {
                self.stream.advance();
                Ok((self.evaluate_name(symbol, span)?, span))
            }
            _ => Err(self.unexpected_token("a value").into()),
        }
    }

    /// Splits the next expression until its first operand or sign is a token by itself.
    fn split_to_operand(&mut self) -> Result<()> {
        let holds_more = |e: &Expr| matches!(e.kind, ExprKind::Chain(_) | ExprKind::Choice(_) | ExprKind::Prefix(..));
        while matches!(self.peek()?, Token::Expr(e) if holds_more(e)) {
            self.stream.split_next_element();
        }
        Ok(())
    }

    /// Reads the components (`.x`) and call arguments after a value, and applies them to the value.
    fn apply_postfixes(&mut self, (mut value, mut span): (Value, Span)) -> Result<(Value, Span)> {
        loop {
            match self.peek_after_value()? {
                Some(Token::Punctuation(Punctuation::Dot)) => {
                    self.stream.advance();
                    let name = self.read_component_name()?;
                    value = component(&value, &name, span)?;
                    span = joined_span_if_near(span, name.span);
                }
                _ if is_callable(&value) && self.call_follows()? => {
                    (value, span) = self.read_call(&value, span)?;
                }
                _ => return Ok((value, span)),
            }
        }
    }

    /// Reads the name of a component after the `.` that follows a value, as in `V.x`.
    pub(super) fn read_component_name(&mut self) -> Result<Name> {
        // A word is the name whatever follows, so that directives after it do not run yet.
        if self.stream.look_ahead().is_none()
            && let Some(Element { kind: ElementKind::Word(word), span, .. }) = self.stream.next_raw_element()
        {
            self.stream.advance();
            return Ok(Name { word: Some(word.name), span: *span });
        }
        self.split_to_operand()?;
        let token = self.peek()?;
        let span = self.stream.next_span();
        let text = self.inputs.sources.snippet(span);
        let word = word::lookup(text).map(|(word, _)| word);
        match token {
            Token::Word(_) | Token::Expr(Expr { kind: ExprKind::Name(_), .. }) => {
                self.stream.advance();
                Ok(Name { word, span })
            }
            _ => Err(self.unexpected_token("the name of a component").into()),
        }
    }

    /// Reads a vector from its `<` on.
    fn read_vector(&mut self) -> Result<(Value, Span)> {
        let (data, span) = self.read_vector_numbers()?;
        Ok((vector_value(&data, span)?, span))
    }

    /// Reads the components of a vector of any length, from its `<` on.
    pub(super) fn read_vector_numbers(&mut self) -> Result<(Vec<f64>, Span)> {
        let start = self.stream.next_span();
        self.stream.advance();
        let mut data = vec![];
        let end = self.in_mode(|mode| mode.defers_directives = false, |me| me.read_vector_to_end(start, &mut data))?;
        self.stream.advance();
        Ok((data, joined_span_if_near(start, end)))
    }

    /// Reads the components of the vector whose `<` is at `start`, up to its `>`; returns the span of the `>`.
    fn read_vector_to_end(&mut self, start: Span, data: &mut Vec<f64>) -> Result<Span> {
        loop {
            match self.peek()? {
                Token::Punctuation(Punctuation::Operator(Operator::Greater)) => return Ok(self.stream.next_span()),
                token
                    if token.is_closer_or_end()
                        || matches!(token, Token::Punctuation(_)) && !self.next_punctuation_begins_operand() =>
                {
                    return Err(self.unclosed_vector_error(start).into());
                }
                // A colour is a value, although no vector can hold one.
                Token::Word(word)
                    if !super::reader::begins_color(word)
                        && self.evaluator.declared_symbol_of_keyword(word).is_none() =>
                {
                    return Err(self.unclosed_vector_error(start).into());
                }
                Token::Block(_) => return Err(self.unclosed_vector_error(start).into()),
                _ => {
                    let (value, span) = self.read_value()?;
                    if !self.stream.has_comma() && matches!(value, Value::Vector(_)) && !data.is_empty() {
                        return Err(self.syntax_error_at(span).into());
                    }
                    data.push(as_float(&value, span)?);
                }
            }
        }
    }

    /// True if the next token is punctuation that can begin an operand: `!`, `-`, `+`, or the `<` of a vector.
    fn next_punctuation_begins_operand(&mut self) -> bool {
        matches!(
            self.peek(),
            Ok(Token::Punctuation(
                Punctuation::Not | Punctuation::Operator(Operator::Sub | Operator::Add | Operator::Less)
            ))
        )
    }
}

/// Maximum depth of values inside values: parentheses, choices, arguments.
const MAX_NESTED: usize = 3_000;

/// Returns the span from `from` to `to`; `from` alone if `to` ends before it or more than 65 535 bytes after its start,
/// which happens across files and macros.
pub(super) fn joined_span_if_near(from: Span, to: Span) -> Span {
    if to.hi >= from.lo && to.hi - from.lo < 1 << 16 { from.to(to) } else { from }
}

fn numbers_value(data: &[f64], span: Span) -> Result<Value> {
    match data {
        [x] => Ok(Value::Float(*x)),
        data if data.len() <= 5 => Ok(Value::Vector(VecN::from_slice(data))),
        _ => {
            let message = format!("a vector has two to five numbers, this has {}", data.len());
            Diagnostic::err(codes::WRONG_COUNT, span, message)
        }
    }
}

/// Reads the signs before an operand, and returns them innermost first, without signs that cancel each other.
pub(super) fn read_signs(me: &mut Interpreter) -> Result<Vec<(Prefix, Span)>> {
    let mut typed = vec![];
    loop {
        me.split_to_operand()?;
        let prefix = match me.peek()? {
            Token::Punctuation(Punctuation::Operator(Operator::Sub)) => Prefix::Minus,
            Token::Punctuation(Punctuation::Operator(Operator::Add)) => Prefix::Plus,
            Token::Punctuation(Punctuation::Not) => Prefix::Not,
            _ => break,
        };
        typed.push((prefix, me.stream.next_span()));
        me.stream.advance();
    }
    let mut row = SignRow::default();
    typed.into_iter().rev().for_each(|(prefix, span)| row.push_outer(prefix, span));
    Ok(row.0)
}

/// Operands and operators that are evaluated while they are read. The first operand may have been read already.
#[derive(Default)]
struct Computed(Option<(Value, Span)>);

impl<'a> Operands<'a> for Computed {
    type Value = Value;

    fn operand(&mut self, me: &mut Interpreter<'a>) -> Result<(Value, Span)> {
        if let Some(first) = self.0.take() {
            return me.apply_postfixes(first);
        }
        let signs = read_signs(me)?;
        let first = me.read_primary()?;
        let (mut value, mut span) = me.apply_postfixes(first)?;
        for (prefix, at) in signs {
            value = apply_prefix(prefix, value, span)?;
            span = joined_span_if_near(at, span);
        }
        Ok((value, span))
    }

    fn combine(
        &mut self,
        me: &mut Interpreter<'a>,
        op: Operator,
        left: (Value, Span),
        right: (Value, Span),
    ) -> Result<Value> {
        me.combine(op, left, right)
    }

    fn read_choice(&mut self, me: &mut Interpreter<'a>, condition: (Value, Span)) -> Result<(Value, Span)> {
        let is_true = as_float(&condition.0, condition.1)?.abs() > TOLERANCE;
        // quirk: choices_evaluate_all
        let yes = me.read_by_precedence(self, true)?;
        expect_colon(me)?;
        let no = me.read_by_precedence(self, true)?;
        Ok((if is_true { yes.0 } else { no.0 }, no.1))
    }
}

pub(super) fn expect_colon(me: &mut Interpreter) -> Result<()> {
    match me.peek()? {
        Token::Punctuation(Punctuation::Colon) => {
            me.stream.advance();
            Ok(())
        }
        _ => Err(me.unexpected_token("`:` and the other value").into()),
    }
}
