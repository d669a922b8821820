//! Breaks lines outside of bodies: in expressions, parentheses and arguments.

use super::STEP;
use super::atoms::{ItemKind, flag};
use super::layout::{Typesetter, indent_inside_brackets};

/// Open brackets, counted by the line that opens them.
#[derive(Default)]
struct Nesting {
    open: Vec<u32>,
    line: u32,
    /// Number of opening minus closing brackets.
    net: i32,
}

impl Nesting {
    fn count_atom(&mut self, opens: bool, closes: bool) {
        self.net += i32::from(opens) - i32::from(closes);
        if opens {
            self.open.push(self.line);
        } else if closes {
            self.open.pop();
        }
    }

    /// Returns the number of lines with open brackets, each of which indents by one step; at least 1.
    fn open_bracket_line_count(&self) -> usize {
        let others = self.open.windows(2).filter(|pair| pair[0] != pair[1]).count();
        (others + usize::from(!self.open.is_empty())).clamp(1, 20)
    }
}

impl Typesetter<'_> {
    /// Writes atoms with an indentation; keeps the author's line breaks, and adds more where a line is too long.
    pub(super) fn write_with_breaks(&mut self, from: usize, to: usize, indent: usize) {
        let (mut nesting, mut at) = (Nesting::default(), from);
        let (body, mut open, mut indent) =
            (indent.saturating_sub(indent_inside_brackets(0, self.open)), self.open, indent);
        while at < to {
            let mut hard = at + 1;
            while hard < to && self.lacks_forced_break(at, hard + 1) {
                hard += 1;
            }
            while at < hard {
                let end = self.next_line_start_atom(at, hard, nesting.open.len());
                for i in at..end {
                    nesting.count_atom(self.has_any_flag(i, flag::OPEN), self.has_any_flag(i, flag::CLOSE));
                }
                self.write_flat(at, end);
                at = end;
                if at < to {
                    nesting.line += 1;
                    if self.is_item(at) {
                        // When the text is read again, this is a row of the body.
                        open = (open + nesting.net).max(0);
                        nesting = Nesting::default();
                        indent = indent_inside_brackets(body, open);
                        self.new_line(indent, false);
                    } else {
                        self.new_line(indent + STEP * nesting.open_bracket_line_count(), false);
                    }
                }
            }
        }
    }

    /// Returns the index of the atom that begins the next line: `to`, or the atom after the best position for a break,
    /// which is outside of as many brackets as possible.
    fn next_line_start_atom(&self, from: usize, to: usize, bracket_depth: usize) -> usize {
        let gap = if self.is_at_line_start() { 0 } else { self.blanks_before(from) };
        let room = self.width.saturating_sub(self.column + gap);
        if self.flat_width(from, to) <= room {
            return to;
        }
        let (mut bracket_depth, mut best) = (bracket_depth, None);
        for i in from..to {
            let width = self.flat_width(from, i);
            if i > from && self.may_break_before_atom(i) {
                if width > room && best.is_some() {
                    break;
                }
                let cost = (width < room / 3, bracket_depth * 8 + self.binding_strength_to_next(i - 1));
                if width > room {
                    return i;
                }
                if best.is_none_or(|(least, _)| cost <= least) {
                    best = Some((cost, i));
                }
            }
            bracket_depth += usize::from(self.has_any_flag(i, flag::OPEN));
            bracket_depth = bracket_depth.saturating_sub(usize::from(self.has_any_flag(i, flag::CLOSE)));
        }
        best.map_or(to, |(_, i)| i)
    }

    fn is_item(&self, i: usize) -> bool {
        self.atoms.row[i].item != ItemKind::None
    }

    /// True if a line may be broken before atom `i`: not before operators, and not between a word and its value.
    fn may_break_before_atom(&self, i: usize) -> bool {
        let word = matches!(self.atoms.row[i - 1].item, ItemKind::Word | ItemKind::Plain);
        let held = self.has_any_flag(i, flag::NO_BLANK_BEFORE | flag::SAME_LINE | flag::OPERATOR | flag::COMMENT);
        !(held || word && self.is_item(i))
    }

    /// Returns the strength with which an atom binds the following one: a line is broken after weak atoms first.
    fn binding_strength_to_next(&self, i: usize) -> usize {
        match self.atom_text(i) {
            "," => 1,
            "?" | ":" | "|" | "&" => 2,
            "+" | "-" => 4,
            "*" | "/" => 5,
            _ if self.has_any_flag(i, flag::OPERATOR) => 3,
            _ if self.has_any_flag(i, flag::CLOSE) => 1,
            _ => 6,
        }
    }
}
