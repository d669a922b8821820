//! Recovery: after a fault, reading resumes behind the statement or bracket that holds it.

use crate::diagnostic::{Diagnostic, Fault};
use crate::interpreter::Interpreter;
use crate::interpreter::stream::Checkpoint;

impl Interpreter<'_> {
    /// Drops the frames that were pushed since the checkpoint, and restores the stream's state there.
    pub fn unwind(&mut self, checkpoint: Checkpoint) {
        while self.stream.is_above(checkpoint) {
            self.pop_frame();
        }
        self.stream.restore(checkpoint);
    }

    /// Skips the statement that began at the checkpoint.
    pub fn skip_statement(&mut self, checkpoint: Checkpoint) {
        let open = self.stream.opened_since(checkpoint);
        self.unwind(checkpoint);
        self.stream.skip_statement(checkpoint, open);
    }

    /// Skips to the end of the brackets that were opened since the checkpoint.
    pub fn skip_brackets(&mut self, checkpoint: Checkpoint) {
        let open = self.stream.opened_since(checkpoint);
        self.unwind(checkpoint);
        self.stream.skip_brackets(open);
    }

    /// Adds the call trace to a fault, and skips the statement that holds it. The statement stays if it is inside an
    /// unclosed bracket, which is then reported instead.
    pub fn skip_fault(&mut self, checkpoint: Checkpoint, fault: Diagnostic) -> Fault {
        let fault = self.stream.with_trace(fault);
        if self.stream.unclosed_bracket().is_none() {
            self.skip_statement(checkpoint);
        }
        Box::new(fault)
    }
}
