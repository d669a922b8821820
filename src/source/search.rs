//! The include path: the folders in which the files that a scene names are searched.

use super::{Disk, Files};
use std::path::{Component, Path, PathBuf};

/// Folders in which the files that a scene names are searched.
#[derive(Clone, Debug, Default)]
pub struct SearchPath {
    /// Folders in the order of the search: the scene's folder, the current folder, those of `-I` and `DURER_INCLUDE`,
    /// and those of an installed POV-Ray.
    pub folders: Vec<PathBuf>,
    /// Folders of fonts that substitute missing fonts.
    pub fonts: Vec<PathBuf>,
}

/// Result of searching a file on the include path.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Path of the file that the search found.
    pub path: PathBuf,
    /// Spelling of the file's name that every system finds; `None` if the scene has that spelling.
    pub portable: Option<String>,
}

impl SearchPath {
    /// Creates the include path of a scene on this machine. `option_folders` are those of `-I`.
    pub fn new(scene_folder: &Path, option_folders: &[PathBuf]) -> Self {
        let mut folders = vec![scene_folder.to_path_buf()];
        // Scenes write their files into the current folder.
        if scene_folder != Path::new(".") {
            folders.push(PathBuf::from("."));
        }
        folders.extend(option_folders.iter().cloned());
        if let Some(list) = std::env::var_os("DURER_INCLUDE") {
            folders.extend(std::env::split_paths(&list));
        }
        folders.extend(INSTALLED.iter().map(PathBuf::from).filter(|folder| Disk.is_folder(folder)));
        let installed = folders.iter().filter(|folder| is_installed_povray_folder(folder)).cloned();
        let fonts = super::fonts::font_folders().into_iter().chain(installed).collect();
        Self { folders, fonts }
    }

    /// Removes the folders of an installed POV-Ray from the include path.
    pub fn without_installed(mut self) -> Self {
        self.folders.retain(|folder| !is_installed_povray_folder(folder));
        self.fonts.retain(|folder| !is_installed_povray_folder(folder));
        self
    }

    /// Finds the first file or folder that has exactly this name, in this letter case and with its extension, for
    /// `file_exists`.
    pub fn find_exact(&self, files: &dyn Files, name: &str) -> Option<PathBuf> {
        self.search(name, None, |path| files.exists(path))
    }

    /// Finds a file that a scene names. The folder of the file `including` is searched last, since POV-Ray does not
    /// search it. The extension `.inc` is optional. A name that is not found is searched again as other systems read
    /// it: in any letter case, with `\` in place of `/`, and at last by the file name of a DOS path.
    pub fn resolve(&self, files: &dyn Files, name: &str, including: Option<&Path>) -> Option<Found> {
        let beside = including.and_then(Path::parent);
        let exact = |name: &str| self.search(name, beside, |path| files.is_file(path));
        let plain = |path| Found { path, portable: None };
        if let Some(path) = exact(name) {
            return Some(plain(path));
        }
        let endings: &[&str] = if Path::new(name).extension().is_none() { &[".inc", ".INC"] } else { &[] };
        if let Some(path) = endings.iter().find_map(|ending| exact(&format!("{name}{ending}"))) {
            return Some(plain(path));
        }
        let slashed = name.trim().replace('\\', "/");
        let last = slashed.rsplit('/').next().unwrap_or_default();
        let is_dos = slashed.as_bytes().get(1) == Some(&b':') || slashed.starts_with('/') && name.contains('\\');
        let names = [Some(slashed.as_str()), Some(last).filter(|_| is_dos)];
        names.into_iter().flatten().filter(|name| !name.is_empty()).find_map(|name| {
            let folders = self.folders.iter().map(PathBuf::as_path).chain(beside);
            folders.into_iter().find_map(|folder| find_in_any_case(files, folder, name))
        })
    }

    fn search(&self, name: &str, last_folder: Option<&Path>, is_there: impl Fn(&Path) -> bool) -> Option<PathBuf> {
        let name = Path::new(name);
        if name.as_os_str().is_empty() {
            return None;
        }
        if name.is_absolute() {
            return is_there(name).then(|| name.to_path_buf());
        }
        let folders = self.folders.iter().map(PathBuf::as_path).chain(last_folder);
        folders.into_iter().map(|folder| folder.join(name)).find(|path| is_there(path))
    }
}

