//! Renders the pictures of one scene: its text is read and parsed once for all frames.

use super::Done;
use super::config::{Config, Pictures};
use super::light_files::{self, LightSaver};
use super::monitor::Monitor;
use super::partial_picture::PartialPicture;
use super::pass_times::PassTime;
use super::picture_writer::Written;
use super::progress::Progress;
use super::stats::{self, Report};
use super::target::Target;
use crate::cli::allocator::MeteredHost;
use crate::cli::args::Dump;
use crate::cli::console::{Console, print_message};
use crate::cli::exit::{Exit, Failure, Result};
use crate::cli::interrupt::{self, Cleanup, Deadline, DeferredSignals, Overrun, StatusTask};
use crate::cli::journal::finished_frames::FinishedFrames;
use crate::cli::journal::identity::{self, Begun, Work};
use crate::cli::journal::{self, Journal};
use crate::cli::povray::client_lines;
use crate::cli::session;
use crate::cli::shard::{Header, Identity, Layout, ShardFile};
use crate::diagnostic::{Diagnostic, Severity};
use crate::interpreter::{self, ParsedFiles, Timing};
use crate::math::cancel::{CancelReason, CancelToken};
use crate::render::{OutputConversion, RayCounts, Region, Shard};
use crate::source::{FileId, ReadFiles, Sources};
use crate::world::World;
use crate::{Built, Keep, advice};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Rendering of the pictures of one scene: from the scene's text to the picture files.
pub struct Job<'a> {
    console: &'a Console,
    sources: &'a Sources,
    config: &'a Config,
    /// Files that are read once for all pictures: the scene, and INI files that contributed to the command line.
    common_files: ReadFiles,
    /// Clock and memory meter of the current picture, with the fixed value of `now`.
    host: Arc<MeteredHost>,
    parsed: ParsedFiles,
    file: FileId,
    /// Results of the command's scenes so far.
    done: &'a mut Done,
    /// Pictures of this scene that were written, now or by an earlier run.
    written: Vec<PathBuf>,
    start: Instant,
    /// Warnings of earlier frames, which are not repeated.
    reported: Vec<Diagnostic>,
}

/// A picture that was written to its file.
struct Rendered {
    rays: RayCounts,
    passes: Vec<PassTime>,
    is_black: bool,
    trace_time: Duration,
    encode_time: Duration,
    /// Warnings about files that could not be written beside the picture.
    warnings: Vec<Diagnostic>,
}

impl<'a> Job<'a> {
    /// Creates the rendering of one scene: reads the scene's text, and prints the note about the shard.
    pub fn new(
        console: &'a Console,
        sources: &'a Sources,
        config: &'a Config,
        ini_files: &'a ReadFiles,
        done: &'a mut Done,
    ) -> Result<Self> {
        let start = Instant::now();
        let file = session::open_or_report(console, sources, &config.input)?;
        identity::open_own_executable();
        config.shard_note.iter().for_each(|note| console.info(note));
        let mut common_files = ini_files.clone();
        common_files.extend(sources.read_files());
        let (parsed, host, written, reported) = Default::default();
        Ok(Self { console, sources, config, common_files, host, parsed, file, done, written, start, reported })
    }

    /// Renders all pictures of the scene.
    pub fn run(&mut self) -> Result {
        let config = self.config;
        match &config.pictures {
            Pictures::One(timing) => {
                let target = config.shard.map(|shard| config.target.of_shard(shard));
                self.render(target.as_ref().unwrap_or(&config.target), *timing, None)
            }
            Pictures::Animation(animation) => {
                let picture = config.target.file().filter(|_| config.dump.is_none());
                let finished = picture.map(|path| FinishedFrames::new(path, config.resume)).transpose()?;
                for (frame, shard) in frames_and_shares(animation.frames_to_render().collect(), config.shard) {
                    let target = config.target.numbered(frame, animation.digits);
                    let target = shard.map(|shard| target.of_shard(shard)).unwrap_or(target);
                    self.render_unless_finished(finished.as_ref(), &target, animation.timing(frame))?;
                }
                // Other processes may still render their frames.
                finished.iter().filter(|_| config.shard.is_none()).for_each(FinishedFrames::delete_journal);
                Ok(Exit::Fine)
            }
        }
    }

