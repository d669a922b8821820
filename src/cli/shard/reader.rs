//! Reader of shard files, which proves that a shard is whole before any of its pixels is used.

use super::{Header, MAGIC};
use crate::cli::journal::record::{HEAD, Key, damaged_reason, unreadable_reason};
use crate::render::Region;
use std::collections::HashMap;
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

/// Maximum length of a shard file's header, in bytes.
const MAX_HEADER: u64 = 1 << 26;

/// A complete shard on the disk.
pub struct ShardFile {
    file: File,
    /// Header of the shard file: picture, division into blocks, encoding, and number of the shard.
    pub header: Header,
    /// Offsets of the blocks' pixels in the file, by the blocks' corners.
    offsets: HashMap<[usize; 2], u64>,
}

impl ShardFile {
    /// Opens a shard and checks all of its records.
    ///
    /// # Errors
    /// The reason why the file is not a complete shard.
    pub fn open(path: &Path) -> Result<Self, String> {
        // A FIFO would block, and a device would have no end.
        if !path.metadata().map_err(|error| unreadable_reason(&error))?.is_file() {
            return Err("it is not a regular file".into());
        }
        let file = File::open(path).map_err(|error| unreadable_reason(&error))?;
        let mut reader = BufReader::with_capacity(1 << 20, &file);
        let start = read_format_and_header(&mut reader)?;
        let header: Header = serde_json::from_slice(&start[MAGIC.len()..]).map_err(|_| damaged_reason())?;
        check_sizes(&header)?;
        let (key, mut end) = (Key::of(&start), start.len() as u64);
        let mut offsets = HashMap::new();
        for block in header.layout.blocks(header.shard) {
            let record = key.read_record(&mut reader, end)?.ok_or("it is not complete")?;
            if record.tile().is_none_or(|tile| tile.area != block) {
                return Err(damaged_reason());
            }
            offsets.insert([block.x, block.y], end + HEAD as u64);
            end += record.length as u64;
        }
        let is_longer = reader.read(&mut [0]).map_err(|error| unreadable_reason(&error))? > 0;
        if is_longer { Err(damaged_reason()) } else { Ok(Self { file, header, offsets }) }
    }

    /// Reads the pixels of a block; `None` if the shard does not have the block.
    ///
    /// # Errors
    /// The reason why the file cannot be read.
    pub fn read_block(&self, area: Region) -> Result<Option<Vec<[f32; 4]>>, String> {
        let Some(&offset) = self.offsets.get(&[area.x, area.y]) else { return Ok(None) };
        let mut bytes = vec![0; area.width * area.height * size_of::<[f32; 4]>()];
        let mut file = &self.file;
        let read = file.seek(SeekFrom::Start(offset)).and_then(|_| file.read_exact(&mut bytes));
        read.map_err(|error| unreadable_reason(&error))?;
        let numbers: Vec<f32> = bytes.as_chunks::<4>().0.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect();
        Ok(Some(numbers.as_chunks::<4>().0.to_vec()))
    }
}

/// Reads the first two lines of a shard file, with their ends: the line that names the format, and the header.
fn read_format_and_header(reader: &mut impl BufRead) -> Result<Vec<u8>, String> {
    let mut start = vec![];
    let mut reader = reader.take(MAX_HEADER);
    reader.read_until(b'\n', &mut start).map_err(|error| unreadable_reason(&error))?;
    if start != MAGIC {
        let is_other_version = super::begins_like_a_shard(&start);
        return Err(if is_other_version { "it is from another version of durer" } else { "it is not a shard" }.into());
    }
    reader.read_until(b'\n', &mut start).map_err(|error| unreadable_reason(&error))?;
    if start.ends_with(b"\n") { Ok(start) } else { Err("it is not complete".into()) }
}

/// Checks the sizes and counts in a shard's header, which determine allocations and loops.
fn check_sizes(header: &Header) -> Result<(), String> {
    let (layout, shard) = (&header.layout, header.shard);
    let is_inside = |at: usize, length: usize, side| at.checked_add(length).is_some_and(|end| end <= side);
    let Region { x, y, width, height } = layout.region;
    let is_sound = (1..=shard.count).contains(&shard.index)
        && [16, 32, 64].contains(&layout.edge)
        && layout.width.max(layout.height) <= MAX_SIDE
        && is_inside(x, width, layout.width)
        && is_inside(y, height, layout.height);
    if is_sound { Ok(()) } else { Err(damaged_reason()) }
}

/// Largest width and height of a picture, in pixels.
const MAX_SIDE: usize = 1 << 30;
