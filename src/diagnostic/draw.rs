//! Renders diagnostics for a terminal. Only this file uses miette.

use super::{Diagnostic, Label, Severity};
use crate::source::{FileId, Sources, Span};
use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan,
    SpanContents,
};

/// Style of a diagnostic's rendering, such as colours.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// True if the message is drawn with colours.
    pub fancy: bool,
    /// True if frames are drawn with ASCII characters and without colours.
    pub ascii: bool,
    /// Width of the terminal, in columns.
    pub width: usize,
}

/// Renders one diagnostic to text that ends in a newline.
pub fn render(diagnostic: &Diagnostic, sources: &Sources, style: Style) -> String {
    let (theme, frame) = match style {
        Style { ascii: true, .. } => (GraphicalTheme::none(), ASCII_FRAME),
        Style { fancy: true, .. } => (GraphicalTheme::unicode(), FRAME),
        _ => (GraphicalTheme::unicode_nocolor(), FRAME),
    };
    let handler = GraphicalReportHandler::new_themed(theme).with_width(style.width).with_context_lines(1);
    let draw = |d: &Diagnostic| {
        let mut out = String::new();
        match handler.render_report(&mut out, &Report::new(d, sources)) {
            Ok(()) => out,
            Err(_) => format!("{}: {}\n", d.code, d.message),
        }
    };
    let mut out = match split_if_label_precedes_primary(diagnostic, sources) {
        Some([first, rest]) => {
            let rest = draw(&rest);
            // The message is above already: continue with the frame.
            let frame = rest.find(frame).and_then(|at| rest[..at].rfind('\n')).map_or(0, |at| at + 1);
            draw(&first) + &rest[frame..]
        }
        None => draw(diagnostic),
    };
    for step in &diagnostic.trace {
        if let Some(place) = sources.place(step.span) {
            out += &format!("  {} at {}:{}:{}\n", step.text, place.file, place.line, place.column);
        }
    }
    out
}

/// Beginning of the frame around quoted source lines.
const FRAME: &str = "╭─";

/// Beginning of the frame around quoted source lines, in ASCII characters.
const ASCII_FRAME: &str = ",-[";

/// Splits a diagnostic in two: one with the fault's own label, and one with the other labels and the help. `None` if
/// all can be shown together. The reason is that miette shows labels in the order of the text, so that others could
/// precede the fault.
fn split_if_label_precedes_primary(d: &Diagnostic, sources: &Sources) -> Option<[Diagnostic; 2]> {
    let line = |label: &Label| sources.place(label.span).map_or(0, |place| place.line);
    let primary = d.labels.first()?;
    let file = |label: &Label| sources.locate(label.span).map(|(id, _)| id);
    let own = line(primary);
    let (near, far): (Vec<_>, Vec<_>) =
        d.labels.iter().cloned().partition(|l| file(l) == file(primary) && line(l).abs_diff(own) <= 1);
    if !far.iter().any(|l| file(l) == file(primary) && line(l) < own) {
        return None;
    }
    // (The first label of a message decides which file is shown.)
    let far = far.into_iter().filter(|l| file(l) == file(primary)).collect();
    let first = Diagnostic { labels: near, help: None, trace: Box::default(), ..d.clone() };
    Some([first, Diagnostic { labels: far, trace: Box::default(), ..d.clone() }])
}

/// Adapter from a diagnostic to miette.
#[derive(Debug)]
struct Report {
    head: String,
    severity: Severity,
    help: Option<String>,
    source: Option<Lines>,
    labels: Vec<LabeledSpan>,
}

impl Report {
    fn new(d: &Diagnostic, sources: &Sources) -> Self {
        let kind = if d.severity == Severity::Error { "error" } else { "warning" };
        let file = sources.locate(d.span()).map(|(id, _)| id);
        let lines = file.map(|id| Lines::new(sources, id, d));
        let local = |span: Span| {
            let (id, range) = sources.locate(span).filter(|(id, _)| Some(*id) == file)?;
            lines.as_ref().map(|lines| lines.clip_to_shown_lines(range_or_first_line(sources.text(id), range)))
        };
        let label = |(i, l): (usize, &Label)| {
            let range = local(l.span)?;
            let text = (!l.text.is_empty()).then(|| l.text.clone());
            let (at, len) = (range.start, range.len());
            Some(if i == 0 {
                LabeledSpan::new_primary_with_span(text, (at, len))
            } else {
                LabeledSpan::new_with_span(text, (at, len))
            })
        };
        let labels = d.labels.iter().enumerate().filter_map(label).collect();
        Self {
            head: format!("{kind}[{}]: {}", d.code, abridged(&d.message)),
            severity: d.severity,
            help: d.help.as_deref().map(abridged),
            source: lines,
            labels,
        }
    }
}

impl std::fmt::Display for Report {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.head)
    }
}

impl std::error::Error for Report {}

impl miette::Diagnostic for Report {
    fn severity(&self) -> Option<miette::Severity> {
        Some(if self.severity == Severity::Error { miette::Severity::Error } else { miette::Severity::Warning })
    }

    fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        self.help.as_ref().map(|h| Box::new(h) as Box<dyn std::fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn miette::SourceCode> {
        self.source.as_ref().map(|s| s as &dyn miette::SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.labels.iter().cloned()))
    }
}

/// Maximum length of a message; longer ones, which quote a name or string of the scene, are cut in their middle.
const MAX_MESSAGE: usize = 2000;

/// Returns the text of a message, with its middle cut out if it is too long.
fn abridged(text: &str) -> String {
    if text.len() <= MAX_MESSAGE {
        return text.into();
    }
    let (head, tail) = (floor_char_start(text, MAX_MESSAGE / 2), floor_char_start(text, text.len() - MAX_MESSAGE / 2));
    format!("{} … {}", &text[..head], &text[tail..])
}

/// The source lines that a message shows, and their position in the file.
#[derive(Debug)]
struct Lines {
    name: String,
    /// Source text from the first to the last line with a label; of a very long line, the part around the label.
    text: String,
    /// Offset of `text` in the source file, in bytes.
    start: usize,
    /// Number of the first source line that the message shows, counted from 0.
    line: usize,
    /// Number of characters of the first line before `text`.
    column: usize,
}

/// Maximum length of a source line; a longer line is cut around the label.
const MAX_LINE: usize = 300;
/// Number of characters of a cut line that are shown before the label.
const CHARS_BEFORE_LABEL: usize = 60;
/// Maximum number of source lines of a label; a longer label marks its first line alone.
const MAX_LINES: usize = 8;

impl Lines {
    fn new(sources: &Sources, file: FileId, d: &Diagnostic) -> Self {
        let text = sources.text(file);
        let ranges: Vec<_> = d
            .labels
            .iter()
            .filter_map(|l| sources.locate(l.span))
            .filter(|(id, _)| *id == file)
            .map(|(_, range)| range_or_first_line(text, range))
            .collect();
        let first = ranges.iter().map(|r| r.start).min().unwrap_or(0);
        let last = ranges.iter().map(|r| r.end).max().unwrap_or(0);
        let line_start = text[..first].rfind(LINE_ENDS).map_or(0, |i| i + 1);
        let line_end = text[last..].find(LINE_ENDS).map_or(text.len(), |i| last + i);
        let (mut start, mut end) = (line_start, line_end);
        if line_end - line_start > MAX_LINE * (1 + text[line_start..line_end].matches('\n').count()) {
            // The first label is the place of the fault.
            let at = ranges.first().map_or(first, |r| r.start);
            start = floor_char_start(text, at.saturating_sub(CHARS_BEFORE_LABEL).max(line_start));
            end = floor_char_start(text, (start + MAX_LINE).min(line_end));
        }
        let line_span = |at: usize| Span::new(sources.base(file) + at, sources.base(file) + at);
        let place = sources.place(line_span(start));
        let (line, column) = place.map_or((0, 0), |p| (p.line - 1, p.column - 1));
        Self { name: sources.name(file).into(), text: text[start..end].into(), start, line, column }
    }

    /// Returns the part of a byte range that the shown lines contain.
    fn clip_to_shown_lines(&self, range: std::ops::Range<usize>) -> std::ops::Range<usize> {
        let (low, high) = (self.start, self.start + self.text.len());
        range.start.clamp(low, high)..range.end.clamp(low, high)
    }
}

const LINE_ENDS: [char; 2] = ['\n', '\r'];

/// Returns the byte range of a label, or that of its first line if the label has too many lines.
fn range_or_first_line(text: &str, range: std::ops::Range<usize>) -> std::ops::Range<usize> {
    let covered = &text[range.clone()];
    match covered.match_indices(LINE_ENDS).nth(MAX_LINES) {
        Some(_) => range.start..range.start + covered.find(LINE_ENDS).unwrap_or(covered.len()),
        None => range,
    }
}

/// Returns the nearest start of a character at or before a byte offset.
fn floor_char_start(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

impl SourceCode for Lines {
    /// Returns the whole source lines that hold a span, for miette, which would cut the lines to the span if no context
    /// is wanted.
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        _after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let lo = span
            .offset()
            .checked_sub(self.start)
            .filter(|lo| *lo <= self.text.len())
            .ok_or(MietteError::OutOfBounds)?;
        let hi = (lo + span.len()).min(self.text.len());
        let from = self.text[..lo].rfind('\n').map_or(0, |i| i + 1);
        let to = self.text[hi..].find('\n').map_or(self.text.len(), |i| hi + i);
        let lines_before = self.text[..from].matches('\n').count();
        let data = &self.text.as_bytes()[from..to];
        let place = SourceSpan::from((self.start + from, to - from));
        let count = self.text[from..to].matches('\n').count() + 1;
        // Without context miette asks for the start of the span; with it, for the lines around the span.
        let left_out = if from == 0 { self.column } else { 0 };
        let column = if before == 0 { left_out + self.text[from..lo].chars().count() } else { 0 };
        let line = self.line + lines_before;
        let contents = MietteSpanContents::new_named(self.name.clone(), data, place, line, column, count);
        Ok(Box::new(contents))
    }
}
