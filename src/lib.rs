//! durer: an interpreter and renderer for scenes written by hand in POV-Ray's scene language.
//!
//! ```text
//! text ──syntax──▶ AST ──interpreter──▶ Scene ──world──▶ World ──render──▶ Frame ──image_io──▶ file
//! ```
//!
//! The whole way, as every front end goes it:
//!
//! ```no_run
//! # fn draw(reading: durer::interpreter::Options, drawing: durer::render::Options) -> durer::diagnostic::Result<()> {
//! use durer::{image_io, render, source};
//!
//! let sources = source::Sources::default();
//! let file = durer::load(&sources, "ball.scene".as_ref())?;
//! let built = durer::build(&sources, file, &reading, &mut |text| print!("{text}"));
//! if let Some(world) = &built.world
//!     && let Ok((frame, _rays)) = render::render(world, &drawing, &render::Unwatched)
//! {
//!     let bytes = image_io::encode(&frame, &image_io::Encoding::new(image_io::Format::Png))?;
//!     source::write_whole("ball.png".as_ref(), &bytes).ok();
//! }
//! # Ok(()) }
//! ```

// What pest_derive writes names it.
extern crate alloc;

pub mod advice;
pub mod atmosphere;
pub mod camera;
pub mod cli;
pub mod color;
pub mod diagnostic;
pub mod font;
pub mod format;
pub mod function;
pub mod image_io;
pub mod interpreter;
pub mod library;
pub mod light;
pub mod lsp;
pub mod math;
pub mod mesh_io;
pub mod pattern;
pub mod preview;
pub mod quirks;
pub mod reference;
pub mod render;
pub mod scene;
pub mod shape;
pub mod snapshot;
pub mod source;
pub mod syntax;
pub mod texture;
pub mod value;
pub mod world;

use diagnostic::{Diagnostic, Result};
use source::{FileId, Sources, Span};
use std::path::Path;
use std::time::{Duration, Instant};

/// Reads a scene's text. A file that is not text gets a place all the same: its first byte.
///
/// # Errors
/// E0001, E0002 or E0003: too long, not there, or not readable.
pub fn load(sources: &Sources, path: &Path) -> Result<FileId> {
    let name = path.display().to_string();
    match source::read_text(path) {
        Ok(text) => add(sources, &name, Some(path), text),
        Err(error) => Err(refuse(sources, path, &error)),
    }
}

/// Takes bytes from elsewhere, such as standard input, for a scene's text.
///
/// # Errors
/// E0001 or E0003: too long, or no text.
pub fn load_bytes(sources: &Sources, name: &str, bytes: Vec<u8>) -> Result<FileId> {
    source::note(Path::new(name), &bytes);
    match source::text_of(bytes) {
        Ok(text) => add(sources, name, None, text),
        Err(error) => Err(refuse(sources, Path::new(name), &error)),
    }
}

fn add(sources: &Sources, name: &str, path: Option<&Path>, text: String) -> Result<FileId> {
    match sources.add(name, path, text) {
        Some(file) => Ok(file),
        None => {
            let text = format!("`{name}` is too large: all files of a scene together hold at most 4 GB");
            Diagnostic::err(diagnostic::codes::FILE_UNREADABLE, Span::NONE, text)
        }
    }
}

fn refuse(sources: &Sources, path: &Path, error: &source::ReadError) -> diagnostic::Fault {
    let mut fault = diagnostic::file::unreadable(path, error);
    if matches!(error, source::ReadError::NotText(_)) {
        let file = sources.add(&path.display().to_string(), Some(path), String::new());
        let start = file.map_or(0, |file| sources.base(file));
        fault.labels.push(diagnostic::Label { span: Span::new(start, start), text: String::new() });
    }
    Box::new(fault)
}

/// What a text became.
#[derive(Debug)]
pub struct Built {
    /// What the author said, unless there were errors or it was not to be kept.
    pub scene: Option<scene::Scene>,
    /// What a ray needs, unless there were errors.
    pub world: Option<world::World>,
    /// Errors and warnings in the order in which they were found.
    pub diagnostics: Vec<Diagnostic>,
    /// A limit (steps, memory, time) ended the run.
    pub limit_reached: bool,
    /// If they were to be kept: the macro calls and includes around each of the scene's objects, innermost first.
    pub origins: Vec<Vec<diagnostic::Label>>,
    /// If they were to be noted: branches that did not run.
    pub idle: Vec<Span>,
    /// How long text → Scene took.
    pub parse_time: Duration,
    /// How long Scene → World took.
    pub build_time: Duration,
}

/// Text → Scene → World. `debug` receives what the scene prints. Scenes may be nested deeply: call this inside [`on_big_stack`].
pub fn build(sources: &Sources, file: FileId, options: &interpreter::Options, debug: &mut dyn FnMut(&str)) -> Built {
    build_with(&interpreter::ParsedFiles::default(), sources, file, options, Keep::Both, debug)
}

/// What is wanted of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// Scene and World.
    Both,
    /// The World alone: the Scene is used up on the way, which takes less memory.
    World,
}

/// The same for one frame of many: files that an earlier frame has left are not parsed again.
pub fn build_with(
    parsed: &interpreter::ParsedFiles,
    sources: &Sources,
    file: FileId,
    options: &interpreter::Options,
    keep: Keep,
    debug: &mut dyn FnMut(&str),
) -> Built {
    let start = Instant::now();
    let interpreter::Outcome { mut scene, mut diagnostics, mut limit_reached, origins, idle } =
        interpreter::interpret_with(parsed, sources, file, options, debug);
    let parse_time = start.elapsed();
    if let Some(scene) = &scene {
        diagnostics.extend(advice::of_scene(scene, sources));
    }
    advice::keep_own(&mut diagnostics, sources, file);
    let start = Instant::now();
    let light = |scene: &scene::Scene| match scene.check_weight(options.max_memory) {
        Ok(()) => true,
        Err(fault) => {
            diagnostics.push(*fault);
            limit_reached = true;
            false
        }
    };
    let lowered = match (scene.as_ref().is_some_and(light), keep) {
        (false, _) => None,
        (true, Keep::Both) => scene.as_ref().map(world::lower),
        (true, Keep::World) => scene.take().map(world::lower_away),
    };
    let world = lowered.and_then(|world| world.map_err(|e| diagnostics.push(*e)).ok());
    Built { scene, world, diagnostics, limit_reached, origins, idle, parse_time, build_time: start.elapsed() }
}

/// Bytes of stack for parser and interpreter, which recurse as deeply as the text is nested. Only what is used costs memory.
const BIG_STACK: usize = 512 << 20;

/// Runs `work` where there is stack for deeply nested text.
///
/// # Panics
/// Where `work` does.
pub fn on_big_stack<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    let slot = std::sync::Mutex::new(Some(work));
    let take = || slot.lock().ok().and_then(|mut work| work.take()).map(|work| work());
    let result = std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().name("durer".into()).stack_size(BIG_STACK);
        match thread.spawn_scoped(scope, take) {
            Ok(handle) => handle.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            // Where memory is rationed, there may be no room for it; small scenes need none.
            Err(_) => take(),
        }
    });
    result.unwrap_or_else(|| unreachable!("the work is taken exactly once"))
}
