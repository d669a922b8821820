//! Reads a text file, and tells a text from a picture, an archive or a program.

use super::{Files, decode_text};
use std::io;
use std::path::Path;

/// Why a text was not read.
#[derive(Debug)]
pub enum ReadError {
    /// The system would not give it.
    Io(io::Error),
    /// It is a folder.
    Folder,
    /// It is not text but this: `a PNG picture`.
    NotText(&'static str),
}

impl From<io::Error> for ReadError {
    fn from(error: io::Error) -> Self {
        ReadError::Io(error)
    }
}

/// The text of a file: UTF-8, or else Latin-1 (see [`decode_text`]).
///
/// # Errors
/// If it can't be read, is too long, or is no text.
pub fn read_text(files: &dyn Files, path: &Path) -> Result<String, ReadError> {
    if files.is_folder(path) {
        return Err(ReadError::Folder);
    }
    text_of(files.read(path)?)
}

/// The text that these bytes are.
///
/// # Errors
/// If there are too many, or they are no text.
pub fn text_of(bytes: Vec<u8>) -> Result<String, ReadError> {
    match binary_kind(&bytes) {
        Some(kind) => Err(ReadError::NotText(kind)),
        None => Ok(decode_text(bytes)),
    }
}

/// How files begin that people mistake for scenes.
const SIGNATURES: &[(&[u8], &str)] = &[
    (b"\x89PNG", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"II*\0", "a TIFF picture"),
    (b"MM\0*", "a TIFF picture"),
    (b"\x76\x2f\x31\x01", "an EXR picture"),
    (b"#?RADIANCE", "an HDR picture"),
    (b"%PDF-", "a PDF document"),
    (b"PK\x03\x04", "a ZIP archive"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"\x7fELF", "a program"),
    (b"\xff\xfe", "text in UTF-16"),
    (b"\xfe\xff", "text in UTF-16"),
];

/// How much of a file is looked at.
const LOOK: usize = 8192;

/// What the file is if it is not text: begins as a known kind does, holds a zero byte near its
/// start, or has more than one control character in sixteen.
fn binary_kind(bytes: &[u8]) -> Option<&'static str> {
    if let Some((_, kind)) = SIGNATURES.iter().find(|(start, _)| bytes.starts_with(start)) {
        return Some(kind);
    }
    let start = &bytes[..bytes.len().min(LOOK)];
    let control = |b: &&u8| **b < 32 && !matches!(**b, b'\t' | b'\n' | b'\r' | 0x0b | 0x0c | 0x1a | 0x1b);
    let controls = start.iter().filter(control).count();
    (start.contains(&0) || controls * 16 > start.len()).then_some("binary data")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_told_from_the_rest() {
        assert_eq!(binary_kind(b"sphere { 0, 1 }\r\n\x1a"), None);
        assert_eq!(binary_kind(b""), None);
        assert_eq!(binary_kind("// Dürer".as_bytes()), None);
        assert_eq!(binary_kind(b"// D\xfcrer"), None);
        assert_eq!(binary_kind(b"\x89PNG\r\n\x1a\n"), Some("a PNG picture"));
        assert_eq!(binary_kind(b"sphere\0"), Some("binary data"));
        assert_eq!(binary_kind(b"\x01\x02abc"), Some("binary data"));
        assert_eq!(binary_kind(b"\xff\xfes\0"), Some("text in UTF-16"));
    }
}
