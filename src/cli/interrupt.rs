//! Early end of work: signals such as Ctrl-C, and the time limit of a command.
//!
//! Both cancel the [`CancelToken`] of the work, which every long loop polls. Work that does not end within [`GRACE`],
//! such as a decoder of another crate, is ended together with the process.

use super::args::values::Seconds;
use super::console::print_message;
use super::exit::{Exit, FILE_SIZE_LIMIT, SIGNALS, Signal};
use crate::math::cancel::{CancelReason, CancelToken};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::SeqCst};
use std::sync::{Arc, Condvar, LazyLock, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Time within which cancelled work must end by itself.
const GRACE: Duration = Duration::from_millis(350);

/// Maximum time of the cleanup before the process ends. With [`GRACE`], less than two seconds.
const CLEANUP_TIME: Duration = Duration::from_millis(1500);

/// Time within which a second Ctrl-C is ignored, because programs such as `timeout` send a signal twice at once.
const REPEAT_INTERVAL: Duration = Duration::from_millis(200);

/// Number of the signal that Ctrl-C sends.
#[cfg(not(unix))]
const INTERRUPT: i32 = 2;

/// Number of the first signal that arrived; 0 before a signal.
static REQUESTED: AtomicUsize = AtomicUsize::new(0);
/// Number of the signal XFSZ once it has arrived; 0 before. The handler sets it before the failed write returns.
static FILE_SIZE: LazyLock<Arc<AtomicUsize>> = LazyLock::new(Arc::default);
static DEFERRED: AtomicBool = AtomicBool::new(false);
/// True once cancelled work has noticed the cancellation, so that the process waits for its last messages and writes.
static NOTICED: AtomicBool = AtomicBool::new(false);
/// Tokens of the work that a signal cancels.
static TOKENS: Mutex<Vec<CancelToken>> = Mutex::new(vec![]);
/// Task to run before the process ends in the middle of work, such as writing the journal.
static CLEANUP: Mutex<Option<Box<dyn Fn() + Send>>> = Mutex::new(None);

/// Task that the signal USR1 starts: writes the picture as far as it is finished.
static STATUS_TASK: Mutex<Option<Arc<dyn Fn() + Send + Sync>>> = Mutex::new(None);

/// Installs the handlers of the signals. The second Ctrl-C always ends the program at once.
pub fn listen() {
    // If a handler cannot be installed, the system's default applies.
    #[cfg(unix)]
    let _ = unix::listen();
    #[cfg(not(unix))]
    let _ = {
        let mut first = None;
        ctrlc::set_handler(move || handle_signal(INTERRUPT, &mut first))
    };
}

#[cfg(unix)]
mod unix {
    use super::{FILE_SIZE, FILE_SIZE_LIMIT, SIGNALS, handle_signal, start_status_task};
    use signal_hook::consts::SIGUSR1;
    use signal_hook::flag::register_usize;
    use signal_hook::iterator::Signals;
    use std::io;

    /// Starts the thread that receives the signals.
    pub fn listen() -> io::Result<()> {
        let ignored = ignored_signal_mask();
        let is_wanted = |number: i32| ignored & 1 << (number - 1) == 0;
        if is_wanted(FILE_SIZE_LIMIT) {
            register_usize(FILE_SIZE_LIMIT, FILE_SIZE.clone(), FILE_SIZE_LIMIT as usize)?;
        }
        let wanted = SIGNALS.iter().filter(|signal| !signal.may_be_ignored || is_wanted(signal.number));
        let mut signals = Signals::new(wanted.map(|signal| signal.number).chain([SIGUSR1]))?;
        let mut first = None;
        let receive_all = move || {
            signals.forever().for_each(|number| match number {
                SIGUSR1 => start_status_task(),
                _ => handle_signal(number, &mut first),
            });
        };
        std::thread::Builder::new().name("signals".into()).spawn(receive_all).map(drop)
    }

    /// Returns the set of signals that the process ignores, one bit for each. Only Linux reports the set; elsewhere,
    /// signals that may be ignored keep the system's default.
    fn ignored_signal_mask() -> u64 {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let set = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        set.and_then(|set| u64::from_str_radix(set.trim(), 16).ok()).unwrap_or(u64::MAX)
    }
}

/// Handles a signal: ends the work, or the program if no work can be stored. `first` is the time of the first signal.
fn handle_signal(signal_number: i32, first: &mut Option<Instant>) {
    let Some(signal) = SIGNALS.iter().find(|signal| signal.number == signal_number) else { return };
    if let Some(first) = first {
        if signal.exit == Exit::Interrupted && first.elapsed() > REPEAT_INTERVAL {
            std::process::exit(Exit::Interrupted.number().into());
        }
        return;
    }
    *first = Some(Instant::now());
    REQUESTED.store(signal_number as usize, SeqCst);
    if !DEFERRED.load(SeqCst) {
        end_process(signal.exit, "");
    }
    lock(&TOKENS).iter().for_each(|token| token.cancel(CancelReason::Request));
    let _ = std::thread::Builder::new().name("interrupt".into()).spawn(|| {
        std::thread::sleep(GRACE);
        if DEFERRED.load(SeqCst) && !NOTICED.load(SeqCst) {
            end_process(signal.exit, &format!("{}; no picture was written\n", signal.reason));
        }
    });
}

/// Returns the signal that asked the program to end; `None` before a signal.
pub fn received_end_signal() -> Option<Signal> {
    let number = match REQUESTED.load(SeqCst) {
        0 => FILE_SIZE.load(SeqCst),
        number => number,
    };
    SIGNALS.iter().find(|signal| signal.number as usize == number).copied()
}

/// Records that cancelled work has noticed the cancellation, so that the process does not end before the work's last
/// messages and writes. Returns at once.
pub fn acknowledge_cancellation() {
    NOTICED.store(true, SeqCst);
}

/// Registration of a task that runs if the process ends in the middle of work; removed when this value is dropped.
pub struct Cleanup(());

impl Cleanup {
    /// Registers the one task that runs if the process ends early, in place of an earlier task.
    pub fn register(task: impl Fn() + Send + 'static) -> Self {
        *lock(&CLEANUP) = Some(Box::new(task));
        Self(())
    }
}

impl Drop for Cleanup {
    fn drop(&mut self) {
        *lock(&CLEANUP) = None;
    }
}

/// Registration of the task that the signal USR1 starts; removed when this value is dropped.
pub struct StatusTask(());

impl StatusTask {
    /// Registers a task that runs whenever the signal USR1 arrives, on a thread of its own. Without a task, the signal has
    /// no effect.
    pub fn register(task: impl Fn() + Send + Sync + 'static) -> Self {
        *lock(&STATUS_TASK) = Some(Arc::new(task));
        Self(())
    }
}

impl Drop for StatusTask {
    fn drop(&mut self) {
        *lock(&STATUS_TASK) = None;
    }
}

/// Starts the task of the signal USR1, unless it is running.
#[cfg(unix)]
fn start_status_task() {
    static RUNNING: Mutex<()> = Mutex::new(());
    let Some(task) = lock(&STATUS_TASK).clone() else { return };
    let run = move || {
        if let Ok(_running) = RUNNING.try_lock() {
            task();
        }
    };
    let _ = std::thread::Builder::new().name("status".into()).spawn(run);
}

/// Ends the process in the middle of work, after the cleanup.
///
/// Another thread runs the cleanup and prints the message in limited time, since the calling thread may hold any lock.
pub fn end_process(exit: Exit, message: &str) -> ! {
    let message = message.to_string();
    let (ended, end) = std::sync::mpsc::channel();
    let work = move || {
        if let Some(cleanup) = &*lock(&CLEANUP) {
            cleanup();
        }
        print_message(&message);
        let _ = ended.send(());
    };
    if std::thread::Builder::new().name("end".into()).spawn(work).is_ok() {
        let _ = end.recv_timeout(CLEANUP_TIME);
    }
    std::process::exit(exit.number().into());
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Guard during whose lifetime signals do not end the program, but are only reported by [`received_end_signal`].
pub struct DeferredSignals(());

impl DeferredSignals {
    /// Starts to defer the effect of signals until the returned value is dropped.
    pub fn begin() -> Self {
        DEFERRED.store(true, SeqCst);
        Self(())
    }
}

impl Drop for DeferredSignals {
    fn drop(&mut self) {
        DEFERRED.store(false, SeqCst);
    }
}

/// Treatment of work that has not ended after its time limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overrun {
    /// The process ends, with [`Exit::Limit`].
    EndsProcess,
    /// The work continues, and its result is discarded.
    Continues,
}

/// Guard during whose lifetime signals and a time limit cancel the work.
pub struct Deadline {
    token: CancelToken,
    /// True once the work has ended; the condition variable announces the change.
    is_done: Arc<(Mutex<bool>, Condvar)>,
    timer: Option<JoinHandle<()>>,
}

impl Deadline {
    /// Starts the time limit (`None` for no limit) of work that polls `token`.
    pub fn start(limit: Option<Seconds>, token: CancelToken, overrun: Overrun) -> Self {
        NOTICED.store(false, SeqCst);
        lock(&TOKENS).push(token.clone());
        if received_end_signal().is_some() {
            token.cancel(CancelReason::Request);
        }
        if limit.is_some_and(|Seconds(seconds)| seconds == 0.0) {
            token.cancel(CancelReason::TimeLimit);
        }
        let is_done = Arc::new((Mutex::new(false), Condvar::new()));
        let timer = limit.and_then(|Seconds(seconds)| {
            let end = Instant::now().checked_add(Duration::try_from_secs_f64(seconds).ok()?)?;
            let (token, is_done) = (token.clone(), is_done.clone());
            let wait = move || {
                if is_done_after_wait(end, &is_done) {
                    return;
                }
                token.cancel(CancelReason::TimeLimit);
                if overrun == Overrun::EndsProcess
                    && !is_done_after_wait(Instant::now() + GRACE, &is_done)
                    && !NOTICED.load(SeqCst)
                {
                    let text = format!("error: the scene took more than {seconds} seconds (`--max-time`)\n");
                    end_process(Exit::Limit, &text);
                }
            };
            std::thread::Builder::new().name("deadline".into()).spawn(wait).ok()
        });
        Self { token, is_done, timer }
    }

    /// Returns the token that is cancelled at the end of the time limit and by a signal.
    pub fn token(&self) -> &CancelToken {
        &self.token
    }
}

impl Drop for Deadline {
    fn drop(&mut self) {
        *lock(&self.is_done.0) = true;
        self.is_done.1.notify_all();
        if let Some(timer) = self.timer.take() {
            let _ = timer.join();
        }
        let mut tokens = lock(&TOKENS);
        if let Some(own) = tokens.iter().position(|token| token.is_same_token(&self.token)) {
            tokens.swap_remove(own);
        }
    }
}

/// Sleeps until `end`, or until the work is done; returns true if the work is done.
fn is_done_after_wait(end: Instant, (is_done, changed): &(Mutex<bool>, Condvar)) -> bool {
    let mut done = lock(is_done);
    loop {
        let Some(left) = end.checked_duration_since(Instant::now()).filter(|_| !*done) else { return *done };
        done = changed.wait_timeout(done, left).unwrap_or_else(PoisonError::into_inner).0;
    }
}
