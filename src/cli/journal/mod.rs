//! Journal of a picture: the finished tiles, in a file beside the picture. After an interruption, `--resume` continues
//! with it.
//!
//! The file is one line of JSON, the [`Work`] (program, options, hashes of the files that were read), and then a
//! sequence of records: pass, tile, pixels and a checksum. A record that is cut off is ignored; a record with a wrong
//! checksum makes the whole journal invalid.

pub mod finished_frames;
pub mod identity;

use super::console::Console;
use crate::render::{FINAL_PASS, Region, Tile};
use identity::Work;
use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Opens the journal of a picture: continues the one that exists if `resume` is set, and reports why that is
/// impossible. A new journal is written when rendering has taken longer than `after`.
pub fn open(console: &Console, picture: &Path, work: &Work, resume: bool, after: Duration) -> Journal {
    let path = path_beside(picture);
    let name = path.display();
    if path.is_file() {
        if resume {
            match Journal::resume(path.clone(), work) {
                Ok(journal) => return journal,
                Err(reason) => {
                    console.info(&format!("cannot continue `{name}`: {reason}; the picture is rendered anew\n"))
                }
            }
        } else {
            console.info(&format!("an unfinished render exists in `{name}`; continue it with `--resume`\n"));
        }
    }
    Journal::new(path, work, after)
}

/// Reports where the tiles of an unfinished picture are.
pub fn report_unfinished(console: &Console, journal: &Journal) {
    let Some(path) = journal.close() else { return report_failure(console, journal) };
    let path = path.display();
    let stored = match journal.failure() {
        None => format!("the unfinished picture is stored in `{path}`"),
        Some(reason) => format!("a part of the unfinished picture is stored in `{path}` (writing stopped: {reason})"),
    };
    console.info(&format!("{stored}; `--resume` continues it\n"));
}

/// Reports a journal that could not be written.
pub fn report_failure(console: &Console, journal: &Journal) {
    if let Some(reason) = journal.failure() {
        console.info(&format!("cannot write the resume journal: {reason}\n"));
    }
}

/// The path of a picture's journal: the picture's path and `.unfinished`.
pub fn path_beside(picture: &Path) -> PathBuf {
    let mut name = picture.as_os_str().to_os_string();
    name.push(".unfinished");
    name.into()
}

/// Bytes of a record before its pixels: pass, x, y, width and height.
const HEAD: usize = 33;
/// Bytes of the checksum after the pixels.
const SUM: usize = 4;
/// Largest number of pixels of a tile.
const MAX_PIXELS: usize = 1 << 16;
/// Bytes that are written together, approximately.
const CHUNK: usize = 1 << 16;

/// The tiles of a picture that is being rendered.
pub struct Journal {
    path: PathBuf,
    /// Offsets in `old_file` of the pixels of finished tiles, by pass and corner.
    known: HashMap<(u8, usize, usize), (Region, u64)>,
    /// File of the earlier journal that a resumed render continues.
    old_file: Option<Mutex<File>>,
    /// Moment from which tiles are written.
    begins: Instant,
    state: Mutex<State>,
}

struct State {
    header: Vec<u8>,
    file: Option<File>,
    /// Records that are not written yet.
    pending: Vec<u8>,
    error: Option<io::Error>,
}

impl Journal {
    /// A new journal, whose file appears when rendering has taken longer than `after`.
    pub fn new(path: PathBuf, work: &Work, after: Duration) -> Self {
        let mut header = serde_json::to_vec(work).unwrap_or_default();
        header.push(b'\n');
        let state = State { header, file: None, pending: vec![], error: None };
        Self { path, known: HashMap::new(), old_file: None, begins: Instant::now() + after, state: Mutex::new(state) }
    }

