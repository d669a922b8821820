//! The lexer: splits a text into tokens in one pass over its bytes, finds the partner of each bracket (see
//! [`super::brackets`]) and collects the comments.

use super::Names;
use super::ast::NumberList;
use super::brackets::{Brackets, MAX_DEPTH, Opener};
use super::class::{self, Role};
use super::fault::{elsif_error, is_other_elseif};
use super::numbers::{ListScanner, is_blank, number_and_end};
use super::word::{self, Category};
use crate::diagnostic::{Code, Diagnostic, codes};
use crate::source::Span;

/// Token of a scene text, by kind and byte offsets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    /// Local offset of the token's first byte.
    pub(super) start: u32,
    /// Offset after the token's last byte.
    pub(super) end: u32,
    /// Number of a keyword, symbol of a name, or index in [`Lexed::numbers`] or [`Lexed::lists`], by the class.
    pub(super) data: u32,
}

/// A scene text split into tokens.
#[derive(Default)]
pub(super) struct Lexed {
    /// One ASCII character for each token, its class: the input of the grammar.
    pub(super) classes: Vec<u8>,
    /// Position and data of each token, parallel to the classes.
    pub(super) tokens: Vec<Token>,
    /// Numeric values of the text's `NUMBER` tokens.
    pub(super) numbers: Vec<f64>,
    /// Values of `LITERAL` and `NUMBERS` tokens, shared with the syntax tree.
    pub(super) lists: Vec<NumberList>,
    /// Indices of tokens at which no bracket or directive is open, ascending; the text can be parsed in pieces between.
    pub(super) cuts: Vec<u32>,
    /// Ranges of all comments in the text, in local offsets.
    pub(super) comments: Vec<(u32, u32)>,
    /// Number of directives without `#end`. The lexer appends an empty `END` token for each one.
    pub(super) unended: usize,
    /// Indices of brackets that are not closed in the rest of the text.
    pub(super) unclosed: Vec<u32>,
    /// Faults that the lexer found in the text.
    pub(super) faults: Vec<Diagnostic>,
}

/// Splits `text`, whose first byte has the global offset `base_in_sources`, into tokens. Without `merges_lists`, each
/// number and each sign is a token by itself.
pub(super) fn lex(text: &str, base_in_sources: usize, names: &Names, merges_lists: bool) -> Lexed {
    let mut lexer = Lexer {
        text,
        bytes: text.as_bytes(),
        base_in_sources,
        at: 0,
        names,
        out: Lexed::default(),
        brackets: Brackets::default(),
        lists: merges_lists.then(ListScanner::default),
        loose_closers: 0,
    };
    lexer.scan_all_tokens();
    lexer.out
}

/// Maximum number of faults that the lexer reports.
const MAX_FAULTS: usize = 20;

struct Lexer<'t> {
    text: &'t str,
    bytes: &'t [u8],
    base_in_sources: usize,
    at: usize,
    names: &'t Names,
    out: Lexed,
    brackets: Brackets,
    lists: Option<ListScanner>,
    /// Number of closing brackets without a partner in the same body.
    loose_closers: usize,
}

/// True for characters that the lexer ignores: no-break spaces, byte-order marks, DEL.
pub fn is_ignored_char(c: char) -> bool {
    matches!(c, '\u{A0}' | '\u{FEFF}' | '\u{7F}')
}

