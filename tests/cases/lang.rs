//! The language's test files: runs each section of `tests/lang/NAME.scene`, and compares its output and its errors with
//! the comments in it.
//!
//! ```text
//! //--- title           begins a section; the preamble before the first section belongs to all
//! Num(1+1) //= 2.000000     the next line of the output
//! Num(A) //! E0203 at 5     an error at column 5 of this line; `at 7:5` or `at say.inc:3:31` elsewhere
//! //~ reason            not compared with POV-Ray, because durer differs on purpose
//! ```
//!
//! `tests/lang/regenerate.py` compares the expected output with that of POV-Ray.
//!
//! Each section runs twice, with parsed expressions and split into single tokens; both runs must give the same.

use crate::Group;
use durer::interpreter::Options;
use durer::source::{Sandbox, SearchPath, Sources, text_of};
use durer::syntax::Granularity;
use libtest_mimic::{Failed, Trial};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

pub fn group() -> Group {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/lang");
    let entries = std::fs::read_dir(&folder).into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> =
        entries.map(|e| e.path()).filter(|p| p.extension().is_some_and(|e| e == "scene")).collect();
    files.sort();
    Group { tests: files.iter().flat_map(|path| trials(path)).collect(), at_least: 1500 }
}

/// Two tests for each section of a file.
fn trials(path: &Path) -> Vec<Trial> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let bytes = std::fs::read(path).unwrap_or_default();
    let text = match text_of(bytes) {
        Ok(text) => text,
        Err(error) => return vec![Trial::test(name, move || Err(format!("{error:?}").into()))],
    };
    let file = Arc::new(TestFile { name: name.clone(), path: path.to_path_buf(), lines: lines(&text) });
    let starts: Vec<usize> = (0..file.lines.len()).filter(|&i| file.lines[i].0.starts_with("//---")).collect();
    let ends = starts.iter().skip(1).copied().chain([file.lines.len()]);
    let sections = starts.iter().copied().zip(ends);
    let trials = |(start, end): (usize, usize)| {
        let title = file.lines[start].0.trim_start_matches("//---").trim();
        let full = format!("lang::{name}::{title}");
        let preamble = starts[0];
        let trial = |name: String, granularity: Granularity| {
            let file = file.clone();
            Trial::test(name, move || file.run(preamble, start..end, granularity))
        };
        [trial(full.clone(), Granularity::Whole), trial(full + " (single tokens)", Granularity::Tokens)]
    };
    sections.flat_map(trials).collect()
}

/// Lines with their line ends, each of which is LF, CR or both.
fn lines(text: &str) -> Vec<(String, String)> {
    let mut out = vec![];
    let mut rest = text;
    while !rest.is_empty() {
        let end = rest.find(['\n', '\r']).unwrap_or(rest.len());
        let after = &rest[end..];
        let len = if after.starts_with("\r\n") { 2 } else { after.len().min(1) };
        out.push((rest[..end].to_string(), after[..len].to_string()));
        rest = &after[len..];
    }
    out
}

struct TestFile {
    name: String,
    path: PathBuf,
    lines: Vec<(String, String)>,
}

impl TestFile {
    /// Runs a section together with the file's preamble.
    fn run(&self, preamble: usize, section: std::ops::Range<usize>, granularity: Granularity) -> Result<(), Failed> {
        let kept = |i: usize| i < preamble || section.contains(&i);
        // All other lines are blank, so that spans keep their line numbers.
        let text: String = self
            .lines
            .iter()
            .enumerate()
            .map(|(i, (line, end))| if kept(i) { line.clone() + end } else { end.clone() })
            .collect();
        // Both runs of a section write the same files.
        static WRITING: Mutex<()> = Mutex::new(());
        let _alone = text.contains("#fopen").then(|| WRITING.lock());
        let Ran { printed, reported, scene } = run(&self.path, &self.name, text.clone(), granularity);
        let mut expected_lines = vec![];
        let mut expected_faults = vec![];
        for i in section {
            let (line, _) = &self.lines[i];
            expected_lines
                .extend(line.split_once("//=").map(|(_, text)| text.strip_prefix(' ').unwrap_or(text).to_string()));
            let fault = line.split_once("//!").map(|(_, text)| text.trim());
            expected_faults.extend(fault.into_iter().flat_map(|t| t.split(';')).map(|fault| with_line(fault, i + 1)));
        }
        let printed: Vec<&str> = printed.lines().collect();
        let mut wrong = vec![];
        if printed != expected_lines {
            wrong.push(format!("expected to print {expected_lines:#?}\nprinted {printed:#?}"));
        }
        if reported != expected_faults {
            wrong.push(format!("expected messages {expected_faults:#?}\nfound {reported:#?}"));
        }
        if granularity == Granularity::Tokens && scene != run(&self.path, &self.name, text, Granularity::Whole).scene {
            wrong.push("the Scene is another one than that of what stands whole".into());
        }
        if wrong.is_empty() { Ok(()) } else { Err(wrong.join("\n").into()) }
    }
}

/// Completes `E0203 at 5` to `E0203 at LINE:5`.
fn with_line(fault: &str, line: usize) -> String {
    match fault.trim().split_once(" at ") {
        Some((code, place)) if !place.contains(':') => format!("{code} at {line}:{place}"),
        _ => fault.trim().to_string(),
    }
}

/// Result of a run.
struct Ran {
    printed: String,
    /// Messages in the form of the comments.
    reported: Vec<String>,
    /// The scene as JSON; `None` after errors.
    scene: Option<String>,
}

fn run(path: &Path, name: &str, text: String, granularity: Granularity) -> Ran {
    let folder = path.parent().unwrap_or(Path::new("."));
    let options = Options {
        sandbox: Sandbox::with_writes_in_memory(),
        search: SearchPath::new(folder, &[]),
        granularity,
        ..Options::default()
    };
    let mut printed = String::new();
    let (reported, scene) = durer::on_big_stack(|| {
        let sources = Sources::default();
        let Some(file) = sources.add(name, Some(path), text) else { return Default::default() };
        let outcome = durer::interpreter::interpret(&sources, file, &options, &mut |text| printed.push_str(text));
        let message = |d: &durer::diagnostic::Diagnostic| match sources.place(d.span()) {
            Some(place) if place.file == name => format!("{} at {}:{}", d.code, place.line, place.column),
            Some(place) => format!("{} at {}:{}:{}", d.code, place.file, place.line, place.column),
            None => d.code.to_string(),
        };
        // The sections have no camera, because they render nothing.
        let reported = outcome.diagnostics.iter().map(message).filter(|m| m != "W0206").collect();
        (reported, outcome.scene.and_then(|scene| serde_json::to_string(&scene).ok()))
    });
    Ran { printed, reported, scene }
}
