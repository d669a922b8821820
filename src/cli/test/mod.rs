//! The command `durer test [PATH…]`: renders each scene that has a snapshot, and compares the pictures.

mod hashes;

use super::args::values::Size;
use super::args::{LookArgs, MessageFormat, SceneArgs, TestArgs};
use super::console::Console;
use super::exit::{Exit, Failure, Result, usage_error};
use super::interrupt::{self, Deadline, DeferredSignals, Overrun};
use super::memory;
use super::session;
use super::summary::{self, ResultWord};
use crate::BuildOptions;
use crate::cli::render::monitor::Monitor;
use crate::cli::render::progress::Progress;
use crate::diagnostic::file;
use crate::image_io::{self, Encoding, Format, Frame, Pixels};
use crate::math::cancel::CancelToken;
use crate::snapshot::{self, Case, Comparison, Entry, Tolerance, Verdict};
use crate::source::{Disk, Files, Sources};
use clap::Parser;
use hashes::{HashResult, Hashes};
use serde_json::json;
use std::path::{Path, PathBuf};

/// Options of a scene's snapshot, from the comment `//! test: --size 128x96 --aa off`.
#[derive(Parser, Debug)]
#[command(no_binary_name = true, disable_help_flag = true)]
struct Header {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    look: LookArgs,
}

/// Options that apply to all tested scenes.
#[derive(Clone, Debug, Default)]
pub struct Setting {
    /// Folders of the test's include path, from the option `-I`.
    pub include: Vec<PathBuf>,
    /// Number of threads; 0 for one per processor.
    pub threads: usize,
}

/// Result of testing one scene against its snapshot.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Exit code of the test of this scene alone.
    pub exit: Exit,
    /// Difference of the scene's picture from its snapshot; `None` unless both exist.
    pub comparison: Option<Comparison>,
    /// Description of the test's result in one line.
    pub text: String,
    /// Errors and warnings of the scene, as text for a person.
    pub messages: String,
    /// Expected picture, with which the rendered picture is compared; `None` without a snapshot or a rendered picture.
    pub expected: Option<Frame>,
    /// Picture that the test rendered of the scene; `None` if the scene could not be rendered.
    pub rendered: Option<Frame>,
    /// Encoding of the snapshot's picture file.
    encoding: Encoding,
}

/// Renders and compares all scenes, prints the results, and writes accepted snapshots.
///
/// # Errors
/// Missing paths, and a report that cannot be written. The result of a scene is no error.
pub fn run(console: &Console, args: &TestArgs) -> Result {
    let here = vec![PathBuf::from(".")];
    let paths = if args.paths.is_empty() { &here } else { &args.paths };
    for path in paths.iter().filter(|path| !path.is_dir()) {
        session::check_input(path)?;
        if super::povray::is_ini(&path.to_string_lossy()) {
            return usage_error(format!("snapshots belong to scenes: name the scene, not `{}`", path.display()));
        }
    }
    let cases = snapshot::find(&Disk, paths).map_err(|e| Box::new(file::unreadable(&Disk, &paths[0], &e.into())))?;
    if cases.is_empty() {
        return usage_error("no scene here has a snapshot; `durer test --accept NAME.scene` makes the first one");
    }
    let setting = Setting { include: args.include.clone(), threads: args.threads.map_or(0, usize::from) };
    let mut hashes = args.hashes.as_deref().map(|file| Hashes::read(file, args.accept)).transpose()?;
    let mut outcomes = Vec::new();
    for case in cases {
        let mut outcome = try_case(console, &case, &setting);
        if args.accept {
            accept(&case, &mut outcome)?;
        }
        if let Some(hashes) = &mut hashes {
            record_hash_comparison(hashes, &case, args.accept, &mut outcome);
        }
        let accept = accept_command(args, &case, &outcome);
        match args.format {
            MessageFormat::Human => {
                console.info(&outcome.messages);
                console.write_to_stdout(result_lines(&case, &outcome, accept.as_deref()))?;
            }
            MessageFormat::Json => console.write_json_to_stdout(&as_json(&case, &outcome, accept.as_deref()))?,
        }
        outcomes.push((case, outcome));
        if let Some(signal) = interrupt::received_end_signal() {
            return Err(Failure::Reported(signal.exit));
        }
    }
    if let Some(hashes) = hashes.filter(|_| args.accept) {
        hashes.write()?;
    }
    if let Some(folder) = &args.report {
        let page = write_report(args, folder, &outcomes)?;
        console.info(&format!("{} shows the pictures side by side\n", page.display()));
    }
    if args.format == MessageFormat::Human {
        let words: Vec<_> = outcomes.iter().map(|(_, outcome)| result_word(outcome)).collect();
        console.write_to_stdout(summary::total_line(&words, console.take_message_count()))?;
    }
    Ok(summary::combined_exit_code(outcomes.iter().map(|(_, outcome)| outcome.exit)))
}

