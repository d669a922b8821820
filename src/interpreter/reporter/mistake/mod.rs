//! Finds the causes of errors: a common mistake, an earlier error, or a cause that several errors share.
//!
//! This code runs only after an error.

mod bracket;
mod directive;
mod habit;
mod missing;
mod operator;
mod source_line;
mod statement;
mod undeclared;

use crate::diagnostic::{Diagnostic, Severity, codes};
use crate::interpreter::reporter::Reporter;
use crate::library;
use crate::source::{FileId, Span};
use habit::CommonMistake;
use rustc_hash::{FxHashMap, FxHashSet};
use source_line::{SourceLine, split_leading_name};

/// Consequences of earlier errors, by which errors that only follow from these are suppressed.
#[derive(Default)]
pub(super) struct Mistakes {
    /// Names that stay undeclared because of earlier errors.
    names_left_undeclared: FxHashSet<String>,
    /// Keywords that the scene used as names.
    words: FxHashSet<String>,
    /// Include files that were not read, each with the file that includes it.
    files: Vec<(String, FileId)>,
    /// True if a directive with a body was not recognized, so that its `#end` is surplus.
    lost_directive: bool,
    /// Source lines that cannot be parsed, each as its file and the offset of the line's start.
    lines: FxHashSet<(FileId, usize)>,
    /// Spans of errors beyond the maximum, which are only counted.
    unreported: FxHashSet<Span>,
    /// Span of the first error beyond the maximum.
    first_unreported: Option<Span>,
    /// For each examined file, the error about a `}` that ends a block too early; `None` for a file without such a
    /// brace.
    early: FxHashMap<FileId, Option<Box<Diagnostic>>>,
}

impl Mistakes {
    /// Counts an error beyond the maximum number of reported errors.
    pub(super) fn count_unreported(&mut self, at: Span) {
        self.first_unreported.get_or_insert(at);
        self.unreported.insert(at);
    }
}

impl Reporter<'_> {
    /// Replaces an error by its cause; `None` if it follows from another error or is merged into one.
    pub(super) fn cause_to_report(&mut self, mut d: Diagnostic) -> Option<Diagnostic> {
        let Some(source) = SourceLine::around(self.inputs.sources, d.span()) else { return Some(d) };
        let line = (source.file, source.line.start);
        let habit = habit::find(&source, &d);
        let is_habit = habit.is_some();
        if let Some(habit) = habit {
            let base = self.inputs.sources.base(source.file);
            self.record_common_mistake(&habit, source.file);
            d = habit.apply_to(d, base);
        } else if self.is_consequence(&d, &source) {
            return None;
        }
        self.record_consequences(&d, &source);
        // Further errors in a line that cannot be parsed are not reported.
        let known = self.diagnostics.iter().any(|k| k.span() == d.span() && k.code == d.code);
        if !known && d.severity == Severity::Error {
            if self.mistakes.lines.contains(&line) {
                return None;
            }
            if is_habit {
                self.mistakes.lines.insert(line);
            }
        }
        self.merge_with_same_missing_names(d)
    }

    /// Records the names and files that a common mistake leaves undeclared or unread.
    fn record_common_mistake(&mut self, habit: &CommonMistake, file: FileId) {
        self.mistakes.names_left_undeclared.extend(habit.names_left_undeclared.iter().cloned());
        self.mistakes.files.extend(habit.file.clone().map(|name| (name, file)));
        self.mistakes.lost_directive |= habit.loses_directive;
    }

    /// Records the names and files that an error leaves undeclared or unread.
    fn record_consequences(&mut self, d: &Diagnostic, source: &SourceLine) {
        let text = self.inputs.sources.snippet(d.span());
        let directive =
            source.line_without_comment().strip_prefix('#').map(str::trim_start).and_then(split_leading_name);
        if let Some(("declare" | "local" | "macro", rest)) = directive
            && let Some((name, _)) = split_leading_name(rest.trim_start())
        {
            self.mistakes.names_left_undeclared.insert(name.to_string());
        }
        match d.code {
            codes::MISSING_INCLUDE | codes::UNREADABLE_INCLUDE if matches!(directive, Some(("include", _))) => {
                let meant = d.help.as_deref().and_then(|help| help.strip_prefix("did you mean `")?.strip_suffix("`?"));
                for name in [Some(text.trim_matches('"')), meant].into_iter().flatten() {
                    self.mistakes.files.push((name.to_string(), source.file));
                }
            }
            codes::RESERVED_NAME => drop(self.mistakes.words.insert(text.to_string())),
            _ => {}
        }
    }

    /// True if an error is a consequence of an earlier one.
    fn is_consequence(&self, d: &Diagnostic, source: &SourceLine) -> bool {
        if d.code == codes::UNMATCHED_CLOSER
            && self.mistakes.lost_directive
            && source.rest_from_fault().starts_with("#end")
        {
            return true;
        }
        if let Some(names) = &d.missing_names {
            return names.uses.iter().all(|(name, _)| self.is_undeclared_by_error(name, source.file));
        }
        let is_value = matches!(d.code, codes::EXPECTED | codes::EXPECTED_VALUE | codes::UNKNOWN_WORD);
        is_value && !self.mistakes.words.is_empty() && source.words().any(|word| self.mistakes.words.contains(word))
    }

    /// True if the name is undeclared only because of earlier errors.
    fn is_undeclared_by_error(&self, name: &str, using_file: FileId) -> bool {
        let gives = |(file, includer): &(String, FileId)| match library::is_standard_include(file) {
            true => library::declares(file, name),
            // The contents of the author's own missing file are unknown: it may declare any name in the file that
            // includes it.
            false => *includer == using_file && library::standard_file_of(name).is_none(),
        };
        self.mistakes.names_left_undeclared.contains(name) || self.mistakes.files.iter().any(gives)
    }

    /// Completes each message about missing names with all uses of the names, at the end of the run.
    pub fn add_all_uses_of_missing_names(&mut self) {
        let all = std::mem::take(&mut self.diagnostics);
        self.diagnostics = all.into_iter().map(|d| self.with_all_uses_of_missing_names(d)).collect();
    }

    /// Adds a diagnostic with the number of errors that were not reported, if there are any.
    pub fn add_count_of_unreported_errors(&mut self) {
        let unreported = self.mistakes.unreported.len();
        if let Some(first) = self.mistakes.first_unreported {
            let more = if unreported == 1 {
                "one more error was found".into()
            } else {
                format!("{unreported} more errors were found")
            };
            let d = Diagnostic::new(codes::MORE_ERRORS, first, format!("{more}, and not shown")).label("the next one");
            self.diagnostics.push(d.help("mend the first ones: others often follow from them"));
        }
    }
}
