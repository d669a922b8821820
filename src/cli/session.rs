//! Steps that several commands share: finds, reads and evaluates a scene, and reports its messages.

use super::allocator::{self, MeteredHost};
use super::animation::{self, Animation};
use super::args::values::{Bytes, Frames, Size};
use super::args::{AaMethod, Library, LookArgs, SceneArgs};
use super::console::Console;
use super::created_files::CreatedByScene;
use super::exit::{Exit, Failure, Result, usage_error};
use super::interrupt::{Deadline, Overrun};
use super::memory;
use super::povray::text_output::Stream;
use crate::diagnostic::{Diagnostic, Severity, file};
use crate::interpreter::{ParsedFiles, Timing};
use crate::math::cancel::CancelToken;
use crate::render::{SampleLayout, Sampling};
use crate::source::{
    CreatedFiles, Disk, FileId, FileKind, Files, ReadError, ReadPolicy, Sandbox, SearchPath, Sources, Span,
    WriteFolder, WritePolicy,
};
use crate::syntax::Granularity;
use crate::world::World;
use crate::{Built, Keep, interpreter, render};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Returns the file that an input names: if there is no file `scene`, the first that exists of `scene.pov`, `scene.scene`
/// and `scene.ini`; `input` itself if none exists.
pub fn existing_scene_path(input: &Path) -> PathBuf {
    let endings = ["pov", "scene", "ini"].into_iter();
    let mut others = endings.map(|ending| PathBuf::from(format!("{}.{ending}", input.display())));
    let found = if input.exists() { None } else { others.find(|path| path.is_file()) };
    found.unwrap_or_else(|| input.to_path_buf())
}

/// Checks that the input exists and is not a folder; `-` is standard input. Called first, so that a mistyped name is
/// reported before anything else.
pub fn check_input(input: &Path) -> Result<()> {
    if input == Path::new("-") || input.is_file() {
        return Ok(());
    }
    match std::fs::metadata(input) {
        Ok(meta) if !meta.is_dir() => Ok(()),
        Ok(_) => Err(Failure::Fault(Box::new(file::unreadable(&Disk, input, &ReadError::Folder)))),
        Err(e) => Err(Failure::Fault(Box::new(file::unreadable(&Disk, input, &e.into())))),
    }
}

/// Reads the scene's text; `-` is standard input.
pub fn open(sources: &Sources, input: &Path) -> Result<FileId> {
    if input != Path::new("-") {
        // A pipe that the user names is read, as in `durer render <(program)`; one that a scene names is not.
        if Disk.metadata(input).is_ok_and(|metadata| metadata.kind == FileKind::Special) {
            let bytes = std::fs::read(input).map_err(|e| Box::new(file::unreadable(&Disk, input, &e.into())))?;
            return Ok(crate::load_bytes(sources, &input.to_string_lossy(), bytes)?);
        }
        return Ok(crate::load(sources, input)?);
    }
    let mut bytes = Vec::new();
    match std::io::stdin().lock().read_to_end(&mut bytes) {
        Ok(_) => Ok(crate::load_bytes(sources, "<stdin>", bytes)?),
        Err(e) => Err(Failure::Fault(Box::new(file::unreadable(&Disk, input, &e.into())))),
    }
}

/// Reads the scene's text, and reports the error if reading fails.
pub fn open_or_report(console: &Console, sources: &Sources, input: &Path) -> Result<FileId> {
    open(sources, input).map_err(|failure| match failure {
        Failure::Fault(fault) => {
            console.report(sources, std::slice::from_ref(&fault));
            Failure::Reported(Exit::of(fault.code))
        }
        other => other,
    })
}

/// Returns the animation's constants for a single picture: frame `--frame`, or the first frame.
pub fn timing(args: &SceneArgs, animation: Option<&Animation>) -> Result<Timing> {
    match (animation, args.frame) {
        (Some(animation), Some(frame)) if !animation.has_frame(frame) => usage_error(format!(
            "there is no frame {frame}: the animation goes from {} to {}",
            animation.first, animation.end
        )),
        (Some(animation), frame) => Ok(animation.timing(frame.unwrap_or(animation.start))),
        (None, Some(frame)) => {
            let alone = Animation::new(Frames { first: frame, last: frame, step: 1, digits: 1 });
            let clock = animation::still_picture_timing(args.clock).clock;
            Ok(Timing { clock, ..alone.timing(frame) })
        }
        (None, None) => Ok(animation::still_picture_timing(args.clock)),
    }
}

/// Returns the interpreter's options for a scene, which writes its files into memory unless
/// [`allow_writing_below_current_folder`] changes that.
pub fn reading_options(args: &SceneArgs, input: &Path, timing: Timing) -> interpreter::Options {
    let folder = input.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let size = args.size();
    let untrusted = args.is_untrusted();
    let search = match args.library {
        _ if untrusted => SearchPath { folders: [&[folder.to_path_buf()], &args.include[..]].concat(), fonts: vec![] },
        Library::Installed => SearchPath::new(folder, &args.include),
        Library::Durer => SearchPath::new(folder, &args.include).without_installed(),
    };
    let read = if untrusted {
        ReadPolicy::Below(search.folders.iter().chain(&args.allow_read).cloned().collect())
    } else {
        ReadPolicy::Anywhere
    };
    let sandbox = Sandbox { read, write: WritePolicy::InMemory };
    interpreter::Options {
        search,
        sandbox,
        header: args.header.clone(),
        declares: args.declare.iter().map(|d| (d.name.clone(), d.value.clone())).collect(),
        timing,
        version: args.language.map(|v| v.0),
        input_name: input.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        size: (size.width, size.height),
        max_steps: args.max_steps,
        max_time: args.time_limit().map(|s| s.0),
        max_memory: args.memory_limit_if_set().map(|b| b.0).or_else(memory::default_memory_limit),
        host: Arc::new(MeteredHost::default()),
        cancel: CancelToken::current(),
        threads: 1,
        granularity: if args.single_tokens { Granularity::Tokens } else { Granularity::Whole },
        record_origins: false,
        record_branches: false,
    }
}

