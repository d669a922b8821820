//! Alignment of comments at the ends of lines: comments that the author aligned stay aligned.

use rustc_hash::FxHashMap;

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
pub fn align_trailing_comments(text: &str, comments: &[Trailing]) -> String {
    let columns = aligned_comment_columns(comments);
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

/// Returns the new column of each comment. Comments that share a column of the author's text are a group as long as each
/// is near the previous one. A group's widest line decides its column, so that groups with equal new columns have the
/// same column after the next pass, in which they are one group.
fn aligned_comment_columns(comments: &[Trailing]) -> Vec<usize> {
    let mut groups: Vec<Vec<usize>> = vec![];
    // Index of the latest group in each column of the author's text.
    let mut latest: FxHashMap<usize, usize> = FxHashMap::default();
    for (i, comment) in comments.iter().enumerate() {
        let near =
            |group: &&usize| groups[**group].last().is_some_and(|last| comment.line - comments[*last].line <= NEAR);
        match latest.get(&comment.written).filter(near) {
            Some(group) => groups[*group].push(i),
            None => {
                latest.insert(comment.written, groups.len());
                groups.push(vec![i]);
            }
        }
    }
    let mut columns = vec![0; comments.len()];
    for group in groups {
        let column = group.iter().map(|i| comments[*i].end).max().unwrap_or(0) + APART;
        group.iter().for_each(|i| columns[*i] = column);
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::{Trailing, aligned_comment_columns};

    #[test]
    fn comments_in_columns_that_were_assigned_keep_them() {
        let mut seed = 1525u32;
        let mut random = |n: u32| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 16) % n
        };
        for _ in 0..1000 {
            let mut line = 0;
            let comment = |_| {
                line += 1 + random(8) / 7 * random(9);
                let end = random(8) as usize;
                Trailing { at: 0, line, end, written: end + random(12) as usize }
            };
            let mut comments: Vec<Trailing> = (0..40).map(comment).collect();
            let once = aligned_comment_columns(&comments);
            comments.iter_mut().zip(&once).for_each(|(comment, column)| comment.written = *column);
            assert_eq!(aligned_comment_columns(&comments), once);
        }
    }
}
