//! Records of a journal: a head, the pixels of a tile or a part of a file of light, and a checksum.
//!
//! The head of a tile is its pass, x, y, width and height; the head of a part is the kind of the light, the offset of the
//! part in the file of light, the length of the part in bytes, and two zeros.

use crate::render::{FINAL_PASS, Region, Tile};
use crate::scene::LightKind;
use std::io::{self, Read};

/// Length of a record's head in bytes: one byte and four `u64`.
pub const HEAD: usize = 33;
/// Length of the checksum at the end of a record, in bytes.
pub const SUM: usize = 16;
/// Maximum number of pixels of the tile in a journal's record; a record with more is damaged.
const MAX_PIXELS: usize = 1 << 16;
/// Largest length of a part of a file of light, in bytes.
pub const MAX_PART: usize = MAX_PIXELS * size_of::<[f32; 4]>();
/// First byte of a record with photons, in place of a pass.
const PHOTONS: u8 = FINAL_PASS + 1;
/// First byte of a record with samples of radiosity, in place of a pass.
const RADIOSITY: u8 = FINAL_PASS + 2;

/// Key of the checksums of one journal. The key depends on the journal's header, and each checksum on the record's
/// position, so that a record is valid in its own place alone.
pub struct Key([u8; blake3::KEY_LEN]);

/// Kind and length of a record that was read from a journal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Record {
    /// Kind of the record's content.
    pub content: Content,
    /// Length of the record in bytes, with head and checksum.
    pub length: usize,
}

/// Kind of a record's content.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Pixels of a tile.
    Tile(Tile),
    /// Part of a file of light.
    Light {
        /// Kind of the light.
        kind: LightKind,
        /// Offset of the part in the file of light, in bytes.
        start: u64,
    },
}

impl Record {
    /// Returns the tile of the record's pixels; `None` for a part of a file of light.
    pub fn tile(&self) -> Option<Tile> {
        match self.content {
            Content::Tile(tile) => Some(tile),
            Content::Light { .. } => None,
        }
    }
}

impl Key {
    /// Derives the key of the journal with this header.
    pub fn of(header: &[u8]) -> Self {
        Self(blake3::derive_key("durer 2025-11-25 records of a resume journal", header))
    }

    fn keyed_checksum(&self, record_offset: u64, content: &[u8]) -> [u8; SUM] {
        let mut hasher = blake3::Hasher::new_keyed(&self.0);
        hasher.update(&record_offset.to_le_bytes()).update(content);
        let mut sum = [0; SUM];
        hasher.finalize_xof().fill(&mut sum);
        sum
    }

    /// Appends the record of a tile, which will be at `record_offset` in the file.
    pub fn append_tile(&self, out: &mut Vec<u8>, record_offset: u64, tile: Tile, pixels: &[[f32; 4]]) {
        let Region { x, y, width, height } = tile.area;
        self.append_record(out, record_offset, tile.pass, [x, y, width, height].map(|n| n as u64), |out| {
            pixels.as_flattened().iter().for_each(|x| out.extend(x.to_le_bytes()));
        });
    }

    /// Appends the record of a part of a file of light, which will be at `record_offset` in the file. The part begins
    /// at `offset_in_light` in the file of light, and has at most [`MAX_PART`] bytes.
    pub fn append_light(
        &self,
        out: &mut Vec<u8>,
        record_offset: u64,
        kind: LightKind,
        offset_in_light: u64,
        part: &[u8],
    ) {
        let first = match kind {
            LightKind::Photons => PHOTONS,
            LightKind::Radiosity => RADIOSITY,
        };
        self.append_record(out, record_offset, first, [offset_in_light, part.len() as u64, 0, 0], |out| {
            out.extend(part)
        });
    }

