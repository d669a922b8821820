//! Alignment of comments at the ends of lines: comments that the author aligned stay aligned.

/// A comment at the end of a line, after other text.
pub struct Trailing {
    /// Offset of the comment's first byte in the new text.
    pub at: usize,
    /// Line of the comment in the new text, from 0.
    pub line: u32,
    /// Width of the line before the comment in the new text.
    pub end: usize,
    /// Width of the line before the comment in the author's text, including the blanks before the comment.
    pub written: usize,
}

/// Minimum number of blanks between a line's text and its comment.
const APART: usize = 2;

/// Maximum distance, in lines, of two aligned comments that stay in one column.
const NEAR: u32 = 6;

/// Inserts blanks before comments at the ends of lines, so that comments that the author aligned are aligned again.
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
        // The groups of the last lines; earlier ones are too far away.
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
