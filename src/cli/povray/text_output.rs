//! POV-Ray's streams of text: which of them are printed, and into which files they are copied (manual, "Text Output").

use super::client_lines::BANNER;
use crate::cli::exit::Result;
use crate::diagnostic::{Diagnostic, codes, file};
use crate::source::{Disk, OpenError, Span, open_or_create_regular};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Kind of text that POV-Ray prints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stream {
    /// All text; the other streams are parts of this one.
    All,
    /// Text that the scene prints.
    Debug,
    /// Stream of the error messages, as one of POV-Ray's kinds of text.
    Fatal,
    /// Notes about the progress of the command.
    Render,
    /// Times and memory of each picture.
    Statistics,
    /// Stream of the warnings, as one of POV-Ray's kinds of text.
    Warning,
}

impl Stream {
    /// Returns POV-Ray's word for the stream, as in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Self::All => "whole",
            Self::Debug => "debug",
            Self::Fatal => "fatal",
            Self::Render => "render",
            Self::Statistics => "statistics",
            Self::Warning => "warning",
        }
    }

    /// Returns the name of the stream's file if an option asks for the file without naming it.
    pub fn default_file(self) -> &'static str {
        match self {
            Self::All => "alltext.out",
            Self::Debug => "debug.out",
            Self::Fatal => "fatal.out",
            Self::Render => "render.out",
            Self::Statistics => "stats.out",
            Self::Warning => "warning.out",
        }
    }
}

/// Text output that POV-Ray's options ask for.
#[derive(Clone, Debug, Default)]
pub struct TextOutput {
    /// Streams that are copied to files, each with its file, in the order of the options.
    pub files: Vec<(Stream, PathBuf)>,
    /// True to append to the files of an earlier run (`Append_File`).
    pub appends: bool,
    /// Streams that are not printed. Errors are always printed.
    pub silent: Vec<Stream>,
    /// Path and contents of the INI file with all settings (`Create_Ini`).
    pub ini: Option<(PathBuf, String)>,
}

/// Open files that receive copies of streams.
#[derive(Debug, Default)]
pub struct TextFiles(Vec<(Stream, File)>);

impl TextFiles {
    /// Creates the text files and the INI file.
    ///
    /// # Errors
    /// E0004 if a file cannot be created, or if its name belongs to a file of another origin.
    pub fn create(output: &TextOutput) -> Result<Self> {
        if let Some((path, text)) = &output.ini {
            let mut file = open_own_file(path, false)?;
            file.write_all(text.as_bytes()).map_err(|error| unwritable(path, &error))?;
        }
        let open = |(stream, path): &(Stream, PathBuf)| Ok((*stream, open_own_file(path, output.appends)?));
        output.files.iter().map(open).collect::<Result<_>>().map(Self)
    }

    /// True if no stream of text is copied to a file.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Copies a text into the files of its stream and of all streams. A file that cannot be written stays incomplete: the
    /// text is printed, too.
    pub fn write(&self, stream: Stream, text: &str) {
        for (_, file) in self.0.iter().filter(|(of, _)| [Stream::All, stream].contains(of)) {
            let _ = (&*file).write_all(text.as_bytes());
        }
    }
}

/// First line of the text files and INI files that durer writes, as a comment of INI files. Only files with this line
/// are replaced.
fn ownership_mark_line() -> String {
    format!("; {BANNER}")
}

/// Creates a file, or opens one that durer wrote before, and writes the first line. The old contents are removed, or kept
/// if `appends`.
fn open_own_file(path: &Path, appends: bool) -> Result<File> {
    let is_hidden = path.file_name().is_none_or(|name| name.to_string_lossy().starts_with('.'));
    if is_hidden {
        return Err(foreign_file_error(path).into());
    }
    let mut file = match open_or_create_regular(path) {
        Ok(file) => file,
        Err(OpenError::Io(error)) => return Err(unwritable(path, &error).into()),
        _ => return Err(foreign_file_error(path).into()),
    };
    let prepare = |file: &mut File| -> io::Result<bool> {
        let mut start = vec![];
        file.take(ownership_mark_line().len() as u64).read_to_end(&mut start)?;
        let is_own = start == ownership_mark_line().as_bytes();
        if !is_own && !start.is_empty() {
            return Ok(false);
        }
        if appends && is_own {
            file.seek(SeekFrom::End(0))?;
            return Ok(true);
        }
        file.set_len(0)?;
        file.seek(SeekFrom::Start(0))?;
        file.write_all(ownership_mark_line().as_bytes())?;
        Ok(true)
    };
    match prepare(&mut file) {
        Ok(true) => Ok(file),
        Ok(false) => Err(foreign_file_error(path).into()),
        Err(error) => Err(unwritable(path, &error).into()),
    }
}

fn unwritable(path: &Path, error: &io::Error) -> Box<Diagnostic> {
    Box::new(file::unwritable(&Disk, path, error))
}

/// Returns the error for a file that durer did not write, and therefore does not replace.
fn foreign_file_error(path: &Path) -> Box<Diagnostic> {
    let text = format!("`{}` was not written by durer, and is not replaced", path.display());
    Box::new(Diagnostic::new(codes::FILE_UNWRITABLE, Span::NONE, text).help("move it away, or choose another name"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_files_replace_only_files_of_durer() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let output = |name: &str, appends| TextOutput {
            files: vec![(Stream::All, path(name)), (Stream::Debug, path("debug.out"))],
            appends,
            ..TextOutput::default()
        };
        let write = |appends, text: &str| {
            TextFiles::create(&output("all.txt", appends)).unwrap().write(Stream::Warning, text);
            std::fs::read_to_string(path("all.txt")).unwrap()
        };
        assert_eq!(write(false, "one\n"), ownership_mark_line() + "one\n");
        assert_eq!(write(false, "two\n"), ownership_mark_line() + "two\n");
        assert_eq!(write(true, "three\n"), ownership_mark_line() + "two\nthree\n");
        assert_eq!(std::fs::read_to_string(path("debug.out")).unwrap(), ownership_mark_line());
        std::fs::write(path("notes.txt"), "mine").unwrap();
        for name in ["notes.txt", ".hidden", "nowhere/all.txt"] {
            assert!(TextFiles::create(&output(name, false)).is_err(), "{name}");
        }
        assert_eq!(std::fs::read_to_string(path("notes.txt")).unwrap(), "mine");
    }

    #[cfg(unix)]
    #[test]
    fn text_files_follow_no_links() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::write(path("other"), "").unwrap();
        std::os::unix::fs::symlink(path("other"), path("link")).unwrap();
        let files = vec![(Stream::All, path("link"))];
        assert!(TextFiles::create(&TextOutput { files, ..TextOutput::default() }).is_err());
        assert_eq!(std::fs::read_to_string(path("other")).unwrap(), "");
    }
}
