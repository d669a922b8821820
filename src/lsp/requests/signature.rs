//! Signature help: the parameters of the macro or function whose call is being typed.

use super::complete;
use crate::lsp::server::{Client, Server};
use crate::lsp::words;
use crate::syntax::outline::{DeclarationKind, Pair};
use lsp_types::{
    Documentation, MarkupContent, MarkupKind, ParameterInformation, ParameterLabel, SignatureHelp, SignatureHelpParams,
    SignatureInformation,
};

/// Returns the signature of the innermost function or macro call around a position of the document.
pub fn help<S: Client>(server: &mut Server<S>, params: &SignatureHelpParams) -> Option<SignatureHelp> {
    let at = &params.text_document_position_params;
    let uri = &at.text_document.uri;
    let related = server.texts_sharing_names(uri);
    let document = server.document(uri)?;
    let offset = document.text.offset(at.position);
    let outline = &document.outline;
    let call = outline.pair_at(offset, |pair| pair.bracket == b'(' && !pair.head.is_empty())?;
    let name = outline.head(call);
    let declared = related.iter().find_map(|one| {
        let d = one.outline.declarations.iter().find(|d| d.kind == DeclarationKind::Macro && d.name == name)?;
        complete::macro_parameters(one, d)
    });
    let (parameters, about) = match declared {
        Some(parameters) => (parameters, ""),
        None => {
            let (_, arguments, summary) =
                words::function_names_arguments_summaries().find(|(other, ..)| *other == name)?;
            let inner = arguments.trim_start_matches('(').trim_end_matches(')');
            (inner.split(',').map(|part| part.trim().to_string()).filter(|part| !part.is_empty()).collect(), summary)
        }
    };
    // Count the commas of this call, but not those of nested calls, vectors and blocks.
    let is_bracket = |pair: &Pair| !matches!(pair.bracket, b'#' | b'<');
    let inner = |at: usize| outline.pair_at(at + 1, is_bracket).is_none_or(|pair| pair.opener == call.opener);
    let tokens = outline.tokens[call.opener + 1..].iter().take_while(|token| token.range.end <= offset);
    let mut depth = 0i32;
    let mut commas = 0;
    for token in tokens {
        match outline.slice(&token.range) {
            "<" => depth += 1,
            ">" => depth -= 1,
            "," if depth <= 0 && inner(token.range.start) => commas += 1,
            _ => {}
        }
    }
    let label = format!("{name}({})", parameters.join(", "));
    let information =
        |name: &String| ParameterInformation { label: ParameterLabel::Simple(name.clone()), documentation: None };
    let documentation = MarkupContent { kind: MarkupKind::Markdown, value: about.into() };
    let active = Some(commas.min(parameters.len().saturating_sub(1)) as u32);
    let signature = SignatureInformation {
        label,
        documentation: (!about.is_empty()).then_some(Documentation::MarkupContent(documentation)),
        parameters: Some(parameters.iter().map(information).collect()),
        active_parameter: active,
    };
    Some(SignatureHelp { signatures: vec![signature], active_signature: Some(0), active_parameter: active })
}
