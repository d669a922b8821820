//! Outline of a text for an editor: tokens with their kinds, declarations and uses of names, and the blocks and
//! directives that enclose a position. One pass over the lossless tokens.

use crate::syntax::word::{Category, entry};
use crate::syntax::{Piece, Tokens, opens};
use std::ops::Range;

/// Kind of a token or comment in a scene's text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// Token that is a reserved word of the scene language.
    Word(Category),
    /// Token that is a name chosen by the scene's author.
    Name,
    /// Token that is a directive, `#…`.
    Directive,
    /// Token that is a string, `"…"`.
    Text,
    /// Token that is a number, or a list of numbers.
    Number,
    /// Token that is a bracket, an operator or a comma.
    Sign,
    /// Token that is a comment, `// …` or `/* … */`.
    Comment,
}

/// A token or comment in a scene's text.
#[derive(Clone, Debug)]
pub struct Token {
    /// Byte range of the token in the text.
    pub at: Range<usize>,
    /// Kind of the token.
    pub kind: TokenKind,
}

/// Directive or construct that declares a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeclarationKind {
    /// Declared by `#declare`.
    Declare,
    /// Declared by `#local`.
    Local,
    /// Declared by `#macro`.
    Macro,
    /// Declaration of a macro's parameter.
    Parameter,
    /// Declaration of a `#for` loop's counter.
    Counter,
}

/// Declaration of a name in a scene's text.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Name that the declaration introduces.
    pub name: String,
    /// Byte range of the declared name.
    pub at: Range<usize>,
    /// Kind of the declaration.
    pub kind: DeclarationKind,
    /// Index of the innermost macro that encloses the declaration.
    pub scope: Option<usize>,
    /// Byte range from the directive to the name, or to the `#end` of a macro.
    pub whole: Range<usize>,
}

/// A use of a declared name in a scene's text.
#[derive(Clone, Debug)]
pub struct Use {
    /// Name that the text uses.
    pub name: String,
    /// Byte range of the used name.
    pub at: Range<usize>,
    /// Index of the innermost macro that encloses the use of the name.
    pub scope: Option<usize>,
}

/// A macro definition in a scene's text.
#[derive(Clone, Debug, Default)]
pub struct Macro {
    /// Byte range of the macro from `#macro` to `#end`.
    pub whole: Range<usize>,
    /// Index of the macro that encloses this macro.
    pub outer: Option<usize>,
    /// Names of the macro's parameters.
    pub parameters: Vec<String>,
}

/// A pair of brackets, or a directive with a body.
#[derive(Clone, Debug)]
pub struct Pair {
    /// The word before the bracket, or the directive's word.
    pub name: String,
    /// Byte range from the opening bracket or directive to the end of the closing one, or of the text.
    pub whole: Range<usize>,
    /// Opening character of the pair: a bracket, or `#`.
    pub open: u8,
    /// Byte range of the pair's name: the word before the bracket, or the directive's word.
    pub named: Range<usize>,
    /// Index of the pair of brackets or directive that encloses this pair.
    pub outer: Option<usize>,
    /// True if the pair's closing bracket or directive exists.
    pub closed: bool,
}

/// Outline of a scene's text: tokens, brackets, macros and names.
#[derive(Debug, Default)]
pub struct Scan {
    /// Tokens in the order of the text.
    pub tokens: Vec<Token>,
    /// Declarations in the order of the text.
    pub declarations: Vec<Declaration>,
    /// Uses in the order of the text.
    pub uses: Vec<Use>,
    /// Macros of the text in the order of their indices.
    pub macros: Vec<Macro>,
    /// Pairs in the order of their openings.
    pub pairs: Vec<Pair>,
    /// Names of included files, and the byte ranges of the strings with their quotes.
    pub includes: Vec<(String, Range<usize>)>,
}

impl Scan {
    /// Scans a text whose first byte has the global offset `base`.
    pub fn of(text: &str, base: usize, tokens: &Tokens) -> Self {
        let mut scan = Self::default();
        for piece in tokens.pieces() {
            let span = piece.span();
            let at = (span.lo as usize).saturating_sub(base)..(span.hi as usize).saturating_sub(base);
            let kind = match piece {
                Piece::Comment(_) => TokenKind::Comment,
                Piece::Token(_) => kind_of(&text[at.clone()]),
            };
            scan.tokens.push(Token { at, kind });
        }
        Scanner { text, scan: &mut scan, macros: vec![], open: vec![] }.run();
        scan
    }

    /// The token at a byte, or the token that ends before it.
    pub fn token_at(&self, offset: usize) -> Option<&Token> {
        let i = self.tokens.partition_point(|token| token.at.end < offset);
        let first = self.tokens.get(i).filter(|token| token.at.start <= offset)?;
        // Between two tokens, prefer a word to a sign.
        let second = self.tokens.get(i + 1).filter(|token| token.at.start <= offset);
        Some(second.filter(|_| first.kind == TokenKind::Sign).unwrap_or(first))
    }

