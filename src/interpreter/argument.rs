//! Arguments of macros and of those built-in functions that take names, array elements or objects.

use super::Interpreter;
use super::evaluator::{LValue, Slot, as_float, as_vector, is_callable, not_text_error};
use super::stream::Token;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::Value;

/// Argument of a macro call or function call, with its span in the source.
pub(super) struct Argument<'a> {
    pub(super) given: ArgumentForm<'a>,
    pub(super) span: Span,
}

/// Contents of an argument in a macro or function call, by the form in which the scene wrote it.
pub(super) enum ArgumentForm<'a> {
    /// Argument that is a name alone, which need not be declared.
    Name(Symbol),
    /// An array element that is passed as an argument, by its location.
    LValue(LValue),
    /// Contents of an argument that is any other value, or whose name or array element is gone when the macro around it
    /// ends.
    Slot(Slot<'a>),
}

impl<'a> Interpreter<'a> {
    /// Returns the argument that a parsed expression represents. A name alone and an array element are not evaluated.
    pub(super) fn argument_of_expression(&mut self, e: &'a Expr) -> Result<Argument<'a>> {
        let given = match &e.kind {
            ExprKind::Name(symbol) => ArgumentForm::Name(*symbol),
            ExprKind::Index(base, indices) => ArgumentForm::LValue(self.element_lvalue(base, indices)?),
            _ => match self.dictionary_lvalue(e)? {
                Some(lvalue) => ArgumentForm::LValue(lvalue),
                None => ArgumentForm::Slot(Slot::Value(self.evaluate(e)?)),
            },
        };
        Ok(Argument { given, span: e.span })
    }

    /// Reads the next argument of a call from the token stream.
    pub(super) fn read_argument(&mut self) -> Result<Argument<'a>> {
        let token = self.peek()?;
        let span = self.stream.next_span();
        match token {
            Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) => {
                // The look-ahead may end the macro that holds the name.
                let (slot, depth) = (self.evaluator.scopes().get(*symbol).cloned(), self.stream.call_depth());
                let level =
                    self.evaluator.scopes().resolve(*symbol).map(|lvalue| self.evaluator.scopes().level_of(&lvalue));
                self.stream.advance();
                let called = matches!(&slot, Some(Slot::Value(value)) if is_callable(value)) && self.call_follows()?;
                let ends = !called && self.no_token_continues_value()?;
                let lasting = level.is_some_and(|level| level <= self.evaluator.scopes().level());
                if !ends {
                    self.report_first_use(*symbol, span);
                }
                match slot {
                    _ if ends && depth == self.stream.call_depth() => {
                        Ok(Argument { given: ArgumentForm::Name(*symbol), span })
                    }
                    Some(_) if ends && lasting => Ok(Argument { given: ArgumentForm::Name(*symbol), span }),
                    Some(slot) if ends => Ok(Argument { given: ArgumentForm::Slot(slot), span }),
                    Some(slot) => self.continue_argument(slot, span),
                    None => {
                        let value = self.evaluate_name(*symbol, span)?;
                        self.continue_argument(Slot::Value(value), span)
                    }
                }
            }
            Token::Element(_) => {
                let Some(lvalue) = self.stream.array_element().cloned() else {
                    return Err(self.unexpected_token("a value").into());
                };
                let (slot, depth) = (self.evaluator.scopes().slot_at(&lvalue).cloned(), self.stream.call_depth());
                self.stream.advance();
                let ends = self.no_token_continues_value()?;
                match slot {
                    _ if ends && depth == self.stream.call_depth() => {
                        Ok(Argument { given: ArgumentForm::LValue(lvalue), span })
                    }
                    Some(slot) if ends => Ok(Argument { given: ArgumentForm::Slot(slot), span }),
                    Some(slot) => self.continue_argument(slot, span),
                    None => self
                        .evaluator
                        .slot_at(&lvalue, span)
                        .map(|slot| Argument { given: ArgumentForm::Slot(slot), span }),
                }
            }
            Token::Block(_) | Token::Function(_) => {
                let slot = self.read_rvalue()?;
                Ok(Argument { given: ArgumentForm::Slot(slot), span })
            }
            _ => {
                let (value, span) = self.read_expression(true)?;
                Ok(Argument { given: ArgumentForm::Slot(Slot::Value(value)), span })
            }
        }
    }

    fn continue_argument(&mut self, first: Slot<'a>, span: Span) -> Result<Argument<'a>> {
        let first = self.slot_value(first, span)?;
        let (value, span) = self.continue_value(first, span)?;
        Ok(Argument { given: ArgumentForm::Slot(Slot::Value(value)), span })
    }

    /// True if no following token continues the value that was just read.
    pub(super) fn no_token_continues_value(&mut self) -> Result<bool> {
        Ok(match self.peek_after_value()? {
            None | Some(Token::Punctuation(Punctuation::Close(_)) | Token::End) => true,
            Some(Token::Punctuation(mark)) => {
                !matches!(mark, Punctuation::Dot | Punctuation::Question | Punctuation::Operator(_))
            }
            Some(Token::Open(Bracket::Paren | Bracket::Square, _)) => false,
            Some(Token::Expr(e)) => !crate::syntax::begins_with_sign(e) && !crate::syntax::begins_with_parenthesis(e),
            Some(Token::Numbers(data)) => data.len() != 1 || !data[0].is_sign_negative(),
            Some(_) => true,
        })
    }

    /// Returns the contents of an argument that is a name, an element or a value; an error if the argument has none.
    pub(super) fn argument_slot(&mut self, argument: &Argument<'a>) -> Result<Slot<'a>> {
        match &argument.given {
            ArgumentForm::Name(symbol) => match self.evaluator.scopes().get(*symbol) {
                Some(slot) => Ok(slot.clone()),
                None => self.evaluate_name(*symbol, argument.span).map(Slot::Value),
            },
            ArgumentForm::LValue(lvalue) => self.evaluator.slot_at(lvalue, argument.span),
            ArgumentForm::Slot(slot) => Ok(slot.clone()),
        }
    }

    pub(super) fn argument_value(&mut self, argument: &Argument<'a>) -> Result<Value> {
        match &argument.given {
            ArgumentForm::Name(symbol) => self.evaluate_name(*symbol, argument.span),
            ArgumentForm::Slot(Slot::Value(value)) => Ok(value.clone()),
            _ => {
                let slot = self.argument_slot(argument)?;
                self.slot_value(slot, argument.span)
            }
        }
    }

    pub(super) fn argument_number(&mut self, argument: &Argument<'a>) -> Result<f64> {
        let value = self.argument_value(argument)?;
        as_float(&value, argument.span)
    }

    pub(super) fn argument_vector(&mut self, argument: &Argument<'a>) -> Result<DVec3> {
        let value = self.argument_value(argument)?;
        as_vector(&value, argument.span)
    }

    pub(super) fn argument_text(&mut self, argument: &Argument<'a>) -> Result<String> {
        match self.argument_value(argument)? {
            Value::Text(text) => Ok(text.to_string()),
            other => not_text_error(&other, argument.span),
        }
    }

    /// True if the argument is a name or an array element that has a value; false for any other value.
    pub(super) fn is_argument_defined(&self, argument: &Argument<'a>) -> bool {
        match &argument.given {
            ArgumentForm::Name(symbol) => self.evaluator.is_declared(*symbol),
            ArgumentForm::LValue(lvalue) => self.evaluator.scopes().slot_at(lvalue).is_some(),
            ArgumentForm::Slot(_) => false,
        }
    }
}
