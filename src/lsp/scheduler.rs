//! Starts the background runs of open scenes, and ends those whose result nobody needs.
//!
//! A cancelled run ends as soon as one of its loops polls its token. Until then it counts as active, so that fast typing
//! into a slow scene never adds up threads.

use super::run::{self, Job, RunResult};
use super::server::{Client, Event, Server};
use crate::math::cancel::{CancelReason, CancelToken};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Time after the last change before a scene is run.
const PAUSE: Duration = Duration::from_millis(250);
/// Largest number of active runs, including cancelled ones that have not ended yet.
const MAX_ACTIVE: usize = 3;

/// Runs that were started and have not ended yet.
#[derive(Default)]
pub struct ActiveRuns {
    active: Vec<ActiveRun>,
    /// Number of runs that were started so far.
    n_started: u64,
}

/// A run that was started and has not ended yet.
struct ActiveRun {
    number: u64,
    cancel: CancelToken,
    /// Time at which the run is cancelled.
    deadline: Instant,
}

impl ActiveRuns {
    /// Cancels all runs.
    pub fn cancel_all(&self) {
        self.active.iter().for_each(|run| run.cancel.cancel(CancelReason::Request));
    }

    /// Removes a run that has ended.
    fn remove(&mut self, number: u64) {
        self.active.retain(|run| run.number != number);
    }

    /// Cancels the runs whose time limit is reached.
    fn cancel_overdue(&self, now: Instant) {
        let overdue = self.active.iter().filter(|run| run.deadline <= now);
        overdue.for_each(|run| run.cancel.cancel(CancelReason::TimeLimit));
    }
}

impl<S: Client> Server<S> {
    /// Schedules a run of the open scenes that read the text with this address, and cancels their active runs.
    pub(in crate::lsp) fn schedule_scenes_reading(&mut self, address: &str) {
        let due = Some(Instant::now() + PAUSE);
        for scene in self.scenes_reading(address) {
            if let Some(document) = self.open.get_mut(&scene) {
                document.due = due;
                if let Some(cancel) = document.cancel.take() {
                    cancel.cancel(CancelReason::Request);
                }
            }
        }
    }

    /// Returns the time at which the language server has to act next: start a scheduled run, or cancel an active one at its
    /// time limit; `None` if it has only to wait for events.
    pub(in crate::lsp) fn next_action_time(&self) -> Option<Instant> {
        let runs = &self.runs.active;
        let is_free = runs.len() < MAX_ACTIVE;
        let due = self.open.values().filter_map(|document| document.due).filter(|_| is_free);
        due.chain(runs.iter().filter(|run| !run.cancel.is_cancelled()).map(|run| run.deadline)).min()
    }

    /// Starts the runs that are due, and cancels those that take too long.
    pub(in crate::lsp) fn update_runs(&mut self) {
        let now = Instant::now();
        self.runs.cancel_overdue(now);
        let is_due =
            |(key, due): (&String, Option<Instant>)| due.filter(|due| *due <= now).map(|due| (due, key.clone()));
        let mut due: Vec<_> = self.open.iter().map(|(key, d)| (key, d.due)).filter_map(is_due).collect();
        due.sort();
        let free = MAX_ACTIVE.saturating_sub(self.runs.active.len());
        due.into_iter().take(free).for_each(|(_, key)| self.start_run(key, now));
    }

    fn start_run(&mut self, key: String, now: Instant) {
        let others = self.open.iter().filter(|(other, _)| **other != key);
        let open =
            others.filter_map(|(_, other)| Some((other.path.clone()?, other.text.as_str().to_string()))).collect();
        let Some(document) = self.open.get_mut(&key) else { return };
        let cancel = CancelToken::default();
        (document.due, document.cancel) = (None, Some(cancel.clone()));
        self.runs.n_started += 1;
        let number = self.runs.n_started;
        let job = Job {
            number,
            uri: key,
            version: document.version,
            path: document.path.clone(),
            text: document.text.as_str().to_string(),
            open,
            include: self.include.clone(),
            cancel: cancel.clone(),
        };
        let events = self.events.clone();
        let is_started = run::start(job, move |ran| {
            events.send(Event::RunEnded(ran)).ok();
        });
        // Without a thread there is no result: the next change tries again.
        if is_started {
            self.runs.active.push(ActiveRun { number, cancel, deadline: now + run::MAX_TIME });
        }
    }

    /// Publishes the result of a run, unless the text has changed since.
    pub(in crate::lsp) fn end_run(&mut self, ran: RunResult) {
        self.runs.remove(ran.number);
        let Some(document) = self.open.get_mut(&ran.uri) else { return };
        if document.version != ran.version || document.due.is_some() {
            return;
        }
        document.cancel = None;
        let mut found = BTreeMap::new();
        for (path, diagnostics) in ran.diagnostics {
            let address = match path {
                None => Some(ran.uri.clone()),
                Some(path) => self.address_of_path(&path),
            };
            found.extend(address.map(|address| (address, diagnostics)));
        }
        let old = self.results.insert(ran.uri.clone(), found).unwrap_or_default();
        let new = self.results.get(&ran.uri).into_iter().flat_map(BTreeMap::keys);
        let mut all: Vec<String> = old.into_keys().chain(new.cloned()).chain([ran.uri]).collect();
        all.sort();
        all.dedup();
        all.iter().for_each(|address| self.publish(address));
    }
}
