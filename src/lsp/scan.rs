//! What an editor asks of a text: its tokens with what they are, names where they are declared and used, what blocks and
//! directives stand around a place. It walks the lossless tokens once.

use crate::syntax::word::{Category, entry};
use crate::syntax::{Piece, Tokens, opens};
use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A word of the language.
    Word(Category),
    /// An author's name.
    Name,
    /// `#…`
    Directive,
    /// `"…"`
    Text,
    /// Numbers, also lists of them.
    Number,
    /// Brackets, operators, commas.
    Sign,
    /// `//` or `/* */`
    Comment,
}

/// A token or a comment.
#[derive(Clone, Debug)]
pub struct Token {
    /// Local bytes.
    pub at: Range<usize>,
    /// What it is.
    pub kind: Kind,
}

/// How a name is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// `#declare`
    Declare,
    /// `#local`
    Local,
    /// `#macro`
    Macro,
    /// Of a macro.
    Parameter,
    /// Of `#for`.
    Counter,
}

/// A name where it is declared.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// The name.
    pub name: String,
    /// Its bytes.
    pub at: Range<usize>,
    /// How.
    pub what: What,
    /// The innermost macro around it.
    pub scope: Option<usize>,
    /// The whole declaration, as far as it is one: of a macro, up to its `#end`.
    pub whole: Range<usize>,
}

/// A name where it is used.
#[derive(Clone, Debug)]
pub struct Use {
    /// The name.
    pub name: String,
    /// Its bytes.
    pub at: Range<usize>,
    /// The innermost macro around it.
    pub scope: Option<usize>,
}

/// A macro.
#[derive(Clone, Debug, Default)]
pub struct Macro {
    /// From `#macro` to `#end`.
    pub whole: Range<usize>,
    /// The macro around it.
    pub outer: Option<usize>,
    /// Its parameters' names.
    pub parameters: Vec<String>,
}

/// Brackets or a directive with a body.
#[derive(Clone, Debug)]
pub struct Pair {
    /// The word before a brace; the directive's word.
    pub name: String,
    /// From the bracket or the directive to the end of its partner, or of the text.
    pub whole: Range<usize>,
    /// What opens it.
    pub open: u8,
    /// The bytes of the name.
    pub named: Range<usize>,
    /// The pair around it.
    pub outer: Option<usize>,
    /// Is there a partner?
    pub closed: bool,
}

/// All that is known of a text.
#[derive(Debug, Default)]
pub struct Scan {
    /// In their order.
    pub tokens: Vec<Token>,
    /// In their order.
    pub declarations: Vec<Declaration>,
    /// In their order.
    pub uses: Vec<Use>,
    /// By number.
    pub macros: Vec<Macro>,
    /// In the order in which they open.
    pub pairs: Vec<Pair>,
    /// Names of included files with their bytes, quotes and all.
    pub includes: Vec<(String, Range<usize>)>,
}

impl Scan {
    /// Looks through a text whose first byte has the global offset `base`.
    pub fn of(text: &str, base: usize, tokens: &Tokens) -> Self {
        let mut scan = Self::default();
        for piece in tokens.pieces() {
            let span = piece.span();
            let at = (span.lo as usize).saturating_sub(base)..(span.hi as usize).saturating_sub(base);
            let kind = match piece {
                Piece::Comment(_) => Kind::Comment,
                Piece::Token(_) => kind_of(&text[at.clone()]),
            };
            scan.tokens.push(Token { at, kind });
        }
        Scanner { text, scan: &mut scan, macros: vec![], open: vec![] }.run();
        scan
    }

    /// The token at a byte, or the one that ends there.
    pub fn token_at(&self, offset: usize) -> Option<&Token> {
        let i = self.tokens.partition_point(|token| token.at.end < offset);
        let first = self.tokens.get(i).filter(|token| token.at.start <= offset)?;
        // Between two, a word counts more than a sign.
        let second = self.tokens.get(i + 1).filter(|token| token.at.start <= offset);
        Some(second.filter(|_| first.kind == Kind::Sign).unwrap_or(first))
    }

    /// The innermost pair around a byte that this holds for.
    pub fn around(&self, offset: usize, holds: impl Fn(&Pair) -> bool) -> Option<&Pair> {
        let inside = |pair: &&Pair| pair.whole.start < offset && (offset < pair.whole.end || !pair.closed);
        self.pairs.iter().rev().filter(inside).find(|pair| holds(pair))
    }

    /// The innermost macro around a byte.
    pub fn macro_at(&self, offset: usize) -> Option<usize> {
        let inside = |m: &&Macro| m.whole.start < offset && offset < m.whole.end;
        self.macros
            .iter()
            .filter(inside)
            .max_by_key(|m| m.whole.start)
            .and_then(|found| self.macros.iter().position(|m| m.whole == found.whole))
    }

    /// The macro to which a name belongs that is used in `scope`; none if it belongs to all.
    pub fn owner(&self, name: &str, mut scope: Option<usize>) -> Option<usize> {
        while let Some(number) = scope {
            let is_own = |d: &Declaration| {
                d.scope == scope && d.name == name && d.what != What::Declare && d.what != What::Macro
            };
            if self.declarations.iter().any(is_own) {
                return scope;
            }
            scope = self.macros.get(number)?.outer;
        }
        None
    }
}

