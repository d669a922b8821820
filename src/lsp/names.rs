//! Where a name is declared and used, in a text and in what it includes; renaming.

use super::files::Reached;
use super::scan::{Kind, What};
use super::server::{Out, Server};
use crate::library;
use crate::syntax::word::entry;
use lsp_types::{
    DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams, GotoDefinitionParams, GotoDefinitionResponse,
    Location, Position, PrepareRenameResponse, Range, ReferenceParams, RenameParams, TextDocumentPositionParams,
    TextEdit, Uri, WorkspaceEdit,
};
use std::collections::HashMap;

/// A name at a place.
struct Named {
    name: String,
    range: Range,
    /// The macro of this text to which it belongs.
    owner: Option<usize>,
}

/// The name that stands at a place of an open text.
fn named<S: Out>(server: &Server<S>, uri: &Uri, at: Position) -> Option<Named> {
    let document = server.document(uri)?;
    let offset = document.text.offset(at);
    let token = document.scan.token_at(offset).filter(|token| token.kind == Kind::Name)?;
    let name = document.text.as_str()[token.at.clone()].to_string();
    // A parameter's declaration stands inside of its macro too.
    let owner = document.scan.owner(&name, document.scan.macro_at(token.at.end));
    Some(Named { name, range: document.text.range(token.at.clone()), owner })
}

/// A place where a name stands.
struct Hit {
    range: Range,
    declares: bool,
}

/// All places of a name in a text. A name that belongs to a macro of the first text stands nowhere else.
fn hits(reached: &Reached, named: &Named, is_own: bool) -> Vec<Hit> {
    let (scan, text) = (&reached.scan, &reached.text);
    if named.owner.is_some() && !is_own {
        return vec![];
    }
    let belongs = |scope| scan.owner(&named.name, scope) == named.owner;
    let declared = scan.declarations.iter().filter(|d| d.name == named.name && belongs(d.scope));
    let used = scan.uses.iter().filter(|one| one.name == named.name && belongs(one.scope));
    let mut out: Vec<Hit> = declared
        .map(|d| Hit { range: text.range(d.at.clone()), declares: true })
        .chain(used.map(|one| Hit { range: text.range(one.at.clone()), declares: false }))
        .collect();
    out.sort_by_key(|hit| hit.range.start);
    out
}

/// All places of a name in all texts that belong together.
fn everywhere<S: Out>(server: &mut Server<S>, uri: &Uri, named: &Named) -> Vec<(Uri, Reached, Vec<Hit>)> {
    let own = server.document(uri).map(|document| document.path.clone());
    let related = server.related(uri);
    let mut out = vec![];
    for reached in related {
        let is_own = own.as_ref() == Some(&reached.path);
        let found = hits(&reached, named, is_own);
        let address = if is_own { Some(uri.clone()) } else { server.uri(&reached, uri) };
        if let (Some(address), false) = (address, found.is_empty()) {
            out.push((address, reached, found));
        }
    }
    out
}

/// Where the name is declared, or the file that is included.
pub fn definition<S: Out>(server: &mut Server<S>, params: &GotoDefinitionParams) -> Option<GotoDefinitionResponse> {
    let TextDocumentPositionParams { text_document, position } = &params.text_document_position_params;
    let uri = &text_document.uri;
    if let Some(file) = included(server, uri, *position) {
        return Some(GotoDefinitionResponse::Scalar(Location { uri: file, range: Range::default() }));
    }
    let named = named(server, uri, *position)?;
    let all = everywhere(server, uri, &named).into_iter().flat_map(|(uri, _, hits)| {
        hits.into_iter().filter(|hit| hit.declares).map(move |hit| Location { uri: uri.clone(), range: hit.range })
    });
    Some(GotoDefinitionResponse::Array(all.collect()))
}

