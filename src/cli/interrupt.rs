//! Ctrl-C: at once while nothing is at stake, in an orderly way while a picture is drawn or written.

use super::exit::Exit;
use std::sync::atomic::{AtomicBool, Ordering::SeqCst};

static ASKED: AtomicBool = AtomicBool::new(false);
static ORDERLY: AtomicBool = AtomicBool::new(false);

/// Listens from now on. The second Ctrl-C always ends the program at once.
pub fn listen() {
    // Where no handler can be set, Ctrl-C does what the system does.
    let _ = ctrlc::set_handler(|| {
        let again = ASKED.swap(true, SeqCst);
        if again || !ORDERLY.load(SeqCst) {
            std::process::exit(Exit::Interrupted as i32);
        }
    });
}

/// Was Ctrl-C pressed?
pub fn asked() -> bool {
    ASKED.load(SeqCst)
}

/// As long as this lives, Ctrl-C only asks.
pub struct Orderly(());

impl Orderly {
    /// From now on.
    pub fn begin() -> Self {
        ORDERLY.store(true, SeqCst);
        Self(())
    }
}

impl Drop for Orderly {
    fn drop(&mut self) {
        ORDERLY.store(false, SeqCst);
    }
}