fn kind_of(text: &str) -> Kind {
    match text.as_bytes() {
        [b'#', ..] => Kind::Directive,
        [b'"', ..] => Kind::Text,
        [b'a'..=b'z' | b'A'..=b'Z' | b'_', ..] => entry(text).map_or(Kind::Name, |word| match word.category {
            Category::Contextual => Kind::Name,
            category => Kind::Word(category),
        }),
        [b'0'..=b'9', ..] => Kind::Number,
        [_, _, ..] if text.contains(|c: char| c.is_ascii_digit()) => Kind::Number,
        _ => Kind::Sign,
    }
}

/// The word of a directive, without `#` and blanks.
pub fn directive(text: &str) -> &str {
    text.trim_start_matches('#').trim_start()
}

struct Scanner<'a> {
    text: &'a str,
    scan: &'a mut Scan,
    /// Numbers of the macros that are open.
    macros: Vec<usize>,
    /// Numbers of the pairs that are open.
    open: Vec<usize>,
}

impl Scanner<'_> {
    fn read(&self, i: usize) -> &str {
        self.scan.tokens.get(i).map_or("", |token| &self.text[token.at.clone()])
    }

    /// The number of the next token behind `i` that is no comment.
    fn next(&self, i: usize) -> usize {
        let is_comment = |i: &usize| self.scan.tokens.get(*i).is_some_and(|token| token.kind == Kind::Comment);
        (i + 1..).find(|i| !is_comment(i)).unwrap_or(i + 1)
    }

    fn kind(&self, i: usize) -> Option<Kind> {
        self.scan.tokens.get(i).map(|token| token.kind)
    }

    fn at(&self, i: usize) -> Range<usize> {
        self.scan.tokens.get(i).map_or(self.text.len()..self.text.len(), |token| token.at.clone())
    }

    fn run(mut self) {
        let mut i = 0;
        while i < self.scan.tokens.len() {
            i = match self.kind(i) {
                Some(Kind::Directive) => self.directive(i),
                Some(Kind::Name) => {
                    let one = Use { name: self.read(i).into(), at: self.at(i), scope: self.macros.last().copied() };
                    self.scan.uses.push(one);
                    i + 1
                }
                Some(Kind::Sign) => {
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

    /// Closes the innermost pair of this kind that no other kind of body hides.
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
                let before = (0..i).rev().find(|i| self.kind(*i) != Some(Kind::Comment));
                let named = before.filter(|i| matches!(self.kind(*i), Some(Kind::Name | Kind::Word(_))));
                let (open, named) = (*open, named.map_or(at.start..at.start, |i| self.at(i)));
                self.open(open, named, at.start);
            }
            [b'}'] => self.close(b'{', at.end),
            [b')'] => self.close(b'(', at.end),
            [b']'] => self.close(b'[', at.end),
            _ => {}
        }
    }

    /// Tells where to go on.
    fn directive(&mut self, i: usize) -> usize {
        let at = self.at(i);
        let word = directive(self.read(i)).to_string();
        if opens(&word) {
            let start = at.end - word.len();
            self.open(b'#', start..at.end, at.start);
        }
        match word.as_str() {
            "declare" | "local" => self.declaration(i, if word == "local" { What::Local } else { What::Declare }),
            "macro" => self.definition(i),
            "for" => {
                let name = self.next(self.next(i));
                if self.kind(name) == Some(Kind::Name) {
                    self.declare(name, What::Counter, at.start);
                    return name + 1;
                }
                i + 1
            }
            "include" => {
                let file = self.next(i);
                if self.kind(file) == Some(Kind::Text) {
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

    fn declaration(&mut self, i: usize, what: What) -> usize {
        let mut name = self.next(i);
        if self.read(name) == "deprecated" {
            name = (name..name + 6).find(|i| self.kind(*i) == Some(Kind::Name)).unwrap_or(name);
        }
        let assigns = self.read(self.next(name)) == "=";
        if self.kind(name) != Some(Kind::Name) || !assigns {
            return i + 1;
        }
        let start = self.at(i).start;
        self.declare(name, what, start);
        name + 1
    }

    fn definition(&mut self, i: usize) -> usize {
        let start = self.at(i).start;
        let name = self.next(i);
        let is_named = self.kind(name) == Some(Kind::Name);
        if is_named {
            self.declare(name, What::Macro, start);
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
            // `optional C`: the second name is the parameter's.
            if self.kind(at) == Some(Kind::Name) && self.kind(self.next(at)) != Some(Kind::Name) {
                let parameter = self.read(at).to_string();
                self.scan.macros[number].parameters.push(parameter);
                self.declare(at, What::Parameter, start);
            } else if !matches!(self.kind(at), Some(Kind::Name | Kind::Sign | Kind::Word(_))) {
                break;
            }
            at = self.next(at);
        }
        self.sign(open);
        at
    }

    fn declare(&mut self, name: usize, what: What, start: usize) {
        let at = self.at(name);
        let declared = Declaration {
            name: self.read(name).into(),
            whole: start..at.end,
            at,
            what,
            scope: self.macros.last().copied(),
        };
        self.scan.declarations.push(declared);
    }
}
