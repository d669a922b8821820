//! The command line: one file for each command. Only here is anything printed, and only here does the program end.

mod animation;
mod args;
mod canvas;
mod check;
mod choices;
mod completions;
mod console;
mod deps;
mod dump;
mod exit;
mod explain;
mod film;
mod fmt;
mod inputs;
mod interrupt;
mod journal;
mod keeping;
#[cfg(feature = "lsp")]
mod lsp;
pub mod manual;
mod memory;
mod new;
mod overlay;
mod pick;
mod povray;
mod progress;
mod query;
mod render;
mod session;
mod stats;
mod summary;
mod target;
pub mod test;
mod unknown;
mod values;
#[cfg(feature = "watch")]
mod watch;
mod watcher;

use crate::diagnostic::Severity;
use crate::source::{ReadFiles, Sources};
use args::Command;
pub use args::{Cli, Common};
use clap::CommandFactory;
use console::Console;
pub use exit::{Exit, Failure, Result};
pub use povray::ini_names;
use std::ffi::OsString;
use std::process::ExitCode;
use std::sync::LazyLock;

/// What clap knows of the command line, put together once.
fn commands() -> &'static clap::Command {
    static COMMAND: LazyLock<clap::Command> = LazyLock::new(Cli::command);
    &COMMAND
}

/// Runs the program with these words, the first being its own name.
pub fn main(words: Vec<OsString>) -> ExitCode {
    interrupt::listen();
    let exit = crate::on_big_stack(|| {
        let (console, cli, ini_files) = match understand(words) {
            Ok(understood) => understood,
            Err(failure) => return Console::plain().tell(failure),
        };
        dispatch(&console, &cli.command, ini_files).unwrap_or_else(|failure| console.tell(failure))
    });
    ExitCode::from(exit as u8)
}

/// The command line in our own words, and the INI files that it was read from; POV-Ray's words are translated first.
fn understand(words: Vec<OsString>) -> Result<(Console, Cli, ReadFiles)> {
    unknown::check(&words)?;
    let sources = Sources::default();
    let povray::Translated { words, animation, mut diagnostics, idle } = povray::translate(&sources, words);
    if diagnostics.iter().any(|d| d.severity == Severity::Error) {
        return Err(overlay::tell(&Console::plain(), &sources, &diagnostics));
    }
    let cli = overlay::parse(words, animation).map_err(|e| Failure::Usage(Box::new(e)))?;
    let console = Console::new(&cli.common);
    let tells_all = match &cli.command {
        Command::Render(args) => !args.warn.is_empty(),
        Command::Check(args) => args.warn.contains(&args::Warn::Options),
        _ => false,
    };
    if tells_all {
        diagnostics.extend(idle);
    }
    console.report(&sources, &diagnostics);
    Ok((console, cli, sources.read_files()))
}

fn dispatch(console: &Console, command: &Command, ini_files: ReadFiles) -> Result {
    match command {
        Command::Render(args) => render::run(console, args, ini_files),
        Command::Check(args) => check::run(console, args),
        Command::Pick(args) => pick::run(console, args),
        Command::Test(args) => test::run(console, args),
        Command::Fmt(args) => fmt::run(console, args),
        Command::New(args) => new::run(console, args),
        #[cfg(feature = "watch")]
        Command::Watch(args) => watch::run(console, args),
        Command::Query(args) => query::run(console, args),
        #[cfg(feature = "lsp")]
        Command::Lsp(args) => lsp::run(args),
        Command::Explain(args) => explain::run(console, args),
        Command::Completions(args) => completions::run(console, args),
    }
}