    /// Returns the names of the first and the last written file, and the seconds since the job was created; empty if no file
    /// was written.
    pub fn summary(&self) -> String {
        let time = format!("({:.1} s)", self.start.elapsed().as_secs_f64());
        match &self.written[..] {
            [] => String::new(),
            [one] => format!("{} {time}", one.display()),
            [first, .., last] => format!("{} to {} {time}", first.display(), last.display()),
        }
    }

    /// Reads the scene's text and builds Scene and World for a frame. `now` is the value of the constant, or `None` for
    /// the present. Warnings that an earlier frame has reported are removed.
    fn build(&mut self, timing: Timing, cancel: &CancelToken, now: Option<Duration>) -> Built {
        self.console.print_line_for_povray_clients(client_lines::PARSING);
        self.sources.begin_run();
        self.host = Arc::new(MeteredHost::new(now));
        let (cancel, host) = (cancel.clone(), self.host.clone());
        let options = interpreter::Options { cancel, host, ..self.config.reading(timing) };
        let keep = if self.config.dump == Some(Dump::Scene) { Keep::Both } else { Keep::World };
        let mut built = session::build(self.console, &self.parsed, self.sources, self.file, &options, keep);
        built.diagnostics.retain(|d| d.severity == Severity::Error || !self.reported.contains(d));
        let warnings = built.diagnostics.iter().filter(|d| d.severity == Severity::Warning).cloned();
        self.reported.extend(warnings);
        built
    }

    /// Reports advice about a picture, unless it was reported for an earlier frame or the console is quiet.
    fn report_new_advice(&mut self, mut advice: Vec<Diagnostic>) {
        if self.console.quiet {
            return;
        }
        advice.retain(|d| !self.reported.contains(d));
        self.console.report(self.sources, &advice);
        self.reported.extend(advice);
    }

    /// Builds the Scene and World of a frame. In a render that continues a journal, the scene's variable `now` has the
    /// value with which the journal began.
    fn build_with_time_from_journal(
        &mut self,
        timing: Timing,
        cancel: &CancelToken,
        journal: Option<&Journal>,
    ) -> Built {
        let begun = journal.filter(|_| self.config.resume).and_then(Journal::begun);
        let options = self.picture_options_text(timing);
        let now = begun.as_ref().filter(|begun| begun.is_current(&options, &self.common_files));
        let now = now.and_then(|begun| begun.work.now);
        let built = self.build(timing, cancel, now);
        let is_other =
            begun.is_some_and(|begun| self.picture_work_identity(timing).difference_reason(&begun.work).is_some());
        // A picture that is rendered anew belongs to the present.
        if now.is_some() && is_other { self.build(timing, cancel, None) } else { built }
    }

    /// Locks the journal of a picture; `None` unless the picture goes to a regular file, and with `--dump`. A run that its
    /// caller can cancel has no journal, because the caller starts the next run of the picture while the cancelled one still
    /// ends.
    fn lock_journal(&self, target: &Target) -> Result<Option<Arc<Journal>>> {
        let file = target.file().filter(|_| self.config.dump.is_none() && self.config.cancel.is_none());
        let picture = file.filter(|path| path.is_file() || !path.exists());
        let journal = picture.map(journal::lock).transpose()?;
        let is_shard = target.shard().is_some();
        Ok(journal.map(|journal| if is_shard { journal.of_shard() } else { journal }).map(Arc::new))
    }

    /// Returns the options that affect the picture of a frame before its encoding, as text.
    fn picture_options_text(&self, timing: Timing) -> String {
        identity::picture_options_text(&self.config.reading(timing), &self.config.drawing(timing))
    }

