//! Declarations and uses of a name in a text and its includes; renaming.

use crate::library;
use crate::lsp::files::ReachableText;
use crate::lsp::server::{Client, Server};
use crate::syntax::outline::{DeclarationKind, TokenKind};
use crate::syntax::word::entry;
use lsp_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, GotoDefinitionParams, GotoDefinitionResponse,
    Location, Position, PrepareRenameResponse, Range, ReferenceParams, RenameParams, TextDocumentPositionParams,
    TextEdit, Uri, WorkspaceEdit,
};
use std::collections::HashMap;

/// The declared name at a position of the document.
struct Named {
    name: String,
    range: Range,
    /// Index of the macro of this text that declares the name.
    declaring_macro_pair: Option<usize>,
}

/// Returns the name at a position of an open text, declared or not; `None` at other tokens.
fn name_at<S: Client>(server: &Server<S>, uri: &Uri, at: Position) -> Option<Named> {
    let document = server.document(uri)?;
    let offset = document.text.offset(at);
    let outline = &document.outline;
    let token = outline.token_at(offset).filter(|token| token.kind == TokenKind::Name)?;
    let name = outline.slice(&token.range).to_string();
    // The declaration of a parameter is inside of its macro, too.
    let declaring_macro_pair = outline.declaring_macro_pair(&name, outline.macro_pair_at(token.range.end));
    Some(Named { name, range: document.text.range(token.range.clone()), declaring_macro_pair })
}

/// One occurrence of a name in a scene's texts.
struct Occurrence {
    range: Range,
    declares: bool,
}

/// Returns all occurrences of a name in a text. A parameter or local name of a macro has occurrences only in the text
/// of the macro, which is the text of the request (`is_requesting_text`).
fn occurrences(reached: &ReachableText, named: &Named, is_requesting_text: bool) -> Vec<Occurrence> {
    let (outline, text) = (&reached.outline, &reached.text);
    if named.declaring_macro_pair.is_some() && !is_requesting_text {
        return vec![];
    }
    let belongs = |scope| outline.declaring_macro_pair(&named.name, scope) == named.declaring_macro_pair;
    let declared = outline.declarations.iter().filter(|d| d.name == named.name && belongs(d.scope));
    let used = outline.uses.iter().filter(|one| outline.slice(&one.range) == named.name && belongs(one.scope));
    let mut out: Vec<Occurrence> = declared
        .map(|d| Occurrence { range: text.range(d.range.clone()), declares: true })
        .chain(used.map(|one| Occurrence { range: text.range(one.range.clone()), declares: false }))
        .collect();
    out.sort_by_key(|hit| hit.range.start);
    out
}

/// Returns all occurrences of a name in all related texts, by text; texts without an occurrence are omitted.
fn related_occurrences<S: Client>(
    server: &mut Server<S>,
    uri: &Uri,
    named: &Named,
) -> Vec<(Uri, ReachableText, Vec<Occurrence>)> {
    let own = server.document(uri).map(|document| document.path.clone());
    let related = server.texts_sharing_names(uri);
    let mut out = vec![];
    for reached in related {
        let is_own = own.as_ref() == Some(&reached.path);
        let found = occurrences(&reached, named, is_own);
        let address = if is_own { Some(uri.clone()) } else { server.uri_of_reached(&reached, uri) };
        if let (Some(address), false) = (address, found.is_empty()) {
            out.push((address, reached, found));
        }
    }
    out
}

/// Returns all declarations of the name at a position, or the file of an `#include`.
pub fn definition<S: Client>(server: &mut Server<S>, params: &GotoDefinitionParams) -> Option<GotoDefinitionResponse> {
    let TextDocumentPositionParams { text_document, position } = &params.text_document_position_params;
    let uri = &text_document.uri;
    if let Some(file) = included_file_at(server, uri, *position) {
        return Some(GotoDefinitionResponse::Scalar(Location { uri: file, range: Range::default() }));
    }
    let named = name_at(server, uri, *position)?;
    let all = related_occurrences(server, uri, &named).into_iter().flat_map(|(uri, _, hits)| {
        hits.into_iter().filter(|hit| hit.declares).map(move |hit| Location { uri: uri.clone(), range: hit.range })
    });
    Some(GotoDefinitionResponse::Array(all.collect()))
}

