//! Photons and radiosity samples in a journal, so that a render that continues does not compute them again.
//!
//! The light is a file of light, in parts that are records of the journal, in their order. A file of light ends with a hash
//! of its own, so that light whose last parts are missing is never used.

use super::record::MAX_PART;
use super::{Journal, SYNC_INTERVAL, State};
use crate::scene::LightKind;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Places of the photons and of the radiosity samples in the file of a journal.
#[derive(Default)]
pub(super) struct StoredLight {
    /// Offset and length of each part in the journal's file, by the kind of the light.
    parts: [Vec<(u64, usize)>; 2],
    /// Error that ended the last attempt to write light.
    error: Option<io::Error>,
}

impl StoredLight {
    /// Records the position of a stored part: `offset_in_light` in its file of light, `offset_in_journal` in the
    /// journal's file. The first part of a file of light replaces the parts of an interrupted attempt.
    pub(super) fn add_part(&mut self, kind: LightKind, offset_in_light: u64, offset_in_journal: u64, length: usize) {
        let parts = &mut self.parts[kind as usize];
        if offset_in_light == 0 {
            parts.clear();
        }
        parts.push((offset_in_journal, length));
    }
}

impl Journal {
    /// Returns the path of the journal's file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// True if an earlier run has stored light in the file, complete or not. False before [`Journal::resume`].
    pub fn has_light(&self) -> bool {
        self.state().light.parts.iter().any(|parts| !parts.is_empty())
    }

    /// Returns the bytes of a file of light that an earlier run has stored; `None` for none, and if reading fails. The file of
    /// light may be incomplete.
    pub fn load_light(&self, kind: LightKind) -> Option<Vec<u8>> {
        let state = self.state();
        let parts = &state.light.parts[kind as usize];
        if parts.is_empty() {
            return None;
        }
        let mut bytes = Vec::with_capacity(parts.iter().map(|(_, length)| length).sum());
        let mut file = state.file.file();
        for &(offset, length) in parts {
            file.seek(SeekFrom::Start(offset)).ok()?;
            file.take(length as u64).read_to_end(&mut bytes).ok()?;
        }
        Some(bytes)
    }

    /// Adds a file of light, whose bytes `write` writes, without waiting for the delay of [`Journal::begin`]. A write error
    /// removes the light, but later tiles are stored. After an error of the journal itself, does nothing.
    pub fn store_light(&self, kind: LightKind, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) {
        let mut state = self.state();
        if state.error.is_some() {
            return;
        }
        match state.write_header_if_new().and_then(|_| state.write_pending()) {
            Ok(()) if state.key.is_some() => {
                if let Err(error) = state.append_light(kind, write) {
                    state.light.error = Some(error);
                }
            }
            Ok(()) => {}
            Err(error) => state.error = Some(error),
        }
        let unsynced = state.take_file_if_sync_due(SYNC_INTERVAL);
        drop(state);
        self.sync(unsynced);
    }

    /// Returns the error that ended the last attempt to store light; `None` without an error.
    pub fn light_failure(&self) -> Option<String> {
        self.state().light.error.as_ref().map(ToString::to_string)
    }
}

impl State {
    /// Appends a file of light to the file of the journal. After an error, the file ends where it ended before.
    fn append_light(&mut self, kind: LightKind, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let end = self.end;
        let mut parts = PartWriter { state: self, kind, start: 0, part: vec![] };
        write(&mut parts).and_then(|()| parts.end_part()).inspect_err(|_| {
            self.pending.clear();
            self.end = end;
            // The space is needed for tiles and the picture.
            self.error = self.file.file().set_len(end).err();
        })
    }
}

/// Writer of a file of light into the records of a journal.
struct PartWriter<'a> {
    state: &'a mut State,
    kind: LightKind,
    /// Offset of the next part in the file of light, in bytes.
    start: u64,
    /// Bytes of the next part.
    part: Vec<u8>,
}

impl PartWriter<'_> {
    /// Writes the collected bytes as a record.
    fn end_part(&mut self) -> io::Result<()> {
        let Some(key) = &self.state.key else { return Ok(()) };
        key.append_light(&mut self.state.pending, self.state.end, self.kind, self.start, &self.part);
        self.start += self.part.len() as u64;
        self.part.clear();
        self.state.write_pending()
    }
}

impl Write for PartWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let length = bytes.len().min(MAX_PART - self.part.len());
        self.part.extend(&bytes[..length]);
        if self.part.len() == MAX_PART {
            self.end_part()?;
        }
        Ok(length)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
