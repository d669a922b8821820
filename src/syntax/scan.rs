//! One pass over the bytes before pest sees them: brackets, strings, comments and directives in their nesting.
//!
//! It finds where the text can be cut (pest would need memory for all of it at once), how deep it nests (pest
//! recurses on the native stack), and everything that is opened and never closed, reported at the opener.

use crate::diagnostic::{Code, Diagnostic, codes, did_you_mean};
use crate::source::Span;

/// The deepest nesting of brackets, directives and choices that is read.
pub const MAX_DEPTH: usize = 1000;

/// What the pass found.
#[derive(Default)]
pub struct Scan {
    /// Ends of stretches outside of all brackets and directives, ascending; the text's end is the last.
    pub cuts: Vec<u32>,
    /// All comments, in local offsets.
    pub comments: Vec<(u32, u32)>,
    /// What is not closed, or closed and never opened.
    pub faults: Vec<Diagnostic>,
}

/// Passes over `text`, whose first byte has the global offset `base`.
pub fn scan(text: &str, base: usize) -> Scan {
    let mut scanner =
        Scanner { bytes: text.as_bytes(), text, base, at: 0, stack: vec![], loose: 0, out: Scan::default() };
    scanner.run();
    scanner.out
}

#[derive(Clone, Copy, PartialEq)]
enum Opener {
    Brace,
    Paren,
    Bracket,
    /// `#if` and its kin.
    Directive,
    /// `?` of a choice, closed by whatever closes the bracket around it.
    Choice,
}

struct Scanner<'t> {
    bytes: &'t [u8],
    text: &'t str,
    base: usize,
    at: usize,
    stack: Vec<(Opener, usize)>,
    /// Braces that a directive's body left open; a `}` outside may close each.
    loose: usize,
    out: Scan,
}

