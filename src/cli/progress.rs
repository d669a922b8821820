//! The progress bar; the only file that knows indicatif.

use super::args::When;
use super::console::{Console, say};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::Instant;

/// Tells how far the picture is.
pub enum Progress {
    /// Nobody wants to know.
    Silent,
    /// A bar on a terminal.
    Bar(ProgressBar),
    /// A line at each tenth, where there is no terminal.
    Lines {
        /// When drawing began.
        start: Instant,
        /// Tenths told so far.
        told: AtomicUsize,
    },
}

impl Progress {
    /// As `--progress` says; the bar is called by the scene's name.
    pub fn new(when: When, console: &Console, name: &str) -> Self {
        match when {
            When::Always if !console.terminal => Self::Lines { start: Instant::now(), told: AtomicUsize::new(0) },
            When::Always => Self::bar(name),
            When::Auto if console.terminal && !console.quiet => Self::bar(name),
            _ => Self::Silent,
        }
    }

    fn bar(name: &str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(1), ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{prefix} {wide_bar} {percent:>3}%  {eta} left") {
            bar.set_style(style);
        }
        bar.set_prefix(name.to_string());
        Self::Bar(bar)
    }

    /// So many of all pixels are done.
    pub fn advance(&self, done: usize, total: usize) {
        match self {
            Self::Silent => {}
            Self::Bar(bar) => {
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            }
            Self::Lines { start, told } => {
                let tenth = done * 10 / total.max(1);
                if tenth > told.fetch_max(tenth, Relaxed) {
                    let left = start.elapsed().as_secs_f64() * (total - done) as f64 / done as f64;
                    say(&format!("{:3}%, {left:.0} s left\n", 10 * tenth));
                }
            }
        }
    }

    /// Clears the bar away.
    pub fn finish(&self) {
        if let Self::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}
