//! Finds scenes with snapshots.

use crate::source::{FileKind, Files, scenes_below};
use std::io;
use std::path::{Path, PathBuf};

/// A scene and the path of its snapshot, which need not exist.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Case {
    /// Path of the scene to render.
    pub scene: PathBuf,
    /// Path of the scene's snapshot.
    pub picture: PathBuf,
}

/// End of a snapshot's file name, which no other picture has, so that rendering a scene cannot overwrite a snapshot.
pub const ENDING: &str = "snapshot.png";

/// True if the path has the name of a snapshot.
pub fn is_snapshot(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    name.strip_suffix(ENDING).is_some_and(|stem| stem.ends_with('.'))
}

impl Case {
    fn of_scene(scene: &Path) -> Self {
        Self { scene: scene.to_path_buf(), picture: scene.with_extension(ENDING) }
    }
}

/// Returns the scenes among `paths`, with or without a snapshot, the scenes of the snapshots among `paths`, and the scenes
/// with a snapshot in and below the folders among `paths`; sorted by path. Hidden folders and Cargo's `target` are omitted.
///
/// # Errors
/// If a path does not exist or a folder cannot be read.
pub fn find(files: &dyn Files, paths: &[PathBuf]) -> io::Result<Vec<Case>> {
    let mut cases = Vec::new();
    for path in paths {
        if files.metadata(path)?.kind == FileKind::Folder {
            let all = scenes_below(files, path)?.into_iter().map(|scene| Case::of_scene(&scene));
            cases.extend(all.filter(|case| files.is_file(&case.picture)));
        } else {
            cases.push(Case::of_scene(&scene_of(files, path)));
        }
    }
    cases.sort();
    cases.dedup();
    Ok(cases)
}

/// Returns the scene of a path: the path itself, or the scene beside a snapshot.
fn scene_of(files: &dyn Files, path: &Path) -> PathBuf {
    let beside = ["scene", "pov"].map(|ending| path.with_extension("").with_extension(ending));
    beside.into_iter().find(|scene| is_snapshot(path) && files.is_file(scene)).unwrap_or(path.to_path_buf())
}

/// Returns the options in a comment at the start of a scene, as in `//! test: --size 128x96 --aa off`, without the prefix;
/// `None` without such a comment.
pub fn test_options(text: &str) -> Option<&str> {
    let lines = text.lines().map(str::trim);
    let mut comments = lines.take_while(|line| line.is_empty() || line.starts_with("//"));
    comments.find_map(|line| line.strip_prefix("//! test:")).map(str::trim)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Memory;

    #[test]
    fn only_scenes_with_a_snapshot_are_found_in_folders() {
        let (files, at) = (Memory::default(), |name: &str| Path::new("/work").join(name));
        for name in [
            "a.scene",
            "a.snapshot.png",
            "new.scene",
            "new.png",
            "alone.snapshot.png",
            "b/c.d.pov",
            "b/c.d.snapshot.png",
            "b/.hidden/e.scene",
            "b/.hidden/e.snapshot.png",
        ] {
            files.insert(at(name), "");
        }
        let names =
            |paths: &[PathBuf]| -> Vec<PathBuf> { find(&files, paths).unwrap().into_iter().map(|c| c.scene).collect() };
        assert_eq!(names(&["/work".into()]), [at("a.scene"), at("b/c.d.pov")]);
        assert_eq!(names(&[at("new.scene")]), [at("new.scene")]);
        assert_eq!(names(&[at("b/c.d.snapshot.png"), at("b")]), [at("b/c.d.pov")]);
        assert!(find(&files, &[at("missing")]).is_err());
    }

    #[test]
    fn snapshots_are_recognized_by_their_names() {
        assert!(is_snapshot(Path::new("a/b.snapshot.png")) && is_snapshot(Path::new("B.SNAPSHOT.PNG")));
        assert!(!is_snapshot(Path::new("snapshot.png")) && !is_snapshot(Path::new("a.png")));
        assert!(!is_snapshot(Path::new("snapshot.png/a.png")));
    }

    #[test]
    fn options_are_read_from_the_first_comments() {
        assert_eq!(test_options("// A ball.\n\n//! test: --size 4x3 \nsphere {}"), Some("--size 4x3"));
        assert_eq!(test_options("sphere {}\n//! test: --size 4x3"), None);
        assert_eq!(test_options(""), None);
    }
}
