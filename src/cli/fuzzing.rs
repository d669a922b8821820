//! Entry points for the fuzzers in `fuzz/`, to readers that the public API does not have. Each function takes arbitrary
//! input and must not panic. They exist only with the feature `fuzzing`.

use super::journal::{Journal, identity::Work};
use super::povray::{self, Translated};
use super::shard::ShardFile;
use super::{Cli, unknown};
use crate::font::{Font, FontLocation, find_family};
use crate::render::{FINAL_PASS, FIRST_PASS, Region, Tile, Unwatched};
use crate::source::{Exclusive, Lookups, Memory, ReadFiles, Sandbox, SearchPath, Sources};
use crate::{interpreter, render};
use clap::Parser;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Reads a font file, lays out a line of text, takes the glyphs' outlines, and searches the font by a family's name.
pub fn read_font(bytes: &[u8]) {
    let (files, path) = (Memory::default(), PathBuf::from("font.ttf"));
    files.insert(&path, bytes);
    for number in [0, 1] {
        let Ok(font) = Font::read(&files, &FontLocation::File(path.clone(), number)) else { continue };
        for placed in font.lay_out("AVÄﬁ~\u{f041}\u{1f600}") {
            font.outline(placed.glyph);
        }
        (0..20).chain([u16::MAX]).for_each(|glyph| drop(font.outline(glyph)));
    }
    find_family(&files, "Font Bold Italic", &[path]);
}

/// Translates an INI file to a durer command line, and parses the command line.
///
/// # Panics
/// If the span of a diagnostic is not inside the INI file.
pub fn read_ini(text: &str) {
    let files = Memory::default();
    files.insert("main.ini", text);
    let sources = Sources::new(Arc::new(files));
    let words = ["durer", "main.ini[low]"].map(OsString::from).to_vec();
    parse_translated(povray::translate(&sources, words), &sources);
}

/// Parses a command line whose words are the lines of a text.
pub fn parse_command_line(text: &str) {
    let words: Vec<OsString> = std::iter::once("durer").chain(text.lines()).map(OsString::from).collect();
    let sources = Sources::new(Arc::new(Memory::default()));
    if unknown::check_command_name(&words).is_ok() {
        parse_translated(povray::translate(&sources, words), &sources);
    }
}

fn parse_translated(translated: Translated, sources: &Sources) {
    for diagnostic in translated.diagnostics.iter().chain(&translated.idle) {
        let spans = diagnostic.labels.iter().map(|label| label.span).filter(|span| !span.is_none());
        spans.for_each(|span| assert!(sources.place(span).is_some(), "{span:?} is in no file: {diagnostic:?}"));
    }
    drop(Cli::try_parse_from(translated.words));
}

/// Scene that loads photons and radiosity samples from the file `light`.
const LIGHT_SCENE: &str = "#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.3 load_file \"light\" } radiosity { count 4 load_file \"light\" } }
camera { location -5*z look_at 0 }
light_source { <3, 5, -4>, 1 }
sphere { 0, 1 pigment { rgbf 1 } photons { target refraction on } }
plane { y, -1 pigment { rgb 1 } }";

/// Renders a small picture with the photons or samples of a file of light. The file is also read with a valid hash
/// appended, so that damaged records are reached.
pub fn use_light_file(bytes: &[u8]) {
    for content in [bytes.to_vec(), [bytes, blake3::hash(bytes).as_bytes()].concat()] {
        let files = Memory::default();
        files.insert("scene.pov", LIGHT_SCENE);
        files.insert("light", content);
        let sources = Sources::new(Arc::new(files));
        let Ok(scene) = crate::load(&sources, Path::new("scene.pov")) else { continue };
        let search = SearchPath { folders: vec![".".into()], fonts: vec![] };
        let options = interpreter::Options { sandbox: Sandbox::for_search_path(&search), search, ..Default::default() };
        let world = crate::build(&sources, scene, &options, &mut |_| {}).world.expect("the scene has no errors");
        render::render(&world, &render::Options::new(6, 4), &Unwatched).expect("the picture is small");
    }
}

/// Reads a shard file and all of its blocks. `folder` is a folder for the file.
pub fn read_shard(folder: &Path, bytes: &[u8]) {
    let path = folder.join("fuzzed.png.shard-1-of-2");
    let Ok(()) = std::fs::write(&path, bytes) else { return };
    let Ok(shard) = ShardFile::open(&path) else { return };
    for area in shard.header.layout.blocks(shard.header.shard) {
        assert!(shard.read_block(area).is_ok_and(|block| block.is_some()), "a block of a valid shard");
    }
}

/// A valid resume journal, from which damaged ones are made.
pub struct ValidJournal {
    path: PathBuf,
    /// Contents of the journal file: a header and the record of one tile.
    content: Vec<u8>,
    /// Length of the header in bytes.
    header: usize,
    work: Work,
}

impl ValidJournal {
    /// The only tile of the fuzzers' journal.
    const TILE: Tile = Tile { pass: FINAL_PASS, area: Region { x: 0, y: 0, width: 2, height: 1 } };
    const PIXELS: [[f32; 4]; 2] = [[0.0, 0.25, 0.5, 1.0], [1.0; 4]];

    /// Writes a valid journal to a folder; `None` if the folder cannot be written to.
    pub fn write(folder: &Path) -> Option<Self> {
        let path = folder.join("fuzzed.unfinished");
        let work = Work { options: String::new(), files: ReadFiles::default(), lookups: Lookups::default(), now: None };
        let journal = Journal::new(Exclusive::open(&path).ok()?);
        journal.begin(work.clone(), Duration::ZERO);
        journal.store_tile(Self::TILE, &Self::PIXELS);
        journal.write_pending_returning_path()?;
        drop(journal);
        let content = std::fs::read(&path).ok()?;
        let header = content.iter().position(|byte| *byte == b'\n')? + 1;
        Some(Self { path, content, header, work })
    }

    /// Resumes from journals in which arbitrary bytes replace the whole contents, follow the header, or follow the
    /// record.
    ///
    /// # Panics
    /// If the pixels of the record before the bytes are not those that were written.
    pub fn resume_with(&self, bytes: &[u8]) {
        for valid in [0, self.header, self.content.len()] {
            let Ok(()) = std::fs::write(&self.path, [&self.content[..valid], bytes].concat()) else { continue };
            let Ok(file) = Exclusive::open(&self.path) else { continue };
            let journal = Journal::new(file);
            journal.begun();
            if journal.resume(&self.work).is_err() {
                continue;
            }
            if valid == self.content.len() {
                assert_eq!(journal.load_tile(Self::TILE).as_deref(), Some(&Self::PIXELS[..]), "pixels of the record");
            }
            journal.store_tile(Tile { pass: FIRST_PASS, ..Self::TILE }, &Self::PIXELS);
            journal.write_pending_returning_path();
        }
    }
}
