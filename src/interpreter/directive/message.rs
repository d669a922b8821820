//! `#debug`, `#warning`, `#error`, `#render`, `#statistics`.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::syntax::ast::Expr;

impl<'a> Interpreter<'a> {
    pub(in crate::interpreter) fn message(&mut self, kind: &'static str, text: &'a Expr) -> Result<()> {
        let message = self.text_value(text)?;
        match kind {
            "error" => {
                self.report_fault(Diagnostic::new(codes::USER_ERROR, text.span, message));
                Diagnostic::err(codes::ENDS_RUN, text.span, "")
            }
            "warning" => {
                self.report_fault(Diagnostic::new(codes::USER_WARNING, text.span, message.trim_end()));
                Ok(())
            }
            _ => {
                (self.debug)(&message);
                Ok(())
            }
        }
    }
}
