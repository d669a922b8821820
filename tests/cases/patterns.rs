//! Patterns compared with POV-Ray's output: the tables of `tests/patterns/`, which `regenerate.py` there writes.

use crate::Group;
use durer::interpreter::{Options, interpret};
use durer::render::{self, Unwatched, render};
use durer::source::{Sandbox, SearchPath, Sources};
use libtest_mimic::{Failed, Trial};
use std::path::{Path, PathBuf};

/// Tolerances, relative to the larger of the number and 1: for doubles, and for colours in single precision.
const TOLERANCE: f64 = 1e-9;
const TOLERANCE_SINGLE: f64 = 1e-6;
/// Size of the pictures of `regenerate.py`.
const SIZE: (usize, usize) = (40, 30);
const STAGE: &str = "camera { location <0, 0, -6> look_at 0 angle 50 } light_source { <-4, 6, -9>, 1 }";

pub fn group() -> Group {
    let tables = std::env::var("DURER_PATTERNS").map_or_else(|_| folder(), Into::into);
    // `DURER_PATTERNS` names another folder with (larger) tables.
    let mut trials = vec![];
    for name in sections() {
        let text = std::fs::read_to_string(tables.join(format!("{name}.txt"))).unwrap_or_default();
        for table in text.split("# ").skip(1) {
            let (setting, rows) = table.split_once('\n').unwrap_or((table, ""));
            let (title, setting, rows) =
                (format!("patterns::{name}::{setting}"), setting.to_string(), rows.to_string());
            trials.push(Trial::test(title, move || compare(&setting, &rows)));
        }
        let settings: Vec<String> = settings(&text).map(str::to_string).collect();
        trials.push(Trial::test(format!("patterns::{name}::points"), move || enough(&text)));
        trials.push(Trial::test(format!("patterns::{name}::extremes"), move || {
            settings.iter().try_for_each(|s| extremes(s))
        }));
    }
    Group { tests: trials, at_least: 360 }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/patterns")
}

/// The names of the tables.
fn sections() -> impl Iterator<Item = &'static str> {
    include_str!("../patterns/settings.txt").lines().filter_map(|line| line.strip_prefix("== "))
}

/// A table has 1000 points or more, and a setting 60.
fn enough(text: &str) -> Result<(), Failed> {
    let counts: Vec<usize> = text.split("# ").skip(1).map(|table| table.lines().count() - 1).collect();
    if counts.iter().sum::<usize>() < 1000 || counts.iter().any(|&n| n < 60) {
        return Err(format!("too few: {counts:?}; see regenerate.py").into());
    }
    Ok(())
}

/// The settings of a table.
fn settings(text: &str) -> impl Iterator<Item = &str> {
    text.split("# ").skip(1).filter_map(|table| table.lines().next())
}

/// Extreme points may give any number, but must not end the program. Pictures never use them.
fn extremes(setting: &str) -> Result<(), Failed> {
    if setting.starts_with("picture ") {
        return Ok(());
    }
    let values = "0, -0.0, 0.5, 5e-324, -1e-310, -1e3, 1e9, -1e9, 1e15, -1e18, 1e300, -1e300, Inf, -Inf, Inf - Inf";
    let asked = format!(
        "#declare Inf = 1e300*1e300; #declare V = array[15] {{ {values} }}\n\
         #for (I, 0, 14) #for (J, 0, 14) #for (K, 0, 14) #declare R = F(V[I], V[J], V[K]); #end #end #end\n\
         #debug \"1\""
    );
    let (settings, function, _) = function(setting);
    let printed = run(&format!("{}{asked}", declared(settings, &function)))?;
    if printed == [1.0] { Ok(()) } else { Err("it did not come to its end".into()) }
}

