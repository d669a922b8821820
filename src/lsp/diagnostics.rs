//! Diagnostics in the form of the protocol.

use super::document::{BASE, uri_of};
use super::manual;
use super::text::Text;
use crate::diagnostic::{Diagnostic, Label, Remedy, Severity, codes};
use crate::source::{FileId, Sources};
use lsp_types::{
    CodeDescription, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, Location, NumberOrString, Range,
    Uri,
};
use serde_json::json;

/// Diagnostic in the form of the Language Server Protocol.
pub type EditorDiagnostic = lsp_types::Diagnostic;

/// Converts a diagnostic of a scene's run to one of the Language Server Protocol; its first label is in `file`.
pub fn from_run_diagnostic(diagnostic: &Diagnostic, sources: &Sources, file: FileId) -> EditorDiagnostic {
    let text = |id: FileId| Text::new(sources.text(id).to_string());
    let range = match sources.locate(diagnostic.span()) {
        Some((id, bytes)) if id == file => text(id).range(bytes),
        _ => Range::default(),
    };
    let related = |label: &Label| {
        let (id, bytes) = sources.locate(label.span)?;
        let location = Location { uri: uri_of(sources.path(id)?)?, range: text(id).range(bytes) };
        let message = if label.text.is_empty() { "here".to_string() } else { label.text.clone() };
        Some(DiagnosticRelatedInformation { location, message })
    };
    let places = diagnostic.labels.iter().skip(1).chain(&diagnostic.trace);
    convert(diagnostic, range, places.filter_map(related).collect())
}

/// Returns the hint that the editor shows at a branch of `#if` or `#switch` that did not run.
pub fn idle_branch_hint(sources: &Sources, file: FileId, bytes: std::ops::Range<usize>) -> EditorDiagnostic {
    EditorDiagnostic {
        range: Text::new(sources.text(file).to_string()).range(bytes),
        severity: Some(DiagnosticSeverity::HINT),
        source: Some("durer".into()),
        message: "this did not run".into(),
        tags: Some(vec![DiagnosticTag::UNNECESSARY]),
        ..EditorDiagnostic::default()
    }
}

/// Converts a syntax fault of an open document to a diagnostic of the Language Server Protocol.
pub fn from_syntax_fault(fault: &Diagnostic, text: &Text, uri: &Uri) -> EditorDiagnostic {
    let local = |place: u32| (place as usize).saturating_sub(BASE);
    let range = |label: &Label| text.range(local(label.span.lo)..local(label.span.hi));
    let related = fault.labels.iter().skip(1).map(|label| DiagnosticRelatedInformation {
        location: Location { uri: uri.clone(), range: range(label) },
        message: label.text.clone(),
    });
    convert(fault, fault.labels.first().map(range).unwrap_or_default(), related.collect())
}

fn convert(d: &Diagnostic, range: Range, related: Vec<DiagnosticRelatedInformation>) -> EditorDiagnostic {
    let label = d.labels.first().map(|label| label.text.as_str()).filter(|text| !text.is_empty());
    let help = d.help.as_ref().map(|help| format!("help: {help}"));
    let message =
        [Some(d.message.clone()), label.map(String::from), help].into_iter().flatten().collect::<Vec<_>>().join("\n");
    let include = d.missing_names.as_ref().and_then(|names| match names.remedy {
        Remedy::Include(file) => Some(file),
        Remedy::Declare => None,
    });
    let unused = d.code == codes::UNUSED_NAME;
    EditorDiagnostic {
        range,
        severity: Some(match d.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            // A hint is shown in a faint colour: the text may just be being typed.
            Severity::Warning if unused || d.code == codes::NOT_PORTABLE => DiagnosticSeverity::HINT,
            Severity::Warning => DiagnosticSeverity::WARNING,
        }),
        code: Some(NumberOrString::String(d.code.0.into())),
        code_description: manual::code_address(d.code.0).map(|href| CodeDescription { href }),
        source: Some("durer".into()),
        message,
        related_information: (!related.is_empty()).then_some(related),
        tags: unused.then(|| vec![DiagnosticTag::UNNECESSARY]),
        data: Some(json!({"help": d.help, "include": include})),
    }
}

/// Moves the diagnostics of a run after a change of the text that replaced `bytes` by `new_length` bytes. Diagnostics that
/// touch the change are removed.
pub fn diagnostics_after_change(
    diagnostics: Vec<EditorDiagnostic>,
    before: &Text,
    after: &Text,
    bytes: &std::ops::Range<usize>,
    new_length: usize,
) -> Vec<EditorDiagnostic> {
    let shift = |offset: usize| offset - bytes.len() + new_length;
    let shifted = |mut d: EditorDiagnostic| {
        let (lo, hi) = (before.offset(d.range.start), before.offset(d.range.end));
        d.range = match () {
            () if hi < bytes.start => d.range,
            () if lo > bytes.end || lo == bytes.end && bytes.is_empty() => after.range(shift(lo)..shift(hi)),
            () => return None,
        };
        Some(d)
    };
    diagnostics.into_iter().filter_map(shifted).collect()
}
