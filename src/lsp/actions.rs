//! What a message's help says, done.

use super::commands::EXPLAIN;
use super::diagnostics::Told;
use super::document::Document;
use super::scan::{Kind, Token, directive};
use super::server::{Out, Server};
use crate::syntax::MISSING_SEMICOLON;
use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, CodeActionResponse, Command,
    DiagnosticRelatedInformation, NumberOrString, Range, TextEdit, WorkspaceEdit,
};
use std::collections::HashMap;

/// Statements are looked for among so many words of a line.
const WORDS: usize = 100;

/// For each message that the editor shows here.
pub fn actions<S: Out>(server: &mut Server<S>, params: &CodeActionParams) -> Option<CodeActionResponse> {
    let uri = &params.text_document.uri;
    let document = server.document(uri)?;
    let known = server.told(uri.as_str());
    let mut out: CodeActionResponse = vec![];
    for told in &params.context.diagnostics {
        // Not every editor gives back what it was given.
        let told = if told.data.is_some() {
            told
        } else {
            known.iter().find(|one| one.range == told.range && one.code == told.code).unwrap_or(told)
        };
        for (title, edits) in remedies(document, told) {
            let changes = HashMap::from([(uri.clone(), edits)]);
            let action = CodeAction {
                title,
                kind: Some(CodeActionKind::QUICKFIX),
                diagnostics: Some(vec![told.clone()]),
                edit: Some(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }),
                is_preferred: Some(true),
                ..CodeAction::default()
            };
            out.push(CodeActionOrCommand::CodeAction(action));
        }
        if let Some(NumberOrString::String(code)) = &told.code {
            let title = format!("Explain {code}");
            let command = Command::new(title.clone(), EXPLAIN.into(), Some(vec![code.clone().into()]));
            let diagnostics = Some(vec![told.clone()]);
            let action = CodeAction { title, diagnostics, command: Some(command), ..CodeAction::default() };
            out.push(CodeActionOrCommand::CodeAction(action));
        }
    }
    Some(out)
}

/// What can be done, and the edits that do it.
fn remedies(document: &Document, told: &Told) -> Vec<(String, Vec<TextEdit>)> {
    let mut out = vec![];
    let data = |name: &str| told.data.as_ref().and_then(|data| data.get(name)).and_then(|value| value.as_str());
    let named = || data("help")?.strip_prefix("add `#include \"")?.split_once('"').map(|(file, _)| file);
    if let Some(file) = data("include").or_else(named) {
        out.push((format!("Include \"{file}\""), vec![include(document, file)]));
    }
    let Some(help) = data("help") else { return out };
    // "did you mean `sphere`?", "write `#elseif`"
    for begin in ["did you mean `", "write `"] {
        let word = help.strip_prefix(begin).and_then(|rest| rest.split_once('`')).map(|(word, _)| word);
        let is_word =
            |word: &&str| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '#'));
        if let Some(word) = word.filter(is_word) {
            let edit = TextEdit { range: told.range, new_text: word.to_string() };
            out.push((format!("Write `{word}`"), vec![edit]));
        }
    }
    if help == "remove it" {
        out.push(("Remove it".into(), vec![TextEdit { range: told.range, new_text: String::new() }]));
    }
    let written = wrapped(document, told, help).or_else(|| statement(document, told, help));
    out.extend(written);
    out.extend(separated(told));
    out.extend(missing(document, help));
    out
}

/// "write `object { Ball … }`" and "write `texture { Oak }`": what the message is about, or it and what stands in braces behind it, in a
/// block.
fn wrapped(document: &Document, told: &Told, help: &str) -> Option<(String, Vec<TextEdit>)> {
    let code = help.strip_prefix("write `")?.strip_suffix('`')?;
    let bytes = document.text.offset(told.range.start)..document.text.offset(told.range.end);
    let name = document.text.as_str().get(bytes.clone()).filter(|name| !name.is_empty())?;
    let (word, inside) = code.split_once(" { ")?;
    if !word.bytes().all(|b| b.is_ascii_lowercase() || b == b'_') {
        return None;
    }
    let at = |position| Range::new(position, position);
    let open = TextEdit { range: at(told.range.start), new_text: format!("{word} {{ ") };
    let rest = inside.strip_prefix(name)?.strip_suffix('}')?.trim();
    let second = if rest.is_empty() {
        TextEdit { range: at(told.range.end), new_text: " }".into() }
    } else {
        // Its own brace goes, and the other one closes the block.
        let next =
            document.scan.tokens.iter().find(|token| token.at.start >= bytes.end && token.kind != Kind::Comment)?;
        let is_brace = document.text.as_str().get(next.at.clone()) == Some("{");
        is_brace.then(|| TextEdit { range: document.text.range(bytes.end..next.at.end), new_text: String::new() })?
    };
    Some((format!("Write `{code}`"), vec![open, second]))
}

