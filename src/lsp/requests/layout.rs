//! Layout of a text: formatting, folding, and the stepwise extension of a selection.

use crate::format::{WIDTH, decode};
use crate::lsp::document::{BASE, Document};
use crate::lsp::server::{Client, Server};
use crate::lsp::text::Text;
use crate::syntax::outline::{Pair, TokenKind};
use lsp_types::{
    DocumentFormattingParams, DocumentRangeFormattingParams, FoldingRange, FoldingRangeKind, FoldingRangeParams,
    Position, Range, SelectionRange, SelectionRangeParams, TextEdit,
};

/// Returns the edits that format a document as `durer fmt` does; `None` for a text with syntax errors.
pub fn format<S: Client>(server: &mut Server<S>, params: &DocumentFormattingParams) -> Option<Vec<TextEdit>> {
    edits(server.document(&params.text_document.uri)?)
}

/// Returns the edits of [`format()`] that touch the lines of a range.
pub fn format_range<S: Client>(
    server: &mut Server<S>,
    params: &DocumentRangeFormattingParams,
) -> Option<Vec<TextEdit>> {
    let wanted = params.range;
    let touches =
        |edit: &TextEdit| edit.range.start.line <= wanted.end.line && wanted.start.line <= edit.range.end.line;
    Some(edits(server.document(&params.text_document.uri)?)?.into_iter().filter(touches).collect())
}

/// Returns one text edit for each sequence of lines that formatting changes.
fn edits(document: &Document) -> Option<Vec<TextEdit>> {
    let old = document.text.as_str();
    let new = Text::new(decode(old.as_bytes().to_vec()).ok()?.formatted(BASE, WIDTH).ok()?);
    let (a, b) = (document.text.lines_with_ends(), new.lines_with_ends());
    let mut out = vec![];
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        if i < a.len() && j < b.len() && a[i] == b[j] {
            (i, j) = (i + 1, j + 1);
            continue;
        }
        let (k, l) = next_equal_lines(&a, &b, i, j);
        let start = Position::new(i as u32, 0);
        let end = if k < a.len() { Position::new(k as u32, 0) } else { document.text.position(old.len()) };
        out.push(TextEdit { range: Range::new(start, end), new_text: b[j..l].concat() });
        (i, j) = (k, l);
    }
    Some(out)
}

/// Returns the indices in `a` and `b` of the nearest pair of equal lines after the indices `i` and `j`, whose lines differ;
/// the lengths of both if no pair is near.
fn next_equal_lines(a: &[&str], b: &[&str], i: usize, j: usize) -> (usize, usize) {
    const MAX_DISTANCE: usize = 60;
    for apart in 1..MAX_DISTANCE {
        for k in 0..=apart {
            let (x, y) = (i + k, j + apart - k);
            // Ignore lines that consist of one brace, which are frequent.
            if x < a.len() && y < b.len() && a[x] == b[y] && a[x].trim().len() > 1 {
                return (x, y);
            }
        }
    }
    (a.len(), b.len())
}

/// Returns the folding ranges of a document: blocks, directives with bodies, and comments that extend over several
/// lines.
pub fn folds<S: Client>(server: &mut Server<S>, params: &FoldingRangeParams) -> Option<Vec<FoldingRange>> {
    let document = server.document(&params.text_document.uri)?;
    let (text, outline) = (&document.text, &document.outline);
    let line = |offset: usize| text.position(offset).line;
    let mut out: Vec<FoldingRange> = vec![];
    for pair in outline.pairs.iter().filter(|pair| is_foldable(pair)) {
        // The closing line remains visible.
        let (start, end) = (line(pair.range.start), line(pair.range.end).saturating_sub(1));
        if start < end && out.last().is_none_or(|last| last.start_line != start) {
            out.push(fold(start, end, FoldingRangeKind::Region));
        }
    }
    let starting = outline.comments.iter().filter(|comment| outline.line_at(comment.start).is_first);
    let whole: Vec<(u32, u32)> =
        starting.map(|comment| (line(comment.start), line(text.as_str()[..comment.end].trim_end().len()))).collect();
    for run in whole.chunk_by(|a, b| a.1 + 1 == b.0) {
        let (start, end) = (run[0].0, run[run.len() - 1].1);
        if start < end {
            out.push(fold(start, end, FoldingRangeKind::Comment));
        }
    }
    Some(out)
}

/// True for bracket pairs that the server offers for folding and selection: closed ones other than `<…>`.
fn is_foldable(pair: &Pair) -> bool {
    pair.closer.is_some() && pair.bracket != b'<'
}

fn fold(start_line: u32, end_line: u32, kind: FoldingRangeKind) -> FoldingRange {
    FoldingRange { start_line, end_line, kind: Some(kind), ..FoldingRange::default() }
}

/// Returns the nested selection ranges at each position: the word, the contents of its brackets, the brackets with
/// their name, and so on up to the whole text.
pub fn selections<S: Client>(server: &mut Server<S>, params: &SelectionRangeParams) -> Option<Vec<SelectionRange>> {
    let document = server.document(&params.text_document.uri)?;
    Some(params.positions.iter().map(|at| selection(document, document.text.offset(*at))).collect())
}

fn selection(document: &Document, offset: usize) -> SelectionRange {
    let (text, outline) = (&document.text, &document.outline);
    let whole = 0..text.as_str().len();
    let mut ranges = Vec::from([whole]);
    let touches = |pair: &&Pair| is_foldable(pair) && pair.range.start <= offset && offset <= pair.range.end;
    for pair in outline.pairs.iter().filter(touches) {
        let Pair { head, range, .. } = pair;
        ranges.push(head.start.min(range.start)..range.end);
        if pair.bracket != b'#' && range.len() > 2 && range.start < offset && offset < range.end {
            ranges.push(range.start + 1..range.end - 1);
        }
    }
    let comment = outline.comment_at(offset).cloned();
    let token = outline.token_at(offset).filter(|token| comment.is_none() || token.kind != TokenKind::Sign);
    ranges.extend(token.map(|token| token.range.clone()).or(comment));
    let mut out: Option<SelectionRange> = None;
    for range in ranges {
        let range = text.range(range);
        // Each range must be inside of the previous one.
        let fits = |outer: &SelectionRange| {
            outer.range.start <= range.start && range.end <= outer.range.end && outer.range != range
        };
        if out.as_ref().is_none_or(fits) {
            out = Some(SelectionRange { range, parent: out.map(Box::new) });
        }
    }
    out.unwrap_or(SelectionRange { range: Range::default(), parent: None })
}
