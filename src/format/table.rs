//! Tables: lines of one shape that the author set in columns stay in columns.

use super::STEP;
use super::atoms::{Atoms, Item, flag};
use super::layout::columns_of;

/// Atoms of one line of the author's: whole items.
struct Row {
    from: usize,
    to: usize,
    /// It can't be indented further than this.
    indent: usize,
}

/// Gives the atoms of tables the blanks that keep their columns in line, unless lines could get longer than `width`.
pub fn pad(text: &str, atoms: &mut Atoms, width: usize) {
    let mut rows: Vec<Row> = vec![];
    let mut depth = 0;
    let mut ends = vec![];
    let mut from = 0;
    while from < atoms.row.len() {
        let mut to = from + 1;
        while to < atoms.row.len() && atoms.row[to].lines == 0 {
            to += 1;
        }
        while ends.last().is_some_and(|end| *end <= from) {
            ends.pop();
        }
        let indent = STEP * (depth + 2 * ends.len()) + STEP;
        for i in from..to {
            let atom = &atoms.row[i];
            depth += usize::from(atom.flags & flag::OPEN != 0);
            depth -= usize::from(atom.flags & flag::CLOSE != 0).min(depth);
            if atom.item == Item::Bodies {
                ends.push(atom.next as usize);
            }
        }
        let row = row(atoms, from, to, indent);
        let goes_on = |last: &Row| row.as_ref().is_some_and(|row| atoms.row[from].lines == 1 && alike(text, atoms, last, row));
        if !rows.last().is_some_and(goes_on) {
            table(text, atoms, &std::mem::take(&mut rows), width);
        }
        rows.extend(row);
        from = to;
    }
    table(text, atoms, &rows, width);
}

/// The line as a row, if it will be one: whole items, and nothing that holds bodies on several lines.
fn row(atoms: &Atoms, from: usize, to: usize, indent: usize) -> Option<Row> {
    let first = &atoms.row[from];
    let mut at = from;
    while at < to && atoms.row[at].item != Item::None {
        at = atoms.row[at].next as usize;
    }
    let comment = at < to && atoms.row[at].flags & flag::LINE_COMMENT != 0 && at + 1 == to;
    let whole = at == to || comment;
    let plain = first.flags & (flag::GLUE | flag::JOIN | flag::PACKED | flag::LOOSE) == 0 && first.lines > 0;
    let packed = |i| atoms.row[i as usize].flags & flag::PACKED != 0;
    (whole && plain && at > from + 1 && !(from as u32..at as u32).any(packed)).then_some(Row { from, to: at, indent })
}

/// Have both rows the same words and signs, and numbers, names and texts at the same places?
fn alike(text: &str, atoms: &Atoms, a: &Row, b: &Row) -> bool {
    let class = |i: usize| {
        let atom = &atoms.row[i];
        let text = &text[atom.lo as usize..atom.hi as usize];
        let sign = text.len() == 1 && !text.starts_with(|c: char| c.is_ascii_alphanumeric());
        match text.as_bytes()[0] {
            b'-' | b'+' | b'.' | b'0'..=b'9' if !sign => "0",
            b'"' => "\"",
            b'a'..=b'z' | b'A'..=b'Z' | b'_' if atom.item != Item::Word => "a",
            _ => text,
        }
    };
    a.to - a.from == b.to - b.from && (a.from..a.to).zip(b.from..b.to).all(|(i, j)| class(i) == class(j))
}

fn table(text: &str, atoms: &mut Atoms, rows: &[Row], width: usize) {
    let [first, _, ..] = rows else { return };
    let place = |row: &Row, j: usize| {
        let atom = &atoms.row[row.from + j];
        let (lo, hi) = (atom.lo as usize, atom.hi as usize);
        (lo, columns_of(&text[lo..hi]), atom.flags & flag::GLUE == 0)
    };
    // What the author wrote: columns from the beginning of the line.
    let starts: Vec<usize> = rows
        .iter()
        .map(|row| place(row, 0).0)
        .map(|lo| text[..lo].rfind(['\n', '\r']).map_or(0, |end| end + 1))
        .collect();
    let mut ends = vec![0; rows.len()];
    let mut pads: Vec<Vec<u8>> = rows.iter().map(|row| vec![0; row.to - row.from]).collect();
    let mut padded = false;
    for j in 0..first.to - first.from {
        let cells: Vec<_> = rows.iter().zip(&starts).map(|(row, start)| {
            let (lo, columns, apart) = place(row, j);
            (columns_of(&text[*start..lo]), columns, apart)
        }).collect();
        let same = |edge: &dyn Fn(&(usize, usize, bool)) -> usize| cells.iter().all(|cell| edge(cell) == edge(&cells[0]));
        let (left, right) = (same(&|cell| cell.0), same(&|cell| cell.0 + cell.1));
        let apart = cells[0].2;
        if apart && !left && !right {
            return;
        }
        let natural = |r: usize| ends[r] + usize::from(apart && j > 0);
        let edge = |r: usize| natural(r) + if left { 0 } else { cells[r].1 };
        let target = (0..rows.len()).map(edge).max().unwrap_or(0);
        let moves = apart || right && !left;
        let gaps: Vec<usize> = (0..rows.len()).map(|r| if moves { target - edge(r) } else { 0 }).collect();
        for (r, gap) in gaps.into_iter().enumerate() {
            ends[r] = ends[r] + usize::from(apart && j > 0) + gap + cells[r].1;
            pads[r][j] = u8::try_from(gap).unwrap_or(u8::MAX);
            padded |= gap > 0;
            if gap > 200 || rows[r].indent + ends[r] > width {
                return;
            }
        }
    }
    if padded {
        for (row, pads) in rows.iter().zip(pads) {
            atoms.row[row.from..row.to].iter_mut().zip(pads).for_each(|(atom, pad)| atom.pad = pad);
        }
    }
}
