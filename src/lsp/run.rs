//! A run of a scene that is open: what it finds, for each file of the scene.

use super::diagnostics::{Told, idle, tell};
use super::files::same;
use crate::Keep;
use crate::diagnostic::Severity;
use crate::interpreter::{Options, ParsedFiles};
use crate::source::{Disk, Overlay, Sandbox, SearchPath, Sources};
use crate::syntax::lint::{self, Lints};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Elements and loop passes, seconds, and bytes that a run may take.
const MAX_STEPS: u64 = 50_000_000;
const MAX_TIME: f64 = 20.0;
const MAX_MEMORY: u64 = 4 << 30;

/// What is run.
pub struct Job {
    /// Of the scene.
    pub uri: String,
    /// Of its text.
    pub version: i32,
    /// Where it lies.
    pub path: Option<PathBuf>,
    /// What stands in it.
    pub text: String,
    /// Other open texts, which stand for their files.
    pub open: Vec<(PathBuf, String)>,
    /// Where included files are looked for.
    pub include: Vec<PathBuf>,
    /// Ends it.
    pub stop: Arc<AtomicBool>,
}

/// What came of it.
pub struct Ran {
    /// Of the scene.
    pub uri: String,
    /// Of the text that was run.
    pub version: i32,
    /// By the paths of files; that of the scene has none.
    pub told: BTreeMap<Option<PathBuf>, Vec<Told>>,
}

/// Runs it in a thread of its own.
pub fn start(job: Job, done: impl FnOnce(Ran) + Send + 'static) {
    let work = move || {
        let told = catch_unwind(AssertUnwindSafe(|| crate::on_big_stack(|| run(&job)))).unwrap_or_default();
        done(Ran { uri: job.uri, version: job.version, told });
    };
    // Without a thread there is nothing to tell.
    let _ = std::thread::Builder::new().name("run".into()).spawn(work);
}

fn run(job: &Job) -> BTreeMap<Option<PathBuf>, Vec<Told>> {
    let overlay = Overlay::new(Arc::new(Disk));
    job.open.iter().for_each(|(path, text)| overlay.insert(path, text.as_str()));
    let (sources, parsed) = (Sources::new(Arc::new(overlay)), ParsedFiles::default());
    let name = job.path.as_deref().unwrap_or(Path::new("untitled")).display().to_string();
    let Some(file) = sources.add(&name, job.path.as_deref(), job.text.clone()) else { return BTreeMap::new() };
    let folder = job.path.as_deref().and_then(Path::parent).unwrap_or(Path::new("."));
    let search = SearchPath::new(folder, &job.include);
    let input = job.path.as_deref().and_then(Path::file_name).unwrap_or_default().to_string_lossy().into_owned();
    let options = Options {
        // Nobody wants a file written while he types.
        sandbox: Sandbox { write: vec![], ..Sandbox::around(&search) },
        search,
        input_name: input,
        size: (640, 480),
        max_steps: MAX_STEPS,
        max_time: Some(MAX_TIME),
        max_memory: Some(MAX_MEMORY),
        stop: Some(job.stop.clone()),
        branches: true,
        ..Options::default()
    };
    let built = crate::build_with(&parsed, &sources, file, &options, Keep::World, &mut |_| {});
    let mut told: BTreeMap<Option<PathBuf>, Vec<Told>> = BTreeMap::new();
    let mut found = built.diagnostics;
    if found.iter().all(|diagnostic| diagnostic.severity == Severity::Warning) {
        // The scene's own file is the first that was parsed.
        let files: Vec<_> = parsed.all().into_iter().map(|(file, _)| file).collect();
        found.extend(lint::lint(
            &sources,
            parsed.names(),
            &files,
            Lints { unused: true, portable: true, shadow: false },
        ));
    }
    for diagnostic in &found {
        let place = sources.locate(diagnostic.span()).map_or(file, |(id, _)| id);
        let path = sources.path(place).filter(|_| place != file).map(Path::to_path_buf);
        told.entry(path).or_default().push(tell(diagnostic, &sources, place));
    }
    // What did not run is shown faint, where somebody sees it.
    for span in &built.idle {
        let Some((id, bytes)) = sources.locate(*span) else { continue };
        let path = sources.path(id).filter(|_| id != file).map(Path::to_path_buf);
        if path.as_deref().is_none_or(|path| job.open.iter().any(|(open, _)| same(open, path))) {
            told.entry(path).or_default().push(idle(&sources, id, bytes));
        }
    }
    told
}
