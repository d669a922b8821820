//! Output of commands: messages go to stderr, data to stdout. A closed stream causes no panic.

use super::args::{Common, When};
use super::exit::{Exit, Failure, Result};
use super::povray::client_lines;
use super::povray::text_output::{Stream, TextFiles, TextOutput};
use super::summary::Count;
use crate::diagnostic::{Diagnostic, Severity, draw, file};
use crate::source::{Disk, Sources};
use serde_json::json;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Width of messages without a terminal, in columns.
const WIDTH: usize = 100;

/// Program whose format of output a command follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dialect {
    /// Output of durer's own commands.
    #[default]
    Durer,
    /// Output of POV-Ray's command line, with the lines that programs expect from POV-Ray.
    Povray,
}

/// Output of a command to stdout and stderr.
#[derive(Clone, Debug)]
pub struct Console {
    style: draw::Style,
    /// Numbers of errors and warnings that the console and its clones have printed since the last `take_message_count`.
    printed: Arc<Mutex<Count>>,
    /// True while one of several scenes is processed. The number of messages is then printed on the scene's line.
    among_several: bool,
    /// Program whose format of output the console follows.
    dialect: Dialect,
    /// Files that receive copies of what is printed.
    text_files: Arc<TextFiles>,
    /// Streams that are not printed.
    silent: Arc<[Stream]>,
    /// True if the command prints errors only.
    pub quiet: bool,
    /// True if the command's stderr is a terminal.
    pub terminal: bool,
}

