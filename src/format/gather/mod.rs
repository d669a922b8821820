//! Makes the formatter's list of atoms from the syntax tree and the tokens.

mod inside;

use super::atoms::flag::*;
use super::atoms::{Atom, Atoms, ItemKind};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::{Piece, Tokens, is_ignored_char};

/// Length of a list of numbers, in bytes, above which each vector is one atom.
const LONG_LIST: usize = 100_000;

/// Returns the atoms of a whole text, whose first byte has the global offset `base_in_sources`.
pub fn gather(text: &str, base_in_sources: usize, ast: &Ast) -> Atoms {
    let pieces = Pieces::new(&ast.tokens);
    let mut gatherer = Gatherer { text, base_in_sources, pieces, out: Atoms::default(), at: 0, pending: 0, block: "" };
    gatherer.gather_body(&ast.elements);
    gatherer.gather_up_to(text.len());
    gatherer.gather_stray_characters(text.len());
    gatherer.out
}

struct Pieces<'a> {
    all: Box<dyn Iterator<Item = Piece> + 'a>,
    next: Option<Piece>,
}

impl<'a> Pieces<'a> {
    fn new(tokens: &'a Tokens) -> Self {
        let mut all = Box::new(tokens.tokens_and_comments());
        Self { next: all.next(), all }
    }

    /// Returns the next token or comment of the text, and moves past it.
    fn advance(&mut self) -> Option<Piece> {
        std::mem::replace(&mut self.next, self.all.next())
    }
}

/// True if a blank between two adjacent tokens would change them: `0.5.6` is another text than `0.5 .6`.
fn changes_if_spaced(last_byte: u8, next_first_byte: u8) -> bool {
    let numeric = |byte: u8| byte.is_ascii_digit() || byte == b'.';
    numeric(last_byte) && numeric(next_first_byte) || last_byte == b'>' && next_first_byte == b'='
}

/// True for a character between tokens that is not in the formatted text.
fn is_dropped(c: char) -> bool {
    c <= ' ' || is_ignored_char(c)
}

struct Gatherer<'a> {
    text: &'a str,
    base_in_sources: usize,
    pieces: Pieces<'a>,
    out: Atoms,
    /// Offset in the text after the last atom.
    at: usize,
    /// Flags for the next atom that is added.
    pending: u16,
    /// Name of the innermost block around the next token.
    block: &'a str,
}

impl<'a> Gatherer<'a> {
    fn len(&self) -> usize {
        self.out.row.len()
    }

    fn local_offset(&self, global_offset: u32) -> usize {
        (global_offset as usize).saturating_sub(self.base_in_sources)
    }