impl Scanner<'_> {
    fn run(&mut self) {
        while let Some(step) = self.bytes[self.at..].iter().position(|b| INTERESTING[*b as usize]) {
            self.at += step;
            let at = self.at;
            self.at += 1;
            match self.bytes[at] {
                b'"' => self.string(at),
                b'/' => self.comment(at),
                b'#' => self.directive(at),
                b'{' => self.open(Opener::Brace, at),
                b'(' => self.open(Opener::Paren, at),
                b'[' => self.open(Opener::Bracket, at),
                b'?' => self.open(Opener::Choice, at),
                b'}' => self.close(Opener::Brace, at),
                b')' => self.close(Opener::Paren, at),
                b']' => self.close(Opener::Bracket, at),
                _ => self.cut(),
            }
            if self.stack.len() > MAX_DEPTH {
                let message = format!("more than {MAX_DEPTH} brackets and directives are nested here");
                self.fault(codes::TOO_DEEP, at, at + 1, message, None);
                return;
            }
        }
        self.unclosed();
        self.out.cuts.push(self.bytes.len() as u32);
    }

    fn open(&mut self, opener: Opener, at: usize) {
        self.stack.push((opener, at));
    }

    fn close(&mut self, opener: Opener, at: usize) {
        while self.stack.last().is_some_and(|top| top.0 == Opener::Choice) {
            self.stack.pop();
        }
        match self.stack.last() {
            Some(&(top, _)) if top == opener => {
                self.stack.pop();
                if opener == Opener::Brace {
                    self.cut();
                }
            }
            // In a directive's body anything may be closed that was opened in another.
            Some((Opener::Directive, _)) => {}
            Some(&(top, opened)) => self.mismatch(top, opened, at),
            None if opener == Opener::Brace && self.loose > 0 => {
                self.loose -= 1;
                self.cut();
            }
            None => {
                let closer = self.bytes[at] as char;
                let message = format!("`{closer}` closes nothing");
                self.fault(
                    codes::UNMATCHED_CLOSER,
                    at,
                    at + 1,
                    message,
                    Some("remove it, or look for its opener above"),
                );
            }
        }
    }

    fn mismatch(&mut self, top: Opener, opened: usize, at: usize) {
        let (open, found) = (self.bytes[opened] as char, self.bytes[at] as char);
        let wanted = closer_of(top);
        let d = Diagnostic::new(
            codes::UNCLOSED,
            self.span(opened, opened + 1),
            format!("this `{open}` is not closed: found `{found}` where `{wanted}` was expected"),
        )
        .label("opened here")
        .also(self.span(at, at + 1), format!("`{found}` found here"));
        self.out.faults.push(d);
        // Take the closer for the right one of an outer bracket if there is one.
        self.stack.pop();
        if self.out.faults.len() < 20 {
            self.at = at;
        }
    }

    fn string(&mut self, at: usize) {
        loop {
            match memchr::memchr2(b'"', b'\\', &self.bytes[self.at.min(self.bytes.len())..]) {
                Some(step) if self.bytes[self.at + step] == b'"' => {
                    self.at += step + 1;
                    return;
                }
                Some(step) => self.at += step + 2,
                None => {
                    self.at = self.bytes.len();
                    let end = self.text[at..].find(['\n', '\r']).map_or(self.at, |i| at + i);
                    let help = Some("strings end with a second `\"`; inside one, write `\\\"` for a quote");
                    self.fault(codes::UNCLOSED, at, end, "this string is not closed".into(), help);
                    return;
                }
            }
        }
    }

    fn comment(&mut self, at: usize) {
        match self.bytes.get(self.at) {
            Some(b'/') => {
                let rest = &self.bytes[self.at..];
                self.at += memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
            }
            Some(b'*') => {
                self.at += 1;
                let mut depth = 1;
                while depth > 0 {
                    let Some(step) = memchr::memchr(b'*', &self.bytes[self.at..]) else {
                        self.at = self.bytes.len();
                        let help = Some("comments nest: each `/*` needs its own `*/`");
                        self.fault(codes::UNCLOSED, at, at + 2, "this comment is not closed".into(), help);
                        return;
                    };
                    let star = self.at + step;
                    self.at = star + 1;
                    if self.bytes.get(star + 1) == Some(&b'/') {
                        depth -= 1;
                        self.at = star + 2;
                    } else if self.bytes[star - 1] == b'/' && star - 1 > at {
                        depth += 1;
                    }
                    if depth > MAX_DEPTH {
                        self.fault(codes::TOO_DEEP, at, at + 2, "this comment nests too deeply".into(), None);
                        self.at = self.bytes.len();
                        return;
                    }
                }
            }
            _ => return,
        }
        self.out.comments.push((at as u32, self.at as u32));
    }

    fn directive(&mut self, at: usize) {
        let blanks = self.bytes[self.at..].iter().take_while(|b| matches!(b, b' ' | b'\t')).count();
        let start = self.at + blanks;
        let end = start + self.bytes[start..].iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
        let word = &self.text[start..end];
        self.at = end;
        match word {
            "if" | "ifdef" | "ifndef" | "while" | "for" | "switch" | "macro" => self.open(Opener::Directive, at),
            "else" | "elseif" | "case" | "range" | "end" => self.back_to_directive(word, at, end),
            "" => {}
            _ if DIRECTIVES.contains(&word) => {}
            _ => {
                let help = did_you_mean(word, DIRECTIVES.iter().copied()).map(|s| s.replacen('`', "`#", 1));
                self.fault(
                    codes::UNKNOWN_DIRECTIVE,
                    at,
                    end,
                    format!("there is no directive `#{word}`"),
                    help.as_deref(),
                );
            }
        }
    }

    /// A directive goes on or ends: what its body left open is closed elsewhere.
    fn back_to_directive(&mut self, word: &str, at: usize, end: usize) {
        let Some(depth) = self.stack.iter().rposition(|(opener, _)| *opener == Opener::Directive) else {
            let help = if word == "end" {
                "each `#end` belongs to an `#if`, `#ifdef`, `#while`, `#for`, `#switch` or `#macro`"
            } else {
                "it continues an `#if` or a `#switch`"
            };
            return self.fault(codes::UNMATCHED_CLOSER, at, end, format!("`#{word}` continues nothing"), Some(help));
        };
        self.loose += self.stack[depth..].iter().filter(|(opener, _)| *opener == Opener::Brace).count();
        self.stack.truncate(depth + usize::from(word != "end"));
        if word == "end" {
            self.cut();
        }
    }

    fn unclosed(&mut self) {
        let opened: Vec<_> = self.stack.iter().filter(|(opener, _)| *opener != Opener::Choice).copied().collect();
        // A missing `#end` leaves all the rest of the file open: its opener alone tells enough.
        for (opener, at) in opened.into_iter().rev().take(3) {
            let (end, what, help) = match opener {
                Opener::Directive => {
                    let word: String = self.text[at..].chars().take_while(|c| !"( \t\n\r".contains(*c)).collect();
                    (at + word.len(), word, "#end")
                }
                _ => (at + 1, self.bytes[at].escape_ascii().to_string(), closer_of(opener)),
            };
            let message = format!("this `{what}` is not closed");
            self.fault(codes::UNCLOSED, at, end, message, Some(&format!("add `{help}` where it should end")));
        }
    }

    fn cut(&mut self) {
        if self.stack.is_empty() {
            self.out.cuts.push(self.at as u32);
        }
    }

    fn span(&self, lo: usize, hi: usize) -> Span {
        Span::new(self.base + lo, self.base + hi)
    }

    fn fault(&mut self, code: Code, lo: usize, hi: usize, message: String, help: Option<&str>) {
        let d = Diagnostic::new(code, self.span(lo, hi), message).maybe_help(help.map(str::to_string));
        self.out.faults.push(d);
    }
}

fn closer_of(opener: Opener) -> &'static str {
    match opener {
        Opener::Brace => "}",
        Opener::Paren | Opener::Choice => ")",
        Opener::Bracket => "]",
        Opener::Directive => "#end",
    }
}

/// All words that may follow a `#`.
pub const DIRECTIVES: &[&str] = &[
    "break",
    "case",
    "debug",
    "declare",
    "default",
    "else",
    "elseif",
    "end",
    "error",
    "fclose",
    "fopen",
    "for",
    "if",
    "ifdef",
    "ifndef",
    "include",
    "local",
    "macro",
    "range",
    "read",
    "render",
    "statistics",
    "switch",
    "undef",
    "version",
    "warning",
    "while",
    "write",
];

const INTERESTING: [bool; 256] = {
    let mut table = [false; 256];
    let bytes = b"\"/#{([?}]);";
    let mut i = 0;
    while i < bytes.len() {
        table[bytes[i] as usize] = true;
        i += 1;
    }
    table
};
