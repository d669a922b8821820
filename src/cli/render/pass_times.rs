//! Durations of the passes that prepare a picture, such as the emission of photons.

use serde::Serialize;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// Durations of passes, in the order in which the passes began. Several threads may record.
#[derive(Debug, Default)]
pub struct PassTimes(Mutex<Vec<Running>>);

/// A pass that has begun.
#[derive(Debug)]
struct Running {
    begin: Instant,
    time: PassTime,
}

/// Duration of a pass.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PassTime {
    /// Name of the pass.
    pub pass: &'static str,
    /// Number of work items.
    pub items: usize,
    /// Time from the begin of the pass to its last finished item, in seconds.
    pub seconds: f64,
}

impl PassTimes {
    /// Records that `done` of the `total` work items of a pass are finished; `done` is 0 at the begin.
    pub fn record(&self, pass: &'static str, done: usize, total: usize) {
        let mut passes = self.lock();
        if done == 0 {
            passes.push(Running { begin: Instant::now(), time: PassTime { pass, items: total, seconds: 0.0 } });
        } else if let Some(last) = passes.last_mut() {
            last.time.seconds = last.begin.elapsed().as_secs_f64();
        }
    }

    /// Returns the durations of all passes so far.
    pub fn all(&self) -> Vec<PassTime> {
        self.lock().iter().map(|running| running.time.clone()).collect()
    }

    fn lock(&self) -> MutexGuard<'_, Vec<Running>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_are_listed_in_the_order_of_their_begin() {
        let times = PassTimes::default();
        for (pass, total) in [("photons", 2), ("radiosity", 1), ("radiosity", 3)] {
            (0..=total).for_each(|done| times.record(pass, done, total));
        }
        let names: Vec<_> = times.all().iter().map(|time| (time.pass, time.items)).collect();
        assert_eq!(names, [("photons", 2), ("radiosity", 1), ("radiosity", 3)]);
        assert!(times.all().iter().all(|time| time.seconds > 0.0));
    }
}
