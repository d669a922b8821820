//! Ends work early: Ctrl-C, and the time limit of a command.
//!
//! Both cancel the work's [`CancelToken`], which every long loop polls. Work that does not end within [`GRACE`], such
//! as a decoder of another crate, is ended together with the process.

use super::args::values::Seconds;
use super::console::print_message;
use super::exit::Exit;
use crate::math::cancel::{CancelReason, CancelToken};
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Time that cancelled work has to end by itself.
const GRACE: Duration = Duration::from_millis(350);

/// Time for the cleanup at the end of the process.
const CLEANUP_TIME: Duration = Duration::from_secs(2);

static REQUESTED: AtomicBool = AtomicBool::new(false);
static DEFERRED: AtomicBool = AtomicBool::new(false);
/// True as soon as cancelled work has noticed that it is to end: its last messages and writes then get the time they
/// need.
static NOTICED: AtomicBool = AtomicBool::new(false);
/// Tokens of the work that Ctrl-C cancels.
static TOKENS: Mutex<Vec<CancelToken>> = Mutex::new(vec![]);
/// Task to do before the process ends in the middle of work, such as writing the journal.
static CLEANUP: Mutex<Option<Box<dyn Fn() + Send>>> = Mutex::new(None);

/// Installs the handler. The second Ctrl-C always ends the program at once.
pub fn listen() {
    // If the handler cannot be installed, the system's default applies.
    let _ = ctrlc::set_handler(|| {
        let again = REQUESTED.swap(true, SeqCst);
        if again || !DEFERRED.load(SeqCst) {
            std::process::exit(Exit::Interrupted as i32);
        }
        lock(&TOKENS).iter().for_each(|token| token.cancel(CancelReason::Request));
        let _ = std::thread::Builder::new().name("interrupt".into()).spawn(|| {
            std::thread::sleep(GRACE);
            if DEFERRED.load(SeqCst) && !NOTICED.load(SeqCst) {
                end_process(Exit::Interrupted, "interrupted; no picture was written\n");
            }
        });
    });
}

/// True after the user pressed Ctrl-C.
pub fn is_requested() -> bool {
    REQUESTED.load(SeqCst)
}

/// Keeps the process alive until cancelled work, which has noticed its cancellation, has finished properly.
pub fn await_cancelled_work() {
    NOTICED.store(true, SeqCst);
}

/// Sets what must happen before the process ends in the middle of work; replaces an earlier cleanup.
pub fn set_cleanup(cleanup: Option<Box<dyn Fn() + Send>>) {
    *lock(&CLEANUP) = cleanup;
}

/// Ends the process in the middle of work, after the cleanup.
///
/// The calling thread may hold any lock, so that cleanup and message are the work of another thread, which gets limited
/// time.
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
    std::process::exit(exit as i32);
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// While a value of this type exists, Ctrl-C does not end the program, but is visible in [`is_requested`].
pub struct Deferred(());

impl Deferred {
    /// Starts to defer the effect of Ctrl-C.
    pub fn begin() -> Self {
        DEFERRED.store(true, SeqCst);
        Self(())
    }
}

impl Drop for Deferred {
    fn drop(&mut self) {
        DEFERRED.store(false, SeqCst);
    }
}

/// End of work that does not end by itself after its time limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overrun {
    /// The process ends with [`Exit::Limit`].
    EndsProcess,
    /// The work goes on, and its result is discarded.
    Continues,
}

/// Work that Ctrl-C and a time limit cancel while this value exists.
pub struct Deadline {
    token: CancelToken,
    /// True after the end of the work.
    is_done: Arc<(Mutex<bool>, Condvar)>,
    timer: Option<JoinHandle<()>>,
}

impl Deadline {
    /// Starts the time limit of work that polls `token`; `None` for no limit.
    pub fn start(limit: Option<Seconds>, token: CancelToken, overrun: Overrun) -> Self {
        NOTICED.store(false, SeqCst);
        lock(&TOKENS).push(token.clone());
        if is_requested() {
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
                if sleep_until(end, &is_done) {
                    return;
                }
                token.cancel(CancelReason::TimeLimit);
                if overrun == Overrun::EndsProcess
                    && !sleep_until(Instant::now() + GRACE, &is_done)
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

    /// The token that is cancelled at the end of the time limit.
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

/// Sleeps until `end`, or until the work is done; true if the work is done.
fn sleep_until(end: Instant, (is_done, changed): &(Mutex<bool>, Condvar)) -> bool {
    let mut done = lock(is_done);
    loop {
        let Some(left) = end.checked_duration_since(Instant::now()).filter(|_| !*done) else { return *done };
        done = changed.wait_timeout(done, left).unwrap_or_else(PoisonError::into_inner).0;
    }
}
