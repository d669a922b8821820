//! Where included files are looked for.

use std::path::{Path, PathBuf};

/// The folders in which an `#include` is looked for, in order.
#[derive(Clone, Debug, Default)]
pub struct SearchPath {
    /// The scene's own folder first, then the current one, `-I`, `DURER_INCLUDE`, an installed POV-Ray.
    pub folders: Vec<PathBuf>,
}

impl SearchPath {
    /// `-I` folders, then those of the environment variable `DURER_INCLUDE`, then an installed
    /// POV-Ray's.
    pub fn new(scene_folder: &Path, options: &[PathBuf]) -> Self {
        let mut folders = vec![scene_folder.to_path_buf()];
        // What a scene has written stands in the current folder.
        if scene_folder != Path::new(".") {
            folders.push(PathBuf::from("."));
        }
        folders.extend(options.iter().cloned());
        if let Some(list) = std::env::var_os("DURER_INCLUDE") {
            folders.extend(std::env::split_paths(&list));
        }
        folders.extend(INSTALLED.iter().map(PathBuf::from).filter(|p| p.is_dir()));
        Self { folders }
    }

    /// As on a machine without POV-Ray.
    pub fn without_installed(mut self) -> Self {
        self.folders.retain(|folder| !INSTALLED.iter().any(|installed| folder == Path::new(installed)));
        self
    }

    /// The first file of that name, looked for beside the including file's folder too.
    pub fn find(&self, name: &str) -> Option<PathBuf> {
        let name = Path::new(name);
        if name.is_absolute() {
            return name.is_file().then(|| name.to_path_buf());
        }
        self.folders.iter().map(|folder| folder.join(name)).find(|path| path.is_file())
    }
}

/// Where distributions put POV-Ray's include files.
const INSTALLED: &[&str] = &[
    "/usr/share/povray-3.7/include",
    "/usr/local/share/povray-3.7/include",
    "/opt/homebrew/share/povray-3.7/include",
    "/usr/share/povray/include",
];
