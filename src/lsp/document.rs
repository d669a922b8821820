//! An open text, and what is known of it.

use super::scan::Scan;
use super::text::Text;
use crate::diagnostic::Diagnostic;
use crate::syntax::tokens_of;
use lsp_types::{TextDocumentContentChangeEvent, Uri};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

/// The global offset of a text's first byte: 0 would be no place.
pub const BASE: usize = 1;

/// An open text.
pub struct Document {
    /// As the editor calls it.
    pub uri: Uri,
    /// Where it lies, if it does.
    pub path: Option<PathBuf>,
    /// Of the editor's.
    pub version: i32,
    /// What stands in it now.
    pub text: Text,
    /// Its tokens and names.
    pub scan: Arc<Scan>,
    /// What is wrong with the text itself.
    pub faults: Vec<Diagnostic>,
    /// When it is to be run.
    pub due: Option<Instant>,
    /// Stops the run that goes on.
    pub stop: Option<Arc<AtomicBool>>,
}

impl Document {
    /// A text that was opened.
    pub fn new(uri: Uri, version: i32, text: String) -> Self {
        let path = path_of(&uri);
        let mut new = Self {
            uri,
            path,
            version,
            text: Text::new(text),
            scan: Arc::default(),
            faults: vec![],
            due: None,
            stop: None,
        };
        new.look();
        new
    }

    /// Makes changes; tells of each what it took away and how many bytes it put there.
    pub fn change(&mut self, version: i32, changes: Vec<TextDocumentContentChangeEvent>) -> Vec<(Range<usize>, usize)> {
        let made = changes.into_iter().map(|change| self.text.change(change)).collect();
        self.version = version;
        self.look();
        made
    }

    /// Reads it. (All that the tree could tell besides, the run tells.)
    fn look(&mut self) {
        let text = self.text.as_str();
        let (tokens, faults) = tokens_of(text, BASE);
        self.scan = Arc::new(Scan::of(text, BASE, &tokens));
        self.faults = faults;
    }

    /// Is it a scene by itself? Include files are read by others.
    pub fn is_scene(&self) -> bool {
        let ending = self.path.as_deref().and_then(Path::extension).and_then(|ending| ending.to_str());
        !matches!(ending, Some("inc" | "INC" | "ini" | "mcr"))
    }

    /// The folder it lies in.
    pub fn folder(&self) -> PathBuf {
        self.path.as_deref().and_then(Path::parent).map_or_else(|| PathBuf::from("."), Path::to_path_buf)
    }
}

/// The file that a `file:` address names.
pub fn path_of(uri: &Uri) -> Option<PathBuf> {
    let rest = uri.as_str().strip_prefix("file://")?;
    // A host's name may stand there; ours is empty.
    let path = &rest[rest.find('/')?..];
    let mut bytes = vec![];
    let mut at = 0;
    while at < path.len() {
        let code = path.get(at..at + 3).and_then(|code| code.strip_prefix('%'));
        match code.and_then(|code| u8::from_str_radix(code, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                at += 3;
            }
            None => {
                bytes.push(path.as_bytes()[at]);
                at += 1;
            }
        }
    }
    let text = String::from_utf8(bytes).ok()?;
    // `/C:/scenes` on Windows.
    let drive = cfg!(windows) && text.as_bytes().get(2) == Some(&b':');
    Some(PathBuf::from(if drive { &text[1..] } else { &text }))
}

/// The address of a file.
pub fn uri_of(path: &Path) -> Option<Uri> {
    let path = std::path::absolute(path).ok()?;
    let text = path.to_str()?.replace('\\', if cfg!(windows) { "/" } else { "\\" });
    let mut out = String::from(if text.starts_with('/') { "file://" } else { "file:///" });
    for byte in text.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'-' | b'_' | b'.' | b'~' => out.push(char::from(byte)),
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    Uri::from_str(&out).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_and_paths() {
        let uri = uri_of(Path::new("/tmp/a b/ü#.pov")).unwrap();
        assert_eq!(uri.as_str(), "file:///tmp/a%20b/%C3%BC%23.pov");
        assert_eq!(path_of(&uri).unwrap(), Path::new("/tmp/a b/ü#.pov"));
        assert_eq!(path_of(&Uri::from_str("untitled:1").unwrap()), None);
        assert_eq!(path_of(&Uri::from_str("file://host/%e4b").unwrap()), None);
        assert_eq!(path_of(&Uri::from_str("file://localhost/a%25").unwrap()), Some("/a%".into()));
    }
}
