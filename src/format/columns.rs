//! Comments behind lines: those that the author set in a column stay in one.

/// A comment behind something on its line.
pub struct Trailing {
    /// Its first byte in the new text.
    pub at: usize,
    /// Its line there, from 0.
    pub line: u32,
    /// Columns of what stands before it there.
    pub end: usize,
    /// Columns of what stood before it in the author's text, blanks and all.
    pub written: usize,
}

/// Blanks before a comment, at least.
const APART: usize = 2;

/// Comments no further apart than this many lines share a column if the author gave them one.
const NEAR: u32 = 6;

/// Puts blanks before comments: those that stood in one column stand in one again.
pub fn align(text: &str, comments: &[Trailing]) -> String {
    let columns = columns(comments);
    let mut out = String::with_capacity(text.len() + comments.len() * 8);
    let mut at = 0;
    for (comment, column) in comments.iter().zip(columns) {
        out.push_str(&text[at..comment.at]);
        out.extend(std::iter::repeat_n(' ', column.saturating_sub(comment.end)));
        at = comment.at;
    }
    out.push_str(&text[at..]);
    out
}

fn columns(comments: &[Trailing]) -> Vec<usize> {
    let mut groups: Vec<Vec<usize>> = vec![];
    for (i, comment) in comments.iter().enumerate() {
        // The groups of the last lines; the others are out of reach.
        let near = |group: &&mut Vec<usize>| {
            group.last().is_some_and(|last| {
                comments[*last].written == comment.written && comment.line - comments[*last].line <= NEAR
            })
        };
        match groups.iter_mut().rev().take(NEAR as usize).find(near) {
            Some(group) => group.push(i),
            None => groups.push(vec![i]),
        }
    }
    let mut columns = vec![0; comments.len()];
    for group in groups {
        let column = group.iter().map(|i| comments[*i].end).max().unwrap_or(0) + APART;
        group.iter().for_each(|i| columns[*i] = column);
    }
    columns
}
