//! The built-in include files declare the names that the manual lists, and give POV-Ray's values.
//!
//! The sections of `tests/library/*.scene` have the form of `tests/cases/lang.rs`; numbers may differ by rounding. A
//! section with `//~` is a known difference, with durer's values. A section with `//?` needs a missing feature of
//! durer, and must be unmarked as soon as it passes.
//!
//! The scenes of `tests/library/pictures` are rendered with the built-in files, and compared with POV-Ray's pictures.

use crate::Group;
use durer::color::{Rgb, transfer::srgb_encode_rgb};
use durer::image_io::{Frame, decode_picture_file};
use durer::interpreter::{Options, interpret};
use durer::render::{self, Unwatched};
use durer::source::{Sandbox, SearchPath, Sources};
use libtest_mimic::{Failed, Trial};
use std::path::{Path, PathBuf};

/// Size of the pictures, in pixels.
const SIZE: (usize, usize) = (48, 36);

/// Maximum mean difference of the channels, in numbers of the file from 0 to 1.
const MEAN: f64 = 0.002;

/// Maximum fraction of pixels that differ by more than `FAR`: edges, by rounding.
const MOST: f64 = 0.01;
const FAR: f64 = 0.01;

pub fn group() -> Group {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library");
    let mut trials = vec![Trial::test("library::common_files_are_read_in_300_ms", quick)];
    for (file, names) in declared_names(&folder) {
        trials.push(Trial::test(format!("library::names::{file}"), move || every_name_is_there(&file, &names)));
    }
    for name in ["values", "objects"] {
        let text = std::fs::read_to_string(folder.join(name).with_extension("scene")).unwrap_or_default();
        let mut sections = text.split("//--- ");
        let preamble = sections.next().unwrap_or_default().to_string();
        for section in sections {
            let title = section.lines().next().unwrap_or_default();
            let (preamble, section) = (preamble.clone(), section.to_string());
            trials.push(Trial::test(format!("library::{name}::{title}"), move || compare(&preamble, &section)));
        }
    }
    for path in pictures(&folder.join("pictures")) {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        trials.push(Trial::test(format!("library::pictures::{name}"), move || looks_alike(&path)));
    }
    Group { tests: trials, at_least: 240 }
}

/// Options as on a machine without POV-Ray.
fn options() -> Options {
    Options {
        // Files that a scene has written are in the current folder.
        search: SearchPath { folders: vec![".".into()], fonts: vec![] },
        sandbox: Sandbox::with_writes_in_memory(),
        size: SIZE,
        ..Options::default()
    }
}

/// A scene's output and messages, on a machine without POV-Ray.
fn run(text: &str) -> (String, Vec<String>) {
    let options = options();
    let mut printed = String::new();
    let told = durer::on_big_stack(|| {
        let sources = Sources::default();
        let Some(file) = sources.add("scene", None, text.to_string()) else { return vec![] };
        let outcome = interpret(&sources, file, &options, &mut |text| printed.push_str(text));
        let message = |d: &durer::diagnostic::Diagnostic| match sources.place(d.span()) {
            Some(place) => format!("{}:{}: {} {}", place.file, place.line, d.code, d.message),
            None => format!("{} {}", d.code, d.message),
        };
        outcome.diagnostics.iter().map(message).filter(|m| !m.starts_with("W0206")).collect()
    });
    (printed, told)
}

/// Compares a section's output with its `//=` comments.
fn compare(preamble: &str, section: &str) -> Result<(), Failed> {
    let (printed, told) = run(&format!("{preamble}// {section}"));
    let wanted =
        section.lines().filter_map(|line| line.split_once("//=").map(|(code, text)| (code.trim(), text.trim())));
    let mut wrong: Vec<String> = told;
    let mut lines = printed.lines();
    for (code, text) in wanted {
        match lines.next() {
            Some(found) if agree(text, found) => {}
            found => wrong.push(format!("{code}\n    POV-Ray {text}\n    durer   {}", found.unwrap_or("nothing"))),
        }
    }
    wrong.extend(lines.map(|line| format!("more is printed: {line}")));
    match (wrong.is_empty(), section.contains("//?")) {
        (true, true) => Err("it gives what POV-Ray gives: take the mark `//?` off".into()),
        (false, false) => Err(wrong.join("\n").into()),
        _ => Ok(()),
    }
}

