//! Diagnostics and limits of a run.

pub(super) mod hints;
mod limits;
mod mistake;

use crate::diagnostic::Diagnostic;
use crate::source::Span;
pub(super) use limits::{MAX_CALLS, MAX_INCLUDES};
use std::collections::BTreeMap;
use std::time::Instant;

/// Diagnostics and limits of a run.
pub(super) struct Reporter<'a> {
    pub(super) debug: &'a mut dyn FnMut(&str),
    /// Faults of the text, told behind those of the run.
    pub(super) late: Vec<Diagnostic>,
    pub(super) steps: u64,
    /// Bytes of strings made since memory was looked at.
    pub(super) text_made: usize,
    pub(super) started: Instant,
    pub(super) diagnostics: Vec<Diagnostic>,
    pub(super) limit_reached: bool,
    /// Did a branch run? By its place; noted where [`super::Options::branches`] asks for it.
    pub(super) branches: BTreeMap<Span, bool>,
    /// Faults met, also those that were told before.
    pub(super) faults: usize,
    /// What earlier faults have left undone.
    mistakes: mistake::Mistakes,
}

impl<'a> Reporter<'a> {
    pub(super) fn new(debug: &'a mut dyn FnMut(&str)) -> Self {
        Self {
            debug,
            late: vec![],
            steps: 0,
            text_made: 0,
            started: Instant::now(),
            diagnostics: vec![],
            limit_reached: false,
            branches: BTreeMap::new(),
            faults: 0,
            mistakes: mistake::Mistakes::default(),
        }
    }
}
