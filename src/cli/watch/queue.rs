//! Where wishes wait until somebody has time for them.

use crate::preview::Settings;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Arc, Condvar, Mutex, PoisonError};

/// What has to be done again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Request {
    /// The picture.
    Picture,
    /// The scene is read again, too.
    Scene,
}

/// See the module. At first the scene is wished for.
pub struct RenderQueue {
    waiting: Mutex<Waiting>,
    bell: Condvar,
}

struct Waiting {
    request: Option<Request>,
    settings: Settings,
    stop: Arc<AtomicBool>,
}

/// What is to be done next.
pub struct Next {
    /// How much.
    pub request: Request,
    /// How.
    pub settings: Settings,
    /// Set as soon as it is of no use any more.
    pub stop: Arc<AtomicBool>,
}

impl Default for RenderQueue {
    fn default() -> Self {
        let settings = Settings { scale: 1.0, antialias: true, quality: 9, clock: None, zoom: None };
        let waiting = Waiting { request: Some(Request::Scene), settings, stop: Arc::default() };
        Self { waiting: Mutex::new(waiting), bell: Condvar::new() }
    }
}

impl RenderQueue {
    /// Wishes for something, and stops what is being done.
    pub fn push(&self, request: Request, change: impl FnOnce(&mut Settings)) {
        let mut waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        waiting.request = waiting.request.max(Some(request));
        change(&mut waiting.settings);
        waiting.stop.store(true, Relaxed);
        self.bell.notify_all();
    }

    /// Waits for a request.
    pub fn next(&self) -> Next {
        let waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        let mut waiting =
            self.bell.wait_while(waiting, |waiting| waiting.request.is_none()).unwrap_or_else(PoisonError::into_inner);
        waiting.stop = Arc::default();
        let request = waiting.request.take().unwrap_or(Request::Scene);
        Next { request, settings: waiting.settings.clone(), stop: waiting.stop.clone() }
    }

    /// Is it of no use any more?
    pub fn is_stopped(stop: &AtomicBool) -> bool {
        stop.load(Relaxed)
    }
}