    /// Returns the identity of a picture's render, after its scene has been built.
    fn picture_work_identity(&self, timing: Timing) -> Work {
        let mut files = self.common_files.clone();
        files.extend(self.sources.read_files());
        Work {
            options: self.picture_options_text(timing),
            files,
            lookups: self.sources.lookups(),
            now: self.host.now_if_used(),
        }
    }

    /// Returns the description of a shard, after its scene has been built.
    fn shard_header(&self, target: &Target, shard: Shard, timing: Timing) -> Header {
        let (reading, drawing) = (self.config.reading(timing), self.config.drawing(timing));
        let identity = Identity::new(&self.config.input, &reading, &drawing, &self.picture_work_identity(timing));
        Header { identity, layout: Layout::new(&drawing, shard.count), encoding: target.encoding(), shard }
    }

    /// True if the target is a shard that an earlier run has finished, with the same picture, options and files.
    fn has_finished_shard(&self, target: &Target, timing: Timing) -> bool {
        let (Some(shard), Some(path)) = (target.shard(), target.file()) else { return false };
        ShardFile::open(path).is_ok_and(|file| file.header == self.shard_header(target, shard, timing))
    }

    /// Renders a frame of an animation, unless the frame is already finished.
    fn render_unless_finished(&mut self, finished: Option<&FinishedFrames>, target: &Target, timing: Timing) -> Result {
        let (Some(finished), Some(picture)) = (finished, target.file()) else {
            return self.render(target, timing, None);
        };
        let options = self.picture_options_text(timing) + &target.encoding_options();
        if finished.is_current(timing.frame, picture, &options, &self.common_files) {
            journal::remove_finished_journal(picture);
            self.done.pictures.push(picture.to_path_buf());
            self.written.push(picture.to_path_buf());
            return Ok(Exit::Fine);
        }
        if finished.was_finished_earlier(timing.frame) {
            let picture = picture.display();
            let text = format!(
                "`{picture}` is rendered again: the file, a file that the scene reads, durer or an option has changed\n"
            );
            self.console.info(&text);
        }
        self.render(target, timing, Some(finished))
    }

    /// Renders a world and writes the picture to its file.
    fn render_and_write(&self, target: &Target, world: &World, timing: Timing, monitor: &Monitor) -> Result<Rendered> {
        let start = Instant::now();
        let mut draft = target.start_draft()?;
        let drawing = self.config.drawing(timing);
        let (rays, written) = match (target.shard(), &mut draft) {
            (Some(shard), Some(draft)) => {
                let mut writer = target.shard_writer(draft, &self.shard_header(target, shard, timing))?;
                let rays = monitor.render_shard(world, &drawing, shard, &mut writer)?;
                (rays, Written { is_black: false, time: Duration::ZERO })
            }
            _ => {
                let mut writer = target.writer(draft.as_mut(), self.config.size())?;
                (monitor.render_rows(world, &drawing, &mut writer)?, writer.finish()?)
            }
        };
        let (time, encode) = (start.elapsed(), Instant::now());
        let Written { is_black, time: rows_time } = written;
        // The journal is deleted afterwards.
        if let (Some(draft), true) = (&mut draft, monitor.journal.as_ref().is_some_and(|journal| journal.has_header()))
        {
            draft.make_durable();
        }
        target.commit(self.console, draft)?;
        let (trace_time, encode_time) = (time.saturating_sub(rows_time), rows_time + encode.elapsed());
        let passes = monitor.passes.all();
        Ok(Rendered { rays, passes, is_black, trace_time, encode_time, warnings: vec![] })
    }

