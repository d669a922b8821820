//! Display of the rendering's progress. Only this file uses indicatif.

use crate::cli::args::ProgressDisplay;
use crate::cli::console::{Console, print_message};
use crate::cli::povray::client_lines;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::json;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Display of a render's progress.
pub enum Progress {
    /// Progress display that shows nothing.
    Silent,
    /// Progress display as a bar on a terminal.
    Bar(ProgressBar),
    /// Progress display without a terminal: a line from time to time.
    Lines {
        /// Form of the lines that state the progress: for people, JSON or Open Job Description.
        style: LineStyle,
        /// Time at which the rendering started.
        start: Instant,
        /// Last printed line. Its lock keeps the lines of several threads in ascending order.
        printed: Mutex<Printed>,
    },
    /// Progress display for programs that start POV-Ray: a line per percent.
    PovrayLines {
        /// Number of pixels that the process renders: those of the region, or of the shard's blocks.
        n_pixels_to_render: usize,
        /// Last printed percentage. Its lock keeps the lines of several threads in ascending order.
        printed: Mutex<usize>,
    },
}

/// Text of the lines of a progress display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineStyle {
    /// Lines for people.
    Plain,
    /// Lines of JSON objects.
    Json,
    /// Lines `openjd_progress: PERCENT` and `openjd_status: TEXT` (Open Job Description 2023-09, "How Jobs Are Run").
    OpenJobDescription,
}

/// The last line that a progress display has printed.
pub struct Printed {
    /// Percentage of the picture that the last printed line stated as finished.
    percent: f64,
    time: Instant,
}

/// Progress since the last printed line at which the next line is printed, in percent of the picture.
const LINE_PERCENT: f64 = 5.0;
/// Time since the last printed line at which the next line is printed, even with less progress.
const LINE_INTERVAL: Duration = Duration::from_secs(30);

impl LineStyle {
    /// Returns the line about a picture of which `percent` are finished.
    fn progress(self, percent: f64, seconds_left: f64) -> String {
        match self {
            Self::Plain => format!("{percent:3.0}%, {seconds_left:.0} s left\n"),
            Self::Json => {
                let [percent, seconds_left] = [percent, seconds_left].map(round_to_tenths);
                let line = json!({ "event": "progress", "percent": percent, "seconds_left": seconds_left });
                format!("{line}\n")
            }
            Self::OpenJobDescription => format!("openjd_progress: {percent:.1}\n"),
        }
    }

    /// Returns the line that states that a preparatory pass, such as the photons, is finished.
    fn pass_finished_line(self, pass: &str) -> String {
        match self {
            Self::Plain => format!("{pass}: finished\n"),
            Self::Json => format!("{}\n", json!({ "event": "pass", "name": pass })),
            Self::OpenJobDescription => format!("openjd_status: {pass} finished\n"),
        }
    }
}

fn round_to_tenths(x: f64) -> f64 {
    (10.0 * x).round() / 10.0
}

impl Progress {
    /// Creates the display that `--progress` selects for a process that renders `n_pixels_to_render` pixels; a bar is
    /// labelled with the scene's `name`.
    pub fn new(
        display: ProgressDisplay,
        console: &Console,
        name: &str,
        n_pixels_to_render: usize,
        is_shard: bool,
    ) -> Self {
        use ProgressDisplay::{Always, Auto, Json, Never, Openjd};
        match display {
            // POV-Ray prints the progress unless `-V` turns it off.
            Always | Auto if console.has_povray_lines() => {
                Self::PovrayLines { n_pixels_to_render, printed: Mutex::default() }
            }
            Json => Self::lines(LineStyle::Json),
            Openjd => {
                print_message(&format!("openjd_status: rendering {name}\n"));
                Self::lines(LineStyle::OpenJobDescription)
            }
            Always if !console.terminal => Self::lines(LineStyle::Plain),
            Always => Self::bar(name),
            Auto if console.quiet => Self::Silent,
            Auto if console.terminal => Self::bar(name),
            // The log of a scheduler's task shows that the task is alive.
            Auto if is_shard => Self::lines(LineStyle::Plain),
            Auto | Never => Self::Silent,
        }
    }

    fn lines(style: LineStyle) -> Self {
        let start = Instant::now();
        Self::Lines { style, start, printed: Mutex::new(Printed { percent: 0.0, time: start }) }
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
    pub fn show_progress(&self, done: usize, total: usize) {
        match self {
            Self::Silent => {}
            Self::Bar(bar) => {
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            }
            Self::PovrayLines { n_pixels_to_render, printed } => {
                let percent = done * 100 / total.max(1);
                let mut printed = printed.lock().unwrap_or_else(PoisonError::into_inner);
                if percent > *printed {
                    *printed = percent;
                    print_message(&client_lines::progress_line(
                        n_pixels_to_render * done / total.max(1),
                        *n_pixels_to_render,
                    ));
                }
            }
            Self::Lines { style, start, printed } => {
                let percent = 100.0 * done as f64 / total.max(1) as f64;
                let mut printed = printed.lock().unwrap_or_else(PoisonError::into_inner);
                let is_due = percent >= printed.percent + LINE_PERCENT || printed.time.elapsed() >= LINE_INTERVAL;
                if percent > printed.percent && (is_due || done == total) {
                    *printed = Printed { percent, time: Instant::now() };
                    let left = start.elapsed().as_secs_f64() * (100.0 - percent) / percent;
                    print_message(&style.progress(percent, left));
                }
            }
        }
    }

    /// Updates the display: `done` of `total` work items of a pass before the picture are finished.
    pub fn show_preparation(&self, pass: &str, done: usize, total: usize) {
        match self {
            Self::Bar(bar) => {
                bar.set_message(if done < total { format!(" {pass}") } else { String::new() });
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            }
            Self::Lines { style, .. } if done == total => print_message(&style.pass_finished_line(pass)),
            _ => {}
        }
    }

    /// Ends the display: removes the progress bar from the terminal, or ends the last line of the progress that
    /// POV-Ray's clients read.
    pub fn clear(&self) {
        match self {
            Self::Bar(bar) => bar.finish_and_clear(),
            Self::PovrayLines { .. } => print_message("\n"),
            _ => {}
        }
    }
}
