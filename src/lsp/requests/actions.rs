//! Code actions: apply the help of a diagnostic.

use super::commands::EXPLAIN;
use crate::lsp::diagnostics::EditorDiagnostic;
use crate::lsp::document::Document;
use crate::lsp::server::{Client, Server};
use crate::syntax::MISSING_SEMICOLON;
use crate::syntax::outline::Token;
use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, CodeActionResponse, Command,
    DiagnosticRelatedInformation, NumberOrString, Range, TextEdit, WorkspaceEdit,
};
use std::collections::{HashMap, HashSet};

/// Largest number of tokens of a line in which a statement is searched.
const MAX_TOKENS: usize = 100;

/// Returns the code actions for the diagnostics at a position.
pub fn actions<S: Client>(server: &mut Server<S>, params: &CodeActionParams) -> Option<CodeActionResponse> {
    let uri = &params.text_document.uri;
    let document = server.document(uri)?;
    let known = server.diagnostics_from_runs(uri.as_str());
    let mut out: CodeActionResponse = vec![];
    for diagnostic in &params.context.diagnostics {
        // Some editors do not return the data of a diagnostic.
        let diagnostic = if diagnostic.data.is_some() {
            diagnostic
        } else {
            known.iter().find(|one| one.range == diagnostic.range && one.code == diagnostic.code).unwrap_or(diagnostic)
        };
        for (title, edits) in remedies(document, diagnostic) {
            let changes = HashMap::from([(uri.clone(), edits)]);
            let action = CodeAction {
                title,
                kind: Some(CodeActionKind::QUICKFIX),
                diagnostics: Some(vec![diagnostic.clone()]),
                edit: Some(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }),
                is_preferred: Some(true),
                ..CodeAction::default()
            };
            out.push(CodeActionOrCommand::CodeAction(action));
        }
        if let Some(NumberOrString::String(code)) = &diagnostic.code {
            let title = format!("Explain {code}");
            let command = Command::new(title.clone(), EXPLAIN.into(), Some(vec![code.clone().into()]));
            let diagnostics = Some(vec![diagnostic.clone()]);
            let action = CodeAction { title, diagnostics, command: Some(command), ..CodeAction::default() };
            out.push(CodeActionOrCommand::CodeAction(action));
        }
    }
    Some(out)
}

/// Returns the titles and edits of the code actions that follow from the help of a diagnostic.
fn remedies(document: &Document, diagnostic: &EditorDiagnostic) -> Vec<(String, Vec<TextEdit>)> {
    let mut out = vec![];
    let data = |name: &str| diagnostic.data.as_ref().and_then(|data| data.get(name)).and_then(|value| value.as_str());
    let named = || data("help")?.strip_prefix("add `#include \"")?.split_once('"').map(|(file, _)| file);
    if let Some(file) = data("include").or_else(named) {
        out.push((format!("Include \"{file}\""), vec![insert_include(document, file)]));
    }
    let Some(help) = data("help") else { return out };
    // "did you mean `sphere`?", "write `#elseif`"
    for begin in ["did you mean `", "write `"] {
        let word = help.strip_prefix(begin).and_then(|rest| rest.split_once('`')).map(|(word, _)| word);
        let is_word =
            |word: &&str| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '#'));
        if let Some(word) = word.filter(is_word) {
            let edit = TextEdit { range: diagnostic.range, new_text: word.to_string() };
            out.push((format!("Write `{word}`"), vec![edit]));
        }
    }
    if help == "remove it" {
        out.push(("Remove it".into(), vec![TextEdit { range: diagnostic.range, new_text: String::new() }]));
    }
    let written = wrap_in_block(document, diagnostic, help).or_else(|| replace_statement(document, diagnostic, help));
    out.extend(written);
    out.extend(insert_semicolon(diagnostic));
    out.extend(insert_missing(document, help));
    out
}

/// Returns the code action, as its title and edits, for help of the form "write `object { Ball … }`": puts the marked
/// name, or the name and the following braces, into a block.
fn wrap_in_block(document: &Document, diagnostic: &EditorDiagnostic, help: &str) -> Option<(String, Vec<TextEdit>)> {
    let code = help.strip_prefix("write `")?.strip_suffix('`')?;
    let bytes = document.text.offset(diagnostic.range.start)..document.text.offset(diagnostic.range.end);
    let name = document.text.as_str().get(bytes.clone()).filter(|name| !name.is_empty())?;
    let (word, inside) = code.split_once(" { ")?;
    if !word.bytes().all(|b| b.is_ascii_lowercase() || b == b'_') {
        return None;
    }
    let at = |position| Range::new(position, position);
    let open = TextEdit { range: at(diagnostic.range.start), new_text: format!("{word} {{ ") };
    let rest = inside.strip_prefix(name)?.strip_suffix('}')?.trim();
    let second = if rest.is_empty() {
        TextEdit { range: at(diagnostic.range.end), new_text: " }".into() }
    } else {
        // Remove the opening brace; the closing one then ends the block.
        let next = document.outline.tokens.get(document.outline.first_token_from(bytes.end))?;
        let is_brace = document.outline.slice(&next.range) == "{";
        is_brace.then(|| TextEdit { range: document.text.range(bytes.end..next.range.end), new_text: String::new() })?
    };
    Some((format!("Write `{code}`"), vec![open, second]))
}

