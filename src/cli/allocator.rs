//! The program's memory allocator: the system's allocator, with a count of the bytes in use and a limit.
//!
//! A scene that needs more than `--max-memory` ends the process with a message before the memory is taken, whatever
//! code requests the memory.

use super::exit::Exit;
use super::interrupt;
use crate::source::{Activity, Host, LocalHost};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::atomic::{AtomicBool, AtomicIsize, AtomicUsize, Ordering::Relaxed};
use std::time::Duration;

/// Number of bytes that a thread allocates or frees before it updates the common count, which should be rare.
const COUNTED_BATCH: isize = 16 << 10;

static USED: AtomicIsize = AtomicIsize::new(0);
static LIMIT: AtomicUsize = AtomicUsize::new(usize::MAX);

thread_local! {
    /// Bytes that this thread has allocated and not yet added to [`USED`]; negative if it freed more.
    static UNCOUNTED: Cell<isize> = const { Cell::new(0) };
}

/// Global allocator that counts the bytes in use, and ends the process above the limit of [`end_process_above_bytes`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Metered;

/// Makes the process end as soon as more than `bytes` are in use; `None` for no limit.
pub fn end_process_above_bytes(bytes: Option<u64>) {
    LIMIT.store(bytes.and_then(|bytes| usize::try_from(bytes).ok()).unwrap_or(usize::MAX), Relaxed);
}

/// Returns the number of bytes that the process has allocated and not freed; 0 if [`Metered`] is not the program's
/// allocator.
fn allocated_bytes() -> usize {
    USED.load(Relaxed).max(0) as usize
}

/// Returns the bytes that the system's allocator takes for an allocation of `size` bytes: 8 bytes of its own, rounded up
/// to a multiple of 16 (GNU C Library manual, "The GNU Allocator"). Small allocations would count too little without.
const fn size_with_overhead(size: usize) -> isize {
    (size.saturating_add(8 + 15) & !15) as isize
}

/// Adds to the count of allocated bytes, and ends the process if the count is above the limit. `bytes` is negative for
/// memory that is freed.
fn count_allocation(bytes: isize) {
    // A thread that ends has no count any more; what it frees then is negligible.
    let _ = UNCOUNTED.try_with(|uncounted| {
        let sum = uncounted.get() + bytes;
        if sum.abs() < COUNTED_BATCH {
            return uncounted.set(sum);
        }
        uncounted.set(0);
        let used = USED.fetch_add(sum, Relaxed) + sum;
        if sum > 0 && used as usize > LIMIT.load(Relaxed) {
            end_process_over_limit();
        }
    });
}

/// Reports that the memory limit is reached, and ends the process.
#[cold]
fn end_process_over_limit() -> ! {
    let limit = LIMIT.swap(usize::MAX, Relaxed);
    if limit == usize::MAX {
        // Another thread is ending the process.
        std::thread::sleep(Duration::from_secs(60));
    }
    let activity = Activity::current();
    let text = format!(
        "error[E0242]: the scene needs more than {} MiB of memory ({activity})\n  help: --max-memory SIZE allows more\n",
        limit >> 20
    );
    interrupt::end_process(Exit::Limit, &text)
}

#[expect(unsafe_code, reason = "an allocator is unsafe by its nature")]
// SAFETY: all methods pass their arguments to the system's allocator; counting does not touch the memory.
unsafe impl GlobalAlloc for Metered {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count_allocation(size_with_overhead(layout.size()));
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count_allocation(size_with_overhead(layout.size()));
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        count_allocation(-size_with_overhead(layout.size()));
        unsafe { System.dealloc(memory, layout) }
    }

    unsafe fn realloc(&self, memory: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // The system moves the pages of large lists that grow, and does not copy them.
        count_allocation(size_with_overhead(size) - size_with_overhead(layout.size()));
        unsafe { System.realloc(memory, layout, size) }
    }
}

/// The machine as a [`Host`], with the memory count of [`Metered`]. The value of `now` stays fixed, so that a resumed
/// render can use the `now` of its first run.
#[derive(Debug)]
pub struct MeteredHost {
    machine: LocalHost,
    /// Value of `now`, as time since the beginning of 1970.
    now: Duration,
    /// True if the scene has used `now`.
    has_used_now: AtomicBool,
}

impl Default for MeteredHost {
    fn default() -> Self {
        Self::new(None)
    }
}

impl MeteredHost {
    /// Creates the clock and memory meter of a run. `since_1970` is the time since 1970 (UTC) for the scene's constant
    /// `now`; `None` for the present time.
    pub fn new(since_1970: Option<Duration>) -> Self {
        let machine = LocalHost::default();
        let now = since_1970.unwrap_or_else(|| machine.since_1970());
        Self { machine, now, has_used_now: AtomicBool::new(false) }
    }

    /// Returns the value of `now` if the scene has used it.
    pub fn now_if_used(&self) -> Option<Duration> {
        self.has_used_now.load(Relaxed).then_some(self.now)
    }
}

impl Host for MeteredHost {
    fn monotonic_time(&self) -> Duration {
        self.machine.monotonic_time()
    }

    fn since_1970(&self) -> Duration {
        self.has_used_now.store(true, Relaxed);
        self.now
    }

    fn resident_bytes(&self) -> Option<u64> {
        match allocated_bytes() {
            // The program has another allocator.
            0 => self.machine.resident_bytes(),
            used => Some(used as u64),
        }
    }

    fn has_cheap_resident_bytes(&self) -> bool {
        allocated_bytes() != 0
    }
}
