//! Writer of shard files.

use super::{Header, MAGIC};
use crate::cli::journal::record::Key;
use crate::diagnostic::{Diagnostic, Result};
use crate::render::{FINAL_PASS, Region, Tile};
use crate::source::Draft;
use std::io::{self, Write};

/// Writes the blocks of a shard in their order.
pub struct ShardWriter<'d> {
    draft: &'d mut Draft,
    key: Key,
    /// Length of the file so far, in bytes.
    length: u64,
    unwritable: Box<dyn Fn(&io::Error) -> Diagnostic + Send + 'd>,
}

impl<'d> ShardWriter<'d> {
    /// Starts a shard file; `unwritable` creates the message for a write error.
    ///
    /// # Errors
    /// The diagnostic of `unwritable`.
    pub fn new(
        draft: &'d mut Draft,
        header: &Header,
        unwritable: impl Fn(&io::Error) -> Diagnostic + Send + 'd,
    ) -> Result<Self> {
        let json = serde_json::to_vec(header).map_err(|error| Box::new(unwritable(&error.into())))?;
        let start = [MAGIC, &json, b"\n"].concat();
        draft.write_all(&start).map_err(|error| Box::new(unwritable(&error)))?;
        Ok(Self { draft, key: Key::of(&start), length: start.len() as u64, unwritable: Box::new(unwritable) })
    }

    /// Writes a block with the linear light of its pixels, row by row.
    ///
    /// # Errors
    /// The diagnostic of a write error.
    pub fn write_block(&mut self, area: Region, pixels: &[[f32; 4]]) -> Result<()> {
        let mut record = vec![];
        self.key.append_tile(&mut record, self.length, Tile { pass: FINAL_PASS, area }, pixels);
        self.length += record.len() as u64;
        self.draft.write_all(&record).map_err(|error| Box::new((self.unwritable)(&error)))
    }
}
