//! Which bracket is to blame, where a text does not close what it opens.

use crate::diagnostic::Diagnostic;
use crate::interpreter::Interpreter;
use crate::source::Span;
use crate::syntax::blame;

impl Interpreter<'_> {
    /// The brace that was left open, by what its block can hold and how the lines are indented; `place` is that of one that is
    /// open where its file ends.
    pub(in crate::interpreter) fn blamed_brace(&self, place: Span) -> Option<Diagnostic> {
        let (file, _) = self.inputs.sources.locate(place)?;
        blame::open_brace(self.inputs.sources.text(file), self.inputs.sources.base(file))
    }

    /// A `}` before the fault that ends a block too early, where another further down closes nothing.
    pub(in crate::interpreter) fn closed_early(&mut self, fault: &Diagnostic) -> Option<Diagnostic> {
        let sources = self.inputs.sources;
        let (file, range) = sources.locate(fault.span())?;
        let look = || blame::early_brace(sources.text(file), sources.base(file)).map(Box::new);
        let d = self.reporter.mistakes.early.entry(file).or_insert_with(look).as_deref()?.clone();
        let (_, early) = self.inputs.sources.locate(d.span())?;
        (early.start <= range.start).then_some(d)
    }
}
