//! `durer render INPUT`: a scene becomes a picture file.

use super::animation::Animation;
use super::args::{Dump, RenderArgs, When};
use super::canvas::Noted;
use super::console::Console;
use super::exit::{Exit, Failure, Result, usage};
use super::film::Film;
use super::inputs::Inputs;
use super::interrupt::{self, Orderly};
use super::journal::{Journal, Work};
use super::progress::Progress;
use super::stats::{self, Report};
use super::target::{Target, is_folder};
use super::values::Stats;
use super::watcher::Watcher;
use super::{deps, dump, keeping, memory, overlay, povray, session, summary};
use crate::diagnostic::{Diagnostic, Severity, codes};
use crate::image_io::Format;
use crate::interpreter::{self, ParsedFiles, Timing};
use crate::render::{self, RayCounts, Region};
use crate::source::{FileId, ReadFiles, Sources, Span};
use crate::world::World;
use crate::{Built, Keep, advice};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Renders each scene: one picture, or one for each frame. `ini_files` are the INI files that the command line was read from.
pub fn run(console: &Console, args: &RenderArgs, ini_files: ReadFiles) -> Result {
    run_and_record(console, args, ini_files).0
}

/// Renders each scene, and returns the files that were read for them, also after a failure.
pub fn run_and_record(console: &Console, args: &RenderArgs, ini_files: ReadFiles) -> (Result, ReadFiles) {
    let mut done = Done { read: ini_files.clone(), ini_files, ..Done::default() };
    let exit = draw_all(console, args, &mut done);
    // A tool that waits for a broken file to be mended needs the list, too.
    let written = match (&args.deps, &exit) {
        (Some(file), Ok(_) | Err(Failure::Told(_) | Failure::Fault(_))) => {
            deps::write(console, file, &done.pictures, &done.read)
        }
        _ => Ok(()),
    };
    (written.and(exit), done.read)
}

/// What became of one command's scenes.
#[derive(Default)]
struct Done {
    reports: Vec<Report>,
    /// Pictures that were begun.
    pictures: Vec<PathBuf>,
    /// INI files that the command line was read from.
    ini_files: ReadFiles,
    /// All files that were read.
    read: ReadFiles,
}

fn draw_all(console: &Console, args: &RenderArgs, done: &mut Done) -> Result {
    let inputs = Inputs::of(&args.inputs)?;
    if !inputs.several {
        let mut draw = |input| draw_scene(console, args, input, done).map(|(exit, _)| exit);
        return inputs.all.iter().try_fold(Exit::Fine, |_, input| draw(input));
    }
    check_several(args, &inputs.all)?;
    let tell = |line: &str| {
        console.note(line);
        Ok(())
    };
    summary::each(console, &inputs.all, tell, |console, input| draw_scene(console, args, input, done))
}

/// Several pictures need a file each.
fn check_several(args: &RenderArgs, inputs: &[PathBuf]) -> Result<()> {
    if let Some(picture) = inputs.iter().find(|input| Format::from_path(input).is_ok()) {
        let picture = picture.display();
        return usage(format!("`{picture}` is a picture, not a scene; `-o {picture}` draws into it"));
    }
    let Some(output) = &args.output else {
        return check_names(args, inputs);
    };
    if output == Path::new("-") {
        usage("the pictures of several scenes can't all go to standard output; draw them one by one")
    } else if is_folder(output) {
        check_names(args, inputs)
    } else {
        let output = output.display();
        usage(format!("several scenes can't all be drawn into `{output}`; name a folder that is there: `-o pictures/`"))
    }
}

fn check_names(args: &RenderArgs, inputs: &[PathBuf]) -> Result<()> {
    if args.no_output || args.dump.is_some() {
        return Ok(());
    }
    let mut taken = std::collections::HashMap::new();
    for input in inputs.iter().filter(|input| !povray::is_ini(&input.to_string_lossy())) {
        let target = Target::new(&RenderArgs { input: input.clone(), ..args.clone() })?;
        if let Some(other) = target.file().and_then(|file| taken.insert(file.to_path_buf(), input)) {
            let (a, b) = (other.display(), input.display());
            let file = target.file().unwrap_or(Path::new("")).display();
            return usage(format!(
                "`{a}` and `{b}` would both be drawn into `{file}`; draw one of them with `-o` and another name"
            ));
        }
    }
    Ok(())
}

