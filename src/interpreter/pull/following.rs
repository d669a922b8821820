//! What stands behind a value: may it go on with it?

use crate::diagnostic::Result;
use crate::interpreter::Interpreter;
use crate::interpreter::stream::{FrameKind, StackFrame, Token};
use crate::syntax::ast::*;
use crate::syntax::{begins_with_parenthesis, begins_with_sign};

impl<'a> Interpreter<'a> {
    /// Is the expression or list that comes next a value by itself, whatever follows? Told without running anything. Where
    /// it `compares`, a `>` goes on.
    pub(in crate::interpreter) fn is_whole(&self, compares: bool) -> bool {
        let Some((frame, outer)) = self.stream.frames.split_last() else { return true };
        let Some(element) = frame.elements.get(frame.at).filter(|_| self.stream.held.is_empty()) else { return false };
        if let ElementKind::Numbers(list) = &element.kind
            && frame.item.0 + 1 < list.len()
        {
            return true;
        }
        if element.comma {
            return true;
        }
        match frame.elements.get(frame.at + 1) {
            Some(next) => self.separates(next, compares),
            None => self.end_separates(frame, outer, compares),
        }
    }

    pub(in crate::interpreter) fn end_separates<'f>(
        &self,
        mut frame: &'f StackFrame<'a>,
        mut outer: &'f [StackFrame<'a>],
        compares: bool,
    ) -> bool {
        loop {
            if frame.closer.is_some() || frame.comma {
                return true;
            }
            match frame.kind {
                FrameKind::File => return true,
                FrameKind::Piece | FrameKind::Branch | FrameKind::Macro(_) | FrameKind::Include | FrameKind::Switch => {
                }
                FrameKind::While(_) | FrameKind::For { .. } => return self.stream.closed,
            }
            let Some((last, rest)) = outer.split_last() else { return true };
            match last.elements.get(last.at) {
                Some(next) => return self.separates(next, compares),
                None => (frame, outer) = (last, rest),
            }
        }
    }

    /// Does a value before this element end there?
    pub(in crate::interpreter) fn separates(&self, next: &Element, compares: bool) -> bool {
        match &next.kind {
            ElementKind::Semicolon | ElementKind::Comma | ElementKind::Word(_) | ElementKind::Block(_) => true,
            ElementKind::Group(_) | ElementKind::Entry(_) | ElementKind::Function(_) => true,
            ElementKind::Sign(Sign::Operator(Operator::Greater)) => !compares,
            ElementKind::Sign(sign) => matches!(sign, Sign::Close(_)),
            ElementKind::Directive(_) => self.stream.closed,
            ElementKind::Numbers(list) => list.width(0) > 1 || !list.data[0].is_sign_negative(),
            ElementKind::Expr(e) if self.is_macro_call(e) => self.stream.closed,
            ElementKind::Expr(e) => !e.calls && !begins_with_sign(e) && !begins_with_parenthesis(e),
        }
    }

    pub(in crate::interpreter) fn is_macro_call(&self, e: &Expr) -> bool {
        matches!(e.kind, ExprKind::Call(name, _) | ExprKind::Name(name) if self.is_macro(name))
    }

    /// What may go on with the value that was just read: the very next token. `None` where a comma, a `;` or nothing
    /// comes next, and where a directive or a macro does that must wait for the value ([`Self::closed`]).
    pub(in crate::interpreter) fn peek_after(&mut self) -> Result<Option<Token<'a>>> {
        loop {
            if !self.stream.held.is_empty() || self.stream.peeked.is_some() {
                return if self.stream.comma { Ok(None) } else { self.peek().map(Some) };
            }
            if self.stream.comma {
                return Ok(None);
            }
            let Some(frame) = self.stream.frames.last() else { return Ok(None) };
            match frame.elements.get(frame.at).map(|e| &e.kind) {
                Some(ElementKind::Comma | ElementKind::Semicolon) => return Ok(None),
                Some(ElementKind::Directive(_)) if self.stream.closed => return Ok(None),
                Some(ElementKind::Expr(e)) if self.stream.closed && self.is_macro_call(e) => return Ok(None),
                None if frame.closer.is_none() && self.stream.closed => match frame.kind {
                    FrameKind::Macro(_) | FrameKind::Piece | FrameKind::Branch | FrameKind::Include
                        if self.stream.frames.len() > self.stream.floor =>
                    {
                        self.pop_frame();
                    }
                    _ => return Ok(None),
                },
                None if matches!(frame.kind, FrameKind::File) => return Ok(None),
                _ => {
                    if !self.settle_once()? {
                        return self.peek().map(Some);
                    }
                }
            }
        }
    }

    /// What goes on with what was just read; the end where [`Self::peek_after`] finds nothing.
    pub(in crate::interpreter) fn peek_on(&mut self) -> Result<Token<'a>> {
        Ok(self.peek_after()?.unwrap_or(Token::End))
    }
}