/// "write `object { Ball translate x }`": the statement that is to be written so is what stands around the place, word by word.
fn statement(document: &Document, told: &Told, help: &str) -> Option<(String, Vec<TextEdit>)> {
    let (_, rest) = help.split_once("write `")?;
    let wanted = rest.strip_suffix('`')?;
    if !["object {", "#declare "].iter().any(|begin| wanted.starts_with(begin)) || wanted.contains(['…', '`']) {
        return None;
    }
    let (text, tokens) = (document.text.as_str(), &document.scan.tokens);
    let (lo, hi) = (document.text.offset(told.range.start), document.text.offset(told.range.end));
    let line = document.text.position(lo).line;
    let is_here = |token: &&Token| document.text.position(token.at.start).line == line && token.kind != Kind::Comment;
    let here: Vec<_> = tokens.iter().filter(is_here).take(WORDS).collect();
    let told_of = |token: &Token| lo <= token.at.start && token.at.end <= hi;
    // The longest row of tokens around the place that stands in the wanted text; what the message is about may be missing there.
    let stands = |row: &[&Token]| {
        let mut left = wanted;
        row.iter().all(|token| match left.split_once(&text[token.at.clone()]) {
            Some((_, behind)) => {
                left = behind;
                true
            }
            None => told_of(token),
        })
    };
    let about = here.iter().position(|token| told_of(token))?;
    let rows = (0..=about).flat_map(|first| (about + 1..=here.len()).map(move |end| first..end));
    let best = rows.filter(|row| stands(&here[row.clone()])).max_by_key(|row| (row.len(), row.start))?;
    let begins = best.start == 0 || matches!(&text[here[best.start - 1].at.clone()], "}" | ";");
    let bytes = here[best.start].at.start..here[best.end - 1].at.end;
    let edit = TextEdit { range: document.text.range(bytes), new_text: wanted.to_string() };
    begins.then(|| (format!("Write `{wanted}`"), vec![edit]))
}

fn line_end(document: &Document) -> &'static str {
    if document.text.as_str().contains("\r\n") { "\r\n" } else { "\n" }
}

fn on_a_new_line(document: &Document) -> &'static str {
    if document.text.as_str().ends_with(['\n', '\r']) { "" } else { line_end(document) }
}

/// The first byte behind comments, `#version` and `#include`s, where a line begins.
fn first_line(document: &Document) -> usize {
    let (text, scan) = (&document.text, &document.scan);
    let all = text.as_str();
    let head = |token: &&Token| {
        token.kind == Kind::Comment
            || token.kind == Kind::Directive && matches!(directive(&all[token.at.clone()]), "version" | "include")
    };
    let of_head = |line: u32| scan.tokens.iter().filter(head).any(|token| text.position(token.at.start).line == line);
    let first = scan.tokens.iter().map(|token| text.position(token.at.start).line).find(|line| !of_head(*line));
    first.map_or(all.len(), |line| text.offset(lsp_types::Position::new(line, 0)))
}

/// What is missing as a whole: the closer of what is open, or a camera.
fn missing(document: &Document, help: &str) -> Option<(String, Vec<TextEdit>)> {
    let text = &document.text;
    let insert = |offset: usize, new_text: String| {
        let at = text.position(offset);
        vec![TextEdit { range: Range::new(at, at), new_text }]
    };
    if let Some((closer, _)) = help.strip_prefix("add `").and_then(|rest| rest.split_once("` where it should end")) {
        let edit = insert(text.as_str().len(), format!("{}{closer}", on_a_new_line(document)));
        return Some((format!("Add `{closer}` at the end"), edit));
    }
    let camera = help.strip_prefix('`')?.strip_suffix('`').filter(|code| code.starts_with("camera {"))?;
    Some(("Add a camera".into(), insert(first_line(document), format!("{camera}{}", line_end(document)))))
}

/// A missing `;`: its place is told beside the message.
fn separated(told: &Told) -> Option<(String, Vec<TextEdit>)> {
    let is_it = |place: &&DiagnosticRelatedInformation| place.message == MISSING_SEMICOLON;
    let place = told.related_information.iter().flatten().find(is_it)?;
    let at = place.location.range.end;
    Some(("Write `;`".into(), vec![TextEdit { range: Range::new(at, at), new_text: ";".into() }]))
}

/// Adds an `#include`: behind the last one that stands at the top, or behind `#version`, or below the comment that begins the text.
pub fn include(document: &Document, file: &str) -> TextEdit {
    let (text, scan) = (&document.text, &document.scan);
    let all = text.as_str();
    let is = |token: &&super::scan::Token, word: &str| {
        token.kind == Kind::Directive && directive(&all[token.at.clone()]) == word
    };
    let last = scan.pairs.first().map_or(all.len(), |pair| pair.whole.start);
    let include = scan.includes.iter().rev().map(|(_, at)| at.end).find(|end| *end < last);
    let version = || scan.tokens.iter().find(|token| is(token, "version")).map(|token| token.at.end);
    let comment = || {
        let first = scan.tokens.iter().position(|token| token.kind != Kind::Comment).unwrap_or(scan.tokens.len());
        scan.tokens[..first].last().map(|token| all[..token.at.end].trim_end().len())
    };
    let line = include.or_else(version).or_else(comment).map_or(0, |end| text.position(end).line + 1);
    let end = line_end(document);
    let missing = line as usize >= text.line_count();
    let at = if missing { text.position(all.len()) } else { lsp_types::Position::new(line, 0) };
    let new_text = if missing { format!("{end}#include \"{file}\"{end}") } else { format!("#include \"{file}\"{end}") };
    TextEdit { range: Range::new(at, at), new_text }
}
