//! Reads a scene for the page, and converts messages and positions for it.

use crate::cli::animation::Animation;
use crate::cli::args::values::Size;
use crate::cli::args::{RenderArgs, WatchArgs};
use crate::cli::console::{Console, print_message};
use crate::cli::exit::Failure;
use crate::cli::interrupt::{Deadline, Overrun};
use crate::cli::overlay::{self, Invocation};
use crate::cli::session;
use crate::diagnostic::{Diagnostic, Severity};
use crate::interpreter::{self, ParsedFiles, Timing};
use crate::math::cancel::{CancelReason, CancelToken};
use crate::preview::{Link, Message, PageSettings};
use crate::source::{LookedUpFiles, Sources, Span};
use crate::world::World;
use crate::{Keep, render};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Duration;

/// A watched scene that can be rendered.
pub struct Scene {
    pub world: World,
    /// Registry of the watched scene's source texts; locked, since two threads may not use it at once.
    pub sources: Mutex<Sources>,
    /// Path of the watched scene's file.
    pub input: PathBuf,
    /// Arguments of the command line and of the INI file.
    pub args: RenderArgs,
    pub timing: Timing,
}

/// Result of reading a watched scene.
#[derive(Default)]
pub struct Read {
    /// The watched scene; `None` after an error or if a newer request cancelled the run.
    pub scene: Option<Scene>,
    /// Errors of the watched scene, then its warnings.
    pub messages: Vec<Message>,
    /// Output of the scene's `#debug` and its kin.
    pub log: String,
    /// True if the messages include an error.
    pub failed: bool,
    /// Size of the picture by the arguments, not scaled for the page; `None` if the scene's file could not be opened.
    pub size: Option<Size>,
    /// Present, first and last value of `clock`.
    pub clock: [f64; 3],
    /// Files that were looked up for the watched scene.
    pub files: LookedUpFiles,
    /// Durations of evaluating the text into a Scene, and of building the World from the Scene.
    pub times: [Duration; 2],
}

/// Largest length of [`Read::log`], in bytes.
const MAX_LOG: usize = 64 << 10;

/// Reads the watched scene's text and builds its World. Messages and the scene's own output also go to the console.
pub fn read(console: &Console, args: &WatchArgs, settings: &PageSettings, cancel: &CancelToken) -> Read {
    let sources = Sources::default();
    let mut out = Read::default();
    let messages = match try_read(args, settings, cancel, &sources, &mut out) {
        Ok((messages, scene)) => {
            out.scene = scene.map(|(world, input, args, timing)| {
                let sources = Mutex::default();
                Scene { world, sources, input, args, timing }
            });
            messages
        }
        Err(messages) => messages,
    };
    out.files = sources.looked_up_files();
    if cancel.reason() == Some(CancelReason::Request) {
        return out;
    }
    console.report(&sources, &messages);
    out.failed = messages.iter().any(|d| d.severity == Severity::Error);
    let (errors, warnings): (Vec<_>, Vec<_>) = messages.into_iter().partition(|d| d.severity == Severity::Error);
    out.messages = errors.iter().chain(&warnings).map(|d| message(&sources, d)).collect();
    if out.failed {
        out.scene = None;
    }
    if let Some(scene) = &mut out.scene {
        scene.sources = Mutex::new(sources);
    }
    out
}

/// Messages of a scene, and its World with the path, arguments and timing; `None` if no World was built.
type Found = (Vec<Diagnostic>, Option<(World, PathBuf, RenderArgs, Timing)>);

/// Reads the watched scene's text and builds its World. Stores size, clock, log and times in `out`; the caller sets the
/// other fields.
///
/// # Errors
/// Messages of a failure before the text is evaluated, such as a missing file.
fn try_read(
    args: &WatchArgs,
    settings: &PageSettings,
    cancel: &CancelToken,
    sources: &Sources,
    out: &mut Read,
) -> Result<Found, Vec<Diagnostic>> {
    let mut messages = vec![];
    let mut invocation = Invocation::new(&args.input, super::render_args(args), None);
    if let Some(mut ini) = overlay::read_ini(sources, &args.input, &args.scene, false)? {
        messages.append(&mut ini.warnings);
        invocation = invocation.with_ini_defaults(ini);
    }
    let Invocation { input, mut args, animation, .. } = invocation;
    let file = crate::load(sources, &input).map_err(|fault| vec![*fault])?;
    let base = args.scene.size();
    out.size = Some(base);
    let scaled = |side: usize| ((side as f64 * settings.scale).round() as usize).max(1);
    args.scene.size = Some(Size { width: scaled(base.width), height: scaled(base.height) });
    let mut timing =
        session::timing(&args.scene, animation.as_ref()).map_err(|failure| vec![diagnostic_of(failure)])?;
    let Animation { clock: range, .. } = animation.unwrap_or_else(|| {
        let whole = Animation::new(crate::cli::args::values::Frames { first: 1, last: 2, step: 1, digits: 1 });
        Animation { clock: args.scene.clock.filter(|clock| clock.first != clock.last).unwrap_or(whole.clock), ..whole }
    });
    if let Some(clock) = settings.clock {
        (timing.clock, timing.clock_on) = (clock, true);
    }
    out.clock = [timing.clock, range.first, range.last];
    let options = session::reading_options(&args.scene, &input, timing);
    let threads = args.threads.map_or(0, usize::from);
    let options = interpreter::Options { cancel: cancel.clone(), threads, ..options };
    let log = &mut out.log;
    let mut print = |text: &str| {
        print_message(text);
        log.push_str(&text[..text.floor_char_boundary(MAX_LOG.saturating_sub(log.len()))]);
    };
    let _deadline = Deadline::start(args.scene.time_limit(), cancel.clone(), Overrun::Continues);
    let built = crate::build_with(&ParsedFiles::default(), sources, file, &options, Keep::World, &mut print);
    out.times = [built.parse_time, built.build_time];
    out.log.push_str(&session::files_in_memory_line(&built).unwrap_or_default());
    messages.extend(built.diagnostics);
    Ok((messages, built.world.map(|world| (world, input, args, timing))))
}

