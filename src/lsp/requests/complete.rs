//! Completion: words of the block, names, directives, files.

use super::actions;
use crate::interpreter;
use crate::library;
use crate::lsp::document::Document;
use crate::lsp::files::ReachableText;
use crate::lsp::server::{Client, Server};
use crate::lsp::words;
use crate::syntax::outline::{Declaration, DeclarationKind, TokenKind};
use crate::syntax::word::CONSTANTS;
use crate::value::{ValueKind, WordSpec};
use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionParams, CompletionResponse, Documentation,
    InsertTextFormat, MarkupContent, MarkupKind,
};
use std::path::Path;

/// Minimum number of typed letters for completions of the names that standard include files declare.
const MIN_LETTERS: usize = 2;
/// Maximum number of completions of the names that standard include files declare.
const MAX_NAMES: usize = 100;
/// Largest number of files that are offered.
const MAX_FILES: usize = 2000;

/// Returns the completions at a position of the document.
pub fn complete<S: Client>(server: &mut Server<S>, params: &CompletionParams) -> Option<CompletionResponse> {
    let at = &params.text_document_position;
    let uri = &at.text_document.uri;
    let reached = server.reachable(uri);
    let document = server.document(uri)?;
    let offset = document.text.offset(at.position);
    let items = completions_at(document, &reached, offset)?;
    // Names that begin with other letters are missing.
    Some(CompletionResponse::List(CompletionList { is_incomplete: true, items }))
}

fn completions_at(document: &Document, reached: &[ReachableText], offset: usize) -> Option<Vec<CompletionItem>> {
    let (text, outline) = (document.text.as_str(), &document.outline);
    let before = &text[..offset];
    // A block comment ends at its end, a line comment with its line.
    let comment = outline.comment_at(offset).filter(|comment| comment.start < offset);
    if comment.is_some_and(|comment| offset < comment.end || outline.slice(comment).starts_with("//")) {
        return None;
    }
    let before_offset = &outline.tokens[..outline.first_token_from(offset)];
    let inside = before_offset.last().filter(|token| offset <= token.range.end);
    if let Some(string) = inside.filter(|token| token.kind == TokenKind::String) {
        return Some(path_completions(document, &text[string.range.start + 1..offset]));
    }
    // An unclosed string contains the rest of the file.
    let line = &before[before.rfind(['\n', '\r']).map_or(0, |i| i + 1)..];
    if let (1, Some((_, path))) = (line.matches('"').count() % 2, line.rsplit_once('"')) {
        return Some(path_completions(document, path));
    }
    let typed = &before[before.trim_end_matches(|c: char| c.is_ascii_alphanumeric() || c == '_').len()..];
    if before[..before.len() - typed.len()].trim_end_matches([' ', '\t']).ends_with('#') {
        return Some(directive_completions());
    }
    let block = words::block_name_at(outline, offset);
    let mut out: Vec<_> = words::block_words(block).iter().map(item_of_word).collect();
    let values = words::function_names_arguments_summaries().map(|(name, arguments, summary)| CompletionItem {
        kind: Some(CompletionItemKind::FUNCTION),
        insert_text: Some(format!("{name}($1)$0")),
        insert_text_format: Some(InsertTextFormat::SNIPPET),
        sort_text: Some(format!("3{name}")),
        ..completion_item(name, format!("{name}{arguments}"), summary)
    });
    out.extend(values);
    for (name, what) in CONSTANTS {
        let constant =
            CompletionItem { kind: Some(CompletionItemKind::CONSTANT), ..completion_item(name, String::new(), what) };
        out.push(CompletionItem { sort_text: Some(format!("3{name}")), ..constant });
    }
    let colors = interpreter::COLOR_WORDS.iter().map(item_of_word);
    out.extend(colors.map(|word| CompletionItem { sort_text: Some(format!("2{}", word.label)), ..word }));
    out.extend(visible_name_completions(reached, outline.macro_pair_at(offset)));
    if typed.len() >= MIN_LETTERS {
        out.extend(library_completions(document, &out, typed));
    }
    Some(out)
}

/// Creates a completion with this label; `about` is its documentation as Markdown. Empty texts are left out.
fn completion_item(label: &str, detail: String, about: &str) -> CompletionItem {
    let text = MarkupContent { kind: MarkupKind::Markdown, value: about.to_string() };
    CompletionItem {
        label: label.into(),
        detail: (!detail.is_empty()).then_some(detail),
        documentation: (!about.is_empty()).then_some(Documentation::MarkupContent(text)),
        ..CompletionItem::default()
    }
}

/// Returns the completion for a word that a block takes; shapes and blocks are completed with their braces.
fn item_of_word(taken: &WordSpec) -> CompletionItem {
    let shape = words::shape_spec(taken.name);
    let snippet = match shape {
        Some(spec) if !spec.params.is_empty() => {
            let place = |(i, param): (usize, &crate::value::Param)| format!("${{{}:{}}}", i + 1, param.name);
            let params: Vec<_> = spec.params.iter().enumerate().map(place).collect();
            Some(format!("{} {{ {}$0 }}", taken.name, params.join(", ")))
        }
        Some(_) => Some(format!("{} {{ $0 }}", taken.name)),
        None if taken.kind == ValueKind::Block && !matches!(taken.name, "matrix" | "spline") => {
            Some(format!("{} {{ $0 }}", taken.name))
        }
        None => None,
    };
    let detail = if shape.is_some() { "shape".into() } else { words::kind_description(taken.kind).to_string() };
    CompletionItem {
        kind: Some(if shape.is_some() { CompletionItemKind::CLASS } else { CompletionItemKind::KEYWORD }),
        insert_text_format: snippet.is_some().then_some(InsertTextFormat::SNIPPET),
        insert_text: snippet,
        sort_text: Some(format!("1{}", taken.name)),
        ..completion_item(taken.name, detail, taken.summary)
    }
}

