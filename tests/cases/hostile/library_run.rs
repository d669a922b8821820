//! Runs texts through the library, and checks its messages.

use durer::diagnostic::{Diagnostic, Severity, codes, draw};
use durer::interpreter::Options;
use durer::render::{self, Watch};
use durer::source::{Sandbox, SearchPath, Sources, Span};
use std::path::Path;
use std::time::{Duration, Instant};

/// A time limit for a render.
struct Deadline(Instant);

impl Watch for Deadline {
    fn progress(&self, _: usize, _: usize) {}
    fn cancelled(&self) -> bool {
        Instant::now() > self.0
    }
}

/// Settings of a run.
pub struct Run<'a> {
    pub path: &'a Path,
    pub steps: u64,
    /// True to render a tiny picture of a scene without errors.
    pub draw: bool,
}

/// Result of a run.
#[derive(Default)]
pub struct Verdict {
    /// True without errors.
    pub sound: bool,
    /// Violated properties.
    pub wrong: Vec<String>,
}

impl Run<'_> {
    /// Builds the world and, if requested, renders a picture. Needs a big stack.
    pub fn check(&self, text: String) -> Verdict {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        let options = Options {
            sandbox: Sandbox::with_writes_in_memory(),
            search: SearchPath::new(folder, &[]),
            size: (8, 6),
            max_steps: self.steps,
            max_time: Some(2.0),
            max_memory: Some(3 << 30),
            ..Options::default()
        };
        let sources = Sources::default();
        let name = self.path.display().to_string();
        let Some(file) = sources.add(&name, Some(self.path), text) else { return Verdict::default() };
        let built = durer::build(&sources, file, &options, &mut |_| {});
        let failed = built.limit_reached || built.diagnostics.iter().any(|d| d.severity == Severity::Error);
        let mut wrong: Vec<String> = built.diagnostics.iter().filter_map(|d| fault_of(d, &sources)).collect();
        if built.world.is_none() && !failed {
            wrong.push("no World and no error".into());
        }
        if built.limit_reached && !built.diagnostics.iter().any(|d| d.severity == Severity::Error) {
            wrong.push("a limit was reached, and nothing told".into());
        }
        if let (Some(world), false, true) = (&built.world, failed, self.draw) {
            wrong.extend(picture(world));
        }
        Verdict { sound: !failed, wrong }
    }
}

/// Checks that every pixel is a number. (Lights of 1e308 may give infinity.)
fn picture(world: &durer::world::World) -> Option<String> {
    let options = render::Options::new(8, 6);
    let (frame, _) = render::render(world, &options, &Deadline(Instant::now() + Duration::from_secs(1))).ok()?;
    let bad = frame.pixels.iter().flatten().find(|x| x.is_nan())?;
    Some(format!("a pixel is {bad}"))
}

/// Checks a message: it has a span in a file, and can be rendered.
fn fault_of(d: &Diagnostic, sources: &Sources) -> Option<String> {
    let drawn = draw::render(d, sources, draw::Style { fancy: false, ascii: false, width: 100 });
    let labels = d.labels.iter().chain(&d.trace);
    let outside = labels.map(|l| l.span).find(|span| !is_inside(*span, sources));
    // `#warning ""` may be empty.
    let own_words = matches!(d.code, codes::USER_WARNING | codes::USER_ERROR);
    let complaint = match outside {
        Some(span) => format!("a place outside of its file: {span:?}"),
        None if d.message.is_empty() && !own_words => "no words".into(),
        None if d.labels.is_empty() && d.code != codes::NO_CAMERA => "no place".into(),
        None if !drawn.contains(d.code.0) => "its drawing lacks the code".into(),
        None => return None,
    };
    Some(format!("{complaint}: {} {}", d.code, d.message))
}

/// True if a span begins and ends in one file, between characters.
fn is_inside(span: Span, sources: &Sources) -> bool {
    let Some((id, _)) = sources.locate(span) else { return false };
    let (text, base) = (sources.text(id), sources.base(id));
    let local = |at: u32| (at as usize).checked_sub(base).filter(|&at| text.is_char_boundary(at));
    span.lo <= span.hi && local(span.lo).is_some() && local(span.hi).is_some() && sources.place(span).is_some()
}
