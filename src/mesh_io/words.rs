//! Text files of words separated by whitespace.

use super::ReadResult;

/// Words of a mesh file's text in order, with the current line number.
pub struct Words<'a> {
    rest: &'a [u8],
    /// Current line of the mesh file, counted from 1.
    pub line: usize,
}

impl<'a> Words<'a> {
    /// Returns the words of a text whose first line has this number.
    pub fn new(rest: &'a [u8], line: usize) -> Self {
        Self { rest, line }
    }

    /// Returns the next word of the text, on this line or a later one.
    pub fn next_word(&mut self) -> Option<&'a [u8]> {
        loop {
            let first = *self.rest.first()?;
            if !first.is_ascii_whitespace() {
                break;
            }
            self.line += usize::from(first == b'\n');
            self.rest = &self.rest[1..];
        }
        let end = self.rest.iter().position(u8::is_ascii_whitespace).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        Some(word)
    }

    /// Returns the current line of the mesh file, for a message.
    pub fn line_for_message(&self) -> String {
        format!("line {}", self.line)
    }
}

/// Returns the lines of a text, each with its number and without its end; a line that ends in `\` is joined with the
/// next.
pub fn numbered_lines(bytes: &[u8]) -> impl Iterator<Item = (usize, String)> {
    let text = |line: &[u8]| String::from_utf8_lossy(line).trim().to_string();
    let mut rest = bytes.split(|b| *b == b'\n').enumerate();
    std::iter::from_fn(move || {
        let (number, line) = rest.next()?;
        let mut line = text(line);
        while line.ends_with('\\') {
            line.pop();
            line.push(' ');
            line += &rest.next().map(|(_, more)| text(more)).unwrap_or_default();
        }
        Some((number + 1, line))
    })
}

/// Parses a number in a mesh file; `place` gives its position for the error message.
pub fn parse_number(word: &[u8], place: impl FnOnce() -> String) -> ReadResult<f64> {
    let text = std::str::from_utf8(word).ok();
    text.and_then(|text| text.parse().ok()).ok_or_else(|| {
        let word: String = String::from_utf8_lossy(word).chars().take(20).collect();
        format!("{}: expected a number, found `{word}`", place())
    })
}
