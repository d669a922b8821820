//! Produces the tokens that the readers of blocks receive: runs directives and expands macro calls on the way. A
//! complete expression or block of the syntax tree is a single token, unless a following token may continue it.

mod bracket;
mod following;
mod frame;
mod name;
mod recovery;

use super::Interpreter;
use super::stream::{BlockName, FrameKind, Mode, Token};
use crate::diagnostic::Result;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::word::Category;

impl<'a> Interpreter<'a> {
    /// Runs `read` with a changed reading mode of the token stream, and restores the mode afterwards.
    #[inline]
    pub(super) fn in_mode<T>(
        &mut self,
        change: impl FnOnce(&mut Mode),
        read: impl FnOnce(&mut Interpreter<'a>) -> T,
    ) -> T {
        let outer = self.stream.mode();
        let mut inner = outer;
        change(&mut inner);
        self.stream.set_mode(inner);
        let result = read(self);
        self.stream.set_mode(outer);
        result
    }

    /// Returns the next token without consuming it, after running the directives and macro calls before it. Commas and
    /// semicolons are skipped; [`super::stream::TokenStream::has_comma`] reports the commas.
    #[inline]
    pub(super) fn peek(&mut self) -> Result<Token<'a>> {
        match self.stream.look_ahead() {
            Some(token) => Ok(*token),
            None => self.find_next_token(),
        }
    }

    fn find_next_token(&mut self) -> Result<Token<'a>> {
        loop {
            if let Some(token) = self.stream.look_ahead() {
                return Ok(*token);
            }
            // Directives are the common case in loops.
            if let Some((directive, span)) = self.stream.take_directive() {
                self.run_next_directive(directive, span)?;
                continue;
            }
            let Some(frame) = self.stream.innermost() else { return Ok(Token::End) };
            if frame.next().is_none_or(may_run_before_token) && self.run_or_drop_unless_token()? {
                continue;
            }
            let Some(frame) = self.stream.innermost() else { return Ok(Token::End) };
            let Some(element) = frame.next() else {
                let token =
                    frame.closer().map_or(Token::End, |bracket| Token::Punctuation(Punctuation::Close(bracket)));
                return Ok(self.stream.set_look_ahead(token));
            };
            let token = match &element.kind {
                ElementKind::Expr(expr) => match self.expr_token(expr, element)? {
                    Some(token) => token,
                    None => continue,
                },
                ElementKind::Numbers(list) => Token::Numbers(frame.peek_list_item(list)),
                ElementKind::Word(word) => {
                    return self.word_token(word.name, word.category == Category::Function, element);
                }
                ElementKind::Block(block) => {
                    Token::Block(BlockName { word: block.name.word, span: block.name.span, body: Some(&block.body) })
                }
                ElementKind::Entry(group) => Token::Open(Bracket::Square, Some(&group.body)),
                ElementKind::Group(group) => Token::Open(Bracket::Brace, Some(&group.body)),
                ElementKind::Function(function) => Token::Function(Some(function)),
                ElementKind::Punctuation(Punctuation::Open(bracket)) => Token::Open(*bracket, None),
                ElementKind::Punctuation(mark) => Token::Punctuation(*mark),
                ElementKind::Directive(_) | ElementKind::Semicolon | ElementKind::Comma => continue,
            };
            // An array's element whose index was read token by token has been pushed back.
            return Ok(if self.stream.has_pushed_back() { token } else { self.stream.set_look_ahead(token) });
        }
    }

    /// Runs directives and macro calls, and drops finished frames, until the next element is a token.
    fn run_to_token(&mut self) -> Result<()> {
        while self.run_or_drop_unless_token()? {}
        Ok(())
    }

    /// Runs one directive or macro call, or drops one finished frame; returns false if the next element is a token.
    pub(super) fn run_or_drop_unless_token(&mut self) -> Result<bool> {
        if self.stream.look_ahead().is_some() {
            return Ok(false);
        }
        let Some(frame) = self.stream.innermost() else { return Ok(false) };
        let Some(element) = frame.next() else {
            if frame.closer().is_some() || matches!(frame.kind(), FrameKind::File) {
                return Ok(false);
            }
            self.run_and_restore_comma(Self::end_frame_or_loop_pass)?;
            return Ok(true);
        };
        match &element.kind {
            ElementKind::Semicolon => self.stream.skip_element(),
            ElementKind::Comma => {
                self.stream.skip_element();
                self.stream.set_comma(true);
            }
            ElementKind::Directive(directive) => {
                self.stream.skip_element();
                self.run_next_directive(directive, element.span)?;
            }
            ElementKind::Expr(expr) => match &expr.kind {
                ExprKind::Name(name) if self.evaluator.is_macro(*name) => {
                    self.stream.skip_element();
                    self.run_and_restore_comma(|me| me.call_macro_by_tokens(*name, element.span))?;
                }
                _ if !self.evaluator.must_split_into_tokens(expr) => return Ok(false),
                ExprKind::Call(name, arguments) if self.evaluator.is_macro(*name) => {
                    self.stream.skip_element();
                    self.run_and_restore_comma(|me| me.call_macro(*name, arguments, element.span, element.comma))?;
                }
                _ => self.stream.split_next_element(),
            },
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Runs the directive that has just been consumed.
    #[inline]
    fn run_next_directive(&mut self, directive: &'a Directive, span: Span) -> Result<()> {
        self.reporter.count_step(span)?;
        self.run_and_restore_comma(|me| me.run_directive(directive, span))
    }

    /// Runs a directive, a macro call or a loop's condition between two tokens. A comma before it still separates these
    /// two tokens.
    #[inline]
    fn run_and_restore_comma(&mut self, run: impl FnOnce(&mut Self) -> Result<()>) -> Result<()> {
        let comma = self.stream.take_comma();
        run(self)?;
        self.stream.add_comma(comma);
        Ok(())
    }
}

/// True if the element may run a directive or macro, or end a frame, before the next token; false for elements that are
/// tokens in any case, which are most.
fn may_run_before_token(element: &Element) -> bool {
    match &element.kind {
        ElementKind::Numbers(_) | ElementKind::Word(_) | ElementKind::Block(_) | ElementKind::Punctuation(_) => false,
        ElementKind::Expr(e) => e.calls || matches!(e.kind, ExprKind::Name(_)),
        _ => true,
    }
}
