//! Display of the rendering's progress. Only this file uses indicatif.

use crate::cli::args::When;
use crate::cli::console::{Console, print_message};
use crate::cli::povray::client_lines;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Display of a render's progress.
pub enum Progress {
    /// Progress display that shows nothing.
    Silent,
    /// Progress display as a bar on a terminal.
    Bar(ProgressBar),
    /// Progress display without a terminal: a line at each tenth of the picture.
    Lines {
        /// Time at which the rendering started.
        start: Instant,
        /// Tenths of the progress that are printed so far.
        printed: AtomicUsize,
    },
    /// Progress display for programs that start POV-Ray: a line per percent.
    PovrayLines {
        /// Number of pixels of the picture or of its region.
        pixels: usize,
        /// Last printed percentage. Its lock keeps the lines of several threads in ascending order.
        printed: Mutex<usize>,
    },
}

impl Progress {
    /// Creates the display that `--progress` selects for a number of pixels; a bar is labelled with the scene's `name`.
    pub fn new(when: When, console: &Console, name: &str, pixels: usize) -> Self {
        match when {
            // POV-Ray prints the progress unless `-V` turns it off.
            When::Always | When::Auto if console.has_povray_lines() => {
                Self::PovrayLines { pixels, printed: Mutex::default() }
            }
            When::Always if !console.terminal => Self::Lines { start: Instant::now(), printed: AtomicUsize::new(0) },
            When::Always => Self::bar(name),
            When::Auto if console.terminal && !console.quiet => Self::bar(name),
            _ => Self::Silent,
        }
    }

    fn bar(name: &str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(1), ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{prefix}{msg} {wide_bar} {percent:>3}%  {eta} left") {
            bar.set_style(style);
        }
        bar.set_prefix(name.to_string());
        Self::Bar(bar)
    }

    /// Updates the display: `done` of `total` pixels of all passes are finished.
    pub fn advance(&self, done: usize, total: usize) {
        match self {
            Self::Silent => {}
            Self::Bar(bar) => {
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            }
            Self::PovrayLines { pixels, printed } => {
                let percent = done * 100 / total.max(1);
                let mut printed = printed.lock().unwrap_or_else(PoisonError::into_inner);
                if percent > *printed {
                    *printed = percent;
                    print_message(&client_lines::progress(pixels * done / total.max(1), *pixels));
                }
            }
            Self::Lines { start, printed } => {
                let tenth = done * 10 / total.max(1);
                if tenth > printed.fetch_max(tenth, Relaxed) {
                    let left = start.elapsed().as_secs_f64() * (total - done) as f64 / done as f64;
                    print_message(&format!("{:3}%, {left:.0} s left\n", 10 * tenth));
                }
            }
        }
    }

    /// Updates the display: `done` of `total` work items of a pass before the picture are finished.
    pub fn prepare(&self, pass: &str, done: usize, total: usize) {
        match self {
            Self::Bar(bar) => {
                bar.set_message(if done < total { format!(" {pass}") } else { String::new() });
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            }
            Self::Lines { .. } if done == total => print_message(&format!("{pass}: finished\n")),
            _ => {}
        }
    }

    /// Removes the progress bar from the terminal.
    pub fn clear(&self) {
        match self {
            Self::Bar(bar) => bar.finish_and_clear(),
            Self::PovrayLines { .. } => print_message("\n"),
            _ => {}
        }
    }
}
