//! Runs the grammar over a file, piece by piece.

use super::ast::{Ast, Element};
use super::build::Builder;
use super::scan::{Scan, scan};
use super::{Names, fault};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Sources, Span};
use pest::Parser;

/// pest's parser, made from the grammar at compile time.
#[derive(pest_derive::Parser)]
#[grammar = "../grammar/scene.pest"]
pub(super) struct SceneParser;

/// Pieces are parsed when they have reached this many bytes: few enough that pest's tokens stay in the cache.
const PIECE: usize = 64 * 1024;

/// At most this many errors of a file are told.
const MAX_FAULTS: usize = 20;

/// Parses a file; on errors, every one that can be told apart.
pub fn parse(sources: &Sources, file: FileId, names: &Names) -> Result<Ast, Vec<Diagnostic>> {
    let (text, base) = (sources.text(file), sources.base(file));
    let Scan { cuts, comments, mut faults } = scan(text, base);
    if !faults.is_empty() {
        faults.truncate(MAX_FAULTS);
        return Err(faults);
    }
    let mut elements = vec![];
    let (mut start, mut done) = (0, 0);
    for (i, &cut) in cuts.iter().enumerate() {
        let cut = cut as usize;
        if cut - start < PIECE && i + 1 < cuts.len() {
            continue;
        }
        if parse_piece(text, start..cut, base, names, &mut elements).is_err() {
            // Somewhere in it is a fault: find out which of its statements are sound.
            for &fine in &cuts[done..=i] {
                let fine = fine as usize;
                if let Err(fault) = parse_piece(text, start..fine, base, names, &mut vec![]) {
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
    if !faults.is_empty() {
        return Err(faults);
    }
    let comments = comments.iter().map(|&(lo, hi)| Span::new(base + lo as usize, base + hi as usize)).collect();
    Ok(Ast { elements, comments })
}

fn parse_piece(
    text: &str,
    range: std::ops::Range<usize>,
    base: usize,
    names: &Names,
    out: &mut Vec<Element>,
) -> Result<(), Box<Diagnostic>> {
    let piece = &text[range.clone()];
    match SceneParser::parse(Rule::chunk, piece) {
        Ok(mut pairs) => {
            let builder = Builder::new(names, base + range.start);
            if let Some(chunk) = pairs.next() {
                builder.elements_into(chunk.into_inner(), "", out);
            }
            Ok(())
        }
        Err(error) => {
            let at = match error.location {
                pest::error::InputLocation::Pos(at) | pest::error::InputLocation::Span((at, _)) => at,
            };
            Err(Box::new(fault::explain(piece, at, base + range.start)))
        }
    }
}
