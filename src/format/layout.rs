//! Layout of the formatter: decides which items of a body share a line, and which blocks take several lines.

use super::STEP;
use super::atoms::{Arm, Atoms, ItemKind, flag};
use super::columns::{self, Trailing};
use super::table;

/// Returns the formatted text, with lines of at most `width` columns where possible.
pub fn lay_out(text: &str, atoms: &Atoms, width: usize) -> String {
    let mut setter = Typesetter::new(text, atoms, width);
    setter.write_body(0, atoms.row.len(), 0, false);
    setter.into_aligned_text()
}

/// State of the layout, with the text written so far.
pub(super) struct Typesetter<'a> {
    pub(super) text: &'a str,
    pub(super) atoms: &'a Atoms,
    /// Maximum width of an output line, in columns.
    pub(super) width: usize,
    /// Total width of all atoms before each atom, as if all were on one line with blanks.
    sums: Vec<u32>,
    /// Number of forced line starts among the atoms up to and including each.
    breaks: Vec<u32>,
    /// Number of unmatched opening braces minus closing ones, before each atom.
    loose: Vec<i32>,
    /// Number of additional blanks before each atom, which keep a column aligned; see [`super::table`].
    pub(super) pads: Vec<u8>,
    /// Number of unmatched brackets that are open before the current position.
    pub(super) open: i32,
    out: String,
    /// Width of the current output line so far.
    pub(super) column: usize,
    line: u32,
    /// Indentation of the current output line.
    indent: usize,
    /// True if the current output line ends in a comment or a lone `#`, so that the line must end.
    commented: bool,
    trailing: Vec<Trailing>,
}

/// Atoms of one item of a body.
#[derive(Clone, Copy)]
struct Range {
    from: usize,
    to: usize,
}

/// Items of a body that share a line unless the line gets too long.
pub(super) struct Row {
    pub(super) from: usize,
    pub(super) to: usize,
    /// True if no item of the row has line breaks.
    pub(super) flat: bool,
}

impl<'a> Typesetter<'a> {
    fn new(text: &'a str, atoms: &'a Atoms, width: usize) -> Self {
        let mut setter = Self {
            text,
            atoms,
            width,
            sums: Vec::with_capacity(atoms.row.len() + 1),
            breaks: Vec::with_capacity(atoms.row.len() + 1),
            loose: Vec::with_capacity(atoms.row.len() + 1),
            pads: vec![0; atoms.row.len()],
            open: 0,
            out: String::with_capacity(text.len() + text.len() / 8),
            column: 0,
            line: 0,
            indent: 0,
            commented: false,
            trailing: vec![],
        };
        let (mut sum, mut breaks, mut loose) = (0u32, 0, 0);
        for i in 0..atoms.row.len() {
            setter.sums.push(sum);
            setter.loose.push(loose);
            breaks += u32::from(setter.must_begin_line(i));
            setter.breaks.push(breaks);
            if atoms.row[i].flags & flag::LINE_COMMENT == 0 {
                sum = sum.saturating_add((setter.blanks_before(i) + setter.atom_width(i)) as u32);
            }
            if atoms.row[i].flags & flag::UNMATCHED != 0 {
                loose += if atoms.row[i].flags & flag::OPEN != 0 { 1 } else { -1 };
            }
        }
        setter.sums.push(sum);
        setter.breaks.push(breaks);
        setter.loose.push(loose);
        setter
    }

    // ------------------------------------------------------------ measures

