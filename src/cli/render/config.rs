//! Configuration of one scene's pictures, computed once from the command line and the INI file.

use super::target::Target;
use crate::advice::Circumstances;
use crate::cli::animation::Animation;
use crate::cli::args::values::{Bytes, Seconds, Stats};
use crate::cli::args::{Dump, MAX_UNTRUSTED_PIXELS, Outside, ProgressDisplay, RenderArgs};
use crate::cli::exit::{self, Result, usage_error};
use crate::cli::overlay::Invocation;
use crate::cli::shard::scheduler::{self, Resolved};
use crate::cli::{memory, session};
use crate::diagnostic::{Diagnostic, codes};
use crate::interpreter::Timing;
use crate::math::cancel::CancelToken;
use crate::render::{Region, Shard};
use crate::source::{Sandbox, Span};
use crate::{interpreter, render};
use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::Duration;

/// Configuration of `durer render`, read from the command line.
pub struct Config {
    /// Path of the scene, or `-` for standard input.
    pub input: PathBuf,
    /// Pictures that `durer render` renders of the scene.
    pub pictures: Pictures,
    /// Destination of the picture; in an animation, without the frame's number.
    pub target: Target,
    /// Stage that is printed in place of rendering.
    pub dump: Option<Dump>,
    /// Share of the work that this process does; `None` for all of it.
    pub shard: Option<Shard>,
    /// Line about the scheduler that chose the shard.
    pub shard_note: Option<String>,
    /// True if an unfinished rendering is continued.
    pub resume: bool,
    /// Time after which a journal of the picture is written.
    pub keep_after: Duration,
    /// Limit of the rendering time, from text to picture.
    pub max_time: Option<Seconds>,
    /// Limit of the process's memory (`--max-memory`).
    pub max_memory: Option<Bytes>,
    /// Display of the render's progress.
    pub progress: ProgressDisplay,
    /// Destination of the render's times and counters.
    pub stats: Option<Stats>,
    /// File whose radiosity samples are used.
    pub load_radiosity: Option<PathBuf>,
    /// File to which the radiosity samples are saved.
    pub save_radiosity: Option<PathBuf>,
    /// File of `durer prepare` whose photons and radiosity samples are used.
    pub prepared: Option<PathBuf>,
    /// Token of a caller that continues after the run; `None` if the process ends with the run.
    pub cancel: Option<CancelToken>,
    /// True if the picture belongs to an animation.
    is_animated: bool,
    /// Options of the interpreter for all frames, without the values of the clock.
    reading: interpreter::Options,
    drawing: render::Options,
}

/// Pictures that `durer render` renders of one scene: one, or one per frame.
pub enum Pictures {
    /// A single picture at this moment of the animation.
    One(Timing),
    /// One picture for each frame of an animation.
    Animation(Animation),
}

impl Config {
    /// Checks the arguments before hours of work, a mistyped input first, and creates the configuration.
    pub fn resolve(invocation: Invocation, cancel: Option<CancelToken>) -> Result<Self> {
        let Invocation { input, args, animation, exact_name } = invocation;
        session::check_input(&input)?;
        if args.dump.is_none() {
            check_region(&args)?;
        }
        // A single picture gets exactly the name that the command line gives, unless an INI file makes it one of many.
        let exact_name = exact_name || animation.is_none() && args.output.is_some();
        let animation = animation_of(&args, animation)?;
        let target = target_within_memory_limits(&input, &args)?;
        check_stdout(&input, &args, &target, animation.is_some())?;
        let (pictures, target) = match &animation {
            Some(animation) if args.scene.frame.is_none() => (Pictures::Animation(animation.clone()), target),
            _ => {
                let timing = session::timing(&args.scene, animation.as_ref())?;
                let is_alone = args.scene.frame.is_none() && animation.is_none();
                // One frame rendered again replaces the file of the same frame of the animation.
                let digits = animation.as_ref().map_or(1, |animation| animation.digits);
                let is_exact = exact_name && !target.has_number_pattern() || is_alone;
                (Pictures::One(timing), if is_exact { target } else { target.numbered(timing.frame, digits) })
            }
        };
        let threads = args.threads.or_else(|| scheduler::assigned_threads(environment_variable)).map_or(0, usize::from);
        let (shard, shard_note) = resolve_shard(&args, &target)?.map_or((None, None), |it| (Some(it.shard), it.note));
        let (timing, region) = (Timing::default(), args.region.map(|part| part.0));
        let drawing = render::Options {
            region,
            outside_alpha: f32::from(u8::from(args.outside == Some(Outside::Black))),
            ..session::drawing_options(&args.scene, &args.look, threads, timing)
        };
        let mut reading = session::reading_options(&args.scene, &input, timing);
        reading.threads = threads;
        if args.dump.is_none() && cancel.is_none() {
            session::allow_writing_below_current_folder(&mut reading, &args.scene, &input);
        }
        Ok(Self {
            input,
            pictures,
            target,
            dump: args.dump,
            shard,
            shard_note,
            // The same command on another machine, or once more, continues what is there.
            resume: args.resume || shard.is_some(),
            keep_after: Duration::from_secs_f64(args.keep_after.0),
            max_time: args.scene.time_limit(),
            max_memory: args.scene.memory_limit_if_set(),
            progress: args.progress.unwrap_or(ProgressDisplay::Auto),
            stats: args.stats,
            load_radiosity: args.load_radiosity,
            save_radiosity: args.save_radiosity.filter(|_| cancel.is_none()),
            prepared: args.prepared,
            is_animated: args.frames.is_some() || animation.is_some(),
            reading,
            drawing,
            cancel,
        })
    }

