//! Journal of an animation: the finished frames, one line of JSON for each, in a file beside the pictures.

use super::identity::Work;
use crate::source::ContentHash;
use serde::{Deserialize, Serialize};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The finished frames of an animation.
pub struct FinishedFrames {
    path: PathBuf,
    /// Frames that were finished by earlier runs.
    old: Vec<Entry>,
}

#[derive(Serialize, Deserialize)]
struct Entry {
    frame: u32,
    picture: PathBuf,
    /// Hash of the finished frame's picture file.
    hash: ContentHash,
    work: Work,
}

impl FinishedFrames {
    /// Opens the journal of the animation whose pictures are numbered variants of `picture`. Without `resume`, the old
    /// journal is deleted.
    pub fn new(picture: &Path, resume: bool) -> Self {
        let mut name = picture.as_os_str().to_os_string();
        name.push(".frames");
        let path = PathBuf::from(name);
        let text = if resume { std::fs::read_to_string(&path).unwrap_or_default() } else { String::new() };
        // A line that is cut off is ignored.
        let old = text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
        if !resume {
            let _ = std::fs::remove_file(&path);
        }
        Self { path, old }
    }

    /// True if this frame was finished by the same program with the same options from the same files, and its picture
    /// is unchanged.
    pub fn is_current(&self, frame: u32, picture: &Path, program: &str, options: &str) -> bool {
        let hash = |path: &Path| std::fs::read(path).ok().map(|bytes| ContentHash::of(&bytes));
        self.old.iter().any(|entry| {
            entry.frame == frame
                && entry.picture == picture
                && entry.work.program == program
                && entry.work.options == options
                && hash(picture) == Some(entry.hash)
                && entry.work.files.iter().all(|(path, known)| hash(path) == Some(*known))
        })
    }

    /// True if an earlier run finished this frame in any way.
    pub fn has(&self, frame: u32) -> bool {
        self.old.iter().any(|entry| entry.frame == frame)
    }

    /// Adds a finished frame. If the entry cannot be written, `--resume` would render the frame again.
    pub fn add(&self, frame: u32, picture: &Path, work: Work) {
        let Ok(bytes) = std::fs::read(picture) else { return };
        let entry = Entry { frame, picture: picture.into(), hash: ContentHash::of(&bytes), work };
        let line = serde_json::to_string(&entry).unwrap_or_default() + "\n";
        let file = std::fs::OpenOptions::new().create(true).append(true).open(&self.path);
        let _ = file.and_then(|mut file| file.write_all(line.as_bytes()));
    }

    /// Deletes the journal of a finished animation.
    pub fn remove(&self) {
        let _ = std::fs::remove_file(&self.path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::ReadFiles;

    #[test]
    fn frames_are_current_until_a_file_or_an_option_changes() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("a.pov"), "sphere").unwrap();
        std::fs::write(at("a1.png"), "picture").unwrap();
        let files = ReadFiles::from([(at("a.pov"), ContentHash::of(b"sphere"))]);
        let work = Work { program: "1".into(), options: "o".into(), files };
        FinishedFrames::new(&at("a.png"), false).add(1, &at("a1.png"), work);
        let is_current = |program: &str, options: &str| {
            let frames = FinishedFrames::new(&at("a.png"), true);
            frames.is_current(1, &at("a1.png"), program, options)
        };
        assert!(is_current("1", "o") && !is_current("2", "o") && !is_current("1", "p"));
        std::fs::write(at("a.pov"), "box").unwrap();
        assert!(!is_current("1", "o"));
        std::fs::write(at("a.pov"), "sphere").unwrap();
        std::fs::write(at("a1.png"), "other").unwrap();
        assert!(!is_current("1", "o"));
    }
}
