//! `durer render INPUT`: a scene becomes a picture file.

use super::args::{Dump, RenderArgs};
use super::console::Console;
use super::exit::{Exit, Failure, Result, usage};
use super::interrupt::{self, Orderly};
use super::memory;
use super::progress::Progress;
use super::session::{self, Moment};
use super::stats::{self, Report};
use super::target::Target;
use super::values::{Clock, Frames, Stats};
use super::watch::Watcher;
use crate::diagnostic::{Diagnostic, codes};
use crate::render::{self, Region};
use crate::source::{Sources, Span};
use std::time::Instant;

/// Draws one picture, or one for each frame.
pub fn run(console: &Console, args: &RenderArgs) -> Result {
    session::check_input(&args.input)?;
    if args.dump.is_none() {
        memory::check(args.scene.size(), args.scene.max_memory.map(|b| b.0))?;
        check_region(args)?;
    }
    let target = Target::new(args)?;
    if target.is_stdout() && (args.stats == Some(Stats::Json) || args.dump.is_some()) {
        return usage("standard output can't take the picture and `--stats json` or `--dump` at once");
    }
    let mut reports = Vec::new();
    let Some(frames) = &args.frames else {
        return draw(console, args, &target, Moment::single(&args.scene), &mut reports);
    };
    for frame in (frames.first..=frames.last).step_by(frames.step as usize) {
        let clock = clock_of(frames, args.scene.clock.unwrap_or(Clock { first: 0.0, last: 1.0 }), frame);
        draw(console, args, &target.numbered(frames, frame), Moment { clock, frame }, &mut reports)?;
    }
    Ok(Exit::Fine)
}

/// `clock` goes evenly from the first to the last frame.
fn clock_of(frames: &Frames, clock: Clock, frame: u32) -> f64 {
    let t = f64::from(frame - frames.first) / f64::from((frames.last - frames.first).max(1));
    clock.first + (clock.last - clock.first) * t
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

fn drawing_options(args: &RenderArgs, moment: Moment) -> render::Options {
    let threads = args.threads.map_or(0, usize::from);
    let region = args.region.map(|part| part.0);
    render::Options { region, ..session::drawing_options(&args.scene, &args.look, threads, moment) }
}

/// One picture, from text to file.
fn draw(console: &Console, args: &RenderArgs, target: &Target, moment: Moment, reports: &mut Vec<Report>) -> Result {
    let start = Instant::now();
    if args.dump.is_none() {
        target.check()?;
    }
    let sources = Sources::default();
    let file = session::open_or_tell(console, &sources, &args.input)?;
    let options = session::reading_options(&args.scene, &args.input, moment);
    let mut built = session::build(console, &sources, file, &options);
    let world = session::settle(console, &sources, &mut built)?;
    match args.dump {
        Some(Dump::Scene) => return console.json(&built.scene).map(|()| Exit::Fine),
        Some(Dump::World) => return console.json(&world).map(|()| Exit::Fine),
        None => drop(built.scene.take()),
    }

    let orderly = Orderly::begin();
    let progress = Progress::new(args.progress, console, sources.name(file));
    let watcher = Watcher::new(progress, start, args.scene.max_time);
    let trace = Instant::now();
    let (frame, rays) = watcher.render(&world, &drawing_options(args, moment))?;
    let trace_time = trace.elapsed();
    let encode = Instant::now();
    let bytes = target.encode(&frame)?;
    let written = target.write(console, &bytes)?;
    let encode_time = encode.elapsed();
    drop(orderly);

    if let Some(stats) = &args.stats {
        let times = [built.parse_time, built.build_time, trace_time, encode_time, start.elapsed()];
        reports.push(Report::new(times, rays, args));
        stats::give(reports, console, stats)?;
    }
    if let (Some(path), true) = (written, console.terminal) {
        console.note(&format!("{} ({:.1} s)\n", path.display(), start.elapsed().as_secs_f64()));
    }
    if interrupt::asked() { Err(Failure::Told(Exit::Interrupted)) } else { Ok(Exit::Fine) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_runs_evenly() {
        let frames = "1-5".parse().unwrap();
        let clock = Clock { first: 0.0, last: 10.0 };
        assert_eq!([1, 2, 5].map(|f| clock_of(&frames, clock, f)), [0.0, 2.5, 10.0]);
        assert_eq!(clock_of(&"3-3".parse().unwrap(), clock, 3), 0.0);
    }
}
