//! The command `durer render INPUT…`: renders scenes into picture files.

mod config;
mod deps;
mod dump;
mod job;
mod light_files;
pub mod monitor;
mod partial_picture;
mod pass_times;
mod picture_writer;
pub mod progress;
mod stats;
pub mod target;

use super::animation::Animation;
use super::args::RenderArgs;
use super::console::Console;
use super::exit::{Exit, Failure, Result, usage_error};
use super::inputs::Inputs;
use super::overlay::Invocation;
use super::{povray, summary};
use crate::image_io::Format;
use crate::math::cancel::CancelToken;
use crate::source::{LookedUpFiles, ReadFiles, Sources};
use config::Config;
use job::Job;
use stats::Report;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use target::{Target, is_folder};

/// Inputs of a render that its command-line arguments do not contain.
#[derive(Default)]
pub struct RenderContext {
    /// Animation that POV-Ray's options request.
    pub animation: Option<Animation>,
    /// INI files that contributed to the command line.
    pub ini_files: ReadFiles,
    /// Token of a caller that continues after the run, and that gets no message when it cancels the run. `None` if the
    /// process ends with the run.
    pub cancel: Option<CancelToken>,
}

/// Results of a command's scenes so far.
#[derive(Default)]
struct Done {
    reports: Vec<Report>,
    /// Paths of the pictures whose rendering has begun.
    pictures: Vec<PathBuf>,
    /// All files that the render has read, and paths that it has only asked about.
    files: LookedUpFiles,
}

/// Renders each scene: one picture, or one per frame. Writes the file of `--deps`, and also returns the files that were
/// looked up, even on failure.
pub fn run(console: &Console, args: &RenderArgs, context: RenderContext) -> (Result, LookedUpFiles) {
    let files = LookedUpFiles { read: context.ini_files.clone(), ..LookedUpFiles::default() };
    let mut done = Done { files, ..Done::default() };
    let exit = render_all(console, args, &context, &mut done);
    // A tool that waits for a broken file to be mended needs the list, too.
    let written = match (&args.deps, &exit) {
        (Some(file), Ok(_) | Err(Failure::Reported(_) | Failure::Fault(_))) => {
            deps::write(console, file, &done.pictures, &done.files.read)
        }
        _ => Ok(()),
    };
    (written.and(exit), done.files)
}

fn render_all(console: &Console, args: &RenderArgs, context: &RenderContext, done: &mut Done) -> Result {
    let inputs = Inputs::collect(&args.inputs)?;
    if !inputs.several {
        let mut render = |input| render_scene(console, args, context, input, done).map(|(exit, _)| exit);
        return inputs.all.iter().try_fold(Exit::Fine, |_, input| render(input));
    }
    check_outputs_differ(args, &inputs.all)?;
    let print = |line: &str| {
        console.info(line);
        Ok(())
    };
    summary::process_each(console, &inputs.all, print, |console, input| {
        render_scene(console, args, context, input, done)
    })
}

/// Checks that several pictures go to different files.
fn check_outputs_differ(args: &RenderArgs, inputs: &[PathBuf]) -> Result<()> {
    if let Some(picture) = inputs.iter().find(|input| Format::from_path(input).is_ok()) {
        let picture = picture.display();
        return usage_error(format!("`{picture}` is a picture, not a scene; `-o {picture}` writes the picture to it"));
    }
    let Some(output) = &args.output else {
        return check_scene_outputs_differ(args, inputs);
    };
    if output == Path::new("-") {
        usage_error("the pictures of several scenes can't all go to standard output; render them one by one")
    } else if is_folder(output) {
        check_scene_outputs_differ(args, inputs)
    } else {
        let output = output.display();
        usage_error(format!("the pictures of several scenes can't all go to `{output}`; name a folder: `-o pictures/`"))
    }
}

/// Checks that no two scenes have the same output file.
fn check_scene_outputs_differ(args: &RenderArgs, inputs: &[PathBuf]) -> Result<()> {
    if args.no_output || args.dump.is_some() {
        return Ok(());
    }
    let mut taken = HashMap::new();
    for input in inputs.iter().filter(|input| !povray::is_ini(&input.to_string_lossy())) {
        let target = Target::new(input, args)?;
        if let Some(other) = target.file().and_then(|file| taken.insert(file.to_path_buf(), input)) {
            let (a, b) = (other.display(), input.display());
            let file = target.file().unwrap_or(Path::new("")).display();
            return usage_error(format!(
                "the pictures of `{a}` and `{b}` would both go to `{file}`; render one of them with `-o` and another name"
            ));
        }
    }
    Ok(())
}

/// Renders one scene, and returns the exit code and a short text about the files that were written.
fn render_scene(
    console: &Console,
    args: &RenderArgs,
    context: &RenderContext,
    input: &Path,
    done: &mut Done,
) -> Result<(Exit, String)> {
    let sources = Sources::default();
    let result = render_with(console, &sources, args, context, input, done);
    done.files.extend(sources.looked_up_files());
    result
}

fn render_with(
    console: &Console,
    sources: &Sources,
    args: &RenderArgs,
    context: &RenderContext,
    input: &Path,
    done: &mut Done,
) -> Result<(Exit, String)> {
    let invocation = Invocation::new(input, args.clone(), context.animation.clone());
    let (console, invocation) = invocation.with_ini(console, sources)?;
    let config = Config::resolve(invocation, context.cancel.clone())?;
    let mut job = Job::new(&console, sources, &config, &context.ini_files, done)?;
    let exit = job.run()?;
    Ok((exit, job.summary()))
}
