//! Text to tokens: what the grammar's characters stand for. One pass over the bytes, which also checks the nesting of
//! brackets and directives (see [`super::nesting`]) and keeps the comments.

use super::Names;
use super::ast::NumberList;
use super::nesting::{Closing, Nesting, Opener};
use super::numbers::{ListScanner, is_blank, scan_number};
use super::word::{self, Category};
use crate::diagnostic::{Code, Diagnostic, codes, did_you_mean};
use crate::source::Span;

/// One token.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    /// Local offset of its first byte.
    pub(super) start: u32,
    /// One past its last byte.
    pub(super) end: u32,
    /// A keyword's number, a name's symbol, an index into [`Lexed::numbers`] or [`Lexed::lists`].
    pub(super) data: u32,
}

/// A text in tokens.
#[derive(Default)]
pub(super) struct Lexed {
    /// One ASCII character a token: the grammar's input.
    pub(super) classes: Vec<u8>,
    /// As many as there are classes.
    pub(super) tokens: Vec<Token>,
    /// Values of `1` tokens.
    pub(super) numbers: Vec<f64>,
    /// Values of `V` and `v` tokens; the tree takes them.
    pub(super) lists: Vec<NumberList>,
    /// Numbers of tokens at which nothing is open, ascending: there the text can be cut.
    pub(super) cuts: Vec<u32>,
    /// All comments, in local offsets.
    pub(super) comments: Vec<(u32, u32)>,
    /// What can't be read.
    pub(super) faults: Vec<Diagnostic>,
}

/// Makes tokens of `text`, whose first byte has the global offset `base`.
pub(super) fn lex(text: &str, base: usize, names: &Names) -> Lexed {
    let mut lexer = Lexer {
        text,
        bytes: text.as_bytes(),
        base,
        at: 0,
        names,
        out: Lexed::default(),
        nesting: Nesting::default(),
        lists: ListScanner::default(),
    };
    lexer.run();
    lexer.out
}

/// A message tells at most this many faults.
const MAX_FAULTS: usize = 20;

struct Lexer<'t> {
    text: &'t str,
    bytes: &'t [u8],
    base: usize,
    at: usize,
    names: &'t Names,
    out: Lexed,
    nesting: Nesting,
    lists: ListScanner,
}

