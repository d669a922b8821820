//! Decodes and encodes files of the formatter, which keep their encoding and line ends.

use super::format;
use crate::diagnostic::Diagnostic;
use crate::source::{ReadError, text_of};

/// A file's text, and its encoding.
#[derive(Debug)]
pub struct Encoded {
    /// Text of the file without a byte-order mark.
    pub text: String,
    marked: bool,
    latin_1: bool,
}

const MARK: &[u8] = b"\xef\xbb\xbf";

/// Decodes the bytes of a file.
///
/// # Errors
/// If the bytes are no text.
pub fn decode(bytes: Vec<u8>) -> Result<Encoded, ReadError> {
    let (marked, latin_1) = (bytes.starts_with(MARK), std::str::from_utf8(&bytes).is_err());
    Ok(Encoded { text: text_of(bytes)?, marked, latin_1 })
}

impl Encoded {
    /// Returns the formatted text; see [`format()`]. Each `\n` without a `\r` before it is replaced by the line ending of
    /// the original's first line; each `\r\n`, and each `\r` in comments and strings, stays.
    ///
    /// # Errors
    /// Those of [`format()`].
    pub fn formatted(&self, base_in_sources: usize, width: usize) -> Result<String, Vec<Diagnostic>> {
        Ok(replace_lone_line_feeds(&format(&self.text, base_in_sources, width)?, line_end(&self.text)))
    }

    /// Encodes `text` as the original file was encoded.
    pub fn encode(&self, text: &str) -> Vec<u8> {
        let mark = if self.marked { MARK } else { b"" };
        let narrow = || text.chars().map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?')).collect();
        let bytes: Vec<u8> = if self.latin_1 { narrow() } else { text.as_bytes().to_vec() };
        [mark, &bytes].concat()
    }
}

/// Returns the line ending of the first line of the text.
fn line_end(text: &str) -> &'static str {
    match text.find(['\n', '\r']) {
        Some(at) if text[at..].starts_with("\r\n") => "\r\n",
        Some(at) if text[at..].starts_with('\r') => "\r",
        _ => "\n",
    }
}

/// Replaces each `\n` without a `\r` before it by `end`, also inside of strings and comments.
fn replace_lone_line_feeds(text: &str, end: &str) -> String {
    if end == "\n" {
        return text.to_string();
    }
    let mut out = String::with_capacity(text.len() + text.len() / 16);
    for line in text.split_inclusive('\n') {
        match line.strip_suffix('\n') {
            Some(rest) if !rest.ends_with('\r') => {
                out.push_str(rest);
                out.push_str(end);
            }
            _ => out.push_str(line),
        }
    }
    out
}
