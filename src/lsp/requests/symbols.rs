//! Symbols of a text: declarations and outermost blocks, for outlines and searches.

use crate::lsp::document::Document;
use crate::lsp::server::{Client, Server};
use crate::syntax::outline::{Declaration, DeclarationKind, Pair};
use lsp_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, Location, OneOf, SymbolKind, WorkspaceSymbol,
    WorkspaceSymbolParams, WorkspaceSymbolResponse,
};

/// Largest number of symbols of a search.
const MAX_SYMBOLS: usize = 1000;

/// Returns the declared names, macros and outermost blocks of a document.
pub fn of_document<S: Client>(server: &mut Server<S>, params: &DocumentSymbolParams) -> Option<DocumentSymbolResponse> {
    let document = server.document(&params.text_document.uri)?;
    let outline = &document.outline;
    let declared = outline.declarations.iter().filter(|d| d.scope.is_none() || d.kind == DeclarationKind::Macro);
    let mut all: Vec<DocumentSymbol> = declared.map(|d| of_declaration(document, d)).collect();
    let is_outer = |pair: &&Pair| pair.bracket == b'{' && pair.outer.is_none() && !pair.head.is_empty();
    let is_value = |pair: &Pair| {
        let before = document.text.as_str()[..pair.head.start].trim_end();
        before.ends_with('=')
    };
    all.extend(outline.pairs.iter().filter(is_outer).filter(|pair| !is_value(pair)).map(|pair| {
        let whole = pair.head.start..pair.range.end;
        symbol(document, outline.head(pair), SymbolKind::OBJECT, whole, pair.head.clone())
    }));
    all.sort_by_key(|symbol| symbol.range.start);
    Some(DocumentSymbolResponse::Nested(all))
}

fn of_declaration(document: &Document, d: &Declaration) -> DocumentSymbol {
    // A declaration extends to the end of the braces of its value.
    let value = document.outline.pairs.iter().find(|pair| {
        pair.bracket == b'{'
            && pair.range.start > d.range.end
            && document.text.as_str().get(d.range.end..pair.head.start).is_some_and(|between| between.trim() == "=")
    });
    let end = value.map_or(d.whole.end, |pair| pair.range.end);
    symbol(document, &d.name, kind(d.kind), d.whole.start..end.max(d.range.end), d.range.clone())
}

fn kind(what: DeclarationKind) -> SymbolKind {
    match what {
        DeclarationKind::Macro => SymbolKind::FUNCTION,
        DeclarationKind::Declare | DeclarationKind::Local | DeclarationKind::Parameter | DeclarationKind::Counter => {
            SymbolKind::VARIABLE
        }
    }
}

#[allow(deprecated)]
fn symbol(
    document: &Document,
    name: &str,
    kind: SymbolKind,
    whole: std::ops::Range<usize>,
    name_range: std::ops::Range<usize>,
) -> DocumentSymbol {
    DocumentSymbol {
        name: name.to_string(),
        detail: None,
        kind,
        tags: None,
        deprecated: None,
        range: document.text.range(whole),
        selection_range: document.text.range(name_range),
        children: None,
    }
}

/// Returns the declared names and macros that contain the query, in any letter case, in all open texts and their includes;
/// at most [`MAX_SYMBOLS`].
pub fn of_workspace<S: Client>(
    server: &mut Server<S>,
    params: &WorkspaceSymbolParams,
) -> Option<WorkspaceSymbolResponse> {
    let wanted = params.query.to_lowercase();
    let uris: Vec<_> = server.open.values().map(|document| document.uri.clone()).collect();
    let mut out: Vec<WorkspaceSymbol> = vec![];
    let mut seen = std::collections::HashSet::new();
    for from in uris {
        for reached in server.reachable(&from) {
            let Some(uri) = server.uri_of_reached(&reached, &from) else { continue };
            if !seen.insert(uri.as_str().to_string()) {
                continue;
            }
            let fits = |d: &&Declaration| {
                d.kind != DeclarationKind::Parameter && d.scope.is_none() | (d.kind == DeclarationKind::Macro)
            };
            for d in
                reached.outline.declarations.iter().filter(fits).filter(|d| d.name.to_lowercase().contains(&wanted))
            {
                let location = Location { uri: uri.clone(), range: reached.text.range(d.range.clone()) };
                out.push(WorkspaceSymbol {
                    name: d.name.clone(),
                    kind: kind(d.kind),
                    tags: None,
                    container_name: None,
                    location: OneOf::Left(location),
                    data: None,
                });
            }
        }
    }
    out.truncate(MAX_SYMBOLS);
    Some(WorkspaceSymbolResponse::Nested(out))
}