impl Lexer<'_> {
    fn scan_all_tokens(&mut self) {
        while let Some(&b) = self.bytes.get(self.at) {
            let at = self.at;
            match b {
                _ if is_blank(b) => self.at += 1,
                b'a'..=b'z' | b'A'..=b'Z' | b'_' => self.scan_word(),
                b'0'..=b'9' | b'.' | b'<' | b'-' | b'+' => self.scan_number_or_sign(b),
                b'"' => self.scan_string(),
                b'/' if matches!(self.bytes.get(at + 1), Some(b'/' | b'*')) => self.scan_comment(),
                b'#' => self.scan_directive(),
                b'{' | b'(' | b'[' | b'?' => self.scan_opening_bracket(b),
                b'}' | b')' | b']' | b'>' | b':' => self.scan_closing_bracket(b),
                b'=' | b'!' => self.scan_equal_or_not(b),
                b',' | b';' => {
                    self.push(b, 1, 0);
                    self.brackets.end_conditional_expressions();
                    if b == class::SEMICOLON {
                        self.add_cut_if_unnested();
                    }
                }
                b'*' | b'/' | b'&' | b'|' => self.push(b, 1, 0),
                _ => self.push_stray_character(),
            }
            if self.out.faults.len() >= MAX_FAULTS || self.brackets.is_too_deep() {
                break;
            }
        }
        if self.brackets.is_too_deep() {
            let message = format!("more than {MAX_DEPTH} brackets and directives are nested here");
            self.add_fault(codes::TOO_DEEP, self.at - 1, self.at, message, None);
        } else {
            self.end_open_directives();
        }
        self.out.cuts.push(self.out.tokens.len() as u32);
    }

    fn push(&mut self, class: u8, len: usize, data: u32) {
        let start = self.at as u32;
        self.at += len;
        self.out.classes.push(class);
        self.out.tokens.push(Token { start, end: self.at as u32, data });
    }

    /// Returns the class of the previous token; that of a `;` at the start of the text.
    fn previous_class(&self) -> u8 {
        self.out.classes.last().copied().unwrap_or(class::SEMICOLON)
    }

    /// True if the previous token ends an operand, so that a sign after it is a binary operator.
    fn is_after_operand(&self) -> bool {
        match self.previous_class() {
            class::NAME | class::NUMBER | class::LITERAL | class::NUMBERS | class::STRING => true,
            class::PAREN_END | class::BRACKET_END | class::VECTOR_END | class::GREATER => true,
            class::KEYWORD | class::BUILTIN => self.out.classes.iter().rev().nth(1) == Some(&class::DOT),
            class::LOOSE => matches!(self.text_of(self.out.tokens.len() - 1), ")" | "]"),
            _ => false,
        }
    }

    fn text_of(&self, token: usize) -> &str {
        let Token { start, end, .. } = self.out.tokens[token];
        &self.text[start as usize..end as usize]
    }

    fn add_cut_if_unnested(&mut self) {
        if self.brackets.is_empty() {
            self.out.cuts.push(self.out.tokens.len() as u32);
        }
    }

    fn word_end(&self, from: usize) -> usize {
        let rest = &self.bytes[from..];
        from + rest.iter().position(|b| !(b.is_ascii_alphanumeric() || *b == b'_')).unwrap_or(rest.len())
    }

    fn scan_word(&mut self) {
        let end = self.word_end(self.at);
        let text = &self.text[self.at..end];
        let (class, data) = match word::word_number_and_category(text) {
            Some((number, Category::Keyword)) if text == "function" => (class::FUNCTION, number),
            Some((number, Category::Keyword)) if text == "deprecated" => (class::DEPRECATED, number),
            Some((number, Category::Keyword)) => (class::KEYWORD, number),
            Some((number, Category::Function)) => (class::BUILTIN, number),
            _ => (class::NAME, self.names.intern(text).0),
        };
        self.push(class, end - self.at, data);
    }

    fn scan_number_or_sign(&mut self, b: u8) {
        if let Some((class, end)) = self.literal_class_and_end(b) {
            let index = self.out.lists.len() as u32;
            self.out.lists.extend(self.lists.as_mut().map(ListScanner::take_items));
            return self.push(class, end - self.at, index);
        }
        match b {
            b'<' if self.bytes.get(self.at + 1) == Some(&b'=') => self.push(class::LESS_EQUAL, 2, 0),
            b'<' => {
                // Stays this class if it is not a vector: the `>` decides.
                if !(self.brackets.is_in_function() || self.is_after_operand() && self.brackets.less_sign_compares()) {
                    self.brackets.open(Opener::Angle, self.out.tokens.len());
                }
                self.push(class::LESS, 1, 0);
            }
            b'-' | b'+' => self.push(b, 1, 0),
            _ => match number_and_end(self.bytes, self.at) {
                Some((value, end)) => {
                    let index = self.out.numbers.len() as u32;
                    self.out.numbers.push(value);
                    self.push(class::NUMBER, end - self.at, index);
                }
                None => self.push(class::DOT, 1, 0),
            },
        }
    }

    /// Returns the class and the end of a list of literals or a vector of numbers at the present position.
    fn literal_class_and_end(&mut self, b: u8) -> Option<(u8, usize)> {
        let after_operand = self.is_after_operand();
        // Lists are allowed between elements: not inside expressions, vectors or functions.
        let goes_on = matches!(
            self.previous_class(),
            class::FUNCTION | class::DOT | class::NOT | class::CHOICE | class::CHOICE_ELSE
        ) || matches!(
            self.previous_class(),
            class::PLUS | class::MINUS | class::TIMES | class::OVER | class::AND | class::OR
        ) || matches!(
            self.previous_class(),
            class::EQUAL | class::LESS_EQUAL | class::GREATER_EQUAL | class::NOT_EQUAL
        ) || matches!(self.previous_class(), class::LESS | class::GREATER);
        let vector =
            b == b'<' && !self.brackets.is_in_function() && !(after_operand && self.brackets.less_sign_compares());
        let lists = self.lists.as_mut()?;
        if self.brackets.allows_number_lists()
            && !goes_on
            && let Some((count, end)) = lists.scan_count_and_end(self.bytes, self.at, !after_operand)
            && (count > 1 || lists.first_item_width() > 1)
        {
            return Some((if count > 1 { class::NUMBERS } else { class::LITERAL }, end));
        }
        let end = if vector { lists.scan_vector_returning_end(self.bytes, self.at)? } else { return None };
        Some((class::LITERAL, end))
    }

    fn scan_equal_or_not(&mut self, b: u8) {
        match (b, self.bytes.get(self.at + 1)) {
            (b'!', Some(b'=')) => self.push(class::NOT_EQUAL, 2, 0),
            _ => self.push(b, 1, 0),
        }
    }

    /// Adds a token for an opening bracket, as unmatched until its partner is found.
    fn scan_opening_bracket(&mut self, b: u8) {
        let opener = match b {
            b'{' if self.next_brace_opens_function() => Opener::FunctionBrace,
            b'{' => Opener::Brace,
            b'(' if matches!(self.previous_class(), class::NAME | class::PLAIN) => Opener::Arguments,
            b'(' => Opener::Paren,
            b'[' => Opener::Bracket,
            _ => Opener::Choice,
        };
        self.brackets.open(opener, self.out.tokens.len());
        self.push(class::LOOSE, 1, 0);
    }

    fn scan_closing_bracket(&mut self, b: u8) {
        if b == b'>' && self.bytes.get(self.at + 1) == Some(&b'=') {
            return self.push(class::GREATER_EQUAL, 2, 0);
        }
        let class = if b == b'>' { class::VECTOR_END } else { b };
        match self.brackets.close_and_opener_token(class) {
            Some((opener, token)) => {
                self.out.classes[token] = opener.opening_and_closing_class().0;
                if opener == Opener::Brace {
                    self.mark_word_before_brace(token);
                }
                self.push(class, 1, 0);
                if class == class::BRACE_END {
                    self.add_cut_if_unnested();
                }
            }
            None if b == b'>' => self.push(class::GREATER, 1, 0),
            None => {
                self.loose_closers += usize::from(b != b':');
                self.push(class::LOOSE, 1, 0);
                self.add_cut_if_unnested();
            }
        }
    }

    /// Marks the word before a matched brace, so that the grammar need not find out whether the word opens a block.
    fn mark_word_before_brace(&mut self, brace: usize) {
        let Some((word, before)) = self.out.classes[..brace].split_last_mut() else { return };
        let is_word = matches!(*word, class::KEYWORD | class::NAME | class::BUILTIN);
        if is_word && !matches!(before.last(), Some(&class::DOT | &class::MACRO)) {
            *word = class::HEAD;
        }
    }

    /// True if the next `{` belongs to `function (…) {` or `function 20, 20 {`.
    fn next_brace_opens_function(&self) -> bool {
        let classes = &self.out.classes;
        let mut i = classes.len();
        if i > 0 && classes[i - 1] == class::PAREN_END {
            while i > 0 && classes[i - 1] != class::PAREN {
                i -= 1;
            }
            i = i.saturating_sub(1);
        }
        i > 0
            && classes[i.saturating_sub(4)..i]
                .iter()
                .rev()
                .take(4)
                .enumerate()
                .any(|(back, class)| *class == class::FUNCTION && matches!(back, 0 | 1 | 3))
    }

    fn scan_string(&mut self) {
        let (start, mut at) = (self.at, self.at + 1);
        loop {
            match memchr::memchr2(b'"', b'\\', &self.bytes[at.min(self.bytes.len())..]) {
                Some(step) if self.bytes[at + step] == b'"' => {
                    return self.push(class::STRING, at + step + 1 - start, 0);
                }
                Some(step) => at += step + 2,
                None => {
                    let end = self.text[start..].find(['\n', '\r']).map_or(self.bytes.len(), |i| start + i);
                    let help = "strings end with a second `\"`; inside one, write `\\\"` for a quote";
                    self.add_fault(codes::UNCLOSED, start, end, "this string is not closed".into(), Some(help));
                    self.at = self.bytes.len();
                    return;
                }
            }
        }
    }

    fn scan_comment(&mut self) {
        let start = self.at;
        if self.bytes[start + 1] == b'/' {
            let rest = &self.bytes[start..];
            self.at += memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        } else if !self.try_skip_block_comment() {
            return;
        }
        self.out.comments.push((start as u32, self.at as u32));
    }

    /// Skips the comment `/* … */`, which may be nested; returns false if the comment has no end.
    fn try_skip_block_comment(&mut self) -> bool {
        let start = self.at;
        let (mut depth, mut at) = (1, start + 2);
        while depth > 0 {
            let Some(step) = memchr::memchr(b'*', &self.bytes[at..]) else {
                let help = "add `*/` where it should end; comments nest: each `/*` needs its own `*/`";
                self.add_fault(codes::UNCLOSED, start, start + 2, "this comment is not closed".into(), Some(help));
                self.at = self.bytes.len();
                return false;
            };
            let star = at + step;
            // A `/` that has closed a comment does not open another.
            let opens = star > at && self.bytes[star - 1] == b'/';
            at = star + 1;
            if opens {
                depth += 1;
            } else if self.bytes.get(at) == Some(&b'/') {
                depth -= 1;
                at += 1;
            }
        }
        self.at = at;
        true
    }

    fn scan_directive(&mut self) {
        let rest = &self.text[self.at + 1..];
        let start = self.text.len() - rest.trim_start_matches(|c| matches!(c, ' ' | '\t') || is_ignored_char(c)).len();
        let end = self.word_end(start);
        let word = &self.text[start..end];
        if word.is_empty() {
            // A lone `#` is ignored, as in POV-Ray.
            self.at += 1;
            return;
        }
        let (at, token) = (self.at, self.out.tokens.len());
        match class::directive_class_and_role(word) {
            None => {
                let symbol = self.names.intern(word).0;
                if is_other_elseif(word) && self.out.faults.is_empty() {
                    self.out.faults.push(elsif_error(word, self.span(at, end)));
                }
                self.push(class::PLAIN, end - at, symbol);
            }
            Some((class, Role::Declares)) => self.push(class, end - at, u32::from(word == "local")),
            Some((class, Role::Opens)) => {
                self.push(class, end - at, 0);
                self.brackets.open(Opener::Directive(class), token);
            }
            Some((class, Role::Continues(which))) => match self.brackets.end_body_and_class() {
                Some(open) if which.contains(&open) => {
                    self.push(class, end - at, 0);
                }
                _ => self.report_stray_branch(word, at, end),
            },
            Some((class, Role::Ends)) => match self.brackets.end_body_and_class() {
                Some(_) => {
                    self.brackets.close_directive();
                    self.push(class, end - at, 0);
                    self.add_cut_if_unnested();
                }
                None => self.report_stray_branch(word, at, end),
            },
        }
    }

    fn report_stray_branch(&mut self, word: &str, at: usize, end: usize) {
        let help = match word {
            "end" => "each `#end` belongs to an `#if`, `#ifdef`, `#while`, `#for`, `#switch` or `#macro`",
            "case" | "range" => "it belongs into a `#switch`, before its `#else`",
            "elseif" => "it belongs into an `#if`, before its `#else`",
            _ => "it continues an `#if` or a `#switch`, once",
        };
        self.add_fault(codes::UNMATCHED_CLOSER, at, end, format!("`#{word}` continues nothing"), Some(help));
        self.at = end;
    }

    /// Ends the open directives at the end of the text, so that a tree can be built, and collects the open brackets.
    fn end_open_directives(&mut self) {
        self.out.unended = self.brackets.n_open_directives();
        for _ in 0..self.out.unended {
            self.push(class::END, 0, 0);
        }
        if self.loose_closers == 0 {
            self.out.unclosed = self.brackets.bracket_tokens_outside_directives().map(|token| token as u32).collect();
        }
    }

    /// Adds a token for a character without meaning, which is an error only once it is read.
    fn push_stray_character(&mut self) {
        let c = self.text[self.at..].chars().next().unwrap_or(' ');
        let mut len = c.len_utf8();
        // Text in single quotes is one fault.
        if matches!(c, '\'' | '“' | '‘') {
            let line = self.text[self.at..].lines().next().unwrap_or_default();
            let end = line[len..].find(['\'', '”', '’']).map(|i| len + i);
            len = end.map_or(len, |i| i + line[i..].chars().next().map_or(0, char::len_utf8));
        }
        if is_ignored_char(c) {
            self.at += len;
        } else {
            self.push(class::LOOSE, len, 0);
        }
    }

    fn span(&self, lo: usize, hi: usize) -> Span {
        Span::new(self.base_in_sources + lo, self.base_in_sources + hi)
    }

    fn add_fault(&mut self, code: Code, lo: usize, hi: usize, message: String, help: Option<&str>) {
        let d = Diagnostic::new(code, self.span(lo, hi), message).maybe_help(help.map(str::to_string));
        self.out.faults.push(d);
    }
}
