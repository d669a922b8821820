//! The directives `#if`, `#ifdef`, `#while`, `#for` and `#switch`.

use crate::diagnostic::{Diagnostic, Fault, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::argument::ArgumentForm;
use crate::interpreter::evaluator::Contents;
use crate::interpreter::evaluator::TOLERANCE;
use crate::interpreter::evaluator::{as_float, is_in_loop};
use crate::interpreter::stream::FrameKind;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::Value;

impl<'a> Interpreter<'a> {
    pub fn evaluate_condition(&mut self, condition: &'a Head, span: Span) -> Result<bool> {
        Ok(self.evaluate_head(condition, span)?.abs() > TOLERANCE)
    }

    /// Evaluates the number in the parentheses after a directive's word.
    fn evaluate_head(&mut self, head: &'a Head, span: Span) -> Result<f64> {
        match head {
            Head::Whole(e) if !self.evaluator.must_split_into_tokens(e) => self.evaluate_number(e),
            Head::Whole(e) => {
                let elements = self.inputs.as_single_element(e);
                self.read_parenthesized_number(elements, e.span)
            }
            Head::Pieces(Some(elements)) => self.read_parenthesized_number(elements, span),
            Head::Pieces(None) => Err(self.syntax_error_at(span).into()),
        }
    }

    fn read_parenthesized_number(&mut self, elements: &'a [Element], span: Span) -> Result<f64> {
        let number = self.read_contents(elements, Bracket::Paren, span, |me| {
            let (value, at) = me.read_expression(true)?;
            as_float(&value, at)
        });
        number.map_err(|fault| match doubled_operator_second_sign(elements) {
            Some(at) => Box::new(self.syntax_error_at(at)),
            None => fault,
        })
    }

    pub fn run_if(&mut self, branches: &'a [Branch], span: Span) -> Result<()> {
        for (i, branch) in branches.iter().enumerate() {
            if let Condition::True(Head::Pieces(None)) = &branch.condition {
                let checkpoint = self.stream.checkpoint();
                if self.read_macro_closed_condition(&branch.body, branch.span)?.abs() > TOLERANCE {
                    break;
                }
                self.unwind(checkpoint);
                continue;
            }
            let taken = match &branch.condition {
                Condition::True(head) => self.evaluate_condition(head, branch.span)?,
                Condition::Declared(head) => self.head_is_declared(head, branch.span)?,
                Condition::NotDeclared(head) => !self.head_is_declared(head, branch.span)?,
                Condition::Always => true,
            };
            self.reporter.record_branch(&branch.body, taken);
            if taken {
                branches[i + 1..].iter().for_each(|other| self.reporter.record_branch(&other.body, false));
                if let (Condition::Always, Some(next)) = (&branch.condition, branches.get(i + 1)) {
                    return Err(branch_after_else_error(next.span, self.inputs.sources.snippet(next.span)));
                }
                self.stream.push_frame(&branch.body, FrameKind::Branch, span);
                break;
            }
        }
        Ok(())
    }

    /// Reads a condition whose `)` comes from a macro. The parser then leaves the `(` as the body's first element; the
    /// stream continues with the rest of the body.
    fn read_macro_closed_condition(&mut self, body: &'a [Element], span: Span) -> Result<f64> {
        if !matches!(body.first().map(|e| &e.kind), Some(ElementKind::Punctuation(Punctuation::Open(Bracket::Paren)))) {
            return Err(self.syntax_error_at(span).into());
        }
        let checkpoint = self.stream.checkpoint();
        self.stream.push_frame(body, FrameKind::Branch, span);
        let read = self.open_bracket().and_then(|_| {
            let (value, at) = self.read_expression(true)?;
            let number = as_float(&value, at)?;
            self.close_bracket("`)`").map(|()| number)
        });
        read.map_err(|fault| {
            let fault = self.stream.with_call_trace(*fault);
            self.unwind(checkpoint);
            Box::new(fault)
        })
    }

    fn head_is_declared(&mut self, head: &'a Head, span: Span) -> Result<bool> {
        match head {
            Head::Whole(e) => self.is_declared(e),
            Head::Pieces(Some(elements)) => self.read_contents(elements, Bracket::Paren, span, |me| {
                // The name may be a macro's, which is not called here.
                match me.stream.take_name_before_closer() {
                    Some((symbol, _)) => Ok(me.evaluator.is_declared(symbol)),
                    None => {
                        let argument = match me.read_argument() {
                            Err(fault) if fault.code == codes::UNDECLARED => {
                                return me.skip_to_closing_bracket().map(|()| false);
                            }
                            argument => argument?,
                        };
                        match argument.given {
                            ArgumentForm::Contents(_) => {
                                Diagnostic::err(codes::WRONG_TYPE, argument.span, "`#ifdef` takes a name")
                            }
                            _ => Ok(me.is_argument_defined(&argument)),
                        }
                    }
                }
            }),
            Head::Pieces(None) => Err(self.syntax_error_at(span).into()),
        }
    }

    /// Skips the rest of the tokens inside a bracket.
    fn skip_to_closing_bracket(&mut self) -> Result<()> {
        while !self.peek()?.is_closer_or_end() {
            self.stream.advance();
        }
        Ok(())
    }

    pub(super) fn is_declared(&mut self, e: &'a Expr) -> Result<bool> {
        match &e.kind {
            // Built-in constants are not declared.
            ExprKind::Name(symbol) => Ok(self.evaluator.is_declared(*symbol)),
            ExprKind::Index(array, indices) => {
                if !self.is_declared(array)? {
                    return Ok(false);
                }
                if let Some(lvalue) = self.dictionary_lvalue(array)? {
                    return self.has_keys(lvalue, indices);
                }
                let lvalue = self.element_lvalue(array, indices)?;
                Ok(self.evaluator.scopes().contents_at(&lvalue).is_some())
            }
            ExprKind::Dot(base, _, symbol) => {
                if let Some(lvalue) = self.evaluator.prefixed_lvalue(e) {
                    return Ok(self.evaluator.scopes().contents_at(&lvalue).is_some());
                }
                let lvalue = self.dictionary_lvalue(base)?;
                let key = self.inputs.names.text(*symbol);
                Ok(
                    matches!(lvalue.and_then(|p| self.evaluator.scopes().contents_at(&p)), Some(Contents::Array(array)) if array.has_value_at(key)),
                )
            }
            ExprKind::Paren(inner) => self.is_declared(inner),
            _ => Diagnostic::err(codes::WRONG_TYPE, e.span, "`#ifdef` takes a name"),
        }
    }

    pub fn run_while(&mut self, condition: &'a Head, body: &'a [Element], span: Span) -> Result<()> {
        if self.evaluate_condition(condition, span)? {
            self.stream.push_frame(body, FrameKind::While(condition), span);
        }
        Ok(())
    }

    pub fn run_for(&mut self, f: &'a For, span: Span) -> Result<()> {
        let (counter, [first, last, step], at) = match &f.head {
            ForHead::Whole(counter, range) => {
                let [first, last, rest @ ..] = &**range else { return Err(self.syntax_error_at(span).into()) };
                let (first, last) = (self.evaluate_number(first)?, self.evaluate_number(last)?);
                let (step, at) = match rest {
                    [step, ..] => (self.evaluate_number(step)?, step.span),
                    [] => (1.0, span),
                };
                (*counter, [first, last, step], at)
            }
            ForHead::Pieces(Some(elements)) => {
                self.read_contents(elements, Bracket::Paren, span, |me| me.read_counter_range_span(span))?
            }
            ForHead::Pieces(None) => return Err(self.syntax_error_at(span).into()),
        };
        if step.is_nan() || step.abs() < TOLERANCE {
            return Diagnostic::err(codes::ZERO_STEP, at, format!("a step of {step} would never reach the last value"));
        }
        self.evaluator.scopes_mut().set_local(counter, Contents::Value(Value::Float(first)), vec![]);
        if is_in_loop(first, last, step) {
            self.stream.push_frame(&f.body, FrameKind::For { counter, last, step }, span);
        }
        Ok(())
    }

    /// Reads the contents `I, 0, 10, 2` of the parentheses after `#for`, with optional commas. Returns the counter, the
    /// first value, last value and step, and the span of the last number.
    fn read_counter_range_span(&mut self, span: Span) -> Result<(Symbol, [f64; 3], Span)> {
        // Without the comma after the name, `J -1, 1` and `J (0), 1` parse as expressions.
        if matches!(self.stream.next_raw_element().map(|e| &e.kind), Some(ElementKind::Expr(e)) if !matches!(e.kind, ExprKind::Name(_)))
        {
            self.stream.split_next_element();
        }
        let Some((counter, _)) = self.stream.take_name() else { return Err(self.unexpected_token("a name").into()) };
        let (mut numbers, mut at) = ([0.0, 0.0, 1.0], span);
        let mut count = 0;
        while count < 3 && !self.peek()?.is_closer_or_end() {
            let (value, lvalue) = self.read_value()?;
            numbers[count] = as_float(&value, lvalue)?;
            (count, at) = (count + 1, lvalue);
        }
        if count < 2 {
            return Diagnostic::err(codes::WRONG_COUNT, span, "`#for` takes a name, a first and a last value");
        }
        Ok((counter, numbers, at))
    }

    /// Runs the first arm of a `#switch` that matches, and the arms after it up to a `#break`.
    pub fn run_switch(&mut self, value: &'a Head, arms: &'a [Arm], span: Span) -> Result<()> {
        let value = self.evaluate_head(value, span)?;
        for (i, arm) in arms.iter().enumerate() {
            let checkpoint = self.stream.checkpoint();
            let fits = match &arm.when {
                When::Case(Head::Pieces(None)) => {
                    (self.read_macro_closed_condition(&arm.body, arm.span)? - value).abs() < TOLERANCE
                }
                When::Case(head) => (self.evaluate_head(head, arm.span)? - value).abs() < TOLERANCE,
                When::Range(Some(elements)) => {
                    let [low, high] =
                        self.read_contents(elements, Bracket::Paren, arm.span, |me| me.read_two_numbers())?;
                    value >= low - TOLERANCE && value <= high + TOLERANCE
                }
                When::Range(None) => return Err(self.syntax_error_at(arm.span).into()),
                When::Otherwise => true,
            };
            // The part of an arm's body that follows a head read from the body.
            let begun = self.stream.split_off_frames(checkpoint.frame_count());
            if let (true, When::Otherwise, Some(next)) = (fits, &arm.when, arms.get(i + 1)) {
                return Err(branch_after_else_error(next.span, self.inputs.sources.snippet(next.span)));
            }
            // The `#break` of an arm is found only when the arm runs: the arms after it count as run.
            self.reporter.record_branch(&arm.body, fits);
            arms[i + 1..].iter().filter(|_| fits).for_each(|other| self.reporter.record_branch(&other.body, true));
            if fits {
                // Later arms are below on the stack, so that reading falls through to them and to `#else`.
                self.stream.push_frame(&[], FrameKind::Switch, span);
                for arm in arms[i + usize::from(!begun.is_empty())..].iter().rev() {
                    self.stream.push_frame(&arm.body, FrameKind::Branch, span);
                }
                self.stream.push_frames(begun);
                break;
            }
        }
        Ok(())
    }

    fn read_two_numbers(&mut self) -> Result<[f64; 2]> {
        let (low, at) = self.read_expression(true)?;
        let (high, end) = self.read_expression(true)?;
        Ok([as_float(&low, at)?, as_float(&high, end)?])
    }
}

/// Returns the span of the second sign of `==`, `&&` or `||`, a habit from other languages.
fn doubled_operator_second_sign(elements: &[Element]) -> Option<Span> {
    let sign = |e: &Element| match e.kind {
        ElementKind::Punctuation(Punctuation::Operator(op)) => Some(op),
        _ => None,
    };
    let doubled = |pair: &&[Element]| {
        sign(&pair[0]).is_some_and(|op| sign(&pair[1]) == Some(op) && !op.is_addition_or_subtraction())
    };
    elements.windows(2).find(doubled).map(|pair| pair[1].span)
}

/// Returns the error for `#elseif`, `#case` or the like after an `#else`.
fn branch_after_else_error(span: Span, text: &str) -> Fault {
    let word = text.split(|c: char| !c.is_ascii_alphabetic() && c != '#').next().unwrap_or("#else");
    let at = Span { hi: span.lo + word.len() as u32, ..span };
    let d = Diagnostic::new(codes::UNMATCHED_CLOSER, at, format!("`{word}` continues nothing"));
    Box::new(d.help("it follows an `#else`, which is the last part"))
}
