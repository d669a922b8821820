//! `durer check INPUT…`: reads and evaluates, draws nothing.

use super::args::{CheckArgs, Deny, MessageFormat};
use super::console::Console;
use super::exit::{Exit, Failure, Result};
use super::session::{self, Moment};
use crate::diagnostic::{Diagnostic, Severity};
use crate::source::Sources;
use std::path::Path;

/// Checks all inputs; the first that is wrong decides the exit code.
pub fn run(console: &Console, args: &CheckArgs) -> Result {
    let mut worst = Exit::Fine;
    for input in &args.inputs {
        let exit = match check(console, args, input) {
            Ok(exit) => exit,
            Err(Failure::NobodyListens) => return Err(Failure::NobodyListens),
            Err(failure) => console.tell(failure),
        };
        if worst == Exit::Fine {
            worst = exit;
        }
    }
    Ok(worst)
}

fn check(console: &Console, args: &CheckArgs, input: &Path) -> Result {
    let sources = Sources::default();
    let file = match session::open(&sources, input) {
        Ok(file) => file,
        Err(Failure::Fault(fault)) => {
            report(console, args, &sources, std::slice::from_ref(&fault))?;
            return Ok(Exit::of(fault.code));
        }
        Err(other) => return Err(other),
    };
    let options = session::reading_options(&args.scene, input, Moment::single(&args.scene));
    let mut built = session::build(console, &sources, file, &options);
    if args.deny == Some(Deny::Warnings) {
        built.diagnostics.iter_mut().for_each(|d| d.severity = Severity::Error);
    }
    report(console, args, &sources, &built.diagnostics)?;
    Ok(session::verdict(built.limit_reached, &built.diagnostics))
}

fn report(console: &Console, args: &CheckArgs, sources: &Sources, diagnostics: &[Diagnostic]) -> Result<()> {
    match args.format {
        MessageFormat::Human => console.report(sources, diagnostics),
        MessageFormat::Json => console.report_json(sources, diagnostics)?,
    }
    Ok(())
}
