//! A text that is being edited, with positions in the protocol's units of UTF-16.
//!
//! Not the crate `line-index`: it ends lines at `\n` alone, where scenes may also have `\r`, and it does not follow
//! changes.

use lsp_types::{Position, Range, TextDocumentContentChangeEvent};

/// A text and the starts of its lines.
#[derive(Clone, Debug, Default)]
pub struct Text {
    all: String,
    /// Byte offsets of the lines; the first is 0.
    lines: Vec<usize>,
}

impl Text {
    /// Finds the lines of a text.
    pub fn new(all: String) -> Self {
        let lines = line_starts(&all);
        Self { all, lines }
    }

    /// Returns the whole text of the document.
    pub fn as_str(&self) -> &str {
        &self.all
    }

    /// Returns the number of lines: one more than the number of line endings.
    pub fn line_count(&self) -> usize {
        self.lines.len()
    }

    /// Returns the byte offset of a position. A position after the end of a line or of the text is moved to that end, and a
    /// position within a character to its start.
    pub fn offset(&self, at: Position) -> usize {
        let Some(&start) = self.lines.get(at.line as usize) else { return self.all.len() };
        let line = self.line(at.line as usize);
        let mut units = 0;
        for (i, c) in line.char_indices() {
            let after = units + c.len_utf16() as u32;
            if after > at.character {
                return start + i;
            }
            units = after;
        }
        start + line.len()
    }

    /// Returns the line and column of a byte offset at the start of a character. An offset after the text counts as its end.
    pub fn position(&self, offset: usize) -> Position {
        let offset = offset.min(self.all.len());
        let line = self.lines.partition_point(|start| *start <= offset).saturating_sub(1);
        let before = self.all.get(self.lines[line]..offset).unwrap_or_default();
        Position::new(line as u32, before.encode_utf16().count() as u32)
    }

    /// Returns the lines and columns of a byte range.
    pub fn range(&self, bytes: std::ops::Range<usize>) -> Range {
        Range::new(self.position(bytes.start), self.position(bytes.end))
    }

    /// Returns the line with this index, from 0, without its line ending; empty after the last line.
    pub fn line(&self, line: usize) -> &str {
        let Some(&start) = self.lines.get(line) else { return "" };
        let end = self.lines.get(line + 1).copied().unwrap_or(self.all.len());
        self.all[start..end].trim_end_matches(['\n', '\r'])
    }

    /// Returns all lines with their line endings; an empty last line is omitted.
    pub fn lines_with_ends(&self) -> Vec<&str> {
        let ends = self.lines.iter().copied().skip(1).chain([self.all.len()]);
        let lines = self.lines.iter().zip(ends).map(|(start, end)| &self.all[*start..end]);
        lines.filter(|line| !line.is_empty()).collect()
    }

    /// Applies a change, of the whole text if it has no range; returns the removed byte range and the number of new bytes.
    pub fn change_with_extent(&mut self, change: TextDocumentContentChangeEvent) -> (std::ops::Range<usize>, usize) {
        let Some(range) = change.range else {
            let old = self.all.len();
            let new = change.text.len();
            *self = Self::new(change.text);
            return (0..old, new);
        };
        let (a, b) = (self.offset(range.start), self.offset(range.end));
        let bytes = a.min(b)..a.max(b);
        self.all.replace_range(bytes.clone(), &change.text);
        self.update_lines(&bytes, &change.text);
        (bytes, change.text.len())
    }

    /// Updates the starts of the lines after a change that replaced `bytes` of the old text by `new`.
    fn update_lines(&mut self, bytes: &std::ops::Range<usize>, new: &str) {
        // The change may add or remove a `\n` after a `\r`: scan the neighbouring lines again.
        let first = self.lines.partition_point(|start| *start < bytes.start).saturating_sub(1);
        let last = self.lines.partition_point(|start| *start <= bytes.end + 1);
        let moved = |start: usize| start - bytes.len() + new.len();
        let from = self.lines[first];
        let until = self.lines.get(last).map_or(self.all.len(), |start| moved(*start));
        let between = line_starts(&self.all[from..until]).into_iter().skip(1).map(|start| from + start);
        let mut lines = self.lines[..=first].to_vec();
        lines.extend(between);
        if lines.last() == Some(&until) && last < self.lines.len() {
            lines.pop();
        }
        lines.extend(self.lines[last..].iter().map(|start| moved(*start)));
        self.lines = lines;
    }
}

/// Byte offsets of all lines, which end with `\n`, `\r\n` or `\r`.
fn line_starts(text: &str) -> Vec<usize> {
    let bytes = text.as_bytes();
    let ends = |i: &usize| bytes[*i] == b'\n' || bytes[*i] == b'\r' && bytes.get(i + 1) != Some(&b'\n');
    std::iter::once(0).chain((0..bytes.len()).filter(ends).map(|i| i + 1)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_in_utf_16() {
        let text = Text::new("aä€😀b\r\nc\rd\n".into());
        assert_eq!(text.line_count(), 4);
        assert_eq!(text.position(10), Position::new(0, 5));
        assert_eq!(text.offset(Position::new(0, 5)), 10);
        // Between the two units of one character.
        assert_eq!(text.offset(Position::new(0, 4)), 6);
        assert_eq!(text.offset(Position::new(0, 99)), 11);
        assert_eq!(text.offset(Position::new(9, 0)), text.as_str().len());
        assert_eq!(text.line(2), "d");
        assert_eq!(text.lines_with_ends(), ["aä€😀b\r\n", "c\r", "d\n"]);
    }

    /// Returns the next number of a linear congruential generator.
    fn next(seed: &mut u64) -> usize {
        *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (*seed >> 33) as usize
    }

    #[test]
    fn lines_are_correct_after_random_edits() {
        let (mut seed, pieces) = (7, ["", "a", "\n", "\r", "\r\n", "ä😀", "x\ny\r\nz"]);
        let mut text = Text::new("one\r\ntwo\n\rthree".into());
        for _ in 0..3000 {
            let mut place = || Position::new((next(&mut seed) % 8) as u32, (next(&mut seed) % 6) as u32);
            let (a, b) = (place(), place());
            let range = Some(Range::new(a.min(b), a.max(b)));
            let piece = pieces[next(&mut seed) % pieces.len()].to_string();
            text.change_with_extent(TextDocumentContentChangeEvent { range, range_length: None, text: piece });
            assert_eq!(text.lines, line_starts(&text.all), "{:?}", text.all);
            if text.all.len() > 200 {
                text = Text::new(String::new());
            }
        }
    }
}
