//! Colour swatches of literal colours, and edits of the colour picker.

use crate::color::transfer::{srgb_decode, srgb_encode};
use crate::interpreter::COLOR_WORDS;
use crate::lsp::server::{Client, Server};
use crate::syntax::outline::{Token, TokenKind};
use crate::value::format_decimal;
use lsp_types::{Color, ColorInformation, ColorPresentation, ColorPresentationParams, DocumentColorParams, TextEdit};
use std::ops::Range;

/// A colour literal in a scene's text.
struct Found {
    /// Byte range from the word to the end of the numbers.
    at: Range<usize>,
    color: Color,
}

/// Returns all literal colours of a document's text.
pub fn colors<S: Client>(server: &mut Server<S>, params: &DocumentColorParams) -> Vec<ColorInformation> {
    let Some(document) = server.document(&params.text_document.uri) else { return vec![] };
    let outline = &document.outline;
    let word = |pair: &[Token]| -> Option<Found> {
        let name = outline.slice(&pair[0].range);
        let is_color = matches!(pair[0].kind, TokenKind::Word(_))
            && name.contains("rgb")
            && COLOR_WORDS.iter().any(|row| row.name == name);
        if !is_color {
            return None;
        }
        let numbers = document.text.as_str()[pair[1].range.start..].strip_prefix('<')?.split_once('>')?.0;
        let end = pair[1].range.start + numbers.len() + 2;
        Some(Found { at: pair[0].range.start..end, color: parse_color(name, numbers)? })
    };
    let found = outline.tokens.windows(2).filter_map(word);
    found.map(|found| ColorInformation { range: document.text.range(found.at), color: found.color }).collect()
}

/// Returns the sRGB colour of the numbers after a word; `None` unless they are three to five plain numbers. Numbers of
/// `rgb` are linear, as with `assumed_gamma 1`.
fn parse_color(word: &str, numbers: &str) -> Option<Color> {
    let read: Result<Vec<f64>, _> = numbers.split(',').map(|number| number.trim().parse::<f64>()).collect();
    let read = read.ok().filter(|read| (3..=5).contains(&read.len()))?;
    let encoded = |x: f64| if word.starts_with('s') { x } else { srgb_encode(x.clamp(0.0, 1.0)) };
    let [red, green, blue] = [0, 1, 2].map(|i| encoded(read[i]).clamp(0.0, 1.0) as f32);
    let clear: f64 = read[3..].iter().sum();
    Some(Color { red, green, blue, alpha: (1.0 - clear).clamp(0.0, 1.0) as f32 })
}

/// Returns the spellings, `rgb` and `srgb`, of a colour that was chosen in the picker. Filter and transmit of the old text
/// stay.
pub fn color_presentations<S: Client>(
    server: &mut Server<S>,
    params: &ColorPresentationParams,
) -> Vec<ColorPresentation> {
    let Some(document) = server.document(&params.text_document.uri) else { return vec![] };
    let bytes = document.text.offset(params.range.start)..document.text.offset(params.range.end);
    let old = document.text.as_str().get(bytes).unwrap_or_default();
    let word: String = old.chars().take_while(char::is_ascii_alphabetic).collect();
    // Keep filter and transmit.
    let rest: Vec<String> =
        old.split([',', '<', '>']).skip(4).map(|n| n.trim().to_string()).filter(|n| !n.is_empty()).collect();
    let suffix = word.trim_start_matches('s').trim_start_matches("rgb").to_string();
    let screen = [params.color.red, params.color.green, params.color.blue].map(f64::from);
    let light = screen.map(srgb_decode);
    let mut all = [(format!("srgb{suffix}"), screen), (format!("rgb{suffix}"), light)];
    all.sort_by_key(|(name, _)| *name != word);
    let one = |(name, numbers): (String, [f64; 3])| {
        let numbers =
            numbers.iter().map(|x| format_decimal(*x, 3)).chain(rest.iter().cloned()).collect::<Vec<_>>().join(", ");
        let text = format!("{name} <{numbers}>");
        let edit = TextEdit { range: params.range, new_text: text.clone() };
        ColorPresentation { label: text, text_edit: Some(edit), additional_text_edits: None }
    };
    all.map(one).into()
}
