//! What the command line says, over what an INI file says.

use super::animation::Animation;
use super::args::{LookArgs, RenderArgs, SceneArgs};
use super::console::Console;
use super::exit::{Exit, Failure, Result};
use super::povray;
use super::{Cli, Command};
use crate::diagnostic::{Diagnostic, Severity};
use crate::source::Sources;
use clap::Parser;
use std::path::{Path, PathBuf};

/// What an INI file asks for, as if it had been typed; `None` where the input is none. `all` tells idle options too.
pub fn read_ini(
    sources: &Sources,
    input: &Path,
    all: bool,
) -> std::result::Result<Option<(Cli, Vec<Diagnostic>)>, Vec<Diagnostic>> {
    if !povray::is_ini(&input.to_string_lossy()) {
        return Ok(None);
    }
    let povray::Translated { words, animation, mut diagnostics, idle } = povray::translate_ini(sources, input);
    diagnostics.extend(idle.into_iter().filter(|_| all));
    if diagnostics.iter().any(|d| d.severity == Severity::Error) {
        return Err(diagnostics);
    }
    match parse(words, animation) {
        Ok(cli) => Ok(Some((cli, diagnostics))),
        // The translation has checked all values; what is left is told without a place.
        Err(error) => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_string();
            Err(vec![Diagnostic::new(crate::diagnostic::codes::UNKNOWN_OPTION, crate::source::Span::NONE, line)])
        }
    }
}

/// Our own words, with the animation that they can't say.
pub fn parse(words: Vec<std::ffi::OsString>, animation: Option<Animation>) -> std::result::Result<Cli, clap::Error> {
    let mut cli = Cli::try_parse_from(words)?;
    match &mut cli.command {
        Command::Render(args) => {
            args.scene.animation = animation;
            args.input = args.inputs.first().cloned().unwrap_or_default();
        }
        Command::Check(args) => args.scene.animation = animation,
        Command::Pick(args) => args.scene.animation = animation,
        _ => {}
    }
    Ok(cli)
}

/// The arguments with those of the INI file, if the input is one; its faults are told.
pub fn with_ini(console: &Console, sources: &Sources, args: &RenderArgs) -> Result<(Console, RenderArgs)> {
    let (cli, diagnostics) = match read_ini(sources, &args.input, !args.warn.is_empty()) {
        Ok(None) => return Ok((console.clone(), args.clone())),
        Ok(Some(found)) => found,
        Err(faults) => return Err(tell(console, sources, &faults)),
    };
    let mut quieter = console.clone();
    quieter.quiet |= cli.common.quiet;
    quieter.report(sources, &diagnostics);
    match cli.command {
        Command::Render(ini) => Ok((quieter, args.over(*ini))),
        _ => Ok((quieter, args.clone())),
    }
}

/// The same where no picture is written.
pub fn scene_with_ini(console: &Console, input: &Path, scene: &SceneArgs) -> Result<(PathBuf, SceneArgs)> {
    let args = RenderArgs { input: input.into(), scene: scene.clone(), ..RenderArgs::default() };
    let (_, args) = with_ini(console, &Sources::default(), &args)?;
    Ok((args.input, args.scene))
}

/// The scene that an INI file names, and its arguments below those of the command line.
pub fn scene_over(ini: Cli, scene: &SceneArgs) -> (PathBuf, SceneArgs) {
    match ini.command {
        Command::Render(ini) => (ini.input, scene.over(ini.scene)),
        _ => (PathBuf::new(), scene.clone()),
    }
}

/// Reports, and gives the exit code of the first error.
pub fn tell(console: &Console, sources: &Sources, faults: &[Diagnostic]) -> Failure {
    console.report(sources, faults);
    let first = faults.iter().find(|d| d.severity == Severity::Error);
    Failure::Told(first.map_or(Exit::Usage, |d| Exit::of(d.code)))
}

impl RenderArgs {
    /// These, and the INI file's where these say nothing.
    pub fn over(&self, ini: RenderArgs) -> RenderArgs {
        RenderArgs {
            inputs: ini.inputs,
            input: ini.input,
            exact_name: self.output.is_some(),
            resume: self.resume || ini.resume,
            keep_after: self.keep_after,
            stop: self.stop.clone(),
            no_output: self.no_output || ini.no_output && self.output.is_none(),
            format: self.format.clone().or(if self.output.is_some() { None } else { ini.format }),
            gray: self.gray || ini.gray,
            bit_depth: self.bit_depth.clone().or(ini.bit_depth),
            file_gamma: self.file_gamma.or(ini.file_gamma),
            dither: self.dither.or(ini.dither),
            exr_packing: self.exr_packing.or(ini.exr_packing),
            output: self.output.clone().or(ini.output),
            scene: self.scene.over(ini.scene),
            look: self.look.over(&ini.look),
            frames: self.frames,
            region: self.region.or(ini.region),
            threads: self.threads.or(ini.threads),
            progress: self.progress.or(ini.progress),
            stats: self.stats.clone(),
            warn: self.warn.clone(),
            dump: self.dump,
            deps: self.deps.clone(),
        }
    }
}

impl LookArgs {
    fn over(&self, ini: &LookArgs) -> LookArgs {
        LookArgs {
            aa: self.aa.or(ini.aa),
            aa_method: self.aa_method.or(ini.aa_method),
            aa_depth: self.aa_depth.or(ini.aa_depth),
            aa_jitter: self.aa_jitter.or(ini.aa_jitter),
            aa_gamma: self.aa_gamma.or(ini.aa_gamma),
            quality: self.quality.or(ini.quality),
            alpha: self.alpha || ini.alpha,
        }
    }
}

impl SceneArgs {
    fn over(&self, ini: SceneArgs) -> SceneArgs {
        let animation = ini.animation.or(self.animation.clone());
        SceneArgs {
            include: [self.include.clone(), ini.include].concat(),
            allow_read: self.allow_read.clone(),
            allow_write: self.allow_write.clone(),
            // The later declaration of a name counts.
            declare: [ini.declare, self.declare.clone()].concat(),
            language: self.language.or(ini.language),
            size: self.size.or(ini.size),
            frame: self.frame,
            animation: animation.map(|a| Animation { clock: self.clock.unwrap_or(a.clock), ..a }),
            clock: self.clock.or(ini.clock),
            library: self.library,
            single_tokens: false,
            max_steps: self.max_steps,
            max_memory: self.max_memory,
            max_time: self.max_time,
        }
    }
}
