//! What the language says: each section of each `tests/lang/NAME.scene` is run, and what it prints and which errors
//! it meets are compared with the comments in it.
//!
//! ```text
//! //--- title           begins a section; what stands before the first one belongs to all of them
//! Num(1+1) //= 2.000000     the next line that is printed
//! Num(A) //! E0203 at 5     a message with this code, in this line at column 5; `at 7:5`, `at say.inc:3:31` elsewhere
//! //~ reason            POV-Ray is not asked about this section, because it is known to differ
//! ```
//!
//! `tests/lang/regenerate.py` asks the real POV-Ray for the printed lines.
//!
//! Each section runs twice: as it is written, and taken apart into single tokens, which has to come to the same.

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

/// Lines, each with its end, which may be LF, CR or both.
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
    /// Runs a section together with what stands before the first one.
    fn run(&self, preamble: usize, section: std::ops::Range<usize>, granularity: Granularity) -> Result<(), Failed> {
        let kept = |i: usize| i < preamble || section.contains(&i);
        // The other lines are blank, so that places stay.
        let text: String = self
            .lines
            .iter()
            .enumerate()
            .map(|(i, (line, end))| if kept(i) { line.clone() + end } else { end.clone() })
            .collect();
        // Both ways of a section write the same files.
        static WRITING: Mutex<()> = Mutex::new(());
        let _alone = text.contains("#fopen").then(|| WRITING.lock());
        let Ran { printed, told, scene } = run(&self.path, &self.name, text.clone(), granularity);
        let mut expected_lines = vec![];
        let mut expected_faults = vec![];
        for i in section {
            let (line, _) = &self.lines[i];
            expected_lines
                .extend(line.split_once("//=").map(|(_, text)| text.strip_prefix(' ').unwrap_or(text).to_string()));
            let fault = line.split_once("//!").map(|(_, text)| text.trim());
            expected_faults.extend(fault.into_iter().flat_map(|t| t.split(';')).map(|fault| whole_place(fault, i + 1)));
        }
        let printed: Vec<&str> = printed.lines().collect();
        let mut wrong = vec![];
        if printed != expected_lines {
            wrong.push(format!("expected to print {expected_lines:#?}\nprinted {printed:#?}"));
        }
        if told != expected_faults {
            wrong.push(format!("expected messages {expected_faults:#?}\nfound {told:#?}"));
        }
        if granularity == Granularity::Tokens && scene != run(&self.path, &self.name, text, Granularity::Whole).scene {
            wrong.push("the Scene is another one than that of what stands whole".into());
        }
        if wrong.is_empty() { Ok(()) } else { Err(wrong.join("\n").into()) }
    }
}

/// `E0203 at 5` as `E0203 at LINE:5`.
fn whole_place(fault: &str, line: usize) -> String {
    match fault.trim().split_once(" at ") {
        Some((code, place)) if !place.contains(':') => format!("{code} at {line}:{place}"),
        _ => fault.trim().to_string(),
    }
}

/// What came of a text.
struct Ran {
    printed: String,
    /// Messages in the form of the comments.
    told: Vec<String>,
    /// As JSON, where there is one.
    scene: Option<String>,
}

fn run(path: &Path, name: &str, text: String, granularity: Granularity) -> Ran {
    let folder = path.parent().unwrap_or(Path::new("."));
    let options = Options {
        sandbox: Sandbox::around(&SearchPath::new(folder, &[])),
        search: SearchPath::new(folder, &[]),
        granularity,
        ..Options::default()
    };
    let mut printed = String::new();
    let (told, scene) = durer::on_big_stack(|| {
        let sources = Sources::default();
        let Some(file) = sources.add(name, Some(path), text) else { return Default::default() };
        let outcome = durer::interpreter::interpret(&sources, file, &options, &mut |text| printed.push_str(text));
        let message = |d: &durer::diagnostic::Diagnostic| match sources.place(d.span()) {
            Some(place) if place.file == name => format!("{} at {}:{}", d.code, place.line, place.column),
            Some(place) => format!("{} at {}:{}:{}", d.code, place.file, place.line, place.column),
            None => d.code.to_string(),
        };
        // The sections draw nothing, so they have no camera.
        let told = outcome.diagnostics.iter().map(message).filter(|m| m != "W0206").collect();
        (told, outcome.scene.and_then(|scene| serde_json::to_string(&scene).ok()))
    });
    Ran { printed, told, scene }
}
