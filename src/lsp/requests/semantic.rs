//! Semantic tokens: kinds of words for the colours of the editor.

use crate::lsp::scan::{DeclarationKind, TokenKind};
use crate::lsp::server::{Client, Server};
use crate::reference::sorts;
use crate::syntax::word::Category;
use lsp_types::{SemanticToken, SemanticTokens, SemanticTokensParams, SemanticTokensResult};
use serde_json::{Value, json};
use std::collections::HashMap;

/// The token types, in the order of [`Type`].
pub fn legend() -> Value {
    json!({
        "tokenTypes": [
            "keyword", "class", "struct", "function", "macro", "variable", "parameter", "property", "enumMember",
        ],
        "tokenModifiers": ["declaration"],
    })
}

#[derive(Clone, Copy)]
enum Type {
    Keyword,
    Class,
    Struct,
    Function,
    Macro,
    Variable,
    Parameter,
    Property,
    Constant,
}

/// The types of all words, names and directives of a text. Numbers, strings and comments are left to the editor's
/// grammar.
pub fn tokens<S: Client>(server: &mut Server<S>, params: &SemanticTokensParams) -> Option<SemanticTokensResult> {
    let uri = &params.text_document.uri;
    let related = server.related(uri);
    let document = server.document(uri)?;
    let (text, scan) = (&document.text, &document.scan);
    let declared = |one: &'_ crate::lsp::files::ReachableText| {
        one.scan
            .declarations
            .iter()
            .filter(|d| d.kind == DeclarationKind::Macro)
            .map(|d| d.name.clone())
            .collect::<Vec<_>>()
    };
    let macros: std::collections::HashSet<String> = related.iter().flat_map(declared).collect();
    let own: HashMap<usize, DeclarationKind> = scan.declarations.iter().map(|d| (d.at.start, d.kind)).collect();
    let sorts = sorts();
    let (mut data, mut last) = (vec![], lsp_types::Position::default());
    for token in &scan.tokens {
        let word = &text.as_str()[token.at.clone()];
        let kind = match token.kind {
            TokenKind::Directive => Type::Keyword,
            TokenKind::Word(Category::Function) => Type::Function,
            TokenKind::Word(Category::Constant) => Type::Constant,
            TokenKind::Word(_) if sorts.objects.contains(&word) => Type::Class,
            TokenKind::Word(_) if sorts.blocks.contains(&word) => Type::Struct,
            TokenKind::Word(_) => Type::Property,
            TokenKind::Name if own.get(&token.at.start) == Some(&DeclarationKind::Parameter) => Type::Parameter,
            TokenKind::Name if macros.contains(word) => Type::Macro,
            TokenKind::Name => {
                let scope = scan.macro_at(token.at.end);
                let is = |what: DeclarationKind| {
                    scan.declarations.iter().any(|d| d.scope == scope && d.kind == what && d.name == word)
                };
                if scope.is_some() && is(DeclarationKind::Parameter) { Type::Parameter } else { Type::Variable }
            }
            TokenKind::Text | TokenKind::Number | TokenKind::Sign | TokenKind::Comment => continue,
        };
        if word.contains(['\n', '\r']) {
            continue;
        }
        let at = text.position(token.at.start);
        let same_line = at.line == last.line;
        data.push(SemanticToken {
            delta_line: at.line - last.line,
            delta_start: if same_line { at.character - last.character } else { at.character },
            length: word.encode_utf16().count() as u32,
            token_type: kind as u32,
            token_modifiers_bitset: u32::from(own.contains_key(&token.at.start)),
        });
        last = at;
    }
    Some(SemanticTokensResult::Tokens(SemanticTokens { result_id: None, data }))
}
