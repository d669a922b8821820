//! Runs an open scene, and collects the diagnostics of each of its files.

use super::diagnostics::{EditorDiagnostic, from_run_diagnostic, idle_branch_hint};
use super::files::are_same_file;
use crate::Keep;
use crate::diagnostic::Severity;
use crate::interpreter::{Options, ParsedFiles};
use crate::math::cancel::CancelToken;
use crate::source::{Disk, Overlay, Sandbox, SearchPath, Sources};
use crate::syntax::lint::{self, Lints};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Maximum number of directives, loop passes and macro calls of a background run of a scene.
const MAX_STEPS: u64 = 50_000_000;
/// Time limit of a background run of a scene.
pub const MAX_TIME: Duration = Duration::from_secs(20);
/// Memory limit of a background run of a scene, in bytes.
const MAX_MEMORY: u64 = 4 << 30;

/// A scene that the language server is to run in the background.
pub struct Job {
    /// Number of the run since the server began.
    pub number: u64,
    /// Address of the scene to run.
    pub uri: String,
    /// Document version of the text to run.
    pub version: i32,
    /// Path of the scene; `None` for a text that is not saved.
    pub path: Option<PathBuf>,
    /// Text of the scene to run.
    pub text: String,
    /// Other open texts, which hide the files of the same path.
    pub open: Vec<(PathBuf, String)>,
    /// Folders of the run's include path.
    pub include: Vec<PathBuf>,
    /// Token that ends the run.
    pub cancel: CancelToken,
}

/// Result of running a scene in the background of the language server.
#[derive(Debug)]
pub struct RunResult {
    /// Number of the run that has ended.
    pub number: u64,
    /// Address of the scene that ran.
    pub uri: String,
    /// Version of the document's text that was run.
    pub version: i32,
    /// Diagnostics by the paths of files; `None` is the scene itself.
    pub diagnostics: BTreeMap<Option<PathBuf>, Vec<EditorDiagnostic>>,
}

/// Runs a scene on a thread of its own; calls `done` at the end. False if the system has no further thread.
pub fn start(job: Job, done: impl FnOnce(RunResult) + Send + 'static) -> bool {
    let work = move || {
        let diagnostics =
            catch_unwind(AssertUnwindSafe(|| crate::on_big_stack(|| diagnostics_by_file(&job)))).unwrap_or_default();
        done(RunResult { number: job.number, uri: job.uri, version: job.version, diagnostics });
    };
    std::thread::Builder::new().name("run".into()).spawn(work).is_ok()
}

/// Runs a scene and returns its diagnostics by the path of the file that they are about; `None` is the scene's own
/// text.
fn diagnostics_by_file(job: &Job) -> BTreeMap<Option<PathBuf>, Vec<EditorDiagnostic>> {
    let overlay = Overlay::new(Arc::new(Disk));
    job.open.iter().for_each(|(path, text)| overlay.insert(path, text.as_str()));
    let (sources, parsed) = (Sources::new(Arc::new(overlay)), ParsedFiles::default());
    let name = job.path.as_deref().unwrap_or(Path::new("untitled")).display().to_string();
    let Some(file) = sources.add(&name, job.path.as_deref(), job.text.clone()) else { return BTreeMap::new() };
    let folder = job.path.as_deref().and_then(Path::parent).unwrap_or(Path::new("."));
    let search = SearchPath::new(folder, &job.include);
    let input = job.path.as_deref().and_then(Path::file_name).unwrap_or_default().to_string_lossy().into_owned();
    let options = Options {
        // A run in the editor writes no files.
        sandbox: Sandbox::with_writes_in_memory(),
        search,
        input_name: input,
        size: (640, 480),
        max_steps: MAX_STEPS,
        max_time: Some(MAX_TIME.as_secs_f64()),
        max_memory: Some(MAX_MEMORY),
        cancel: job.cancel.clone(),
        record_branches: true,
        ..Options::default()
    };
    let built = crate::build_with(&parsed, &sources, file, &options, Keep::World, &mut |_| {});
    let mut out: BTreeMap<Option<PathBuf>, Vec<EditorDiagnostic>> = BTreeMap::new();
    let mut found = built.diagnostics;
    if found.iter().all(|diagnostic| diagnostic.severity == Severity::Warning) {
        // The scene's own file is the first that was parsed.
        let files: Vec<_> = parsed.all().into_iter().map(|(file, _)| file).collect();
        found.extend(lint::lint_scene(&sources, &files, Lints { unused: true, portable: true, shadow: false }));
    }
    for diagnostic in &found {
        let place = sources.locate(diagnostic.span()).map_or(file, |(id, _)| id);
        let path = sources.path(place).filter(|_| place != file).map(Path::to_path_buf);
        out.entry(path).or_default().push(from_run_diagnostic(diagnostic, &sources, place));
    }
    // The editor shows branches of open texts that did not run in a faint colour.
    for span in &built.unused_branches {
        let Some((id, bytes)) = sources.locate(*span) else { continue };
        let path = sources.path(id).filter(|_| id != file).map(Path::to_path_buf);
        if path.as_deref().is_none_or(|path| job.open.iter().any(|(open, _)| are_same_file(open, path))) {
            out.entry(path).or_default().push(idle_branch_hint(&sources, id, bytes));
        }
    }
    out
}
