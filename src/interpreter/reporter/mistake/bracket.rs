//! Finds the bracket that causes an error further down in the text.

use crate::diagnostic::Diagnostic;
use crate::interpreter::reporter::Reporter;
use crate::syntax::{Outline, blame};

impl Reporter<'_> {
    /// Returns the error for a `}` that is before the fault and ends a block too early, so that a later `}` is surplus.
    pub fn error_of_early_brace(&mut self, fault: &Diagnostic) -> Option<Diagnostic> {
        let sources = self.inputs.sources;
        let (file, range) = sources.locate(fault.span())?;
        let look = || blame::early_brace_error(&Outline::read(sources, file)).map(Box::new);
        let d = self.mistakes.early.entry(file).or_insert_with(look).as_deref()?.clone();
        let (_, early) = self.inputs.sources.locate(d.span())?;
        (early.start <= range.start).then_some(d)
    }
}