/// Returns the file that an `#include` at a position names; `None` at any other name of a file.
fn included_file_at<S: Client>(server: &mut Server<S>, uri: &Uri, at: Position) -> Option<Uri> {
    let document = server.document(uri)?;
    let offset = document.text.offset(at);
    // (Or one of its quotes.)
    let contains = |name: &&std::ops::Range<usize>| (name.start - 1..=name.end).contains(&offset);
    let name = document.outline.slice(document.outline.includes.iter().find(contains)?);
    let search = crate::source::SearchPath::new(&document.folder(), &server.include);
    crate::lsp::document::uri_of(&crate::lsp::files::find_included_file(name, &document.folder(), &search)?)
}

/// Returns all occurrences of the name at a position of the document.
pub fn references<S: Client>(server: &mut Server<S>, params: &ReferenceParams) -> Option<Vec<Location>> {
    let at = &params.text_document_position;
    let named = name_at(server, &at.text_document.uri, at.position)?;
    let declares = params.context.include_declaration;
    let all = related_occurrences(server, &at.text_document.uri, &named).into_iter().flat_map(|(uri, _, hits)| {
        hits.into_iter()
            .filter(move |hit| declares || !hit.declares)
            .map(move |hit| Location { uri: uri.clone(), range: hit.range })
    });
    Some(all.collect())
}

/// Returns all occurrences in the document of the name at a position.
pub fn highlights<S: Client>(
    server: &mut Server<S>,
    params: &DocumentHighlightParams,
) -> Option<Vec<DocumentHighlight>> {
    let TextDocumentPositionParams { text_document, position } = &params.text_document_position_params;
    let named = name_at(server, &text_document.uri, *position)?;
    let own = server.reachable(&text_document.uri).into_iter().next()?;
    let kind = |hit: &Occurrence| if hit.declares { DocumentHighlightKind::WRITE } else { DocumentHighlightKind::READ };
    let all = occurrences(&own, &named, true);
    Some(all.iter().map(|hit| DocumentHighlight { range: hit.range, kind: Some(kind(hit)) }).collect())
}

/// Returns the range of the name at a position that the editor offers to rename; `None` at other tokens.
pub fn prepare_rename<S: Client>(
    server: &mut Server<S>,
    params: &TextDocumentPositionParams,
) -> Option<PrepareRenameResponse> {
    let named = name_at(server, &params.text_document.uri, params.position)?;
    Some(PrepareRenameResponse::Range(named.range))
}

/// Returns the edits that rename all occurrences of the name at a position; `None` without a name there.
///
/// # Errors
/// The reason of a refusal.
pub fn rename<S: Client>(server: &mut Server<S>, params: &RenameParams) -> Result<Option<WorkspaceEdit>, String> {
    let at = &params.text_document_position;
    let uri = &at.text_document.uri;
    let Some(named) = name_at(server, uri, at.position) else { return Ok(None) };
    let new = params.new_name.trim();
    check_name(new)?;
    let all = related_occurrences(server, uri, &named);
    if !all.iter().flat_map(|(.., hits)| hits).any(|hit| hit.declares) {
        return Err(format!("`{}` is not declared", named.name));
    }
    let installed = |one: &&(Uri, ReachableText, Vec<Occurrence>)| {
        let name = one
            .1
            .path
            .as_deref()
            .and_then(std::path::Path::file_name)
            .and_then(|name| name.to_str())
            .unwrap_or_default();
        library::is_standard_include(name) && server.document(&one.0).is_none()
    };
    if let Some((.., reached, _)) = all.iter().find(installed) {
        let file = reached.path.as_deref().unwrap_or(std::path::Path::new("")).display();
        return Err(format!("`{}` belongs to `{file}`, which other scenes include", named.name));
    }
    let taken = all.iter().any(|(_, reached, _)| {
        reached.outline.declarations.iter().any(|d| d.name == new && d.kind != DeclarationKind::Parameter)
    });
    if taken && new != named.name {
        return Err(format!("`{new}` is declared already"));
    }
    let edit = |hit: &Occurrence| TextEdit { range: hit.range, new_text: new.to_string() };
    let changes: HashMap<Uri, Vec<TextEdit>> =
        all.iter().map(|(uri, _, hits)| (uri.clone(), hits.iter().map(edit).collect())).collect();
    Ok(Some(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }))
}

/// Checks that a scene can declare this name.
fn check_name(name: &str) -> Result<(), String> {
    let starts = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if !starts || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        return Err(format!(
            "`{name}` is not an identifier, which consists of letters, digits and `_` and does not start with a digit"
        ));
    }
    if entry(name).is_some() {
        return Err(format!("`{name}` is a word of the language"));
    }
    Ok(())
}
