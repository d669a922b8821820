//! Streams of pseudo-random numbers that `seed()` opened.

use std::cell::{Cell, RefCell};

/// Random streams of a run, by their numbers. The fast evaluation of an expression takes numbers for an attempt, which may
/// fail; the numbers are then taken again by the general evaluation.
#[derive(Default)]
pub struct RandomStreams {
    states: Vec<Cell<u32>>,
    /// Streams from which the present attempt took numbers, with the states before.
    states_before_attempt: RefCell<Vec<(usize, u32)>>,
}

impl RandomStreams {
    /// Opens a stream with this initial state, and returns its number, from 0.
    pub fn open(&mut self, state: u32) -> usize {
        self.states.push(Cell::new(state));
        self.states.len() - 1
    }

    /// Returns the next number of a stream, from 0 to 1, by POV-Ray's generator (quirk: `random_generator`); `None` if no
    /// stream has this number.
    pub fn next(&self, stream: f64) -> Option<f64> {
        self.index(stream).map(|index| self.advance(index))
    }

    /// Returns the next number of a stream like [`Self::next`], for an attempt that [`Self::end_attempt`] ends.
    pub fn try_next(&self, stream: f64) -> Option<f64> {
        let index = self.index(stream)?;
        self.states_before_attempt.borrow_mut().push((index, self.states[index].get()));
        Some(self.advance(index))
    }

    /// Ends an attempt. If it failed, the streams give the numbers again that it took.
    #[inline]
    pub fn end_attempt(&self, succeeded: bool) {
        // (Most scenes open no stream.)
        if self.states.is_empty() {
            return;
        }
        for (index, state) in self.states_before_attempt.borrow_mut().drain(..).rev() {
            if !succeeded {
                self.states[index].set(state);
            }
        }
    }

    fn index(&self, stream: f64) -> Option<usize> {
        Some(stream as usize).filter(|index| stream >= 0.0 && *index < self.states.len())
    }

    fn advance(&self, index: usize) -> f64 {
        let state = self.states[index].get().wrapping_mul(1_812_433_253).wrapping_add(12_345);
        self.states[index].set(state);
        f64::from(state) / f64::from(u32::MAX)
    }
}