    /// The innermost pair around a byte for which `holds` is true.
    pub fn around(&self, offset: usize, holds: impl Fn(&Pair) -> bool) -> Option<&Pair> {
        let inside = |pair: &&Pair| pair.whole.start < offset && (offset < pair.whole.end || !pair.closed);
        self.pairs.iter().rev().filter(inside).find(|pair| holds(pair))
    }

    /// Returns the index of the innermost macro around a byte offset.
    pub fn macro_at(&self, offset: usize) -> Option<usize> {
        let inside = |m: &&Macro| m.whole.start < offset && offset < m.whole.end;
        self.macros
            .iter()
            .filter(inside)
            .max_by_key(|m| m.whole.start)
            .and_then(|found| self.macros.iter().position(|m| m.whole == found.whole))
    }

    /// Index of the macro that declares a name used in `scope`; `None` for a global name.
    pub fn owner(&self, name: &str, mut scope: Option<usize>) -> Option<usize> {
        while let Some(number) = scope {
            let is_own = |d: &Declaration| {
                d.scope == scope
                    && d.name == name
                    && d.kind != DeclarationKind::Declare
                    && d.kind != DeclarationKind::Macro
            };
            if self.declarations.iter().any(is_own) {
                return scope;
            }
            scope = self.macros.get(number)?.outer;
        }
        None
    }
}

fn kind_of(text: &str) -> TokenKind {
    match text.as_bytes() {
        [b'#', ..] => TokenKind::Directive,
        [b'"', ..] => TokenKind::Text,
        [b'a'..=b'z' | b'A'..=b'Z' | b'_', ..] => entry(text).map_or(TokenKind::Name, |word| match word.category {
            Category::Contextual => TokenKind::Name,
            category => TokenKind::Word(category),
        }),
        [b'0'..=b'9', ..] => TokenKind::Number,
        [_, _, ..] if text.contains(|c: char| c.is_ascii_digit()) => TokenKind::Number,
        _ => TokenKind::Sign,
    }
}

/// The word of a directive, without `#` and spaces.
pub fn directive(text: &str) -> &str {
    text.trim_start_matches('#').trim_start()
}

struct Scanner<'a> {
    text: &'a str,
    scan: &'a mut Scan,
    /// Indices of the macros that are still open while scanning.
    macros: Vec<usize>,
    /// Indices of the bracket pairs that are still open while scanning.
    open: Vec<usize>,
}

