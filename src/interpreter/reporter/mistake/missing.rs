//! Errors about names from an include file that is not included, merged into one message in the author's own file.

use crate::diagnostic::{Diagnostic, Label, MissingNames, Remedy};
use crate::interpreter::reporter::Reporter;
use crate::library;
use crate::source::Span;
use std::path::Path;

/// Maximum number of further places that a message shows.
const MAX_PLACES: usize = 4;

impl Reporter<'_> {
    /// Merges an error into a reported one about the same missing names; returns the error if no other is about them.
    pub(super) fn merge_with_same_missing_names(&mut self, d: Diagnostic) -> Option<Diagnostic> {
        let Some(missing_names) = d.missing_names.as_deref() else { return Some(d) };
        // A warning about an unused declaration can be merged into an error, too.
        let same = |k: &&mut Diagnostic| {
            k.severity >= d.severity && k.missing_names.as_ref().is_some_and(|known| known.is_same_as(missing_names))
        };
        match self.diagnostics.iter_mut().find(same).and_then(|known| known.missing_names.as_mut()) {
            Some(known) => {
                known.add_uses(missing_names);
                None
            }
            None => Some(d),
        }
    }

    /// Completes a message with all uses of its missing names, those in the author's own file first.
    pub(super) fn with_all_uses_of_missing_names(&self, mut d: Diagnostic) -> Diagnostic {
        let Some(mut missing_names) = d.missing_names.take() else { return d };
        missing_names.uses.sort_by_key(|(_, span)| (self.in_standard_file(*span), span.lo));
        let Some((name, first)) = missing_names.uses.first().cloned() else { return d };
        if let Remedy::Include(file) = missing_names.remedy {
            if self.in_standard_file(first) {
                return self.missing_include_of_include(d, &missing_names, file);
            }
            d.message = include_message(&name, file);
            d.help = Some(include_help(file));
            if self.include_missing_for(&name).is_none() {
                d.message = format!("`{name}` is declared in `{file}`, which is included only further down");
                d.help = Some(format!("put `#include \"{file}\"` before this line"));
            }
        }
        // The call trace belongs to the first span only.
        if first != d.span() {
            d.trace = Box::default();
        }
        d.labels = vec![Label { span: first, text: String::new() }];
        self.add_labels_of_further_uses(&mut d, &missing_names, &name);
        d
    }

    /// Adds further places to a message, and the number of places beyond [`MAX_PLACES`].
    fn add_labels_of_further_uses(&self, d: &mut Diagnostic, missing_names: &MissingNames, name: &str) {
        let file = |span: Span| self.inputs.sources.locate(span).map(|(file, _)| file);
        let mut more = 0;
        for (other, span) in &missing_names.uses[1..] {
            if d.labels.len() > MAX_PLACES || file(*span) != file(missing_names.uses[0].1) {
                more += 1;
                continue;
            }
            let text = if other == name { "and here".into() } else { format!("`{other}` is declared there too") };
            d.labels.push(Label { span: *span, text });
        }
        if let (true, Some(help)) = (more > 0, d.help.as_mut()) {
            let places =
                if more == 1 { "one more place needs it".into() } else { format!("{more} more places need it") };
            help.push_str(&format!(" ({places})"));
        }
    }

    /// Turns an error inside a standard include file into the error that this file needs the include file
    /// `missing_file`. The place of the error is the `#include` or macro call in the author's own text.
    fn missing_include_of_include(
        &self,
        mut d: Diagnostic,
        missing_names: &MissingNames,
        missing_file: &'static str,
    ) -> Diagnostic {
        let Some((name, first)) = missing_names.uses.first() else { return d };
        let inner = self.inputs.sources.locate(*first).map_or("", |(id, _)| self.inputs.sources.name(id));
        let inner = Path::new(inner).file_name().unwrap_or_default().to_string_lossy().into_owned();
        let outer = d.trace.iter().find(|step| !self.in_standard_file(step.span)).cloned();
        let Some(place) = outer.filter(|step| !step.span.is_none()) else { return d };
        let mut names: Vec<&str> = missing_names.uses.iter().map(|(name, _)| name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        let others = match names.len() - 1 {
            0 => String::new(),
            1 => " and one more name of it".into(),
            n => format!(" and {n} more names of it"),
        };
        d.message = format!("`{inner}` needs `{missing_file}`: it uses `{name}`{others}");
        d.help = Some(match place.text.as_str() {
            "included" => format!("add `#include \"{missing_file}\"` before this line"),
            _ => format!("add `#include \"{missing_file}\"` at the start of the scene"),
        });
        d.labels = vec![Label { span: place.span, text: String::new() }];
        d.trace = Box::new([Label { span: *first, text: format!("`{name}` is used") }]);
        d
    }

    /// True if a span is in a standard include file, installed or built in.
    pub(super) fn in_standard_file(&self, span: Span) -> bool {
        let Some((id, _)) = self.inputs.sources.locate(span) else { return false };
        match self.inputs.sources.path(id) {
            Some(path) => {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                let own = self.inputs.options.search.folders.first().map(|folder| folder.as_path());
                library::is_standard_include(&name) && path.parent() != own
            }
            None => self.inputs.sources.name(id).starts_with(library::FOLDER),
        }
    }

    /// True if a standard include file declares the name. A name of up to four letters counts only with the same letter
    /// case, and only if the file has not been read.
    pub fn is_declared_in_library(&self, name: &str) -> bool {
        self.include_missing_for(name).is_some()
            || name.len() > 4 && library::standard_names().any(|n| n.eq_ignore_ascii_case(name))
    }

    /// Returns the help for a name that a standard include file declares, used outside of all blocks; `None` if no such
    /// file declares it, or if the file has been read.
    pub fn include_hint(&self, name: &str) -> Option<String> {
        self.include_missing_for(name).map(|file| {
            format!("`{name}` is declared in `{file}`; it is used inside a block, after `#include \"{file}\"`")
        })
    }

    /// Returns the standard include file that declares a name; `None` if none does, or if the file has been read.
    pub(super) fn include_missing_for(&self, name: &str) -> Option<&'static str> {
        let file = library::standard_file_of(name)?;
        let read = |(id, _): (crate::source::FileId, &_)| {
            Path::new(self.inputs.sources.name(id)).file_name() == Some(file.as_ref())
        };
        (!self.inputs.parsed.all().into_iter().any(read)).then_some(file)
    }
}

pub(super) fn include_message(name: &str, file: &str) -> String {
    format!("`{name}` is declared in `{file}`, which is not included")
}

pub(super) fn include_help(file: &str) -> String {
    format!("add `#include \"{file}\"`")
}
