//! The line of text around an error.

use crate::source::{FileId, Sources, Span};
use std::ops::Range;

/// Number of bytes of a line that are examined on each side of the error, since a large file may be one line.
const LONG: usize = 500;

/// A span in a text, and the line that holds its start.
pub(super) struct SourceLine<'t> {
    pub(super) file: FileId,
    pub(super) text: &'t str,
    /// Start of the span, as an offset in the file.
    pub(super) at: usize,
    /// End of the span, as an offset in the file.
    pub(super) end: usize,
    /// Byte range of the source line, without its line feed and with at most [`LONG`] bytes on each side of the span.
    pub(super) line: Range<usize>,
}

impl<'t> SourceLine<'t> {
    /// Finds the line around the start of `span`; `None` if the span is in no text.
    pub(super) fn around(sources: &'t Sources, span: Span) -> Option<Self> {
        let (file, range) = sources.locate(span)?;
        let text = sources.text(file);
        let (from, to) = (range.start.saturating_sub(LONG), range.start.saturating_add(LONG));
        let (from, to) = (text.floor_char_boundary(from), text.floor_char_boundary(to));
        let start = text.get(from..range.start)?.rfind(['\n', '\r']).map_or(from, |i| from + i + 1);
        let end = text.get(range.start..to)?.find(['\n', '\r']).map_or(to, |i| range.start + i);
        Some(Self { file, text, at: range.start, end: range.end, line: start..end })
    }

    /// Returns the source line up to the fault's span.
    pub(super) fn before_fault(&self) -> &'t str {
        &self.text[self.line.start..self.at]
    }

    /// Returns the source line from the fault's span on.
    pub(super) fn rest_from_fault(&self) -> &'t str {
        &self.text[self.at..self.line.end]
    }

    /// Returns the source line without comment and surrounding blanks.
    pub(super) fn line_without_comment(&self) -> &'t str {
        without_comment(&self.text[self.line.clone()])
    }

    /// Returns the offset of [`Self::line_without_comment`] in the source file.
    pub(super) fn trimmed_line_offset_in_file(&self) -> usize {
        let line = &self.text[self.line.clone()];
        self.line.start + line.len() - line.trim_start().len()
    }

    /// Returns the words of the faulty source line.
    pub(super) fn words(&self) -> impl Iterator<Item = &'t str> {
        self.text[self.line.clone()].split(|c: char| !is_name_char(c)).filter(|word| !word.is_empty())
    }

    /// Returns the byte range of a part of the line, as offsets in the file.
    pub(super) fn file_range_of(&self, part: &str) -> Range<usize> {
        let start = (part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize).min(self.text.len());
        start..(start + part.len()).min(self.text.len())
    }
}

/// Returns a line without comment and surrounding blanks.
pub(super) fn without_comment(line: &str) -> &str {
    let end = line.find("//").or(line.find("/*")).unwrap_or(line.len());
    line[..end].trim()
}

/// True if a name may contain the character.
pub(super) fn is_name_char(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// Splits a text into the name at its start and the text after the name.
pub(super) fn split_leading_name(text: &str) -> Option<(&str, &str)> {
    let end = text.find(|c: char| !is_name_char(c)).unwrap_or(text.len());
    text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_').then(|| text.split_at(end))
}

/// Splits a text into the text before the name at its end, and that name.
pub(super) fn split_trailing_name(text: &str) -> Option<(&str, &str)> {
    let start = text.trim_end_matches(is_name_char).len();
    let (before, name) = text.split_at(start);
    name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_').then_some((before, name))
}

/// Returns a value's text for a help line: without comment and final `;`, at most 50 characters, and `…` for an empty
/// text.
pub(super) fn shortened_value(text: &str) -> String {
    let value = without_comment(text).trim_end_matches(';').trim();
    match value.char_indices().nth(50) {
        _ if value.is_empty() => "…".into(),
        Some((end, _)) => format!("{}…", &value[..end]),
        None => value.into(),
    }
}
