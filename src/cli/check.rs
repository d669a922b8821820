//! `durer check INPUT…`: reads and evaluates, draws nothing.

use super::args::{CheckArgs, CheckFormat, Deny, Warn};
use super::console::Console;
use super::exit::{Exit, Failure, Result};
use super::inputs::Inputs;
use super::summary::Word;
use super::{overlay, session, summary};
use crate::diagnostic::{Diagnostic, Severity};
use crate::interpreter::ParsedFiles;
use crate::source::Sources;
use crate::syntax::lint::{self, Lints};
use crate::{Keep, advice};
use std::path::Path;

/// Checks all inputs; the worst decides the exit code.
pub fn run(console: &Console, args: &CheckArgs) -> Result {
    let inputs = Inputs::of(&args.inputs)?;
    let human = args.format == CheckFormat::Human;
    if let ([input], false) = (&inputs.all[..], inputs.several) {
        let exit = check(console, args, input)?;
        // Programs see the exit code, a person would see nothing at all.
        if human && console.terminal && exit == Exit::Fine {
            console.note(&summary::line(Word::Ok, input.display(), &console.take_count().to_string()));
        }
        return Ok(exit);
    }
    let tell = |line: &str| if human && !console.quiet { console.data(line) } else { Ok(()) };
    summary::each(console, &inputs.all, tell, |console, input| Ok((check(console, args, input)?, String::new())))
}

fn check(console: &Console, args: &CheckArgs, input: &Path) -> Result {
    let sources = Sources::default();
    let (input, scene) = match overlay::read_ini(&sources, input, args.warn.contains(&Warn::Options)) {
        Ok(None) => (input.to_path_buf(), args.scene.clone()),
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
        CheckFormat::Human => console.report(sources, diagnostics),
        CheckFormat::Short => console.report_short(sources, diagnostics)?,
        CheckFormat::Json => console.report_json(sources, diagnostics)?,
    }
    Ok(())
}
