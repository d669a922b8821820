//! Cancellation: a flag that another thread sets to end a run early, and the poll of that flag in long loops.
//!
//! Whoever starts work on a thread installs its token with [`CancelToken::scope`]. Every loop that can take long, however
//! deep below, polls [`is_cancelled`] and then returns early with any result; whoever started the work discards that
//! result. So a kernel needs no parameter and no error for cancellation.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

/// Flag that ends a run early. Clones share the flag.
#[derive(Clone, Debug, Default)]
pub struct CancelToken(Arc<AtomicU8>);

/// Reason for which a run was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CancelReason {
    /// Somebody asked for the end, or no longer needs the result.
    Request = 1,
    /// The time limit was reached.
    TimeLimit = 2,
}

thread_local! {
    /// Cancellation token of the work that the thread does now.
    static CURRENT: RefCell<Option<CancelToken>> = const { RefCell::new(None) };
}

impl CancelToken {
    /// Asks the work that polls this token to end. The first reason remains.
    pub fn cancel(&self, reason: CancelReason) {
        let _ = self.0.compare_exchange(0, reason as u8, Ordering::Relaxed, Ordering::Relaxed);
    }

    /// True once [`CancelToken::cancel`] was called on this token or on a clone of it.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed) != 0
    }

    /// Returns the reason of the first [`CancelToken::cancel`]; `None` before.
    pub fn reason(&self) -> Option<CancelReason> {
        match self.0.load(Ordering::Relaxed) {
            0 => None,
            1 => Some(CancelReason::Request),
            _ => Some(CancelReason::TimeLimit),
        }
    }

    /// True if both are clones of one token.
    pub fn is_same_token(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Returns the token of the work that the calling thread does; a token that nobody cancels outside of any
    /// [`CancelToken::scope`].
    pub fn current() -> Self {
        CURRENT.with(|current| current.borrow().clone()).unwrap_or_default()
    }

    /// Runs `work` on the calling thread, whose polls by [`is_cancelled`] refer to this token meanwhile.
    pub fn scope<T>(&self, work: impl FnOnce() -> T) -> T {
        /// Guard that makes the thread's previous token current again when it is dropped, after a panic too.
        struct Restore(Option<CancelToken>);
        impl Drop for Restore {
            fn drop(&mut self) {
                CURRENT.with(|current| current.replace(self.0.take()));
            }
        }
        let _restore = Restore(CURRENT.with(|current| current.replace(Some(self.clone()))));
        work()
    }
}

/// True if the work that the calling thread does was cancelled: the result of a loop then no longer matters, so that the
/// loop returns early.
pub fn is_cancelled() -> bool {
    CURRENT.with(|current| current.borrow().as_ref().is_some_and(CancelToken::is_cancelled))
}

/// Poll of [`is_cancelled`] in one of 256 passes of a loop whose passes are short, the first included.
#[derive(Debug)]
pub struct Poll(u8);

impl Default for Poll {
    fn default() -> Self {
        Self(u8::MAX)
    }
}

impl Poll {
    /// Counts a pass of the loop; true if the work was found to be cancelled.
    #[inline]
    pub fn is_cancelled(&mut self) -> bool {
        self.0 = self.0.wrapping_add(1);
        self.0 == 0 && is_cancelled()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scopes_nest_and_end() {
        let (outer, inner) = (CancelToken::default(), CancelToken::default());
        outer.cancel(CancelReason::TimeLimit);
        outer.cancel(CancelReason::Request);
        assert_eq!((outer.reason(), inner.reason()), (Some(CancelReason::TimeLimit), None));
        assert!(!is_cancelled());
        outer.scope(|| {
            assert!(is_cancelled());
            inner.scope(|| assert!(!is_cancelled()));
            assert!(std::panic::catch_unwind(|| inner.scope(|| panic!())).is_err());
            assert!(is_cancelled() && CancelToken::current().is_cancelled());
        });
        assert!(!is_cancelled());
    }

    #[test]
    fn a_poll_notices_within_256_passes() {
        let token = CancelToken::default();
        token.cancel(CancelReason::Request);
        let passes = token.scope(|| {
            let mut poll = Poll::default();
            (1..).find(|_| poll.is_cancelled())
        });
        assert!(passes.is_some_and(|n| n <= 256));
    }
}
