//! Code lenses above a scene: "Render" and "Watch and pick".

use super::commands::{RENDER, WATCH};
use crate::lsp::server::{Client, Server};
use lsp_types::{CodeLens, CodeLensParams, Command};
use serde_json::json;

/// Returns the code lenses of a scene, which render and watch it: above the first line that is no comment. None for
/// include files and for texts that are not saved.
pub fn lenses<S: Client>(server: &mut Server<S>, params: &CodeLensParams) -> Option<Vec<CodeLens>> {
    let document = server.document(&params.text_document.uri)?;
    let path = document.path.as_ref().filter(|_| document.is_scene())?;
    let first = document.outline.tokens.first();
    let range = document.text.range(first.map_or(0..0, |token| token.range.clone()));
    let lens = |title: &str, command: &str| {
        let command = Command::new(title.into(), command.into(), Some(vec![json!(path)]));
        CodeLens { range, command: Some(command), data: None }
    };
    Some(vec![lens("Render", RENDER), lens("Watch and pick", WATCH)])
}
