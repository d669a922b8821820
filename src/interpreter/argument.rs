//! Arguments of macros and of those built-in functions that take names, array elements or objects.

use super::Interpreter;
use super::evaluator::{Contents, LValue, as_float, as_vector, is_callable, not_text_error};
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
    Contents(Contents<'a>),
}

impl<'a> Interpreter<'a> {
    /// Returns the argument that a parsed expression represents. A name alone and an array element are not evaluated.
    pub(super) fn argument_of_expression(&mut self, e: &'a Expr) -> Result<Argument<'a>> {
        let given = match &e.kind {
            ExprKind::Name(symbol) => ArgumentForm::Name(*symbol),
            ExprKind::Index(base, indices) => ArgumentForm::LValue(self.element_lvalue(base, indices)?),
            _ => match self.dictionary_lvalue(e)? {
                Some(lvalue) => ArgumentForm::LValue(lvalue),
                None => ArgumentForm::Contents(Contents::Value(self.evaluate(e)?)),
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
                let (contents, depth) = (self.evaluator.scopes().get(*symbol).cloned(), self.stream.call_depth());
                let level =
                    self.evaluator.scopes().resolve(*symbol).map(|lvalue| self.evaluator.scopes().level_of(&lvalue));
                self.stream.advance();
                let called =
                    matches!(&contents, Some(Contents::Value(value)) if is_callable(value)) && self.call_follows()?;
                let ends = !called && self.no_token_continues_value()?;
                let lasting = level.is_some_and(|level| level <= self.evaluator.scopes().level());
                if !ends {
                    self.report_first_use(*symbol, span);
                }
                match contents {
                    _ if ends && depth == self.stream.call_depth() => {
                        Ok(Argument { given: ArgumentForm::Name(*symbol), span })
                    }
                    Some(_) if ends && lasting => Ok(Argument { given: ArgumentForm::Name(*symbol), span }),
                    Some(contents) if ends => Ok(Argument { given: ArgumentForm::Contents(contents), span }),
                    Some(contents) => self.continue_argument(contents, span),
                    None => {
                        let value = self.evaluate_name(*symbol, span)?;
                        self.continue_argument(Contents::Value(value), span)
                    }
                }
            }
            Token::Element(_) => {
                let Some(lvalue) = self.stream.array_element().cloned() else {
                    return Err(self.unexpected_token("a value").into());
                };
                let (contents, depth) =
                    (self.evaluator.scopes().contents_at(&lvalue).cloned(), self.stream.call_depth());
                self.stream.advance();
                let ends = self.no_token_continues_value()?;
                match contents {
                    _ if ends && depth == self.stream.call_depth() => {
                        Ok(Argument { given: ArgumentForm::LValue(lvalue), span })
                    }
                    Some(contents) if ends => Ok(Argument { given: ArgumentForm::Contents(contents), span }),
                    Some(contents) => self.continue_argument(contents, span),
                    None => self
                        .evaluator
                        .contents_at(&lvalue, span)
                        .map(|contents| Argument { given: ArgumentForm::Contents(contents), span }),
                }
            }
            Token::Block(_) | Token::Function(_) => {
                let contents = self.read_rvalue()?;
                Ok(Argument { given: ArgumentForm::Contents(contents), span })
            }
            _ => {
                let (value, span) = self.read_expression(true)?;
                Ok(Argument { given: ArgumentForm::Contents(Contents::Value(value)), span })
            }
        }
    }

    fn continue_argument(&mut self, first: Contents<'a>, span: Span) -> Result<Argument<'a>> {
        let first = self.value_of_contents(first, span)?;
        let (value, span) = self.continue_value(first, span)?;
        Ok(Argument { given: ArgumentForm::Contents(Contents::Value(value)), span })
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

    /// Returns a copy of an argument's contents: those of the name or array element, or the value; an error if the name
    /// or element has none.
    pub(super) fn argument_contents(&mut self, argument: &Argument<'a>) -> Result<Contents<'a>> {
        match &argument.given {
            ArgumentForm::Name(symbol) => match self.evaluator.scopes().get(*symbol) {
                Some(contents) => Ok(contents.clone()),
                None => self.evaluate_name(*symbol, argument.span).map(Contents::Value),
            },
            ArgumentForm::LValue(lvalue) => self.evaluator.contents_at(lvalue, argument.span),
            ArgumentForm::Contents(contents) => Ok(contents.clone()),
        }
    }

    pub(super) fn argument_value(&mut self, argument: &Argument<'a>) -> Result<Value> {
        match &argument.given {
            ArgumentForm::Name(symbol) => self.evaluate_name(*symbol, argument.span),
            ArgumentForm::Contents(Contents::Value(value)) => Ok(value.clone()),
            _ => {
                let contents = self.argument_contents(argument)?;
                self.value_of_contents(contents, argument.span)
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
            ArgumentForm::LValue(lvalue) => self.evaluator.scopes().contents_at(lvalue).is_some(),
            ArgumentForm::Contents(_) => false,
        }
    }
}
