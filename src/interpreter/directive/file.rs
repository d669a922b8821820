//! `#fopen`, `#fclose`, `#read`, `#write` (manual, "User Defined File I/O").

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::scope::Slot;
use crate::interpreter::stream::Token;
use crate::source::{Span, read_text};
use crate::syntax::ast::{Element, ElementKind, Expr, ExprKind, Symbol};
use crate::value::{Value, VecN};
use std::io::Write;
use std::path::PathBuf;
use std::rc::Rc;

/// The most bytes that one scene may write.
const MAX_WRITTEN: u64 = 4 << 30;

/// A file between its `#fopen` and its `#fclose`.
#[derive(Debug)]
pub(in crate::interpreter) struct OpenFile {
    /// As the scene calls it.
    name: String,
    path: PathBuf,
    access: Access,
}

#[derive(Debug)]
enum Access {
    /// The text's first byte as a global offset, and how far it has been read.
    Read {
        base: usize,
        text: String,
        at: usize,
    },
    Write(std::io::BufWriter<std::fs::File>),
    Closed,
}

impl<'a> Interpreter<'a> {
    pub(in crate::interpreter) fn file(
        &mut self,
        kind: &'static str,
        elements: &'a [Element],
        span: Span,
    ) -> Result<()> {
        match kind {
            "fopen" => self.open_file(elements, span),
            "fclose" => match file_name(elements) {
                Some(symbol) => {
                    self.close_file(symbol);
                    Ok(())
                }
                None => Ok(()),
            },
            "read" => self.read_file(elements, span),
            // Without its `)` the list is continued by later directives.
            _ if elements.is_empty() => self.write_on(span),
            _ => self.enclosed(None, elements, span, |me| me.write_file(span)),
        }
    }

    /// `#fopen Name "file" read`
    fn open_file(&mut self, elements: &'a [Element], span: Span) -> Result<()> {
        let (Some(symbol), Some(Element { kind: ElementKind::Expr(path), span: at })) =
            (file_name(elements), elements.get(1))
        else {
            return Diagnostic::err(
                codes::EXPECTED,
                span,
                "`#fopen` takes a name, a file and `read`, `write` or `append`",
            );
        };
        let name = self.text_value(path)?;
        let word = match elements.get(2).map(|e| &e.kind) {
            Some(ElementKind::Word(word)) => *word,
            Some(ElementKind::Expr(e)) => self.sources.snippet(e.span),
            _ => "",
        };
        let file = match word {
            "read" => self.open_to_read(&name, *at),
            "write" | "append" => self.open_to_write(&name, word == "append", *at),
            _ => {
                let d = Diagnostic::new(
                    codes::EXPECTED,
                    at.end(),
                    "expected `read`, `write` or `append` behind the file's name",
                );
                return d.help(format!("`#fopen {} \"{name}\" read`", self.names.text(symbol))).into();
            }
        };
        // What is done with a file that could not be opened is no fault of its own.
        let file = file.inspect_err(|_| self.scopes.set_global(symbol, Slot::Faulty(Rc::default()), vec![]))?;
        self.files.push(file);
        self.scopes.set_global(symbol, Slot::File(self.files.len() - 1), vec![]);
        Ok(())
    }

    fn open_to_read(&mut self, name: &str, span: Span) -> Result<OpenFile> {
        let Some(path) = self.find_read_file(name, span)? else {
            let d = Diagnostic::new(codes::MISSING_INCLUDE, span, format!("the file `{name}` was not found"));
            let folders: Vec<String> =
                self.options.search.folders.iter().map(|f| format!("`{}`", f.display())).collect();
            return d
                .help(format!("looked in {}; `#if (file_exists(\"{name}\"))` asks for it", folders.join(", ")))
                .into();
        };
        let text = read_text(&path).map_err(|e| {
            let message = crate::diagnostic::file::unreadable(&path, &e).message;
            Box::new(Diagnostic::new(codes::UNREADABLE_INCLUDE, span, message))
        })?;
        let Some(file) = self.sources.add(name, Some(&path), text.clone()) else {
            return self.limit(codes::MEMORY_LIMIT, span, "the scene's text is larger than 4 GB".into(), "split it");
        };
        let access = Access::Read { base: self.sources.base(file), text, at: 0 };
        Ok(OpenFile { name: name.into(), path, access })
    }

