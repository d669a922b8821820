//! The command `durer check INPUT…`: reads and evaluates scenes without rendering.

use super::animation::Animation;
use super::args::{CheckArgs, CheckFormat, Deny, RenderArgs, Warn};
use super::console::Console;
use super::exit::{Exit, Failure, Result};
use super::inputs::Inputs;
use super::interrupt::{Deadline, Overrun};
use super::overlay::Invocation;
use super::summary::ResultWord;
use super::{overlay, session, summary};
use crate::diagnostic::{Diagnostic, Severity};
use crate::interpreter::ParsedFiles;
use crate::math::cancel::CancelToken;
use crate::source::Sources;
use crate::syntax::lint::{self, Lints};
use crate::{BuildOptions, Keep, advice};
use std::path::Path;

/// Checks all inputs; the worst result determines the exit code. `animation` comes from POV-Ray's options.
pub fn run(console: &Console, args: &CheckArgs, animation: Option<Animation>) -> Result {
    let inputs = Inputs::collect(&args.inputs)?;
    let human = args.format == CheckFormat::Human;
    if let ([input], false) = (&inputs.all[..], inputs.several) {
        let exit = check_scene(console, args, &animation, input)?;
        // A program reads the exit code; a person would see no output.
        if human && console.terminal && exit == Exit::Fine {
            console.info(&summary::scene_line(
                ResultWord::Ok,
                input.display(),
                &console.take_message_count().to_string(),
            ));
        }
        return Ok(exit);
    }
    let print = |line: &str| if human && !console.quiet { console.write_to_stdout(line) } else { Ok(()) };
    summary::process_each(console, &inputs.all, print, |console, input| {
        Ok((check_scene(console, args, &animation, input)?, String::new()))
    })
}

fn check_scene(console: &Console, args: &CheckArgs, animation: &Option<Animation>, input: &Path) -> Result {
    let sources = Sources::default();
    let invocation = Invocation::without_picture(input, &args.scene, animation.clone());
    let invocation = match overlay::read_ini(&sources, input, &args.scene, args.warn.contains(&Warn::Options)) {
        Ok(None) => invocation,
        Ok(Some(ini)) => {
            report(console, args, &sources, &ini.warnings)?;
            invocation.with_ini_defaults(ini)
        }
        Err(faults) => {
            report(console, args, &sources, &faults)?;
            return Ok(faults.iter().find(|d| d.severity == Severity::Error).map_or(Exit::Usage, |d| Exit::of(d.code)));
        }
    };
    let Invocation { input, args: RenderArgs { scene, .. }, animation, .. } = invocation;
    let file = match session::open(&sources, &input) {
        Ok(file) => file,
        Err(Failure::Fault(fault)) => {
            report(console, args, &sources, std::slice::from_ref(&fault))?;
            return Ok(Exit::of(fault.code));
        }
        Err(other) => return Err(other),
    };
    let options = session::reading_options(&scene, &input, session::timing(&scene, animation.as_ref())?);
    session::enforce_memory_limit(scene.memory_limit_if_set());
    let deadline = Deadline::start(scene.time_limit(), CancelToken::default(), Overrun::EndsProcess);
    let options = BuildOptions { cancel: deadline.token().clone(), ..options };
    let parsed = ParsedFiles::default();
    let doubtful = args.warn.contains(&Warn::Doubtful);
    let keep = if doubtful { Keep::Both } else { Keep::World };
    let mut built = session::build(console, &parsed, &sources, file, &options, keep);
    drop(deadline);
    let scene = built.scene.as_ref().filter(|_| doubtful);
    built.diagnostics.extend(scene.map(|scene| advice::doubtful_scene_warnings(scene, &sources)).unwrap_or_default());
    built.diagnostics.extend(requested_lint_warnings(args, &sources, &parsed));
    if args.deny == Some(Deny::Warnings) {
        built.diagnostics.iter_mut().for_each(|d| d.severity = Severity::Error);
    }
    report(console, args, &sources, &built.diagnostics)?;
    Ok(session::exit_code_of_run(built.limit_reached, &built.diagnostics))
}

/// Returns the warnings of `--warn unused`, `shadow` and `portable`, if the option names them. The scene's own file is the
/// first of the parsed files.
fn requested_lint_warnings(args: &CheckArgs, sources: &Sources, parsed: &ParsedFiles) -> Vec<Diagnostic> {
    let asked = |what| args.warn.contains(&what);
    let lints = Lints { unused: asked(Warn::Unused), shadow: asked(Warn::Shadow), portable: asked(Warn::Portable) };
    let files: Vec<_> = parsed.all().into_iter().map(|(file, _)| file).collect();
    if lints == Lints::default() { vec![] } else { lint::lint_scene(sources, &files, lints) }
}

fn report(console: &Console, args: &CheckArgs, sources: &Sources, diagnostics: &[Diagnostic]) -> Result<()> {
    match args.format {
        CheckFormat::Human => console.report(sources, diagnostics),
        CheckFormat::Short => console.report_short_to_stdout(sources, diagnostics)?,
        CheckFormat::Json => console.report_json_to_stdout(sources, diagnostics)?,
    }
    Ok(())
}
