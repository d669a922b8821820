//! Small notes between the words: what an `#end` closes, what an argument is for.

use super::complete;
use super::scan::{Kind, Pair, What};
use super::server::{Out, Server};
use lsp_types::{InlayHint, InlayHintKind, InlayHintLabel, InlayHintParams, Position};
use std::collections::HashMap;

/// A directive needs so many lines for its end to be out of sight.
const LINES: u32 = 8;

/// Those of a range.
pub fn hints<S: Out>(server: &mut Server<S>, params: &InlayHintParams) -> Option<Vec<InlayHint>> {
    let uri = &params.text_document.uri;
    let related = server.related(uri);
    let document = server.document(uri)?;
    let (text, scan) = (&document.text, &document.scan);
    let (from, to) = (text.offset(params.range.start), text.offset(params.range.end));
    let mut parameters: HashMap<&str, Vec<String>> = HashMap::new();
    for one in &related {
        for d in one.scan.declarations.iter().filter(|d| d.what == What::Macro) {
            parameters.entry(&d.name).or_insert_with(|| complete::parameters(one, d).unwrap_or_default());
        }
    }
    let mut out = vec![];
    for pair in scan.pairs.iter().filter(|pair| pair.closed && pair.whole.start < to && from < pair.whole.end) {
        if pair.open == b'#' {
            let (start, end) = (text.position(pair.whole.start), text.position(pair.whole.end));
            if end.line >= start.line + LINES && (from..=to).contains(&pair.whole.end) {
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

fn is_definition(scan: &super::scan::Scan, pair: &Pair) -> bool {
    scan.declarations.iter().any(|d| d.what == What::Macro && d.at == pair.named)
}

/// Where the arguments of a call begin.
fn arguments(text: &str, scan: &super::scan::Scan, call: &Pair) -> Vec<usize> {
    let first = scan.tokens.partition_point(|token| token.at.start <= call.whole.start);
    let inside = scan.tokens[first..].iter().take_while(|token| token.at.end < call.whole.end);
    let (mut out, mut depth, mut fresh) = (vec![], 0i32, true);
    for token in inside.filter(|token| token.kind != Kind::Comment) {
        if std::mem::take(&mut fresh) {
            out.push(token.at.start);
        }
        match &text[token.at.clone()] {
            "(" | "[" | "{" | "<" => depth += 1,
            ")" | "]" | "}" | ">" => depth -= 1,
            "," => fresh = depth <= 0,
            // A list of numbers holds the commas of several arguments: what follows is not known.
            list if token.kind == Kind::Number
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
