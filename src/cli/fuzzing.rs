//! Entry points of the fuzzers in `fuzz/` to readers that the public API does not have. Each takes arbitrary input and
//! must not panic. They exist with the feature `fuzzing` only.

use super::journal::{Journal, identity::Work};
use super::povray::{self, Translated};
use super::{Cli, unknown};
use crate::font::{Font, FontLocation, find_family};
use crate::render::{FINAL_PASS, FIRST_PASS, Region, Tile};
use crate::source::{Memory, ReadFiles, Sources};
use clap::Parser;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Reads a font file, sets a line of text, takes the outlines of its glyphs, and searches the font by a family's name.
pub fn read_font(bytes: &[u8]) {
    let (files, path) = (Memory::default(), PathBuf::from("font.ttf"));
    files.insert(&path, bytes);
    for number in [0, 1] {
        let Ok(font) = Font::read(&files, &FontLocation::File(path.clone(), number)) else { continue };
        for placed in font.set("AVÄﬁ~\u{f041}\u{1f600}") {
            font.outline(placed.glyph);
        }
        (0..20).chain([u16::MAX]).for_each(|glyph| drop(font.outline(glyph)));
    }
    find_family(&files, "Font Bold Italic", &[path]);
}

/// Translates an INI file to a command line of durer's, and parses the command line.
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
    if unknown::check(&words).is_ok() {
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

/// Resumes from a journal with the content `bytes`: once as it is, once with a valid header before `bytes`, and once
/// with a valid checksum after them, too. `folder` holds the journal's file.
pub fn resume_journal(bytes: &[u8], folder: &Path) {
    let work = Work { program: String::new(), options: String::new(), files: ReadFiles::default() };
    let header = [serde_json::to_vec(&work).unwrap_or_default(), vec![b'\n']].concat();
    let checksum = crc32fast::hash(bytes).to_le_bytes();
    for journal in [bytes.to_vec(), [&header, bytes].concat(), [&header, bytes, &checksum].concat()] {
        let path = folder.join("fuzzed.unfinished");
        if std::fs::write(&path, journal).is_err() {
            continue;
        }
        let Ok(journal) = Journal::resume(path, &work) else { continue };
        for pass in [FIRST_PASS, FINAL_PASS] {
            let tile = Tile { pass, area: Region { x: 0, y: 0, width: 2, height: 1 } };
            if journal.load_tile(tile).is_none() {
                journal.store_tile(tile, &[[0.0; 4]; 2]);
            }
        }
        journal.close();
    }
}