    /// Continues a journal of the same work.
    ///
    /// # Errors
    /// The reason, if the journal belongs to other work or is damaged.
    pub fn resume(path: PathBuf, work: &Work) -> Result<Self, String> {
        let broken = |e: io::Error| format!("it can't be read: {e}");
        let file = OpenOptions::new().read(true).write(true).open(&path).map_err(broken)?;
        let mut reader = BufReader::with_capacity(1 << 20, &file);
        let mut header = vec![];
        reader.read_until(b'\n', &mut header).map_err(broken)?;
        let begun: Work = serde_json::from_slice(&header).map_err(|_| "it is damaged".to_string())?;
        if let Some(reason) = work.differs(&begun) {
            return Err(reason);
        }
        let (mut known, mut end) = (HashMap::new(), header.len() as u64);
        while let Some((pass, tile, length)) = record(&mut reader)? {
            known.insert((pass, tile.x, tile.y), (tile, end + HEAD as u64));
            end += length as u64;
        }
        drop(reader);
        file.set_len(end).map_err(broken)?;
        let mut more = file.try_clone().map_err(broken)?;
        more.seek(SeekFrom::Start(end)).map_err(broken)?;
        let old_file = File::open(&path).map_err(broken)?;
        let state = State { header: vec![], file: Some(more), pending: vec![], error: None };
        let begins = Instant::now();
        Ok(Self { path, known, old_file: Some(Mutex::new(old_file)), begins, state: Mutex::new(state) })
    }

    /// Returns the pixels of a tile that was finished by an earlier run.
    pub fn load_tile(&self, tile: Tile) -> Option<Vec<[f32; 4]>> {
        let (area, at) = self.known.get(&(tile.pass, tile.area.x, tile.area.y))?;
        if *area != tile.area {
            return None;
        }
        let mut bytes = vec![0; area.width * area.height * 16];
        let mut file = self.old_file.as_ref()?.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(*at)).ok()?;
        file.read_exact(&mut bytes).ok()?;
        let (numbers, _) = bytes.as_chunks::<4>();
        let numbers: Vec<f32> = numbers.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect();
        Some(numbers.as_chunks::<4>().0.to_vec())
    }

    /// Adds a finished tile. A write error ends the journal, but not the rendering.
    pub fn store_tile(&self, tile: Tile, pixels: &[[f32; 4]]) {
        if Instant::now() < self.begins {
            return;
        }
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if state.error.is_some() {
            return;
        }
        append(&mut state.pending, tile, pixels);
        if state.file.is_none() || state.pending.len() >= CHUNK {
            state.error = state.write(&self.path).err();
        }
    }

    /// Writes all pending records. Returns the path of the journal if its file exists.
    pub fn close(&self) -> Option<&Path> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if state.file.is_some() && state.error.is_none() {
            state.error = state.write(&self.path).err();
        }
        state.file.is_some().then_some(self.path.as_path())
    }

    /// Returns the error that ended the journal.
    pub fn failure(&self) -> Option<String> {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.error.as_ref().map(ToString::to_string)
    }

    /// Deletes the file after the picture has been written.
    pub fn remove(&self) {
        let written = self.state.lock().unwrap_or_else(PoisonError::into_inner).file.take().is_some();
        if written {
            // A later run reports and ignores a file that remains.
            let _ = std::fs::remove_file(&self.path);
        }
    }
}

impl State {
    fn write(&mut self, path: &Path) -> io::Result<()> {
        let file = match &mut self.file {
            Some(file) => file,
            None => {
                let mut file = File::create(path)?;
                file.write_all(&self.header)?;
                self.file.insert(file)
            }
        };
        file.write_all(&self.pending)?;
        self.pending.clear();
        Ok(())
    }
}

fn append(out: &mut Vec<u8>, tile: Tile, pixels: &[[f32; 4]]) {
    let start = out.len();
    out.push(tile.pass);
    let Region { x, y, width, height } = tile.area;
    [x, y, width, height].iter().for_each(|&n| out.extend((n as u64).to_le_bytes()));
    pixels.as_flattened().iter().for_each(|x| out.extend(x.to_le_bytes()));
    let sum = crc32fast::hash(&out[start..]);
    out.extend(sum.to_le_bytes());
}

