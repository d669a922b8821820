//! Renders the pictures of one scene: its text is read and parsed once for all frames.

use super::Done;
use super::config::{Config, Pictures};
use super::monitor::Monitor;
use super::picture_writer::Written;
use super::progress::Progress;
use super::stats::{self, Report};
use super::target::Target;
use crate::cli::args::Dump;
use crate::cli::console::Console;
use crate::cli::exit::{Exit, Failure, Result};
use crate::cli::interrupt::{self, Deadline, Deferred, Overrun};
use crate::cli::journal::finished_frames::FinishedFrames;
use crate::cli::journal::identity::{self, Work};
use crate::cli::journal::{self, Journal};
use crate::cli::session;
use crate::diagnostic::{Diagnostic, Severity};
use crate::interpreter::{self, ParsedFiles, Timing};
use crate::math::cancel::{CancelReason, CancelToken};
use crate::render::RayCounts;
use crate::source::{FileId, ReadFiles, Sources};
use crate::world::World;
use crate::{Built, Keep, advice};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Rendering of one picture: from the scene's text to the picture file.
pub struct Job<'a> {
    console: &'a Console,
    sources: &'a Sources,
    config: &'a Config,
    /// INI files that the command line was read from.
    ini_files: &'a ReadFiles,
    parsed: ParsedFiles,
    file: FileId,
    /// Results of all scenes of the command.
    done: &'a mut Done,
    /// Pictures of this scene that were written.
    written: Vec<PathBuf>,
    start: Instant,
    /// Warnings of earlier frames, which are not repeated.
    reported: Vec<Diagnostic>,
    /// Identity of the running program, for the resume journal.
    program: String,
}

/// A picture that was written to its file.
struct Rendered {
    rays: RayCounts,
    is_black: bool,
    trace_time: Duration,
    encode_time: Duration,
}

impl<'a> Job<'a> {
    /// Creates the rendering of one scene after reading the scene's text.
    pub fn new(
        console: &'a Console,
        sources: &'a Sources,
        config: &'a Config,
        ini_files: &'a ReadFiles,
        done: &'a mut Done,
    ) -> Result<Self> {
        let start = Instant::now();
        let file = session::open_or_report(console, sources, &config.input)?;
        let (parsed, program) = (ParsedFiles::default(), identity::program());
        let (written, reported) = (vec![], vec![]);
        Ok(Self { console, sources, config, ini_files, parsed, file, done, written, start, reported, program })
    }

    /// Renders all pictures of the scene.
    pub fn run(&mut self) -> Result {
        let config = self.config;
        match &config.pictures {
            Pictures::One(timing) => self.render(&config.target, *timing),
            Pictures::Animation(animation) => {
                let picture = config.target.file().filter(|_| config.dump.is_none());
                let finished = picture.map(|path| FinishedFrames::new(path, config.resume));
                for frame in animation.frames() {
                    let target = config.target.numbered(frame, animation.digits);
                    self.render_frame(finished.as_ref(), &target, animation.timing(frame))?;
                }
                finished.iter().for_each(FinishedFrames::remove);
                Ok(Exit::Fine)
            }
        }
    }

    /// Names of the files that were written, and the time they took.
    pub fn summary(&self) -> String {
        let time = format!("({:.1} s)", self.start.elapsed().as_secs_f64());
        match &self.written[..] {
            [] => String::new(),
            [one] => format!("{} {time}", one.display()),
            [first, .., last] => format!("{} to {} {time}", first.display(), last.display()),
        }
    }

    /// Text → Scene → World. Warnings that an earlier frame has reported are removed.
    fn build(&mut self, timing: Timing, cancel: &CancelToken) -> Built {
        let options = interpreter::Options { cancel: cancel.clone(), ..self.config.reading(timing) };
        let keep = if self.config.dump == Some(Dump::Scene) { Keep::Both } else { Keep::World };
        let mut built = session::build(self.console, &self.parsed, self.sources, self.file, &options, keep);
        built.diagnostics.retain(|d| d.severity == Severity::Error || !self.reported.contains(d));
        let warnings = built.diagnostics.iter().filter(|d| d.severity == Severity::Warning).cloned();
        self.reported.extend(warnings);
        built
    }

    /// Reports advice about a finished picture.
    fn advise(&mut self, world: &World, timing: Timing, circumstances: advice::Circumstances) {
        if self.console.quiet {
            return;
        }
        let mut advice = advice::of_picture(world, &self.config.drawing(timing), circumstances);
        advice.retain(|d| !self.reported.contains(d));
        self.console.report(self.sources, &advice);
        self.reported.extend(advice);
    }

    /// The journal of a picture; none unless the picture goes to a regular file.
    fn journal(&self, target: &Target, timing: Timing) -> Option<Journal> {
        let picture = target.file().filter(|path| path.is_file() || !path.exists())?;
        let (work, config) = (self.work(timing), self.config);
        Some(journal::open(self.console, picture, &work, config.resume, config.keep_after))
    }

