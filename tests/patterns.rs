//! Patterns against what the real POV-Ray prints: the tables of `tests/patterns/`, which `regenerate.py` there writes.

use durer::interpreter::{Options, interpret};
use durer::source::Sources;
use libtest_mimic::{Arguments, Failed, Trial};
use std::path::Path;

/// How far numbers may be from POV-Ray's, in units of the larger of the number and 1.
const TOLERANCE: f64 = 1e-9;

fn main() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/patterns");
    // `DURER_PATTERNS` names another folder with (larger) tables.
    let folder = std::env::var("DURER_PATTERNS").map_or(folder, Into::into);
    let mut trials = vec![];
    for name in sections() {
        let text = std::fs::read_to_string(folder.join(format!("{name}.txt"))).unwrap_or_default();
        for table in text.split("# ").skip(1) {
            let (setting, rows) = table.split_once('\n').unwrap_or((table, ""));
            let (title, setting, rows) = (format!("{name}::{setting}"), setting.to_string(), rows.to_string());
            trials.push(Trial::test(title, move || compare(&setting, &rows)));
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// The names of the tables.
fn sections() -> impl Iterator<Item = &'static str> {
    include_str!("patterns/settings.txt").lines().filter_map(|line| line.strip_prefix("== "))
}

/// A setting's table: `x y z value` in each line.
fn compare(setting: &str, rows: &str) -> Result<(), Failed> {
    let rows: Vec<Vec<f64>> = rows.lines().map(|l| l.split(' ').filter_map(|w| w.parse().ok()).collect()).collect();
    let printed = run(&scene(setting, &rows))?;
    let mut lines = printed.lines();
    let mut wrong = vec![];
    let mut worst: f64 = 0.0;
    for row in &rows {
        let theirs = row[3];
        let ours: f64 = lines.next().and_then(|l| l.parse().ok()).unwrap_or(f64::NAN);
        let error = (ours - theirs).abs() / theirs.abs().max(1.0);
        worst = worst.max(if error.is_nan() { f64::INFINITY } else { error });
        if error.is_nan() || error > TOLERANCE {
            wrong.push(format!("at <{}, {}, {}> {ours}, POV-Ray has {theirs}", row[0], row[1], row[2]));
        }
    }
    let shown: Vec<String> = wrong.iter().take(8).cloned().collect();
    let summary = format!("{} of {} differ, at most by {worst:.1e}\n{}", wrong.len(), rows.len(), shown.join("\n"));
    if wrong.is_empty() && !rows.is_empty() { Ok(()) } else { Err(summary.into()) }
}

/// A scene that prints the pattern's numbers.
fn scene(setting: &str, rows: &[Vec<f64>]) -> String {
    let (settings, pattern) = setting.rsplit_once('|').unwrap_or(("", setting));
    let call =
        |row: &Vec<f64>| format!("#debug concat(str(F({:?}, {:?}, {:?}), 0, 17), \"\\n\")\n", row[0], row[1], row[2]);
    format!(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1 {settings} }}\n\
         #declare F = function {{ pattern {{ {pattern} }} }}\n{}",
        rows.iter().map(call).collect::<String>()
    )
}

/// What a scene prints.
fn run(text: &str) -> Result<String, Failed> {
    let options = Options::default();
    let mut printed = String::new();
    let told = durer::on_big_stack(|| {
        let sources = Sources::default();
        let Some(file) = sources.add("scene", None, text.to_string()) else { return vec![] };
        let outcome = interpret(&sources, file, &options, &mut |text| printed.push_str(text));
        outcome.diagnostics.iter().map(|d| format!("{} {}", d.code, d.message)).collect::<Vec<String>>()
    });
    let faults: Vec<String> = told.into_iter().filter(|m| !m.starts_with('W')).collect();
    if faults.is_empty() { Ok(printed) } else { Err(faults.join("\n").into()) }
}
