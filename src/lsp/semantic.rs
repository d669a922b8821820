//! Which word is what: for colours in the editor.

use super::scan::{Kind, What};
use super::server::{Out, Server};
use crate::reference::sorts;
use crate::syntax::word::Category;
use lsp_types::{SemanticToken, SemanticTokens, SemanticTokensParams, SemanticTokensResult};
use serde_json::{Value, json};
use std::collections::HashMap;

/// What a word can be; the order is that of [`Type`].
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

/// Of the whole text: words, names and directives. Numbers, texts and comments are what they look like.
pub fn tokens<S: Out>(server: &mut Server<S>, params: &SemanticTokensParams) -> Option<SemanticTokensResult> {
    let uri = &params.text_document.uri;
    let related = server.related(uri);
    let document = server.document(uri)?;
    let (text, scan) = (&document.text, &document.scan);
    let declared = |one: &'_ super::files::Reached| {
        one.scan.declarations.iter().filter(|d| d.what == What::Macro).map(|d| d.name.clone()).collect::<Vec<_>>()
    };
    let macros: std::collections::HashSet<String> = related.iter().flat_map(declared).collect();
    let own: HashMap<usize, What> = scan.declarations.iter().map(|d| (d.at.start, d.what)).collect();
    let sorts = sorts();
    let (mut data, mut last) = (vec![], lsp_types::Position::default());
    for token in &scan.tokens {
        let word = &text.as_str()[token.at.clone()];
        let kind = match token.kind {
            Kind::Directive => Type::Keyword,
            Kind::Word(Category::Function) => Type::Function,
            Kind::Word(Category::Constant) => Type::Constant,
            Kind::Word(_) if sorts.objects.contains(&word) => Type::Class,
            Kind::Word(_) if sorts.blocks.contains(&word) => Type::Struct,
            Kind::Word(_) => Type::Property,
            Kind::Name if own.get(&token.at.start) == Some(&What::Parameter) => Type::Parameter,
            Kind::Name if macros.contains(word) => Type::Macro,
            Kind::Name => {
                let scope = scan.macro_at(token.at.end);
                let is =
                    |what: What| scan.declarations.iter().any(|d| d.scope == scope && d.what == what && d.name == word);
                if scope.is_some() && is(What::Parameter) { Type::Parameter } else { Type::Variable }
            }
            Kind::Text | Kind::Number | Kind::Sign | Kind::Comment => continue,
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