    fn text_of(&self, span: Span) -> &'a str {
        self.text.get(self.local_offset(span.lo)..self.local_offset(span.hi)).unwrap_or_default()
    }

    /// Adds all tokens and comments that begin before a local offset.
    fn gather_up_to(&mut self, local_end: usize) {
        while let Some(piece) = self.pieces.next
            && self.local_offset(piece.span().lo) < local_end
        {
            self.pieces.advance();
            self.add_piece(piece);
        }
    }

    fn gather_before(&mut self, span: Span) {
        self.gather_up_to(self.local_offset(span.lo));
    }

    fn gather_through(&mut self, span: Span) {
        self.gather_up_to(self.local_offset(span.hi));
    }

    /// Returns the text of the next token; `None` before a comment.
    fn peek_token_text(&self) -> Option<&str> {
        match self.pieces.next {
            Some(Piece::Token(span)) => self.text.get(self.local_offset(span.lo)..self.local_offset(span.hi)),
            _ => None,
        }
    }

    /// Adds the next token, and the comments before it.
    fn gather_token(&mut self) {
        while let Some(piece) = self.pieces.advance() {
            self.add_piece(piece);
            if matches!(piece, Piece::Token(_)) {
                break;
            }
        }
    }

    /// Adds the characters without meaning between two tokens, so that they stay in the text.
    fn gather_stray_characters(&mut self, end: usize) {
        let text = self.text;
        while let Some(from) = text[self.at..end].find(|c| !is_dropped(c)).map(|i| self.at + i) {
            let to = text[from..end].find(is_dropped).map_or(end, |i| from + i);
            self.push_atom(from, to, LONE);
        }
    }

    fn add_piece(&mut self, piece: Piece) {
        let Span { lo, hi } = piece.span();
        let (lo, hi) = (self.local_offset(lo), self.local_offset(hi));
        self.gather_stray_characters(lo);
        let text = &self.text[lo..hi];
        if let Piece::Comment(_) = piece {
            let kind = if text.starts_with("//") { LINE_COMMENT } else { BLOCK_COMMENT };
            let blanks = text.len() - text.trim_end_matches(|c| c <= ' ').len();
            self.push_atom(lo, hi - blanks, kind);
            self.at = hi;
            return;
        }
        let flags = std::mem::take(&mut self.pending);
        let sign = text.starts_with(['-', '+']);
        match text.as_bytes() {
            [b'<', _, _, ..] | [b'0'..=b'9' | b'.', ..] if text.len() > 2 => self.gather_number_list(lo, hi),
            [_, _, ..] if sign => self.gather_number_list(lo, hi),
            [b'(' | b'[' | b'{'] => self.push_atom(lo, hi, flags | OPEN),
            [b')' | b']' | b'}'] => self.push_atom(lo, hi, flags | CLOSE),
            _ if matches!(text, "'" | "“" | "‘") => self.push_atom(lo, hi, flags | LONE),
            _ => self.push_atom(lo, hi, flags),
        }
    }

    fn push_atom(&mut self, lo: usize, hi: usize, mut flags: u16) {
        let bytes = self.text.as_bytes();
        let blanks = &bytes[self.at.min(lo)..lo];
        let ends = |i: &usize| blanks[*i] == b'\n' || blanks[*i] == b'\r' && blanks.get(i + 1) != Some(&b'\n');
        let lines = (0..blanks.len()).filter(ends).take(2).count() as u8;
        let previous = self.out.row.last();
        match bytes[lo] {
            b',' | b';' | b')' | b']' => flags |= NO_BLANK_BEFORE,
            b'>' if flags & CLOSE != 0 => flags |= NO_BLANK_BEFORE,
            b'.' if hi == lo + 1 && self.is_member_dot(hi) => flags |= NO_BLANK_BEFORE | NO_BLANK_AFTER,
            b'(' | b'[' => flags |= NO_BLANK_AFTER,
            b'<' if flags & OPEN != 0 => flags |= NO_BLANK_AFTER,
            _ => {}
        }
        if lo == self.at && lo > 0 && changes_if_spaced(bytes[lo - 1], bytes[lo])
            || previous.is_some_and(|p| p.flags & NO_BLANK_AFTER != 0)
        {
            flags |= NO_BLANK_BEFORE;
        }
        if flags & COMMENT != 0 {
            flags &= !NO_BLANK_BEFORE;
        }
        self.out.row.push(Atom { lo: lo as u32, hi: hi as u32, flags, lines, ..Atom::default() });
        self.at = hi;
    }

    /// True if the `.` that ends at the local offset `dot_end` selects a member of the expression before it.
    fn is_member_dot(&self, dot_end: usize) -> bool {
        let word = |byte: Option<&u8>| byte.is_some_and(|b| b.is_ascii_alphabetic() || *b == b'_');
        let first = self.out.row.last().and_then(|atom| self.text.as_bytes().get(atom.lo as usize));
        let is_blank = |c| is_dropped(c) && !matches!(c, '\n' | '\r');
        word(self.text[dot_end..].trim_start_matches(is_blank).as_bytes().first())
            && (word(first) || matches!(first, Some(b')' | b']')))
    }

    /// Splits a token that is a list of numbers and vectors into atoms.
    fn gather_number_list(&mut self, lo: usize, hi: usize) {
        let (bytes, packed) = (self.text.as_bytes(), hi - lo > LONG_LIST);
        let mut at = lo;
        while at < hi {
            let stops = |b: &u8| matches!(b, b'<' | b'>' | b',') || *b <= b' ';
            match bytes[at] {
                b if b <= b' ' => at += 1,
                b'<' if packed => {
                    let end = bytes[at..hi].iter().position(|b| *b == b'>').map_or(hi, |i| at + i + 1);
                    self.push_atom(at, end, PACKED);
                    at = end;
                }
                b => {
                    let kind = match b {
                        b'<' => OPEN,
                        b'>' => CLOSE,
                        _ => 0,
                    };
                    let end = bytes[at + 1..hi].iter().position(stops).map_or(hi, |i| at + 1 + i);
                    let end = if matches!(b, b'<' | b'>' | b',') { at + 1 } else { end };
                    self.push_atom(at, end, kind);
                    at = end;
                }
            }
        }
    }

    // ------------------------------------------------------------ bodies

    fn gather_body(&mut self, elements: &[Element]) {
        // End of a declaration, and the textures that follow it.
        let mut layers = vec![];
        for e in elements {
            self.gather_before(e.span);
            let start = self.len();
            let item = self.gather_element(e);
            self.gather_through(e.span);
            self.gather_comma_after(e);
            self.mark_item(start, item);
            match &e.kind {
                ElementKind::Block(block) if !layers.is_empty() && self.text_of(block.name.span) == "texture" => {
                    layers.push(start)
                }
                _ => self.equalize_layer_line_starts(&std::mem::take(&mut layers)),
            }
            if item == ItemKind::Declare {
                layers.push(start);
            }
            if matches!(e.kind, ElementKind::Numbers(_)) {
                self.split_list_into_items(start);
            }
        }
        self.equalize_layer_line_starts(&layers);
    }

    /// Makes all textures of a declaration begin a line if one of them does.
    fn equalize_layer_line_starts(&mut self, layer_start_atoms: &[usize]) {
        let [_, first, rest @ ..] = layer_start_atoms else { return };
        if rest.is_empty() {
            return;
        }
        let breaks = rest.iter().any(|i| self.out.row[*i].lines > 0);
        let mut from = *first;
        for i in &layer_start_atoms[1..] {
            // Comments before it too.
            self.out.row[from..=*i].iter_mut().for_each(|atom| atom.flags |= LAYER);
            let atom = &mut self.out.row[*i];
            if breaks {
                atom.lines = atom.lines.max(1);
                atom.flags &= !SAME_LINE;
            }
            from = atom.next as usize;
        }
    }

    /// Adds the atom of the comma that follows a syntax element, if there is one.
    fn gather_comma_after(&mut self, e: &Element) {
        if e.comma {
            self.pending = 0;
            self.gather_token();
        }
    }

    /// Marks the atoms from `start_atom` to the last one as an item.
    fn mark_item(&mut self, start_atom: usize, item: ItemKind) {
        let end = self.len() as u32;
        let text = self.text;
        let read = |atom: &Atom| &text[atom.lo as usize..atom.hi as usize];
        let (before, rest) = self.out.row.split_at_mut(start_atom);
        let Some(first) = rest.first_mut() else { return };
        (first.item, first.next) = (item, end);
        let Some(last) = before.last().filter(|a| a.flags & COMMENT == 0) else { return };
        let after = read(last);
        if item == ItemKind::Entry
            && (after == "array" || after == "]" && last.flags & UNMATCHED == 0 && first.lines == 0)
        {
            // The sizes of an array: no other construct has entries directly after a word or after each other.
            let chained = after == "array" || first.lo == last.hi;
            first.flags |= if chained { NO_BLANK_BEFORE } else { 0 };
        }
        let group = item == ItemKind::Group && !matches!(after, "{" | "}" | "," | ";");
        if group || after == "=" && item != ItemKind::Sign {
            first.flags |= SAME_LINE;
        }
    }

    /// Makes each number or vector of a list an item of the body.
    fn split_list_into_items(&mut self, start_atom: usize) {
        let (end, mut from, mut depth) = (self.len(), start_atom, 0);
        for i in start_atom..end {
            let atom = self.out.row[i];
            depth += i32::from(atom.flags & OPEN != 0) - i32::from(atom.flags & CLOSE != 0);
            if depth == 0 && self.text.as_bytes()[atom.lo as usize] == b',' || i + 1 == end {
                let alone = from == i && depth == 0 && self.text.as_bytes()[atom.lo as usize] == b',';
                let first = &mut self.out.row[from];
                (first.item, first.next) = (if alone { ItemKind::Separator } else { ItemKind::Value }, i as u32 + 1);
                from = i + 1;
            }
        }
    }

    fn gather_element(&mut self, e: &Element) -> ItemKind {
        match &e.kind {
            ElementKind::Word(_) => ItemKind::Word,
            ElementKind::Expr(expr) => {
                self.gather_expr(expr);
                ItemKind::Value
            }
            ElementKind::Numbers(_) => ItemKind::Value,
            ElementKind::Block(block) => self.gather_bracketed(e.span, block.name.span, ItemKind::Block, &block.body),
            ElementKind::Group(group) => self.gather_bracketed(e.span, Span::NONE, ItemKind::Group, &group.body),
            ElementKind::Entry(group) => self.gather_bracketed(e.span, Span::NONE, ItemKind::Entry, &group.body),
            ElementKind::Function(function) => self.gather_function(function, e.span),
            ElementKind::Directive(directive) => self.gather_directive(directive, e.span),
            ElementKind::Semicolon | ElementKind::Comma => ItemKind::Separator,
            ElementKind::Punctuation(Punctuation::Open(_) | Punctuation::Close(_)) => {
                self.pending |= UNMATCHED;
                ItemKind::Sign
            }
            ElementKind::Punctuation(_) => ItemKind::Sign,
        }
    }

    /// Gathers the atoms of a body in brackets.
    fn gather_bracketed(&mut self, span: Span, name: Span, item: ItemKind, body: &[Element]) -> ItemKind {
        let start = self.len();
        if !name.is_none() {
            self.gather_through(name);
            self.pending |= SAME_LINE;
        }
        self.gather_token();
        let name = self.text_of(name);
        let outside = std::mem::replace(&mut self.block, name);
        self.gather_to_closing_bracket(start, span, body);
        self.block = outside;
        item
    }

    /// Adds the contents of brackets, up to the closing one, after the opening one was added.
    fn gather_to_closing_bracket(&mut self, start: usize, span: Span, body: &[Element]) {
        let open = self.len() - 1;
        self.gather_body(body);
        self.gather_up_to(self.local_offset(span.hi).saturating_sub(1));
        self.pending = 0;
        self.gather_token();
        let close = self.len() as u32 - 1;
        self.out.row[open].link = close;
        if start != open {
            self.out.row[start].link = open as u32;
        }
    }

    fn gather_function(&mut self, function: &Function, span: Span) -> ItemKind {
        let start = self.len();
        self.gather_token();
        if self.peek_token_text() == Some("(") {
            self.pending |= NO_BLANK_BEFORE;
        }
        function.size.iter().for_each(|e| self.gather_expr(e));
        while self.len() == start + 1 || self.text.as_bytes()[self.at - 1] != b'{' {
            if self.peek_token_text() == Some("{") {
                self.pending |= SAME_LINE;
            }
            if self.pieces.next.is_none() {
                return ItemKind::Value;
            }
            self.gather_token();
        }
        self.gather_to_closing_bracket(start, span, &function.body);
        ItemKind::Block
    }
}
