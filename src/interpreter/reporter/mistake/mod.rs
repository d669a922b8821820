//! From a fault to its cause: what was meant, which faults only follow from others, and which are one and the same.
//!
//! All of this runs only when there is a fault.

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
use habit::Habit;
use rustc_hash::{FxHashMap, FxHashSet};
use source_line::{SourceLine, leading_name};

/// What the faults so far have left undone: what needs it is no fault of its own.
#[derive(Default)]
pub(super) struct Mistakes {
    /// Names that were to be declared.
    names: FxHashSet<String>,
    /// Words of the language that were to be declared.
    words: FxHashSet<String>,
    /// Include files that were not read, and the files that name them.
    files: Vec<(String, FileId)>,
    /// Was a directive with a body written in a way that none is?
    lost_directive: bool,
    /// Lines, as a file and the line's start, that can't be read.
    lines: FxHashSet<(FileId, usize)>,
    /// Places of errors that are counted only.
    unreported: FxHashSet<Span>,
    /// The first of them.
    first_unreported: Option<Span>,
    /// What was found out of a file's braces.
    early: FxHashMap<FileId, Option<Box<Diagnostic>>>,
}

impl Mistakes {
    /// An error after all that are told.
    pub(super) fn count_unreported(&mut self, at: Span) {
        self.first_unreported.get_or_insert(at);
        self.unreported.insert(at);
    }
}

impl Reporter<'_> {
    /// A fault as it is to be told; `None` if it follows from another, or is told with another.
    pub(super) fn with_cause(&mut self, mut d: Diagnostic) -> Option<Diagnostic> {
        let Some(source) = SourceLine::of(self.inputs.sources, d.span()) else { return Some(d) };
        let line = (source.file, source.line.start);
        let habit = habit::find(&source, &d);
        let is_habit = habit.is_some();
        if let Some(habit) = habit {
            let base = self.inputs.sources.base(source.file);
            self.record_habit(&habit, source.file);
            d = habit.told(d, base);
        } else if self.is_consequence(&d, &source) {
            return None;
        }
        self.record_consequences(&d, &source);
        // What else is wrong in a line that can't be read is no news.
        let known = self.diagnostics.iter().any(|k| k.span() == d.span() && k.code == d.code);
        if !known && d.severity == Severity::Error {
            if self.mistakes.lines.contains(&line) {
                return None;
            }
            if is_habit {
                self.mistakes.lines.insert(line);
            }
        }
        self.merge_with_same_cause(d)
    }

    /// Remembers what was meant, and is not there.
    fn record_habit(&mut self, habit: &Habit, file: FileId) {
        self.mistakes.names.extend(habit.names.iter().cloned());
        self.mistakes.files.extend(habit.file.clone().map(|name| (name, file)));
        self.mistakes.lost_directive |= habit.loses_directive;
    }

    /// Remembers what a fault leaves undone.
    fn record_consequences(&mut self, d: &Diagnostic, source: &SourceLine) {
        let text = self.inputs.sources.snippet(d.span());
        let directive = source.statement().strip_prefix('#').map(str::trim_start).and_then(leading_name);
        if let Some(("declare" | "local" | "macro", rest)) = directive
            && let Some((name, _)) = leading_name(rest.trim_start())
        {
            self.mistakes.names.insert(name.to_string());
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

    /// Does a fault follow from an earlier one?
    fn is_consequence(&self, d: &Diagnostic, source: &SourceLine) -> bool {
        if d.code == codes::UNMATCHED_CLOSER && self.mistakes.lost_directive && source.after().starts_with("#end") {
            return true;
        }
        if let Some(cause) = &d.cause {
            return cause.uses.iter().all(|(name, _)| self.is_left_undone(name, source.file));
        }
        let is_value = matches!(d.code, codes::EXPECTED | codes::EXPECTED_VALUE | codes::UNKNOWN_WORD);
        is_value && !self.mistakes.words.is_empty() && source.words().any(|word| self.mistakes.words.contains(word))
    }

    /// Would the name be declared, had nothing failed before?
    fn is_left_undone(&self, name: &str, user: FileId) -> bool {
        let gives = |(file, includer): &(String, FileId)| match library::is_standard(file) {
            true => library::declares(file, name),
            // Nobody knows what a file of the author's would have declared for the one that includes it.
            false => *includer == user && library::declared_in(name).is_none(),
        };
        self.mistakes.names.contains(name) || self.mistakes.files.iter().any(gives)
    }

    /// At the end of the run: one message for each cause, and how many errors were only counted.
    pub(in crate::interpreter) fn settle_messages(&mut self) {
        let all = std::mem::take(&mut self.diagnostics);
        self.diagnostics = all.into_iter().map(|d| self.with_all_places(d)).collect();
        let unreported = self.mistakes.unreported.len();
        if let Some(first) = self.mistakes.first_unreported {
            let more = if unreported == 1 {
                "one more error was found".into()
            } else {
                format!("{unreported} more errors were found")
            };
            let d = Diagnostic::new(codes::MORE_ERRORS, first, format!("{more}, and not told")).label("the next one");
            self.diagnostics.push(d.help("mend the first ones: others often follow from them"));
        }
    }
}
