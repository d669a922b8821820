//! Draws messages for a person; the only file that knows miette.

use super::{Diagnostic, Label, Severity};
use crate::source::{Sources, Span};
use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource};

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
    let handler = GraphicalReportHandler::new_themed(theme).with_width(style.width).with_context_lines(0);
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
    source: Option<NamedSource<String>>,
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
            source: file.map(|id| NamedSource::new(sources.name(id), sources.text(id).to_string())),
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
