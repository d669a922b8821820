//! Tells when a file that a scene has read is another one.

use crate::source::{ContentHash, ReadFiles};
use notify::{RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, SystemTime};

/// Where nothing tells of changes (there are file systems that don't), files are looked at so often.
const OFTEN: Duration = Duration::from_secs(1);
/// Editors write in several steps: the files are read when nothing has happened for so long.
const STILL: Duration = Duration::from_millis(25);
/// But no later than after so many waits.
const PATIENCE: usize = 12;

/// Files that are watched.
pub struct Files {
    shared: Arc<Mutex<Shared>>,
}

#[derive(Default)]
struct Shared {
    /// `None` where the system has no room for one more watcher.
    watcher: Option<RecommendedWatcher>,
    folders: BTreeSet<PathBuf>,
    files: BTreeMap<PathBuf, File>,
    /// Something was looked for and not there: whatever appears in the folders may be it.
    missing: bool,
}

/// A file as it was when it was looked at last.
#[derive(Clone, Copy, PartialEq)]
struct File {
    stamp: Stamp,
    /// What stood in it when the scene read it.
    content: Option<ContentHash>,
}

/// Length and age; `None` if there is no file.
type Stamp = Option<(u64, Option<SystemTime>)>;

fn stamp(path: &Path) -> Stamp {
    let meta = std::fs::metadata(path).ok()?;
    Some((meta.len(), meta.modified().ok()))
}

fn content(path: &Path) -> Option<ContentHash> {
    std::fs::read(path).ok().map(|bytes| ContentHash::of(&bytes))
}

impl Files {
    /// Calls `changed` from a thread of its own whenever one of the files is another one.
    pub fn new(changed: impl Fn() + Send + 'static) -> Self {
        let (sender, events) = channel();
        let tell = move |event: notify::Result<notify::Event>| {
            // Reading is no change.
            if !event.as_ref().is_ok_and(|event| event.kind.is_access()) {
                let _ = sender.send(());
            }
        };
        let watcher = notify::recommended_watcher(tell).ok();
        let shared = Arc::new(Mutex::new(Shared { watcher, ..Shared::default() }));
        let of_thread = shared.clone();
        // Without a thread the scene is drawn once.
        let _ = std::thread::Builder::new().name("files".into()).spawn(move || look(&of_thread, &events, &changed));
        Self { shared }
    }

    /// From now on these files count, with what stood in them when they were read. Is one of them another one already, that is told.
    /// `scene` counts too, if it is not among them because it is gone. `missing` says that something may not have been found.
    pub fn follow(&self, seen: &ReadFiles, scene: &Path, missing: bool) {
        let mut shared = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
        let file = |path: &Path, read: Option<ContentHash>| {
            let old = shared.files.get(path).copied();
            // What was read may be older than what is there now: it is looked at again.
            let known = old.filter(|old| old.content == read);
            (path.to_path_buf(), known.unwrap_or(File { stamp: None, content: read }))
        };
        let gone = (!seen.contains_key(scene)).then(|| file(scene, None));
        let files = seen.iter().map(|(path, read)| file(path, Some(*read))).chain(gone).collect();
        (shared.files, shared.missing) = (files, missing);
        let folders: BTreeSet<PathBuf> = shared.files.keys().map(|path| folder(path)).collect();
        let (old, new) = (shared.folders.clone(), folders.clone());
        shared.folders = folders;
        if let Some(watcher) = &mut shared.watcher {
            // A folder that can't be watched is looked at now and then.
            old.difference(&new).for_each(|gone| _ = watcher.unwatch(gone));
            new.difference(&old).for_each(|come| _ = watcher.watch(come, RecursiveMode::NonRecursive));
        }
    }
}

fn folder(path: &Path) -> PathBuf {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_path_buf()
}

fn look(shared: &Mutex<Shared>, events: &Receiver<()>, changed: &dyn Fn()) {
    loop {
        let told = match events.recv_timeout(OFTEN) {
            Ok(()) => {
                (0..PATIENCE)
                    .take_while(|_| events.recv_timeout(STILL).is_ok())
                    .for_each(|_| while events.try_recv().is_ok() {});
                true
            }
            Err(RecvTimeoutError::Timeout) => false,
            Err(RecvTimeoutError::Disconnected) => {
                std::thread::sleep(OFTEN);
                false
            }
        };
        let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
        let others = shared.files.iter_mut().filter_map(|(path, file)| file.is_another(path).then_some(())).count();
        let appeared = told && shared.missing;
        drop(shared);
        if others > 0 || appeared {
            changed();
        }
    }
}

impl File {
    /// Is there something else in it than before? Told once.
    fn is_another(&mut self, path: &Path) -> bool {
        let now = stamp(path);
        if now == self.stamp && now.is_some() {
            return false;
        }
        let content = content(path);
        let another = content != self.content;
        *self = Self { stamp: now, content };
        another
    }
}