/// Returns the message of a command's failure.
pub fn diagnostic_of(failure: Failure) -> Diagnostic {
    match failure {
        Failure::Fault(fault) => *fault,
        Failure::Usage(error) => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default().trim_start_matches("error: ").to_string();
            Diagnostic::new(crate::diagnostic::codes::UNKNOWN_OPTION, Span::NONE, line)
        }
        Failure::Reported(_) | Failure::BrokenPipe => {
            Diagnostic::new(crate::diagnostic::codes::UNKNOWN_OPTION, Span::NONE, "the operation failed")
        }
    }
}

/// Returns a message in the form that the preview page displays.
pub fn message(sources: &Sources, diagnostic: &Diagnostic) -> Message {
    use crate::diagnostic::draw;
    let text = draw::render(diagnostic, sources, draw::Style { fancy: false, ascii: false, width: 100 });
    let severity = if diagnostic.severity == Severity::Error { "error" } else { "warning" };
    Message { severity, code: diagnostic.code.0, text, place: link(sources, diagnostic.span()) }
}

/// Returns the link that opens a position of the scene in an editor; `None` for a position in no file on the disk.
pub fn link(sources: &Sources, span: Span) -> Option<Link> {
    let place = sources.place(span)?;
    let path = sources.locate(span).and_then(|(file, _)| sources.path(file))?;
    let url = format!("vscode://file{}:{}:{}", url_path(path), place.line, place.column);
    Some(Link { file: place.file, line: place.line, column: place.column, url })
}

/// Returns a file's path as the path of a URL, with a leading `/`.
fn url_path(path: &Path) -> String {
    let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/-._~:".contains(&byte);
    let text = whole.to_string_lossy().replace('\\', "/");
    let byte = |b: u8| if plain(b) { char::from(b).to_string() } else { format!("%{b:02X}") };
    let slash = if text.starts_with('/') { "" } else { "/" };
    slash.to_string() + &text.bytes().map(byte).collect::<String>()
}

/// Returns the options for rendering a watched scene: those of the command line, with the anti-aliasing and
/// quality of the preview page. If the page zooms, the picture is larger, and only the visible region is rendered.
pub fn render_options_for_page(scene: &Scene, page: &PageSettings) -> render::Options {
    let threads = scene.args.threads.map_or(0, usize::from);
    let options = session::drawing_options(&scene.args.scene, &scene.args.look, threads, scene.timing);
    let antialias = match options.antialias {
        _ if !page.antialias => None,
        // The switch of the page overrides `--aa off`.
        None => default_antialias_threshold(),
        some => some,
    };
    let options = render::Options { antialias, quality: page.quality, ..options };
    let Some([x, y, width, height]) = page.zoom else { return options };
    let larger = (1.0 / width).min(1.0 / height).clamp(1.0, MAX_ZOOM);
    let side = |pixels: usize| (pixels as f64 * larger).round() as usize;
    let (across, down) = (side(options.width), side(options.height));
    let cut = |at: f64, length: f64, side: usize| {
        let start = ((at * side as f64).round() as usize).min(side - 1);
        (start, ((length * side as f64).round() as usize).clamp(1, side - start))
    };
    let ((x, width), (y, height)) = (cut(x, width, across), cut(y, height, down));
    render::Options { width: across, height: down, region: Some(render::Region { x, y, width, height }), ..options }
}

/// Largest zoom factor of the preview page.
const MAX_ZOOM: f64 = 64.0;

fn default_antialias_threshold() -> Option<f64> {
    Some(session::DEFAULT_THRESHOLD)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_escaped_in_addresses() {
        assert_eq!(url_path(Path::new("/a b/ü#.scene")), "/a%20b/%C3%BC%23.scene");
    }
}
