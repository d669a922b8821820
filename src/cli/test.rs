//! `durer test [PATH…]`: draws each scene that has a snapshot, and compares.

use super::args::{LookArgs, MessageFormat, SceneArgs, TestArgs};
use super::console::Console;
use super::exit::{Exit, Failure, Result, usage};
use super::interrupt::{self, Orderly};
use super::memory;
use super::progress::Progress;
use super::session;
use super::summary::{self, Word};
use super::values::Size;
use super::watcher::Watcher;
use crate::diagnostic::file;
use crate::image_io::{self, Encoding, Format, Frame, Pixels};
use crate::snapshot::{self, Case, Comparison, Entry, Tolerance, Verdict};
use crate::source::{Disk, Files, Sources};
use clap::Parser;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What a scene says about its snapshot: `//! test: --size 128x96 --aa off`.
#[derive(Parser, Debug)]
#[command(no_binary_name = true, disable_help_flag = true)]
struct Header {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    look: LookArgs,
}

/// What all scenes of a test are drawn with.
#[derive(Clone, Debug, Default)]
pub struct Setting {
    /// `-I`.
    pub include: Vec<PathBuf>,
    /// 0: one for each processor.
    pub threads: usize,
}

/// How one scene fared.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The exit code it alone would give.
    pub exit: Exit,
    /// How the pictures differ, where there are two.
    pub comparison: Option<Comparison>,
    /// One line.
    pub text: String,
    /// Errors and warnings as a person reads them.
    pub messages: String,
    /// The snapshot.
    pub expected: Option<Frame>,
    /// What was drawn now.
    pub drawn: Option<Frame>,
    /// How it is stored.
    encoding: Encoding,
}

/// Draws, compares, tells and accepts.
///
/// # Errors
/// What `durer test` can exit with otherwise than by its outcomes: paths that are not there, a report that can't be written.
pub fn run(console: &Console, args: &TestArgs) -> Result {
    let here = vec![PathBuf::from(".")];
    let paths = if args.paths.is_empty() { &here } else { &args.paths };
    for path in paths.iter().filter(|path| !path.is_dir()) {
        session::check_input(path)?;
        if super::povray::is_ini(&path.to_string_lossy()) {
            return usage(format!("snapshots belong to scenes: name the scene, not `{}`", path.display()));
        }
    }
    let cases = snapshot::find(&Disk, paths).map_err(|e| Box::new(file::unreadable(&Disk, &paths[0], &e.into())))?;
    if cases.is_empty() {
        return usage("no scene here has a snapshot; `durer test --accept NAME.scene` makes the first one");
    }
    let setting = Setting { include: args.include.clone(), threads: args.threads.map_or(0, usize::from) };
    let mut outcomes = Vec::new();
    for case in cases {
        let mut outcome = try_case(console, &case, &setting);
        if args.accept {
            accept(&case, &mut outcome)?;
        }
        let accept = acceptance(args, &case, &outcome);
        match args.format {
            MessageFormat::Human => {
                console.note(&outcome.messages);
                console.data(line(&case, &outcome, accept.as_deref()))?;
            }
            MessageFormat::Json => console.json(&as_json(&case, &outcome, accept.as_deref()))?,
        }
        outcomes.push((case, outcome));
        if interrupt::asked() {
            return Err(Failure::Told(Exit::Interrupted));
        }
    }
    if let Some(folder) = &args.report {
        let page = write_report(args, folder, &outcomes)?;
        console.note(&format!("the pictures are side by side in {}\n", page.display()));
    }
    if args.format == MessageFormat::Human {
        let words: Vec<_> = outcomes.iter().map(|(_, outcome)| word(outcome)).collect();
        console.data(summary::total(&words, console.take_count()))?;
    }
    Ok(summary::worst(outcomes.iter().map(|(_, outcome)| outcome.exit)))
}

/// The same for programs, without a terminal.
pub fn try_quietly(case: &Case, setting: &Setting) -> Outcome {
    try_case(&Console::plain(), case, setting)
}

fn try_case(console: &Console, case: &Case, setting: &Setting) -> Outcome {
    let sources = Sources::default();
    let mut outcome = Outcome {
        exit: Exit::Fine,
        comparison: None,
        text: String::new(),
        messages: String::new(),
        expected: None,
        drawn: None,
        encoding: Encoding::new(Format::Png),
    };
    if let Err(failure) = attempt(console, &sources, case, setting, &mut outcome) {
        let (exit, messages) = console.text_of(&sources, failure);
        outcome.exit = exit;
        outcome.messages += &messages;
        outcome.text = "could not be drawn".into();
    }
    outcome
}

fn attempt(console: &Console, sources: &Sources, case: &Case, setting: &Setting, outcome: &mut Outcome) -> Result<()> {
    let start = Instant::now();
    let file = session::open(sources, &case.scene)?;
    let mut header = match Header::try_parse_from(snapshot::header(sources.text(file)).unwrap_or("").split_whitespace())
    {
        Ok(header) => header,
        Err(error) => return Err(Failure::Usage(Box::new(error))),
    };
    let expected = if case.picture.is_file() { Some(image_io::decode_file(&Disk, &case.picture)?) } else { None };
    header.scene.include.extend(setting.include.iter().cloned());
    header.scene.size = header.scene.size.or(expected.as_ref().map(|p| Size { width: p.width, height: p.height }));
    header.look.alpha |= expected.as_ref().is_some_and(|p| p.channels % 2 == 0);
    outcome.encoding.alpha = header.look.alpha;
    let kept = size_of::<[f32; 4]>();
    memory::check_drawing(header.scene.size(), None, kept, header.scene.max_memory.map(|b| b.0))?;

    let timing = session::timing(&header.scene)?;
    let options = session::reading_options(&header.scene, &case.scene, timing);
    let built = crate::build(sources, file, &options, &mut |_| {});
    outcome.messages = console.text(sources, &built.diagnostics);
    let (exit, Some(world)) = (session::verdict(built.limit_reached, &built.diagnostics), built.world) else {
        return Err(Failure::Told(Exit::Scene));
    };
    if exit != Exit::Fine {
        return Err(Failure::Told(exit));
    }
    let drawing = session::drawing_options(&header.scene, &header.look, setting.threads, timing);
    let _orderly = Orderly::begin();
    let frame = Watcher::new(Progress::Silent, start, header.scene.max_time).render(&world, &drawing)?;
    compare(if header.look.alpha { frame } else { frame.over_black() }, expected.as_ref(), outcome);
    Ok(())
}