impl Console {
    /// Creates the console for the options `--color` and `--quiet`.
    pub fn new(common: &Common) -> Self {
        let terminal = io::stderr().is_terminal();
        let plain = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty())
            || std::env::var_os("TERM").is_some_and(|t| t == "dumb");
        let fancy = match common.color {
            When::Auto => terminal && !plain,
            When::Always => true,
            When::Never => false,
        };
        let columns = terminal_size::terminal_size_of(io::stderr()).map(|(width, _)| usize::from(width.0));
        let style = draw::Style { fancy, ascii: false, width: columns.unwrap_or(WIDTH).max(40) };
        let dialect = Dialect::default();
        Self {
            style,
            printed: Arc::default(),
            among_several: false,
            dialect,
            text_files: Arc::default(),
            silent: Arc::default(),
            quiet: common.quiet,
            terminal,
        }
    }

    /// Creates the console that is used before the command line is parsed.
    pub fn before_arguments() -> Self {
        Self::new(&Common { quiet: false, color: When::Auto })
    }

    /// Returns this console with the output format of a program. In that of POV-Ray, messages are ASCII unless stderr is a
    /// terminal.
    pub fn with_dialect(self, dialect: Dialect) -> Self {
        let style = draw::Style { ascii: dialect == Dialect::Povray && !self.terminal, ..self.style };
        Self { dialect, style, ..self }
    }

    /// Returns this console with the text files and silent streams of POV-Ray's command line.
    ///
    /// # Errors
    /// If a text file cannot be created.
    pub fn with_text_output(self, output: &TextOutput) -> Result<Self> {
        let text_files = Arc::new(TextFiles::create(output)?);
        Ok(Self { text_files, silent: output.silent.as_slice().into(), ..self })
    }

    /// Returns the console for one of several scenes, each of which has a line with the number of its messages.
    pub fn for_scene_among_several(&self) -> Self {
        Self { among_several: true, ..self.clone() }
    }

    /// True if the command processes several scenes; a summary line then states the result of each scene.
    pub fn is_among_several(&self) -> bool {
        self.among_several
    }

    /// Returns the numbers of errors and warnings that this console and its clones have printed, and sets them to 0.
    pub fn take_message_count(&self) -> Count {
        std::mem::take(&mut self.printed.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn add_to_message_count(&self, count: Count) {
        let mut printed = self.printed.lock().unwrap_or_else(PoisonError::into_inner);
        *printed = *printed + count;
    }

    /// Writes a command's data to stdout.
    pub fn write_to_stdout(&self, bytes: impl AsRef<[u8]>) -> Result<()> {
        to_stdout(|out| out.write_all(bytes.as_ref()))
    }

    /// Writes data to stdout, as JSON on one line.
    pub fn write_json_to_stdout(&self, value: &impl serde::Serialize) -> Result<()> {
        to_stdout(|out| {
            serde_json::to_writer(&mut *out, value)?;
            out.write_all(b"\n")
        })
    }

    /// Writes a note to stderr as text of POV-Ray's render stream, unless `--quiet` is given or the stream is silent, and
    /// copies the note into the stream's files.
    pub fn info(&self, text: &str) {
        self.print_to_povray_stream(Stream::Render, text);
    }

    /// Writes the text of one of POV-Ray's streams to stderr, unless `--quiet` is given or the stream is silent, and copies
    /// the text into the stream's files in any case.
    pub fn print_to_povray_stream(&self, stream: Stream, text: &str) {
        self.text_files.write(stream, text);
        if !self.quiet && !self.silent.contains(&stream) {
            print_message(text);
        }
    }

    /// Copies a text into the files of a stream without printing it.
    pub fn copy_to_text_files(&self, stream: Stream, text: &str) {
        self.text_files.write(stream, text);
    }

    /// True if the console prints the lines that programs expect from POV-Ray.
    pub fn has_povray_lines(&self) -> bool {
        self.dialect == Dialect::Povray && !self.terminal
    }

    /// Writes a line that programs expect from POV-Ray to stderr, if [`Self::has_povray_lines`]; copies it to the text
    /// files in any case.
    pub fn print_line_for_povray_clients(&self, line: &str) {
        self.copy_to_text_files(Stream::Render, line);
        if self.has_povray_lines() {
            print_message(line);
        }
    }

    /// Writes POV-Ray's statistics of a picture to stderr, if [`Self::has_povray_lines`] and unless `-GA` or `-GS` silences
    /// them; copies them to the text files in any case.
    pub fn print_povray_statistics(&self, text: &str) {
        if self.has_povray_lines() {
            self.print_to_povray_stream(Stream::Statistics, text);
        } else {
            self.copy_to_text_files(Stream::Statistics, text);
        }
    }

    /// Formats the diagnostics that the console prints for a person, errors first, and adds their number to the console's
    /// count. If there are several, their number is the last line, except for a scene among several.
    pub fn format_and_count(&self, sources: &Sources, diagnostics: &[Diagnostic]) -> String {
        let of = |severity| move |d: &&Diagnostic| d.severity == severity;
        let errors = diagnostics.iter().filter(of(Severity::Error));
        let warnings = diagnostics.iter().filter(of(Severity::Warning)).filter(|_| self.prints_warnings());
        let wanted: Vec<_> = errors.chain(warnings).collect();
        let povray_line =
            |d| if self.has_povray_lines() { client_lines::povray_diagnostic_line(sources, d) } else { String::new() };
        let mut text: String =
            wanted.iter().map(|d| povray_line(d) + &draw::render(d, sources, self.style) + "\n").collect();
        let count = Count::of(wanted.iter().copied());
        self.add_to_message_count(count);
        if wanted.len() > 1 && !self.among_several {
            text += &format!("{count}\n");
        }
        if self.style.ascii { client_lines::replace_message_symbols(&text) } else { text }
    }

    /// Writes diagnostics as rendered by [`Console::format_and_count`] to stderr, and copies them to the text files.
    pub fn report(&self, sources: &Sources, diagnostics: &[Diagnostic]) {
        self.copy_diagnostics_to_files(sources, diagnostics);
        print_message(&self.format_and_count(sources, diagnostics));
    }

    /// True if the command prints warnings.
    fn prints_warnings(&self) -> bool {
        !self.quiet && !self.silent.contains(&Stream::Warning)
    }

    /// Copies diagnostics into the text files, without colours.
    fn copy_diagnostics_to_files(&self, sources: &Sources, diagnostics: &[Diagnostic]) {
        if self.text_files.is_empty() {
            return;
        }
        for d in diagnostics {
            let stream = match d.severity {
                Severity::Error => Stream::Fatal,
                Severity::Warning => Stream::Warning,
            };
            let style = draw::Style { fancy: false, ascii: false, width: WIDTH };
            let text = client_lines::povray_diagnostic_line(sources, d) + &draw::render(d, sources, style) + "\n";
            self.copy_to_text_files(stream, &text);
        }
    }

    /// Writes all diagnostics to stdout for programs, one JSON object a line, also warnings with `--quiet`.
    pub fn report_json_to_stdout(&self, sources: &Sources, diagnostics: &[Diagnostic]) -> Result<()> {
        diagnostics.iter().try_for_each(|d| self.write_json_to_stdout(&as_json(sources, d)))
    }

    /// Writes diagnostics to stdout for editors, one a line: `a.scene:3:7: error[E0204]: message`. With `--quiet`, only errors.
    pub fn report_short_to_stdout(&self, sources: &Sources, diagnostics: &[Diagnostic]) -> Result<()> {
        let wanted = |d: &&Diagnostic| !self.quiet || d.severity == Severity::Error;
        let lines: String = diagnostics.iter().filter(wanted).map(|d| d.line(sources) + "\n").collect();
        self.write_to_stdout(lines)
    }

    /// Prints the reason of a failure, unless it is printed already, and returns the exit code. The texts of `--help` and
    /// `--version` are failures, too, with the exit code of success.
    pub fn print_failure(&self, failure: Failure) -> Exit {
        match failure {
            Failure::Usage(error) => {
                let _ = error.print();
                if error.use_stderr() { Exit::Usage } else { Exit::Fine }
            }
            other => {
                if let Failure::Fault(fault) = &other {
                    self.copy_diagnostics_to_files(&Sources::default(), std::slice::from_ref(fault));
                }
                let (exit, text) = self.exit_and_text_of(&Sources::default(), other);
                print_message(&text);
                exit
            }
        }
    }

    /// Returns the exit code of a failure, and the text to print; empty if the reason is printed already. Counts the message.
    pub fn exit_and_text_of(&self, sources: &Sources, failure: Failure) -> (Exit, String) {
        match failure {
            Failure::Reported(exit) => (exit, String::new()),
            Failure::BrokenPipe => (Exit::Fine, String::new()),
            Failure::Fault(fault) => {
                (Exit::of(fault.code), self.format_and_count(sources, std::slice::from_ref(&fault)))
            }
            Failure::Usage(error) => (Exit::Usage, error.to_string()),
        }
    }
}

fn to_stdout(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<()> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    write(&mut out).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::BrokenPipe,
        _ => Failure::Fault(Box::new(file::unwritable(&Disk, Path::new("standard output"), &error))),
    })
}

/// Writes to stderr; ignores a closed stream.
pub fn print_message(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Returns a diagnostic as JSON with the fields `code severity message file line column end{line column} help labels
/// trace`; a missing position is null.
fn as_json(sources: &Sources, d: &Diagnostic) -> serde_json::Value {
    let place = sources.place(d.span());
    let place = place.as_ref();
    let end = sources.place(d.span().end());
    let label = |l: &crate::diagnostic::Label| {
        let at = sources.place(l.span);
        let at = at.as_ref();
        json!({"text": l.text, "file": at.map(|p| &p.file), "line": at.map(|p| p.line), "column": at.map(|p| p.column)})
    };
    json!({
        "code": d.code.0,
        "severity": d.severity.name(),
        "message": d.message,
        "file": place.map(|p| &p.file),
        "line": place.map(|p| p.line),
        "column": place.map(|p| p.column),
        "end": end.map(|p| json!({"line": p.line, "column": p.column})),
        "help": d.help,
        "labels": d.labels.iter().map(label).collect::<Vec<_>>(),
        "trace": d.trace.iter().map(label).collect::<Vec<_>>(),
    })
}
