//! Runs the grammar over a file, piece by piece.

use super::ast::{Ast, Element};
use super::build::Builder;
use super::lex::{Lexed, lex};
use super::{Names, fault};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Sources, Span};
use pest::Parser;

/// pest's parser, made from the grammar at compile time.
#[derive(pest_derive::Parser)]
#[grammar = "../grammar/scene.pest"]
pub(super) struct SceneParser;

/// Pieces are parsed when they have reached this many tokens: few enough that pest's own stay in the cache.
const PIECE: usize = 8 * 1024;

/// At most this many errors of a file are told.
const MAX_FAULTS: usize = 20;

/// Parses a file; on errors, every one that can be told apart.
pub fn parse(sources: &Sources, file: FileId, names: &Names) -> Result<Ast, Vec<Diagnostic>> {
    let (text, base) = (sources.text(file), sources.base(file));
    let mut lexed = lex(text, base, names);
    if !lexed.faults.is_empty() {
        lexed.faults.truncate(MAX_FAULTS);
        return Err(lexed.faults);
    }
    let comments = lexed.comments.iter().map(|&(lo, hi)| Span::new(base + lo as usize, base + hi as usize)).collect();
    let mut ast = Ast { elements: vec![], comments };
    let mut faults = vec![];
    let cuts = std::mem::take(&mut lexed.cuts);
    let (mut start, mut done) = (0, 0);
    for (i, &cut) in cuts.iter().enumerate() {
        let cut = cut as usize;
        if cut - start < PIECE && i + 1 < cuts.len() {
            continue;
        }
        if parse_piece(text, &mut lexed, start..cut, base, names, Some(&mut ast.elements)).is_err() {
            // Somewhere in it is a fault: find out which of its statements are sound.
            for &fine in &cuts[done..=i] {
                let fine = fine as usize;
                if let Err(fault) = parse_piece(text, &mut lexed, start..fine, base, names, None) {
                    faults.push(*fault);
                }
                start = fine;
                if faults.len() == MAX_FAULTS {
                    return Err(faults);
                }
            }
        }
        (start, done) = (cut, i + 1);
    }
    if faults.is_empty() { Ok(ast) } else { Err(faults) }
}

/// Parses the tokens of a range; without `out`, only to see whether they are sound.
fn parse_piece(
    text: &str,
    lexed: &mut Lexed,
    range: std::ops::Range<usize>,
    base: usize,
    names: &Names,
    out: Option<&mut Vec<Element>>,
) -> Result<(), Box<Diagnostic>> {
    // The classes are ASCII, so this check is quick.
    let classes = std::mem::take(&mut lexed.classes);
    let piece = std::str::from_utf8(&classes[range.clone()]).unwrap_or("");
    let result = SceneParser::parse(Rule::chunk, piece);
    let result = match (result, out) {
        (Ok(mut pairs), Some(out)) => {
            if let Some(chunk) = pairs.next() {
                Builder::new(names, text, base, range.start, lexed).elements_into(chunk.into_inner(), "", out);
            }
            Ok(())
        }
        (Ok(_), None) => Ok(()),
        (Err(error), _) => {
            let at = match error.location {
                pest::error::InputLocation::Pos(at) | pest::error::InputLocation::Span((at, _)) => at,
            };
            let offset = |i: usize| lexed.tokens.get(i).map_or(text.len(), |t| t.start as usize);
            let end = lexed.tokens[..range.start + at].last().map_or(0, |t| t.end as usize);
            // At the end of the piece the fault lies behind its last token, not at the next one.
            let place =
                if at == range.len() { end..end } else { offset(range.start + at)..offset(range.start + at + 1) };
            Err(Box::new(fault::explain(text, place.start, base)))
        }
    };
    lexed.classes = classes;
    result
}