fn compare(drawn: Frame, expected: Option<&Pixels>, outcome: &mut Outcome) {
    if let Some(expected) = expected.map(Pixels::to_frame) {
        let comparison = snapshot::compare(&expected, &drawn, Tolerance::default());
        if comparison.verdict == Verdict::Differs {
            outcome.exit = Exit::Snapshot;
        }
        if comparison.verdict != Verdict::Identical {
            outcome.text = comparison.to_string();
        }
        outcome.comparison = Some(comparison);
        outcome.expected = Some(expected);
    } else {
        outcome.exit = Exit::Snapshot;
        outcome.text = "has no snapshot; --accept makes one".into();
    }
    outcome.drawn = Some(drawn);
}

/// What was drawn becomes the snapshot, unless it is the same already.
fn accept(case: &Case, outcome: &mut Outcome) -> Result<()> {
    let Some(drawn) =
        outcome.drawn.as_ref().filter(|_| outcome.comparison.is_none_or(|c| c.verdict != Verdict::Identical))
    else {
        return Ok(());
    };
    let _orderly = Orderly::begin();
    let bytes = image_io::encode(drawn, &outcome.encoding)?;
    Disk.write(&case.picture, &bytes).map_err(|e| Box::new(file::unwritable(&Disk, &case.picture, &e)))?;
    outcome.text = format!("accepted: {}", outcome.comparison.map_or("new".into(), |c| c.to_string()));
    outcome.exit = Exit::Fine;
    Ok(())
}

fn word(outcome: &Outcome) -> Word {
    match (outcome.exit, &outcome.drawn, outcome.comparison) {
        (Exit::Snapshot, Some(_), None) => Word::New,
        (exit, ..) => Word::of(exit),
    }
}

/// The command that takes what was drawn as the snapshot, where there is something to take.
fn acceptance(args: &TestArgs, case: &Case, outcome: &Outcome) -> Option<String> {
    let differs = outcome.exit == Exit::Snapshot && outcome.drawn.is_some();
    let folders = args.include.iter().flat_map(|folder| ["-I".to_string(), quoted(folder)]);
    let command = ["durer test --accept".to_string()].into_iter().chain(folders).chain([quoted(&case.scene)]);
    differs.then(|| command.collect::<Vec<_>>().join(" "))
}

/// A path as a shell takes it.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    let plain = |c: char| c.is_alphanumeric() || "-_./\\:~+@,".contains(c);
    if !text.is_empty() && text.chars().all(plain) { text } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

fn line(case: &Case, outcome: &Outcome, accept: Option<&str>) -> String {
    let accept = accept.map_or(String::new(), |command| format!("      if it is as it should be: {command}\n"));
    summary::line(word(outcome), case.scene.display(), &outcome.text) + &accept
}

/// One scene for programs; numbers are null where there is nothing to compare.
fn as_json(case: &Case, outcome: &Outcome, accept: Option<&str>) -> serde_json::Value {
    let numbers = outcome.comparison;
    json!({
        "scene": case.scene.display().to_string(),
        "snapshot": case.picture.display().to_string(),
        "result": word(outcome).text().to_lowercase(),
        "exit": outcome.exit as u8,
        "text": outcome.text,
        "messages": outcome.messages,
        "pixels": numbers.map(|n| n.pixels),
        "different": numbers.map(|n| n.different),
        "beyond": numbers.map(|n| n.beyond),
        "largest": numbers.map(|n| n.largest),
        "accept": accept,
    })
}

/// Returns the page.
fn write_report(args: &TestArgs, folder: &Path, outcomes: &[(Case, Outcome)]) -> Result<PathBuf> {
    let entries: Vec<_> = outcomes.iter().map(|(case, outcome)| entry(args, case, outcome)).collect();
    std::fs::create_dir_all(folder).map_err(|e| Box::new(file::unwritable(&Disk, folder, &e)))?;
    for (name, bytes) in snapshot::report(&entries)? {
        let path = folder.join(name);
        Disk.write(&path, &bytes).map_err(|e| Box::new(file::unwritable(&Disk, &path, &e)))?;
    }
    Ok(folder.join("index.html"))
}

fn entry<'o>(args: &TestArgs, case: &Case, outcome: &'o Outcome) -> Entry<'o> {
    Entry {
        name: case.scene.display().to_string(),
        fine: outcome.exit == Exit::Fine,
        snapshot: case.picture.display().to_string(),
        text: format!("{}\n{}", outcome.text, outcome.messages).trim().to_string(),
        accept: acceptance(args, case, outcome),
        expected: outcome.expected.as_ref(),
        drawn: outcome.drawn.as_ref(),
    }
}