/// Tests one scene without printing anything.
pub fn try_quietly(case: &Case, setting: &Setting) -> Outcome {
    try_case(&Console::before_arguments(), case, setting)
}

fn try_case(console: &Console, case: &Case, setting: &Setting) -> Outcome {
    let sources = Sources::default();
    let mut outcome = Outcome {
        exit: Exit::Fine,
        comparison: None,
        text: String::new(),
        messages: String::new(),
        expected: None,
        rendered: None,
        encoding: Encoding::new(Format::Png),
    };
    if let Err(failure) = render_and_compare(console, &sources, case, setting, &mut outcome) {
        let (exit, messages) = console.exit_and_text_of(&sources, failure);
        outcome.exit = exit;
        outcome.messages += &messages;
        outcome.text = "could not be rendered".into();
    }
    outcome
}

fn render_and_compare(
    console: &Console,
    sources: &Sources,
    case: &Case,
    setting: &Setting,
    outcome: &mut Outcome,
) -> Result<()> {
    let file = session::open(sources, &case.scene)?;
    let mut header =
        match Header::try_parse_from(snapshot::test_options(sources.text(file)).unwrap_or("").split_whitespace()) {
            Ok(header) => header,
            Err(error) => return Err(Failure::Usage(Box::new(error))),
        };
    let expected =
        if case.picture.is_file() { Some(image_io::decode_picture_file(&Disk, &case.picture)?) } else { None };
    header.scene.include.extend(setting.include.iter().cloned());
    header.scene.size = header.scene.size.or(expected.as_ref().map(|p| Size { width: p.width, height: p.height }));
    header.look.alpha |= expected.as_ref().is_some_and(|p| p.channels % 2 == 0);
    outcome.encoding.alpha = header.look.alpha;
    let bytes_per_pixel = size_of::<[f32; 4]>();
    memory::check_memory(header.scene.size(), None, bytes_per_pixel, header.scene.max_memory.map(|b| b.0))?;

    let timing = session::timing(&header.scene, None)?;
    session::enforce_memory_limit(header.scene.memory_limit_if_set());
    let deadline = Deadline::start(header.scene.time_limit(), CancelToken::default(), Overrun::EndsProcess);
    let options = session::reading_options(&header.scene, &case.scene, timing);
    let options = BuildOptions { cancel: deadline.token().clone(), ..options };
    let built = crate::build(sources, file, &options, &mut |_| {});
    outcome.messages = console.format_and_count(sources, &built.diagnostics);
    let (exit, Some(world)) = (session::exit_code_of_run(built.limit_reached, &built.diagnostics), built.world) else {
        return Err(Failure::Reported(Exit::Scene));
    };
    if exit != Exit::Fine {
        return Err(Failure::Reported(exit));
    }
    let drawing = session::drawing_options(&header.scene, &header.look, setting.threads, timing);
    let _deferred = DeferredSignals::begin();
    let frame = Monitor::new(Progress::Silent, deadline.token().clone()).render(&world, &drawing)?;
    record_comparison(if header.look.alpha { frame } else { frame.over_black() }, expected.as_ref(), outcome);
    Ok(())
}

