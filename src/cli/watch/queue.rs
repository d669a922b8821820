//! Queue of one element for the work that the page and changed files ask for.

use crate::math::cancel::{CancelReason, CancelToken};
use crate::preview::PageSettings;
use std::sync::{Condvar, Mutex, PoisonError};

/// Part of a watched picture's work that has to be repeated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Request {
    /// Request to render the picture again, without reading the scene.
    Picture,
    /// Request to read the scene and render the picture.
    Scene,
}

/// Joins all pending requests into one. A new queue contains [`Request::Scene`].
pub struct RenderQueue {
    pending: Mutex<Pending>,
    changed: Condvar,
}

struct Pending {
    request: Option<Request>,
    settings: PageSettings,
    cancel: CancelToken,
}

/// Rendering work that was taken from the queue.
pub struct Work {
    /// Part of the work that has to be repeated.
    pub request: Request,
    /// Settings of the page for the rendering.
    pub settings: PageSettings,
    /// Token that is cancelled as soon as the rendering work is obsolete.
    pub cancel: CancelToken,
}

impl Default for RenderQueue {
    fn default() -> Self {
        let settings = PageSettings { scale: 1.0, antialias: true, quality: 9, clock: None, zoom: None };
        let pending = Pending { request: Some(Request::Scene), settings, cancel: CancelToken::default() };
        Self { pending: Mutex::new(pending), changed: Condvar::new() }
    }
}

impl RenderQueue {
    /// Adds a request with a change of the settings, and stops the present work.
    pub fn push(&self, request: Request, change: impl FnOnce(&mut PageSettings)) {
        let mut pending = self.pending.lock().unwrap_or_else(PoisonError::into_inner);
        pending.request = pending.request.max(Some(request));
        change(&mut pending.settings);
        pending.cancel.cancel(CancelReason::Request);
        self.changed.notify_all();
    }

    /// Waits until the queue has a request, removes it, and returns the rendering work that it asks for.
    pub fn pop(&self) -> Work {
        let pending = self.pending.lock().unwrap_or_else(PoisonError::into_inner);
        let is_empty = |pending: &mut Pending| pending.request.is_none();
        let mut pending = self.changed.wait_while(pending, is_empty).unwrap_or_else(PoisonError::into_inner);
        pending.cancel = CancelToken::default();
        let request = pending.request.take().unwrap_or(Request::Scene);
        Work { request, settings: pending.settings.clone(), cancel: pending.cancel.clone() }
    }
}