impl Lexer<'_> {
    fn run(&mut self) {
        while let Some(&b) = self.bytes.get(self.at) {
            let at = self.at;
            match b {
                _ if is_blank(b) => self.at += 1,
                b'a'..=b'z' | b'A'..=b'Z' | b'_' => self.word(),
                b'0'..=b'9' | b'.' | b'<' | b'-' | b'+' => self.number_or_sign(b),
                b'"' => self.string(),
                b'/' if matches!(self.bytes.get(at + 1), Some(b'/' | b'*')) => self.comment(),
                b'#' => self.directive(),
                b'{' | b'(' | b'[' | b'?' | b'}' | b')' | b']' | b'>' => self.bracket(b),
                b'=' | b'!' => self.operator(b),
                b',' | b';' | b':' | b'*' | b'/' | b'&' | b'|' => {
                    self.push(b, 1, 0);
                    if b == b';' {
                        self.cut();
                    }
                }
                _ => self.other(),
            }
            if self.out.faults.len() >= MAX_FAULTS || self.nesting.too_deep() {
                break;
            }
        }
        if self.nesting.too_deep() {
            let message = format!("more than {} brackets and directives are nested here", super::nesting::MAX_DEPTH);
            self.fault(codes::TOO_DEEP, self.at - 1, self.at, message, None);
        } else {
            self.unclosed();
        }
        self.out.cuts.push(self.out.tokens.len() as u32);
    }

    fn push(&mut self, class: u8, len: usize, data: u32) {
        let start = self.at as u32;
        self.at += len;
        self.out.classes.push(class);
        self.out.tokens.push(Token { start, end: self.at as u32, data });
    }

    /// The class of the token before; a `;` at the start.
    fn before(&self) -> u8 {
        self.out.classes.last().copied().unwrap_or(b';')
    }

    /// Does the token before end an operand, so that a sign after it adds?
    fn after_operand(&self) -> bool {
        matches!(self.before(), b'n' | b'1' | b'2' | b'3' | b'"' | b')' | b']' | b'>')
            || matches!(self.before(), b'k' | b'f') && self.out.classes.iter().rev().nth(1) == Some(&b'.')
    }

    fn cut(&mut self) {
        if self.nesting.is_empty() {
            self.out.cuts.push(self.out.tokens.len() as u32);
        }
    }

    fn word_end(&self, from: usize) -> usize {
        let rest = &self.bytes[from..];
        from + rest.iter().position(|b| !(b.is_ascii_alphanumeric() || *b == b'_')).unwrap_or(rest.len())
    }

    fn word(&mut self) {
        let end = self.word_end(self.at);
        let text = &self.text[self.at..end];
        let (class, data) = match word::lookup_number(text) {
            Some((_, Category::Keyword)) if text == "function" => (b'@', 0),
            Some((_, Category::Keyword)) if text == "deprecated" => (b'%', 0),
            Some((number, Category::Keyword)) => (b'k', number),
            Some((number, Category::Function)) => (b'f', number),
            _ => (b'n', self.names.intern(text).0),
        };
        self.push(class, end - self.at, data);
    }

    fn number_or_sign(&mut self, b: u8) {
        let after_operand = self.after_operand();
        // Lists stand between elements: not inside expressions, vectors or functions.
        let starts = !matches!(
            self.before(),
            b'@' | b'+' | b'-' | b'*' | b'/' | b'.' | b'!' | b'?' | b':' | b'&' | b'|' | b'=' | b'4' | b'5' | b'6'
        );
        if self.nesting.takes_lists()
            && starts
            && let Some((count, end)) = self.lists.scan(self.bytes, self.at, !after_operand)
            && (count > 1 || self.lists.first_width() > 1)
        {
            return self.push_list(if count > 1 { b'3' } else { b'2' }, end);
        }
        if b == b'<'
            && !self.nesting.in_function()
            && let Some(end) = self.lists.scan_vector(self.bytes, self.at)
        {
            return self.push_list(b'2', end);
        }
        match b {
            b'<' if self.bytes.get(self.at + 1) == Some(&b'=') => self.push(b'4', 2, 0),
            b'<' => {
                if !after_operand && !self.nesting.in_function() {
                    self.nesting.open(Opener::Angle, self.out.tokens.len());
                }
                self.push(b'<', 1, 0);
            }
            b'-' | b'+' => self.push(b, 1, 0),
            _ => match scan_number(self.bytes, self.at) {
                Some((value, end)) => {
                    let index = self.out.numbers.len() as u32;
                    self.out.numbers.push(value);
                    self.push(b'1', end - self.at, index);
                }
                None => self.push(b'.', 1, 0),
            },
        }
    }

    fn push_list(&mut self, class: u8, end: usize) {
        let index = self.out.lists.len() as u32;
        self.out.lists.push(self.lists.take());
        self.push(class, end - self.at, index);
    }

    fn operator(&mut self, b: u8) {
        match (b, self.bytes.get(self.at + 1)) {
            (b'!', Some(b'=')) => self.push(b'6', 2, 0),
            _ => self.push(b, 1, 0),
        }
    }

    fn bracket(&mut self, b: u8) {
        let token = self.out.tokens.len();
        match b {
            b'{' => {
                let function = self.opens_function();
                self.nesting.open(if function { Opener::FunctionBrace } else { Opener::Brace }, token);
            }
            b'(' => self.nesting.open(Opener::Paren, token),
            b'[' => self.nesting.open(Opener::Bracket, token),
            b'?' => self.nesting.open(Opener::Choice, token),
            b'>' if self.bytes.get(self.at + 1) == Some(&b'=') => return self.push(b'5', 2, 0),
            b'>' => self.nesting.close_angle(),
            closer => match self.nesting.close(closer) {
                Closing::Closes => {}
                Closing::Loose => {
                    self.push(b'^', 1, 0);
                    return self.cut();
                }
                // The closer is tried again, for a bracket further out.
                Closing::Unclosed(opener, token) => return self.mismatch(opener, token, closer),
                Closing::Swapped(opener, token) => {
                    self.mismatch(opener, token, closer);
                    self.at += 1;
                    return;
                }
                Closing::Stray(open) => return self.stray(open, closer),
            },
        }
        self.push(b, 1, 0);
        if b == b'}' {
            self.cut();
        }
    }

    /// Is the brace that comes now that of `function (…) {`?
    fn opens_function(&self) -> bool {
        let classes = &self.out.classes;
        let mut i = classes.len();
        if i > 0 && classes[i - 1] == b')' {
            while i > 0 && classes[i - 1] != b'(' {
                i -= 1;
            }
            i = i.saturating_sub(1);
        }
        i > 0 && (classes[i - 1] == b'@' || i > 3 && classes[i - 4] == b'@')
    }

    fn mismatch(&mut self, opener: Opener, token: usize, closer: u8) {
        let (at, found) = (self.at, closer as char);
        let start = self.out.tokens[token].start as usize;
        let open = self.bytes[start] as char;
        let wanted = opener.closer();
        let message = format!("this `{open}` is not closed: found `{found}` where `{wanted}` was expected");
        let d = Diagnostic::new(codes::UNCLOSED, self.span(start, start + 1), message)
            .label("opened here")
            .also(self.span(at, at + 1), format!("`{found}` found here"));
        self.out.faults.push(d);
    }

    fn stray(&mut self, open: Option<usize>, closer: u8) {
        let (at, found) = (self.at, closer as char);
        let help = "remove it, or look for its opener above";
        let d = Diagnostic::new(codes::UNMATCHED_CLOSER, self.span(at, at + 1), format!("`{found}` closes nothing"));
        let open = open.map(|token| self.out.tokens[token].start as usize);
        let d = match open {
            Some(start) => d.also(self.span(start, start + 1), "this is open, and closes with `}`"),
            None => d,
        };
        self.out.faults.push(d.help(help));
        self.at += 1;
    }

    fn string(&mut self) {
        let (start, mut at) = (self.at, self.at + 1);
        loop {
            match memchr::memchr2(b'"', b'\\', &self.bytes[at.min(self.bytes.len())..]) {
                Some(step) if self.bytes[at + step] == b'"' => return self.push(b'"', at + step + 1 - start, 0),
                Some(step) => at += step + 2,
                None => {
                    let end = self.text[start..].find(['\n', '\r']).map_or(self.bytes.len(), |i| start + i);
                    let help = "strings end with a second `\"`; inside one, write `\\\"` for a quote";
                    self.fault(codes::UNCLOSED, start, end, "this string is not closed".into(), Some(help));
                    self.at = self.bytes.len();
                    return;
                }
            }
        }
    }

    fn comment(&mut self) {
        let start = self.at;
        if self.bytes[start + 1] == b'/' {
            let rest = &self.bytes[start..];
            self.at += memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        } else if !self.block_comment() {
            return;
        }
        self.out.comments.push((start as u32, self.at as u32));
    }

    /// `/* … */`, which may hold others; false if it has no end.
    fn block_comment(&mut self) -> bool {
        let start = self.at;
        let (mut depth, mut at) = (1, start + 2);
        while depth > 0 {
            let Some(step) = memchr::memchr(b'*', &self.bytes[at..]) else {
                let help = "comments nest: each `/*` needs its own `*/`";
                self.fault(codes::UNCLOSED, start, start + 2, "this comment is not closed".into(), Some(help));
                self.at = self.bytes.len();
                return false;
            };
            let star = at + step;
            // A `/` that already closed a comment does not open another.
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

    fn directive(&mut self) {
        let blanks = self.bytes[self.at + 1..].iter().take_while(|b| matches!(b, b' ' | b'\t')).count();
        let start = self.at + 1 + blanks;
        let end = self.word_end(start);
        let word = &self.text[start..end];
        if word.is_empty() {
            // A lone `#` is passed over, as POV-Ray does.
            self.at += 1;
            return;
        }
        let Some(&(_, class)) = DIRECTIVES.iter().find(|(name, _)| *name == word) else {
            let known = DIRECTIVES.iter().map(|(name, _)| *name);
            let help = did_you_mean(word, known).map(|s| s.replacen('`', "`#", 1));
            let message = format!("there is no directive `#{word}`");
            self.fault(codes::UNKNOWN_DIRECTIVE, self.at, end, message, help.as_deref());
            self.at = end;
            return;
        };
        let (at, token) = (self.at, self.out.tokens.len());
        self.push(class, end - at, 0);
        match class {
            b'I' | b'J' | b'K' | b'W' | b'R' | b'S' | b'M' => self.nesting.open(Opener::Directive, token),
            b'L' | b'G' | b'C' | b'T' | b'E' => match self.nesting.back_to_directive(class == b'E') {
                Some(loose) => {
                    for token in loose {
                        let class = &mut self.out.classes[token];
                        *class = if *class == b'(' { b'$' } else { b'~' };
                    }
                    self.cut();
                }
                None => self.continues_nothing(word, at, end),
            },
            _ => {}
        }
    }

    fn continues_nothing(&mut self, word: &str, at: usize, end: usize) {
        let help = match word {
            "end" => "each `#end` belongs to an `#if`, `#ifdef`, `#while`, `#for`, `#switch` or `#macro`",
            _ => "it continues an `#if` or a `#switch`",
        };
        self.fault(codes::UNMATCHED_CLOSER, at, end, format!("`#{word}` continues nothing"), Some(help));
    }

    /// At the end of the text: what is still open. The innermost three tell enough.
    fn unclosed(&mut self) {
        for (opener, token) in self.nesting.unclosed().into_iter().rev().take(3) {
            let Token { start, end, .. } = self.out.tokens[token];
            let what = self.text[start as usize..end as usize].to_string();
            let help = format!("add `{}` where it should end", opener.closer());
            let message = format!("this `{what}` is not closed");
            self.fault(codes::UNCLOSED, start as usize, end as usize, message, Some(&help));
        }
    }

    /// A character that stands for nothing in the language.
    fn other(&mut self) {
        let c = self.text[self.at..].chars().next().unwrap_or(' ');
        let mut len = c.len_utf8();
        // Text in single quotes is one fault.
        if matches!(c, '\'' | '“' | '‘') {
            let line = self.text[self.at..].lines().next().unwrap_or_default();
            let end = line[len..].find(['\'', '”', '’']).map(|i| len + i);
            len = end.map_or(len, |i| i + line[i..].chars().next().map_or(0, char::len_utf8));
        }
        if !matches!(c, '\u{A0}' | '\u{FEFF}' | '\u{7F}') {
            let help = match c {
                '\'' | '“' | '”' | '‘' | '’' => "strings stand in double quotes: `\"`",
                '%' => "the remainder is `mod(a, b)`",
                '^' => "powers are `pow(a, b)`",
                c if c.is_alphabetic() => "names are made of the letters a to z, digits and `_`",
                _ => "outside of strings and comments no such character has a meaning",
            };
            self.fault(codes::SYNTAX, self.at, self.at + len, format!("`{c}` can't stand here"), Some(help));
        }
        self.at += len;
    }

    fn span(&self, lo: usize, hi: usize) -> Span {
        Span::new(self.base + lo, self.base + hi)
    }

    fn fault(&mut self, code: Code, lo: usize, hi: usize, message: String, help: Option<&str>) {
        let d = Diagnostic::new(code, self.span(lo, hi), message).maybe_help(help.map(str::to_string));
        self.out.faults.push(d);
    }
}

/// The words that may follow a `#`.
pub fn directive_names() -> impl Iterator<Item = &'static str> {
    DIRECTIVES.iter().map(|(name, _)| *name)
}

/// All words that may follow a `#`, and the grammar's character for each.
const DIRECTIVES: &[(&str, u8)] = &[
    ("declare", b'D'),
    ("local", b'D'),
    ("if", b'I'),
    ("end", b'E'),
    ("else", b'L'),
    ("ifdef", b'J'),
    ("ifndef", b'K'),
    ("elseif", b'G'),
    ("while", b'W'),
    ("for", b'R'),
    ("macro", b'M'),
    ("switch", b'S'),
    ("case", b'C'),
    ("range", b'T'),
    ("break", b'B'),
    ("include", b'N'),
    ("version", b'N'),
    ("debug", b'N'),
    ("warning", b'N'),
    ("error", b'N'),
    ("render", b'N'),
    ("statistics", b'N'),
    ("default", b'Z'),
    ("undef", b'U'),
    ("fopen", b'O'),
    ("fclose", b'Q'),
    ("read", b'A'),
    ("write", b'A'),
];
