//! Parsed expressions and single tokens mean the same: each scene of this repository, and many of POV-Ray's, is run in
//! both granularities, and must give the same scene and messages.

use durer::interpreter::{Options, interpret};
use durer::source::{Sandbox, SearchPath, Sources};
use durer::syntax::Granularity;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Changes to a scratch folder, to which scenes write their files.
fn enter_scratch() {
    std::env::set_current_dir(env!("CARGO_TARGET_TMPDIR")).unwrap();
}

fn own(folder: &str) -> Vec<PathBuf> {
    let files = gather(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder));
    assert!(files.len() > 5, "{folder}: {} files", files.len());
    files
}

/// All scenes below a folder.
fn gather(folder: &Path) -> Vec<PathBuf> {
    let mut all = vec![];
    for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()) {
        if path.is_dir() {
            all.extend(gather(&path));
        } else if path.extension().is_some_and(|e| e == "scene" || e == "pov") {
            all.push(path);
        }
    }
    all.sort();
    all
}

/// Result of a run.
struct Ran {
    scene: String,
    messages: Vec<String>,
    printed: String,
    limited: bool,
    took: Duration,
}

fn run(path: &Path, text: &str, granularity: Granularity, max_steps: u64) -> Ran {
    let start = Instant::now();
    let folder = path.parent().unwrap();
    let search = SearchPath::new(folder, &[]);
    let options = Options {
        sandbox: Sandbox::with_writes_in_memory(),
        search,
        input_name: path.file_name().unwrap().to_string_lossy().into_owned(),
        size: (64, 48),
        max_steps,
        max_memory: Some(2 << 30),
        granularity,
        ..Options::default()
    };
    let sources = Sources::default();
    let file = sources.add(&path.display().to_string(), Some(path), text.to_string()).unwrap();
    let mut printed = String::new();
    let outcome = interpret(&sources, file, &options, &mut |text| printed.push_str(text));
    let message = |d: &durer::diagnostic::Diagnostic| {
        let place = sources.place(d.span()).map(|p| format!("{}:{}:{}", p.file, p.line, p.column));
        format!(
            "{} {:?} at {}: {} | {}",
            d.code,
            d.severity,
            place.unwrap_or_default(),
            d.message,
            d.help.as_deref().unwrap_or_default()
        )
    };
    Ran {
        scene: serde_json::to_string(&outcome.scene).unwrap(),
        messages: outcome.diagnostics.iter().map(message).collect(),
        printed,
        limited: outcome.limit_reached,
        took: start.elapsed(),
    }
}

/// The first difference of two texts, with its surroundings.
fn parting(a: &str, b: &str) -> String {
    let at = a.bytes().zip(b.bytes()).take_while(|(a, b)| a == b).count();
    let around = |s: &str| {
        let bytes = &s.as_bytes()[at.saturating_sub(160).min(s.len())..(at + 80).min(s.len())];
        String::from_utf8_lossy(bytes).into_owned()
    };
    format!("    whole: …{}\n    single: …{}", around(a), around(b))
}

/// The difference between both runs; `None` if they agree.
fn compare(path: &Path, max_steps: u64) -> Option<String> {
    let text = durer::source::read_text(&durer::source::Disk, path).ok()?;
    let whole = run(path, &text, Granularity::Whole, max_steps);
    let single = run(path, &text, Granularity::Tokens, max_steps);
    if std::env::var_os("WHOLES_SHOW").is_some() {
        eprintln!("{}: {:?} {:?}", path.display(), whole.took, single.took);
    }
    // A limit on time, steps or memory may be reached at different spans.
    if whole.limited || single.limited {
        return (whole.limited != single.limited && max_steps > MANY).then(|| format!("{}: a limit", path.display()));
    }
    let mut wrong = vec![];
    if whole.messages != single.messages {
        let only = |a: &[String], b: &[String]| a.iter().filter(|m| !b.contains(m)).cloned().collect::<Vec<_>>();
        let (of_whole, of_single) = (only(&whole.messages, &single.messages), only(&single.messages, &whole.messages));
        wrong.push(format!("    only whole: {of_whole:#?}\n    only single: {of_single:#?}"));
    }
    if whole.printed != single.printed {
        wrong.push(parting(&whole.printed, &single.printed));
    }
    if whole.scene != single.scene {
        wrong.push(parting(&whole.scene, &single.scene));
    }
    (!wrong.is_empty()).then(|| format!("{}\n{}", path.display(), wrong.join("\n")))
}

/// Maximum number of steps of POV-Ray's scenes.
const MANY: u64 = 300_000;

/// Compares on all processors until the time is over; returns the number of scenes compared.
fn compare_all(files: &[PathBuf], max_steps: u64, time: Duration) -> usize {
    enter_scratch();
    let (next, start) = (AtomicUsize::new(0), Instant::now());
    let work = || {
        let mut wrong = vec![];
        while start.elapsed() < time
            && let Some(path) = files.get(next.fetch_add(1, Ordering::Relaxed))
        {
            wrong.extend(compare(path, max_steps));
        }
        wrong
    };
    let halves = std::thread::scope(|scope| {
        let threads = [(); 2].map(|()| scope.spawn(|| durer::on_big_stack(work)));
        threads.map(|thread| thread.join().unwrap())
    });
    let wrong: Vec<String> = halves.into_iter().flatten().collect();
    assert!(wrong.is_empty(), "{} of {} differ:\n{}", wrong.len(), files.len(), wrong.join("\n"));
    next.into_inner().min(files.len())
}

const LONG: Duration = Duration::from_secs(600);

#[test]
fn scenes() {
    compare_all(&own("scenes"), 10_000_000, LONG);
}

#[test]
fn messages() {
    compare_all(&own("tests/ui"), 10_000_000, LONG);
}

#[test]
fn cases_of_light() {
    compare_all(&own("tests/light_cases"), 10_000_000, LONG);
}

#[test]
fn cases_of_the_library() {
    let files = gather(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/library"));
    assert!(!files.is_empty());
    compare_all(&files, 10_000_000, LONG);
}

/// Compares a few dozen of POV-Ray's own scenes from all of its folders, as time permits. `WHOLES_ALL=1` compares all.
#[test]
fn povrays_scenes() {
    const STRIDE: usize = 13;
    let all = std::env::var_os("WHOLES_ALL").is_some();
    let files = gather(Path::new("/usr/share/doc/povray/examples"));
    let spread: Vec<PathBuf> =
        (0..STRIDE).flat_map(|first| files.iter().skip(first).step_by(STRIDE).cloned()).collect();
    let time = if all { LONG } else { Duration::from_secs(4) };
    let count = compare_all(&spread, if all { 10_000_000 } else { MANY }, time);
    println!("{count} of {} compared", files.len());
}