    /// Identity of the work for a picture, as far as its files have been read.
    fn work(&self, timing: Timing) -> Work {
        let mut files = self.ini_files.clone();
        files.extend(self.sources.read_files());
        let options = identity::options(&self.config.reading(timing), &self.config.drawing(timing));
        Work { program: self.program.clone(), options, files }
    }

    /// Renders a frame of an animation, unless it is finished.
    fn render_frame(&mut self, finished: Option<&FinishedFrames>, target: &Target, timing: Timing) -> Result {
        let (Some(finished), Some(picture)) = (finished, target.file()) else { return self.render(target, timing) };
        let Work { program, options, .. } = self.work(timing);
        if finished.is_current(timing.frame, picture, &program, &options) {
            self.done.pictures.push(picture.to_path_buf());
            self.written.push(picture.to_path_buf());
            return Ok(Exit::Fine);
        }
        if finished.has(timing.frame) {
            let picture = picture.display();
            let text = format!(
                "`{picture}` is rendered again: the file, a file that the scene reads, durer or an option has changed\n"
            );
            self.console.info(&text);
        }
        let exit = self.render(target, timing)?;
        finished.add(timing.frame, picture, self.work(timing));
        Ok(exit)
    }

    /// Renders a world and writes the picture to its file.
    fn write(&self, target: &Target, world: &World, timing: Timing, monitor: &Monitor) -> Result<Rendered> {
        let start = Instant::now();
        let mut draft = target.draft()?;
        let mut writer = target.writer(draft.as_mut(), self.config.size())?;
        let rays = monitor.render_rows(world, &self.config.drawing(timing), &mut writer)?;
        let (time, encode) = (start.elapsed(), Instant::now());
        let Written { is_black, time: rows_time } = writer.finish()?;
        target.commit(self.console, draft)?;
        let (trace_time, encode_time) = (time.saturating_sub(rows_time), rows_time + encode.elapsed());
        Ok(Rendered { rays, is_black, trace_time, encode_time })
    }

    /// Renders one picture, from text to file.
    fn render(&mut self, target: &Target, timing: Timing) -> Result {
        let (console, config, start) = (self.console, self.config, Instant::now());
        if config.dump.is_none() {
            target.check()?;
            self.done.pictures.extend(target.file().map(Path::to_path_buf));
        }
        let (token, overrun) = match &config.cancel {
            Some(token) => (token.clone(), Overrun::Continues),
            None => {
                session::enforce_memory_limit(config.max_memory);
                (CancelToken::default(), Overrun::EndsProcess)
            }
        };
        let deadline = Deadline::start(config.max_time, token, overrun);
        let token = deadline.token();
        let mut built = self.build(timing, token);
        if config.cancel.is_some() && token.reason() == Some(CancelReason::Request) {
            // The caller has no use for the messages of a run that it stopped.
            return Ok(Exit::Fine);
        }
        let is_incomplete = advice::is_incomplete(&built.diagnostics);
        let world = session::settle(console, self.sources, &mut built)?;
        match config.dump {
            Some(Dump::Scene) => return self.dump(&built.scene),
            Some(Dump::World) => return self.dump(&world),
            None => {}
        }

        let deferred = Deferred::begin();
        let progress = Progress::new(config.progress, console, self.sources.name(self.file));
        let mut monitor = Monitor::new(progress, token.clone());
        monitor.is_silent = config.cancel.is_some();
        monitor.journal = self.journal(target, timing).map(Arc::new);
        if let Some(journal) = monitor.journal.clone() {
            interrupt::set_cleanup(Some(Box::new(move || _ = journal.close())));
        }
        let rendered = self.write(target, &world, timing, &monitor);
        interrupt::set_cleanup(None);
        match (monitor.journal, &rendered) {
            (Some(journal), Ok(_)) => {
                journal::report_failure(console, &journal);
                journal.remove();
            }
            (Some(journal), Err(_)) => journal::report_unfinished(console, &journal),
            (None, _) => {}
        }
        let Rendered { rays, is_black, trace_time, encode_time } = rendered?;
        let written = target.file();
        drop(deferred);

        self.advise(&world, timing, config.circumstances(is_incomplete, is_black));
        if let Some(stats) = &config.stats {
            let times = [built.parse_time, built.build_time, trace_time, encode_time, start.elapsed()];
            self.done.reports.push(Report::new(times, rays, &config.drawing(timing)));
            stats::write(&self.done.reports, console, stats)?;
        }
        if let (Some(path), true) = (written, console.terminal && !console.is_among_several()) {
            console.info(&format!("{} ({:.1} s)\n", path.display(), start.elapsed().as_secs_f64()));
        }
        self.written.extend(written.map(Path::to_path_buf));
        if interrupt::is_requested() { Err(Failure::Reported(Exit::Interrupted)) } else { Ok(Exit::Fine) }
    }

    fn dump(&self, stage: &impl serde::Serialize) -> Result {
        self.console.data(super::dump::text(self.sources, stage)).map(|()| Exit::Fine)
    }
}