    /// Appends a record with this head, whose content `append_content` appends.
    fn append_record(
        &self,
        out: &mut Vec<u8>,
        record_offset: u64,
        kind_byte: u8,
        head_numbers: [u64; 4],
        append_content: impl FnOnce(&mut Vec<u8>),
    ) {
        let start = out.len();
        out.push(kind_byte);
        head_numbers.iter().for_each(|number| out.extend(number.to_le_bytes()));
        append_content(out);
        let sum = self.keyed_checksum(record_offset, &out[start..]);
        out.extend(sum);
    }

    /// Reads the next record of `from`, which is at `record_offset` in the file. `None` at the end of the file, if the record
    /// is cut off, and if its checksum is wrong but the file ends with zeros, as after a power loss.
    ///
    /// # Errors
    /// If the record is damaged or from another journal, or cannot be read.
    pub fn read_record(&self, from: &mut impl Read, record_offset: u64) -> Result<Option<Record>, String> {
        let mut bytes = vec![0; HEAD];
        if !fill_unless_file_ends(from, &mut bytes)? {
            return Ok(None);
        }
        let (content, n_bytes) = parse_content_and_length(&bytes).ok_or_else(damaged_reason)?;
        bytes.resize(HEAD + n_bytes + SUM, 0);
        if !fill_unless_file_ends(from, &mut bytes[HEAD..])? {
            return Ok(None);
        }
        let (summed, sum) = bytes.split_at(bytes.len() - SUM);
        if self.keyed_checksum(record_offset, summed) != sum {
            return if ends_with_zeros(from, sum)? { Ok(None) } else { Err(damaged_reason()) };
        }
        Ok(Some(Record { content, length: bytes.len() }))
    }
}

/// Returns the kind of a record's content and the content's length in bytes; `None` if the head is damaged.
fn parse_content_and_length(head: &[u8]) -> Option<(Content, usize)> {
    let mut numbers = head[1..].as_chunks::<8>().0.iter().map(|&number| u64::from_le_bytes(number));
    let [a, b, c, d] = [(); 4].map(|()| numbers.next().unwrap_or(0));
    let kind = match head[0] {
        PHOTONS => LightKind::Photons,
        RADIOSITY => LightKind::Radiosity,
        pass => {
            let [x, y, width, height] = [a, b, c, d].map(|number| number as usize);
            let is_valid = pass <= FINAL_PASS && width.saturating_mul(height) <= MAX_PIXELS;
            let tile = Tile { pass, area: Region { x, y, width, height } };
            return is_valid.then_some((Content::Tile(tile), width * height * size_of::<[f32; 4]>()));
        }
    };
    let length = usize::try_from(b).ok().filter(|length| *length <= MAX_PART)?;
    Some((Content::Light { kind, start: a }, length))
}

/// Returns the words that a journal is damaged, as the reason why it cannot be continued.
pub fn damaged_reason() -> String {
    "it is damaged".into()
}

/// Returns the words that the system cannot read or write a journal, as the reason why it cannot be continued.
pub fn unreadable_reason(error: &io::Error) -> String {
    format!("it can't be read: {error}")
}

/// Fills `bytes`; false if the file ends before.
fn fill_unless_file_ends(from: &mut impl Read, bytes: &mut [u8]) -> Result<bool, String> {
    match from.read_exact(bytes) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => Ok(false),
        Err(error) => Err(unreadable_reason(&error)),
    }
}

/// True if the last bytes of a file are zero. After a power loss, a file may have its length but not all of its bytes;
/// the missing bytes are then zero, up to the end. `bytes_already_read` are the last bytes that were read.
fn ends_with_zeros(from: &mut impl Read, bytes_already_read: &[u8]) -> Result<bool, String> {
    let mut tail = bytes_already_read.to_vec();
    let mut chunk = vec![0; 1 << 16];
    loop {
        match from.read(&mut chunk).map_err(|error| unreadable_reason(&error))? {
            0 => return Ok(tail[tail.len() - SUM..].iter().all(|byte| *byte == 0)),
            length => {
                tail.extend(&chunk[..length]);
                tail.drain(..tail.len() - SUM);
            }
        }
    }
}
