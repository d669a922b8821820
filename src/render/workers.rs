//! Parallel work with rayon, which no other file of this module uses. Results are in the order of the jobs.

use super::{Cancelled, Watch};
use crate::math::cancel::CancelToken;
use crate::source::Activity;
use rayon::prelude::*;

/// Stack of each thread in bytes. Solids that are nested 5000 deep, which is the parser's limit, need 17 MB; unused stack costs no memory.
const STACK: usize = 32 << 20;

/// A pool of worker threads.
pub(super) struct Workers<'a> {
    pool: Option<rayon::ThreadPool>,
    pub watch: &'a dyn Watch,
    token: CancelToken,
}

impl<'a> Workers<'a> {
    /// Creates a pool of `threads` threads; 0 for one per processor.
    pub fn new(threads: usize, watch: &'a dyn Watch) -> Self {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK);
        // Without threads the work is done on the caller's.
        Self { pool: builder.build().ok(), watch, token: watch.cancel_token() }
    }

    /// True if the render must stop, so that later results are invalid.
    pub fn is_cancelled(&self) -> bool {
        self.token.is_cancelled() || self.watch.cancelled()
    }

    /// Runs `work` on each thread of the pool at the same time, and returns when all have ended.
    pub fn run_on_each_thread(&self, work: impl Fn() + Sync) {
        let work = || {
            let _activity = Activity::begin("while the picture was rendered");
            self.token.scope(&work);
        };
        match &self.pool {
            Some(pool) => drop(pool.broadcast(|_| work())),
            None => work(),
        }
    }

    /// Returns the results of `work` for all jobs, in order, and the result of `beside`, which runs at the same time.
    pub fn map<J: Sync, T: Send, B: Send>(
        &self,
        jobs: &[J],
        work: impl Fn(&J) -> Result<T, Cancelled> + Sync,
        beside: impl FnOnce() -> B + Send,
    ) -> (Result<Vec<T>, Cancelled>, B) {
        let work = |job: &J| {
            let _activity = Activity::begin("while the picture was rendered");
            self.token.scope(|| if self.is_cancelled() { Err(Cancelled) } else { work(job) })
        };
        match &self.pool {
            Some(pool) => {
                let all = || jobs.par_iter().with_max_len(1).map(work).collect();
                let (beside, all) = pool.install(|| rayon::join(beside, all));
                (all, beside)
            }
            None => {
                let beside = beside();
                (jobs.iter().map(work).collect(), beside)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Unwatched;

    #[test]
    fn results_are_in_the_order_of_the_jobs() {
        let jobs: Vec<u64> = (0..1000).collect();
        for threads in [1, 2, 7] {
            let workers = Workers::new(threads, &Unwatched);
            let (words, beside) = workers.map(&jobs, |job| Ok(job.to_string()), || "meanwhile");
            assert_eq!(beside, "meanwhile");
            assert!(words.is_ok_and(|words| words.iter().zip(&jobs).all(|(word, job)| *word == job.to_string())));
        }
    }

    #[test]
    fn a_cancelled_job_cancels_all() {
        let workers = Workers::new(2, &Unwatched);
        let (all, ()) = workers.map(&[1, 2, 3], |job| if *job == 2 { Err(Cancelled) } else { Ok(()) }, || ());
        assert_eq!(all, Err(Cancelled));
    }
}
