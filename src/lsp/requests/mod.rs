//! Requests of the editor: capabilities, and a file for each family of requests.

mod actions;
mod colors;
pub mod commands;
mod complete;
mod hover;
mod inlay;
mod layout;
mod lens;
mod names;
mod semantic;
mod signature;
mod symbols;

use crate::lsp::server::{Client, Server, not_open};
use lsp_server::{ErrorCode, Request, Response};
use lsp_types::request as ask;
use serde_json::{Value, json};

/// Returns the capabilities of the server. Positions count in UTF-16, which every editor supports. Commands that the
/// editor implements itself, named in `initializationOptions.commands`, are omitted.
pub fn capabilities(asked: &Value) -> Value {
    let own = &asked["initializationOptions"]["commands"];
    let is_own = |command: &&str| own.as_array().is_some_and(|own| own.iter().any(|one| one == command));
    let all = [commands::RENDER, commands::WATCH, commands::EXPLAIN];
    let commands: Vec<&str> = all.into_iter().filter(|command| !is_own(command)).collect();
    json!({
        "positionEncoding": "utf-16",
        "textDocumentSync": {"openClose": true, "change": 2, "save": true},
        "completionProvider": {"triggerCharacters": ["#", "\"", "/"]},
        "hoverProvider": true,
        "signatureHelpProvider": {"triggerCharacters": ["(", ","]},
        "definitionProvider": true,
        "referencesProvider": true,
        "documentHighlightProvider": true,
        "renameProvider": {"prepareProvider": true},
        "documentSymbolProvider": true,
        "workspaceSymbolProvider": true,
        "documentFormattingProvider": true,
        "documentRangeFormattingProvider": true,
        "foldingRangeProvider": true,
        "selectionRangeProvider": true,
        "semanticTokensProvider": {"legend": semantic::legend(), "full": true},
        "codeActionProvider": {"codeActionKinds": ["quickfix"]},
        "colorProvider": true,
        "inlayHintProvider": true,
        "codeLensProvider": {},
        "executeCommandProvider": {"commands": commands},
    })
}

/// Responds to a request from the editor.
pub fn answer<S: Client>(server: &mut Server<S>, request: Request) -> Response {
    fn respond_with<R: ask::Request>(request: Request, answer: impl FnOnce(R::Params) -> R::Result) -> Response {
        match serde_json::from_value(request.params) {
            Ok(params) => Response::new_ok(request.id, answer(params)),
            Err(error) => Response::new_err(request.id, ErrorCode::InvalidParams as i32, error.to_string()),
        }
    }
    if let Some(response) = response_without_service(server, &request) {
        return response;
    }
    match request.method.as_str() {
        "textDocument/completion" => respond_with::<ask::Completion>(request, |p| complete::complete(server, &p)),
        "textDocument/hover" => respond_with::<ask::HoverRequest>(request, |p| hover::hover(server, &p)),
        "textDocument/signatureHelp" => {
            respond_with::<ask::SignatureHelpRequest>(request, |p| signature::help(server, &p))
        }
        "textDocument/definition" => respond_with::<ask::GotoDefinition>(request, |p| names::definition(server, &p)),
        "textDocument/references" => respond_with::<ask::References>(request, |p| names::references(server, &p)),
        "textDocument/documentHighlight" => {
            respond_with::<ask::DocumentHighlightRequest>(request, |p| names::highlights(server, &p))
        }
        "textDocument/prepareRename" => {
            respond_with::<ask::PrepareRenameRequest>(request, |p| names::prepare_rename(server, &p))
        }
        "textDocument/rename" => rename(server, request),
        "textDocument/documentSymbol" => {
            respond_with::<ask::DocumentSymbolRequest>(request, |p| symbols::of_document(server, &p))
        }
        "workspace/symbol" => {
            respond_with::<ask::WorkspaceSymbolRequest>(request, |p| symbols::of_workspace(server, &p))
        }
        "textDocument/formatting" => respond_with::<ask::Formatting>(request, |p| layout::format(server, &p)),
        "textDocument/rangeFormatting" => {
            respond_with::<ask::RangeFormatting>(request, |p| layout::format_range(server, &p))
        }
        "textDocument/foldingRange" => respond_with::<ask::FoldingRangeRequest>(request, |p| layout::folds(server, &p)),
        "textDocument/selectionRange" => {
            respond_with::<ask::SelectionRangeRequest>(request, |p| layout::selections(server, &p))
        }
        "textDocument/semanticTokens/full" => {
            respond_with::<ask::SemanticTokensFullRequest>(request, |p| semantic::tokens(server, &p))
        }
        "textDocument/codeAction" => respond_with::<ask::CodeActionRequest>(request, |p| actions::actions(server, &p)),
        "textDocument/documentColor" => respond_with::<ask::DocumentColor>(request, |p| colors::colors(server, &p)),
        "textDocument/colorPresentation" => {
            respond_with::<ask::ColorPresentationRequest>(request, |p| colors::color_presentations(server, &p))
        }
        "textDocument/inlayHint" => respond_with::<ask::InlayHintRequest>(request, |p| inlay::hints(server, &p)),
        "textDocument/codeLens" => respond_with::<ask::CodeLensRequest>(request, |p| lens::lenses(server, &p)),
        "workspace/executeCommand" => respond_with::<ask::ExecuteCommand>(request, |p| commands::execute(server, &p)),
        other => {
            let text = format!("`{other}` is not supported");
            Response::new_err(request.id, ErrorCode::MethodNotFound as i32, text)
        }
    }
}

/// Returns the response to a request about a document that is not open or too large for any service; `None` for all
/// other requests.
fn response_without_service<S: Client>(server: &Server<S>, request: &Request) -> Option<Response> {
    let address = request.params["textDocument"]["uri"].as_str()?;
    let id = request.id.clone();
    let Some(document) = server.open.get(address) else {
        return Some(Response::new_err(id, ErrorCode::InvalidParams as i32, not_open(address)));
    };
    if !document.is_too_large() {
        return None;
    }
    Some(match request.method.as_str() {
        // The author has asked for these changes: report why there are none.
        "textDocument/formatting" | "textDocument/rangeFormatting" | "textDocument/rename" => {
            Response::new_err(id, ErrorCode::RequestFailed as i32, document.too_large_message())
        }
        "textDocument/documentColor" | "textDocument/colorPresentation" => Response::new_ok(id, json!([])),
        _ => Response::new_ok(id, Value::Null),
    })
}

/// Responds to a rename request, which may be refused with a reason.
fn rename<S: Client>(server: &mut Server<S>, request: Request) -> Response {
    match serde_json::from_value(request.params) {
        Ok(params) => match names::rename(server, &params) {
            Ok(edit) => Response::new_ok(request.id, edit),
            Err(reason) => Response::new_err(request.id, ErrorCode::InvalidRequest as i32, reason),
        },
        Err(error) => Response::new_err(request.id, ErrorCode::InvalidParams as i32, error.to_string()),
    }
}