    fn open_to_write(&mut self, name: &str, append: bool, span: Span) -> Result<OpenFile> {
        let path = PathBuf::from(name);
        if !self.options.sandbox.may_write(&path) {
            let message = format!("the scene may not write `{name}`");
            return Diagnostic::new(codes::FORBIDDEN_FILE, span, message)
                .help("scenes write below the current folder only; --allow-write DIR allows another one")
                .into();
        }
        let file = std::fs::OpenOptions::new().create(true).write(true).append(append).truncate(!append).open(&path);
        match file {
            Ok(file) => {
                self.parsed.forget(&path);
                Ok(OpenFile { name: name.into(), path, access: Access::Write(std::io::BufWriter::new(file)) })
            }
            Err(error) => {
                let message = format!("`{name}` can't be written: {error}");
                Diagnostic::err(codes::UNREADABLE_INCLUDE, span, message)
            }
        }
    }

    fn close_file(&mut self, symbol: Symbol) {
        if let Some(Slot::File(index)) = self.scopes.get(symbol) {
            let index = *index;
            let path = self.files[index].path.clone();
            self.files[index].access = Access::Closed;
            self.parsed.forget(&path);
            if let Some(place) = self.scopes.resolve(symbol) {
                self.scopes.unbind(&place);
            }
        }
    }

    fn file_number(&mut self, symbol: Symbol, span: Span) -> Result<usize> {
        match self.scopes.get(symbol) {
            Some(Slot::File(index)) => Ok(*index),
            Some(Slot::Faulty(_)) => Diagnostic::err(codes::FOLLOWS, span, ""),
            _ => {
                let name = self.names.text(symbol);
                let d = Diagnostic::new(codes::WRONG_TYPE, span, format!("`{name}` is no open file"));
                d.help(format!("`#fopen {name} \"file.txt\" read` opens one")).into()
            }
        }
    }

    /// `#read (Name, A, B)`: a file that has been read to its end is closed, which `defined` tells.
    fn read_file(&mut self, elements: &'a [Element], span: Span) -> Result<()> {
        let Some(file) = file_name(elements) else {
            return Diagnostic::err(codes::EXPECTED, span, "`#read` takes an open file and names");
        };
        let index = self.file_number(file, elements[0].span)?;
        for element in &elements[1..] {
            let ElementKind::Expr(target) = &element.kind else {
                return Diagnostic::err(codes::EXPECTED, element.span, "expected a name for what is read");
            };
            let value = self.next_value(index, span);
            if let (Err(_), ExprKind::Name(symbol)) = (&value, &target.kind) {
                self.scopes.set_global(*symbol, Slot::Faulty(Rc::default()), vec![]);
            }
            let (value, more) = match value? {
                Some(found) => found,
                None => {
                    self.close_file(file);
                    return Ok(());
                }
            };
            match &target.kind {
                ExprKind::Name(symbol) => self.scopes.set_global(*symbol, Slot::Value(value), vec![]),
                ExprKind::Index(array, indices) => {
                    let place = self.element_place(array, indices)?;
                    self.scopes.set_element(&place, Some(Slot::Value(value)));
                }
                _ => return Diagnostic::err(codes::EXPECTED, element.span, "expected a name for what is read"),
            }
            if !more {
                self.close_file(file);
                return Ok(());
            }
        }
        Ok(())
    }

    /// The next number, vector or string of a file, and whether anything follows it.
    fn next_value(&mut self, index: usize, span: Span) -> Result<Option<(Value, bool)>> {
        let file = &mut self.files[index];
        let Access::Read { base, text, at } = &mut file.access else {
            let message = format!("`{}` is open for writing: it can't be read", file.name);
            return Diagnostic::err(codes::WRONG_TYPE, span, message);
        };
        *at = skip_blanks(text, *at);
        if *at == text.len() {
            return Ok(None);
        }
        match data_value(&text[*at..]) {
            Some((value, length)) => {
                *at = skip_blanks(text, *at + length);
                Ok(Some((value, *at < text.len())))
            }
            None => {
                let place = Span::new(*base + *at, *base + *at + 1);
                let d =
                    Diagnostic::new(codes::BAD_DATA, place, "a data file holds numbers, vectors and strings, not this");
                d.also(span, "read here").into()
            }
        }
    }

    /// The arguments of a `#write` whose `)` stands in a later directive.
    fn write_on(&mut self, span: Span) -> Result<()> {
        self.write_file(span)?;
        self.advance();
        Ok(())
    }

