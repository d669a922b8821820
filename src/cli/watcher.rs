//! Watches a picture being drawn: progress, Ctrl-C and `--max-time`.

use super::console::say;
use super::exit::{Exit, Failure, Result};
use super::interrupt;
use super::journal::Journal;
use super::progress::Progress;
use super::values::Seconds;
use crate::diagnostic::{Diagnostic, codes};
use crate::image_io::{Frame, Rows};
use crate::render::{self, RayCounts, Stopped, Tile, Watch};
use crate::source::Span;
use crate::world::World;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Shows progress and stops when asked to, or when time is over.
pub struct Watcher {
    /// Where progress is shown.
    progress: Progress,
    /// When `--max-time` is over.
    deadline: Option<Instant>,
    /// Whoever else may stop it.
    pub stop: Option<Arc<AtomicBool>>,
    /// What is drawn is kept here.
    pub journal: Option<Journal>,
}

impl Watch for Watcher {
    fn progress(&self, done: usize, total: usize) {
        self.progress.advance(done, total);
    }

    fn cancelled(&self) -> bool {
        interrupt::asked() || self.late() || self.is_stopped()
    }

    fn load_tile(&self, tile: Tile) -> Option<Vec<[f32; 4]>> {
        self.journal.as_ref()?.load_tile(tile)
    }

    fn store_tile(&self, tile: Tile, pixels: &[[f32; 4]]) {
        if let Some(journal) = &self.journal {
            journal.store_tile(tile, pixels);
        }
    }
}

impl Watcher {
    /// For work that began at `start`.
    pub fn new(progress: Progress, start: Instant, limit: Option<Seconds>) -> Self {
        Self { progress, deadline: limit.map(|s| start + Duration::from_secs_f64(s.0)), stop: None, journal: None }
    }

    /// World to the rows of a picture, unless it is stopped.
    pub fn draw(&self, world: &World, options: &render::Options, rows: &mut dyn Rows) -> Result<RayCounts> {
        if self.cancelled() {
            return Err(self.reason());
        }
        let drawn = render::draw(world, options, self, rows);
        self.progress.finish();
        drawn.map_err(|stopped| match stopped {
            Stopped::Cancelled => self.reason(),
            Stopped::Fault(fault) => Failure::Fault(fault),
        })
    }

    /// World to Frame, unless it is stopped.
    pub fn render(&self, world: &World, options: &render::Options) -> Result<Frame> {
        let mut frame = Frame { width: options.width, height: options.height, pixels: vec![] };
        frame.pixels.reserve_exact(options.width * options.height);
        self.draw(world, options, &mut frame)?;
        Ok(frame)
    }

    /// Is the time over?
    fn late(&self) -> bool {
        self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }

    fn is_stopped(&self) -> bool {
        self.stop.as_ref().is_some_and(|stop| stop.load(Ordering::Relaxed))
    }

    /// Why the picture was not finished.
    fn reason(&self) -> Failure {
        if interrupt::asked() {
            say("interrupted; no picture was written\n");
            return Failure::Told(Exit::Interrupted);
        }
        if self.is_stopped() {
            return Failure::Told(Exit::Fine);
        }
        let text = "the picture took longer than `--max-time` allows";
        Failure::Fault(Box::new(Diagnostic::new(codes::TIME_LIMIT, Span::NONE, text)))
    }
}
