//! Limits on steps, time, memory and depth, so that a runaway scene ends with a message.

use super::Reporter;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::cancel::{CancelReason, CancelToken};
use crate::source::{Host, Span};
use std::time::Duration;

/// Maximum depth of nested macro calls.
pub const MAX_CALLS: usize = 5_000;
/// Maximum depth of nested include files.
pub const MAX_INCLUDES: usize = 100;
/// Memory for each pixel of a function's picture, in bytes: four components.
const PER_POINT: u64 = 16;
/// Maximum number of pixels of a function's picture, if memory is not limited.
const MAX_POINTS: u64 = 1 << 26;
/// Number of steps between two checks of the clock, which cost more than a step.
const CLOCK_EVERY: u64 = 4096;
/// Number of steps between two checks of the memory, on a host where checking is cheap.
const MEMORY_EVERY: u64 = 16;
/// Bytes of created strings between two checks of the clock.
const TEXT_EVERY: usize = 64 << 20;

/// Work that the interpreter has done so far, which is compared with the limits.
pub(super) struct Usage {
    /// Number of directives, loop passes and macro calls that the run has executed.
    steps: u64,
    /// Number of steps at which the limits are checked next.
    next_check: u64,
    /// Bytes of strings that were created since the limits were last checked.
    text_made: usize,
    /// Time on the host's clock when the run began.
    started: Duration,
}

impl Usage {
    pub fn new(host: &dyn Host) -> Self {
        Self { steps: 0, next_check: 1, text_made: 0, started: host.monotonic_time() }
    }
}

/// Returns the error at `span` for a run that `cancel` cancels; `None` for one that may go on. `max_time` is the time
/// limit in seconds, for the message.
pub fn cancellation_error(cancel: &CancelToken, max_time: Option<f64>, span: Span) -> Option<Diagnostic> {
    let (message, help) = match cancel.reason()? {
        CancelReason::Request => ("the run was stopped".into(), "its result is no longer needed"),
        CancelReason::TimeLimit => {
            let limit = max_time.map_or_else(|| "its time limit".into(), |seconds| format!("{seconds} seconds"));
            (format!("the scene took more than {limit}"), "--max-time SECONDS allows more")
        }
    };
    Some(Diagnostic::new(codes::TIME_LIMIT, span, message).help(help))
}

impl Reporter<'_> {
    /// Counts one step: a directive, a loop pass or a macro call. An error if a limit is exceeded, which ends the run.
    #[inline]
    pub fn count_step(&mut self, span: Span) -> Result<()> {
        self.usage.steps += 1;
        // A few steps may take long, such as calls of `trace()`: the token is polled at each.
        if self.usage.steps < self.usage.next_check && !self.inputs.options.cancel.is_cancelled() {
            return Ok(());
        }
        self.check_limits_after_step(span)
    }

    /// Checks the limits that are to be checked at the present number of steps.
    #[inline(never)]
    fn check_limits_after_step(&mut self, span: Span) -> Result<()> {
        let options = self.inputs.options;
        let steps = self.usage.steps;
        if steps > options.max_steps {
            let message = format!("the scene took more than {} steps", options.max_steps);
            let help = "is this loop endless? --max-steps N allows more";
            return self.limit_error(codes::STEP_LIMIT, span, message, help);
        }
        let checks_memory_often = options.host.has_cheap_resident_bytes();
        let interval = if checks_memory_often { MEMORY_EVERY } else { CLOCK_EVERY };
        self.usage.next_check =
            (steps / interval * interval).saturating_add(interval).min(options.max_steps.saturating_add(1));
        if steps.is_multiple_of(CLOCK_EVERY) || options.cancel.is_cancelled() {
            return self.check_limits(span);
        }
        if checks_memory_often { self.check_memory(span) } else { Ok(()) }
    }

    /// Counts the bytes of a created string, and checks time and memory once per [`TEXT_EVERY`] bytes, because a few
    /// large strings take as long as many steps.
    pub fn check_limits_after_text(&mut self, bytes: usize, span: Span) -> Result<()> {
        self.usage.text_made += bytes;
        if self.usage.text_made < TEXT_EVERY {
            return Ok(());
        }
        self.usage.text_made = 0;
        self.check_limits(span)
    }

    fn check_limits(&mut self, span: Span) -> Result<()> {
        let options = self.inputs.options;
        if let Some(seconds) = options.max_time
            && options.host.monotonic_time().saturating_sub(self.usage.started).as_secs_f64() > seconds
        {
            options.cancel.cancel(CancelReason::TimeLimit);
        }
        if let Some(diagnostic) = cancellation_error(&options.cancel, options.max_time, span) {
            self.limit_reached = true;
            return diagnostic.into();
        }
        self.check_memory(span)
    }

    fn check_memory(&mut self, span: Span) -> Result<()> {
        if let Some(bytes) = self.inputs.options.max_memory
            && self.inputs.options.host.resident_bytes().is_some_and(|used| used > bytes)
        {
            let message = format!("the scene needs more than {} MiB of memory", bytes >> 20);
            return self.limit_error(codes::MEMORY_LIMIT, span, message, "--max-memory SIZE allows more");
        }
        Ok(())
    }

    /// Returns the error E0242 if the remaining memory cannot hold a function's picture of this size.
    pub fn check_picture_memory(&mut self, [width, height]: [usize; 2], span: Span) -> Result<()> {
        let points = (width as u64).saturating_mul(height as u64);
        let fits = match self.inputs.options.max_memory {
            Some(bytes) => {
                let needed = points.saturating_mul(PER_POINT);
                self.inputs.options.host.resident_bytes().unwrap_or(0).saturating_add(needed) <= bytes
            }
            None => points <= MAX_POINTS,
        };
        if fits {
            return Ok(());
        }
        let message = format!("there is no memory for a picture of {width} by {height} points");
        self.limit_error(codes::MEMORY_LIMIT, span, message, "--max-memory SIZE allows more")
    }

    /// Returns the error of an exceeded limit, which ends the run.
    pub fn limit_error<T>(
        &mut self,
        code: crate::diagnostic::Code,
        span: Span,
        message: String,
        help: &str,
    ) -> Result<T> {
        self.limit_reached = true;
        Diagnostic::new(code, span, message).help(help).into()
    }
}
