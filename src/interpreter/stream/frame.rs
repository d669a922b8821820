//! Where elements come from: bodies of branches, loops and macros, files, and what stands in brackets.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::source::Span;
use crate::syntax::ast::*;

/// Where elements come from.
pub(in crate::interpreter) struct StackFrame<'a> {
    pub(in crate::interpreter) elements: &'a [Element],
    pub(in crate::interpreter) at: usize,
    /// Index within a literal list, and of its first number.
    pub(in crate::interpreter) item: (usize, usize),
    pub(in crate::interpreter) kind: FrameKind<'a>,
    /// The whole of what is being read: block, call, directive.
    pub(in crate::interpreter) span: Span,
    /// The bracket that follows the last element.
    pub(in crate::interpreter) closer: Option<Bracket>,
    /// Does a comma follow?
    pub(in crate::interpreter) comma: bool,
}

pub(in crate::interpreter) enum FrameKind<'a> {
    /// The outermost file.
    File,
    /// Between brackets, or an expression taken apart.
    Piece,
    /// A branch or an arm.
    Branch,
    /// Like a branch, and `#break` leaves it.
    Switch,
    While(&'a Head),
    For {
        counter: Symbol,
        last: f64,
        step: f64,
    },
    Macro(Symbol),
    Include,
}

impl StackFrame<'_> {
    /// Has an expression that was taken apart come to its end?
    pub(in crate::interpreter) fn is_spent_piece(&self) -> bool {
        let whole = matches!(self.kind, FrameKind::Piece) && self.closer.is_none();
        whole && self.at >= self.elements.len()
    }

    pub(in crate::interpreter) fn opens_brace(&self, at: usize) -> bool {
        matches!(
            self.elements.get(at).map(|e| &e.kind),
            Some(ElementKind::Group(_) | ElementKind::Sign(Sign::Open(Bracket::Brace)))
        )
    }

    pub(in crate::interpreter) fn opens_paren(&self, at: usize) -> bool {
        match self.elements.get(at).map(|e| &e.kind) {
            Some(ElementKind::Sign(sign)) => *sign == Sign::Open(Bracket::Paren),
            Some(ElementKind::Expr(e)) => matches!(e.kind, ExprKind::Paren(_)),
            _ => false,
        }
    }
}

impl<'a> Interpreter<'a> {
    pub(in crate::interpreter) fn push_frame(&mut self, elements: &'a [Element], kind: FrameKind<'a>, span: Span) {
        self.stream.peeked = None;
        self.stream.frames.push(StackFrame { elements, at: 0, item: (0, 0), kind, span, closer: None, comma: false });
    }

    /// Elements that come next, then perhaps a closing bracket and a comma.
    pub(in crate::interpreter) fn push_piece(
        &mut self,
        elements: &'a [Element],
        closer: Option<Bracket>,
        span: Span,
        comma: bool,
    ) {
        self.stream.peeked = None;
        self.stream.frames.push(StackFrame {
            elements,
            at: 0,
            item: (0, 0),
            kind: FrameKind::Piece,
            span,
            closer,
            comma,
        });
    }

    /// Drops the innermost frame, and the scope that came with it.
    pub(in crate::interpreter) fn pop_frame(&mut self) {
        self.stream.peeked = None;
        let Some(frame) = self.stream.frames.pop() else { return };
        self.stream.comma |= frame.comma;
        match frame.kind {
            FrameKind::Macro(_) => {
                self.evaluator.scopes.leave();
                self.stream.depth -= 1;
            }
            FrameKind::Include => {
                self.evaluator.scopes.leave();
                self.leave_include();
            }
            _ => {}
        }
    }

    /// A frame that nobody waits for has run out: loops begin again, all others go.
    pub(in crate::interpreter) fn end_of_frame(&mut self) -> Result<()> {
        let Some(frame) = self.stream.frames.last() else { return Ok(()) };
        let span = frame.span;
        let again = match frame.kind {
            FrameKind::While(condition) => self.step(span).and_then(|()| self.condition(condition, span)),
            FrameKind::For { counter, last, step } => {
                self.step(span).and_then(|()| self.advance_counter(counter, last, step, span))
            }
            _ => Ok(false),
        };
        let again = match again {
            Ok(again) => again,
            Err(fault) => {
                // A loop whose condition fails ends here.
                let fault = self.with_trace(*fault);
                self.pop_frame();
                return Err(Box::new(fault));
            }
        };
        match self.stream.frames.last_mut() {
            Some(frame) if again => frame.at = 0,
            _ => self.pop_frame(),
        }
        Ok(())
    }

    /// `#break`: leaves the innermost loop, `#switch` or macro.
    pub(in crate::interpreter) fn break_out(&mut self, span: Span) -> Result<()> {
        let is_breakable = |f: &StackFrame| {
            matches!(f.kind, FrameKind::While(_) | FrameKind::For { .. } | FrameKind::Switch | FrameKind::Macro(_))
        };
        let is_inner = |f: &StackFrame| matches!(f.kind, FrameKind::Branch | FrameKind::Piece);
        let inner = self.stream.frames.iter().rev().take_while(|f| is_inner(f)).count();
        let target = self.stream.frames.len().checked_sub(inner + 1);
        match target {
            Some(depth) if is_breakable(&self.stream.frames[depth]) => {
                while self.stream.frames.len() > depth {
                    self.pop_frame();
                }
                Ok(())
            }
            _ => Diagnostic::new(codes::BREAK_OUTSIDE, span, "`#break` stands in no loop, no `#switch` and no macro")
                .help("it leaves the innermost `#while`, `#for`, `#switch` or `#macro`")
                .into(),
        }
    }

    /// Runs what the macros that gave a declared value still have to run, down to `floor` frames.
    pub(in crate::interpreter) fn drain(&mut self, floor: usize) -> Result<()> {
        let in_macro = |f: &StackFrame| matches!(f.kind, FrameKind::Macro(_));
        if self.stream.held.is_empty() {
            self.stream.peeked = None;
        }
        while self.stream.frames.iter().skip(floor).any(in_macro) {
            let Some(frame) = self.stream.frames.last_mut() else { break };
            match frame.elements.get(frame.at) {
                None if frame.closer.is_some() => return Ok(()),
                None => self.end_of_frame()?,
                Some(element) => match &element.kind {
                    ElementKind::Semicolon | ElementKind::Comma => frame.at += 1,
                    ElementKind::Directive(directive) => {
                        frame.at += 1;
                        self.run_directive(directive, element.span)?;
                    }
                    ElementKind::Expr(_) | ElementKind::Numbers(_) => {
                        let message = "the macro gives more than the one value that is declared here";
                        return Diagnostic::err(codes::WRONG_COUNT, element.span, message);
                    }
                    // It ends a block in which the declaration stands, or begins another one.
                    _ => return Ok(()),
                },
            }
        }
        Ok(())
    }
}
