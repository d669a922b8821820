//! What stands above a scene, to be clicked: "Render" and "Watch and pick".

use super::commands::{RENDER, WATCH};
use super::scan::Kind;
use super::server::{Out, Server};
use lsp_types::{CodeLens, CodeLensParams, Command};
use serde_json::json;

/// Above the first line that is no comment. A text that lies nowhere can't be drawn, nor can an include file.
pub fn lenses<S: Out>(server: &mut Server<S>, params: &CodeLensParams) -> Option<Vec<CodeLens>> {
    let document = server.document(&params.text_document.uri)?;
    let path = document.path.as_ref().filter(|_| document.is_scene())?;
    let first = document.scan.tokens.iter().find(|token| token.kind != Kind::Comment);
    let range = document.text.range(first.map_or(0..0, |token| token.at.clone()));
    let lens = |title: &str, command: &str| {
        let command = Command::new(title.into(), command.into(), Some(vec![json!(path)]));
        CodeLens { range, command: Some(command), data: None }
    };
    Some(vec![lens("Render", RENDER), lens("Watch and pick", WATCH)])
}