    /// `#write (Name, A, B)`, what stands in the parentheses.
    fn write_file(&mut self, span: Span) -> Result<()> {
        let index = match self.peek()? {
            Token::Expr(Expr { kind: ExprKind::Name(symbol), span }) => {
                self.advance();
                self.file_number(*symbol, *span)?
            }
            _ => return Err(self.unexpected_token("an open file").into()),
        };
        // The binary form of the values that follow the word up to a comma; with one behind the word itself it says nothing.
        let mut form = None;
        loop {
            let token = self.peek()?;
            if self.behind_comma() {
                form = None;
            }
            match token {
                Token::End => return Ok(()),
                Token::Word(word) if Binary::of(word).is_some() => {
                    self.advance();
                    form = Binary::of(word);
                }
                Token::Word(_) => return Err(self.unexpected_token("a value").into()),
                _ => {
                    let (value, at) = self.value_here()?;
                    if let Some(form) = form {
                        let numbers = numbers_of(&value);
                        if numbers.is_empty() {
                            let message = format!("expected numbers, found {}", value.describe());
                            return Diagnostic::err(codes::WRONG_TYPE, at, message);
                        }
                        let bytes: Vec<u8> = numbers.iter().flat_map(|x| form.bytes(*x)).collect();
                        self.write_bytes(index, &bytes, span)?;
                        continue;
                    }
                    let text = match value {
                        Value::Text(text) => text.to_string(),
                        Value::Float(x) => general(x),
                        Value::Vector(v) => vector_text(&v),
                        Value::Color(c) => vector_text(&VecN::from_slice(&c.to_array())),
                        other => {
                            let message = format!("{} can't be written", other.describe());
                            return Diagnostic::err(codes::WRONG_TYPE, at, message);
                        }
                    };
                    self.write_bytes(index, text.as_bytes(), span)?;
                }
            }
        }
    }

    /// Does a comma stand between what was read last and what comes next? The tree keeps none.
    fn behind_comma(&self) -> bool {
        // What comes next is the element at hand, or the first of a body whose call or directive has been passed.
        let mut back = 1;
        for frame in self.frames.iter().rev() {
            if frame.item.0 > 0 {
                return true;
            }
            if let Some(before) = frame.at.checked_sub(back).and_then(|i| frame.elements.get(i)) {
                let Some((file, range)) = self.sources.locate(before.span) else { return false };
                let text = self.sources.text(file);
                return text[skip(text, range.end, |_| false)..].starts_with(',');
            }
            back = 2;
        }
        false
    }

    fn write_bytes(&mut self, index: usize, bytes: &[u8], span: Span) -> Result<()> {
        self.written += bytes.len() as u64;
        if self.written > MAX_WRITTEN {
            let message = format!("the scene writes more than {} GB", MAX_WRITTEN >> 30);
            return self.limit(codes::MEMORY_LIMIT, span, message, "does a loop write without end?");
        }
        let file = &mut self.files[index];
        let written = match &mut file.access {
            Access::Write(out) => out.write_all(bytes),
            _ => {
                let message = format!("`{}` is open for reading: it can't be written", file.name);
                return Diagnostic::err(codes::WRONG_TYPE, span, message);
            }
        };
        written.map_err(|error| {
            let message = format!("`{}` can't be written: {error}", file.name);
            Box::new(Diagnostic::new(codes::UNREADABLE_INCLUDE, span, message))
        })
    }
}

/// `uint16be` and its kin: whole numbers as bytes.
#[derive(Clone, Copy)]
struct Binary {
    size: usize,
    signed: bool,
    big_endian: bool,
}

impl Binary {
    fn of(word: &str) -> Option<Self> {
        let (signed, rest) = match word.strip_prefix("uint") {
            Some(rest) => (false, rest),
            None => (true, word.strip_prefix("sint")?),
        };
        let (bits, big_endian) = match rest.strip_suffix("be") {
            Some(bits) => (bits, true),
            None => (rest.strip_suffix("le").unwrap_or(rest), false),
        };
        let size = match bits {
            "8" => 1,
            "16" => 2,
            "32" => 4,
            _ => return None,
        };
        Some(Self { size, signed, big_endian })
    }

    /// The nearest whole number in the range.
    fn bytes(self, x: f64) -> Vec<u8> {
        let values = (1_i64 << (8 * self.size)) as f64;
        let (low, high) = if self.signed { (-values / 2.0, values / 2.0 - 1.0) } else { (0.0, values - 1.0) };
        let bytes = (x.round().clamp(low, high) as i64).to_le_bytes();
        let mut out = bytes[..self.size].to_vec();
        if self.big_endian {
            out.reverse();
        }
        out
    }
}

fn numbers_of(value: &Value) -> Vec<f64> {
    match value {
        Value::Float(x) => vec![*x],
        Value::Vector(v) => v.c[..v.len as usize].to_vec(),
        _ => vec![],
    }
}

/// The name that a directive's elements begin with.
fn file_name(elements: &[Element]) -> Option<Symbol> {
    match elements.first().map(|e| &e.kind) {
        Some(ElementKind::Expr(e)) => match e.kind {
            ExprKind::Name(symbol) => Some(symbol),
            _ => None,
        },
        _ => None,
    }
}