impl Scanner<'_> {
    fn read(&self, i: usize) -> &str {
        self.scan.tokens.get(i).map_or("", |token| &self.text[token.at.clone()])
    }

    /// The index of the next token after `i` that is no comment.
    fn next(&self, i: usize) -> usize {
        let is_comment = |i: &usize| self.scan.tokens.get(*i).is_some_and(|token| token.kind == TokenKind::Comment);
        (i + 1..).find(|i| !is_comment(i)).unwrap_or(i + 1)
    }

    fn kind(&self, i: usize) -> Option<TokenKind> {
        self.scan.tokens.get(i).map(|token| token.kind)
    }

    fn at(&self, i: usize) -> Range<usize> {
        self.scan.tokens.get(i).map_or(self.text.len()..self.text.len(), |token| token.at.clone())
    }

    fn run(mut self) {
        let mut i = 0;
        while i < self.scan.tokens.len() {
            i = match self.kind(i) {
                Some(TokenKind::Directive) => self.directive(i),
                Some(TokenKind::Name) => {
                    let one = Use { name: self.read(i).into(), at: self.at(i), scope: self.macros.last().copied() };
                    self.scan.uses.push(one);
                    i + 1
                }
                Some(TokenKind::Sign) => {
                    self.sign(i);
                    i + 1
                }
                _ => i + 1,
            };
        }
        let end = self.text.len();
        self.open.iter().for_each(|pair| self.scan.pairs[*pair].whole.end = end);
        self.macros.iter().for_each(|number| self.scan.macros[*number].whole.end = end);
    }

    fn open(&mut self, open: u8, named: Range<usize>, start: usize) {
        let name = self.text[named.clone()].to_string();
        let outer = self.open.last().copied();
        self.open.push(self.scan.pairs.len());
        self.scan.pairs.push(Pair { name, whole: start..start + 1, open, named, outer, closed: false });
    }

    /// Closes the innermost pair with the opening character `open`, unless a directive's body encloses the position
    /// more tightly.
    fn close(&mut self, open: u8, end: usize) {
        let is = |pair: &usize| self.scan.pairs[*pair].open == open;
        let hidden = |pair: &usize| open != b'#' && self.scan.pairs[*pair].open == b'#';
        let Some(at) = self.open.iter().rposition(|pair| is(pair) || hidden(pair)).filter(|at| is(&self.open[*at]))
        else {
            return;
        };
        for pair in self.open.drain(at..).collect::<Vec<_>>().into_iter().rev() {
            let pair = &mut self.scan.pairs[pair];
            pair.whole.end = end;
            pair.closed = pair.open == open;
        }
    }

    fn sign(&mut self, i: usize) {
        let at = self.at(i);
        match self.read(i).as_bytes() {
            [open @ (b'{' | b'(' | b'[')] => {
                let before = (0..i).rev().find(|i| self.kind(*i) != Some(TokenKind::Comment));
                let named = before.filter(|i| matches!(self.kind(*i), Some(TokenKind::Name | TokenKind::Word(_))));
                let (open, named) = (*open, named.map_or(at.start..at.start, |i| self.at(i)));
                self.open(open, named, at.start);
            }
            [b'}'] => self.close(b'{', at.end),
            [b')'] => self.close(b'(', at.end),
            [b']'] => self.close(b'[', at.end),
            _ => {}
        }
    }

    /// Handles a directive; returns the index of the next token.
    fn directive(&mut self, i: usize) -> usize {
        let at = self.at(i);
        let word = directive(self.read(i)).to_string();
        if opens(&word) {
            let start = at.end - word.len();
            self.open(b'#', start..at.end, at.start);
        }
        match word.as_str() {
            "declare" | "local" => {
                self.declaration(i, if word == "local" { DeclarationKind::Local } else { DeclarationKind::Declare })
            }
            "macro" => self.definition(i),
            "for" => {
                let name = self.next(self.next(i));
                if self.kind(name) == Some(TokenKind::Name) {
                    self.declare(name, DeclarationKind::Counter, at.start);
                    return name + 1;
                }
                i + 1
            }
            "include" => {
                let file = self.next(i);
                if self.kind(file) == Some(TokenKind::Text) {
                    let name = self.read(file).trim_matches('"').to_string();
                    self.scan.includes.push((name, self.at(file)));
                }
                i + 1
            }
            "end" => {
                let inner = self.open.iter().rev().find(|pair| self.scan.pairs[**pair].open == b'#');
                if inner.is_some_and(|pair| self.scan.pairs[*pair].name == "macro")
                    && let Some(number) = self.macros.pop()
                {
                    self.scan.macros[number].whole.end = at.end;
                    let start = self.scan.macros[number].whole.start;
                    let own = self.scan.declarations.iter_mut().rev().find(|d| d.whole.start == start);
                    own.into_iter().for_each(|d| d.whole.end = at.end);
                }
                self.close(b'#', at.end);
                i + 1
            }
            _ => i + 1,
        }
    }

    fn declaration(&mut self, i: usize, kind: DeclarationKind) -> usize {
        let mut name = self.next(i);
        if self.read(name) == "deprecated" {
            name = (name..name + 6).find(|i| self.kind(*i) == Some(TokenKind::Name)).unwrap_or(name);
        }
        let assigns = self.read(self.next(name)) == "=";
        if self.kind(name) != Some(TokenKind::Name) || !assigns {
            return i + 1;
        }
        let start = self.at(i).start;
        self.declare(name, kind, start);
        name + 1
    }

    fn definition(&mut self, i: usize) -> usize {
        let start = self.at(i).start;
        let name = self.next(i);
        let is_named = self.kind(name) == Some(TokenKind::Name);
        if is_named {
            self.declare(name, DeclarationKind::Macro, start);
        }
        let number = self.scan.macros.len();
        let outer = self.macros.last().copied();
        self.scan.macros.push(Macro { whole: start..self.text.len(), outer, parameters: vec![] });
        self.macros.push(number);
        let mut at = self.next(name);
        if !is_named || self.read(at) != "(" {
            return name + usize::from(is_named);
        }
        let open = at;
        at = self.next(at);
        while at < self.scan.tokens.len() && self.read(at) != ")" {
            // `optional C`: the second name is the parameter.
            if self.kind(at) == Some(TokenKind::Name) && self.kind(self.next(at)) != Some(TokenKind::Name) {
                let parameter = self.read(at).to_string();
                self.scan.macros[number].parameters.push(parameter);
                self.declare(at, DeclarationKind::Parameter, start);
            } else if !matches!(self.kind(at), Some(TokenKind::Name | TokenKind::Sign | TokenKind::Word(_))) {
                break;
            }
            at = self.next(at);
        }
        self.sign(open);
        at
    }

    fn declare(&mut self, name: usize, kind: DeclarationKind, start: usize) {
        let at = self.at(name);
        let declared = Declaration {
            name: self.read(name).into(),
            whole: start..at.end,
            at,
            kind,
            scope: self.macros.last().copied(),
        };
        self.scan.declarations.push(declared);
    }
}
