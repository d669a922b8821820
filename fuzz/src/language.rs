//! Properties of texts in the scene language.

use crate::{Corpus, allocated_bytes};
use durer::format::{WIDTH, format};
use durer::source::text_of;
use durer::syntax::{Granularity, Names, Piece, parse_text};
use durer::{
    BuildOptions, Built, Diagnostic, FileId, Host, LocalHost, Memory, RenderOptions, Sandbox, SearchPath, Severity,
    Sources, Span, Watch,
};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Longest text that is interpreted, in bytes.
const MAX_TEXT: usize = 20_000;

/// Files that scenes may read, in the only folder of the search path.
const FILES: &[(&str, &[u8])] = &[
    ("a.png", include_bytes!("../seeds/picture_png/a.png")),
    ("a.gif", include_bytes!("../seeds/picture_gif/a.gif")),
    ("a.ply", include_bytes!("../seeds/mesh_ply/a.ply")),
    ("a.obj", include_bytes!("../seeds/mesh_obj/a.obj")),
    ("a.df3", include_bytes!("../seeds/density/a.df3")),
    ("a.inc", b"#declare A = 1; #macro M(B) sphere { 0, B } #end"),
    ("a.txt", b"1, 2.5, \"text\", <1, 2, 3>,\n4"),
];

/// Checks that tokens, comments and the blanks between them are the text, for both granularities of the parser, and
/// that the faults of the lexer and of the parser are inside the text.
pub fn parse(bytes: &[u8]) -> Corpus {
    let Ok(text) = text_of(bytes.to_vec()) else { return Corpus::Reject };
    for granularity in [Granularity::Whole, Granularity::Tokens] {
        check_pieces(&text, granularity);
    }
    Corpus::Keep
}

fn check_pieces(text: &str, granularity: Granularity) {
    /// Global offset of the text's first byte.
    const BASE: usize = 100;
    let (ast, faults) = parse_text(text, BASE, &Names::default(), granularity);
    let local = |span: Span| {
        let (lo, hi) = (span.lo as usize - BASE, span.hi as usize - BASE);
        assert!(lo <= hi && text.is_char_boundary(lo) && text.is_char_boundary(hi), "{span:?} is no part of the text");
        (lo, hi)
    };
    let mut end = 0;
    for piece in ast.tokens.tokens_and_comments() {
        let (lo, hi) = local(piece.span());
        assert!(end <= lo, "{piece:?} overlaps the piece before it");
        assert!(!faults.is_empty() || is_blank(&text[end..lo]), "{:?} is between two tokens", &text[end..lo]);
        end = hi;
    }
    assert!(!faults.is_empty() || is_blank(&text[end..]), "{:?} is after the last token", &text[end..]);
    ast.elements.iter().for_each(|element| _ = local(element.span));
    faults.iter().flat_map(|fault| &fault.labels).for_each(|label| _ = local(label.span));
}

/// True for text that the lexer ignores.
fn is_blank(between: &str) -> bool {
    between.chars().all(|c| c <= ' ' || matches!(c, '#' | '\u{A0}' | '\u{FEFF}' | '\u{7F}'))
}

/// Checks that the formatter keeps tokens and comments, and that formatting twice equals formatting once.
pub fn format_text(bytes: &[u8]) -> Corpus {
    let Ok(text) = text_of(bytes.to_vec()) else { return Corpus::Reject };
    for width in [WIDTH, 40] {
        let Ok(once) = format(&text, 0, width) else { return Corpus::Keep };
        assert_eq!(pieces(&text), pieces(&once), "other tokens after formatting, width {width}");
        let twice = format(&once, 0, width).expect("a formatted text has no faults");
        assert_eq!(once, twice, "formatting is not idempotent, width {width}");
    }
    Corpus::Keep
}

/// Tokens and comments, each number and sign as a token of its own, without blanks at the end of comments.
fn pieces(text: &str) -> Vec<&str> {
    let (ast, _) = parse_text(text, 0, &Names::default(), Granularity::Tokens);
    let read = |piece: Piece| {
        let span = piece.span();
        text[span.lo as usize..span.hi as usize].trim_end_matches(|c| c <= ' ')
    };
    ast.tokens.tokens_and_comments().map(read).collect()
}

