//! All texts of a run, with one numbering of their bytes.

use super::{Disk, Files, LookedUpFiles, Lookups, ReadFiles, Recorder, Span};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Index that identifies a text in [`Sources`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FileId(pub u32);

/// A position in a source text, for people to read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Name of the source file as the user wrote it.
    pub file: String,
    /// Line of the position in the text, counted from 1.
    pub line: usize,
    /// Column of the position in characters, counted from 1.
    pub column: usize,
}

/// Formats as `file:line:column`, which editors read.
impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

struct File {
    name: String,
    path: Option<PathBuf>,
    text: String,
    base: usize,
    /// Byte offsets of the starts of the lines. Lines end with CR, LF or CRLF.
    lines: std::sync::OnceLock<Vec<u32>>,
}

/// Texts of a run and the storage they come from. A [`Span`] is a position in one particular `Sources`.
pub struct Sources {
    files: Recorder,
    texts: elsa::FrozenVec<Box<File>>,
}

/// Sources that read files from the disk.
impl Default for Sources {
    fn default() -> Self {
        Self::new(Arc::new(Disk))
    }
}

impl Sources {
    /// Creates an empty collection of texts, which reads files from `files`.
    pub fn new(files: Arc<dyn Files>) -> Self {
        Self { files: Recorder::new(files), texts: elsa::FrozenVec::new() }
    }

    /// Returns the storage that the run reads from and writes to.
    pub fn files(&self) -> &dyn Files {
        &self.files
    }

    /// Adds contents that were read elsewhere, such as standard input, to [`Sources::read_files`].
    pub fn record(&self, name: &Path, bytes: &[u8]) {
        self.files.record(name, bytes);
    }

    /// Returns the files that were read so far, texts and others, with hashes of their contents.
    pub fn read_files(&self) -> ReadFiles {
        self.files.read_files()
    }

    /// Forgets the look-ups of earlier runs, such as the frames before.
    pub fn begin_run(&self) {
        self.files.begin_run();
    }

    /// Returns the look-ups of files since [`Sources::begin_run`]: questions about paths, with their answers.
    pub fn lookups(&self) -> Lookups {
        self.files.lookups()
    }

    /// Returns the files that were read so far, and the look-ups since [`Sources::begin_run`].
    pub fn looked_up_files(&self) -> LookedUpFiles {
        LookedUpFiles { read: self.read_files(), lookups: self.lookups() }
    }

    /// Adds a text; returns `None` if all texts together would exceed 4 GB.
    pub fn add(&self, name: &str, path: Option<&Path>, text: String) -> Option<FileId> {
        let base = self.texts.iter().last().map_or(1, |f| f.base + f.text.len() + 1);
        u32::try_from(base + text.len() + 1).ok()?;
        let file = File { name: name.into(), path: path.map(Into::into), text, base, lines: Default::default() };
        self.texts.push(Box::new(file));
        Some(FileId(self.texts.len() as u32 - 1))
    }

    /// Returns the indices of all texts in the order of their addition.
    pub fn ids(&self) -> impl Iterator<Item = FileId> + use<> {
        (0..self.texts.len() as u32).map(FileId)
    }

    /// Returns the contents of a source text.
    pub fn text(&self, id: FileId) -> &str {
        self.texts.get(id.0 as usize).map_or("", |f| &f.text)
    }

    /// Returns the name of a text as the user wrote it.
    pub fn name(&self, id: FileId) -> &str {
        self.texts.get(id.0 as usize).map_or("", |f| &f.name)
    }

    /// Returns the path of a text; `None` for a text without a file, such as standard input.
    pub fn path(&self, id: FileId) -> Option<&Path> {
        self.texts.get(id.0 as usize).and_then(|f| f.path.as_deref())
    }

    /// Returns the global offset of a text's first byte: its position among the bytes of all texts.
    pub fn base(&self, id: FileId) -> usize {
        self.texts.get(id.0 as usize).map_or(0, |f| f.base)
    }

    /// Returns the text that contains a span, and the byte range in that text; `None` for [`Span::NONE`].
    pub fn locate(&self, span: Span) -> Option<(FileId, std::ops::Range<usize>)> {
        if span.is_none() {
            return None;
        }
        let (lo, hi) = (span.lo as usize, span.hi as usize);
        let (mut a, mut b) = (0, self.texts.len());
        while b - a > 1 {
            let mid = (a + b) / 2;
            if self.texts[mid].base <= lo { a = mid } else { b = mid }
        }
        let file = self.texts.get(a)?;
        let end = file.text.len();
        Some((FileId(a as u32), (lo - file.base).min(end)..hi.saturating_sub(file.base).min(end)))
    }

    /// Returns the part of a text that a span covers; empty for [`Span::NONE`].
    pub fn snippet(&self, span: Span) -> &str {
        match self.locate(span) {
            Some((id, range)) => self.text(id).get(range).unwrap_or(""),
            None => "",
        }
    }

    /// Returns the file, line and column of a span's first byte; `None` for [`Span::NONE`].
    pub fn place(&self, span: Span) -> Option<Place> {
        let (id, range) = self.locate(span)?;
        let file = self.texts.get(id.0 as usize)?;
        let lines = file.lines.get_or_init(|| line_starts(&file.text));
        let line = lines.partition_point(|&start| start as usize <= range.start) - 1;
        let column = file.text.get(lines[line] as usize..range.start).map_or(1, |s| s.chars().count() + 1);
        Some(Place { file: file.name.clone(), line: line + 1, column })
    }
}

fn line_starts(text: &str) -> Vec<u32> {
    let bytes = text.as_bytes();
    let ends = memchr::memchr2_iter(b'\n', b'\r', bytes);
    let starts = ends.filter(|&i| !(bytes[i] == b'\r' && bytes.get(i + 1) == Some(&b'\n'))).map(|i| i as u32 + 1);
    std::iter::once(0).chain(starts).collect()
}

/// Decodes bytes as UTF-8 without a byte-order mark or, if they are invalid UTF-8, as Latin-1.
pub fn decode_text(bytes: Vec<u8>) -> String {
    let bytes = match bytes.strip_prefix(b"\xef\xbb\xbf") {
        Some(rest) => rest.to_vec(),
        None => bytes,
    };
    String::from_utf8(bytes).unwrap_or_else(|e| e.as_bytes().iter().map(|&b| char::from(b)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_ending_counts_once() {
        let sources = Sources::default();
        let id = sources.add("a", None, "1\n2\r\n3\r4".into()).unwrap();
        let at = |i| sources.place(Span::new(sources.base(id) + i, sources.base(id) + i)).unwrap();
        assert_eq!([0, 2, 5, 7].map(|i| (at(i).line, at(i).column)), [(1, 1), (2, 1), (3, 1), (4, 1)]);
    }

    #[test]
    fn spans_identify_their_files() {
        let sources = Sources::default();
        sources.add("a", None, "abc".into()).unwrap();
        let b = sources.add("b", None, "xyz".into()).unwrap();
        let span = Span::new(sources.base(b) + 1, sources.base(b) + 2);
        assert_eq!(sources.snippet(span), "y");
        assert_eq!(sources.place(span).unwrap().file, "b");
    }

    #[test]
    fn invalid_utf_8_is_latin_1() {
        assert_eq!(decode_text(b"D\xfcrer".to_vec()), "Dürer");
    }
}
