//! Files of hashes of pictures: whether two machines render the same bits, without their pictures.
//!
//! A line is the BLAKE3 hash of a picture in hexadecimal, two spaces, and the path of the scene from the file's folder, as `b3sum`
//! writes it; a line that starts with `#` is a comment.

use crate::cli::exit::{Result, usage_error};
use crate::diagnostic::file;
use crate::image_io::Frame;
use crate::source::{Disk, Files};
use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

/// Hashes of pictures, by the names of their scenes.
pub(super) struct Hashes {
    file: PathBuf,
    /// Comments at the start of the file.
    head: String,
    known: BTreeMap<String, String>,
}

/// Relation of a picture to its hash in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum HashResult {
    /// The picture has the file's hash.
    Same,
    /// The picture has another hash.
    Differs,
    /// The file has no hash for the scene.
    Missing,
}

impl Hashes {
    /// Reads the file with the hashes of scenes' pictures. If `may_be_new`, a missing file has no hashes.
    ///
    /// # Errors
    /// A file that cannot be read, or a line that is not a hash with a name.
    pub fn read(file: &Path, may_be_new: bool) -> Result<Self> {
        let mut hashes = Self { file: file.to_path_buf(), head: String::new(), known: BTreeMap::new() };
        if may_be_new && !file.exists() {
            return Ok(hashes);
        }
        let text = std::fs::read_to_string(file).map_err(|e| Box::new(file::unreadable(&Disk, file, &e.into())))?;
        for (number, line) in text.lines().enumerate() {
            match line.split_once("  ") {
                _ if line.starts_with('#') => hashes.head += &format!("{line}\n"),
                Some((hash, name)) if hash.len() == 2 * blake3::OUT_LEN => {
                    hashes.known.insert(name.to_string(), hash.to_string());
                }
                _ if line.is_empty() => {}
                _ => {
                    return usage_error(format!("`{}`: line {} is not a hash and a scene", file.display(), number + 1));
                }
            }
        }
        Ok(hashes)
    }

    /// Compares a scene's picture with the hash of the file, and returns the result. If `accept`, the picture's hash then
    /// replaces the known one, until [`Self::write`] writes the file.
    pub fn compare_and_update(&mut self, scene: &Path, picture: &Frame, accept: bool) -> HashResult {
        let (name, hash) = (self.name_of(scene), hash_of(picture));
        let result = match self.known.get(&name) {
            Some(known) if *known == hash => HashResult::Same,
            Some(_) => HashResult::Differs,
            None => HashResult::Missing,
        };
        if accept {
            self.known.insert(name, hash);
        }
        result
    }

    /// Writes the hashes to their file, sorted by the names of the scenes.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&self) -> Result<()> {
        let lines: String = self.known.iter().map(|(name, hash)| format!("{hash}  {name}\n")).collect();
        let text = format!("{}{lines}", self.head);
        Disk.write(&self.file, text.as_bytes()).map_err(|e| Box::new(file::unwritable(&Disk, &self.file, &e)))?;
        Ok(())
    }

    /// Returns a scene's name in the file: its path from the file's folder, with slashes.
    fn name_of(&self, scene: &Path) -> String {
        let absolute = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_path_buf());
        let folder = match self.file.parent() {
            Some(folder) if folder != Path::new("") => absolute(folder),
            _ => absolute(Path::new(".")),
        };
        let scene = absolute(scene);
        let (from, to): (Vec<_>, Vec<_>) = (folder.components().collect(), scene.components().collect());
        let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
        let up = std::iter::repeat_n("..".to_string(), from.len() - common);
        let down = to[common..].iter().map(|c: &Component| c.as_os_str().to_string_lossy().into_owned());
        up.chain(down).collect::<Vec<_>>().join("/")
    }
}

/// Returns the hash of a picture's size and of all bits of its linear pixels, which no encoding has rounded.
fn hash_of(picture: &Frame) -> String {
    let mut hasher = blake3::Hasher::new();
    for length in [picture.width, picture.height] {
        hasher.update(&(length as u64).to_le_bytes());
    }
    for channel in picture.pixels.as_flattened() {
        hasher.update(&channel.to_bits().to_le_bytes());
    }
    hasher.finalize().to_hex().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_tell_pictures_apart_by_one_bit() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("hashes.txt");
        std::fs::write(&file, "# Pictures of the gallery.\n").unwrap();
        let scene = folder.path().join("a/b.scene");
        let mut picture = Frame::new(2, 3);
        let mut hashes = Hashes::read(&file, false).unwrap();
        assert_eq!(hashes.compare_and_update(&scene, &picture, true), HashResult::Missing);
        hashes.write().unwrap();
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(text.starts_with("# Pictures of the gallery.\n") && text.ends_with("  a/b.scene\n"), "{text}");

        let mut hashes = Hashes::read(&file, false).unwrap();
        assert_eq!(hashes.compare_and_update(&scene, &picture, false), HashResult::Same);
        picture.pixels[4][2] = f32::from_bits(1);
        assert_eq!(hashes.compare_and_update(&scene, &picture, false), HashResult::Differs);
        assert_eq!(hashes.compare_and_update(&scene, &Frame::new(3, 2), false), HashResult::Differs);
    }

    #[test]
    fn lines_that_are_no_hashes_are_reported() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("hashes.txt");
        assert!(Hashes::read(&file, false).is_err());
        assert!(Hashes::read(&file, true).is_ok());
        std::fs::write(&file, "1234  a.scene\n").unwrap();
        assert!(Hashes::read(&file, true).is_err());
    }
}