fn record_comparison(rendered: Frame, expected: Option<&Pixels>, outcome: &mut Outcome) {
    if let Some(expected) = expected.map(Pixels::to_linear_image) {
        let comparison = snapshot::compare(&expected, &rendered, Tolerance::default());
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
    outcome.rendered = Some(rendered);
}

/// Compares the hash of the rendered picture's bits with the known hash, and adds the result to the outcome. With `accept`,
/// a different or missing hash is replaced.
fn record_hash_comparison(hashes: &mut Hashes, case: &Case, accept: bool, outcome: &mut Outcome) {
    let Some(rendered) = &outcome.rendered else { return };
    let text = match hashes.compare_and_update(&case.scene, rendered, accept) {
        HashResult::Same => return,
        HashResult::Differs if accept => "accepted: another hash",
        HashResult::Missing if accept => "accepted: a new hash",
        HashResult::Differs => "the pixels have other bits than their hash says",
        HashResult::Missing => "has no hash; --accept adds one",
    };
    let gap = if outcome.text.is_empty() { "" } else { "; " };
    outcome.text += &format!("{gap}{text}");
    if !accept {
        outcome.exit = Exit::Snapshot;
    }
}

/// Writes the rendered picture as the new snapshot, unless both are identical.
fn accept(case: &Case, outcome: &mut Outcome) -> Result<()> {
    let Some(rendered) =
        outcome.rendered.as_ref().filter(|_| outcome.comparison.is_none_or(|c| c.verdict != Verdict::Identical))
    else {
        return Ok(());
    };
    let _deferred = DeferredSignals::begin();
    let bytes = image_io::encode(rendered, &outcome.encoding)?;
    Disk.write(&case.picture, &bytes).map_err(|e| Box::new(file::unwritable(&Disk, &case.picture, &e)))?;
    outcome.text = format!("accepted: {}", outcome.comparison.map_or("new".into(), |c| c.to_string()));
    outcome.exit = Exit::Fine;
    Ok(())
}

fn result_word(outcome: &Outcome) -> ResultWord {
    match (outcome.exit, &outcome.rendered, outcome.comparison) {
        (Exit::Snapshot, Some(_), None) => ResultWord::New,
        (exit, ..) => ResultWord::of(exit),
    }
}

/// Returns the command that accepts the rendered picture as the snapshot; `None` if the test passed, or if no picture was
/// rendered.
fn accept_command(args: &TestArgs, case: &Case, outcome: &Outcome) -> Option<String> {
    let differs = outcome.exit == Exit::Snapshot && outcome.rendered.is_some();
    let folders = args.include.iter().flat_map(|folder| ["-I".to_string(), quoted(folder)]);
    let hashes = args.hashes.iter().flat_map(|file| ["--hashes".to_string(), quoted(file)]);
    let command =
        ["durer test --accept".to_string()].into_iter().chain(folders).chain(hashes).chain([quoted(&case.scene)]);
    differs.then(|| command.collect::<Vec<_>>().join(" "))
}

/// Quotes a path for a shell if necessary.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    let plain = |c: char| c.is_alphanumeric() || "-_./\\:~+@,".contains(c);
    if !text.is_empty() && text.chars().all(plain) { text } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

fn result_lines(case: &Case, outcome: &Outcome, accept: Option<&str>) -> String {
    let accept = accept.map_or(String::new(), |command| format!("      if the new picture is right: {command}\n"));
    summary::scene_line(result_word(outcome), case.scene.display(), &outcome.text) + &accept
}

/// Returns the result of one scene as JSON; the numbers are null without a comparison.
fn as_json(case: &Case, outcome: &Outcome, accept: Option<&str>) -> serde_json::Value {
    let numbers = outcome.comparison;
    json!({
        "scene": case.scene.display().to_string(),
        "snapshot": case.picture.display().to_string(),
        "result": result_word(outcome).text().to_lowercase(),
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

/// Writes the HTML page of `--report`, and returns its path.
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
        accept: accept_command(args, case, outcome),
        expected: outcome.expected.as_ref(),
        rendered: outcome.rendered.as_ref(),
    }
}