    /// Renders a world, writes the picture to its target, and reports an unfinished picture.
    fn render_world_to_target(
        &self,
        target: &Target,
        world: &mut World,
        timing: Timing,
        journal: Option<&Arc<Journal>>,
        token: &CancelToken,
    ) -> Result<Rendered> {
        let (console, config) = (self.console, self.config);
        console.print_line_for_povray_clients(client_lines::RENDERING);
        let drawing = config.drawing(timing);
        let n_pixels_to_render = match target.shard() {
            Some(shard) => Layout::new(&drawing, shard.count).blocks(shard).iter().map(Region::n_pixels).sum(),
            None => drawing.rendered_region().n_pixels(),
        };
        let progress = Progress::new(
            config.progress,
            console,
            self.sources.name(self.file),
            n_pixels_to_render,
            target.shard().is_some(),
        );
        let mut monitor = Monitor::new(progress, token.clone());
        monitor.is_silent = config.cancel.is_some();
        monitor.journal = journal.cloned();
        let mut saver = LightSaver::new(config.sandbox().clone());
        if let Some(journal) = journal {
            journal::begin(console, journal, self.picture_work_identity(timing), config.resume, config.keep_after);
            if config.prepared.is_none() {
                saver.use_journal(journal, world, &drawing, config.keep_after);
            }
        }
        monitor.light = Some(&saver);
        let partial = journal.zip(target.file()).map(|(journal, file)| {
            let (size, conversion) = ([drawing.width, drawing.height], OutputConversion::new(world, &drawing));
            let partial = PartialPicture::new(journal, file, size, n_pixels_to_render, conversion);
            StatusTask::register(move || print_message(&partial.write_and_describe()))
        });
        let rendered = self.render_and_write(target, world, timing, &monitor).map_err(|failure| {
            journal.and_then(|journal| journal::flush_and_describe(journal)).iter().for_each(|note| console.info(note));
            match (interrupt::received_end_signal(), failure) {
                // The signal that a file has reached its size limit is also an error of writing.
                (Some(signal), fault @ Failure::Fault(_)) => {
                    console.print_failure(fault);
                    Failure::Reported(signal.exit)
                }
                (_, failure) => failure,
            }
        })?;
        drop(partial);
        Ok(Rendered { warnings: saver.warnings(), ..rendered })
    }

    /// Removes the journal of a picture that was written, and lists the picture among the finished frames.
    fn record_picture_as_finished(
        &self,
        target: &Target,
        timing: Timing,
        journal: Option<&Journal>,
        finished: Option<&FinishedFrames>,
    ) {
        if let (Some(finished), Some(picture)) = (finished, target.file()) {
            let mut work = self.picture_work_identity(timing);
            work.options += &target.encoding_options();
            finished.add(timing.frame, picture, Begun::new(work), journal.is_some_and(Journal::has_header));
        }
        if let Some(journal) = journal {
            journal::failure_note(journal).iter().for_each(|note| self.console.info(note));
            journal.remove_if_written();
        }
    }

