//! `durer render INPUT`: a scene becomes a picture file.

use super::animation::Animation;
use super::args::{Dump, RenderArgs, When};
use super::console::Console;
use super::exit::{Exit, Failure, Result, usage};
use super::interrupt::{self, Orderly};
use super::progress::Progress;
use super::stats::{self, Report};
use super::target::Target;
use super::values::Stats;
use super::watch::Watcher;
use super::{memory, overlay, session};
use crate::diagnostic::{Diagnostic, Severity, codes};
use crate::image_io::Frame;
use crate::interpreter::{ParsedFiles, Timing};
use crate::render::{self, Region};
use crate::source::{FileId, Sources, Span};
use crate::world::World;
use crate::{Built, Keep, advice};
use std::time::Instant;

/// Draws one picture, or one for each frame.
pub fn run(console: &Console, args: &RenderArgs) -> Result {
    let args = RenderArgs { input: session::named(&args.input), ..args.clone() };
    let (console, args) = overlay::with_ini(console, &args)?;
    session::check_input(&args.input)?;
    if args.dump.is_none() {
        memory::check(args.scene.size(), args.scene.max_memory.map(|b| b.0))?;
        check_region(&args)?;
    }
    let target = Target::new(&args)?;
    if target.is_stdout() && (args.stats == Some(Stats::Json) || args.dump.is_some()) {
        return usage("standard output can't take the picture and `--stats json` or `--dump` at once");
    }
    let mut job = Job::new(&console, &args)?;
    match animation(&args)? {
        Some(animation) => {
            for frame in animation.frames() {
                job.draw(&target.numbered(&animation.number(frame)), animation.timing(frame))?;
            }
            Ok(Exit::Fine)
        }
        None => {
            let timing = session::timing(&args.scene)?;
            // One frame again: it takes the place of the one that was drawn with the others.
            let numbered = args.scene.animation.as_ref().filter(|_| !args.exact_name);
            let target = numbered.map_or(target.clone(), |animation| target.numbered(&animation.number(timing.frame)));
            job.draw(&target, timing)
        }
    }
}

/// Many frames, if they are asked for.
fn animation(args: &RenderArgs) -> Result<Option<Animation>> {
    let scene = &args.scene;
    match (args.frames, &scene.animation) {
        (Some(frames), Some(animation)) if !animation.has(frames.first) || !animation.has(frames.last) => {
            let (first, last) = (animation.first, animation.end);
            usage(format!("`--frames` asks for frames that are not there: the animation goes from {first} to {last}"))
        }
        (Some(frames), Some(animation)) => Ok(Some(animation.only(frames))),
        (Some(frames), None) => {
            let animation = Animation::new(frames);
            Ok(Some(Animation { clock: scene.clock.unwrap_or(animation.clock), ..animation }))
        }
        (None, animation) => Ok(animation.clone().filter(|_| scene.frame.is_none())),
    }
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

fn drawing_options(args: &RenderArgs, timing: Timing) -> render::Options {
    let threads = args.threads.map_or(0, usize::from);
    let region = args.region.map(|part| part.0);
    render::Options { region, ..session::drawing_options(&args.scene, &args.look, threads, timing) }
}

/// What the frames of one command share: their text is read and parsed once.
struct Job<'a> {
    console: &'a Console,
    args: &'a RenderArgs,
    sources: Sources,
    parsed: ParsedFiles,
    file: FileId,
    reports: Vec<Report>,
    /// Warnings of earlier frames, which are not told again.
    told: Vec<Diagnostic>,
}

impl<'a> Job<'a> {
    fn new(console: &'a Console, args: &'a RenderArgs) -> Result<Self> {
        let sources = Sources::default();
        let file = session::open_or_tell(console, &sources, &args.input)?;
        Ok(Self { console, args, sources, parsed: ParsedFiles::default(), file, reports: vec![], told: vec![] })
    }

    /// Text to Scene to World.
    fn build(&mut self, timing: Timing) -> Built {
        let options = session::reading_options(&self.args.scene, &self.args.input, timing);
        let keep = if self.args.dump == Some(Dump::Scene) { Keep::Both } else { Keep::World };
        let mut built = session::build(self.console, &self.parsed, &self.sources, self.file, &options, keep);
        built.diagnostics.retain(|d| d.severity == Severity::Error || !self.told.contains(d));
        let warnings = built.diagnostics.iter().filter(|d| d.severity == Severity::Warning).cloned();
        self.told.extend(warnings);
        built
    }

    /// What there is to say of the picture.
    fn advise(&mut self, world: &World, frame: &Frame, timing: Timing, incomplete: bool) {
        let one_of_many = self.args.frames.is_some() || self.args.scene.animation.is_some();
        let circumstances = advice::Circumstances { one_of_many, incomplete };
        let mut advice = advice::of_picture(world, &drawing_options(self.args, timing), frame, circumstances);
        advice.retain(|d| !self.told.contains(d));
        self.console.report(&self.sources, &advice);
        self.told.extend(advice);
    }

    /// One picture, from text to file.
    fn draw(&mut self, target: &Target, timing: Timing) -> Result {
        let (console, args, start) = (self.console, self.args, Instant::now());
        if args.dump.is_none() {
            target.check()?;
        }
        let mut built = self.build(timing);
        let incomplete = advice::is_incomplete(&built.diagnostics);
        let world = session::settle(console, &self.sources, &mut built)?;
        match args.dump {
            Some(Dump::Scene) => return console.json(&built.scene).map(|()| Exit::Fine),
            Some(Dump::World) => return console.json(&world).map(|()| Exit::Fine),
            None => {}
        }

        let orderly = Orderly::begin();
        let progress = Progress::new(args.progress.unwrap_or(When::Auto), console, self.sources.name(self.file));
        let watcher = Watcher::new(progress, start, args.scene.max_time);
        let trace = Instant::now();
        let (frame, rays) = watcher.render(&world, &drawing_options(args, timing))?;
        let trace_time = trace.elapsed();
        let encode = Instant::now();
        let bytes = target.encode(&frame)?;
        let written = target.write(console, &bytes)?;
        let encode_time = encode.elapsed();
        drop(orderly);

        self.advise(&world, &frame, timing, incomplete);
        if let Some(stats) = &args.stats {
            let times = [built.parse_time, built.build_time, trace_time, encode_time, start.elapsed()];
            self.reports.push(Report::new(times, rays, args));
            stats::give(&self.reports, console, stats)?;
        }
        if let (Some(path), true) = (written, console.terminal) {
            console.note(&format!("{} ({:.1} s)\n", path.display(), start.elapsed().as_secs_f64()));
        }
        if interrupt::asked() { Err(Failure::Told(Exit::Interrupted)) } else { Ok(Exit::Fine) }
    }
}
