//! Journal of an animation: the finished frames, one line of JSON for each, in a file beside the pictures.

use super::identity::Begun;
use super::lock_failure;
use crate::cli::exit::Result;
use crate::source::{ContentHash, Exclusive, OpenError, ReadFiles, sync_folder_of};
use serde::{Deserialize, Serialize};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The finished frames of an animation. Processes that render other frames of the same animation add to the same file.
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
    /// Inputs of the finished frame (`Work`) and the program that rendered it; the work's options include those of the
    /// picture's encoding.
    begun: Begun,
}

impl FinishedFrames {
    /// Reads the journal of the animation whose pictures are numbered variants of `picture`. Without `resume`, the old
    /// journal is deleted. A journal that the system cannot open counts as empty.
    ///
    /// # Errors
    /// If the journal is not a plain file (E0004).
    pub fn new(picture: &Path, resume: bool) -> Result<Self> {
        let mut name = picture.as_os_str().to_os_string();
        name.push(".frames");
        let path = PathBuf::from(name);
        let mut text = String::new();
        match Exclusive::wait_for(&path) {
            Ok(file) if resume => _ = file.file().read_to_string(&mut text),
            Ok(file) => file.delete(),
            // The picture's own messages describe a folder that cannot be written.
            Err(OpenError::Io(_)) => {}
            Err(error) => return Err(lock_failure(picture, &path, error)),
        }
        // A line that is cut off is ignored.
        let old = text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
        Ok(Self { path, old })
    }

    /// True if this frame was finished by the same program with the same options from the same files, and its picture
    /// is unchanged. `known_hashes` has the hashes of files that this process will not read again.
    pub fn is_current(&self, frame: u32, picture: &Path, options: &str, known_hashes: &ReadFiles) -> bool {
        let hash = || std::fs::read(picture).ok().map(|bytes| ContentHash::of(&bytes));
        self.old.iter().any(|entry| {
            entry.frame == frame
                && entry.picture == picture
                && hash() == Some(entry.hash)
                && entry.begun.is_current(options, known_hashes)
        })
    }

    /// True if an earlier run finished this frame in any way. Frames that this run has added do not count.
    pub fn was_finished_earlier(&self, frame: u32) -> bool {
        self.old.iter().any(|entry| entry.frame == frame)
    }

    /// Adds a finished frame, and waits for the disk if `waits_for_disk`. If the entry cannot be written, `--resume` would
    /// render the frame again.
    pub fn add(&self, frame: u32, picture: &Path, begun: Begun, waits_for_disk: bool) {
        let Ok(bytes) = std::fs::read(picture) else { return };
        let entry = Entry { frame, picture: picture.into(), hash: ContentHash::of(&bytes), begun };
        // A line that a killed process has cut off ends here.
        let line = format!("\n{}\n", serde_json::to_string(&entry).unwrap_or_default());
        let Ok(exclusive) = Exclusive::wait_for(&self.path) else { return };
        let mut file = exclusive.file();
        let written = file.seek(SeekFrom::End(0)).and_then(|_| file.write_all(line.as_bytes()));
        if written.is_ok() && waits_for_disk {
            let _ = file.sync_data();
            sync_folder_of(&self.path);
        }
    }

    /// Deletes the journal of a finished animation.
    pub fn delete_journal(&self) {
        if let Ok(file) = Exclusive::wait_for(&self.path) {
            file.delete();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::journal::identity::Work;
    use crate::source::Lookups;

    #[test]
    fn frames_are_current_until_a_file_or_an_option_changes() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("a.pov"), "sphere").unwrap();
        std::fs::write(at("a1.png"), "picture").unwrap();
        let files = ReadFiles::from([(at("a.pov"), ContentHash::of(b"sphere"))]);
        let work =
            |options: &str| Work { options: options.into(), files: files.clone(), lookups: Lookups::new(), now: None };
        FinishedFrames::new(&at("a.png"), false).unwrap().add(1, &at("a1.png"), Begun::new(work("o")), true);
        let is_current = |options: &str| {
            let frames = FinishedFrames::new(&at("a.png"), true).unwrap();
            frames.is_current(1, &at("a1.png"), options, &ReadFiles::new())
        };
        assert!(is_current("o") && !is_current("p"));
        std::fs::write(at("a.pov"), "box").unwrap();
        assert!(!is_current("o"));
        std::fs::write(at("a.pov"), "sphere").unwrap();
        std::fs::write(at("a1.png"), "other").unwrap();
        assert!(!is_current("o"));
    }
}
