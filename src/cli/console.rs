//! Messages go to stderr, data to stdout; neither panics when the other end is closed.

use super::args::{Common, When};
use super::exit::{Exit, Failure, Result};
use super::summary::Count;
use crate::diagnostic::{Diagnostic, Severity, draw, file};
use crate::source::{Disk, Sources};
use serde_json::json;
use std::cell::Cell;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::rc::Rc;

/// Where messages are as wide as no terminal says.
const WIDTH: usize = 100;

/// How we talk.
#[derive(Clone, Debug)]
pub struct Console {
    style: draw::Style,
    /// What was told so far; its clones share it.
    told: Rc<Cell<Count>>,
    /// One of several scenes is being told of: the counts stand on its line.
    among_several: bool,
    /// Errors only.
    pub quiet: bool,
    /// Is someone watching stderr?
    pub terminal: bool,
}

impl Console {
    /// As `--color` and `--quiet` say.
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
        let style = draw::Style { fancy, width: columns.unwrap_or(WIDTH).max(40) };
        Self { style, told: Rc::default(), among_several: false, quiet: common.quiet, terminal }
    }

    /// Before the command line is understood.
    pub fn plain() -> Self {
        Self::new(&Common { quiet: false, color: When::Auto })
    }

    /// For several scenes, each of which has a line of its own that counts its messages.
    pub fn among_several(&self) -> Self {
        Self { among_several: true, ..self.clone() }
    }

    /// Does another line tell what becomes of a scene?
    pub fn is_among_several(&self) -> bool {
        self.among_several
    }

    /// How many messages were told since this was asked last.
    pub fn take_count(&self) -> Count {
        self.told.take()
    }

    /// Data, to stdout.
    pub fn data(&self, bytes: impl AsRef<[u8]>) -> Result<()> {
        to_stdout(|out| out.write_all(bytes.as_ref()))
    }

    /// Data as JSON on one line, to stdout.
    pub fn json(&self, value: &impl serde::Serialize) -> Result<()> {
        to_stdout(|out| {
            serde_json::to_writer(&mut *out, value)?;
            out.write_all(b"\n")
        })
    }

    /// A message, to stderr as it is, unless `--quiet`.
    pub fn note(&self, text: &str) {
        if !self.quiet {
            say(text);
        }
    }

    /// Diagnostics as a person reads them, errors first, and how many there were.
    pub fn text(&self, sources: &Sources, diagnostics: &[Diagnostic]) -> String {
        let wanted = |severity| move |d: &&Diagnostic| d.severity == severity;
        let errors = diagnostics.iter().filter(wanted(Severity::Error));
        let warnings = diagnostics.iter().filter(wanted(Severity::Warning)).filter(|_| !self.quiet);
        let told: Vec<_> = errors.chain(warnings).collect();
        let mut text: String = told.iter().map(|d| draw::render(d, sources, self.style) + "\n").collect();
        let count = Count::of(told.iter().copied());
        self.told.set(self.told.get().and(count));
        if told.len() > 1 && !self.among_several {
            text += &format!("{count}\n");
        }
        text
    }

    /// [`Console::text`] to stderr.
    pub fn report(&self, sources: &Sources, diagnostics: &[Diagnostic]) {
        say(&self.text(sources, diagnostics));
    }

    /// Diagnostics for programs, one JSON object a line, to stdout.
    pub fn report_json(&self, sources: &Sources, diagnostics: &[Diagnostic]) -> Result<()> {
        diagnostics.iter().try_for_each(|d| self.json(&as_json(sources, d)))
    }

    /// Diagnostics for editors, one a line, to stdout: `a.scene:3:7: error[E0204]: message`.
    pub fn report_short(&self, sources: &Sources, diagnostics: &[Diagnostic]) -> Result<()> {
        let wanted = |d: &&Diagnostic| !self.quiet || d.severity == Severity::Error;
        let lines: String = diagnostics.iter().filter(wanted).map(|d| d.line(sources) + "\n").collect();
        self.data(lines)
    }

    /// Tells why a command failed.
    pub fn tell(&self, failure: Failure) -> Exit {
        match failure {
            Failure::Usage(error) => {
                let _ = error.print();
                if error.use_stderr() { Exit::Usage } else { Exit::Fine }
            }
            other => {
                let (exit, text) = self.text_of(&Sources::default(), other);
                say(&text);
                exit
            }
        }
    }

    /// The exit code of a failure, and what is to be told.
    pub fn text_of(&self, sources: &Sources, failure: Failure) -> (Exit, String) {
        match failure {
            Failure::Told(exit) => (exit, String::new()),
            Failure::NobodyListens => (Exit::Fine, String::new()),
            Failure::Fault(fault) => (Exit::of(fault.code), self.text(sources, std::slice::from_ref(&fault))),
            Failure::Usage(error) => (Exit::Usage, error.to_string()),
        }
    }
}

fn to_stdout(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<()> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    write(&mut out).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::NobodyListens,
        _ => Failure::Fault(Box::new(file::unwritable(&Disk, Path::new("standard output"), &error))),
    })
}

/// To stderr; when nobody listens there is nobody to tell.
pub fn say(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// `code severity message file line column end{line column} help labels trace`; the place is null where there is none.
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