/// Makes the process end if it needs clearly more than `--max-memory`, or by default most of the free memory.
pub fn enforce_memory_limit(limit: Option<Bytes>) {
    allocator::end_process_above_bytes(memory::hard_memory_limit_bytes(limit.map(|bytes| bytes.0)));
}

/// Default of the option `--aa`, the threshold of anti-aliasing.
pub const DEFAULT_THRESHOLD: f64 = 0.3;
/// Default of the option `--quality`.
const DEFAULT_QUALITY: u8 = 9;

/// Returns the renderer's options for the whole picture.
pub fn drawing_options(scene: &SceneArgs, look: &LookArgs, threads: usize, timing: Timing) -> render::Options {
    let Size { width, height } = scene.size();
    render::Options {
        antialias: look.aa.map_or(Some(DEFAULT_THRESHOLD), |aa| aa.0),
        sampling: sampling(look),
        quality: look.quality.unwrap_or(DEFAULT_QUALITY),
        threads,
        frame: timing.frame,
        alpha: look.alpha,
        ..render::Options::new(width, height)
    }
}

fn sampling(look: &LookArgs) -> Sampling {
    let default = Sampling::default();
    Sampling {
        layout: look.aa_method.map_or(default.layout, |method| match method {
            AaMethod::Net => SampleLayout::Lattice,
            AaMethod::Grid => SampleLayout::Grid,
            AaMethod::Corners => SampleLayout::Corners,
        }),
        depth: look.aa_depth.map_or(default.depth, u32::from),
        jitter: look.aa_jitter.map_or(default.jitter, |jitter| jitter.0),
        gamma: look.aa_gamma.map_or(default.gamma, |gamma| gamma.0),
    }
}

/// Allows a scene to create files below the current folder, and to create and replace files below the folders of
/// `--allow-write`. `scene_path` is the key of the list of files that the scene has created, and may therefore replace.
/// Does nothing for an untrusted scene.
pub fn allow_writing_below_current_folder(options: &mut interpreter::Options, args: &SceneArgs, scene_path: &Path) {
    if args.is_untrusted() {
        return;
    }
    let created: Arc<dyn CreatedFiles> = Arc::new(CreatedByScene::new(scene_path));
    let folder = |path: &Path, replaces_all| WriteFolder { path: path.into(), created: created.clone(), replaces_all };
    let allowed = args.allow_write.iter().map(|path| folder(path, true));
    options.sandbox.write = WritePolicy::Below(allowed.chain([folder(Path::new("."), false)]).collect());
}

/// Returns a line about the files that a scene wrote to memory; `None` if there are none.
pub fn files_in_memory_line(built: &Built) -> Option<String> {
    let [first, rest @ ..] = &built.paths_written_in_memory[..] else { return None };
    let others = match rest.len() {
        0 => String::new(),
        n => format!(" and {n} more"),
    };
    Some(format!("`{}`{others} was not written: only `durer render` writes the files of a scene\n", first.display()))
}

/// Runs `work` on a scene within `--max-time` and `--max-memory`. The work polls the token of its thread, which
/// [`reading_options`] uses.
///
/// # Errors
/// Those of `work`, or that the time is over.
pub fn within_limits<T>(args: &SceneArgs, work: impl FnOnce() -> Result<T>) -> Result<T> {
    enforce_memory_limit(args.memory_limit_if_set());
    let deadline = Deadline::start(args.time_limit(), CancelToken::default(), Overrun::EndsProcess);
    let result = deadline.token().scope(work)?;
    let max_time = args.time_limit().map(|s| s.0);
    match interpreter::cancellation_error(deadline.token(), max_time, Span::NONE) {
        Some(diagnostic) => Err(Failure::Fault(Box::new(diagnostic))),
        None => Ok(result),
    }
}

/// Evaluates a scene's text and builds the World. The output of `#debug` goes to stderr; the diagnostics are returned, and
/// not yet reported.
pub fn build(
    console: &Console,
    parsed: &ParsedFiles,
    sources: &Sources,
    file: FileId,
    options: &interpreter::Options,
    keep: Keep,
) -> Built {
    let print = &mut |text: &str| console.print_to_povray_stream(Stream::Debug, text);
    let built = crate::build_with(parsed, sources, file, options, keep, print);
    files_in_memory_line(&built).iter().for_each(|note| console.info(note));
    built
}

/// Returns the exit code for the result of the interpreter.
pub fn exit_code_of_run(limit_reached: bool, diagnostics: &[Diagnostic]) -> Exit {
    if limit_reached {
        Exit::Limit
    } else if diagnostics.iter().any(|d| d.severity == Severity::Error) {
        Exit::Scene
    } else {
        Exit::Fine
    }
}

/// Reports the messages of a run, and returns the World if there is no error.
pub fn report_and_take_world(console: &Console, sources: &Sources, built: &mut Built) -> Result<World> {
    console.report(sources, &built.diagnostics);
    match (exit_code_of_run(built.limit_reached, &built.diagnostics), built.world.take()) {
        (Exit::Fine, Some(world)) => Ok(world),
        (Exit::Fine, None) => Err(Failure::Reported(Exit::Scene)),
        (exit, _) => Err(Failure::Reported(exit)),
    }
}
