//! List of the files that scenes created, stored in the user's state folder. A scene that writes data for its next run,
//! or an animation that rewrites a file for each frame, may therefore replace its own files, and no others.

use crate::source::{CreatedFiles, CreatedInSession};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{File, Metadata};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

/// Number of listed files above which files that no longer exist are removed from the list.
const MANY: usize = 1000;

/// State of a file after a scene has written it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Fingerprint {
    length: u64,
    /// Time of the last write, in nanoseconds since 1970.
    modified: u128,
}

/// Files that one scene created, each with its state after the last write. `None` while the scene writes the file, or
/// if the file was gone at the end: such a file belongs to the scene, whatever its contents.
type FilesOfScene = BTreeMap<PathBuf, Option<Fingerprint>>;

/// Created files, by the path of the scene that created them.
type Created = BTreeMap<PathBuf, FilesOfScene>;

/// Files that one scene created, in this run and in earlier ones.
#[derive(Debug)]
pub struct CreatedByScene {
    scene: PathBuf,
    /// Path of the list in the user's state folder; `None` without such a folder.
    store: Option<PathBuf>,
    /// Files that this run has created or replaced.
    session: CreatedInSession,
}

impl CreatedByScene {
    /// Opens the list of created files for the scene in the file `scene`.
    pub fn new(scene: &Path) -> Self {
        let scene = scene.canonicalize().unwrap_or_else(|_| scene.to_path_buf());
        Self {
            scene,
            store: state_folder().map(|folder| folder.join("created-files.json")),
            session: CreatedInSession::default(),
        }
    }

    /// Applies `change` to the scene's part of the list of created files, and saves the list. Programs that run at the
    /// same time wait for each other. A list that cannot be read counts as empty, and is replaced. `None` if the list
    /// cannot be saved: the old list stays, and a later run of the scene may replace fewer files.
    fn try_save_changed_list(&self, change: impl FnOnce(&mut FilesOfScene)) -> Option<()> {
        let store = self.store.as_ref()?;
        std::fs::create_dir_all(store.parent()?).ok()?;
        let lock = File::create(store.with_extension("lock")).ok()?;
        lock.lock().ok()?;
        let mut all = read_store_or_empty(store);
        change(all.entry(self.scene.clone()).or_default());
        if all.values().map(BTreeMap::len).sum::<usize>() > MANY {
            all.values_mut().for_each(|files| files.retain(|path, _| path.exists()));
            all.retain(|_, files| !files.is_empty());
        }
        let mut file = tempfile::NamedTempFile::new_in(store.parent()?).ok()?;
        serde_json::to_writer(&mut file, &all).ok()?;
        file.persist(store).ok().map(drop)
    }
}

impl CreatedFiles for CreatedByScene {
    fn add(&self, path: &Path) {
        if !self.session.contains(path) {
            self.session.add(path);
            self.try_save_changed_list(|files| _ = files.insert(path.to_path_buf(), None));
        }
    }

    fn contains(&self, path: &Path) -> bool {
        if self.session.contains(path) {
            return true;
        }
        let stored =
            self.store.as_deref().map(read_store_or_empty).and_then(|mut all| all.remove(&self.scene)?.remove(path));
        stored.is_some_and(|state| state.is_none_or(|state| Some(state) == fingerprint(path)))
    }
}

impl Drop for CreatedByScene {
    fn drop(&mut self) {
        let created = self.session.paths();
        if !created.is_empty() {
            self.try_save_changed_list(|files| {
                files.extend(created.into_iter().map(|path| (path.clone(), fingerprint(&path))))
            });
        }
    }
}

/// Returns the list at this path; an empty one if the list cannot be read or parsed.
fn read_store_or_empty(store: &Path) -> Created {
    std::fs::read(store).ok().and_then(|bytes| serde_json::from_slice(&bytes).ok()).unwrap_or_default()
}

fn fingerprint(path: &Path) -> Option<Fingerprint> {
    let metadata: Metadata = path.symlink_metadata().ok()?;
    let modified = metadata.modified().ok()?.duration_since(UNIX_EPOCH).ok()?.as_nanos();
    Some(Fingerprint { length: metadata.len(), modified })
}

/// Returns the folder in which programs store their state (XDG Base Directory Specification).
fn state_folder() -> Option<PathBuf> {
    let folder = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let base = folder("XDG_STATE_HOME")
        .or_else(|| folder("LOCALAPPDATA"))
        .or_else(|| folder("HOME").map(|home| home.join(".local/state")))?;
    Some(base.join("durer"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_knows_its_files_until_somebody_else_changes_them() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let scene = |name: &str| CreatedByScene {
            scene: at(name),
            store: Some(at("state/created-files.json")),
            session: CreatedInSession::default(),
        };
        let (data, other) = (at("data.txt"), at("other.txt"));
        std::fs::write(&other, "mine").unwrap();
        let first = scene("a.pov");
        assert!(!first.contains(&data));
        first.add(&data);
        std::fs::write(&data, "1").unwrap();
        assert!(first.contains(&data));
        drop(first);
        let again = scene("a.pov");
        assert!(again.contains(&data) && !again.contains(&other) && !scene("b.pov").contains(&data));
        std::fs::write(&data, "edited by hand").unwrap();
        assert!(!again.contains(&data));
    }
}
