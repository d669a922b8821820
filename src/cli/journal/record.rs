//! Records of a journal: pass, tile, pixels and a checksum.

use crate::render::{FINAL_PASS, Region, Tile};
use std::io::{self, Read};

/// Bytes of a record before its pixels: pass, x, y, width and height.
pub const HEAD: usize = 33;
/// Bytes of the checksum after the pixels.
pub const SUM: usize = 16;
/// Largest number of pixels of a tile.
const MAX_PIXELS: usize = 1 << 16;

/// Key of the checksums of one journal. The key depends on the journal's header, and each checksum on the record's
/// position, so that a record is valid in its own place alone.
pub struct Key([u8; blake3::KEY_LEN]);

/// Tile and length in bytes of a record that was read from a journal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Record {
    /// Pass and area of the pixels.
    pub tile: Tile,
    /// Length of the record in bytes.
    pub length: usize,
}

impl Key {
    /// Derives the key of the journal with this header.
    pub fn of(header: &[u8]) -> Self {
        Self(blake3::derive_key("durer 2025-11-25 records of a resume journal", header))
    }

    fn sum(&self, offset: u64, content: &[u8]) -> [u8; SUM] {
        let mut hasher = blake3::Hasher::new_keyed(&self.0);
        hasher.update(&offset.to_le_bytes()).update(content);
        let mut sum = [0; SUM];
        hasher.finalize_xof().fill(&mut sum);
        sum
    }

    /// Appends a record that will be at `offset` in the file.
    pub fn append(&self, out: &mut Vec<u8>, offset: u64, tile: Tile, pixels: &[[f32; 4]]) {
        let start = out.len();
        out.push(tile.pass);
        let Region { x, y, width, height } = tile.area;
        [x, y, width, height].iter().for_each(|&n| out.extend((n as u64).to_le_bytes()));
        pixels.as_flattened().iter().for_each(|x| out.extend(x.to_le_bytes()));
        let sum = self.sum(offset, &out[start..]);
        out.extend(sum);
    }

    /// Reads the record at `offset`; `None` at the end of the file, and if the record is cut off.
    ///
    /// # Errors
    /// If the record is damaged or from another journal, or cannot be read.
    pub fn read(&self, from: &mut impl Read, offset: u64) -> Result<Option<Record>, String> {
        let mut bytes = vec![0; HEAD];
        if !is_filled(from, &mut bytes)? {
            return Ok(None);
        }
        let mut numbers = bytes[1..].as_chunks::<8>().0.iter().map(|&number| u64::from_le_bytes(number) as usize);
        let [x, y, width, height] = [(); 4].map(|()| numbers.next().unwrap_or(0));
        if width.saturating_mul(height) > MAX_PIXELS || bytes[0] > FINAL_PASS {
            return Err(damaged());
        }
        bytes.resize(HEAD + width * height * 16 + SUM, 0);
        if !is_filled(from, &mut bytes[HEAD..])? {
            return Ok(None);
        }
        let (content, sum) = bytes.split_at(bytes.len() - SUM);
        if self.sum(offset, content) != sum {
            return if ends_with_zeros(from, sum)? { Ok(None) } else { Err(damaged()) };
        }
        let tile = Tile { pass: bytes[0], area: Region { x, y, width, height } };
        Ok(Some(Record { tile, length: bytes.len() }))
    }
}

/// Returns the reason for a journal that is damaged.
pub fn damaged() -> String {
    "it is damaged".into()
}

/// Returns the reason for a journal that the system does not read or write.
pub fn unreadable(error: &io::Error) -> String {
    format!("it can't be read: {error}")
}

/// Fills `bytes`; false if the file ends before.
fn is_filled(from: &mut impl Read, bytes: &mut [u8]) -> Result<bool, String> {
    match from.read_exact(bytes) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => Ok(false),
        Err(error) => Err(unreadable(&error)),
    }
}

/// True if the last bytes of a file are zero. After a power loss, a file may have its length but not all of its bytes;
/// the missing bytes are then zero, up to the end. `last` are the last bytes that were read.
fn ends_with_zeros(from: &mut impl Read, last: &[u8]) -> Result<bool, String> {
    let mut tail = last.to_vec();
    let mut chunk = vec![0; 1 << 16];
    loop {
        match from.read(&mut chunk).map_err(|error| unreadable(&error))? {
            0 => return Ok(tail[tail.len() - SUM..].iter().all(|byte| *byte == 0)),
            length => {
                tail.extend(&chunk[..length]);
                tail.drain(..tail.len() - SUM);
            }
        }
    }
}
