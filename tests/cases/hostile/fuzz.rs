//! Mutations of all our scenes: no panic, no hang, and messages with valid spans.

use super::library_run::{Run, Verdict};
use crate::mutate::{Rng, mutate};
use libtest_mimic::{Failed, Trial};
use std::panic::AssertUnwindSafe;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, mpsc};
use std::time::{Duration, Instant};

/// Number of mutants in an ordinary run, and its time limit. Each run takes the same seeds, so more of them find little more.
const MODEST: usize = 4_000;
const MODEST_TIME: Duration = Duration::from_secs(3);
/// Time after which a single mutant counts as hanging.
const HANGS: Duration = Duration::from_secs(20);

pub fn trials() -> Vec<Trial> {
    vec![Trial::test("hostile::fuzz", fuzz), Trial::test("all_scenes_as_they_are", originals)]
}

/// All scenes below these folders, sorted.
fn corpus() -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = vec![];
    for folder in ["scenes", "tests/lang", "tests/ui"] {
        gather(&root.join(folder), &mut files);
    }
    files.sort();
    let text = |path: PathBuf| durer::source::read_text(&durer::source::Disk, &path).ok().map(|text| (path, text));
    files.into_iter().filter_map(text).collect()
}

fn gather(folder: &Path, out: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()) {
        if path.is_dir() {
            gather(&path, out);
        } else if path.extension().is_some_and(|e| e == "scene" || e == "inc" || e == "pov") {
            out.push(path);
        }
    }
}

/// A number in the environment.
fn number(name: &str) -> Option<usize> {
    std::env::var(name).ok()?.parse().ok()
}

/// State shared by all workers.
struct Hunt {
    corpus: Vec<(PathBuf, String)>,
    next: AtomicUsize,
    end: usize,
    until: Option<Instant>,
    sound: AtomicUsize,
    found: Mutex<Vec<String>>,
}

impl Hunt {
    /// The path and the text of a seed's mutant.
    fn mutant(&self, seed: usize) -> (&Path, String) {
        let mut rng = Rng::new(seed as u64);
        let (path, text) = &self.corpus[rng.below(self.corpus.len())];
        let (_, other) = &self.corpus[rng.below(self.corpus.len())];
        (path, mutate(text, other, &mut rng))
    }

    fn over(&self) -> bool {
        self.until.is_some_and(|until| Instant::now() > until) || self.found.lock().is_ok_and(|f| f.len() >= 20)
    }

    /// Tests seeds until there are no more; reports the current one.
    fn work(&self, worker: usize, at: &mpsc::Sender<(usize, Option<usize>)>) {
        loop {
            let seed = self.next.fetch_add(1, Ordering::Relaxed);
            if seed >= self.end || self.over() {
                at.send((worker, None)).ok();
                return;
            }
            at.send((worker, Some(seed))).ok();
            let (path, text) = self.mutant(seed);
            let verdict = verdict(path, text.clone());
            self.sound.fetch_add(usize::from(verdict.sound), Ordering::Relaxed);
            if !verdict.wrong.is_empty() {
                let kept = keep(&format!("seed-{seed}.scene"), &text);
                let name = path.file_name().unwrap_or_default().display();
                let message = format!("seed {seed} of {name}: {}\n    {kept}", verdict.wrong.join("\n    "));
                self.found.lock().unwrap().push(message);
            }
        }
    }
}

/// Stores a text with a fault; returns its path.
fn keep(name: &str, text: &str) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).ok();
    path.display().to_string()
}

/// Tests a text; a panic is a fault.
fn verdict(path: &Path, text: String) -> Verdict {
    let run = Run { path, steps: 20_000, draw: true };
    std::panic::catch_unwind(AssertUnwindSafe(|| run.check(text))).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned().or(panic.downcast_ref::<&str>().map(|s| s.to_string()));
        Verdict { sound: false, wrong: vec![format!("panic: {}", text.unwrap_or_default())] }
    })
}

fn fuzz() -> Result<(), Failed> {
    let wished = number("DURER_FUZZ");
    let first = number("DURER_SEED");
    let hunt = Arc::new(Hunt {
        corpus: corpus(),
        next: AtomicUsize::new(first.unwrap_or(0)),
        end: first.map_or(wished.unwrap_or(MODEST), |first| first + wished.unwrap_or(1)),
        until: wished.is_none().then(|| Instant::now() + MODEST_TIME),
        sound: AtomicUsize::new(0),
        found: Mutex::default(),
    });
    let (sender, receiver) = mpsc::channel();
    for worker in 0..2 {
        let (hunt, sender) = (hunt.clone(), sender.clone());
        std::thread::Builder::new().spawn(move || durer::on_big_stack(|| hunt.work(worker, &sender)))?;
    }
    drop(sender);
    watch(&hunt, &receiver)?;
    let done = hunt.next.load(Ordering::Relaxed).min(hunt.end) - first.unwrap_or(0);
    println!("{done} mutants, {} of them without errors", hunt.sound.load(Ordering::Relaxed));
    let found = hunt.found.lock().unwrap();
    if found.is_empty() { Ok(()) } else { Err(found.join("\n").into()) }
}

/// Waits for all workers; an error if one of them hangs.
fn watch(hunt: &Hunt, receiver: &mpsc::Receiver<(usize, Option<usize>)>) -> Result<(), Failed> {
    let mut at: [Option<(usize, Instant)>; 2] = [None, None];
    loop {
        match receiver.recv_timeout(Duration::from_millis(500)) {
            Ok((worker, seed)) => at[worker] = seed.map(|seed| (seed, Instant::now())),
            Err(mpsc::RecvTimeoutError::Disconnected) => return Ok(()),
            Err(mpsc::RecvTimeoutError::Timeout) => {}
        }
        if let Some((seed, _)) = at.iter().flatten().find(|(_, since)| since.elapsed() > HANGS) {
            let kept = keep(&format!("hang-{seed}.scene"), &hunt.mutant(*seed).1);
            return Err(format!("seed {seed} hangs\n    {kept}").into());
        }
    }
}

/// The scenes themselves satisfy the same properties.
fn originals() -> Result<(), Failed> {
    let wrong = durer::on_big_stack(|| {
        let mut wrong = vec![];
        for (path, text) in corpus() {
            let verdict = verdict(&path, text);
            wrong.extend(verdict.wrong.into_iter().map(|w| format!("{}: {w}", path.display())));
        }
        wrong
    });
    if wrong.is_empty() { Ok(()) } else { Err(wrong.join("\n").into()) }
}
