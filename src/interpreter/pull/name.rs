//! Tokens of names, words and expressions, whose kind depends on declarations and on the tokens that follow.

use crate::diagnostic::Result;
use crate::interpreter::Interpreter;
use crate::interpreter::evaluator::Contents;
use crate::interpreter::stream::{BlockName, FrameKind, Token};
use crate::syntax::ast::*;
use crate::value::Value;

impl<'a> Interpreter<'a> {
    /// Returns the token of an expression; `None` if the expression was split, so that its first part is now the next
    /// element.
    pub(super) fn expr_token(&mut self, expr: &'a Expr, element: &'a Element) -> Result<Option<Token<'a>>> {
        match &expr.kind {
            ExprKind::Name(symbol) => self.name_token(*symbol, expr, element),
            ExprKind::Index(base, indices) => match base.kind {
                ExprKind::Name(symbol) if !self.evaluator.bracket_begins_index(symbol) => {
                    self.stream.split_next_element();
                    Ok(None)
                }
                _ => {
                    let lvalue = self.element_lvalue(base, indices)?;
                    self.stream.set_array_element(lvalue);
                    Ok(Some(Token::Element(expr.span)))
                }
            },
            ExprKind::Dot(..) => match self.dictionary_lvalue(expr)? {
                Some(lvalue) => {
                    self.stream.set_array_element(lvalue);
                    Ok(Some(Token::Element(expr.span)))
                }
                None => Ok(Some(Token::Expr(expr))),
            },
            _ if self.stream.begins_with_durer_word(expr) => {
                self.stream.split_next_element();
                Ok(None)
            }
            _ => Ok(Some(Token::Expr(expr))),
        }
    }

    /// Returns the token of a name alone: a word that only durer has, an unknown block's name, an array's element, or a
    /// value.
    fn name_token(&mut self, symbol: Symbol, expr: &'a Expr, element: &'a Element) -> Result<Option<Token<'a>>> {
        if let Some(word) = self.stream.durer_only_word_of_open_block(symbol) {
            return self.word_token(word, false, element).map(Some);
        }
        let Some(frame) = self.stream.innermost() else { return Ok(None) };
        let next = frame.element_after_next().filter(|_| !element.comma);
        let is_indexed = match next.map(|e| &e.kind) {
            Some(ElementKind::Group(_) | ElementKind::Punctuation(Punctuation::Open(Bracket::Brace))) => {
                return Ok(Some(Token::Block(BlockName { word: None, span: expr.span, body: None })));
            }
            Some(ElementKind::Punctuation(Punctuation::Open(Bracket::Square))) => {
                match self.evaluator.scopes().get(symbol) {
                    Some(Contents::Array(_)) => true,
                    // The fault is that this value has no elements.
                    Some(Contents::Value(value)) => !matches!(value, Value::Thing(_)),
                    _ => false,
                }
            }
            Some(ElementKind::Entry(_)) => self.evaluator.is_array(symbol),
            Some(ElementKind::Punctuation(Punctuation::Dot)) => {
                self.evaluator.is_array(symbol) || self.evaluator.scope_level_of_prefix(symbol).is_some()
            }
            None if !element.comma => self.evaluator.is_array(symbol),
            _ => false,
        };
        match is_indexed {
            true => self.push_back_element_token(symbol, expr).map(Some),
            false => Ok(Some(Token::Expr(expr))),
        }
    }

    /// Returns the token of a word: the start of a block, the name of a called function, or the word alone. A
    /// directive, a macro or the end of a body after the word is processed first, because the kind depends on the token
    /// after that.
    pub(super) fn word_token(
        &mut self,
        word: &'static str,
        is_callable: bool,
        element: &'a Element,
    ) -> Result<Token<'a>> {
        let span = element.span;
        let Some(frame) = self.stream.innermost() else { return Ok(Token::End) };
        let alone = if word == "function" { Token::Function(None) } else { Token::Word(word) };
        let block = Token::Block(BlockName { word: Some(word), span, body: None });
        let next = frame.element_after_next().map(|e| &e.kind);
        let callee = is_callable.then_some(Token::Callee(word));
        let is_open = match next {
            _ if element.comma || word == "function" => false,
            Some(ElementKind::Group(_) | ElementKind::Punctuation(Punctuation::Open(Bracket::Brace))) => {
                return Ok(self.stream.set_look_ahead(block));
            }
            Some(ElementKind::Punctuation(Punctuation::Open(Bracket::Paren))) if let Some(callee) = callee => {
                return Ok(self.stream.set_look_ahead(callee));
            }
            Some(ElementKind::Directive(_)) => true,
            Some(ElementKind::Expr(e)) => {
                e.calls || matches!(e.kind, ExprKind::Name(name) if self.evaluator.is_macro(name))
            }
            Some(_) => false,
            None => frame.closer().is_none() && !matches!(frame.kind(), FrameKind::File),
        };
        if !is_open {
            return Ok(self.stream.set_look_ahead(alone));
        }
        self.stream.skip_element();
        let before = self.stream.take_comma();
        self.run_to_token()?;
        let (brace, paren) = match self.stream.look_ahead() {
            Some(token) => {
                (matches!(token, Token::Open(Bracket::Brace, _)), matches!(token, Token::Open(Bracket::Paren, _)))
            }
            None => match self.stream.innermost() {
                Some(frame) => (frame.is_at_brace(), frame.is_at_parenthesis()),
                None => (false, false),
            },
        };
        let token = match callee {
            _ if self.stream.has_comma() => alone,
            Some(callee) if paren => callee,
            _ if brace => block,
            _ => alone,
        };
        Ok(self.stream.push_back(token, span, before))
    }

    /// Evaluates and consumes an expression and the `;` after it, and returns its number; consumes nothing and returns
    /// `None` if the two do not come next or the fast evaluation gives no number.
    pub fn take_number_and_semicolon(&mut self) -> Option<f64> {
        let e = self.stream.expression_before_semicolon().filter(|e| !e.has_bare_condition())?;
        let x = self.evaluator.quick_number(e)?;
        self.stream.skip_expression_and_semicolon();
        Some(x)
    }
}
