//! Ends of call frames: starts the next pass of a loop, ends a scope, or completes macros that returned a value.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::stream::{FrameKind, StackFrame};
use crate::source::Span;
use crate::syntax::ast::*;

impl Interpreter<'_> {
    /// Drops the innermost call frame, and ends the scope that belongs to it.
    pub fn pop_frame(&mut self) {
        if self.stream.pop_frame().is_some_and(FrameKind::has_scope) {
            self.evaluator.scopes_mut().leave_scope();
        }
    }

    /// Ends the innermost frame after its last element: a loop begins its next pass, any other frame is dropped.
    pub(super) fn end_frame_or_loop_pass(&mut self) -> Result<()> {
        let Some(frame) = self.stream.innermost() else { return Ok(()) };
        let span = frame.span();
        let again = match frame.kind() {
            FrameKind::While(condition) => {
                self.reporter.count_step(span).and_then(|()| self.evaluate_condition(condition, span))
            }
            FrameKind::For { counter, last, step } => self
                .reporter
                .count_step(span)
                .and_then(|()| self.evaluator.step_counter_and_continues(counter, last, step, span)),
            _ => Ok(false),
        };
        let again = match again {
            Ok(again) => again,
            Err(fault) => {
                // A loop whose condition fails ends.
                let fault = self.stream.with_call_trace(*fault);
                self.pop_frame();
                return Err(Box::new(fault));
            }
        };
        if again {
            self.stream.restart_frame();
        } else {
            self.pop_frame();
        }
        Ok(())
    }

    /// Runs `#break`: leaves the innermost loop, `#switch` or macro.
    pub fn run_break(&mut self, span: Span) -> Result<()> {
        let is_breakable = |f: &StackFrame| {
            matches!(f.kind(), FrameKind::While(_) | FrameKind::For { .. } | FrameKind::Switch | FrameKind::Macro(_))
        };
        let is_inner = |f: &&StackFrame| matches!(f.kind(), FrameKind::Branch | FrameKind::Piece);
        let frames = self.stream.frames();
        let inner = frames.iter().rev().take_while(is_inner).count();
        let target = frames.len().checked_sub(inner + 1);
        match target {
            Some(depth) if is_breakable(&frames[depth]) => {
                while self.stream.frames().len() > depth {
                    self.pop_frame();
                }
                Ok(())
            }
            _ => Diagnostic::new(codes::BREAK_OUTSIDE, span, "`#break` is not inside a loop, a `#switch` or a macro")
                .help("it leaves the innermost `#while`, `#for`, `#switch` or `#macro`")
                .into(),
        }
    }

    /// Runs the rest of the macros above the first `frame_count` frames, after they returned the value of a declaration.
    ///
    /// # Errors
    /// If a macro gives a second value.
    pub fn run_rest_of_macros(&mut self, frame_count: usize) -> Result<()> {
        let in_macro = |f: &StackFrame| matches!(f.kind(), FrameKind::Macro(_));
        self.stream.drop_unpushed_look_ahead();
        while self.stream.frames().iter().skip(frame_count).any(in_macro) {
            let Some(frame) = self.stream.innermost() else { break };
            match frame.next() {
                None if frame.closer().is_some() => return Ok(()),
                None => self.end_frame_or_loop_pass()?,
                Some(element) => match &element.kind {
                    ElementKind::Semicolon | ElementKind::Comma => self.stream.skip_element(),
                    ElementKind::Directive(directive) => {
                        self.stream.skip_element();
                        self.run_directive(directive, element.span)?;
                    }
                    ElementKind::Expr(_) | ElementKind::Numbers(_) => {
                        let message = "the macro gives more than the one value that is declared here";
                        return Diagnostic::err(codes::WRONG_COUNT, element.span, message);
                    }
                    // It ends a block around the declaration, or begins another block.
                    _ => return Ok(()),
                },
            }
        }
        Ok(())
    }

    /// Drops the innermost frames of macros, branches and split expressions whose elements are all consumed.
    pub fn pop_spent_frames(&mut self) {
        let is_spent = |f: &StackFrame| {
            matches!(f.kind(), FrameKind::Macro(_) | FrameKind::Piece | FrameKind::Branch) && f.is_spent()
        };
        while !self.stream.has_pushed_back() && self.stream.innermost().is_some_and(is_spent) {
            self.pop_frame();
        }
    }
}
