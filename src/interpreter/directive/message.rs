//! The directives `#debug`, `#warning`, `#error`, `#render` and `#statistics`.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;

impl Interpreter<'_> {
    pub fn run_message(&mut self, kind: &'static str) -> Result<()> {
        let (message, span) = self.read_text_value()?;
        match kind {
            "error" => {
                self.reporter.report(Diagnostic::new(codes::USER_ERROR, span, message));
                Diagnostic::err(codes::ENDS_RUN, span, "")
            }
            "warning" => {
                self.reporter.report(Diagnostic::new(codes::USER_WARNING, span, message.trim_end()));
                Ok(())
            }
            _ => {
                self.reporter.print(&message);
                Ok(())
            }
        }
    }
}