    /// Renders one picture, from the scene's text to the picture file. With `--dump`, prints a stage in place of rendering. A
    /// finished shard is not rendered again.
    fn render(&mut self, target: &Target, timing: Timing, finished: Option<&FinishedFrames>) -> Result {
        let (console, config, start) = (self.console, self.config, Instant::now());
        if config.dump.is_none() {
            target.check_file_writable()?;
            self.done.pictures.extend(target.file().map(Path::to_path_buf));
        }
        let journal = self.lock_journal(target)?;
        let _cleanup = journal.clone().map(|journal| Cleanup::register(early_exit_handler(journal, console.quiet)));
        let (token, overrun) = match &config.cancel {
            Some(token) => (token.clone(), Overrun::Continues),
            None => {
                session::enforce_memory_limit(config.max_memory);
                (CancelToken::default(), Overrun::EndsProcess)
            }
        };
        let deadline = Deadline::start(config.max_time, token, overrun);
        let token = deadline.token();
        let mut built = self.build_with_time_from_journal(timing, token, journal.as_deref());
        if config.cancel.is_some() && token.reason() == Some(CancelReason::Request) {
            // The caller has no use for the messages of a run that it stopped.
            return Ok(Exit::Fine);
        }
        let mut world = session::report_and_take_world(console, self.sources, &mut built)?;
        let warnings = light_files::apply_radiosity_file_options(&mut world, config, self.sources);
        self.report_new_advice(warnings);
        if let Some(path) = config.prepared.as_ref().filter(|_| config.dump.is_none()) {
            light_files::use_prepared_light(&mut world, path, &config.drawing(timing))?;
        }
        match config.dump {
            Some(Dump::Scene) => return self.print_as_json(&built.scene),
            Some(Dump::World) => return self.print_as_json(&world),
            None => {}
        }
        if self.has_finished_shard(target, timing) {
            self.written.extend(target.file().map(Path::to_path_buf));
            return Ok(Exit::Fine);
        }
        self.report_new_advice(advice::time_warnings(&world, &config.drawing(timing)));
        let deferred = DeferredSignals::begin();
        let Rendered { rays, passes, is_black, trace_time, encode_time, warnings } =
            self.render_world_to_target(target, &mut world, timing, journal.as_ref(), token)?;
        self.report_new_advice(warnings);
        self.record_picture_as_finished(target, timing, journal.as_deref(), finished);
        drop(deferred);

        let drawing = config.drawing(timing);
        if !console.quiet {
            self.report_new_advice(advice::picture_warnings(&world, &drawing, config.circumstances(is_black)));
        }
        let times = [built.parse_time + built.build_time, trace_time];
        console.print_povray_statistics(&client_lines::statistics([drawing.width, drawing.height], times));
        if let Some(stats) = &config.stats {
            let times = [built.parse_time, built.build_time, trace_time, encode_time, start.elapsed()];
            self.done.reports.push(Report::new(times, passes, rays, &config.drawing(timing)));
            stats::write(&self.done.reports, console, stats)?;
        }
        let written = target.file();
        if let (Some(path), true) = (written, console.terminal && !console.is_among_several()) {
            console.info(&format!("{} ({:.1} s)\n", path.display(), start.elapsed().as_secs_f64()));
        }
        self.written.extend(written.map(Path::to_path_buf));
        interrupt::received_end_signal().map_or(Ok(Exit::Fine), |signal| Err(Failure::Reported(signal.exit)))
    }

    fn print_as_json(&self, stage: &impl serde::Serialize) -> Result {
        self.console.write_to_stdout(super::dump::to_json(self.sources, stage)).map(|()| Exit::Fine)
    }
}

/// Returns a function that, if the process ends early, stores the journal, prints its path unless `quiet`, and deletes
/// an empty journal file.
fn early_exit_handler(journal: Arc<Journal>, quiet: bool) -> impl Fn() + Send {
    move || {
        if let Some(note) = journal::flush_and_describe(&journal).filter(|_| !quiet) {
            print_message(&note);
        }
        journal.remove_if_empty();
    }
}

/// Returns the frames that a shard renders, each with the share of the picture (`None` for the whole picture): whole
/// frames, or a share of one frame if there are fewer frames than shards. Without a shard, returns all frames.
fn frames_and_shares(frames: Vec<u32>, shard: Option<Shard>) -> Vec<(u32, Option<Shard>)> {
    let Some(Shard { index, count }) = shard else {
        return frames.into_iter().map(|frame| (frame, None)).collect();
    };
    if frames.len() >= count {
        return frames.into_iter().skip(index - 1).step_by(count).map(|frame| (frame, None)).collect();
    }
    let (number, n_frames) = ((index - 1) % frames.len(), frames.len());
    let shares = (count - number).div_ceil(n_frames);
    let share = Shard { index: (index - 1) / n_frames + 1, count: shares };
    vec![(frames[number], (shares > 1).then_some(share))]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_render_each_frame_once() {
        for (n_frames, count) in [(1, 1), (10, 3), (3, 10), (4, 4), (5, 16)] {
            let mut shares = std::collections::HashMap::<u32, Vec<Shard>>::new();
            for index in 1..=count {
                let all = frames_and_shares((1..=n_frames).collect(), Some(Shard { index, count }));
                for (frame, share) in all {
                    shares.entry(frame).or_default().push(share.unwrap_or(Shard { index: 1, count: 1 }));
                }
            }
            assert_eq!(shares.len(), n_frames as usize);
            for shares in shares.values_mut() {
                shares.sort();
                let count = shares.len();
                assert_eq!(*shares, (1..=count).map(|index| Shard { index, count }).collect::<Vec<_>>());
            }
        }
    }
}
