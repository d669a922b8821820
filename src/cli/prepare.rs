//! The command `durer prepare INPUT`: computes the photons and radiosity samples of a picture and writes them to a file,
//! from which `durer render --prepared` takes them.

use super::animation::Animation;
use super::args::{PrepareArgs, ProgressDisplay, RenderArgs};
use super::console::Console;
use super::exit::{Exit, Failure, Result, usage_error};
use super::interrupt::{self, Deadline, DeferredSignals, Overrun};
use super::memory;
use super::overlay::Invocation;
use super::render::monitor::{Monitor, ReceiveLight};
use super::render::progress::Progress;
use super::session;
use crate::diagnostic::{Diagnostic, codes, file};
use crate::interpreter::{self, ParsedFiles, Timing};
use crate::math::cancel::CancelToken;
use crate::scene::{LightFile, LightKind, PreparedLight, SaveFile, is_light_file_or_empty};
use crate::source::{Disk, Files, Sources, Span};
use crate::world::World;
use crate::{Keep, advice};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Receives photons and radiosity samples in memory, as the bytes of files of light.
#[derive(Default)]
struct LightInMemory {
    photons: Mutex<Vec<u8>>,
    radiosity: Mutex<Vec<u8>>,
}

impl LightInMemory {
    /// Returns the bytes of the saved photons or radiosity samples, as `kind` selects; empty for none.
    fn bytes(&self, kind: LightKind) -> std::sync::MutexGuard<'_, Vec<u8>> {
        let bytes = match kind {
            LightKind::Photons => &self.photons,
            LightKind::Radiosity => &self.radiosity,
        };
        bytes.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the number of photons or of radiosity samples, in words; `None` for none.
    fn count_in_words(&self, kind: LightKind) -> Option<String> {
        let file = LightFile::parse(self.bytes(kind).clone(), kind).ok()?;
        Some(format!("{} {}", file.records().len(), kind.plural_name()))
    }
}

impl ReceiveLight for LightInMemory {
    fn receive(&self, file: &SaveFile, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) {
        // Writing to memory does not fail.
        let _ = write(&mut *self.bytes(file.kind));
    }
}

/// Prepares a picture. `animation` comes from POV-Ray's options.
pub fn run(console: &Console, args: &PrepareArgs, animation: Option<Animation>) -> Result {
    let input = session::existing_scene_path(&args.input);
    let merged = RenderArgs {
        scene: args.scene.clone(),
        look: args.look.clone(),
        threads: args.threads,
        progress: args.progress,
        ..RenderArgs::default()
    };
    let sources = Sources::default();
    let invocation = Invocation::new(&input, merged, animation);
    let (console, Invocation { input, args: merged, animation, .. }) = invocation.with_ini(console, &sources)?;
    session::check_input(&input)?;
    if animation.is_some() && merged.scene.frame.is_none() {
        return usage_error("a file of prepared light belongs to one picture: name the frame with `--frame`");
    }
    memory::check_pixel_count(merged.scene.size())?;
    let output = args.output.clone().unwrap_or_else(|| default_output(&input));
    check_replaces_only_light(&output)?;
    let timing = session::timing(&merged.scene, animation.as_ref())?;
    prepare(&console, &sources, &input, &merged, timing, &output)
}

/// Returns the default output file: the name of `input` without its folder, with the ending `.prepared`.
fn default_output(input: &Path) -> PathBuf {
    let stem = if input == Path::new("-") { "stdin".as_ref() } else { input.file_stem().unwrap_or_default() };
    let mut name = stem.to_os_string();
    name.push(".prepared");
    name.into()
}

/// Checks that an existing output file contains photons or radiosity samples, so that no other file is replaced.
fn check_replaces_only_light(output: &Path) -> Result<()> {
    if Disk.exists(output) && !Disk.read(output).is_ok_and(|bytes| is_light_file_or_empty(&bytes)) {
        let text = format!("`{}` exists, and durer did not save it as light", output.display());
        let help = "name another file with `-o`, or remove the file";
        return Err(Failure::Fault(Box::new(Diagnostic::new(codes::FILE_UNWRITABLE, Span::NONE, text).help(help))));
    }
    Ok(())
}

/// Builds the scene, computes its photons and radiosity samples, and writes them to the output file.
fn prepare(
    console: &Console,
    sources: &Sources,
    input: &Path,
    args: &RenderArgs,
    timing: Timing,
    output: &Path,
) -> Result {
    let start = Instant::now();
    session::enforce_memory_limit(args.scene.memory_limit_if_set());
    let deadline = Deadline::start(args.scene.time_limit(), CancelToken::default(), Overrun::EndsProcess);
    let token = deadline.token();
    let light = LightInMemory::default();
    token.scope(|| {
        let file = session::open_or_report(console, sources, input)?;
        let options = session::reading_options(&args.scene, input, timing);
        let threads = args.threads.map_or(0, usize::from);
        let options = interpreter::Options { cancel: token.clone(), threads, ..options };
        let mut built = session::build(console, &ParsedFiles::default(), sources, file, &options, Keep::World);
        let mut world = session::report_and_take_world(console, sources, &mut built)?;
        let drawing = session::drawing_options(&args.scene, &args.look, threads, timing);
        set_saved_light_path(&mut world, output);
        if !console.quiet {
            console.report(sources, &advice::time_warnings(&world, &drawing));
        }
        let _deferred = DeferredSignals::begin();
        let display = args.progress.unwrap_or(ProgressDisplay::Auto);
        let progress = Progress::new(display, console, sources.name(file), 0, false);
        let mut monitor = Monitor::new(progress, token.clone());
        monitor.light = Some(&light);
        monitor.compute_and_save_light(&world, &drawing)?;
        write_file(&light, output)
    })?;
    console.info(&format!(
        "{}: {} ({:.1} s)\n",
        output.display(),
        prepared_counts_in_words(&light),
        start.elapsed().as_secs_f64()
    ));
    interrupt::received_end_signal().map_or(Ok(Exit::Fine), |signal| Err(Failure::Reported(signal.exit)))
}

/// Makes the render of a World hand all photons and radiosity samples to the receiver of saved light, in place of
/// writing them to the files that the scene names.
fn set_saved_light_path(world: &mut World, output: &Path) {
    let save = |kind| Some(SaveFile { kind, path: output.to_path_buf(), source: Span::NONE });
    if let Some(settings) = &mut world.photon_map {
        settings.saved.save = save(LightKind::Photons);
    }
    if let Some(settings) = &mut world.radiosity {
        settings.saved.save = save(LightKind::Radiosity);
    }
}

/// Writes the file of prepared light, whole or not at all.
fn write_file(light: &LightInMemory, output: &Path) -> Result<()> {
    let write = || {
        let mut draft = Disk.draft(output)?;
        PreparedLight::write(&light.bytes(LightKind::Photons), &light.bytes(LightKind::Radiosity), &mut draft)?;
        draft.make_durable();
        draft.commit(&Disk)
    };
    write().map_err(|error: io::Error| {
        let text = format!("`{}` can't be written: {}", output.display(), file::reason(&error));
        Failure::Fault(Box::new(Diagnostic::new(codes::FILE_UNWRITABLE, Span::NONE, text)))
    })
}

/// Describes for a person how many photons and radiosity samples were prepared.
fn prepared_counts_in_words(light: &LightInMemory) -> String {
    let counts: Vec<String> =
        [LightKind::Photons, LightKind::Radiosity].into_iter().filter_map(|kind| light.count_in_words(kind)).collect();
    match &counts[..] {
        [] => "the scene has neither photons nor radiosity to prepare".into(),
        counts => counts.join(" and "),
    }
}
