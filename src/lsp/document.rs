//! An open document.

use super::diagnostics::EditorDiagnostic;
use super::text::Text;
use crate::diagnostic::Diagnostic;
use crate::math::cancel::CancelToken;
use crate::syntax::{Outline, tokens_of};
use lsp_types::{DiagnosticSeverity, Uri};
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::Arc;
use std::time::Instant;

/// Global offset of a document's first byte, as of the only text in `Sources`; 0 would mean no position.
pub const BASE: usize = 1;
/// Largest length of a text that the language server checks, in bytes.
pub const MAX_TEXT: usize = 2 << 20;

/// A scene document that is open in the editor.
pub struct Document {
    /// Address of the document in the editor.
    pub uri: Uri,
    /// Path of the document, if the document is a file.
    pub path: Option<PathBuf>,
    /// Version of the document's text in the editor.
    pub version: i32,
    /// Present text of the open document.
    pub text: Text,
    /// Outline of the document's present text: its tokens, bracket pairs, declarations and uses of names.
    pub outline: Arc<Outline>,
    /// Syntax faults of the open document.
    pub faults: Vec<Diagnostic>,
    /// Time of the document's next background run; `None` if no run is due.
    pub due: Option<Instant>,
    /// Token that ends the document's present background run.
    pub cancel: Option<CancelToken>,
}

impl Document {
    /// Creates a document that the editor has opened.
    pub fn new(uri: Uri, version: i32, text: String) -> Self {
        let path = path_of(&uri);
        let mut new = Self {
            uri,
            path,
            version,
            text: Text::new(text),
            outline: Arc::default(),
            faults: vec![],
            due: None,
            cancel: None,
        };
        new.rebuild_outline();
        new
    }

    /// Sets the version of the document, and rebuilds outline and faults for its text, which the caller has changed.
    pub fn update_to_version(&mut self, version: i32) {
        self.version = version;
        self.rebuild_outline();
    }

    /// Sets the outline and the faults of the text's tokens; both are empty if the text is too large. Faults that only the
    /// syntax tree shows are found by a run.
    fn rebuild_outline(&mut self) {
        if self.is_too_large() {
            (self.outline, self.faults) = (Arc::default(), vec![]);
            return;
        }
        let text = self.text.as_str();
        let (tokens, faults) = tokens_of(text, BASE);
        self.outline = Arc::new(Outline::new(text, &tokens));
        self.faults = faults;
    }

    /// True if the text is longer than [`MAX_TEXT`], and so has no service.
    pub fn is_too_large(&self) -> bool {
        self.text.as_str().len() > MAX_TEXT
    }

    /// Returns the notice that the document has no service; `None` unless [`Self::is_too_large`].
    pub fn too_large_notice(&self) -> Option<EditorDiagnostic> {
        self.is_too_large().then(|| EditorDiagnostic {
            severity: Some(DiagnosticSeverity::INFORMATION),
            source: Some("durer".into()),
            message: self.too_large_message(),
            ..EditorDiagnostic::default()
        })
    }

    /// Returns the text of the notice that the document has no service.
    pub fn too_large_message(&self) -> String {
        let megabytes = self.text.as_str().len() as f64 / f64::from(1 << 20);
        let limit = MAX_TEXT >> 20;
        format!(
            "this text has {megabytes:.1} MB: the language server checks only texts of up to {limit} MB\n\
             help: `durer check` and `durer render` take longer texts"
        )
    }

    /// True if the document is a scene that can be run: not too large, and without the extension of an include file or INI
    /// file.
    pub fn is_scene(&self) -> bool {
        if self.is_too_large() {
            return false;
        }
        let ending = self.path.as_deref().and_then(Path::extension).and_then(|ending| ending.to_str());
        !matches!(ending, Some("inc" | "INC" | "ini" | "mcr"))
    }

    /// Returns the folder that contains the document; `.` for a document that is not a file.
    pub fn folder(&self) -> PathBuf {
        self.path.as_deref().and_then(Path::parent).map_or_else(|| PathBuf::from("."), Path::to_path_buf)
    }
}

/// Returns the path of a `file:` address; `None` for other addresses.
pub fn path_of(uri: &Uri) -> Option<PathBuf> {
    let rest = uri.as_str().strip_prefix("file://")?;
    // The address may contain a host's name before the path.
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

/// Returns the `file:` address of a path; `None` if the path is not Unicode.
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
    fn addresses_and_paths_are_converted() {
        let uri = uri_of(Path::new("/tmp/a b/ü#.pov")).unwrap();
        assert_eq!(uri.as_str(), "file:///tmp/a%20b/%C3%BC%23.pov");
        assert_eq!(path_of(&uri).unwrap(), Path::new("/tmp/a b/ü#.pov"));
        assert_eq!(path_of(&Uri::from_str("untitled:1").unwrap()), None);
        assert_eq!(path_of(&Uri::from_str("file://host/%e4b").unwrap()), None);
        assert_eq!(path_of(&Uri::from_str("file://localhost/a%25").unwrap()), Some("/a%".into()));
    }
}
