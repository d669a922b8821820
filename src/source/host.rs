//! Clocks and memory meter of the machine, given by the caller.

use std::fmt::Debug;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Clocks and memory meter of the machine on which a run takes place; file access is in [`Files`](super::Files).
pub trait Host: Debug + Send + Sync {
    /// Returns the time since a fixed moment, which the host chooses: only differences have a meaning.
    fn monotonic_time(&self) -> Duration;

    /// Returns the time since the beginning of the year 1970 in UTC, for the built-in variable `now`.
    fn since_1970(&self) -> Duration;

    /// Returns the memory that the process occupies, in bytes; `None` if the system does not report it.
    fn resident_bytes(&self) -> Option<u64>;

    /// True if [`Host::resident_bytes`] is as cheap as reading a variable.
    fn has_cheap_resident_bytes(&self) -> bool {
        false
    }
}

/// The machine on which the program runs.
#[derive(Clone, Copy, Debug)]
pub struct LocalHost {
    started: Instant,
}

impl Default for LocalHost {
    fn default() -> Self {
        Self { started: Instant::now() }
    }
}

impl Host for LocalHost {
    fn monotonic_time(&self) -> Duration {
        self.started.elapsed()
    }

    fn since_1970(&self) -> Duration {
        SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default()
    }

    fn resident_bytes(&self) -> Option<u64> {
        // Linux: the second number counts pages.
        let pages = std::fs::read_to_string("/proc/self/statm").ok()?;
        Some(pages.split(' ').nth(1)?.parse::<u64>().ok()? * 4096)
    }
}