/// Finds a file below a folder by a relative name in any letter case.
fn find_in_any_case(files: &dyn Files, folder: &Path, name: &str) -> Option<Found> {
    let (mut path, mut portable) = (folder.to_path_buf(), PathBuf::new());
    for part in Path::new(name).components() {
        let part = match part {
            Component::CurDir => continue,
            Component::Normal(part) => part.to_str()?,
            Component::ParentDir => {
                path.push("..");
                portable.push("..");
                continue;
            }
            _ => return None,
        };
        let part =
            if files.exists(&path.join(part)) { part.to_string() } else { files.entry_in_any_case(&path, part)? };
        path.push(&part);
        portable.push(&part);
    }
    files.is_file(&path).then(|| Found { path, portable: Some(portable.to_string_lossy().replace('\\', "/")) })
}

fn is_installed_povray_folder(folder: &Path) -> bool {
    INSTALLED.iter().any(|installed| folder == Path::new(installed))
}

/// Folders of POV-Ray's include files on common systems.
const INSTALLED: &[&str] = &[
    "/usr/share/povray-3.7/include",
    "/usr/local/share/povray-3.7/include",
    "/opt/homebrew/share/povray-3.7/include",
    "/usr/share/povray/include",
];

#[cfg(test)]
mod tests {
    use super::*;

    fn search(files: &[&str]) -> (tempfile::TempDir, SearchPath) {
        let folder = tempfile::tempdir().unwrap();
        for file in files {
            let path = folder.path().join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "").unwrap();
        }
        let search = SearchPath { folders: vec![folder.path().into()], fonts: vec![] };
        (folder, search)
    }

    #[test]
    fn names_of_other_systems_are_found() {
        let (folder, search) = search(&["Sub Dir/My Shapes.inc", "low.inc", "a.pov", "b.h", "Old.INC"]);
        let found = |name: &str| {
            let found = search.resolve(&Disk, name, None)?;
            let path = found.path.strip_prefix(folder.path()).unwrap().to_str().unwrap().to_string();
            Some((path, found.portable))
        };
        let respelled = |path: &str| Some((path.to_string(), Some(path.to_string())));
        let exact = |path: &str| Some((path.to_string(), None));
        for name in ["low.inc", "a.pov", "b.h", "Sub Dir/My Shapes.inc"] {
            assert_eq!(found(name), exact(name), "{name}");
        }
        assert_eq!(found("low"), exact("low.inc"));
        assert_eq!(found("Old"), exact("Old.INC"));
        assert_eq!(found("LOW.INC"), respelled("low.inc"));
        assert_eq!(found("sub dir\\my shapes.INC"), respelled("Sub Dir/My Shapes.inc"));
        assert_eq!(found("C:\\POV\\include\\low.inc"), respelled("low.inc"));
        assert_eq!(found("c:/pov/LOW.INC"), respelled("low.inc"));
        assert_eq!(found(".\\low.inc"), respelled("low.inc"));
        for name in ["", "no.inc", "Sub Dir", "pov/low.inc", "/low.inc", "\\", "C:"] {
            assert_eq!(found(name), None, "{name}");
        }
    }

    #[test]
    fn the_folder_of_the_including_file_is_searched_last() {
        let (folder, search) = search(&["b.inc", "sub/b.inc", "sub/c.inc"]);
        let including = folder.path().join("sub/a.inc");
        let found = |name: &str| search.resolve(&Disk, name, Some(&including)).unwrap().path;
        assert_eq!(found("b.inc"), folder.path().join("b.inc"));
        assert_eq!(found("c.inc"), folder.path().join("sub/c.inc"));
    }

    #[test]
    fn find_needs_the_exact_name() {
        let (_folder, search) = search(&["sub/low.inc"]);
        assert!(search.find_exact(&Disk, "sub/low.inc").is_some() && search.find_exact(&Disk, "sub").is_some());
        for name in ["sub/LOW.inc", "sub\\low.inc", "sub/low", ""] {
            assert!(search.find_exact(&Disk, name).is_none(), "{name}");
        }
    }
}