fn directive_completions() -> Vec<CompletionItem> {
    let rows = interpreter::directives::TABLE.iter();
    rows.flat_map(|row| row.names.iter().map(move |name| (name, row)))
        .map(|(name, row)| CompletionItem {
            kind: Some(CompletionItemKind::KEYWORD),
            ..completion_item(name, row.form.to_string(), row.summary)
        })
        .collect()
}

/// Returns completions for the declared names that are visible in the macro `within_macro` of the first text, or outside of
/// macros.
fn visible_name_completions(reached: &[ReachableText], within_macro: Option<usize>) -> Vec<CompletionItem> {
    let mut out: Vec<CompletionItem> = vec![];
    let mut seen = std::collections::HashSet::new();
    for (i, one) in reached.iter().enumerate() {
        let is_seen = |d: &&Declaration| match d.kind {
            DeclarationKind::Declare | DeclarationKind::Macro => true,
            DeclarationKind::Counter | DeclarationKind::Local => {
                i == 0 && (d.scope.is_none() || d.scope == within_macro)
            }
            DeclarationKind::Parameter => i == 0 && d.scope == within_macro,
        };
        for d in one.outline.declarations.iter().filter(is_seen) {
            if !seen.insert(d.name.as_str()) {
                continue;
            }
            let file = one
                .path
                .as_deref()
                .filter(|_| i > 0)
                .and_then(Path::file_name)
                .map(|name| name.to_string_lossy().into_owned());
            out.push(item_of_name(one, d, file.unwrap_or_default()));
        }
    }
    out
}

fn item_of_name(one: &ReachableText, d: &Declaration, file: String) -> CompletionItem {
    let parameters = macro_parameters(one, d);
    let snippet = parameters.as_ref().map(|parameters| {
        let place = |(i, name): (usize, &String)| format!("${{{}:{name}}}", i + 1);
        format!("{}({})", d.name, parameters.iter().enumerate().map(place).collect::<Vec<_>>().join(", "))
    });
    let detail = parameters.map_or(file.clone(), |parameters| format!("({}) {file}", parameters.join(", ")));
    CompletionItem {
        kind: Some(if d.kind == DeclarationKind::Macro {
            CompletionItemKind::METHOD
        } else {
            CompletionItemKind::VARIABLE
        }),
        insert_text_format: snippet.is_some().then_some(InsertTextFormat::SNIPPET),
        insert_text: snippet,
        sort_text: Some(format!("{}{}", if file.is_empty() { '0' } else { '4' }, d.name)),
        ..completion_item(&d.name, detail.trim().to_string(), "")
    }
}

/// Returns the parameter names of a declared macro; `None` if the declaration is not that of a macro.
pub fn macro_parameters(one: &ReachableText, d: &Declaration) -> Option<Vec<String>> {
    (d.kind == DeclarationKind::Macro).then(|| one.outline.parameters(d).map(String::from).collect())
}

/// Returns completions for the names that standard include files declare and the document does not know yet; each also
/// adds the `#include` of its file.
fn library_completions(document: &Document, known: &[CompletionItem], typed: &str) -> Vec<CompletionItem> {
    let lower = typed.to_lowercase();
    let fits = |name: &&str| name.to_lowercase().starts_with(&lower) && !known.iter().any(|item| item.label == **name);
    let item = |name: &str| {
        let file = library::standard_file_of(name)?;
        Some(CompletionItem {
            kind: Some(CompletionItemKind::VARIABLE),
            sort_text: Some(format!("5{name}")),
            additional_text_edits: Some(vec![actions::insert_include(document, file)]),
            ..completion_item(name, format!("from {file}; adds its #include"), "")
        })
    };
    library::standard_names().filter(fits).take(MAX_NAMES).filter_map(item).collect()
}

/// Returns completions of a typed path: the files and folders of the typed folder, relative to the document's folder;
/// without a typed folder also the standard include files.
fn path_completions(document: &Document, typed: &str) -> Vec<CompletionItem> {
    let (folder, _) = typed.rsplit_once('/').unwrap_or(("", typed));
    let place = document.folder().join(folder);
    let mut out = vec![];
    for entry in std::fs::read_dir(place).into_iter().flatten().flatten().take(MAX_FILES) {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with('.') {
            continue;
        }
        let is_folder = entry.path().is_dir();
        let kind = if is_folder { CompletionItemKind::FOLDER } else { CompletionItemKind::FILE };
        out.push(CompletionItem { kind: Some(kind), ..completion_item(&name, String::new(), "") });
    }
    if folder.is_empty() {
        let standard = library::builtin_file_names().map(|name| CompletionItem {
            kind: Some(CompletionItemKind::FILE),
            ..completion_item(name, "standard include file".into(), "")
        });
        out.extend(standard);
    }
    out.sort_by(|a, b| a.label.cmp(&b.label));
    out
}
