//! Watches a picture being drawn: progress, Ctrl-C and `--max-time`.

use super::console::say;
use super::exit::{Exit, Failure, Result};
use super::interrupt;
use super::progress::Progress;
use super::values::Seconds;
use crate::diagnostic::{Diagnostic, codes};
use crate::image_io::Frame;
use crate::render::{self, Rays, Watch};
use crate::source::Span;
use crate::world::World;
use std::time::{Duration, Instant};

/// Shows progress and stops when asked to, or when time is over.
pub struct Watcher {
    /// Where progress is shown.
    progress: Progress,
    /// When `--max-time` is over.
    deadline: Option<Instant>,
}

impl Watch for Watcher {
    fn progress(&self, done: usize, total: usize) {
        self.progress.advance(done, total);
    }

    fn cancelled(&self) -> bool {
        interrupt::asked() || self.late()
    }
}

impl Watcher {
    /// For work that began at `start`.
    pub fn new(progress: Progress, start: Instant, limit: Option<Seconds>) -> Self {
        Self { progress, deadline: limit.map(|s| start + Duration::from_secs_f64(s.0)) }
    }

    /// World to Frame, unless it is stopped.
    pub fn render(&self, world: &World, options: &render::Options) -> Result<(Frame, Rays)> {
        if self.cancelled() {
            return Err(self.reason());
        }
        let drawn = render::render(world, options, self);
        self.progress.finish();
        drawn.map_err(|_| self.reason())
    }

    /// Is the time over?
    fn late(&self) -> bool {
        self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Why the picture was not finished.
    fn reason(&self) -> Failure {
        if interrupt::asked() {
            say("interrupted; no picture was written\n");
            return Failure::Told(Exit::Interrupted);
        }
        let text = "the picture took longer than `--max-time` allows";
        Failure::Fault(Box::new(Diagnostic::new(codes::TIME_LIMIT, Span::NONE, text)))
    }
}
