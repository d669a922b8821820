//! Reads text files, and refuses pictures, archives and programs.

use super::{Files, decode_text};
use std::io;
use std::path::Path;

/// Reason for which a text was not read.
#[derive(Debug)]
pub enum ReadError {
    /// Reading failed because the operating system reported an error.
    Io(io::Error),
    /// Reading failed because the path is a folder.
    Folder,
    /// The file is no text. The description says what it is, for example `a PNG picture`.
    NotText(&'static str),
}

impl From<io::Error> for ReadError {
    fn from(error: io::Error) -> Self {
        ReadError::Io(error)
    }
}

/// Returns the text of a file in UTF-8 or Latin-1 (see [`decode_text`]).
///
/// # Errors
/// If the file cannot be read or is no text.
pub fn read_text(files: &dyn Files, path: &Path) -> Result<String, ReadError> {
    if files.is_folder(path) {
        return Err(ReadError::Folder);
    }
    text_of(files.read(path)?)
}

/// Decodes bytes as a text.
///
/// # Errors
/// If the bytes are no text.
pub fn text_of(bytes: Vec<u8>) -> Result<String, ReadError> {
    match binary_kind(&bytes) {
        Some(kind) => Err(ReadError::NotText(kind)),
        None => Ok(decode_text(bytes)),
    }
}

/// Descriptions of files that are mistaken for scenes, by their first bytes.
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

/// Number of bytes at a file's start that are examined to distinguish texts from other files.
const EXAMINED: usize = 8192;

/// Describes a file that is no text; `None` for a text. A file is no text if it has a known signature, a zero byte near
/// its start, or more than one control character in sixteen bytes.
fn binary_kind(bytes: &[u8]) -> Option<&'static str> {
    if let Some((_, kind)) = SIGNATURES.iter().find(|(start, _)| bytes.starts_with(start)) {
        return Some(kind);
    }
    let start = &bytes[..bytes.len().min(EXAMINED)];
    let control = |b: &&u8| **b < 32 && !matches!(**b, b'\t' | b'\n' | b'\r' | 0x0b | 0x0c | 0x1a | 0x1b);
    let controls = start.iter().filter(control).count();
    (start.contains(&0) || controls * 16 > start.len()).then_some("binary data")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn binary_files_are_recognized() {
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
