//! Journal of a picture: the finished tiles, and the photons and radiosity samples, in a file beside the picture. After an
//! interruption, `--resume` continues with it.
//!
//! The file is one line of JSON, the [`Begun`] work (program, options, files that were read and looked up), and then a
//! sequence of records: tiles, and parts of files of light. A record that is cut off is ignored; a record with a wrong
//! checksum makes the whole journal invalid. From the beginning of a render to its end the file is locked, so that one
//! process at a time renders a picture.

pub mod finished_frames;
pub mod identity;
mod light;
pub mod record;

use super::console::Console;
use super::exit::{self, Failure};
use crate::diagnostic::{Diagnostic, codes, file};
use crate::render::{FINAL_PASS, Region, Tile};
use crate::source::{Disk, Exclusive, OpenError, Span, follow_links, sync_folder_of};
use identity::{Begun, Work};
use light::StoredLight;
use record::{Content, HEAD, Key, Record, SUM, damaged_reason, unreadable_reason};
use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Opens or creates the journal of a picture, and locks it while the returned value exists.
///
/// # Errors
/// If another process renders the picture, or the journal is not a plain file (E0004).
pub fn lock(picture: &Path) -> exit::Result<Journal> {
    // A picture and a link to the picture are one output.
    let path = journal_path(&follow_links(picture).unwrap_or_else(|_| picture.to_path_buf()));
    match Exclusive::open(&path) {
        Ok(file) => Ok(Journal::new(file)),
        Err(error) => Err(lock_failure(picture, &path, error)),
    }
}

/// Deletes the journal of a finished frame, which a run that was killed just after the frame has left.
pub fn remove_finished_journal(picture: &Path) {
    let path = journal_path(&follow_links(picture).unwrap_or_else(|_| picture.to_path_buf()));
    if path.is_file()
        && let Ok(file) = Exclusive::open(&path)
    {
        file.delete();
    }
}

/// Returns the failure to open the journal of a picture.
fn lock_failure(picture: &Path, journal: &Path, error: OpenError) -> Failure {
    let (path, reason, help) = match error {
        OpenError::Io(error) => return Failure::Fault(Box::new(file::unwritable(&Disk, journal, &error))),
        OpenError::InUse => (
            picture,
            "another process is rendering it",
            "wait for the end of that render, or give the picture another name with `-o`",
        ),
        OpenError::NotPlain => (
            journal,
            "it is not a regular file with one name",
            "move it away: durer stores unfinished work under this name",
        ),
    };
    let text = format!("`{}` can't be written: {reason}", path.display());
    Failure::Fault(Box::new(Diagnostic::new(codes::FILE_UNWRITABLE, Span::NONE, text).help(help)))
}

/// Begins the work of a journal: continues the work in the journal if `resume` is set, or reports why that is impossible.
/// New work is written when rendering has taken longer than `first_write_delay`.
pub fn begin(console: &Console, journal: &Journal, work: Work, resume: bool, first_write_delay: Duration) {
    let name = journal.path.display();
    if journal.has_old_work() {
        if resume {
            match journal.resume(&work) {
                Ok(()) => return,
                Err(reason) => {
                    console.info(&format!("cannot continue `{name}`: {reason}; the picture is rendered anew\n"))
                }
            }
        } else {
            console.info(&format!("an unfinished render exists in `{name}`; continue it with `--resume`\n"));
        }
    }
    journal.begin(work, first_write_delay);
}

/// Writes the pending records of the journal, waits for the disk, and returns a line that states where the unfinished
/// picture is; `None` if the journal is not begun in its file and nothing failed.
pub fn flush_and_describe(journal: &Journal) -> Option<String> {
    let Some(path) = journal.write_pending_returning_path() else { return failure_note(journal) };
    let path = path.display();
    let stored = match journal.failure() {
        None => format!("the unfinished picture is stored in `{path}`"),
        Some(reason) => format!("a part of the unfinished picture is stored in `{path}` (writing stopped: {reason})"),
    };
    let command = if journal.continues_itself { "the same command" } else { "`--resume`" };
    Some(format!("{stored}; {command} continues it\n"))
}

/// Returns a line about a journal that could not be written, whole or in part; `None` if nothing failed.
pub fn failure_note(journal: &Journal) -> Option<String> {
    let failure = journal.failure().map(|reason| format!("cannot write the resume journal: {reason}\n"));
    failure.or_else(|| {
        let reason = journal.light_failure()?;
        Some(format!("cannot write photons or radiosity samples to the resume journal: {reason}\n"))
    })
}

