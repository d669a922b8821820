//! Ctrl-C ends the program at once, or after cleaning up while a picture is rendered or written.

use super::exit::Exit;
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};

static REQUESTED: AtomicBool = AtomicBool::new(false);
static DEFERRED: AtomicBool = AtomicBool::new(false);

/// Installs the handler. The second Ctrl-C always ends the program at once.
pub fn listen() {
    // If the handler cannot be installed, the system's default applies.
    let _ = ctrlc::set_handler(|| {
        let again = REQUESTED.swap(true, SeqCst);
        if again || !DEFERRED.load(SeqCst) {
            std::process::exit(Exit::Interrupted as i32);
        }
    });
}

/// True after the user pressed Ctrl-C.
pub fn is_requested() -> bool {
    REQUESTED.load(SeqCst)
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
