//! Diagnostics of a run: collects them, finds the causes of errors, and checks limits.

pub(super) mod hints;
mod limits;
mod mistake;

use super::Inputs;
use crate::diagnostic::{Diagnostic, Severity, codes};
use crate::source::Span;
use crate::syntax::ast::Element;
use limits::Usage;
pub use limits::cancellation_error;
pub(super) use limits::{MAX_CALLS, MAX_INCLUDES};
use mistake::Mistakes;
use std::collections::BTreeMap;

/// Maximum number of errors that are reported; further ones are counted.
const MAX_ERRORS: usize = 20;
/// Maximum number of diagnostics; beyond it, warnings are dropped.
const MAX_WARNINGS: usize = 500;
/// Number of errors that end a run, even if all are the same.
const MAX_FAULTS: usize = 200;

/// Diagnostics and limits of a run.
pub(super) struct Reporter<'a> {
    inputs: Inputs<'a>,
    /// Function that receives the output of `#debug`, `#render` and `#statistics`.
    output: &'a mut dyn FnMut(&str),
    diagnostics: Vec<Diagnostic>,
    /// Errors and warnings of the parser, which are reported after those of the run.
    deferred: Vec<Diagnostic>,
    /// Number of errors, including repeated ones.
    fault_count: usize,
    mistakes: Mistakes,
    usage: Usage,
    limit_reached: bool,
    /// For each branch of `#if`, `#ifdef` or `#switch`, by its span: true if it ran at least once. Filled if
    /// [`super::Options::record_branches`] is set.
    branches: BTreeMap<Span, bool>,
}

impl<'a> Reporter<'a> {
    pub(super) fn new(inputs: Inputs<'a>, output: &'a mut dyn FnMut(&str)) -> Self {
        Self {
            inputs,
            output,
            diagnostics: vec![],
            deferred: vec![],
            fault_count: 0,
            mistakes: Mistakes::default(),
            usage: Usage::new(&*inputs.options.host),
            limit_reached: false,
            branches: BTreeMap::new(),
        }
    }

    /// Prints the text of `#debug` and the like.
    pub(super) fn print(&mut self, text: &str) {
        (self.output)(text);
    }

    /// True if a limit has ended the run.
    pub(super) fn limit_reached(&self) -> bool {
        self.limit_reached
    }

    pub(super) fn error_count(&self) -> usize {
        self.diagnostics.iter().filter(|d| d.severity == Severity::Error).count()
    }

    /// Adds a diagnostic, or the cause that is found for it. Drops a diagnostic that only follows from an earlier one
    /// or repeats it, and those beyond the maximum number.
    pub(super) fn report(&mut self, d: Diagnostic) {
        let silent = matches!(d.code, codes::FOLLOWS | codes::ENDS_RUN);
        // The code separates errors from warnings: an error in an unused declaration is reported with severity `Warning`.
        let d = if silent || d.code.severity() == Severity::Warning { Some(d) } else { self.cause_to_report(d) };
        let Some(d) = d.filter(|_| !silent) else { return };
        // An error at the same place replaces a warning.
        let is_same = |k: &Diagnostic| k.message == d.message || k.severity > d.severity;
        let known = |k: &Diagnostic| k.code == d.code && k.span() == d.span() && is_same(k);
        if self.diagnostics.iter().rev().take(100).any(known) {
            return;
        }
        if d.severity == Severity::Error && self.error_count() >= MAX_ERRORS && !self.limit_reached {
            self.mistakes.count_unreported(d.span());
            return;
        }
        if d.severity == Severity::Warning && self.diagnostics.len() >= MAX_WARNINGS {
            // A loop that warns in each pass would fill the memory.
            if let Some(last) = self.diagnostics.last_mut() {
                last.help = Some("further warnings are not shown".into());
            }
            return;
        }
        self.diagnostics.push(d);
    }

    /// Stores diagnostics that are reported at the end of the run.
    pub(super) fn defer(&mut self, faults: impl IntoIterator<Item = Diagnostic>) {
        self.deferred.extend(faults);
    }

    /// Counts an error, even one that was reported before. Returns true if there are too many to continue.
    pub(super) fn count_fault_reaches_limit(&mut self) -> bool {
        self.fault_count += 1;
        self.fault_count >= MAX_FAULTS
    }

    /// Returns the number of diagnostics so far, for [`Self::take_diagnostics_since`].
    pub(super) fn diagnostic_count(&self) -> usize {
        self.diagnostics.len()
    }

    /// Removes and returns the diagnostics reported since `position`.
    pub(super) fn take_diagnostics_since(&mut self, position: usize) -> Vec<Diagnostic> {
        self.diagnostics.split_off(position.min(self.diagnostics.len()))
    }

    /// Records whether a branch runs, if [`super::Options::record_branches`] is set.
    pub(super) fn record_branch(&mut self, body: &[Element], runs: bool) {
        if let (true, [first, ..], Some(last)) = (self.inputs.options.record_branches, body, body.last()) {
            *self.branches.entry(first.span.to(last.span)).or_default() |= runs;
        }
    }

    /// Reports all deferred diagnostics, and as warnings those `faults_of_declarations` that no use of the declared
    /// name has reported as errors. Completes all messages; nothing is reported afterwards.
    pub(super) fn report_deferred(&mut self, faults_of_declarations: Vec<Diagnostic>) {
        for d in std::mem::take(&mut self.deferred) {
            self.report(d);
        }
        let is_wanted = |fault: &Diagnostic| !matches!(fault.code, codes::NOT_YET | codes::FOLLOWS);
        for mut fault in faults_of_declarations.into_iter().filter(is_wanted) {
            fault.severity = Severity::Warning;
            self.report(fault);
        }
        self.diagnostics.retain(|d| d.code != codes::FOLLOWS && d.code != codes::ENDS_RUN);
        self.add_all_uses_of_missing_names();
        self.add_count_of_unreported_errors();
    }

    /// Returns all diagnostics, and the branches that never ran.
    pub(super) fn into_diagnostics_and_unused_branches(self) -> (Vec<Diagnostic>, Vec<Span>) {
        let unused = self.branches.into_iter().filter(|(_, ran)| !ran).map(|(span, _)| span).collect();
        (self.diagnostics, unused)
    }
}
