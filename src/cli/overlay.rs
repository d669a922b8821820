//! Merges the options of the command line with those of the INI file that it names. The command line has precedence.

use super::Cli;
use super::animation::Animation;
use super::args::{Command, LookArgs, RenderArgs, SceneArgs};
use super::console::Console;
use super::exit::{Exit, Failure, Result};
use super::povray;
use crate::diagnostic::{Diagnostic, Severity, codes};
use crate::source::{Sources, Span};
use clap::Parser;
use std::path::{Path, PathBuf};

/// Options for one scene, and settings that only an INI file or POV-Ray's options can state.
#[derive(Clone, Debug)]
pub struct Invocation {
    /// Path of the scene, or of the INI file that names the scene.
    pub input: PathBuf,
    /// Options of the command line and of the INI file.
    pub args: RenderArgs,
    /// Animation of an INI file or of POV-Ray's options.
    pub animation: Option<Animation>,
    /// True if the command line names the output of a scene that an INI file describes: a single frame then gets
    /// exactly this name.
    pub exact_name: bool,
}

/// Settings of an INI file, converted to command-line arguments.
pub struct IniFile {
    invocation: Invocation,
    quiet: bool,
    /// Warnings about the INI file.
    pub warnings: Vec<Diagnostic>,
}

/// Reads the INI file `input`; `None` if `input` is not an INI file. `scene` holds the options of the command line.
/// With `warns_of_ineffective_options`, the warnings include options without effect.
///
/// # Errors
/// The errors and warnings of a broken INI file.
pub fn read_ini(
    sources: &Sources,
    input: &Path,
    scene: &SceneArgs,
    warns_of_ineffective_options: bool,
) -> std::result::Result<Option<IniFile>, Vec<Diagnostic>> {
    if !povray::is_ini(&input.to_string_lossy()) {
        return Ok(None);
    }
    let povray::Translated { words, animation, mut diagnostics, idle, .. } =
        povray::translate_ini(sources, input, scene.is_untrusted());
    diagnostics.extend(idle.into_iter().filter(|_| warns_of_ineffective_options));
    if diagnostics.iter().any(|d| d.severity == Severity::Error) {
        return Err(diagnostics);
    }
    match Cli::try_parse_from(words) {
        Ok(Cli { common, command: Command::Render(args) }) => {
            let input = args.inputs.first().cloned().unwrap_or_default();
            let invocation = Invocation { input, args: *args, animation, exact_name: false };
            Ok(Some(IniFile { invocation, quiet: common.quiet, warnings: diagnostics }))
        }
        Ok(_) => Ok(None),
        // The translation has checked all values; other errors have no position in the file.
        Err(error) => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_string();
            Err(vec![Diagnostic::new(codes::UNKNOWN_OPTION, Span::NONE, line)])
        }
    }
}

impl Invocation {
    /// Creates the invocation for one of the inputs on the command line.
    pub fn new(input: &Path, args: RenderArgs, animation: Option<Animation>) -> Self {
        Self { input: input.to_path_buf(), args, animation, exact_name: false }
    }

    /// Creates the invocation of a command that reads a scene and writes no picture.
    pub fn without_picture(input: &Path, scene: &SceneArgs, animation: Option<Animation>) -> Self {
        Self::new(input, RenderArgs { scene: scene.clone(), ..RenderArgs::default() }, animation)
    }

    /// Merges with the INI file `input`, if the input is one, and reports errors of the file.
    pub fn with_ini(self, console: &Console, sources: &Sources) -> Result<(Console, Self)> {
        let ini = match read_ini(sources, &self.input, &self.args.scene, !self.args.warn.is_empty()) {
            Ok(None) => return Ok((console.clone(), self)),
            Ok(Some(ini)) => ini,
            Err(faults) => return Err(report_as_failure(console, sources, &faults)),
        };
        let mut console = console.clone();
        console.quiet |= ini.quiet;
        console.report(sources, &ini.warnings);
        Ok((console, self.with_ini_defaults(ini)))
    }

    /// Adds an INI file's settings where the command line states none. The scene is the INI file's. The animation of the INI
    /// file, if there is one, replaces that of this invocation; `--clock` of the command line sets the clock of either.
    pub fn with_ini_defaults(self, ini: IniFile) -> Self {
        let Invocation { input, args, animation, .. } = ini.invocation;
        let animation = animation.or(self.animation);
        Self {
            input,
            exact_name: self.args.output.is_some(),
            animation: animation.map(|a| Animation { clock: self.args.scene.clock.unwrap_or(a.clock), ..a }),
            args: self.args.with_ini_defaults(args),
        }
    }
}

/// Reports errors and warnings, and returns a failure with the exit code of the first error; that of a wrong command line
/// if there is no error.
pub fn report_as_failure(console: &Console, sources: &Sources, faults: &[Diagnostic]) -> Failure {
    console.report(sources, faults);
    let first = faults.iter().find(|d| d.severity == Severity::Error);
    Failure::Reported(first.map_or(Exit::Usage, |d| Exit::of(d.code)))
}

impl RenderArgs {
    /// Fills in the INI file's options where these options are absent. The inputs are the INI file's.
    fn with_ini_defaults(self, ini: RenderArgs) -> RenderArgs {
        RenderArgs {
            inputs: ini.inputs,
            resume: self.resume || ini.resume,
            no_output: self.no_output || ini.no_output && self.output.is_none(),
            // The compression belongs to the format that the INI file names.
            packing: self.packing.or(if self.output.is_some() || self.format.is_some() { None } else { ini.packing }),
            format: self.format.or(if self.output.is_some() { None } else { ini.format }),
            gray: self.gray || ini.gray,
            bit_depth: self.bit_depth.or(ini.bit_depth),
            file_gamma: self.file_gamma.or(ini.file_gamma),
            dither: self.dither.or(ini.dither),
            output: self.output.or(ini.output),
            scene: self.scene.with_ini_defaults(ini.scene),
            look: self.look.with_ini_defaults(&ini.look),
            region: self.region.or(ini.region),
            outside: self.outside.or(ini.outside),
            threads: self.threads.or(ini.threads),
            progress: self.progress.or(ini.progress),
            load_radiosity: self.load_radiosity.or(ini.load_radiosity),
            save_radiosity: self.save_radiosity.or(ini.save_radiosity),
            // Options that an INI file does not have:
            keep_after: self.keep_after,
            frames: self.frames,
            shard: self.shard,
            prepared: self.prepared,
            stats: self.stats,
            warn: self.warn,
            dump: self.dump,
            deps: self.deps,
        }
    }
}

impl LookArgs {
    fn with_ini_defaults(&self, ini: &LookArgs) -> LookArgs {
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
    fn with_ini_defaults(self, ini: SceneArgs) -> SceneArgs {
        SceneArgs {
            include: [&self.include[..], &ini.include].concat(),
            // The last declaration of a name is valid.
            declare: [ini.declare, self.declare].concat(),
            header: self.header.or(ini.header),
            language: self.language.or(ini.language),
            size: self.size.or(ini.size),
            clock: self.clock.or(ini.clock),
            single_tokens: false,
            // Options that an INI file does not have:
            untrusted: self.untrusted,
            allow_read: self.allow_read,
            allow_write: self.allow_write,
            frame: self.frame,
            library: self.library,
            max_steps: self.max_steps,
            max_memory: self.max_memory,
            max_time: self.max_time,
        }
    }
}
