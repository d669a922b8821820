//! Inlay hints: the directive that an `#end` closes, and the parameters of arguments.

use super::complete;
use crate::lsp::server::{Client, Server};
use crate::syntax::outline::{DeclarationKind, Outline, Pair, TokenKind};
use lsp_types::{InlayHint, InlayHintKind, InlayHintLabel, InlayHintParams, Position};
use std::collections::HashMap;

/// Number of lines from which the end of a directive gets a hint.
const MIN_LINES: u32 = 8;

/// Returns the inlay hints in a range of the document.
pub fn hints<S: Client>(server: &mut Server<S>, params: &InlayHintParams) -> Option<Vec<InlayHint>> {
    let uri = &params.text_document.uri;
    let related = server.texts_sharing_names(uri);
    let document = server.document(uri)?;
    let (text, outline) = (&document.text, &document.outline);
    let (from, to) = (text.offset(params.range.start), text.offset(params.range.end));
    let mut parameters: HashMap<&str, Vec<String>> = HashMap::new();
    for one in &related {
        for d in one.outline.declarations.iter().filter(|d| d.kind == DeclarationKind::Macro) {
            parameters.entry(&d.name).or_insert_with(|| complete::macro_parameters(one, d).unwrap_or_default());
        }
    }
    let mut out = vec![];
    for pair in
        outline.pairs.iter().filter(|pair| pair.closer.is_some() && pair.range.start < to && from < pair.range.end)
    {
        if pair.bracket == b'#' {
            let (start, end) = (text.position(pair.range.start), text.position(pair.range.end));
            if end.line >= start.line + MIN_LINES && (from..=to).contains(&pair.range.end) {
                let name = text.line(start.line as usize).trim().trim_end_matches(['{', ' ']);
                let name: String = name.chars().take(40).collect();
                out.push(hint(end, name, true, false));
            }
        } else if pair.bracket == b'(' && !is_macro_definition(outline, pair) {
            let Some(names) = parameters.get(outline.head(pair)) else { continue };
            for (name, at) in names.iter().zip(argument_offsets(outline, pair)) {
                let argument = &text.as_str()[at..];
                let same = argument.to_lowercase().starts_with(&name.to_lowercase());
                if !same && name.len() > 1 && (from..=to).contains(&at) {
                    out.push(hint(text.position(at), format!("{name}:"), false, true));
                }
            }
        }
    }
    Some(out)
}

fn is_macro_definition(outline: &Outline, pair: &Pair) -> bool {
    outline.declarations.iter().any(|d| d.kind == DeclarationKind::Macro && d.range == pair.head)
}

/// Returns the byte offsets of a call's arguments, or of the first ones if the others have no known index.
fn argument_offsets(outline: &Outline, call: &Pair) -> Vec<usize> {
    let inside = &outline.tokens[call.opener + 1..call.closer.unwrap_or(outline.tokens.len())];
    let (mut out, mut depth, mut fresh) = (vec![], 0i32, true);
    for token in inside {
        if std::mem::take(&mut fresh) {
            out.push(token.range.start);
        }
        match outline.slice(&token.range) {
            "(" | "[" | "{" | "<" => depth += 1,
            ")" | "]" | "}" | ">" => depth -= 1,
            "," => fresh = depth <= 0,
            // A list of numbers contains the commas of several arguments, so that later arguments have no known index.
            list if token.kind == TokenKind::Number
                && list.replace(char::is_whitespace, "").contains([','])
                && !list.starts_with('<') =>
            {
                break;
            }
            _ => {}
        }
    }
    out
}

fn hint(position: Position, label: String, padding_left: bool, padding_right: bool) -> InlayHint {
    InlayHint {
        position,
        label: InlayHintLabel::String(label),
        kind: padding_right.then_some(InlayHintKind::PARAMETER),
        text_edits: None,
        tooltip: None,
        padding_left: Some(padding_left),
        padding_right: Some(padding_right),
        data: None,
    }
}
