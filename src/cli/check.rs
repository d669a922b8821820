//! `durer check INPUT…`: reads and evaluates, draws nothing.

use super::args::{CheckArgs, Deny, MessageFormat, Warn};
use super::console::Console;
use super::exit::{Exit, Failure, Result};
use super::overlay;
use super::session;
use crate::diagnostic::{Diagnostic, Severity};
use crate::interpreter::ParsedFiles;
use crate::source::Sources;
use crate::syntax::lint::{self, Lints};
use crate::{Keep, advice};
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
    let (input, scene) = match overlay::read_ini(&sources, &session::named(input), args.warn.contains(&Warn::Options)) {
        Ok(None) => (session::named(input), args.scene.clone()),
        Ok(Some((cli, warnings))) => {
            report(console, args, &sources, &warnings)?;
            overlay::scene_over(cli, &args.scene)
        }
        Err(faults) => {
            report(console, args, &sources, &faults)?;
            return Ok(faults.iter().find(|d| d.severity == Severity::Error).map_or(Exit::Usage, |d| Exit::of(d.code)));
        }
    };
    let file = match session::open(&sources, &input) {
        Ok(file) => file,
        Err(Failure::Fault(fault)) => {
            report(console, args, &sources, std::slice::from_ref(&fault))?;
            return Ok(Exit::of(fault.code));
        }
        Err(other) => return Err(other),
    };
    let options = session::reading_options(&scene, &input, session::timing(&scene)?);
    let parsed = ParsedFiles::default();
    let doubtful = args.warn.contains(&Warn::Doubtful);
    let keep = if doubtful { Keep::Both } else { Keep::World };
    let mut built = session::build(console, &parsed, &sources, file, &options, keep);
    let scene = built.scene.as_ref().filter(|_| doubtful);
    built.diagnostics.extend(scene.map(|scene| advice::doubtful(scene, &sources)).unwrap_or_default());
    built.diagnostics.extend(lint(args, &sources, &parsed));
    if args.deny == Some(Deny::Warnings) {
        built.diagnostics.iter_mut().for_each(|d| d.severity = Severity::Error);
    }
    report(console, args, &sources, &built.diagnostics)?;
    Ok(session::verdict(built.limit_reached, &built.diagnostics))
}

/// What `--warn` asks for; the scene's own file is the first that was parsed.
fn lint(args: &CheckArgs, sources: &Sources, parsed: &ParsedFiles) -> Vec<Diagnostic> {
    let asked = |what| args.warn.contains(&what);
    let lints = Lints { unused: asked(Warn::Unused), shadow: asked(Warn::Shadow), portable: asked(Warn::Portable) };
    let files: Vec<_> = parsed.all().into_iter().map(|(file, _)| file).collect();
    if lints == Lints::default() { vec![] } else { lint::lint(sources, parsed.names(), &files, lints) }
}

fn report(console: &Console, args: &CheckArgs, sources: &Sources, diagnostics: &[Diagnostic]) -> Result<()> {
    match args.format {
        MessageFormat::Human => console.report(sources, diagnostics),
        MessageFormat::Json => console.report_json(sources, diagnostics)?,
    }
    Ok(())
}