/// Returns the path of a picture's journal: the picture's path and `.unfinished`.
pub fn journal_path(picture: &Path) -> PathBuf {
    let mut name = picture.as_os_str().to_os_string();
    name.push(".unfinished");
    name.into()
}

/// Number of bytes of pending records from which a journal writes them to its file.
const CHUNK: usize = 1 << 16;
/// Maximum length of a journal's header, in bytes.
const MAX_HEADER: u64 = 1 << 26;
/// Time between two waits for the disk. A power loss costs at most the tiles that were finished within this time.
const SYNC_INTERVAL: Duration = Duration::from_secs(5);

/// Journal of a picture that is being rendered: finished tiles, photons and radiosity samples in a locked file.
pub struct Journal {
    path: PathBuf,
    /// True for the journal of a shard: the same command continues the work without `--resume`.
    continues_itself: bool,
    state: Mutex<State>,
}

struct State {
    file: Exclusive,
    /// Moment from which tiles are written; `None` before the work is known.
    begins: Option<Instant>,
    /// New work whose header is not yet written to the journal's file; `None` once the header is written.
    new_work: Option<Work>,
    /// Key of the records; `None` before the header is written.
    key: Option<Key>,
    /// Areas of the tiles that an earlier run has finished, and offsets of their pixels in the file, by pass and corner.
    known: HashMap<(u8, usize, usize), (Region, u64)>,
    /// Photons and radiosity samples in the file that an earlier run has stored.
    light: StoredLight,
    /// Length of the header and all records in the file.
    end: u64,
    /// Bytes of the records that are not yet written to the journal's file.
    pending: Vec<u8>,
    error: Option<io::Error>,
    /// Moment at which the last wait until the journal was on the disk ended; `None` before the first.
    synced: Option<Instant>,
}

impl Journal {
    /// Creates the journal in a file, whose old contents remain until the first tile is stored.
    pub fn new(file: Exclusive) -> Self {
        let path = file.path().to_path_buf();
        let state = State {
            file,
            begins: None,
            new_work: None,
            key: None,
            known: HashMap::new(),
            light: StoredLight::default(),
            end: 0,
            pending: vec![],
            error: None,
            synced: None,
        };
        Self { path, continues_itself: false, state: Mutex::new(state) }
    }