/// One scene; also says what became of it, in a few words.
fn draw_scene(console: &Console, args: &RenderArgs, input: &Path, done: &mut Done) -> Result<(Exit, String)> {
    let sources = Sources::default();
    let drawn = draw_with(console, &sources, args, input, done);
    done.read.extend(sources.read_files());
    drawn
}

fn draw_with(
    console: &Console,
    sources: &Sources,
    args: &RenderArgs,
    input: &Path,
    done: &mut Done,
) -> Result<(Exit, String)> {
    let args = RenderArgs { input: input.to_path_buf(), ..args.clone() };
    let (console, mut args) = overlay::with_ini(console, sources, &args)?;
    session::check_input(&args.input)?;
    if args.dump.is_none() {
        check_region(&args)?;
    }
    settle_frames(&mut args)?;
    let target = check_target(&args)?;
    check_stdout(&args, &target)?;
    let mut job = Job::new(&console, sources, &args, done)?;
    let exit = match &args.scene.animation {
        Some(animation) if args.scene.frame.is_none() => {
            let film = target.file().filter(|_| args.dump.is_none()).map(|path| Film::new(path, args.resume));
            for frame in animation.frames() {
                let target = target.numbered(frame, animation.digits);
                job.draw_frame(film.as_ref(), &target, animation.timing(frame))?;
            }
            film.iter().for_each(Film::remove);
            Exit::Fine
        }
        animation => {
            let timing = session::timing(&args.scene)?;
            let exact = args.exact_name && !target.has_pattern() || args.scene.frame.is_none() && animation.is_none();
            // One frame again: it takes the place of the one that was drawn with the others.
            let digits = animation.as_ref().map_or(1, |animation| animation.digits);
            job.draw(&if exact { target } else { target.numbered(timing.frame, digits) }, timing)?
        }
    };
    Ok((exit, job.done()))
}

/// What `--frames` and `--frame` say becomes part of the animation, that of the INI file if there is one.
fn settle_frames(args: &mut RenderArgs) -> Result<()> {
    let scene = &mut args.scene;
    let by_ini = scene.animation.is_some();
    scene.animation = match (args.frames, scene.animation.take()) {
        (Some(frames), Some(animation)) if !animation.has(frames.first) || !animation.has(frames.last) => {
            let (first, last) = (animation.first, animation.end);
            return usage(format!(
                "`--frames` asks for frames that are not there: the animation goes from {first} to {last}"
            ));
        }
        (Some(frames), Some(animation)) => Some(animation.only(frames)),
        (Some(frames), None) => {
            let animation = Animation::new(frames);
            Some(Animation { clock: scene.clock.unwrap_or(animation.clock), ..animation })
        }
        (None, animation) => animation,
    };
    args.exact_name |= !by_ini && args.output.is_some();
    Ok(())
}

/// What can't go to standard output.
fn check_stdout(args: &RenderArgs, target: &Target) -> Result<()> {
    if !target.is_stdout() || args.dump.is_some() && args.output.is_none() {
        return Ok(());
    }
    if args.stats == Some(Stats::Json) || args.dump.is_some() {
        return usage("standard output can't take the picture and `--stats json` or `--dump` at once");
    }
    if args.scene.animation.is_some() && args.scene.frame.is_none() {
        target.check_many()?;
    }
    if std::io::stdout().is_terminal() {
        let input = args.input.display();
        return usage(format!(
            "a picture is not written to a terminal; send it to a file or a program: `durer render {input} -o - > picture.png`"
        ));
    }
    Ok(())
}

fn check_region(args: &RenderArgs) -> crate::diagnostic::Result<()> {
    let (size, Some(part)) = (args.scene.size(), args.region) else {
        return Ok(());
    };
    let Region { x, y, width, height } = part.0;
    let inside = |at: usize, len: usize, side| at.checked_add(len).is_some_and(|end| end <= side);
    if inside(x, width, size.width) && inside(y, height, size.height) {
        return Ok(());
    }
    let text = format!(
        "the region of {width}x{height} pixels at {x},{y} is not inside the picture of {}x{}",
        size.width, size.height
    );
    Diagnostic::err(codes::OUTSIDE_PICTURE, Span::NONE, text)
}

