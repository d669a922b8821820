//! Hover: explanation of the word under the pointer.

use super::complete;
use crate::lsp::files::ReachableText;
use crate::lsp::server::{Client, Server};
use crate::lsp::{manual, words};
use crate::syntax::outline::{Declaration, DeclarationKind, TokenKind};
use lsp_types::{Hover, HoverContents, HoverParams, MarkupContent, MarkupKind};
use std::path::Path;

/// Largest number of displayed lines of a declaration.
const MAX_LINES: usize = 8;
/// Largest number of displayed bytes of a declaration.
const MAX_BYTES: usize = 400;

/// Returns the manual's text about the word at a position, or the declaration of a name and its position.
pub fn hover<S: Client>(server: &mut Server<S>, params: &HoverParams) -> Option<Hover> {
    let at = &params.text_document_position_params;
    let uri = &at.text_document.uri;
    let related = server.texts_sharing_names(uri);
    let document = server.document(uri)?;
    let offset = document.text.offset(at.position);
    let outline = &document.outline;
    let token = outline.token_at(offset)?;
    let text = outline.slice(&token.range);
    let value = match token.kind {
        TokenKind::Directive => words::directive_usage_and_summary(outline.directive_word(token))
            .map(|(form, summary)| format!("```pov\n{form}\n```\n{summary}")),
        TokenKind::Word(_) => word_explanation(text, words::block_name_at(outline, offset)),
        TokenKind::Name => {
            let scope = outline.declaring_macro_pair(text, outline.macro_pair_at(token.range.end));
            let own = related.iter().position(|one| one.path == document.path);
            declaration_and_position(&related, text, scope, own)
                .or_else(|| word_explanation(text, words::block_name_at(outline, offset)))
        }
        _ => None,
    };
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value: value? });
    Some(Hover { contents, range: Some(document.text.range(token.range.clone())) })
}

fn word_explanation(word: &str, block: &str) -> Option<String> {
    let lines = words::explain(word, block);
    let picture = manual::picture(word).map(|uri| format!("\n\n![{word}]({})", uri.as_str())).unwrap_or_default();
    (!lines.is_empty()).then(|| format!("**{word}**\n\n- {}{picture}", lines.join("\n- ")))
}

/// Returns, as Markdown, the first declaration of a name in the document itself, or else in the related texts, with its
/// file, its line and the number of declarations; `None` for a name that is not declared.
fn declaration_and_position(
    related: &[ReachableText],
    name: &str,
    declaring_macro_pair: Option<usize>,
    own_index: Option<usize>,
) -> Option<String> {
    let all = related.iter().enumerate().flat_map(|(i, one)| one.outline.declarations.iter().map(move |d| (i, one, d)));
    let fits = |(i, one, d): &(usize, &ReachableText, &Declaration)| {
        d.name == name
            && one.outline.declaring_macro_pair(name, d.scope) == declaring_macro_pair
            && (declaring_macro_pair.is_none() || Some(*i) == own_index)
    };
    let found: Vec<_> = all.filter(fits).collect();
    let (_, one, d) = found.iter().find(|(i, ..)| Some(*i) == own_index).or(found.first())?;
    let place = one.path.as_deref().and_then(Path::file_name).map(|file| file.to_string_lossy().into_owned());
    let line = one.text.position(d.range.start).line + 1;
    let place = place.map(|file| format!("{file}, line {line}")).unwrap_or(format!("line {line}"));
    let text = one.text.as_str();
    let code = match d.kind {
        DeclarationKind::Macro => {
            let about = comment_above_line(one, d.whole.start);
            let parameters = complete::macro_parameters(one, d).unwrap_or_default();
            format!("{about}#macro {}({})", d.name, parameters.join(", "))
        }
        DeclarationKind::Parameter => format!("{name}: a parameter"),
        _ => format!("{}{}", comment_above_line(one, d.whole.start), shortened_declaration(&text[d.whole.start..])),
    };
    let more = if found.len() > 1 { format!("; declared {} times", found.len()) } else { String::new() };
    Some(format!("```pov\n{code}\n```\n{place}{more}"))
}

/// Returns the `//` comments directly above the line that contains a byte, each with a line ending; empty without comments.
fn comment_above_line(one: &ReachableText, byte_in_line: usize) -> String {
    let before = &one.text.as_str()[..one.outline.line_at(byte_in_line).start];
    let mut lines: Vec<&str> =
        before.lines().rev().take_while(|line| line.trim_start().starts_with("//")).take(MAX_LINES).collect();
    lines.reverse();
    lines.iter().map(|line| format!("{}\n", line.trim())).collect()
}

/// Returns the declaration with which a text begins, up to its `;` or closing brace, shortened if necessary.
fn shortened_declaration(text_from_declaration: &str) -> String {
    let (mut depth, mut end) = (0i32, text_from_declaration.len());
    for (i, c) in text_from_declaration.char_indices() {
        depth += match c {
            '{' | '(' => 1,
            '}' | ')' => -1,
            _ => 0,
        };
        let ends = match c {
            ';' => depth <= 0,
            '}' => depth == 0,
            '\n' => {
                depth <= 0
                    && text_from_declaration[..i].contains('=')
                    && !text_from_declaration[..i].trim_end().ends_with(['=', ',', '+', '-', '*', '/'])
            }
            _ => false,
        };
        if ends {
            end = i + usize::from(c != '\n');
            break;
        }
        if i > MAX_BYTES {
            end = i;
            break;
        }
    }
    let mut lines: Vec<&str> = text_from_declaration[..end].lines().collect();
    let whole = lines.len() <= MAX_LINES && end <= MAX_BYTES;
    lines.truncate(MAX_LINES);
    lines.join("\n") + if whole { "" } else { " …" }
}
