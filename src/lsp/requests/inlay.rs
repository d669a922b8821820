//! Inlay hints: the directive that an `#end` closes, and the parameters of arguments.

use super::complete;
use crate::lsp::scan::{DeclarationKind, Pair, TokenKind};
use crate::lsp::server::{Client, Server};
use lsp_types::{InlayHint, InlayHintKind, InlayHintLabel, InlayHintParams, Position};
use std::collections::HashMap;

/// Number of lines from which the end of a directive gets a hint.
const MIN_LINES: u32 = 8;

/// Returns the inlay hints in a range of the document.
pub fn hints<S: Client>(server: &mut Server<S>, params: &InlayHintParams) -> Option<Vec<InlayHint>> {
    let uri = &params.text_document.uri;
    let related = server.related(uri);
    let document = server.document(uri)?;
    let (text, scan) = (&document.text, &document.scan);
    let (from, to) = (text.offset(params.range.start), text.offset(params.range.end));
    let mut parameters: HashMap<&str, Vec<String>> = HashMap::new();
    for one in &related {
        for d in one.scan.declarations.iter().filter(|d| d.kind == DeclarationKind::Macro) {
            parameters.entry(&d.name).or_insert_with(|| complete::parameters(one, d).unwrap_or_default());
        }
    }
    let mut out = vec![];
    for pair in scan.pairs.iter().filter(|pair| pair.closed && pair.whole.start < to && from < pair.whole.end) {
        if pair.open == b'#' {
            let (start, end) = (text.position(pair.whole.start), text.position(pair.whole.end));
            if end.line >= start.line + MIN_LINES && (from..=to).contains(&pair.whole.end) {
                let name = text.line(start.line as usize).trim().trim_end_matches(['{', ' ']);
                let name: String = name.chars().take(40).collect();
                out.push(hint(end, name, true, false));
            }
        } else if pair.open == b'(' && !is_definition(scan, pair) {
            let Some(names) = parameters.get(pair.name.as_str()) else { continue };
            for (name, at) in names.iter().zip(arguments(text.as_str(), scan, pair)) {
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

fn is_definition(scan: &crate::lsp::scan::Scan, pair: &Pair) -> bool {
    scan.declarations.iter().any(|d| d.kind == DeclarationKind::Macro && d.at == pair.named)
}

/// Returns the byte offsets of a call's arguments.
fn arguments(text: &str, scan: &crate::lsp::scan::Scan, call: &Pair) -> Vec<usize> {
    let first = scan.tokens.partition_point(|token| token.at.start <= call.whole.start);
    let inside = scan.tokens[first..].iter().take_while(|token| token.at.end < call.whole.end);
    let (mut out, mut depth, mut fresh) = (vec![], 0i32, true);
    for token in inside.filter(|token| token.kind != TokenKind::Comment) {
        if std::mem::take(&mut fresh) {
            out.push(token.at.start);
        }
        match &text[token.at.clone()] {
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
