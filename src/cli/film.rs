//! Which frames of an animation are done, in a file beside the first of them: one line of JSON for each.

use super::journal::Work;
use crate::source::ContentHash;
use serde::{Deserialize, Serialize};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The frames of an animation that are done.
pub struct Film {
    path: PathBuf,
    /// Those of before.
    done: Vec<Entry>,
}

#[derive(Serialize, Deserialize)]
struct Entry {
    frame: u32,
    picture: PathBuf,
    /// Of the picture's file.
    hash: ContentHash,
    work: Work,
}

impl Film {
    /// Of an animation whose pictures are called like this one; those of before count if it is to go on with them.
    pub fn new(picture: &Path, resume: bool) -> Self {
        let mut name = picture.as_os_str().to_os_string();
        name.push(".frames");
        let path = PathBuf::from(name);
        let text = if resume { std::fs::read_to_string(&path).unwrap_or_default() } else { String::new() };
        // A line that is cut off is as good as none.
        let done = text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
        if !resume {
            let _ = std::fs::remove_file(&path);
        }
        Self { path, done }
    }

    /// Is this frame done, by the same program with the same options from the same files, and its picture untouched?
    pub fn has(&self, frame: u32, picture: &Path, program: &str, options: &str) -> bool {
        let hash = |path: &Path| std::fs::read(path).ok().map(|bytes| ContentHash::of(&bytes));
        self.done.iter().any(|entry| {
            entry.frame == frame
                && entry.picture == picture
                && entry.work.program == program
                && entry.work.options == options
                && hash(picture) == Some(entry.hash)
                && entry.work.files.iter().all(|(path, known)| hash(path) == Some(*known))
        })
    }

    /// Was this frame done before, in whatever way?
    pub fn knows(&self, frame: u32) -> bool {
        self.done.iter().any(|entry| entry.frame == frame)
    }

    /// This frame is done now. Where it can't be noted, it would be drawn again.
    pub fn add(&self, frame: u32, picture: &Path, work: Work) {
        let Ok(bytes) = std::fs::read(picture) else { return };
        let entry = Entry { frame, picture: picture.into(), hash: ContentHash::of(&bytes), work };
        let line = serde_json::to_string(&entry).unwrap_or_default() + "\n";
        let file = std::fs::OpenOptions::new().create(true).append(true).open(&self.path);
        let _ = file.and_then(|mut file| file.write_all(line.as_bytes()));
    }

    /// All frames are done.
    pub fn remove(&self) {
        let _ = std::fs::remove_file(&self.path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::ReadFiles;

    #[test]
    fn frames_are_done_as_long_as_nothing_changes() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("a.pov"), "sphere").unwrap();
        std::fs::write(at("a1.png"), "picture").unwrap();
        let files = ReadFiles::from([(at("a.pov"), ContentHash::of(b"sphere"))]);
        let work = Work { program: "1".into(), options: "o".into(), files };
        Film::new(&at("a.png"), false).add(1, &at("a1.png"), work);
        let done = |program: &str, options: &str| {
            let film = Film::new(&at("a.png"), true);
            film.has(1, &at("a1.png"), program, options)
        };
        assert!(done("1", "o") && !done("2", "o") && !done("1", "p"));
        std::fs::write(at("a.pov"), "box").unwrap();
        assert!(!done("1", "o"));
        std::fs::write(at("a.pov"), "sphere").unwrap();
        std::fs::write(at("a1.png"), "other").unwrap();
        assert!(!done("1", "o"));
    }
}