/// Reads pass, tile and length in bytes of the next record; `None` at the end, and if the record is cut off.
fn record(from: &mut impl Read) -> Result<Option<(u8, Region, usize)>, String> {
    let mut bytes = vec![0; HEAD];
    if from.read_exact(&mut bytes).is_err() {
        return Ok(None);
    }
    let mut numbers = bytes[1..].as_chunks::<8>().0.iter().map(|&number| u64::from_le_bytes(number) as usize);
    let [x, y, width, height] = [(); 4].map(|()| numbers.next().unwrap_or(0));
    let damaged = || Err("it is damaged".to_string());
    if width.saturating_mul(height) > MAX_PIXELS || bytes[0] > FINAL_PASS {
        return damaged();
    }
    bytes.resize(HEAD + width * height * 16 + SUM, 0);
    if from.read_exact(&mut bytes[HEAD..]).is_err() {
        return Ok(None);
    }
    let (content, sum) = bytes.split_at(bytes.len() - SUM);
    if crc32fast::hash(content).to_le_bytes() != sum {
        return damaged();
    }
    Ok(Some((bytes[0], Region { x, y, width, height }, bytes.len())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::ContentHash;
    use crate::source::ReadFiles;

    fn work(options: &str) -> Work {
        Work {
            program: "1".into(),
            options: options.into(),
            files: ReadFiles::from([("a.pov".into(), ContentHash::of(b"7"))]),
        }
    }

    fn tile(x: usize) -> Tile {
        Tile { pass: (x % 2) as u8, area: Region { x, y: 3, width: 2, height: 1 } }
    }

    fn pixels(x: usize) -> Vec<[f32; 4]> {
        vec![[x as f32, f32::NAN, -0.0, 1.5], [f32::INFINITY; 4]]
    }

    fn written(path: &Path) -> Vec<u8> {
        let journal = Journal::new(path.into(), &work("a"), Duration::ZERO);
        (0..9).for_each(|x| journal.store_tile(tile(x), &pixels(x)));
        assert_eq!(journal.close(), Some(path));
        std::fs::read(path).unwrap()
    }

    #[test]
    fn records_before_a_cut_are_known() {
        let folder = tempfile::tempdir().unwrap();
        let path = path_beside(&folder.path().join("a.png"));
        let whole = written(&path);
        let header = whole.iter().position(|&b| b == b'\n').unwrap() + 1;
        let size = (whole.len() - header) / 9;
        for end in header..=whole.len() {
            std::fs::write(&path, &whole[..end]).unwrap();
            let journal = Journal::resume(path.clone(), &work("a")).unwrap();
            for x in 0..9 {
                let known = journal.load_tile(tile(x)).map(|p| format!("{p:?}"));
                assert_eq!(known, (x < (end - header) / size).then(|| format!("{:?}", pixels(x))));
            }
            let missing = (0..9).filter(|x| journal.load_tile(tile(*x)).is_none());
            missing.for_each(|x| journal.store_tile(tile(x), &pixels(x)));
            journal.close();
            assert!(std::fs::read(&path).unwrap() == whole);
        }
    }

    #[test]
    fn damage_and_other_work_are_reported() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let whole = written(&path);
        let reason = |work: &Work| Journal::resume(path.clone(), work).err().unwrap_or_default();
        assert_eq!(reason(&work("b")), "it was rendered with other options");
        let changed = Work { files: ReadFiles::from([("a.pov".into(), ContentHash::of(b"8"))]), ..work("a") };
        assert_eq!(reason(&changed), "`a.pov` has changed");
        for at in (whole.len() - 36..whole.len()).step_by(5) {
            let mut bytes = whole.clone();
            bytes[at] ^= 4;
            std::fs::write(&path, bytes).unwrap();
            assert_eq!(reason(&work("a")), "it is damaged", "{at}");
        }
        std::fs::write(&path, "").unwrap();
        assert_eq!(reason(&work("a")), "it is damaged");
    }
}