    /// Marks the journal as that of a shard; messages then say that the same command continues the work, without
    /// `--resume`.
    pub fn of_shard(self) -> Self {
        Self { continues_itself: true, ..self }
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// True if the file has contents from an earlier run.
    fn has_old_work(&self) -> bool {
        self.state().file.file().metadata().is_ok_and(|metadata| metadata.len() > 0)
    }

    /// Returns the work that an earlier run of this program began, from the header in the journal's file; `None`
    /// without a valid header.
    pub fn begun(&self) -> Option<Begun> {
        let state = self.state();
        read_header(&mut reader_from_start(state.file.file()).ok()?).and_then(|header| Begun::parse(&header)).ok()
    }

    /// Begins a journal of new work. The file's old contents remain until light is stored, or a tile that is finished after
    /// `first_write_delay`.
    pub fn begin(&self, work: Work, first_write_delay: Duration) {
        let mut state = self.state();
        state.begins = Instant::now().checked_add(first_write_delay);
        state.new_work = Some(work);
    }

    /// Continues the work whose tiles the journal's file holds, if it is the same as `work`.
    ///
    /// # Errors
    /// The reason, if the journal belongs to other work or is damaged.
    pub fn resume(&self, work: &Work) -> Result<(), String> {
        let mut guard = self.state();
        let state = &mut *guard;
        let mut reader = reader_from_start(state.file.file()).map_err(|e| unreadable_reason(&e))?;
        let header = read_header(&mut reader)?;
        if let Some(reason) = work.difference_reason(&Begun::parse(&header)?.work) {
            return Err(reason);
        }
        let (key, mut end) = (Key::of(&header), header.len() as u64);
        let (mut known, mut light) = (HashMap::new(), StoredLight::default());
        while let Some(Record { content, length }) = key.read_record(&mut reader, end)? {
            let offset = end + HEAD as u64;
            match content {
                Content::Tile(Tile { pass, area }) => _ = known.insert((pass, area.x, area.y), (area, offset)),
                Content::Light { kind, start } => light.add_part(kind, start, offset, length - HEAD - SUM),
            }
            end += length as u64;
        }
        state.file.file().set_len(end).map_err(|e| unreadable_reason(&e))?;
        (state.key, state.known, state.light) = (Some(key), known, light);
        (state.end, state.begins) = (end, Some(Instant::now()));
        Ok(())
    }

    /// Returns the pixels of a tile that an earlier run has finished, row by row; `None` for another tile, or if reading fails.
    pub fn load_tile(&self, tile: Tile) -> Option<Vec<[f32; 4]>> {
        let state = self.state();
        let (area, at) = state.known.get(&(tile.pass, tile.area.x, tile.area.y))?;
        if *area == tile.area { state.pixels_at(*area, *at) } else { None }
    }

    /// Returns the finished tiles of the final pass, in the order of their rows, each with the offset of its pixels in
    /// the file. Empty before the file has a header.
    ///
    /// # Errors
    /// The reason for which the file cannot be read.
    pub fn finished_tiles_and_offsets(&self) -> Result<Vec<(Region, u64)>, String> {
        let mut guard = self.state();
        let state = &mut *guard;
        if state.key.is_none() {
            return Ok(vec![]);
        }
        state.write_pending().map_err(|e| unreadable_reason(&e))?;
        let Some(key) = &state.key else { return Ok(vec![]) };
        let mut reader = reader_from_start(state.file.file()).map_err(|e| unreadable_reason(&e))?;
        let (mut at, mut tiles) = (read_header(&mut reader)?.len() as u64, vec![]);
        while let Some(record) = key.read_record(&mut reader, at)? {
            if let Some(tile) = record.tile().filter(|tile| tile.pass == FINAL_PASS) {
                tiles.push((tile.area, at + HEAD as u64));
            }
            at += record.length as u64;
        }
        tiles.sort_by_key(|(area, _)| (area.y, area.x));
        Ok(tiles)
    }

    /// Reads the pixels of a tile's area from the journal's file, at the offset that [`Self::finished_tiles_and_offsets`] gave;
    /// `None` if reading fails.
    pub fn pixels_at(&self, area: Region, file_offset: u64) -> Option<Vec<[f32; 4]>> {
        self.state().pixels_at(area, file_offset)
    }

    /// Adds a finished tile. Before the delay of [`Journal::begin`] is over, the tile is not stored at all. A write error ends
    /// the journal, but not the rendering.
    pub fn store_tile(&self, tile: Tile, pixels: &[[f32; 4]]) {
        let mut state = self.state();
        if state.error.is_some() || state.begins.is_none_or(|begins| Instant::now() < begins) {
            return;
        }
        if let Err(error) = state.store(tile, pixels) {
            state.error = Some(error);
        }
        let unsynced = state.take_file_if_sync_due(SYNC_INTERVAL);
        // Other threads store their tiles meanwhile.
        drop(state);
        self.sync(unsynced);
    }

    /// Writes all pending records, and waits for the disk. Returns the path of the journal; `None`, without writing, if
    /// [`Self::has_header`] is false. An error is only noted for [`Self::failure`].
    pub fn write_pending_returning_path(&self) -> Option<&Path> {
        let mut state = self.state();
        state.key.as_ref()?;
        if state.error.is_none() {
            state.error = state.write_pending().err();
        }
        let unsynced = state.take_file_if_sync_due(Duration::ZERO);
        drop(state);
        self.sync(unsynced);
        Some(&self.path)
    }

    /// True if the header of this run's work is in the journal's file: after [`Self::resume`], or once a tile or light is
    /// stored.
    pub fn has_header(&self) -> bool {
        self.state().key.is_some()
    }

    /// Returns the write error after which the journal stores no more tiles; `None` without an error.
    pub fn failure(&self) -> Option<String> {
        self.state().error.as_ref().map(ToString::to_string)
    }

    /// Deletes the journal's file after the picture has been written. A file without the header of this run's work, which may
    /// be of other work, remains.
    pub fn remove_if_written(&self) {
        let state = self.state();
        if state.key.is_some() {
            state.file.delete();
        }
    }

    /// Deletes the journal's file if it is empty, before the process ends.
    pub fn remove_if_empty(&self) {
        let state = self.state();
        if state.file.file().metadata().is_ok_and(|metadata| metadata.len() == 0) {
            state.file.delete();
        }
    }

    /// Waits until the journal's contents are on the disk; the first time, also until the file's name is.
    fn sync(&self, unsynced: Option<UnsyncedFile>) {
        let Some(UnsyncedFile { file, is_first }) = unsynced else { return };
        if let Err(error) = file.sync_data() {
            self.state().error.get_or_insert(error);
        }
        if is_first {
            sync_folder_of(&self.path);
        }
    }
}

/// File of the journal that is about to be synchronized with the disk.
struct UnsyncedFile {
    file: File,
    /// True for the first synchronization, after which the folder is synchronized too.
    is_first: bool,
}

impl State {
    /// Reads the pixels of a tile's area from the journal's file, at this offset; `None` if reading fails.
    fn pixels_at(&self, area: Region, file_offset: u64) -> Option<Vec<[f32; 4]>> {
        let mut bytes = vec![0; area.width * area.height * 16];
        let mut file = self.file.file();
        file.seek(SeekFrom::Start(file_offset)).ok()?;
        file.read_exact(&mut bytes).ok()?;
        let (numbers, _) = bytes.as_chunks::<4>();
        let numbers: Vec<f32> = numbers.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect();
        Some(numbers.as_chunks::<4>().0.to_vec())
    }