    pub(super) fn atom_text(&self, i: usize) -> &'a str {
        let atom = &self.atoms.row[i];
        &self.text[atom.lo as usize..atom.hi as usize]
    }

    pub(super) fn has_any_flag(&self, i: usize, flags: u16) -> bool {
        self.atoms.row[i].flags & flags != 0
    }

    /// True if the atom must begin a new line; false for the first atom, before which there is no line break.
    fn must_begin_line(&self, i: usize) -> bool {
        let Some(previous) = i.checked_sub(1) else { return false };
        let after_comment = self.must_end_line(previous) || self.is_multi_line_comment(previous);
        let joined =
            self.has_any_flag(i, flag::NO_BLANK_BEFORE | flag::SAME_LINE) || self.is_matched_closing_bracket(i);
        after_comment || self.atoms.row[i].lines > 0 && !joined
    }

    /// True if no atom may follow this one on its line.
    fn must_end_line(&self, i: usize) -> bool {
        self.has_any_flag(i, flag::LINE_COMMENT | flag::LONE)
    }

    /// True for a `}` or `]` with a partner, which can stay at the end of a line.
    fn is_matched_closing_bracket(&self, i: usize) -> bool {
        matches!(self.atom_text(i), "}" | "]") && !self.has_any_flag(i, flag::UNMATCHED)
    }

    /// True for a comment that covers several lines.
    fn is_multi_line_comment(&self, i: usize) -> bool {
        self.has_any_flag(i, flag::BLOCK_COMMENT) && self.atom_text(i).contains(['\n', '\r'])
    }

    /// Returns the number of blanks before an atom that does not begin a line.
    pub(super) fn blanks_before(&self, i: usize) -> usize {
        usize::from(self.pads[i]) + usize::from(!self.has_any_flag(i, flag::NO_BLANK_BEFORE))
    }

    pub(super) fn atom_width(&self, i: usize) -> usize {
        if self.has_any_flag(i, flag::PACKED) {
            normalize_vector_returning_width(self.atom_text(i), |_| {})
        } else {
            columns_of(self.atom_text(i))
        }
    }

    /// Returns the width in columns of the atoms from `from` to before `to` if they are on one line, without blanks
    /// before the first atom.
    pub(super) fn flat_width(&self, from: usize, to: usize) -> usize {
        (self.sums[to] - self.sums[from]) as usize - if from < to { self.blanks_in_flat_width(from) } else { 0 }
    }

    fn blanks_in_flat_width(&self, i: usize) -> usize {
        if self.has_any_flag(i, flag::LINE_COMMENT) {
            0
        } else {
            usize::from(!self.has_any_flag(i, flag::NO_BLANK_BEFORE))
        }
    }

    /// True if the atoms of a range contain no forced line break.
    pub(super) fn lacks_forced_break(&self, from: usize, to: usize) -> bool {
        from >= to || self.breaks[to - 1] == self.breaks[from] && !(from + 1 < to && self.is_multi_line_comment(from))
    }

    /// True if a range fits on the rest of the current line.
    fn fits(&self, from: usize, to: usize) -> bool {
        let gap = if from < to && !self.is_at_line_start() { self.blanks_before(from) } else { 0 };
        self.lacks_forced_break(from, to) && self.column + gap + self.flat_width(from, to) <= self.width
    }

    // ------------------------------------------------------------ writing

    pub(super) fn new_line(&mut self, indent: usize, with_blank_line: bool) {
        if self.out.is_empty() {
            return;
        }
        self.out.push('\n');
        if with_blank_line {
            self.out.push('\n');
        }
        self.line += 1 + u32::from(with_blank_line);
        self.out.extend(std::iter::repeat_n(' ', indent));
        self.column = indent;
        (self.indent, self.commented) = (indent, false);
    }

    /// True if the current line has only blanks so far.
    pub(super) fn is_at_line_start(&self) -> bool {
        self.out.as_bytes().last().is_none_or(|b| matches!(b, b'\n' | b' '))
    }

    pub(super) fn write_flat(&mut self, from: usize, to: usize) {
        (from..to).for_each(|i| self.write_atom(i));
    }

    fn write_atom(&mut self, i: usize) {
        if self.commented {
            // A comma, or another atom that no other rule breaks lines before.
            self.new_line(self.indent, false);
        }
        self.commented = self.must_end_line(i);
        if self.has_any_flag(i, flag::LINE_COMMENT) && !self.is_at_line_start() {
            return self.write_trailing_comment(i);
        }
        let gap = if self.is_at_line_start() { usize::from(self.pads[i]) } else { self.blanks_before(i) };
        self.out.extend(std::iter::repeat_n(' ', gap));
        let text = self.atom_text(i);
        self.column += gap + self.atom_width(i);
        if self.has_any_flag(i, flag::PACKED) {
            let out = &mut self.out;
            normalize_vector_returning_width(text, |part| out.push_str(part));
        } else {
            self.line += if self.is_multi_line_comment(i) { text.lines().count() as u32 - 1 } else { 0 };
            self.out.push_str(text);
            if let Some(end) = text.rfind(['\n', '\r']) {
                self.column = columns_of(&text[end + 1..]);
            }
        }
    }

    fn write_trailing_comment(&mut self, i: usize) {
        let lo = self.atoms.row[i].lo as usize;
        let start = self.text[..lo].rfind(['\n', '\r']).map_or(0, |end| end + 1);
        let written = columns_of(&self.text[start..lo]);
        self.trailing.push(Trailing { at: self.out.len(), line: self.line, end: self.column, written });
        self.out.push_str(self.atom_text(i));
    }

    /// Ends the text with a line feed, aligns its trailing comments, and returns it.
    fn into_aligned_text(mut self) -> String {
        if !self.out.is_empty() {
            self.out.push('\n');
        }
        columns::align_trailing_comments(&self.out, &self.trailing)
    }

    // ------------------------------------------------------------ bodies

    fn item_at(&self, from: usize) -> Range {
        let atom = &self.atoms.row[from];
        let to = if atom.item == ItemKind::None { from + 1 } else { atom.next as usize };
        Range { from, to: to.max(from + 1) }
    }

    /// Returns the items up to the next one that begins a line, and the index of that one.
    fn row_items_and_end(&self, from: usize, to: usize) -> (Vec<Range>, usize) {
        let (mut items, mut at) = (vec![], from);
        while at < to && (at == from || !self.must_begin_line(at)) {
            let item = self.item_at(at);
            items.push(Range { to: item.to.min(to), ..item });
            at = item.to;
        }
        (items, at.min(to))
    }

    /// Writes the items of a body as rows, one per line. If `follows_opening_bracket` is true, a comment on the line of
    /// the bracket stays there.
    fn write_body(&mut self, from: usize, to: usize, indent: usize, follows_opening_bracket: bool) {
        let mut at = from;
        if follows_opening_bracket
            && at < to
            && self.has_any_flag(at, flag::LINE_COMMENT)
            && self.atoms.row[at].lines == 0
        {
            self.write_atom(at);
            at += 1;
        }
        let (start, mut open) = (at, 0i32);
        let mut rows = vec![];
        while at < to {
            let (items, next) = self.row_items_and_end(at, to);
            let flat = self.lacks_forced_break(at, next) && items.iter().all(|item| self.kind(*item) != ItemKind::Sign);
            rows.push(Row { from: at, to: next, flat });
            at = next;
        }
        table::align_tables(self, &rows, indent);
        for Row { from, to, .. } in rows {
            let closes = self.has_any_flag(from, flag::UNMATCHED) && self.has_any_flag(from, flag::CLOSE);
            let first = indent_inside_brackets(indent, open - i32::from(closes))
                + self.continued_declaration_extra_indent(from);
            self.new_line(first, from > start && self.atoms.row[from].lines > 1);
            let (items, _) = self.row_items_and_end(from, to);
            self.write_row(&items, indent, &mut open);
        }
    }

    /// Returns the number of unmatched opening braces minus closing ones in an item. In a directive only the first arm
    /// counts, since one arm runs.
    fn brace_balance(&self, item: Range) -> i32 {
        let (from, to) = match self.arms(item.from) {
            // A macro runs elsewhere.
            _ if self.atom_text(item.from).ends_with("macro") => return 0,
            Some([first, ..]) => (first.body as usize, first.end as usize),
            _ => (item.from, item.to),
        };
        self.loose[to] - self.loose[from]
    }

    fn arms(&self, i: usize) -> Option<&'a [Arm]> {
        let atom = &self.atoms.row[i];
        (atom.item == ItemKind::Bodies).then(|| &self.atoms.arms[atom.link as usize][..])
    }

    fn kind(&self, item: Range) -> ItemKind {
        match self.atoms.row[item.from].item {
            // An additional comma, which the tree drops.
            ItemKind::None if self.atom_text(item.from) == "," => ItemKind::Separator,
            kind => kind,
        }
    }

    /// True if items of this kind can be laid out on several lines, whether or not this item is.
    fn can_span_several_lines(&self, item: Range) -> bool {
        matches!(self.kind(item), ItemKind::Block | ItemKind::Group | ItemKind::Entry | ItemKind::Bodies)
            && !self.has_any_flag(item.from, flag::NO_BLANK_BEFORE)
    }

    /// Writes items that the author wrote on one line. `open_brackets` is the number of unmatched brackets and is updated.
    fn write_row(&mut self, items: &[Range], indent: usize, open_brackets: &mut i32) {
        let flat = match items {
            [first, .., last] => self.fits(first.from, last.to),
            _ => false,
        };
        let (mut from, mut after_big) = (0, None);
        while from < items.len() {
            let mut to = if flat { items.len() } else { from + 1 };
            while to < items.len() && !self.may_break_before(&items[from..to], items[to]) {
                to += 1;
            }
            let piece = &items[from..to];
            let (a, b) = (piece[0].from, piece[to - from - 1].to);
            let big = piece.iter().any(|item| self.can_span_several_lines(*item));
            let trails = self.has_any_flag(a, flag::LINE_COMMENT);
            let indent = indent_inside_brackets(indent, *open_brackets) + self.continued_declaration_extra_indent(a);
            if !trails && after_big.is_some_and(|after| after || big || !self.fits(a, b)) {
                self.new_line(indent, false);
            }
            self.open = *open_brackets;
            self.write_piece(piece, indent);
            *open_brackets = piece
                .iter()
                .fold(*open_brackets, |open_brackets, item| (open_brackets + self.brace_balance(*item)).max(0));
            (after_big, from) = (Some(big), to);
        }
    }

    /// Returns the additional indentation of a line that continues a declaration.
    fn continued_declaration_extra_indent(&self, i: usize) -> usize {
        if self.has_any_flag(i, flag::LAYER) { STEP } else { 0 }
    }

    /// True if a line may be broken before `item`, which follows `piece`.
    fn may_break_before(&self, piece: &[Range], item: Range) -> bool {
        let (kind, before) = (self.kind(item), piece[piece.len() - 1]);
        let directive = matches!(kind, ItemKind::Declare | ItemKind::Plain | ItemKind::Bodies);
        let layer = self.has_any_flag(item.from, flag::LAYER);
        if self.has_any_flag(item.from, flag::NO_BLANK_BEFORE | flag::SAME_LINE) && !layer
            || kind == ItemKind::Separator
        {
            return false;
        }
        if self.has_any_flag(item.from, flag::COMMENT) || self.has_any_flag(before.to - 1, flag::COMMENT) {
            return true;
        }
        match (self.kind(before), kind) {
            (ItemKind::Sign, _) => directive,
            (_, ItemKind::Sign) => false,
            (ItemKind::Declare, _) => layer,
            (ItemKind::Plain, _) => directive,
            (ItemKind::Word, ItemKind::Block) | (ItemKind::Word, ItemKind::Entry) => true,
            (ItemKind::Word, _) => directive,
            (ItemKind::Value, ItemKind::Value) => {
                self.kind(piece[0]) == ItemKind::Value || self.atom_text(before.to - 1) != ","
            }
            (ItemKind::Value, ItemKind::Group) => self.atom_text(before.to - 1) == ",",
            _ => true,
        }
    }

    /// Writes items that belong together: on the current line if they fit.
    fn write_piece(&mut self, items: &[Range], indent: usize) {
        let (from, to) = (items[0].from, items[items.len() - 1].to);
        if self.fits(from, to) {
            return self.write_flat(from, to);
        }
        let (mut at, open) = (from, self.open);
        for item in items {
            if self.arms(item.from).is_some() {
                self.write_with_breaks(at, item.from, indent);
                self.write_directive(*item, indent);
            } else if self.can_span_several_lines(*item) {
                self.write_block(at, *item, indent);
            } else {
                continue;
            }
            (at, self.open) = (item.to, open);
        }
        self.write_with_breaks(at, to, indent);
    }

    /// Writes the atoms from `at` on and the body in brackets that follows them, on several lines.
    fn write_block(&mut self, at: usize, item: Range, indent: usize) {
        let open = match self.kind(item) {
            ItemKind::Block => self.atoms.row[item.from].link as usize,
            _ => item.from,
        };
        let close = self.atoms.row[open].link as usize;
        self.write_with_breaks(at, open + 1, indent);
        if close > open + 1 {
            let body = self.write_opening_line_values(open + 1, close, self.kind(item) == ItemKind::Entry, indent);
            self.write_body(body, close, indent + STEP, true);
        }
        self.new_line(indent, false);
        self.write_flat(close, item.to);
    }

    /// Writes the values that stay on the opening bracket's line, as in `sphere { 0, 1`. Returns the index of the rest.
    fn write_opening_line_values(&mut self, from: usize, to: usize, is_entry: bool, indent: usize) -> usize {
        let (items, next) = self.row_items_and_end(from, to);
        // A comma never begins a line, unless it is the first item.
        let stays = |item: &&Range| matches!(self.kind(**item), ItemKind::Value | ItemKind::Separator);
        let begins = items.first().is_none_or(|first| self.kind(*first) == ItemKind::Separator);
        let values = if begins { 0 } else { items.iter().take_while(stays).count() };
        let trails = |item: &Range| self.has_any_flag(item.from, flag::LINE_COMMENT);
        let small = items.iter().all(|item| !self.can_span_several_lines(*item) && !trails(item));
        let held = |item: &Range| self.has_any_flag(item.from, flag::SAME_LINE | flag::NO_BLANK_BEFORE);
        let end = match () {
            () if values == 0 || self.must_begin_line(from) || items.get(values).is_some_and(held) => from,
            // Only the closing bracket would not fit.
            () if !is_entry && next == to && values == items.len() && self.lacks_forced_break(from, to) => from,
            () if next < to && small && !is_entry => next,
            () if items.get(values).is_some_and(trails) || next == to || is_entry => {
                items.get(values).map_or(next, |item| item.from)
            }
            () => from,
        };
        if end == from || !is_entry && !self.fits(from, end) {
            return from;
        }
        self.write_with_breaks(from, end, indent + STEP);
        end
    }

    /// Writes a directive with bodies on several lines.
    fn write_directive(&mut self, item: Range, indent: usize) {
        let Some(arms) = self.arms(item.from) else { return };
        for (i, arm) in arms.iter().enumerate() {
            let (head, body, end) = (arm.head as usize, arm.body as usize, arm.end as usize);
            let indent = indent + if arm.is_switch_arm { STEP } else { 0 };
            let on_line = arm.is_switch_arm && !self.must_begin_line(head) && self.fits(head, end) && i > 1;
            if i > 0 && !on_line {
                self.new_line(indent, self.atoms.row[head].lines > 1);
            }
            if arm.is_switch_arm && self.fits(head, end) {
                self.write_flat(head, end);
                continue;
            }
            self.write_with_breaks(head, body, indent);
            self.write_body(body, end, indent + STEP, true);
        }
        let end = arms.last().map_or(item.from, |arm| arm.end as usize);
        self.new_line(indent, false);
        self.write_flat(end, item.to);
    }
}

/// Returns the indentation inside of `open` unmatched brackets.
pub(super) fn indent_inside_brackets(indent: usize, open: i32) -> usize {
    indent + STEP * open.clamp(0, 20).unsigned_abs() as usize
}

/// Returns the width of a text on one line, in columns.
pub(super) fn columns_of(text: &str) -> usize {
    if text.is_ascii() { text.len() } else { text.chars().count() }
}

/// Passes the normalised parts of a vector of numbers to `part`, and returns their total width.
fn normalize_vector_returning_width(text: &str, mut part: impl FnMut(&str)) -> usize {
    let (mut columns, mut first) = (2, true);
    part("<");
    for number in text.split(|c: char| matches!(c, '<' | '>' | ',') || c <= ' ').filter(|n| !n.is_empty()) {
        if !std::mem::take(&mut first) {
            part(", ");
            columns += 2;
        }
        part(number);
        columns += number.len();
    }
    part(">");
    columns
}
