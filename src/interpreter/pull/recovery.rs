//! Recovery from an error: reading continues after the statement or bracket that contains the error.

use crate::diagnostic::{Diagnostic, Fault};
use crate::interpreter::Interpreter;
use crate::interpreter::stream::Checkpoint;

impl Interpreter<'_> {
    /// Drops the frames that were pushed since the checkpoint, and restores the checkpoint's state of the stream.
    pub fn unwind(&mut self, checkpoint: Checkpoint) {
        while self.stream.has_frames_above(checkpoint) {
            self.pop_frame();
        }
        self.stream.restore(checkpoint);
    }

    /// Skips the statement that began at the checkpoint.
    pub fn skip_statement(&mut self, checkpoint: Checkpoint) {
        let open = self.stream.brackets_opened_since(checkpoint);
        self.unwind(checkpoint);
        self.stream.skip_statement(checkpoint, open);
    }

    /// Skips to the end of the brackets that were opened since the checkpoint.
    pub fn skip_brackets(&mut self, checkpoint: Checkpoint) {
        let open = self.stream.brackets_opened_since(checkpoint);
        self.unwind(checkpoint);
        self.stream.skip_brackets(open);
    }

    /// Adds the call trace to an error, and skips the statement that contains it. Inside an unclosed bracket, nothing
    /// is skipped: the caller reports the bracket in place of the error, and ends the run.
    pub fn trace_fault_and_skip(&mut self, checkpoint: Checkpoint, fault: Diagnostic) -> Fault {
        let fault = self.stream.with_call_trace(fault);
        if self.stream.unclosed_bracket_error().is_none() {
            self.skip_statement(checkpoint);
        }
        Box::new(fault)
    }
}
