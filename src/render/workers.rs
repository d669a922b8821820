//! Work for many threads: the only file that knows rayon. Results come back in the order of the jobs, so nothing ever
//! depends on who did what.

use super::{Cancelled, Watch};
use rayon::prelude::*;

/// Objects that are inside each other 5000 deep, as many as are read, need 17 MB of stack. Only what is used costs memory.
const STACK: usize = 32 << 20;

/// The threads, and who waits for them.
pub(super) struct Workers<'a> {
    pool: Option<rayon::ThreadPool>,
    pub watch: &'a dyn Watch,
}

impl<'a> Workers<'a> {
    /// So many threads; 0: one for each processor.
    pub fn new(threads: usize, watch: &'a dyn Watch) -> Self {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK);
        // A system that gives no threads still gets its picture.
        Self { pool: builder.build().ok(), watch }
    }

    /// What `work` makes of each job, in the order of the jobs; `beside` is done meanwhile.
    pub fn map<J: Sync, T: Send, B: Send>(
        &self,
        jobs: &[J],
        work: impl Fn(&J) -> Result<T, Cancelled> + Sync,
        beside: impl FnOnce() -> B + Send,
    ) -> (Result<Vec<T>, Cancelled>, B) {
        let work = |job: &J| if self.watch.cancelled() { Err(Cancelled) } else { work(job) };
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
    fn results_of_any_kind_stand_in_the_order_of_the_jobs() {
        let jobs: Vec<u64> = (0..1000).collect();
        for threads in [1, 2, 7] {
            let workers = Workers::new(threads, &Unwatched);
            let (words, beside) = workers.map(&jobs, |job| Ok(job.to_string()), || "meanwhile");
            assert_eq!(beside, "meanwhile");
            assert!(words.is_ok_and(|words| words.iter().zip(&jobs).all(|(word, job)| *word == job.to_string())));
        }
    }

    #[test]
    fn one_that_is_cancelled_ends_all() {
        let workers = Workers::new(2, &Unwatched);
        let (all, ()) = workers.map(&[1, 2, 3], |job| if *job == 2 { Err(Cancelled) } else { Ok(()) }, || ());
        assert_eq!(all, Err(Cancelled));
    }
}
