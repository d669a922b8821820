//! Semantic tokens: kinds of words for the colours of the editor.

use crate::lsp::server::{Client, Server};
use crate::reference::words_by_kind;
use crate::syntax::outline::{DeclarationKind, TokenKind};
use crate::syntax::word::Category;
use lsp_types::{SemanticToken, SemanticTokens, SemanticTokensParams, SemanticTokensResult};
use serde_json::{Value, json};
use std::collections::HashMap;

/// Returns the legend of the semantic tokens: the names of their types, in the order of [`Type`].
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

/// Returns the semantic tokens of a document: the types of all words, names and directives. Numbers, strings and
/// comments are left to the editor's grammar.
pub fn tokens<S: Client>(server: &mut Server<S>, params: &SemanticTokensParams) -> Option<SemanticTokensResult> {
    let uri = &params.text_document.uri;
    let related = server.texts_sharing_names(uri);
    let document = server.document(uri)?;
    let (text, outline) = (&document.text, &document.outline);
    let declared = |one: &'_ crate::lsp::files::ReachableText| {
        one.outline
            .declarations
            .iter()
            .filter(|d| d.kind == DeclarationKind::Macro)
            .map(|d| d.name.clone())
            .collect::<Vec<_>>()
    };
    let macros: std::collections::HashSet<String> = related.iter().flat_map(declared).collect();
    let own: HashMap<usize, DeclarationKind> = outline.declarations.iter().map(|d| (d.range.start, d.kind)).collect();
    let by_kind = words_by_kind();
    let (mut data, mut last) = (vec![], lsp_types::Position::default());
    for token in &outline.tokens {
        let word = outline.slice(&token.range);
        let kind = match token.kind {
            TokenKind::Directive => Type::Keyword,
            TokenKind::Word(Category::Function) => Type::Function,
            TokenKind::Word(Category::Constant) => Type::Constant,
            TokenKind::Word(_) if by_kind.objects.contains(&word) => Type::Class,
            TokenKind::Word(_) if by_kind.blocks.contains(&word) => Type::Struct,
            TokenKind::Word(_) => Type::Property,
            TokenKind::Name if own.get(&token.range.start) == Some(&DeclarationKind::Parameter) => Type::Parameter,
            TokenKind::Name if macros.contains(word) => Type::Macro,
            TokenKind::Name => {
                let scope = outline.macro_pair_at(token.range.end);
                let is = |what: DeclarationKind| {
                    outline.declarations.iter().any(|d| d.scope == scope && d.kind == what && d.name == word)
                };
                if scope.is_some() && is(DeclarationKind::Parameter) { Type::Parameter } else { Type::Variable }
            }
            TokenKind::String | TokenKind::Number | TokenKind::Sign => continue,
        };
        if word.contains(['\n', '\r']) {
            continue;
        }
        let at = text.position(token.range.start);
        let same_line = at.line == last.line;
        data.push(SemanticToken {
            delta_line: at.line - last.line,
            delta_start: if same_line { at.character - last.character } else { at.character },
            length: word.encode_utf16().count() as u32,
            token_type: kind as u32,
            token_modifiers_bitset: u32::from(own.contains_key(&token.range.start)),
        });
        last = at;
    }
    Some(SemanticTokensResult::Tokens(SemanticTokens { result_id: None, data }))
}
