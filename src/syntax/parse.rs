//! Runs the grammar over a file, in pieces of limited size.

use super::ast::{Ast, Element};
use super::build::Builder;
use super::lex::{Lexed, lex};
use super::tokens::Tokens;
use super::{Names, Outline, blame};
use crate::diagnostic::{Diagnostic, codes};
use crate::source::{FileId, Sources, Span};
use pest::Parser;
use std::ops::Range;

/// pest's parser, made from the grammar at compile time.
#[derive(pest_derive::Parser)]
#[grammar = "../grammar/scene.pest"]
pub(super) struct SceneParser;

/// Number of tokens that are parsed together: few enough that pest's own tokens stay in the CPU cache.
const PIECE: usize = 8 * 1024;

/// Maximum number of errors of a file that are reported.
const MAX_FAULTS: usize = 20;

/// The scene text to be parsed, with its global offset and its table of names.
pub(super) struct Source<'t> {
    pub(super) text: &'t str,
    /// Global offset of the text's first byte.
    pub(super) base_in_sources: usize,
    pub(super) names: &'t Names,
    /// True if each token is an element of its own.
    pub(super) single: bool,
}

/// Size of the syntax elements that the parser produces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Granularity {
    /// A complete block, call or expression is one element.
    #[default]
    Whole,
    /// Each token is an element, except that directives are complete. The rendered scene is the same.
    Tokens,
}

/// Parses a file into a syntax tree and the faults of its text, such as unbalanced directives, strings and comments
/// without an end, and brackets that nest too deeply. A tree is returned even for a faulty text.
pub fn parse(sources: &Sources, file: FileId, names: &Names, granularity: Granularity) -> (Ast, Vec<Diagnostic>) {
    parse_text(sources.text(file), sources.base(file), names, granularity)
}

/// Parses a text whose first byte has the global offset `base_in_sources`: a file, or a part of one between two
/// positions where no bracket and no directive is open.
pub fn parse_text(
    text: &str,
    base_in_sources: usize,
    names: &Names,
    granularity: Granularity,
) -> (Ast, Vec<Diagnostic>) {
    let single = granularity == Granularity::Tokens;
    let lexed = lex(text, base_in_sources, names, !single);
    let span = |token: &u32| {
        let token = lexed.tokens[*token as usize];
        Span::new(base_in_sources + token.start as usize, base_in_sources + token.end as usize)
    };
    let unclosed = lexed.unclosed.iter().map(span).collect();
    let (mut elements, mut piece_faults) = (vec![], vec![]);
    // pest must not follow a nesting that is too deep.
    let source = Source { text, base_in_sources, names, single };
    let too_deep = lexed.faults.iter().any(|fault| fault.code == codes::TOO_DEEP);
    let mut start = 0;
    for (i, &cut) in lexed.cuts.iter().enumerate() {
        let cut = cut as usize;
        if too_deep || cut - start < PIECE && i + 1 < lexed.cuts.len() {
            continue;
        }
        if let Err(fault) = parse_piece(&source, &lexed, start..cut, &mut elements) {
            piece_faults.push(*fault);
        }
        start = cut;
    }
    let (tokens, mut faults) = tokens_and_faults(lexed, text, base_in_sources);
    faults.extend(piece_faults);
    (Ast { elements, tokens, unclosed }, faults)
}

/// Splits a text into tokens and returns them with their faults: those that [`parse_text`] finds, except for tokens
/// that the grammar rejects. The text's first byte has the global offset `base_in_sources`.
pub fn tokens_of(text: &str, base_in_sources: usize) -> (Tokens, Vec<Diagnostic>) {
    tokens_and_faults(lex(text, base_in_sources, &Names::default(), true), text, base_in_sources)
}

/// Returns the tokens of a text and their faults, including directives without `#end`.
fn tokens_and_faults(mut lexed: Lexed, text: &str, base_in_sources: usize) -> (Tokens, Vec<Diagnostic>) {
    let mut faults = std::mem::take(&mut lexed.faults);
    let unended = lexed.unended;
    let tokens = Tokens::new(lexed, base_in_sources);
    if unended > 0 && faults.len() < MAX_FAULTS {
        faults.extend(blame::unclosed_directive_errors(&Outline::new(text, &tokens)));
    }
    faults.truncate(MAX_FAULTS);
    (tokens, faults)
}

/// Parses a range of tokens into elements.
fn parse_piece(
    source: &Source,
    lexed: &Lexed,
    token_range: Range<usize>,
    out: &mut Vec<Element>,
) -> Result<(), Box<Diagnostic>> {
    let &Source { text, base_in_sources, .. } = source;
    // The classes are ASCII, so this check is quick.
    let piece = std::str::from_utf8(&lexed.classes[token_range.clone()]).unwrap_or("");
    match SceneParser::parse(Rule::chunk, piece) {
        Ok(mut pairs) => {
            if let Some(chunk) = pairs.next() {
                Builder::new(source, lexed, token_range.start).piece(chunk, out);
            }
            Ok(())
        }
        // The grammar accepts any sequence of tokens whose directives balance.
        Err(error) => {
            let at = match error.location {
                pest::error::InputLocation::Pos(at) | pest::error::InputLocation::Span((at, _)) => at,
            };
            let token = lexed.tokens.get(token_range.start + at).or(lexed.tokens.last());
            let (lo, hi) = token.map_or((0, 0), |t| (t.start as usize, t.end as usize));
            let found = &text[lo..hi];
            Err(Box::new(Diagnostic::new(
                codes::SYNTAX,
                Span::new(base_in_sources + lo, base_in_sources + hi),
                format!("`{found}` is not allowed here"),
            )))
        }
    }
}
