//! Computations that are divided among threads, such as the halves of a hierarchy.
//!
//! Whoever starts work on a thread grants it a number of threads with [`with_threads`]; without that it has one, its own.
//! [`join`] and [`map`] divide their work among these threads, which rayon starts when they are needed first. Results
//! never depend on the number of threads.

use super::cancel::CancelToken;
use rayon::prelude::*;
use std::cell::RefCell;
use std::sync::{Arc, OnceLock};

/// Stack of each thread in bytes: hierarchies are built recursively, up to about a hundred levels deep.
const STACK: usize = 8 << 20;

/// Threads among which the work of a thread is divided.
#[derive(Clone, Default)]
enum Team {
    /// Work that is not divided.
    #[default]
    Alone,
    /// Work of a thread outside of the pool that it may use.
    Pool(Arc<Pool>),
    /// Work of a thread of a pool.
    InPool,
}

struct Pool {
    /// Number of threads; 0 for one per processor.
    threads: usize,
    /// The pool, when it was needed; `None` if its threads could not be started, as under a limit on memory.
    started: OnceLock<Option<rayon::ThreadPool>>,
}

impl Pool {
    /// Returns the pool, whose threads are started by the first call; `None` if they could not be started.
    fn started(&self) -> Option<&rayon::ThreadPool> {
        let start = || {
            let builder = rayon::ThreadPoolBuilder::new().num_threads(self.threads);
            let named = builder.thread_name(|i| format!("durer fork {i}")).stack_size(STACK);
            named.start_handler(|_| TEAM.set(Team::InPool)).build().ok()
        };
        self.started.get_or_init(start).as_ref()
    }
}

thread_local! {
    static TEAM: RefCell<Team> = const { RefCell::new(Team::Alone) };
}

/// Runs `work` on the calling thread; meanwhile [`join`] and [`map`] may use this number of threads, or one per
/// processor if it is 0.
pub fn with_threads<T>(threads: usize, work: impl FnOnce() -> T) -> T {
    /// Guard that restores the previous threads when it is dropped, after a panic too.
    struct Restore(Team);
    impl Drop for Restore {
        fn drop(&mut self) {
            TEAM.set(std::mem::take(&mut self.0));
        }
    }
    let team = match threads {
        1 => Team::Alone,
        _ => Team::Pool(Arc::new(Pool { threads, started: OnceLock::new() })),
    };
    let _restore = Restore(TEAM.replace(team));
    work()
}

/// Number of threads that the calling thread's work may use. The first call may start them: a caller asks when it has
/// enough work for several.
pub fn threads() -> usize {
    match TEAM.with_borrow(Team::clone) {
        Team::Alone => 1,
        Team::Pool(pool) => pool.started().map_or(1, rayon::ThreadPool::current_num_threads),
        Team::InPool => rayon::current_num_threads(),
    }
}

/// Runs both parts, at the same time if the calling thread's work may use more than one thread, and returns their
/// results.
///
/// # Panics
/// If one of the parts panics.
pub fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    let token = CancelToken::current();
    divide(|divided| match divided {
        true => rayon::join(|| token.scope(a), || token.scope(b)),
        false => (a(), b()),
    })
}

/// Returns the results of `work` for 0 … `count` - 1, in this order. Each thread computes at least `part_len` of them
/// in a row; `work` is short and does not poll for cancellation.
///
/// # Panics
/// If `work` panics.
pub fn map<T: Send>(count: usize, part_len: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    if count < 2 * part_len {
        return (0..count).map(work).collect();
    }
    let work = &work;
    divide(|divided| match divided {
        true => (0..count).into_par_iter().with_min_len(part_len).map(work).collect(),
        false => (0..count).map(work).collect(),
    })
}

/// Runs `work` with true in the pool of the calling thread's team, or with false on the thread itself if it has none.
fn divide<T: Send>(work: impl FnOnce(bool) -> T + Send) -> T {
    match TEAM.with_borrow(Team::clone) {
        Team::Alone => work(false),
        Team::InPool => work(true),
        Team::Pool(pool) => match pool.started() {
            Some(started) => started.install(|| work(true)),
            None => work(false),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::cancel::{self, CancelReason};

    #[test]
    fn results_are_in_order_for_any_number_of_threads() {
        for threads in [1, 2, 3, 7] {
            for count in [0, 1, 2, 9, 1000] {
                let squares = with_threads(threads, || map(count, 4, |i| i * i));
                assert!(squares.iter().copied().eq((0..count).map(|i| i * i)), "{threads} {count}");
            }
        }
        assert_eq!(threads(), 1);
    }

    #[test]
    fn both_parts_know_threads_and_cancellation() {
        let token = CancelToken::default();
        token.cancel(CancelReason::Request);
        let part = || (threads(), cancel::is_cancelled());
        let both = token.scope(|| with_threads(3, || join(part, || join(part, part))));
        assert_eq!(both, ((3, true), ((3, true), (3, true))));
        assert_eq!(join(part, part), ((1, false), (1, false)));
    }

    #[test]
    fn panics_of_both_parts_reach_the_caller() {
        let panics = |in_first: bool| {
            let panic_if = |it: bool| assert!(!it, "expected");
            let both = || join(|| panic_if(in_first), || panic_if(!in_first));
            std::panic::catch_unwind(|| with_threads(2, both)).is_err()
        };
        assert!(panics(true) && panics(false));
        assert_eq!(threads(), 1);
    }
}