/// The file whose name stands at a place behind `#include`.
fn included<S: Out>(server: &mut Server<S>, uri: &Uri, at: Position) -> Option<Uri> {
    let document = server.document(uri)?;
    let offset = document.text.offset(at);
    let (name, _) = document.scan.includes.iter().find(|(_, at)| at.contains(&offset))?;
    let search = crate::source::SearchPath::new(&document.folder(), &server.include);
    super::document::uri_of(&super::files::find(name, &document.folder(), &search)?)
}

/// All places of the name.
pub fn references<S: Out>(server: &mut Server<S>, params: &ReferenceParams) -> Option<Vec<Location>> {
    let at = &params.text_document_position;
    let named = named(server, &at.text_document.uri, at.position)?;
    let declares = params.context.include_declaration;
    let all = everywhere(server, &at.text_document.uri, &named).into_iter().flat_map(|(uri, _, hits)| {
        hits.into_iter()
            .filter(move |hit| declares || !hit.declares)
            .map(move |hit| Location { uri: uri.clone(), range: hit.range })
    });
    Some(all.collect())
}

/// All places of the name in its own text.
pub fn highlights<S: Out>(server: &mut Server<S>, params: &DocumentHighlightParams) -> Option<Vec<DocumentHighlight>> {
    let TextDocumentPositionParams { text_document, position } = &params.text_document_position_params;
    let named = named(server, &text_document.uri, *position)?;
    let own = server.reachable(&text_document.uri).into_iter().next()?;
    let kind = |hit: &Hit| if hit.declares { DocumentHighlightKind::WRITE } else { DocumentHighlightKind::READ };
    let all = hits(&own, &named, true);
    Some(all.iter().map(|hit| DocumentHighlight { range: hit.range, kind: Some(kind(hit)) }).collect())
}

/// Can what stands here be renamed?
pub fn prepare<S: Out>(server: &mut Server<S>, params: &TextDocumentPositionParams) -> Option<PrepareRenameResponse> {
    let named = named(server, &params.text_document.uri, params.position)?;
    Some(PrepareRenameResponse::Range(named.range))
}

/// Another name in all places.
///
/// # Errors
/// Why it can't be renamed.
pub fn rename<S: Out>(server: &mut Server<S>, params: &RenameParams) -> Result<Option<WorkspaceEdit>, String> {
    let at = &params.text_document_position;
    let uri = &at.text_document.uri;
    let Some(named) = named(server, uri, at.position) else { return Ok(None) };
    let new = params.new_name.trim();
    check_name(new)?;
    let all = everywhere(server, uri, &named);
    if !all.iter().flat_map(|(.., hits)| hits).any(|hit| hit.declares) {
        return Err(format!("`{}` is declared nowhere", named.name));
    }
    let installed = |one: &&(Uri, Reached, Vec<Hit>)| {
        let name = one
            .1
            .path
            .as_deref()
            .and_then(std::path::Path::file_name)
            .and_then(|name| name.to_str())
            .unwrap_or_default();
        library::is_standard(name) && server.document(&one.0).is_none()
    };
    if let Some((.., reached, _)) = all.iter().find(installed) {
        let file = reached.path.as_deref().unwrap_or(std::path::Path::new("")).display();
        return Err(format!("`{}` belongs to `{file}`, which other scenes include", named.name));
    }
    let taken = all
        .iter()
        .any(|(_, reached, _)| reached.scan.declarations.iter().any(|d| d.name == new && d.what != What::Parameter));
    if taken && new != named.name {
        return Err(format!("there is a `{new}` already"));
    }
    let edit = |hit: &Hit| TextEdit { range: hit.range, new_text: new.to_string() };
    let changes: HashMap<Uri, Vec<TextEdit>> =
        all.iter().map(|(uri, _, hits)| (uri.clone(), hits.iter().map(edit).collect())).collect();
    Ok(Some(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }))
}

/// Can a scene declare this name?
fn check_name(name: &str) -> Result<(), String> {
    let starts = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if !starts || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        return Err(format!("`{name}` is no name: letters, digits and `_`, and no digit first"));
    }
    if entry(name).is_some() {
        return Err(format!("`{name}` is a word of the language"));
    }
    Ok(())
}
