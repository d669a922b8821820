//! Watches a picture being drawn: progress, Ctrl-C and `--max-time`.

use super::exit::{Exit, Failure};
use super::interrupt;
use super::progress::Progress;
use crate::diagnostic::{Diagnostic, codes};
use crate::render::Watch;
use crate::source::Span;
use std::time::Instant;

/// Shows progress and stops when asked to, or when time is over.
pub struct Watcher {
    /// Where progress is shown.
    pub progress: Progress,
    /// When `--max-time` is over.
    pub deadline: Option<Instant>,
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
    /// Is the time over?
    pub fn late(&self) -> bool {
        self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Why the picture was not finished.
    pub fn reason(&self) -> Failure {
        if interrupt::asked() {
            return Failure::Told(Exit::Interrupted);
        }
        let text = "the picture took longer than `--max-time` allows";
        Failure::Fault(Box::new(Diagnostic::new(codes::TIME_LIMIT, Span::NONE, text)))
    }
}
