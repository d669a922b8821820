//! Going on with work of before: what the work is, where it is kept, and what is told of it.

use super::args::RenderArgs;
use super::console::Console;
use super::journal::{Journal, Work, beside};
use super::session;
use crate::interpreter::Timing;
use crate::render;
use std::path::Path;
use std::time::Duration;

/// This program: its version, and the size and age of its file, since versions in the making have one number.
pub fn program() -> String {
    let file = std::env::current_exe().and_then(std::fs::metadata);
    let made = |file: &std::fs::Metadata| file.modified().ok()?.duration_since(std::time::UNIX_EPOCH).ok();
    let file = file.map_or(String::new(), |file| format!("{} {:?}", file.len(), made(&file).unwrap_or_default()));
    format!("{} {file}", env!("CARGO_PKG_VERSION"))
}

/// All options that change a pixel, and the moment.
pub fn options(args: &RenderArgs, drawing: &render::Options, timing: Timing) -> String {
    let scene = &args.scene;
    let drawing = render::Options { threads: 0, ..drawing.clone() };
    let reading = session::reading_options(scene, &args.input, timing);
    let folders = &reading.search;
    format!("{drawing:?} {timing:?} {:?} {:?} {folders:?} {:?}", scene.declare, reading.version, reading.input_name)
}

/// The journal of a picture that is to be drawn; goes on with the one that is there if that is asked for, and tells if it can't.
pub fn journal(console: &Console, args: &RenderArgs, picture: &Path, work: &Work) -> Journal {
    let path = beside(picture);
    let name = path.display();
    if path.is_file() {
        if args.resume {
            match Journal::resume(path.clone(), work) {
                Ok(journal) => return journal,
                Err(reason) => console.note(&format!("`{name}` is of no use, all is drawn anew: {reason}\n")),
            }
        } else {
            console.note(&format!("`{name}` is left from before; `--resume` would go on with it\n"));
        }
    }
    Journal::new(path, work, Duration::from_secs_f64(args.keep_after.0))
}

/// The picture was not finished: tells where what was drawn is kept, all of it or what there was room for.
pub fn tell_kept(console: &Console, journal: &Journal) {
    let Some(path) = journal.close() else { return tell_failure(console, journal) };
    let path = path.display();
    let kept = match journal.failure() {
        None => format!("what was drawn is kept in `{path}`"),
        Some(reason) => format!("a part of what was drawn is kept in `{path}` (no more could be written: {reason})"),
    };
    console.note(&format!("{kept}; with `--resume` it goes on from there\n"));
}

/// Tells why what was drawn could not be kept, if so.
pub fn tell_failure(console: &Console, journal: &Journal) {
    if let Some(reason) = journal.failure() {
        console.note(&format!("what is drawn could not be kept for `--resume`: {reason}\n"));
    }
}