/// Over blanks, commas and comments.
fn skip_blanks(text: &str, at: usize) -> usize {
    skip(text, at, |c| c == ',')
}

/// Over blanks, comments and these characters.
fn skip(text: &str, mut at: usize, also: fn(char) -> bool) -> usize {
    loop {
        let rest = &text[at..];
        let blank = rest.len() - rest.trim_start_matches(|c: char| c.is_whitespace() || also(c)).len();
        let comment = match &rest.as_bytes()[blank..] {
            [b'/', b'/', ..] => rest[blank..].find(['\n', '\r']).unwrap_or(rest.len() - blank),
            [b'/', b'*', ..] => rest[blank..].find("*/").map_or(rest.len() - blank, |i| i + 2),
            _ => 0,
        };
        if blank + comment == 0 {
            return at;
        }
        at += blank + comment;
    }
}

/// A number, vector or string that a text begins with, and how long it is.
fn data_value(text: &str) -> Option<(Value, usize)> {
    match text.as_bytes()[0] {
        b'"' => {
            let end = 1 + closing_quote(&text[1..])?;
            let inner = crate::syntax::unescape(&text[..=end]);
            Some((Value::Text((*inner).into()), end + 1))
        }
        b'<' => {
            let (mut at, mut c) = (1, vec![]);
            loop {
                at = skip_blanks(text, at);
                if text[at..].starts_with('>') {
                    break;
                }
                let (x, length) = number(&text[at..])?;
                c.push(x);
                at += length;
            }
            (2..=5).contains(&c.len()).then(|| (Value::Vector(VecN::from_slice(&c)), at + 1))
        }
        _ => number(text).map(|(x, length)| (Value::Float(x), length)),
    }
}

fn closing_quote(text: &str) -> Option<usize> {
    let mut escaped = false;
    text.bytes().position(|b| {
        let ends = b == b'"' && !escaped;
        escaped = b == b'\\' && !escaped;
        ends
    })
}

fn number(text: &str) -> Option<(f64, usize)> {
    let end =
        text.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E' | '+' | '-'))).unwrap_or(text.len());
    (1..=end.min(60)).rev().find_map(|end| text[..end].parse().ok().map(|x| (x, end)))
}

/// `<1,2,3> `, as POV-Ray writes it.
fn vector_text(v: &VecN) -> String {
    let parts: Vec<String> = v.c[..v.len as usize].iter().map(|x| general(*x)).collect();
    format!("<{}> ", parts.join(","))
}

/// A number as C's `%g` writes it: six digits that count, without zeros at the end.
fn general(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return match x {
            _ if x.is_nan() => "nan".into(),
            _ if x.is_infinite() => if x > 0.0 { "inf" } else { "-inf" }.into(),
            _ => "0".into(),
        };
    }
    let scientific = format!("{x:.5e}");
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let trimmed = |s: &str| {
        if s.contains('.') { s.trim_end_matches('0').trim_end_matches('.').to_string() } else { s.to_string() }
    };
    if (-4..6).contains(&exponent) {
        return trimmed(&format!("{x:.*}", (5 - exponent) as usize));
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{}e{sign}{:02}", trimmed(digits), exponent.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_as_bytes() {
        let bytes = |word, x| Binary::of(word).map(|form| form.bytes(x));
        assert_eq!(bytes("uint8", 65.0), Some(vec![65]));
        assert_eq!(bytes("uint8", 300.0), Some(vec![255]));
        assert_eq!(bytes("sint8", -1.7), Some(vec![0xfe]));
        assert_eq!(bytes("uint16be", 258.0), Some(vec![1, 2]));
        assert_eq!(bytes("uint16le", 258.0), Some(vec![2, 1]));
        assert_eq!(bytes("sint16be", -2.0), Some(vec![255, 254]));
        assert_eq!(bytes("sint32le", 5.0), Some(vec![5, 0, 0, 0]));
        assert_eq!(bytes("float", 5.0), None);
    }

    #[test]
    fn numbers_as_c_writes_them() {
        let all = [0.1, 1.23456789, 1e5, 1e6, 1234567.89, 1e300, -2.5e-7, 0.0001, 100.0, 999_999.5];
        let texts: Vec<String> = all.iter().map(|x| general(*x)).collect();
        let wanted =
            ["0.1", "1.23457", "100000", "1e+06", "1.23457e+06", "1e+300", "-2.5e-07", "0.0001", "100", "1e+06"];
        assert_eq!(texts, wanted);
    }
}
