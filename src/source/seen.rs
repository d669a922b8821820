//! What was read so far, by name and content: whoever goes on with work of before asks whether it would be the same work.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Files and the fingerprints of their contents.
pub type Seen = BTreeMap<PathBuf, u64>;

static SEEN: Mutex<Seen> = Mutex::new(BTreeMap::new());

/// The bytes of a file that a scene needs.
///
/// # Errors
/// If it can't be read.
pub fn read_bytes(path: &Path) -> io::Result<Vec<u8>> {
    let bytes = std::fs::read(path)?;
    note(path, &bytes);
    Ok(bytes)
}

/// Notes what was read in another way.
pub fn note(name: &Path, bytes: &[u8]) {
    if let Ok(mut seen) = SEEN.lock() {
        seen.insert(name.to_path_buf(), fingerprint(bytes));
    }
}

/// All files that this process has read for its scenes.
pub fn seen() -> Seen {
    SEEN.lock().map(|seen| seen.clone()).unwrap_or_default()
}

/// From now on, only what is read later counts.
pub fn forget() {
    if let Ok(mut seen) = SEEN.lock() {
        seen.clear();
    }
}

/// Tells contents apart: two checksums of different kinds.
pub fn fingerprint(bytes: &[u8]) -> u64 {
    let mut sum = 0u64;
    for chunk in bytes.chunks(8) {
        let mut word = [0; 8];
        word[..chunk.len()].copy_from_slice(chunk);
        sum = (sum.rotate_left(5) ^ u64::from_le_bytes(word)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }
    (sum ^ bytes.len() as u64) >> 32 ^ u64::from(crc32fast::hash(bytes)) << 32
}
