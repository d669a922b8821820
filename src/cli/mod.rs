//! The command line, with a file or a folder for each command. Only this module prints and ends the program.

mod allocator;
mod animation;
mod args;
mod check;
mod completions;
mod confinement;
mod console;
mod created_files;
mod exit;
mod explain;
mod fmt;
#[cfg(feature = "fuzzing")]
pub mod fuzzing;
mod inputs;
mod interrupt;
mod journal;
#[cfg(feature = "lsp")]
mod lsp;
pub mod manual;
mod memory;
mod new;
mod overlay;
mod pick;
mod povray;
mod prepare;
mod query;
mod render;
mod session;
mod shard;
mod summary;
pub mod test;
mod unknown;
#[cfg(feature = "watch")]
mod watch;

use crate::diagnostic::Severity;
use crate::source::Sources;
pub use allocator::Metered;
use args::Command;
pub use args::{Cli, Common};
use clap::{CommandFactory, Parser};
use console::{Console, Dialect, print_message};
pub use exit::{Exit, Failure, Result};
use povray::client_lines;
pub use povray::ini_names;
use render::RenderContext;
use std::ffi::OsString;
use std::process::ExitCode;
use std::sync::LazyLock;

/// Returns clap's description of the command line, which is computed once.
fn commands() -> &'static clap::Command {
    static COMMAND: LazyLock<clap::Command> = LazyLock::new(Cli::command);
    &COMMAND
}

/// Runs the program with its name and the words of its command line.
pub fn main(program_and_words: Vec<OsString>) -> ExitCode {
    interrupt::listen();
    let exit = crate::on_big_stack(|| {
        let mut console = Console::before_arguments();
        let exit = match parse_command_line(program_and_words, &mut console) {
            Ok((command, context)) => dispatch(&console, &command, context),
            Err(failure) => Err(failure),
        };
        let exit = exit.unwrap_or_else(|failure| console.print_failure(failure));
        console.print_line_for_povray_clients(client_lines::ending_lines(exit));
        exit
    });
    ExitCode::from(exit.number())
}

/// Parses the command line, which begins with the program's name, after translating POV-Ray's options. Configures the
/// console, and reports the warnings about POV-Ray's options. The returned context holds the inputs of a render for which
/// durer has no option, such as the animation that POV-Ray's options request.
fn parse_command_line(program_and_words: Vec<OsString>, console: &mut Console) -> Result<(Command, RenderContext)> {
    if !povray::is_named_povray(&program_and_words) {
        unknown::check_command_name(&program_and_words)?;
    }
    if povray::asks_version(&program_and_words) {
        print_message(client_lines::BANNER);
    }
    // POV-Ray prints its lines with `-GA`, too.
    let is_quiet = program_and_words.iter().any(|word| word == "-q" || word == "--quiet");
    let sources = Sources::default();
    let povray::Translated { words, animation, mut diagnostics, idle, is_povray_line, text_output } =
        povray::translate(&sources, program_and_words);
    let dialect = if is_povray_line && !is_quiet { Dialect::Povray } else { Dialect::Durer };
    if is_povray_line {
        exit::use_povray_codes();
        *console = Console::before_arguments().with_dialect(dialect);
    }
    if diagnostics.iter().any(|d| d.severity == Severity::Error) {
        return Err(overlay::report_as_failure(console, &sources, &diagnostics));
    }
    let Cli { common, command } = Cli::try_parse_from(words).map_err(|e| Failure::Usage(Box::new(e)))?;
    *console = Console::new(&common).with_dialect(dialect);
    *console = console.clone().with_text_output(&text_output)?;
    console.print_line_for_povray_clients(client_lines::BANNER);
    let warns_of_idle = match &command {
        Command::Render(args) => !args.warn.is_empty(),
        Command::Check(args) => args.warn.contains(&args::Warn::Options),
        _ => false,
    };
    if warns_of_idle {
        diagnostics.extend(idle);
    }
    console.report(&sources, &diagnostics);
    Ok((command, RenderContext { animation, ini_files: sources.read_files(), cancel: None }))
}

fn dispatch(console: &Console, command: &Command, context: RenderContext) -> Result {
    confinement::confine(console, command);
    match command {
        Command::Render(args) => render::run(console, args, context).0,
        Command::Prepare(args) => prepare::run(console, args, context.animation),
        Command::Merge(args) => shard::merge::run(console, args),
        Command::Check(args) => check::run(console, args, context.animation),
        Command::Pick(args) => pick::run(console, args, context.animation),
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
