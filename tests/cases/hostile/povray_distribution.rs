//! All files of POV-Ray's distribution, where it is installed: no panic, and messages have valid spans.

use super::library_run::Run;
use libtest_mimic::{Failed, Trial};
use std::panic::AssertUnwindSafe;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Installation folders of Debian and others.
const FOLDERS: &[&str] = &[
    "/usr/share/povray-3.7/include",
    "/usr/share/povray-3.7/scenes",
    "/usr/share/doc/povray/examples",
    "/usr/local/share/povray-3.7",
];
/// Time limit; the files that are read until then are spread over all folders. `DURER_FUZZ=1` reads all.
const TIME: Duration = Duration::from_secs(3);

pub fn trials() -> Vec<Trial> {
    vec![Trial::test("hostile::povrays_own_files", own_files)]
}

fn own_files() -> Result<(), Failed> {
    let mut files = vec![];
    FOLDERS.iter().for_each(|folder| gather(Path::new(folder), &mut files));
    files.sort();
    if files.is_empty() {
        println!("POV-Ray's scenes are not installed: skipped");
        return Ok(());
    }
    let (count, wrong) = durer::on_big_stack(|| check(&spread(&files)));
    println!("{count} of {} files read", files.len());
    if wrong.is_empty() { Ok(()) } else { Err(wrong.join("\n").into()) }
}

fn gather(folder: &Path, out: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()) {
        if path.is_dir() && !path.is_symlink() {
            gather(&path, out);
        } else if path.extension().is_some_and(|e| e == "pov" || e == "inc") {
            out.push(path);
        }
    }
}

/// Reordered so that neighbours come from different folders.
fn spread(files: &[PathBuf]) -> Vec<&PathBuf> {
    const STRIDE: usize = 17;
    (0..STRIDE).flat_map(|first| files.iter().skip(first).step_by(STRIDE)).collect()
}

/// Number of files read, and the faults.
fn check(files: &[&PathBuf]) -> (usize, Vec<String>) {
    let start = Instant::now();
    let all = std::env::var_os("DURER_FUZZ").is_some();
    let (mut count, mut wrong) = (0, vec![]);
    for path in files.iter().take_while(|_| all || start.elapsed() < TIME) {
        let Ok(text) = durer::source::read_text(&durer::source::Disk, path) else { continue };
        let run = Run { path, steps: 100_000, draw: false };
        match std::panic::catch_unwind(AssertUnwindSafe(|| run.check(text))) {
            Ok(verdict) => wrong.extend(verdict.wrong.into_iter().map(|w| format!("{}: {w}", path.display()))),
            Err(_) => wrong.push(format!("{}: panic", path.display())),
        }
        count += 1;
    }
    (count, wrong)
}
