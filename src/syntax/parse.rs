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
    let blanked = blank_out(text, &comments);
    let text = &*blanked;
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
    blanked: &str,
    range: std::ops::Range<usize>,
    base: usize,
    names: &Names,
    out: &mut Vec<Element>,
) -> Result<(), Box<Diagnostic>> {
    let piece = &blanked[range.clone()];
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

/// The text with a space for each byte of a comment or of a blank that is not ASCII, so that places stay what they are.
fn blank_out<'t>(text: &'t str, comments: &[(u32, u32)]) -> std::borrow::Cow<'t, str> {
    let odd = |(i, c): (usize, char)| ODD_BLANKS.contains(&c).then(|| (i as u32, (i + c.len_utf8()) as u32));
    let odd: Vec<_> = if text.is_ascii() { vec![] } else { text.char_indices().filter_map(odd).collect() };
    if comments.is_empty() && odd.is_empty() {
        return text.into();
    }
    let (mut out, mut done) = (String::with_capacity(text.len()), 0);
    for &(lo, hi) in comments.iter() {
        out.push_str(&text[done..lo as usize]);
        out.extend(std::iter::repeat_n(' ', (hi - lo) as usize));
        done = hi as usize;
    }
    out.push_str(&text[done..]);
    for (lo, hi) in odd {
        // A comment may have blanked it already; `get` fails in the middle of a character only.
        if out.get(lo as usize..hi as usize).is_some() {
            out.replace_range(lo as usize..hi as usize, &" ".repeat((hi - lo) as usize));
        }
    }
    out.into()
}

/// No-break space and byte-order mark: text that was copied from elsewhere has them.
const ODD_BLANKS: [char; 2] = ['\u{A0}', '\u{FEFF}'];
