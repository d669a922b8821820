//! What a message's help says, done.

use super::diagnostics::Told;
use super::document::Document;
use super::scan::{Kind, directive};
use super::server::{Out, Server};
use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, CodeActionResponse, Range, TextEdit,
    WorkspaceEdit,
};
use std::collections::HashMap;

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
        for (title, edit) in remedies(document, told) {
            let changes = HashMap::from([(uri.clone(), vec![edit])]);
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
    }
    Some(out)
}

/// What can be done, and the edit that does it.
fn remedies(document: &Document, told: &Told) -> Vec<(String, TextEdit)> {
    let mut out = vec![];
    let data = |name: &str| told.data.as_ref().and_then(|data| data.get(name)).and_then(|value| value.as_str());
    if let Some(file) = data("include") {
        out.push((format!("Include \"{file}\""), include(document, file)));
    }
    let Some(help) = data("help") else { return out };
    // "did you mean `sphere`?", "write `#elseif`"
    for begin in ["did you mean `", "write `"] {
        let word = help.strip_prefix(begin).and_then(|rest| rest.split_once('`')).map(|(word, _)| word);
        let is_word =
            |word: &&str| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '#'));
        if let Some(word) = word.filter(is_word) {
            let edit = TextEdit { range: told.range, new_text: word.to_string() };
            out.push((format!("Write `{word}`"), edit));
        }
    }
    if help == "remove it" {
        out.push(("Remove it".into(), TextEdit { range: told.range, new_text: String::new() }));
    }
    out
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
    let end = if all.contains("\r\n") { "\r\n" } else { "\n" };
    let missing = line as usize >= text.line_count();
    let at = if missing { text.position(all.len()) } else { lsp_types::Position::new(line, 0) };
    let new_text = if missing { format!("{end}#include \"{file}\"{end}") } else { format!("#include \"{file}\"{end}") };
    TextEdit { range: Range::new(at, at), new_text }
}