/// Interprets a scene within a budget of steps, time and memory, and checks the diagnostics. All files are in memory.
pub fn interpret(bytes: &[u8]) -> Corpus {
    let Some((sources, file, options)) = scene(bytes) else { return Corpus::Reject };
    let outcome = durer::interpreter::interpret(&sources, file, &options, &mut |_| {});
    check_diagnostics(&outcome.diagnostics, &sources);
    let is_wrong = outcome.diagnostics.iter().any(|d| d.severity == Severity::Error);
    assert!(outcome.scene.is_some() || is_wrong, "neither a scene nor an error");
    assert!(is_wrong || !outcome.limit_reached, "a limit was reached without an error");
    Corpus::Keep
}

/// Interprets and lowers a scene, and renders 8x8 pixels, all within a budget. No pixel may be NaN.
pub fn render(bytes: &[u8]) -> Corpus {
    let Some((sources, file, options)) = scene(bytes) else { return Corpus::Reject };
    let Built { world, diagnostics, .. } = durer::build(&sources, file, &options, &mut |_| {});
    check_diagnostics(&diagnostics, &sources);
    let Some(world) = world else { return Corpus::Keep };
    let deadline = Deadline(Instant::now() + Duration::from_secs(1));
    let options = RenderOptions { antialias: Some(0.3), alpha: bytes.len() % 2 == 0, ..RenderOptions::new(8, 8) };
    if let Ok((frame, _)) = durer::render(&world, &options, &deadline) {
        assert!(!frame.pixels.iter().flatten().any(|x| x.is_nan()), "a pixel is NaN");
    }
    Corpus::Keep
}

/// Prepares a run of the interpreter on a text; `None` if the bytes are no text or too long.
fn scene(bytes: &[u8]) -> Option<(Sources, FileId, BuildOptions)> {
    if bytes.len() > MAX_TEXT {
        return None;
    }
    let files = Memory::default();
    FILES.iter().for_each(|(name, bytes)| files.insert(name, *bytes));
    let sources = Sources::new(Arc::new(files));
    let file = durer::load_bytes(&sources, "main.pov", bytes).ok()?;
    let search = SearchPath { folders: vec![".".into()], fonts: vec![] };
    let options = BuildOptions {
        sandbox: Sandbox::for_search_path(&search),
        search,
        size: (8, 8),
        max_steps: 3_000,
        max_time: Some(1.0),
        max_memory: Some(1 << 30),
        host: Arc::new(MeteredHost(LocalHost::default())),
        ..BuildOptions::default()
    };
    Some((sources, file, options))
}

/// Checks that each diagnostic has words, and that its spans are inside of files.
fn check_diagnostics(diagnostics: &[Diagnostic], sources: &Sources) {
    for diagnostic in diagnostics {
        assert!(!diagnostic.line(sources).is_empty());
        for span in diagnostic.labels.iter().chain(&diagnostic.trace).map(|label| label.span) {
            let (file, base) = sources.locate(span).map(|(file, _)| (file, sources.base(file))).expect("a file");
            let text = sources.text(file);
            let is_boundary = |at: u32| (at as usize).checked_sub(base).is_some_and(|at| text.is_char_boundary(at));
            let is_inside = span.lo <= span.hi && is_boundary(span.lo) && is_boundary(span.hi);
            assert!(is_inside, "{span:?} is no part of a file: {diagnostic:?}");
        }
    }
}

/// The machine, with the memory count of the fuzzers' allocator.
#[derive(Debug)]
struct MeteredHost(LocalHost);

impl Host for MeteredHost {
    fn monotonic_time(&self) -> Duration {
        self.0.monotonic_time()
    }

    /// Returns the same time in each run, so that a fault can be repeated.
    fn since_1970(&self) -> Duration {
        Duration::from_secs(1_700_000_000)
    }

    fn resident_bytes(&self) -> Option<u64> {
        Some(allocated_bytes() as u64)
    }

    fn has_cheap_resident_bytes(&self) -> bool {
        true
    }
}

/// End of the time for a render.
struct Deadline(Instant);

impl Watch for Deadline {
    fn progress(&self, _: usize, _: usize) {}

    fn cancelled(&self) -> bool {
        Instant::now() > self.0
    }
}