/// Returns the code action, as its title and edits, for help of the form "write `object { Ball translate x }`":
/// replaces the statement around the position whose tokens occur in that text.
fn replace_statement(
    document: &Document,
    diagnostic: &EditorDiagnostic,
    help: &str,
) -> Option<(String, Vec<TextEdit>)> {
    let (_, rest) = help.split_once("write `")?;
    let wanted = rest.strip_suffix('`')?;
    if !["object {", "#declare "].iter().any(|begin| wanted.starts_with(begin)) || wanted.contains(['…', '`']) {
        return None;
    }
    let outline = &document.outline;
    let (lo, hi) = (document.text.offset(diagnostic.range.start), document.text.offset(diagnostic.range.end));
    let line = document.text.position(lo).line;
    let is_here = |token: &&Token| document.text.position(token.range.start).line == line;
    let here: Vec<_> = outline.tokens.iter().filter(is_here).take(MAX_TOKENS).collect();
    let is_marked = |token: &Token| lo <= token.range.start && token.range.end <= hi;
    // Find the longest row of tokens around the position that occurs in the wanted text; marked tokens may be missing
    // there.
    let occurs = |row: &[&Token]| {
        let mut left = wanted;
        row.iter().all(|token| match left.split_once(outline.slice(&token.range)) {
            Some((_, after)) => {
                left = after;
                true
            }
            None => is_marked(token),
        })
    };
    let about = here.iter().position(|token| is_marked(token))?;
    let rows = (0..=about).flat_map(|first| (about + 1..=here.len()).map(move |end| first..end));
    let best = rows.filter(|row| occurs(&here[row.clone()])).max_by_key(|row| (row.len(), row.start))?;
    let begins = best.start == 0 || matches!(outline.slice(&here[best.start - 1].range), "}" | ";");
    let bytes = here[best.start].range.start..here[best.end - 1].range.end;
    let edit = TextEdit { range: document.text.range(bytes), new_text: wanted.to_string() };
    begins.then(|| (format!("Write `{wanted}`"), vec![edit]))
}

fn line_ending(document: &Document) -> &'static str {
    if document.text.as_str().contains("\r\n") { "\r\n" } else { "\n" }
}

fn line_ending_if_missing(document: &Document) -> &'static str {
    if document.text.as_str().ends_with(['\n', '\r']) { "" } else { line_ending(document) }
}

/// Returns the byte offset of the first line of the scene that is no comment, `#version` or `#include`; the length of a
/// text without such a line.
fn first_scene_line_offset(document: &Document) -> usize {
    let (text, outline) = (&document.text, &document.outline);
    let is_head = |token: &&Token| matches!(outline.directive_word(token), "version" | "include");
    let directives = outline.tokens.iter().filter(is_head).map(|token| token.range.start);
    let heads = directives.chain(outline.comments.iter().map(|comment| comment.start));
    let lines: HashSet<u32> = heads.map(|start| text.position(start).line).collect();
    let first =
        outline.tokens.iter().map(|token| text.position(token.range.start).line).find(|line| !lines.contains(line));
    first.map_or(text.as_str().len(), |line| text.offset(lsp_types::Position::new(line, 0)))
}

/// Returns the code action, as its title and edits, that inserts missing text: a closing bracket or `#end` at the end,
/// or a camera. `None` for other help.
fn insert_missing(document: &Document, help: &str) -> Option<(String, Vec<TextEdit>)> {
    let text = &document.text;
    let insert = |offset: usize, new_text: String| {
        let at = text.position(offset);
        vec![TextEdit { range: Range::new(at, at), new_text }]
    };
    if let Some((closer, _)) = help.strip_prefix("add `").and_then(|rest| rest.split_once("` where it should end")) {
        let edit = insert(text.as_str().len(), format!("{}{closer}", line_ending_if_missing(document)));
        return Some((format!("Add `{closer}` at the end"), edit));
    }
    let camera = help.strip_prefix('`')?.strip_suffix('`').filter(|code| code.starts_with("camera {"))?;
    Some((
        "Add a camera".into(),
        insert(first_scene_line_offset(document), format!("{camera}{}", line_ending(document))),
    ))
}

/// Returns the code action, as its title and edits, that inserts a missing `;` at the related position of the diagnostic;
/// `None` for other diagnostics.
fn insert_semicolon(diagnostic: &EditorDiagnostic) -> Option<(String, Vec<TextEdit>)> {
    let is_it = |place: &&DiagnosticRelatedInformation| place.message == MISSING_SEMICOLON;
    let place = diagnostic.related_information.iter().flatten().find(is_it)?;
    let at = place.location.range.end;
    Some(("Write `;`".into(), vec![TextEdit { range: Range::new(at, at), new_text: ";".into() }]))
}

/// Returns the edit that adds an `#include` after the last one at the top, or after `#version`, or below the first
/// comment, or else in the first line.
pub fn insert_include(document: &Document, file: &str) -> TextEdit {
    let (text, outline) = (&document.text, &document.outline);
    let all = text.as_str();
    let last = outline.pairs.iter().find(|pair| pair.bracket != b'<');
    let last = last.map_or(all.len(), |pair| pair.range.start);
    let include = outline.includes.iter().rev().map(|include| include.end).find(|end| *end < last);
    let is_version = |token: &&Token| outline.directive_word(token) == "version";
    let version = || outline.tokens.iter().find(is_version).map(|token| token.range.end);
    let comment = || {
        let first = outline.tokens.first().map_or(all.len(), |token| token.range.start);
        let last = outline.comments.iter().take_while(|comment| comment.end <= first).last();
        last.map(|comment| all[..comment.end].trim_end().len())
    };
    let line = include.or_else(version).or_else(comment).map_or(0, |end| text.position(end).line + 1);
    let end = line_ending(document);
    let missing = line as usize >= text.line_count();
    let at = if missing { text.position(all.len()) } else { lsp_types::Position::new(line, 0) };
    let new_text = if missing { format!("{end}#include \"{file}\"{end}") } else { format!("#include \"{file}\"{end}") };
    TextEdit { range: Range::new(at, at), new_text }
}
