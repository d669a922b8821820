//! Detects changes of the files that a scene has read.

use crate::source::{ContentHash, ReadFiles};
use notify::{RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, SystemTime};

/// Interval of polling, for file systems that report no changes.
const POLL_INTERVAL: Duration = Duration::from_secs(1);
/// Quiet time after a change: editors write in several steps.
const QUIET: Duration = Duration::from_millis(25);
/// Largest number of quiet times that are waited for.
const MAX_WAITS: usize = 12;

/// Watcher that reports changes of a scene's files.
pub struct FileWatcher {
    shared: Arc<Mutex<Shared>>,
}

#[derive(Default)]
struct Shared {
    /// The system's file watcher; `None` if the system allows no further one.
    watcher: Option<RecommendedWatcher>,
    folders: BTreeSet<PathBuf>,
    files: BTreeMap<PathBuf, File>,
    /// True if a file may have been missing: any change in the folders then counts.
    missing: bool,
}

/// State of a watched file at the last check.
#[derive(Clone, Copy, PartialEq)]
struct File {
    stamp: Stamp,
    /// Hash of the contents that the scene read.
    content: Option<ContentHash>,
}

/// Length of a watched file and time of its last modification; `None` without a file.
type Stamp = Option<(u64, Option<SystemTime>)>;

fn stamp(path: &Path) -> Stamp {
    let meta = std::fs::metadata(path).ok()?;
    Some((meta.len(), meta.modified().ok()))
}

fn content(path: &Path) -> Option<ContentHash> {
    std::fs::read(path).ok().map(|bytes| ContentHash::of(&bytes))
}

impl FileWatcher {
    /// Calls `changed` from a thread of its own after each change of a watched file.
    pub fn new(changed: impl Fn() + Send + 'static) -> Self {
        let (sender, events) = channel();
        let notify = move |event: notify::Result<notify::Event>| {
            // Ignore reads.
            if !event.as_ref().is_ok_and(|event| event.kind.is_access()) {
                let _ = sender.send(());
            }
        };
        let watcher = notify::recommended_watcher(notify).ok();
        let shared = Arc::new(Mutex::new(Shared { watcher, ..Shared::default() }));
        let of_thread = shared.clone();
        // Without a thread no change is detected.
        let _ = std::thread::Builder::new().name("files".into()).spawn(move || run(&of_thread, &events, &changed));
        Self { shared }
    }

    /// Watches the files `read`, with the contents that were read: a file that has changed since then is reported at
    /// once. `scene` is watched, too, even if it could not be read. `missing` is true if the scene may have searched
    /// for files that do not exist.
    pub fn follow(&self, read: &ReadFiles, scene: &Path, missing: bool) {
        let mut shared = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
        let file = |path: &Path, read: Option<ContentHash>| {
            let old = shared.files.get(path).copied();
            // The file may have changed after it was read: check it again.
            let known = old.filter(|old| old.content == read);
            (path.to_path_buf(), known.unwrap_or(File { stamp: None, content: read }))
        };
        let gone = (!read.contains_key(scene)).then(|| file(scene, None));
        let files = read.iter().map(|(path, hash)| file(path, Some(*hash))).chain(gone).collect();
        (shared.files, shared.missing) = (files, missing);
        let folders: BTreeSet<PathBuf> = shared.files.keys().map(|path| folder(path)).collect();
        let (old, new) = (shared.folders.clone(), folders.clone());
        shared.folders = folders;
        if let Some(watcher) = &mut shared.watcher {
            // Polling covers folders that cannot be watched.
            old.difference(&new).for_each(|gone| _ = watcher.unwatch(gone));
            new.difference(&old).for_each(|come| _ = watcher.watch(come, RecursiveMode::NonRecursive));
        }
    }
}

fn folder(path: &Path) -> PathBuf {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_path_buf()
}

fn run(shared: &Mutex<Shared>, events: &Receiver<()>, changed: &dyn Fn()) {
    loop {
        let notified = match events.recv_timeout(POLL_INTERVAL) {
            Ok(()) => {
                (0..MAX_WAITS)
                    .take_while(|_| events.recv_timeout(QUIET).is_ok())
                    .for_each(|_| while events.try_recv().is_ok() {});
                true
            }
            Err(RecvTimeoutError::Timeout) => false,
            Err(RecvTimeoutError::Disconnected) => {
                std::thread::sleep(POLL_INTERVAL);
                false
            }
        };
        let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
        let changes = shared.files.iter_mut().filter_map(|(path, file)| file.has_changed(path).then_some(())).count();
        let appeared = notified && shared.missing;
        drop(shared);
        if changes > 0 || appeared {
            changed();
        }
    }
}

impl File {
    /// True if the contents differ from those at the last check.
    fn has_changed(&mut self, path: &Path) -> bool {
        let now = stamp(path);
        if now == self.stamp && now.is_some() {
            return false;
        }
        let content = content(path);
        let changed = content != self.content;
        *self = Self { stamp: now, content };
        changed
    }
}
