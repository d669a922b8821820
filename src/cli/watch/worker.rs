//! Runs work that a save makes obsolete, on threads of its own.
//!
//! Cancelled work ends as soon as one of its loops polls its token, and then frees what it has built, which takes seconds
//! for a large scene. The next work does not wait for that end, except for [`GRACE`].

use crate::cli::console::print_message;
use crate::math::cancel::{CancelReason, CancelToken};
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, channel};
use std::time::{Duration, Instant};

/// Time that cancelled work has to end before the next work begins.
const GRACE: Duration = Duration::from_millis(100);
/// Interval in which the token of running work is polled.
const POLL_INTERVAL: Duration = Duration::from_millis(10);
/// Largest number of threads with cancelled work that has not ended yet.
const MAX_ABANDONED: usize = 2;

/// Runner of one piece of work after another.
pub struct Worker<T> {
    /// Channels of cancelled work; each is closed at the end of its work.
    abandoned: Vec<Receiver<T>>,
}

impl<T> Default for Worker<T> {
    fn default() -> Self {
        Self { abandoned: vec![] }
    }
}

impl<T: Send + 'static> Worker<T> {
    /// Runs `work` on a new thread, waits for it and returns its result. `None` if `cancel` was cancelled by a newer
    /// request, the work has panicked, or no thread could be started. A time limit does not end the wait.
    pub fn run_until_superseded(
        &mut self,
        cancel: &CancelToken,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Option<T> {
        self.limit_abandoned_threads();
        let (sender, result) = channel();
        let token = cancel.clone();
        let run = move || {
            let value = work();
            // An obsolete result may be large: this thread frees it.
            if !is_obsolete(&token) {
                let _ = sender.send(value);
            }
        };
        if let Err(error) = std::thread::Builder::new().name("watch".into()).spawn(run) {
            print_message(&format!("durer watch: cannot start a thread: {error}; the next change tries again\n"));
            return None;
        }
        let mut end = None;
        loop {
            match result.recv_timeout(POLL_INTERVAL) {
                Ok(value) => return Some(value),
                Err(RecvTimeoutError::Disconnected) => return None,
                Err(RecvTimeoutError::Timeout) if !is_obsolete(cancel) => {}
                Err(RecvTimeoutError::Timeout) => {
                    if Instant::now() >= *end.get_or_insert_with(|| Instant::now() + GRACE) {
                        self.abandoned.push(result);
                        return None;
                    }
                }
            }
        }
    }

    /// Waits until fewer than [`MAX_ABANDONED`] threads with cancelled work are left, so that fast saves do not add up
    /// threads and memory.
    fn limit_abandoned_threads(&mut self) {
        self.abandoned.retain(|work| matches!(work.try_recv(), Err(TryRecvError::Empty)));
        while self.abandoned.len() >= MAX_ABANDONED {
            let _ = self.abandoned.remove(0).recv();
        }
    }
}

/// Frees a value on a thread of its own: to free a large scene takes long.
pub fn free_on_own_thread(value: impl Send + 'static) {
    // Without a thread, the value is freed here.
    let _ = std::thread::Builder::new().name("discard".into()).spawn(move || drop(value));
}

/// True if a newer request has cancelled the work.
pub fn is_obsolete(cancel: &CancelToken) -> bool {
    cancel.reason() == Some(CancelReason::Request)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cancelled_work_does_not_hold_up_the_next() {
        let (mut worker, cancel) = (Worker::default(), CancelToken::default());
        assert_eq!(worker.run_until_superseded(&cancel, || 1), Some(1));
        let (release, gate) = channel::<()>();
        let (token, start) = (cancel.clone(), Instant::now());
        let work = move || {
            token.cancel(CancelReason::Request);
            let _ = gate.recv_timeout(Duration::from_secs(20));
            2
        };
        assert_eq!(worker.run_until_superseded(&cancel, work), None);
        assert_eq!(worker.run_until_superseded(&CancelToken::default(), || 3), Some(3));
        assert!(start.elapsed() < Duration::from_secs(10));
        assert_eq!(worker.abandoned.len(), 1);
        drop(release);
        let limited = CancelToken::default();
        limited.cancel(CancelReason::TimeLimit);
        assert_eq!(worker.run_until_superseded(&limited, || 4), Some(4));
    }

    #[test]
    fn work_that_panics_has_no_result() {
        assert_eq!(Worker::<()>::default().run_until_superseded(&CancelToken::default(), || panic!()), None);
    }
}
