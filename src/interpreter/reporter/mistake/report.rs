//! The list of messages: each is kept once, and not too many.

use crate::diagnostic::{Diagnostic, Severity, codes};
use crate::interpreter::Interpreter;

/// So many errors are told; the others are counted.
const MAX_ERRORS: usize = 20;
/// So many messages are kept before warnings are left out.
const MAX_WARNINGS: usize = 500;

impl Interpreter<'_> {
    pub(in crate::interpreter) fn error_count(&self) -> usize {
        self.reporter.diagnostics.iter().filter(|d| d.severity == Severity::Error).count()
    }

    /// Keeps a message, unless the same was told of the same place.
    pub(in crate::interpreter) fn report_fault(&mut self, d: Diagnostic) {
        let silent = matches!(d.code, codes::FOLLOWS | codes::ENDS_RUN);
        // (The codes of warnings begin with `W`; those of errors in what nobody uses with `E`.)
        let d = if silent || d.code.severity() == Severity::Warning { Some(d) } else { self.understood(d) };
        let Some(d) = d.filter(|_| !silent) else { return };
        // (Nobody is warned of what is told as an error.)
        let told = |k: &Diagnostic| k.message == d.message || k.severity > d.severity;
        let known = |k: &Diagnostic| k.code == d.code && k.span() == d.span() && told(k);
        if self.reporter.diagnostics.iter().rev().take(100).any(known) {
            return;
        }
        if d.severity == Severity::Error && self.error_count() >= MAX_ERRORS && !self.reporter.limit_reached {
            self.reporter.mistakes.count_untold(d.span());
            return;
        }
        if d.severity == Severity::Warning && self.reporter.diagnostics.len() >= MAX_WARNINGS {
            // A loop that warns in every pass would fill the memory.
            if let Some(last) = self.reporter.diagnostics.last_mut() {
                last.help = Some("there are more warnings, which are not told".into());
            }
            return;
        }
        self.reporter.diagnostics.push(d);
    }
}