/// Compares a setting with its table: lines `x y z value`, or `column row value` for a picture.
fn compare(setting: &str, rows: &str) -> Result<(), Failed> {
    let rows: Vec<Vec<f64>> = rows.lines().map(|l| l.split(' ').filter_map(|w| w.parse().ok()).collect()).collect();
    let (ours, tolerance) = match setting.strip_prefix("picture ") {
        Some(object) => (draw(object, &rows)?, 1.01),
        None => {
            let (settings, function, part) = function(setting);
            let colors =
                ["pigment ", "image_pattern ", "pigment_pattern "].iter().any(|word| setting.starts_with(word));
            let tolerance = if colors { TOLERANCE_SINGLE } else { TOLERANCE };
            (run(&scene(settings, &function, part, &rows))?, tolerance)
        }
    };
    let mut wrong = vec![];
    let mut worst: f64 = 0.0;
    let mut ours = ours.into_iter();
    for row in &rows {
        let Some((theirs, place)) = row.split_last() else { continue };
        let ours = ours.next().unwrap_or(f64::NAN);
        let error = (ours - theirs).abs() / theirs.abs().max(1.0);
        let error = if setting.starts_with("picture ") { (ours - theirs).abs() } else { error };
        worst = worst.max(if error.is_nan() { f64::INFINITY } else { error });
        if error.is_nan() || error > tolerance {
            wrong.push(format!("at {place:?} {ours}, POV-Ray has {theirs}"));
        }
    }
    let shown: Vec<String> = wrong.iter().take(8).cloned().collect();
    let summary = format!("{} of {} differ, at most by {worst:.1e}\n{}", wrong.len(), rows.len(), shown.join("\n"));
    if wrong.is_empty() && !rows.is_empty() { Ok(()) } else { Err(summary.into()) }
}

/// Global settings, the body of a function, and the component of its result.
fn function(setting: &str) -> (&str, String, &'static str) {
    if let Some(pigment) = setting.strip_prefix("pigment ") {
        return ("", format!("pigment {{ {pigment} }}"), ".red");
    }
    let (settings, pattern) = setting.rsplit_once('|').unwrap_or(("", setting));
    (settings, format!("pattern {{ {pattern} }}"), "")
}

/// The declaration of the function F.
fn declared(settings: &str, function: &str) -> String {
    format!("#version 3.7;\nglobal_settings {{ assumed_gamma 1 {settings} }}\n#declare F = function {{ {function} }}\n")
}

/// A scene that prints a component of a function's values at all points.
fn scene(settings: &str, function: &str, part: &str, rows: &[Vec<f64>]) -> String {
    let call = |row: &Vec<f64>| {
        format!("#debug concat(str(F({:?}, {:?}, {:?}){part}, 0, 17), \"\\n\")\n", row[0], row[1], row[2])
    };
    declared(settings, function) + &rows.iter().map(call).collect::<String>()
}

fn options() -> Options {
    Options {
        sandbox: Sandbox::with_writes_in_memory(),
        search: SearchPath::new(&folder(), &[]),
        size: SIZE,
        ..Options::default()
    }
}

/// The numbers that a scene prints.
fn run(text: &str) -> Result<Vec<f64>, Failed> {
    let mut printed = String::new();
    let told = durer::on_big_stack(|| {
        let sources = Sources::default();
        let Some(file) = sources.add("scene", None, text.to_string()) else { return vec![] };
        let outcome = interpret(&sources, file, &options(), &mut |text| printed.push_str(text));
        outcome.diagnostics.iter().map(|d| format!("{} {}", d.code, d.message)).collect::<Vec<String>>()
    });
    let faults: Vec<String> = told.into_iter().filter(|m| !m.starts_with('W')).collect();
    if !faults.is_empty() {
        return Err(faults.join("\n").into());
    }
    Ok(printed.lines().map(|line| line.parse().unwrap_or(f64::NAN)).collect())
}

/// The red of the pixels of an object's picture, in 65535ths.
fn draw(object: &str, places: &[Vec<f64>]) -> Result<Vec<f64>, Failed> {
    let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }}\n{STAGE}\n{object}\n");
    let (width, height) = SIZE;
    let frame = durer::on_big_stack(|| {
        let sources = Sources::default();
        let file = sources.add("scene", None, text).ok_or("no source")?;
        let built = durer::build(&sources, file, &options(), &mut |_| {});
        let told = built.diagnostics.iter().map(|d| d.message.clone()).collect::<Vec<_>>().join("\n");
        let world = built.world.ok_or(told)?;
        let options = render::Options::new(width, height);
        render(&world, &options, &Unwatched).map(|(frame, _)| frame).map_err(|_| "cancelled".to_string())
    })?;
    let red = |place: &Vec<f64>| frame.pixels[place[1] as usize * width + place[0] as usize][0];
    Ok(places.iter().map(|place| f64::from(red(place)).clamp(0.0, 1.0) * 65535.0).collect())
}
