//! What is drawn of a picture, tile by tile, in a file beside the picture: whatever ends the program, the next one goes on there.
//!
//! The file is one line of JSON, which says what the work was (version, options, the files that were read), and then a row of records: a pass,
//! a tile, its pixels and a checksum. A record that is cut off is as good as none; one with a wrong checksum makes the whole journal
//! worth nothing.

use crate::render::{FINAL_PASS, Region, Tile};
use crate::source::ReadFiles;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// What the work is: the same work gives the same bytes.
#[derive(Serialize, Deserialize, Clone, Debug, PartialEq)]
pub struct Work {
    /// Of this program.
    pub program: String,
    /// All options that change a pixel, and the moment.
    pub options: String,
    /// What was read.
    pub files: ReadFiles,
}

impl Work {
    /// Why work that was begun as `other` can't go on as this one.
    pub fn differs(&self, other: &Work) -> Option<String> {
        if self.program != other.program {
            return Some("another version of durer drew it".into());
        }
        if self.options != other.options {
            return Some("it was drawn with other options".into());
        }
        let changed = self.files.iter().find(|(path, print)| other.files.get(*path) != Some(print));
        changed.map(|(path, _)| format!("`{}` has changed", path.display()))
    }
}

/// A picture's file and `.unfinished`.
pub fn beside(picture: &Path) -> PathBuf {
    let mut name = picture.as_os_str().to_os_string();
    name.push(".unfinished");
    name.into()
}

/// Bytes of a record without its pixels: pass, x, y, width, height and, behind the pixels, the checksum.
const HEAD: usize = 33;
const SUM: usize = 4;
/// A tile has so many pixels at most.
const MOST: usize = 1 << 16;
/// Written at once, about.
const CHUNK: usize = 1 << 16;

/// The tiles of a picture that is drawn.
pub struct Journal {
    path: PathBuf,
    /// Where the pixels of tiles of before stand.
    known: HashMap<(u8, usize, usize), (Region, u64)>,
    before: Option<Mutex<File>>,
    begins: Instant,
    state: Mutex<State>,
}

struct State {
    header: Vec<u8>,
    file: Option<File>,
    waiting: Vec<u8>,
    failed: Option<io::Error>,
}

impl Journal {
    /// A new one, which is written once drawing has taken so long.
    pub fn new(path: PathBuf, work: &Work, after: Duration) -> Self {
        let mut header = serde_json::to_vec(work).unwrap_or_default();
        header.push(b'\n');
        let state = State { header, file: None, waiting: vec![], failed: None };
        Self { path, known: HashMap::new(), before: None, begins: Instant::now() + after, state: Mutex::new(state) }
    }

    /// Goes on with one that is there, if it is of this work; the reason if not.
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
        let before = File::open(&path).map_err(broken)?;
        let state = State { header: vec![], file: Some(more), waiting: vec![], failed: None };
        let begins = Instant::now();
        Ok(Self { path, known, before: Some(Mutex::new(before)), begins, state: Mutex::new(state) })
    }

    /// The pixels of a tile that was drawn before.
    pub fn load_tile(&self, tile: Tile) -> Option<Vec<[f32; 4]>> {
        let (area, at) = self.known.get(&(tile.pass, tile.area.x, tile.area.y))?;
        if *area != tile.area {
            return None;
        }
        let mut bytes = vec![0; area.width * area.height * 16];
        let mut file = self.before.as_ref()?.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(*at)).ok()?;
        file.read_exact(&mut bytes).ok()?;
        let (numbers, _) = bytes.as_chunks::<4>();
        let numbers: Vec<f32> = numbers.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect();
        Some(numbers.as_chunks::<4>().0.to_vec())
    }

    /// Keeps a tile. What can't be written ends the journal, not the picture.
    pub fn store_tile(&self, tile: Tile, pixels: &[[f32; 4]]) {
        if Instant::now() < self.begins {
            return;
        }
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if state.failed.is_some() {
            return;
        }
        append(&mut state.waiting, tile, pixels);
        if state.file.is_none() || state.waiting.len() >= CHUNK {
            state.failed = state.write(&self.path).err();
        }
    }

    /// What was kept is written; where it is, if anything is.
    pub fn close(&self) -> Option<&Path> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if state.file.is_some() && state.failed.is_none() {
            state.failed = state.write(&self.path).err();
        }
        state.file.is_some().then_some(self.path.as_path())
    }

    /// Why it could not be written, if it couldn't.
    pub fn failure(&self) -> Option<String> {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        state.failed.as_ref().map(ToString::to_string)
    }

    /// The picture is where it belongs.
    pub fn remove(self) {
        let written = self.state.lock().unwrap_or_else(PoisonError::into_inner).file.take().is_some();
        if written {
            // One that stays is told and not used.
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
        file.write_all(&self.waiting)?;
        self.waiting.clear();
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

/// Pass, tile and length of the next record; `None` at the end, also of one that is cut off.
fn record(from: &mut impl Read) -> Result<Option<(u8, Region, usize)>, String> {
    let mut bytes = vec![0; HEAD];
    if from.read_exact(&mut bytes).is_err() {
        return Ok(None);
    }
    let mut numbers = bytes[1..].as_chunks::<8>().0.iter().map(|&number| u64::from_le_bytes(number) as usize);
    let [x, y, width, height] = [(); 4].map(|()| numbers.next().unwrap_or(0));
    let damaged = || Err("it is damaged".to_string());
    if width.saturating_mul(height) > MOST || bytes[0] > FINAL_PASS {
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
    fn whatever_is_cut_off_the_rest_is_known() {
        let folder = tempfile::tempdir().unwrap();
        let path = beside(&folder.path().join("a.png"));
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
    fn what_is_damaged_or_of_other_work_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let whole = written(&path);
        let reason = |work: &Work| Journal::resume(path.clone(), work).err().unwrap_or_default();
        assert_eq!(reason(&work("b")), "it was drawn with other options");
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
