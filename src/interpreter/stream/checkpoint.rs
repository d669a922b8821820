//! After a fault: to the end of the statement, so that one mistake gives one message.

use super::{Opened, StackFrame};
use crate::diagnostic::{Diagnostic, Fault};
use crate::interpreter::Interpreter;
use crate::syntax::ast::*;

/// Where the reading was, to go back there after a fault.
#[derive(Clone, Copy)]
pub(in crate::interpreter) struct Mark {
    pub(in crate::interpreter) frames: usize,
    pub(in crate::interpreter) opened: usize,
    pub(in crate::interpreter) at: usize,
    pub(in crate::interpreter) closed: bool,
}

/// Brackets that were open when a fault was met.
#[derive(Clone, Copy)]
pub(in crate::interpreter) struct Unclosed {
    count: usize,
    /// If there are braces, they alone count.
    braces: bool,
}

impl StackFrame<'_> {
    /// After a fault: on to the end of the statement that began at index `from`, of which so many brackets are open.
    pub(in crate::interpreter) fn skip_statement(&mut self, from: usize, open: Unclosed) {
        self.item = (0, 0);
        self.closer = None;
        if open.count > 0 {
            return self.skip_brackets(open);
        }
        if self.at == from {
            self.skip_one();
        }
        // A block or a function ends a statement.
        // (A loop's next pass stands at its start.)
        let last = self.at.checked_sub(1).and_then(|last| self.elements.get(last)).map(|e| &e.kind);
        let ends = matches!(
            last,
            Some(
                ElementKind::Block(_)
                    | ElementKind::Function(_)
                    | ElementKind::Group(_)
                    | ElementKind::Sign(Sign::Close(Bracket::Brace))
            )
        );
        if ends {
            return;
        }
        while let Some(element) = self.elements.get(self.at) {
            match element.kind {
                ElementKind::Block(_) | ElementKind::Directive(_) => return,
                ElementKind::Word(_) if self.opens_brace(self.at + 1) => return,
                ElementKind::Semicolon => {
                    self.at += 1;
                    return;
                }
                _ => self.skip_one(),
            }
        }
    }

    /// Over one element, or over a bracket with all that is in it.
    pub(in crate::interpreter) fn skip_one(&mut self) {
        let opens = matches!(self.elements.get(self.at).map(|e| &e.kind), Some(ElementKind::Sign(Sign::Open(_))));
        self.at += 1;
        if opens {
            self.skip_brackets(Unclosed { count: 1, braces: false });
        }
    }

    pub(in crate::interpreter) fn skip_brackets(&mut self, Unclosed { mut count, braces }: Unclosed) {
        while let Some(element) = self.elements.get(self.at) {
            self.at += 1;
            match element.kind {
                ElementKind::Sign(Sign::Open(bracket)) if !braces || bracket == Bracket::Brace => count += 1,
                ElementKind::Sign(Sign::Close(bracket)) if !braces || bracket == Bracket::Brace => count -= 1,
                _ => {}
            }
            if count == 0 {
                return;
            }
        }
    }

    /// After a declared texture that failed: over its other layers.
    pub(in crate::interpreter) fn skip_layers(&mut self, from: usize) {
        let is_texture = |frame: &Self, at: usize| match frame.elements.get(at).map(|e| &e.kind) {
            Some(ElementKind::Block(b)) => b.name.word == Some("texture"),
            Some(ElementKind::Word(word)) => word.name == "texture" && frame.opens_brace(at + 1),
            _ => false,
        };
        if is_texture(self, from) {
            while is_texture(self, self.at) {
                let alone = matches!(self.elements[self.at].kind, ElementKind::Word(_));
                self.at += usize::from(alone);
                self.skip_one();
            }
        }
    }
}

impl<'a> Interpreter<'a> {
    pub(in crate::interpreter) fn mark(&self) -> Mark {
        let at = self.stream.frames.last().map_or(0, |f| f.at);
        Mark { frames: self.stream.frames.len(), opened: self.stream.opened.len(), at, closed: self.stream.closed }
    }

    /// After an error: back to the frames that were there when the statement began.
    pub(in crate::interpreter) fn unwind(&mut self, mark: Mark) {
        while self.stream.frames.len() > mark.frames {
            self.pop_frame();
        }
        self.forget_ahead(mark);
        self.stream.closed = mark.closed;
    }

    /// After an error in a directive: what was seen behind it is looked at anew.
    pub(in crate::interpreter) fn forget_ahead(&mut self, mark: Mark) {
        self.stream.opened.truncate(mark.opened);
        self.stream.held.clear();
        (self.stream.peeked, self.stream.comma, self.stream.skipping) = (None, false, false);
    }

    /// After an error: past the statement that began at the mark.
    pub(in crate::interpreter) fn skip_statement(&mut self, mark: Mark) {
        let open = self.opened_alone(mark);
        self.unwind(mark);
        if let Some(frame) = self.stream.frames.last_mut() {
            frame.skip_statement(mark.at, open);
        }
    }

    /// Leaves the statement in which a fault was met, unless a bracket that nothing closes tells more of it.
    pub(in crate::interpreter) fn past_fault(&mut self, mark: Mark, fault: Diagnostic) -> Fault {
        let fault = self.with_trace(fault);
        if self.unclosed_bracket().is_none() {
            self.skip_statement(mark);
        }
        Box::new(fault)
    }

    /// What was opened since the mark, as tokens of the frame that was the innermost.
    fn opened_alone(&self, mark: Mark) -> Unclosed {
        let own = |o: &&Opened| o.alone.is_some() && o.frames == mark.frames;
        let all = self.stream.opened.iter().skip(mark.opened).filter(own);
        let braces = all.clone().filter(|o| o.bracket == Bracket::Brace).count();
        Unclosed { count: if braces > 0 { braces } else { all.count() }, braces: braces > 0 }
    }

    /// After an error: past the brackets that were opened since the mark.
    pub(in crate::interpreter) fn skip_brackets(&mut self, mark: Mark) {
        let open = self.opened_alone(mark);
        self.unwind(mark);
        if let Some(frame) = self.stream.frames.last_mut().filter(|_| open.count > 0) {
            frame.skip_brackets(open);
        }
    }
}