    /// Appends a tile to the pending bytes, which are written from time to time; does nothing if no work has begun.
    fn store(&mut self, tile: Tile, pixels: &[[f32; 4]]) -> io::Result<()> {
        let is_first = self.write_header_if_new()?;
        let Some(key) = &self.key else { return Ok(()) };
        let offset = self.end + self.pending.len() as u64;
        key.append_tile(&mut self.pending, offset, tile, pixels);
        if is_first || self.pending.len() >= CHUNK || self.is_sync_due(SYNC_INTERVAL) {
            self.write_pending()
        } else {
            Ok(())
        }
    }

    /// Replaces the old contents by the header of new work, if the header is not written yet. Returns true if it was written.
    fn write_header_if_new(&mut self) -> io::Result<bool> {
        let Some(work) = self.new_work.take() else { return Ok(false) };
        // An empty file vanishes at the end.
        self.write_header(work).inspect_err(|_| _ = self.file.file().set_len(0))?;
        Ok(true)
    }

    /// Replaces the old contents of the journal's file by the header of `work`.
    fn write_header(&mut self, work: Work) -> io::Result<()> {
        let mut header = serde_json::to_vec(&Begun::new(work))?;
        header.push(b'\n');
        let mut file = self.file.file();
        file.set_len(0)?;
        file.seek(SeekFrom::Start(0))?;
        file.write_all(&header)?;
        (self.key, self.end) = (Some(Key::of(&header)), header.len() as u64);
        Ok(())
    }

    fn write_pending(&mut self) -> io::Result<()> {
        let mut file = self.file.file();
        file.seek(SeekFrom::Start(self.end))?;
        file.write_all(&self.pending)?;
        self.end += self.pending.len() as u64;
        self.pending.clear();
        Ok(())
    }

    /// True if the last wait for the disk was longer ago than `interval`.
    fn is_sync_due(&self, interval: Duration) -> bool {
        self.synced.is_none_or(|synced| synced.elapsed() >= interval)
    }

    /// Returns the file if it is time to wait for the disk, and counts the wait as done; `None` before the header is written,
    /// and if the last wait was not longer ago than `interval`.
    fn take_file_if_sync_due(&mut self, interval: Duration) -> Option<UnsyncedFile> {
        let is_first = self.synced.is_none();
        if self.key.is_none() || !self.is_sync_due(interval) {
            return None;
        }
        self.synced = Some(Instant::now());
        Some(UnsyncedFile { file: self.file.file().try_clone().ok()?, is_first })
    }
}

fn reader_from_start(mut file: &File) -> io::Result<BufReader<&File>> {
    file.seek(SeekFrom::Start(0))?;
    Ok(BufReader::with_capacity(1 << 20, file))
}

/// Reads the header of a journal, which is its first line, with the line's end.
fn read_header(reader: &mut impl BufRead) -> Result<Vec<u8>, String> {
    let mut header = vec![];
    reader.by_ref().take(MAX_HEADER).read_until(b'\n', &mut header).map_err(|e| unreadable_reason(&e))?;
    if header.ends_with(b"\n") { Ok(header) } else { Err(damaged_reason()) }
}

#[cfg(test)]
mod tests;
