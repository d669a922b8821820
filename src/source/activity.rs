//! Present activity of the calling thread, which messages about exhausted memory mention.

use std::cell::Cell;

thread_local! {
    static CURRENT: Cell<&'static str> = const { Cell::new("while it was read") };
}

/// An activity of the calling thread, which ends when this value is dropped.
#[derive(Debug)]
pub struct Activity {
    before: &'static str,
}

impl Activity {
    /// Begins an activity; `text` completes "the memory was exhausted …", such as "while a picture was decoded".
    #[must_use]
    pub fn begin(text: &'static str) -> Self {
        Self { before: CURRENT.replace(text) }
    }

    /// Returns the text of the calling thread's present activity.
    pub fn current() -> &'static str {
        CURRENT.get()
    }
}

impl Drop for Activity {
    fn drop(&mut self) {
        CURRENT.set(self.before);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn activities_nest() {
        let before = Activity::current();
        let outer = Activity::begin("outer");
        {
            let _inner = Activity::begin("inner");
            assert_eq!(Activity::current(), "inner");
        }
        assert_eq!(Activity::current(), "outer");
        drop(outer);
        assert_eq!(Activity::current(), before);
    }
}
