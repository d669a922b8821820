//! Alignment of tables: columns in rows of equal structure that the author aligned stay aligned.

use super::atoms::{ItemKind, flag};
use super::layout::{Row, Typesetter, columns_of};

/// Adds the blanks that align the columns of tables, unless a line would get too long.
pub fn align_tables(setter: &mut Typesetter, rows: &[Row], indent: usize) {
    let mut from = 0;
    while from < rows.len() {
        let mut to = from + 1;
        while to < rows.len() && has_same_structure(setter, &rows[from], &rows[to]) {
            to += 1;
        }
        // A neighbour that is broken may become rows of the same shape.
        let before = from > 0 && needs_more_lines(setter, &rows[from - 1], indent);
        let after = rows.get(to).is_some_and(|row| needs_more_lines(setter, row, indent));
        if to > from + 1
            && !before
            && !after
            && let Some(pads) = alignment_blanks(setter, &rows[from..to], indent)
        {
            for (row, pads) in rows[from..to].iter().zip(pads) {
                setter.pads[row.from..row.from + pads.len()].copy_from_slice(&pads);
            }
        }
        from = to;
    }
}

/// True if a row needs more lines than in the author's text.
fn needs_more_lines(setter: &Typesetter, row: &Row, indent: usize) -> bool {
    let single = setter.atoms.row[row.from].next as usize == row.to;
    !single && (!row.flat || indent + setter.flat_width(row.from, row.to) > setter.width)
}

/// Returns the indices of a row's atoms, without a comma or comment at its end, since the last row has no comma.
fn row_atoms_without_comma(setter: &Typesetter, row: &Row) -> std::ops::Range<usize> {
    let to = row.to - usize::from(setter.has_any_flag(row.to - 1, flag::LINE_COMMENT));
    row.from..to - usize::from(to > row.from + 1 && setter.atom_text(to - 1) == ",")
}

/// True if both rows are one line each, without a blank line between them, and have the same words and signs, and numbers,
/// names and strings at the same positions.
fn has_same_structure(setter: &Typesetter, first: &Row, next: &Row) -> bool {
    let (a, b) = (row_atoms_without_comma(setter, first), row_atoms_without_comma(setter, next));
    let together = first.flat && next.flat && setter.atoms.row[next.from].lines == 1;
    together
        && a.len() > 1
        && a.len() == b.len()
        && a.zip(b).all(|(i, j)| structure_class(setter, i) == structure_class(setter, j))
}

fn structure_class<'a>(setter: &Typesetter<'a>, i: usize) -> &'a str {
    let text = setter.atom_text(i);
    let sign = text.len() == 1 && !text.starts_with(|c: char| c.is_ascii_alphanumeric());
    match text.as_bytes()[0] {
        b'-' | b'+' | b'.' | b'0'..=b'9' if !sign => "0",
        b'"' => "\"",
        b'a'..=b'z' | b'A'..=b'Z' | b'_' if setter.atoms.row[i].item != ItemKind::Word => "a",
        _ => text,
    }
}

/// Position of an atom in the author's text: its column and width.
#[derive(Clone, Copy)]
struct Cell {
    start: usize,
    columns: usize,
}

/// Returns the numbers of additional blanks before the atoms of each row; `None` if all are 0, because the author aligned
/// no column or the columns are aligned without blanks, or if a line would get too long.
fn alignment_blanks(setter: &Typesetter, rows: &[Row], indent: usize) -> Option<Vec<Vec<u8>>> {
    let text = setter.text;
    let begins = |lo: usize| text[..lo].rfind(['\n', '\r']).map_or(0, |end| end + 1);
    let lo = |i: usize| setter.atoms.row[i].lo as usize;
    let lines: Vec<usize> = rows.iter().map(|row| begins(lo(row.from))).collect();
    let mut ends = vec![indent; rows.len()];
    let mut pads: Vec<Vec<u8>> = vec![vec![]; rows.len()];
    for j in 0..row_atoms_without_comma(setter, &rows[0]).len() {
        let cell = |(row, line): (&Row, &usize)| Cell {
            start: columns_of(&text[*line..lo(row.from + j)]),
            columns: setter.atom_width(row.from + j),
        };
        let column: Vec<Cell> = rows.iter().zip(&lines).map(cell).collect();
        let left = column.iter().all(|cell| cell.start == column[0].start);
        let right = column.iter().all(|cell| cell.start + cell.columns == column[0].start + column[0].columns);
        let apart = !setter.has_any_flag(rows[0].from + j, flag::NO_BLANK_BEFORE);
        let gap = usize::from(apart && j > 0);
        let edge = |r: usize| ends[r] + gap + if left { 0 } else { column[r].columns };
        let target = (0..rows.len()).map(edge).max()?;
        let blanks: Vec<usize> =
            (0..rows.len()).map(|r| if left && apart || right && !left { target - edge(r) } else { 0 }).collect();
        for (r, blanks) in blanks.into_iter().enumerate() {
            ends[r] += gap + blanks + column[r].columns;
            pads[r].push(u8::try_from(blanks).ok()?);
            // A comma may follow.
            if ends[r] >= setter.width {
                return None;
            }
        }
    }
    pads.iter().flatten().any(|pad| *pad > 0).then_some(pads)
}
