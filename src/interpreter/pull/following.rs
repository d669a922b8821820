//! Tests whether the tokens after a value continue it.

use crate::diagnostic::Result;
use crate::interpreter::Interpreter;
use crate::interpreter::stream::{FrameKind, StackFrame, Token};
use crate::syntax::ast::*;
use crate::syntax::{begins_with_parenthesis, begins_with_sign};

impl<'a> Interpreter<'a> {
    /// True if the expression or list that comes next is complete, because no following token can continue it. No
    /// directive or macro runs for the test. Where comparisons are allowed (`compares`), a `>` continues a value.
    pub fn next_value_is_complete(&self, compares: bool) -> bool {
        let Some((frame, outer)) = self.stream.frames().split_last() else { return true };
        let Some(element) = frame.next().filter(|_| !self.stream.has_pushed_back()) else { return false };
        if let ElementKind::Numbers(list) = &element.kind
            && frame.list_item_index() + 1 < list.len()
        {
            return true;
        }
        if element.comma {
            return true;
        }
        match frame.element_after_next() {
            Some(next) => self.cannot_continue_value(next, compares),
            None => self.frame_end_ends_value(frame, outer, compares),
        }
    }

    /// True if no token after the end of `frame` can continue the frame's last value.
    fn frame_end_ends_value<'f>(
        &self,
        mut frame: &'f StackFrame<'a>,
        mut outer: &'f [StackFrame<'a>],
        compares: bool,
    ) -> bool {
        loop {
            if frame.is_delimited() {
                return true;
            }
            match frame.kind() {
                FrameKind::File => return true,
                FrameKind::Piece | FrameKind::Branch | FrameKind::Macro(_) | FrameKind::Include | FrameKind::Switch => {
                }
                FrameKind::While(_) | FrameKind::For { .. } => return self.stream.mode().defers_directives,
            }
            let Some((last, rest)) = outer.split_last() else { return true };
            match last.next() {
                Some(next) => return self.cannot_continue_value(next, compares),
                None => (frame, outer) = (last, rest),
            }
        }
    }

    /// True if the element `next` can't continue the value before it.
    fn cannot_continue_value(&self, next: &Element, compares: bool) -> bool {
        match &next.kind {
            ElementKind::Semicolon | ElementKind::Comma | ElementKind::Word(_) | ElementKind::Block(_) => true,
            ElementKind::Group(_) | ElementKind::Entry(_) | ElementKind::Function(_) => true,
            ElementKind::Punctuation(Punctuation::Operator(Operator::Greater)) => !compares,
            ElementKind::Punctuation(mark) => matches!(mark, Punctuation::Close(_)),
            ElementKind::Directive(_) => self.stream.mode().defers_directives,
            ElementKind::Numbers(list) => list.width(0) > 1 || !list.data[0].is_sign_negative(),
            ElementKind::Expr(e) if self.evaluator.is_macro_call(e) => self.stream.mode().defers_directives,
            ElementKind::Expr(e) => !e.calls && !begins_with_sign(e) && !begins_with_parenthesis(e),
        }
    }

    /// Returns the token directly after the value that was just read. `None` after a comma, before a `;` or the end of
    /// the file, and before a directive or macro call that must wait ([`super::Mode::defers_directives`]).
    pub fn peek_after_value(&mut self) -> Result<Option<Token<'a>>> {
        loop {
            if self.stream.look_ahead().is_some() {
                return if self.stream.has_comma() { Ok(None) } else { self.peek().map(Some) };
            }
            if self.stream.has_comma() {
                return Ok(None);
            }
            let Some(frame) = self.stream.innermost() else { return Ok(None) };
            let mode = self.stream.mode();
            match frame.next().map(|e| &e.kind) {
                Some(ElementKind::Comma | ElementKind::Semicolon) => return Ok(None),
                Some(ElementKind::Directive(_)) if mode.defers_directives => return Ok(None),
                Some(ElementKind::Expr(e)) if mode.defers_directives && self.evaluator.is_macro_call(e) => {
                    return Ok(None);
                }
                None if frame.closer().is_none() && mode.defers_directives => match frame.kind() {
                    FrameKind::Macro(_) | FrameKind::Piece | FrameKind::Branch | FrameKind::Include
                        if self.stream.frames().len() > mode.frame_floor =>
                    {
                        self.pop_frame();
                    }
                    _ => return Ok(None),
                },
                None if matches!(frame.kind(), FrameKind::File) => return Ok(None),
                _ => {
                    if !self.run_or_drop_unless_token()? {
                        return self.peek().map(Some);
                    }
                }
            }
        }
    }

    /// Returns the token that may continue the value just read; [`Token::End`] if [`Self::peek_after_value`] returns none.
    pub fn peek_continuation(&mut self) -> Result<Token<'a>> {
        Ok(self.peek_after_value()?.unwrap_or(Token::End))
    }
}