/// Where the pictures go, and whether there is room for them on the way.
fn check_target(args: &RenderArgs) -> Result<Target> {
    if args.dump.is_none() {
        memory::check_size(args.scene.size())?;
    }
    let target = Target::new(args)?;
    if args.dump.is_none() {
        let limit = args.scene.max_memory.map(|bytes| bytes.0);
        memory::check_drawing(args.scene.size(), args.region.map(|part| part.0), target.kept(), limit)?;
    }
    Ok(target)
}

fn drawing_options(args: &RenderArgs, timing: Timing) -> render::Options {
    let threads = args.threads.map_or(0, usize::from);
    let region = args.region.map(|part| part.0);
    render::Options { region, ..session::drawing_options(&args.scene, &args.look, threads, timing) }
}

/// What the frames of one command share: their text is read and parsed once.
struct Job<'a> {
    console: &'a Console,
    args: &'a RenderArgs,
    sources: &'a Sources,
    parsed: ParsedFiles,
    file: FileId,
    /// Of all scenes of the command.
    all: &'a mut Done,
    /// The pictures so far.
    written: Vec<PathBuf>,
    start: Instant,
    /// Warnings of earlier frames, which are not told again.
    told: Vec<Diagnostic>,
    /// This very one, for those who go on with its work.
    program: String,
}

/// A picture in its file.
struct Drawn {
    rays: RayCounts,
    black: bool,
    /// For drawing, and for storing.
    times: [Duration; 2],
}

impl<'a> Job<'a> {
    fn new(console: &'a Console, sources: &'a Sources, args: &'a RenderArgs, all: &'a mut Done) -> Result<Self> {
        let start = Instant::now();
        let file = session::open_or_tell(console, sources, &args.input)?;
        let parsed = ParsedFiles::default();
        let program = keeping::program();
        Ok(Self { console, args, sources, parsed, file, all, written: vec![], start, told: vec![], program })
    }

    /// What was written, in a few words.
    fn done(&self) -> String {
        let time = format!("({:.1} s)", self.start.elapsed().as_secs_f64());
        match &self.written[..] {
            [] => String::new(),
            [one] => format!("{} {time}", one.display()),
            [first, .., last] => format!("{} to {} {time}", first.display(), last.display()),
        }
    }

    /// Text to Scene to World.
    fn build(&mut self, timing: Timing) -> Built {
        let options = session::reading_options(&self.args.scene, &self.args.input, timing);
        let options = interpreter::Options { stop: self.args.stop.clone(), ..options };
        let keep = if self.args.dump == Some(Dump::Scene) { Keep::Both } else { Keep::World };
        let mut built = session::build(self.console, &self.parsed, self.sources, self.file, &options, keep);
        built.diagnostics.retain(|d| d.severity == Severity::Error || !self.told.contains(d));
        let warnings = built.diagnostics.iter().filter(|d| d.severity == Severity::Warning).cloned();
        self.told.extend(warnings);
        built
    }

    /// What there is to say of the picture.
    fn advise(&mut self, world: &World, timing: Timing, circumstances: advice::Circumstances) {
        if self.console.quiet {
            return;
        }
        let mut advice = advice::of_picture(world, &drawing_options(self.args, timing), circumstances);
        advice.retain(|d| !self.told.contains(d));
        self.console.report(self.sources, &advice);
        self.told.extend(advice);
    }

    /// What keeps the tiles of a picture; none where no file is written.
    fn journal(&self, target: &Target, timing: Timing) -> Option<Journal> {
        let picture = target.file().filter(|path| path.is_file() || !path.exists())?;
        Some(keeping::journal(self.console, self.args, picture, &self.work(timing)))
    }

    /// What the work is that this picture takes, now that all of its files are read.
    fn work(&self, timing: Timing) -> Work {
        let options = keeping::options(self.args, &drawing_options(self.args, timing), timing);
        let mut files = self.all.ini_files.clone();
        files.extend(self.sources.read_files());
        Work { program: self.program.clone(), options, files }
    }