    /// Returns the policy for the files that the scene reads and writes.
    pub fn sandbox(&self) -> &Sandbox {
        &self.reading.sandbox
    }

    /// Returns the interpreter's options for a frame.
    pub fn reading(&self, timing: Timing) -> interpreter::Options {
        interpreter::Options { timing, ..self.reading.clone() }
    }

    /// Returns the renderer's options for a frame.
    pub fn drawing(&self, timing: Timing) -> render::Options {
        render::Options { frame: timing.frame, ..self.drawing.clone() }
    }

    /// Returns the width and height of the picture in pixels.
    pub fn size(&self) -> (usize, usize) {
        (self.drawing.width, self.drawing.height)
    }

    /// Returns the circumstances that determine the advice about a finished picture.
    pub fn circumstances(&self, is_picture_black: bool) -> Circumstances {
        Circumstances { one_of_many: self.is_animated, black: is_picture_black }
    }
}

/// Returns the shard that `--shard` states or that a scheduler assigned; `None` without `--shard`. With a shard, the
/// process will end with [`exit::Exit::TryAgain`] after the signal TERM.
fn resolve_shard(args: &RenderArgs, target: &Target) -> Result<Option<Resolved>> {
    let Some(choice) = args.shard else { return Ok(None) };
    if target.file().is_none() {
        return usage_error("`--shard` writes a file beside the picture: name the picture's file with `-o`");
    }
    let resolved = scheduler::resolve(choice, environment_variable)?;
    exit::request_retry_on_term();
    Ok(Some(resolved))
}

/// Returns a variable of the environment.
fn environment_variable(name: &str) -> Option<String> {
    std::env::var(name).ok()
}

/// Returns the animation that `--frames` and the INI file describe; `None` for a single picture. An error if `--frames`
/// asks for frames that the INI file's animation does not have.
fn animation_of(args: &RenderArgs, ini_animation: Option<Animation>) -> Result<Option<Animation>> {
    Ok(match (args.frames, ini_animation) {
        (Some(frames), Some(animation)) if !animation.has_frame(frames.first) || !animation.has_frame(frames.last) => {
            let (first, last) = (animation.first, animation.end);
            return usage_error(format!(
                "`--frames` asks for frames that do not exist: the animation goes from {first} to {last}"
            ));
        }
        (Some(frames), Some(animation)) => Some(animation.restricted_to(frames)),
        (Some(frames), None) => {
            let animation = Animation::new(frames);
            Some(Animation { clock: args.scene.clock.unwrap_or(animation.clock), ..animation })
        }
        (None, animation) => animation,
    })
}

fn check_region(args: &RenderArgs) -> crate::diagnostic::Result<()> {
    let (size, Some(part)) = (args.scene.size(), args.region) else {
        return Ok(());
    };
    let Region { x, y, width, height } = part.0;
    let is_inside = |at: usize, len: usize, side| at.checked_add(len).is_some_and(|end| end <= side);
    if is_inside(x, width, size.width) && is_inside(y, height, size.height) {
        return Ok(());
    }
    let text = format!(
        "the region of {width}x{height} pixels at {x},{y} is not inside the picture of {}x{}",
        size.width, size.height
    );
    Diagnostic::err(codes::OUTSIDE_PICTURE, Span::NONE, text)
}

/// Returns the destination of the picture; an error if the picture does not fit into memory.
fn target_within_memory_limits(input: &std::path::Path, args: &RenderArgs) -> Result<Target> {
    if args.dump.is_none() {
        memory::check_pixel_count(args.scene.size())?;
        if args.scene.is_untrusted() {
            memory::check_pixel_limit(args.scene.size(), MAX_UNTRUSTED_PIXELS)?;
        }
    }
    let target = Target::new(input, args)?;
    if args.dump.is_none() {
        let limit = args.scene.memory_limit_if_set().map(|bytes| bytes.0);
        memory::check_memory(args.scene.size(), args.region.map(|part| part.0), target.kept_bytes_per_pixel(), limit)?;
    }
    Ok(target)
}

/// Checks that standard output can take the picture, beside the other output of the command.
fn check_stdout(input: &std::path::Path, args: &RenderArgs, target: &Target, is_animated: bool) -> Result<()> {
    if !target.is_stdout() || args.dump.is_some() && args.output.is_none() {
        return Ok(());
    }
    if args.stats == Some(Stats::Json) || args.dump.is_some() {
        return usage_error("standard output can't take both the picture and `--stats json` or `--dump`");
    }
    if is_animated && args.scene.frame.is_none() {
        target.check_takes_many_frames()?;
    }
    if std::io::stdout().is_terminal() {
        let input = input.display();
        return usage_error(format!(
            "a picture is not written to a terminal; send it to a file or a program: `durer render {input} -o - > picture.png`"
        ));
    }
    Ok(())
}
