//! The text around a fault.

use crate::source::{FileId, Sources, Span};
use std::ops::Range;

/// So much of a line is looked at on each side of a place: a file of a million bytes may be one line.
const LONG: usize = 500;

/// A place in a text, and its line.
pub(super) struct SourceLine<'t> {
    pub(super) file: FileId,
    pub(super) text: &'t str,
    /// Local offset of the place.
    pub(super) at: usize,
    /// Local offset of its end.
    pub(super) end: usize,
    /// The line, without its end.
    pub(super) line: Range<usize>,
}

impl<'t> SourceLine<'t> {
    pub(super) fn of(sources: &'t Sources, span: Span) -> Option<Self> {
        let (file, range) = sources.locate(span)?;
        let text = sources.text(file);
        let (from, to) = (range.start.saturating_sub(LONG), range.start.saturating_add(LONG));
        let (from, to) = (text.floor_char_boundary(from), text.floor_char_boundary(to));
        let start = text.get(from..range.start)?.rfind(['\n', '\r']).map_or(from, |i| from + i + 1);
        let end = text.get(range.start..to)?.find(['\n', '\r']).map_or(to, |i| range.start + i);
        Some(Self { file, text, at: range.start, end: range.end, line: start..end })
    }

    /// The line up to the place.
    pub(super) fn before(&self) -> &'t str {
        &self.text[self.line.start..self.at]
    }

    /// The line from the place on.
    pub(super) fn after(&self) -> &'t str {
        &self.text[self.at..self.line.end]
    }

    /// The whole line, without a comment at its end and the blanks around it.
    pub(super) fn statement(&self) -> &'t str {
        code_of(&self.text[self.line.clone()])
    }

    /// Local offset of [`Self::statement`].
    pub(super) fn statement_start(&self) -> usize {
        let line = &self.text[self.line.clone()];
        self.line.start + line.len() - line.trim_start().len()
    }

    /// The words of the line.
    pub(super) fn words(&self) -> impl Iterator<Item = &'t str> {
        self.text[self.line.clone()].split(|c: char| !is_letter(c)).filter(|word| !word.is_empty())
    }

    /// A local range of a part of the text.
    pub(super) fn range_of(&self, part: &str) -> Range<usize> {
        let start = (part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize).min(self.text.len());
        start..(start + part.len()).min(self.text.len())
    }
}

/// A line without a comment at its end and the blanks around it.
pub(super) fn code_of(line: &str) -> &str {
    let end = line.find("//").or(line.find("/*")).unwrap_or(line.len());
    line[..end].trim()
}

/// May it be a part of a name?
pub(super) fn is_letter(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The name that a text begins with, and what follows it.
pub(super) fn leading_name(text: &str) -> Option<(&str, &str)> {
    let end = text.find(|c: char| !is_letter(c)).unwrap_or(text.len());
    text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_').then(|| text.split_at(end))
}

/// The name that a text ends with, and what stands before it.
pub(super) fn trailing_name(text: &str) -> Option<(&str, &str)> {
    let start = text.trim_end_matches(is_letter).len();
    let (before, name) = text.split_at(start);
    name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_').then_some((before, name))
}

/// A value as it stands behind a sign, up to its `;`, for a help line.
pub(super) fn value_text(text: &str) -> String {
    let value = code_of(text).trim_end_matches(';').trim();
    match value.char_indices().nth(50) {
        _ if value.is_empty() => "…".into(),
        Some((end, _)) => format!("{}…", &value[..end]),
        None => value.into(),
    }
}