/// True for equal words, and numbers that are equal except for rounding.
fn agree(wanted: &str, found: &str) -> bool {
    let words = |text: &str| text.split([',', ' ', '<', '>']).map(str::to_string).collect::<Vec<_>>();
    let (wanted, found) = (words(wanted), words(found));
    wanted.len() == found.len()
        && wanted.iter().zip(&found).all(|(a, b)| match (a.parse::<f64>(), b.parse::<f64>()) {
            (Ok(a), Ok(b)) => (a - b).abs() <= 2e-6 * a.abs().max(1.0),
            _ => a == b,
        })
}

/// The table of names.txt: each file, and its names.
fn declared_names(folder: &Path) -> Vec<(String, Vec<String>)> {
    let text = std::fs::read_to_string(folder.join("names.txt")).unwrap_or_default();
    let mut files: Vec<(String, Vec<String>)> = vec![];
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        match files.last_mut() {
            Some((_, names)) if line.starts_with(' ') => names.extend(line.split_whitespace().map(str::to_string)),
            _ => files.push((line.to_string(), vec![])),
        }
    }
    files
}

fn every_name_is_there(file: &str, names: &[String]) -> Result<(), Failed> {
    let file = file.split(' ').next().unwrap_or_default();
    let tests: String = names.iter().map(|n| format!("#ifndef ({n}) #debug \"{n}\\n\" #end\n")).collect();
    let (printed, told) = run(&format!("#version 3.7;\n#include \"{file}\"\n{tests}"));
    if !names.is_empty() && printed.is_empty() && told.is_empty() {
        return Ok(());
    }
    Err(format!("{} names; not declared:\n{printed}messages: {told:#?}", names.len()).into())
}

/// colors.inc, shapes.inc and functions.inc are read in about 5 ms; the bound allows slow machines and unoptimised
/// builds.
fn quick() -> Result<(), Failed> {
    let start = std::time::Instant::now();
    let (_, told) =
        run("#version 3.7;\n#include \"colors.inc\"\n#include \"shapes.inc\"\n#include \"functions.inc\"\n");
    let took = start.elapsed().as_millis();
    if took < 300 && told.is_empty() { Ok(()) } else { Err(format!("{took} ms, {told:?}").into()) }
}

fn pictures(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut scenes: Vec<_> = entries.filter(|path| path.extension().is_some_and(|e| e == "pov")).collect();
    scenes.sort();
    scenes
}

/// Compares a scene with POV-Ray's picture of it.
fn looks_alike(path: &Path) -> Result<(), Failed> {
    let found = durer::on_big_stack(|| draw(path))?;
    let wanted = decode_picture_file(&durer::source::Disk, &path.with_extension("png"))
        .map_err(|e| e.message.clone())?
        .to_linear_image();
    if (wanted.width, wanted.height) != SIZE {
        return Err(format!("POV-Ray's picture is {} by {}", wanted.width, wanted.height).into());
    }
    let numbers = |frame: &Frame, i: usize| {
        let [r, g, b, _] = frame.pixels[i].map(|c| f64::from(c).clamp(0.0, 1.0));
        srgb_encode_rgb(Rgb::new(r, g, b))
    };
    let count = SIZE.0 * SIZE.1;
    let differences = (0..count).map(|i| (numbers(&found, i) - numbers(&wanted, i)).abs());
    let (mean, far) = differences.fold((0.0, 0.0), |(mean, far), d| {
        let one = 1.0 / count as f64;
        (mean + d.element_sum() / 3.0 * one, if d.max_element() > FAR { far + one } else { far })
    });
    println!("{}: mean difference {mean:.5}, {:.2} % of the pixels differ", path.display(), 100.0 * far);
    if mean <= MEAN && far <= MOST {
        return Ok(());
    }
    Err(format!("mean difference {mean:.5}, {:.2} % of the pixels differ", 100.0 * far).into())
}

fn draw(path: &Path) -> Result<Frame, Failed> {
    let sources = Sources::default();
    let file = durer::load(&sources, path).map_err(|e| e.message.clone())?;
    let built = durer::build(&sources, file, &options(), &mut |_| {});
    let told: Vec<_> = built.diagnostics.iter().map(|d| format!("{} {}", d.code, d.message)).collect();
    let world = built.world.filter(|_| told.is_empty()).ok_or(told.join("\n"))?;
    let (width, height) = SIZE;
    let options = render::Options::new(width, height);
    render::render(&world, &options, &Unwatched).map(|(frame, _)| frame).map_err(|_| "cancelled".into())
}
