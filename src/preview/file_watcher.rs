//! Detects changes of the files that a scene has looked up.

use crate::source::{ContentHash, Disk, FileKind, Files, LookedUpFiles, Lookup, Lookups, Stamp};
use notify::{RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// Interval at which all watched files of a scene are checked, for file systems that report no changes.
const POLL_INTERVAL: Duration = Duration::from_secs(1);
/// Time without further file events after which the watched files are checked, since editors write in several steps.
const QUIET: Duration = Duration::from_millis(25);
/// Largest number of waits for a quiet time after a file event, before the watched files are checked anyway.
const MAX_WAITS: usize = 12;
/// Largest number of a scene's questions about paths (such as whether a file exists) that are watched for another
/// answer.
const MAX_ANSWERS: usize = 4096;

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
    /// Answers that the storage gave to the scene's questions about paths, such as whether a file exists.
    answers: Vec<Answer>,
}

/// State of a watched file at the last check.
#[derive(Clone, Copy, PartialEq)]
struct File {
    stamp: Option<Stamp>,
    /// Hash of the contents that the scene read; `None` if it could not be read.
    content: Option<ContentHash>,
}

/// Answer that the storage gave to a question about a path.
struct Answer {
    path: PathBuf,
    lookup: Lookup,
    /// True if the storage gave the same answer at the last check.
    was_current: bool,
}

impl Answer {
    /// Returns the folder in which a change may change the answer.
    fn folder(&self) -> PathBuf {
        if matches!(self.lookup, Lookup::Spelling { .. }) {
            self.path.clone()
        } else {
            parent_or_current_folder(&self.path)
        }
    }

    /// True if the answer was current at the last check and is no longer, or the other way round.
    fn update_returning_changed(&mut self) -> bool {
        let is_current = self.lookup.is_current(&Disk, &self.path);
        std::mem::replace(&mut self.was_current, is_current) != is_current
    }
}

/// Returns the state of a regular file, which differs after the file was written; `None` for a missing file, a folder,
/// a device or a pipe.
fn regular_file_stamp(path: &Path) -> Option<Stamp> {
    Disk.metadata(path).ok().filter(|metadata| metadata.kind == FileKind::File)?;
    Disk.stamp(path)
}

fn hash_contents(path: &Path) -> Option<ContentHash> {
    Disk.read(path).ok().map(|bytes| ContentHash::of(&bytes))
}

impl FileWatcher {
    /// Creates a watcher of no files yet, which calls `changed` from a thread of its own after each change of a watched file.
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

    /// Watches the files that a scene has looked up, in place of those watched before, with the contents that were read: a
    /// file that has changed since then is reported at the next check. `scene` is watched, too, even if it could not be read.
    pub fn watch_files(&self, files: &LookedUpFiles, scene: &Path) {
        let mut shared = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
        let LookedUpFiles { read, lookups } = files;
        let file = |path: &Path, read: Option<ContentHash>| {
            let old = shared.files.get(path).copied();
            // The file may have changed after it was read: check it again.
            let known = old.filter(|old| old.content == read);
            (path.to_path_buf(), known.unwrap_or(File { stamp: None, content: read }))
        };
        let unread = (!read.contains_key(scene)).then(|| file(scene, None));
        shared.files = read.iter().map(|(path, hash)| file(path, Some(*hash))).chain(unread).collect();
        shared.answers = answers_of(lookups);
        let folders: BTreeSet<PathBuf> = shared
            .files
            .keys()
            .map(|path| parent_or_current_folder(path))
            .chain(shared.answers.iter().map(Answer::folder))
            .collect();
        let (old, new) = (shared.folders.clone(), folders.clone());
        shared.folders = folders;
        if let Some(watcher) = &mut shared.watcher {
            // Polling covers folders that cannot be watched.
            old.difference(&new).for_each(|gone| _ = watcher.unwatch(gone));
            new.difference(&old).for_each(|come| _ = watcher.watch(come, RecursiveMode::NonRecursive));
        }
    }
}

/// Returns the answers on which the scene depends. Names in a folder are left out: they serve messages and the search for
/// fonts, and any new file would change them.
fn answers_of(lookups: &Lookups) -> Vec<Answer> {
    let answer =
        |path: &PathBuf, lookup: &Lookup| Answer { path: path.clone(), lookup: lookup.clone(), was_current: true };
    let all = lookups.iter().flat_map(|(path, lookups)| lookups.iter().map(move |lookup| answer(path, lookup)));
    all.filter(|answer| !matches!(answer.lookup, Lookup::Names(_))).take(MAX_ANSWERS).collect()
}

fn parent_or_current_folder(path: &Path) -> PathBuf {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_path_buf()
}

fn run(shared: &Mutex<Shared>, events: &Receiver<()>, changed: &dyn Fn()) {
    loop {
        match events.recv_timeout(POLL_INTERVAL) {
            Ok(()) => (0..MAX_WAITS)
                .take_while(|_| events.recv_timeout(QUIET).is_ok())
                .for_each(|_| while events.try_recv().is_ok() {}),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => std::thread::sleep(POLL_INTERVAL),
        }
        let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
        let has_changed = shared.update_returning_changed();
        drop(shared);
        if has_changed {
            changed();
        }
    }
}

impl Shared {
    /// Checks all files and answers; true if one is other than at the last check, which this check replaces.
    fn update_returning_changed(&mut self) -> bool {
        let mut has_changed = false;
        for (path, file) in &mut self.files {
            has_changed |= file.update_returning_changed(path);
        }
        for answer in &mut self.answers {
            has_changed |= answer.update_returning_changed();
        }
        has_changed
    }
}

impl File {
    /// True if the contents differ from those at the last check, which this check replaces.
    fn update_returning_changed(&mut self, path: &Path) -> bool {
        let now = regular_file_stamp(path);
        if now == self.stamp && now.is_some() {
            return false;
        }
        let content = hash_contents(path);
        let changed = content != self.content;
        *self = Self { stamp: now, content };
        changed
    }
}