    /// A frame of a film, unless it was drawn before.
    fn draw_frame(&mut self, film: Option<&Film>, target: &Target, timing: Timing) -> Result {
        let (Some(film), Some(picture)) = (film, target.file()) else { return self.draw(target, timing) };
        let Work { program, options, .. } = self.work(timing);
        if film.has(timing.frame, picture, &program, &options) {
            self.all.pictures.push(picture.to_path_buf());
            self.written.push(picture.to_path_buf());
            return Ok(Exit::Fine);
        }
        if film.knows(timing.frame) {
            let text = format!(
                "`{}` is drawn anew: it, a file that it needs, durer or an option has changed\n",
                picture.display()
            );
            self.console.note(&text);
        }
        let exit = self.draw(target, timing)?;
        film.add(timing.frame, picture, self.work(timing));
        Ok(exit)
    }

    /// World to file.
    fn draw_into(&self, target: &Target, world: &World, timing: Timing, watcher: &Watcher) -> Result<Drawn> {
        let (args, trace) = (self.args, Instant::now());
        let mut draft = target.draft()?;
        let mut canvas = target.canvas(draft.as_mut(), args.scene.size())?;
        let rays = watcher.draw(world, &drawing_options(args, timing), &mut canvas)?;
        let (drawing_time, encode) = (trace.elapsed(), Instant::now());
        let Noted { black, time: rows_time } = canvas.finish()?;
        target.place(self.console, draft)?;
        Ok(Drawn { rays, black, times: [drawing_time.saturating_sub(rows_time), rows_time + encode.elapsed()] })
    }

    /// One picture, from text to file.
    fn draw(&mut self, target: &Target, timing: Timing) -> Result {
        let (console, args, start) = (self.console, self.args, Instant::now());
        if args.dump.is_none() {
            target.check()?;
            self.all.pictures.extend(target.file().map(Path::to_path_buf));
        }
        let mut built = self.build(timing);
        if args.stop.as_ref().is_some_and(|stop| stop.load(Ordering::Relaxed)) {
            // What it has to say is of no use any more.
            return Ok(Exit::Fine);
        }
        let incomplete = advice::is_incomplete(&built.diagnostics);
        let world = session::settle(console, self.sources, &mut built)?;
        match args.dump {
            Some(Dump::Scene) => return console.data(dump::text(self.sources, &built.scene)).map(|()| Exit::Fine),
            Some(Dump::World) => return console.data(dump::text(self.sources, &world)).map(|()| Exit::Fine),
            None => {}
        }

        let orderly = Orderly::begin();
        let progress = Progress::new(args.progress.unwrap_or(When::Auto), console, self.sources.name(self.file));
        let mut watcher = Watcher::new(progress, start, args.scene.max_time);
        watcher.stop = args.stop.clone();
        watcher.journal = self.journal(target, timing);
        let drawn = self.draw_into(target, &world, timing, &watcher);
        match (watcher.journal, &drawn) {
            (Some(journal), Ok(_)) => {
                keeping::tell_failure(console, &journal);
                journal.remove();
            }
            (Some(journal), Err(_)) => keeping::tell_kept(console, &journal),
            (None, _) => {}
        }
        let Drawn { rays, black, times: [trace_time, encode_time] } = drawn?;
        let written = target.file();
        drop(orderly);

        let one_of_many = args.frames.is_some() || args.scene.animation.is_some();
        self.advise(&world, timing, advice::Circumstances { one_of_many, incomplete, black });
        if let Some(stats) = &args.stats {
            let times = [built.parse_time, built.build_time, trace_time, encode_time, start.elapsed()];
            self.all.reports.push(Report::new(times, rays, args));
            stats::give(&self.all.reports, console, stats)?;
        }
        if let (Some(path), true) = (written, console.terminal && !console.is_among_several()) {
            console.note(&format!("{} ({:.1} s)\n", path.display(), start.elapsed().as_secs_f64()));
        }
        self.written.extend(written.map(Path::to_path_buf));
        if interrupt::asked() { Err(Failure::Told(Exit::Interrupted)) } else { Ok(Exit::Fine) }
    }
}
