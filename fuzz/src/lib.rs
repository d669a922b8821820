//! Properties that the fuzzers check, one function for each target in `fuzz_targets/`.

pub mod language;
pub mod readers;

pub use libfuzzer_sys::{Corpus, fuzz_target};

use cap::Cap;
use std::alloc::System;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, OnceLock};

/// Most memory that a target may allocate, in bytes. A request beyond it ends the process, which libFuzzer reports.
const MAX_MEMORY: usize = 2 << 30;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, MAX_MEMORY);

/// Number of allocated bytes of the process.
fn allocated_bytes() -> usize {
    ALLOCATOR.allocated()
}

/// Property of arbitrary bytes; panics if the bytes violate it. Bytes that are [`Corpus::Reject`]ed are not mutated
/// further.
pub type Check = fn(&[u8]) -> Corpus;

/// Defines the target of a [`Check`].
#[macro_export]
macro_rules! target {
    ($check:expr) => {
        $crate::fuzz_target!(|bytes: &[u8]| -> $crate::Corpus { $crate::run($check, bytes) });
    };
}

/// Thread with a big stack, which runs all checks. A thread for each check would take longer than most checks.
struct Worker {
    inputs: Sender<(Check, Vec<u8>)>,
    results: Receiver<Corpus>,
}

impl Worker {
    fn start() -> Mutex<Self> {
        let (inputs, waiting) = channel::<(Check, Vec<u8>)>();
        let (done, results) = channel();
        std::thread::spawn(|| {
            durer::on_big_stack(move || waiting.iter().all(|(check, bytes)| done.send(check(&bytes)).is_ok()))
        });
        Mutex::new(Self { inputs, results })
    }
}

/// Runs a check on a thread with a big stack.
///
/// # Panics
/// If the thread has ended.
pub fn run(check: Check, bytes: &[u8]) -> Corpus {
    static WORKER: OnceLock<Mutex<Worker>> = OnceLock::new();
    let worker = WORKER.get_or_init(Worker::start).lock().expect("no check has panicked");
    worker.inputs.send((check, bytes.to_vec())).expect("the worker waits for inputs");
    worker.results.recv().expect("the worker has checked the input")
}
