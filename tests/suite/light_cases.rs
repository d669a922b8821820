//! Whole scenes compared with POV-Ray 3.7: every pixel of `tests/light_cases/*.pov`, as linear light, and povray's
//! picture of the same file (see the README there).

use durer::color::transfer::srgb_encode;
use durer::interpreter;
use durer::render::{Options, SampleLayout, Unwatched, render};
use durer::source::{Sandbox, SearchPath, Sources};
use serde::Deserialize;
use std::path::Path;

#[derive(Deserialize)]
struct Expected {
    x: usize,
    y: usize,
    rgb: [f64; 3],
}

/// Formats of povray's pictures.
#[derive(Deserialize)]
#[serde(untagged)]
enum Kept {
    Pixels(Vec<Expected>),
    /// Row by row, three numbers a pixel, in steps of 1/65535.
    Steps(Vec<u16>),
}

impl Kept {
    fn pixels(self) -> Vec<Expected> {
        let steps = match self {
            Kept::Pixels(pixels) => return pixels,
            Kept::Steps(steps) => steps,
        };
        assert_eq!(steps.len(), 3 * SIZE.0 * SIZE.1);
        let pixel = |(i, [r, g, b]): (usize, &[u16; 3])| Expected {
            x: i % SIZE.0,
            y: i / SIZE.0,
            rgb: [*r, *g, *b].map(|step| f64::from(step) / 65535.0),
        };
        steps.as_chunks().0.iter().enumerate().map(pixel).collect()
    }
}

/// The values are rounded to 1/65535, and stored with six digits.
const TOLERANCE: f64 = 1.0 / 65535.0;

/// Prefix of the cases with random samples, whose noise differs from POV-Ray's, and their tolerance.
const NOISY: (&str, f64) = ("subsurface_", 0.015);

const SIZE: (usize, usize) = (16, 12);

/// Cases that still differ, with the reason.
const DIFFERS: &[(&str, &str)] = &[
    ("blob_thin_components", "quirk: blob_thin_components"),
    ("coplanar_boxes", "quirk: coplanar_boxes"),
    ("far_away", "quirk: far_hits"),
    ("infinite_boxes_rotated", "quirk: rotated_infinite_box"),
    ("julia_transcendental", "quirk: hypercomplex_functions"),
    ("parametric_coarse", "quirk: parametric_accuracy"),
    ("sor_sturm_transparent", "quirk: sor_sturm"),
    ("subsurface_zero_channel", "quirk: subsurface_zero_channel"),
];

#[test]
fn all_cases() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/light_cases");
    let mut names: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.retain(|path| path.extension().is_some_and(|e| e == "pov"));
    names.sort();
    assert!(names.len() >= 50);
    let faults: Vec<String> = names.iter().filter_map(|path| durer::on_big_stack(|| compare(path))).collect();
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// The deviation of one case.
fn compare(path: &Path) -> Option<String> {
    let name = path.file_stem().unwrap().to_string_lossy().into_owned();
    let kept: Kept = serde_json::from_str(&std::fs::read_to_string(path.with_extension("json")).unwrap()).unwrap();
    let expected = kept.pixels();
    let frame = match draw(path, quality(&name)) {
        Ok(frame) => frame,
        Err(message) => return Some(format!("{name}: {message}")),
    };
    // Without gamma handling povray writes the numbers of the scene unchanged.
    let raw = name == "no_version";
    let differences = expected.iter().map(|e| {
        let found = frame.pixels[e.y * SIZE.0 + e.x].map(|c| f64::from(c).clamp(0.0, 1.0));
        let found = if raw { found.map(srgb_encode) } else { found };
        // (`max` ignores NaN, which must not pass.)
        let apart = |c: usize| if found[c].is_nan() { 1.0 } else { (found[c] - e.rgb[c]).abs() };
        let worst = (0..3).map(apart).fold(0.0, f64::max);
        (worst, e)
    });
    let (worst, e) = differences.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    let found = frame.pixels[e.y * SIZE.0 + e.x];
    let fine = worst <= if name.starts_with(NOISY.0) { NOISY.1 } else { TOLERANCE };
    match DIFFERS.iter().find(|(case, _)| *case == name) {
        Some(_) if fine => Some(format!("{name} is fine: take it off the list of those that differ")),
        None if !fine => Some(format!("{name}: off by {worst:.6} at {}, {}: {found:?} is not {:?}", e.x, e.y, e.rgb)),
        _ => None,
    }
}

/// `NAME_qN` is rendered with `--quality N`.
fn quality(name: &str) -> u8 {
    name.rsplit_once("_q").and_then(|(_, n)| n.parse().ok()).unwrap_or(9)
}

/// Adds the anti-aliasing of a case whose first line is `// options: +A0.3 +AM1 +R2`.
fn with_options_of_case(mut options: Options, text: &str) -> Options {
    let Some(words) = text.lines().next().and_then(|line| line.strip_prefix("// options: ")) else { return options };
    options.sampling.jitter = 0.0;
    for word in words.split(' ') {
        let number = |prefix| word.strip_prefix(prefix).and_then(|n: &str| n.parse::<f64>().ok());
        if word == "+AM1" {
            options.sampling.layout = SampleLayout::Grid;
        } else if word == "+AM2" {
            options.sampling.layout = SampleLayout::Corners;
        } else if let Some(depth) = number("+R") {
            options.sampling.depth = depth as u32;
        } else if let Some(threshold) = number("+A").or_else(|| number("Antialias_Threshold=")) {
            options.antialias = Some(threshold);
        } else {
            assert_eq!(word, "Antialias=on");
        }
    }
    options
}

fn draw(path: &Path, quality: u8) -> Result<durer::image_io::Frame, String> {
    let sources = Sources::default();
    let reading = interpreter::Options {
        search: SearchPath::new(path.parent().unwrap(), &[]),
        sandbox: Sandbox::with_writes_in_memory(),
        size: SIZE,
        ..interpreter::Options::default()
    };
    let file = durer::load(&sources, path).map_err(|e| e.message.clone())?;
    let built = durer::build(&sources, file, &reading, &mut |_| {});
    let messages: Vec<_> = built.diagnostics.iter().map(|d| d.message.clone()).collect();
    let world = built.world.ok_or_else(|| messages.join("; "))?;
    let (width, height) = SIZE;
    let options = with_options_of_case(Options { quality, ..Options::new(width, height) }, sources.text(file));
    render(&world, &options, &Unwatched).map(|(frame, _)| frame).map_err(|_| "cancelled".into())
}
