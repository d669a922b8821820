//! Draws messages for a person; the only file that knows miette.

use super::{Diagnostic, Label, Severity};
use crate::source::{FileId, Sources, Span};
use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan,
    SpanContents,
};

/// How to draw.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// With colours and Unicode lines.
    pub fancy: bool,
    /// Columns of the terminal.
    pub width: usize,
}

/// One message as a person sees it, ending in a newline.
pub fn render(diagnostic: &Diagnostic, sources: &Sources, style: Style) -> String {
    let theme = if style.fancy { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
    let handler = GraphicalReportHandler::new_themed(theme).with_width(style.width).with_context_lines(1);
    let mut out = String::new();
    if handler.render_report(&mut out, &Report::new(diagnostic, sources)).is_err() {
        out = format!("{}: {}\n", diagnostic.code, diagnostic.message);
    }
    for step in &diagnostic.trace {
        if let Some(place) = sources.place(step.span) {
            out += &format!("  {} at {}:{}:{}\n", step.text, place.file, place.line, place.column);
        }
    }
    out
}

/// miette's view of a diagnostic.
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
        let local = |span: Span| sources.locate(span).filter(|(id, _)| Some(*id) == file).map(|(_, range)| range);
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
        Self {
            head: format!("{kind}[{}]: {}", d.code, d.message),
            severity: d.severity,
            help: d.help.clone(),
            source: file.map(|id| Lines::new(sources, id, d)),
            labels: d.labels.iter().enumerate().filter_map(label).collect(),
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

/// The lines that a message shows, and where they stand in the file.
#[derive(Debug)]
struct Lines {
    name: String,
    /// From the first to the last line that a label touches.
    text: String,
    /// Local offset of `text`.
    start: usize,
    /// Number of its first line, from 0.
    line: usize,
}

impl Lines {
    fn new(sources: &Sources, file: FileId, d: &Diagnostic) -> Self {
        let text = sources.text(file);
        let ranges: Vec<_> = d
            .labels
            .iter()
            .filter_map(|l| sources.locate(l.span))
            .filter(|(id, _)| *id == file)
            .map(|(_, r)| r)
            .collect();
        let first = ranges.iter().map(|r| r.start).min().unwrap_or(0);
        let last = ranges.iter().map(|r| r.end).max().unwrap_or(0);
        let ends = ['\n', '\r'];
        let start = text[..first].rfind(ends).map_or(0, |i| i + 1);
        let end = text[last..].find(ends).map_or(text.len(), |i| last + i);
        let base = sources.base(file);
        let line = sources.place(Span::new(base + start, base + start)).map_or(1, |p| p.line) - 1;
        Self { name: sources.name(file).into(), text: text[start..end].into(), start, line }
    }
}

impl SourceCode for Lines {
    /// Whole lines, always: miette would cut them to the span where no context is asked for.
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
        // Without context it is asked where the span starts; with it, for the lines around the span.
        let column = if before == 0 { self.text[from..lo].chars().count() } else { 0 };
        let line = self.line + lines_before;
        let contents = MietteSpanContents::new_named(self.name.clone(), data, place, line, column, count);
        Ok(Box::new(contents))
    }
}
