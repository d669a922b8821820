//! The interpreter's implementation of [`Reader`], by which the readers of blocks get their words and values.

mod color;
mod font;
mod mesh_file;
mod message;
mod skip;
mod transform;

pub(super) use transform::TransformThing;

use super::evaluator::{Contents, TOLERANCE, as_float, as_vector, not_text_error};
use super::stream::Token;
use super::{Interpreter, reporter::hints};
use crate::color::Color;
use crate::diagnostic::{Diagnostic, Result, codes, did_you_mean};
use crate::font::Font;
use crate::image_io::Picture;
use crate::math::{DVec2, DVec3, Transform};
use crate::scene::Object;
use crate::source::{Files, Span};
use crate::syntax::ast::*;
use crate::value::{BuildMesh, FloatOrColor, Language, Next, Reader, Solid, Thing, Value};
use crate::world::Probe;
pub use color::COLOR_WORDS;
pub(super) use color::begins_color;
use std::path::PathBuf;
use std::sync::Arc;

impl<'a> Interpreter<'a> {
    /// Reads a string, and returns it with its span.
    pub(super) fn read_text_value(&mut self) -> Result<(String, Span)> {
        // A sign after a string is no operator: strings have none.
        let (value, span) = self.read_primary()?;
        match value {
            Value::Text(text) => Ok((text.to_string(), span)),
            other => not_text_error(&other, span),
        }
    }

    /// Reads a number, and returns it with its span.
    pub(super) fn read_number(&mut self) -> Result<(f64, Span)> {
        let (value, span) = self.read_value()?;
        Ok((as_float(&value, span)?, span))
    }
}

fn checked_finite(v: DVec3, span: Span) -> Result<DVec3> {
    if v.is_finite() {
        return Ok(v);
    }
    Diagnostic::err(codes::NOT_FINITE, span, "this vector holds a number that is not finite")
}

impl Reader for Interpreter<'_> {
    fn peek_next(&mut self) -> Result<Next> {
        Ok(match self.peek()? {
            Token::Block(name) => match name.word {
                Some(word) => Next::Block(word),
                None => {
                    let (text, span) = (self.inputs.sources.snippet(name.span), name.span);
                    let d = Diagnostic::new(codes::UNKNOWN_WORD, span, format!("there is no block `{text} {{…}}`"));
                    let symbol = self.inputs.names.find(text);
                    if let Some(Next::Thing(kind)) = symbol.map(|symbol| self.evaluator.next_kind_of_name(symbol)) {
                        return d.help(format!("write `{kind} {{ {text} … }}`")).into();
                    }
                    let near = did_you_mean(text, crate::syntax::word::KEYWORDS.iter().copied());
                    let near = near.or_else(|| self.reporter.include_hint(text));
                    return d.maybe_help(near).maybe_help(hints::other_tool_hint(text).map(String::from)).into();
                }
            },
            Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) => self.evaluator.next_kind_of_name(*symbol),
            Token::Element(_) => {
                match self.stream.array_element().and_then(|lvalue| self.evaluator.scopes().contents_at(lvalue)) {
                    Some(Contents::Value(Value::Thing(thing))) => Next::Thing(thing.kind()),
                    _ => Next::Value,
                }
            }
            Token::Function(_) => Next::Function,
            Token::Expr(_) | Token::Numbers(_) => Next::Value,
            Token::Callee(_) => Next::Value,
            Token::Word(word) => Next::Word(word),
            Token::Open(Bracket::Square, _) => Next::Entry,
            Token::Open(Bracket::Brace, _) => Next::Group,
            // The reader of the value reports what is wrong with it.
            Token::Open(Bracket::Paren, _) => Next::Value,
            Token::Punctuation(Punctuation::Close(_)) | Token::End => Next::End,
            Token::Punctuation(_) => Next::Value,
        })
    }

    fn span(&mut self) -> Span {
        // This method cannot fail, so it reports a fault in a directive before the token.
        if let Err(fault) = self.peek() {
            let fault = self.stream.with_call_trace(*fault);
            self.reporter.report(fault);
        }
        self.stream.next_span()
    }

    fn take_token(&mut self) -> Result<Span> {
        self.open_bracket()
    }

    fn leave_block(&mut self) -> Result<()> {
        self.close_bracket("the end of this block")
    }

    fn value(&mut self) -> Result<(Value, Span)> {
        self.read_value()
    }

    fn take_thing(&mut self) -> Result<(Arc<dyn Thing>, Span)> {
        let token = self.peek()?;
        let span = self.stream.next_span();
        let value = match token {
            Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) => {
                self.stream.advance();
                Some(self.evaluate_name(*symbol, span)?)
            }
            Token::Function(_) => match self.read_rvalue()? {
                Contents::Value(value) => Some(value),
                _ => None,
            },
            Token::Element(_) => {
                let contents = self.take_array_element()?;
                Some(self.value_of_contents(contents, span)?)
            }
            _ => None,
        };
        match value {
            Some(Value::Thing(thing)) => Ok((thing, span)),
            _ => Err(self.unexpected_token("a declared thing").into()),
        }
    }

    fn read_solid(&mut self) -> Result<Arc<dyn Solid>> {
        let defaults = self.builder.defaults().clone();
        let object = Object::read(self, &defaults)?;
        Ok(Arc::new(Probe::new(&object)?))
    }

    fn read_pigment_pattern(&mut self) -> Result<Arc<dyn Thing>> {
        self.read_pigment_as_pattern()
    }

    fn float(&mut self) -> Result<f64> {
        self.expect_value("a number")?;
        let (value, span) = self.read_value()?;
        let x = as_float(&value, span)?;
        if x.is_finite() { Ok(x) } else { Diagnostic::err(codes::NOT_FINITE, span, format!("this number is {x}")) }
    }

    fn optional_float(&mut self) -> Result<Option<f64>> {
        if Reader::peek_next(self)? == Next::Value { self.float().map(Some) } else { Ok(None) }
    }

    fn vector(&mut self) -> Result<DVec3> {
        self.expect_value("a vector")?;
        let (value, span) = self.read_value()?;
        checked_finite(as_vector(&value, span)?, span)
    }

    fn unchecked_vector(&mut self) -> Result<DVec3> {
        self.expect_value("a vector")?;
        let (value, span) = self.read_value()?;
        as_vector(&value, span)
    }

    fn vector2(&mut self) -> Result<DVec2> {
        let v = self.vector()?;
        Ok(DVec2::new(v.x, v.y))
    }

    fn numbers_in_angle_brackets(&mut self, n: usize) -> Result<Vec<f64>> {
        let token = self.peek()?;
        let span = self.stream.next_span();
        let data = match token {
            Token::Numbers(data) => {
                self.stream.advance();
                data.to_vec()
            }
            Token::Expr(Expr { kind: ExprKind::Literal(data), .. }) => {
                self.stream.advance();
                data.to_vec()
            }
            Token::Expr(Expr { kind: ExprKind::Vector(parts), .. }) => {
                self.stream.advance();
                self.evaluate_numbers(parts)?
            }
            Token::Punctuation(Punctuation::Operator(Operator::Less)) => self.read_vector_numbers()?.0,
            _ => {
                let (value, span) = self.read_value()?;
                match value {
                    Value::Vector(v) => v.c[..v.len as usize].to_vec(),
                    other => {
                        let message = format!("expected {n} numbers in `< >`, found {}", other.describe());
                        return Diagnostic::err(codes::WRONG_TYPE, span, message);
                    }
                }
            }
        };
        if data.len() != n {
            let message = format!("expected {n} numbers in `< >`, found {}", data.len());
            return Diagnostic::err(codes::WRONG_COUNT, span, message);
        }
        if !data.iter().all(|x| x.is_finite()) {
            return Diagnostic::err(codes::NOT_FINITE, span, "this vector holds a number that is not finite");
        }
        Ok(data)
    }

    fn read_literals(&mut self, width: usize, most: usize, take: &mut dyn FnMut(&[f64]) -> bool) -> usize {
        self.stream.take_middle_list_items(width, most, take)
    }

    fn numbers_in_parentheses(&mut self, n: usize) -> Result<Vec<f64>> {
        let span = self.stream.next_span();
        self.expect_paren("the word")?;
        let mut numbers = vec![];
        while !self.peek()?.closes(Bracket::Paren) {
            numbers.push(self.float()?);
        }
        self.close_bracket("`)`")?;
        if numbers.len() != n {
            let message = format!("expected {n} numbers in `( )`, found {}", numbers.len());
            return Diagnostic::err(codes::WRONG_COUNT, span, message);
        }
        Ok(numbers)
    }

    fn read_colon(&mut self) -> Result<()> {
        if !matches!(self.peek()?, Token::Punctuation(Punctuation::Colon)) {
            return Err(self.unexpected_token("`:`").into());
        }
        self.stream.advance();
        Ok(())
    }

    fn color(&mut self) -> Result<Color> {
        self.read_color()
    }

    fn peek_next_unless_separated(&mut self) -> Result<Next> {
        match self.peek_continuation()? {
            Token::End => Ok(Next::End),
            _ => Reader::peek_next(self),
        }
    }

    fn float_or_color(&mut self) -> Result<FloatOrColor> {
        self.read_float_or_color()
    }

    fn may_be_at_color(&mut self) -> Result<bool> {
        Ok(match self.peek()? {
            Token::Word(word) => begins_color(word),
            Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) => {
                matches!(self.evaluator.next_kind_of_name(*symbol), Next::Value)
                    && !matches!(self.evaluator.scopes().get(*symbol), Some(Contents::Value(Value::Text(_))))
            }
            Token::Element(_) => {
                let contents =
                    self.stream.array_element().and_then(|lvalue| self.evaluator.scopes().contents_at(lvalue));
                matches!(contents, Some(Contents::Value(Value::Float(_) | Value::Vector(_) | Value::Color(_))))
            }
            Token::Expr(_) | Token::Numbers(_) | Token::Callee(_) | Token::Open(Bracket::Paren, _) => true,
            Token::Punctuation(mark) => matches!(mark, Punctuation::Not | Punctuation::Operator(_)),
            _ => false,
        })
    }

    fn transform(&mut self) -> Result<Option<Box<Transform>>> {
        self.read_transform()
    }

    fn text(&mut self) -> Result<String> {
        self.read_text_value().map(|(text, _)| text)
    }

    fn flag(&mut self) -> Result<bool> {
        Ok(self.optional_float()?.is_none_or(|x| x.abs() > TOLERANCE))
    }

    fn language(&self) -> Language {
        self.builder.language()
    }

    fn files(&self) -> &dyn Files {
        self.inputs.files
    }

    fn find_file(&mut self, name: &str, at: Span) -> Result<Option<PathBuf>> {
        self.find_readable_file(name, at)
    }

    fn open_picture(&mut self, name: &str, at: Span, format: Option<&str>) -> Result<Arc<Picture>> {
        let Some(path) = self.find_readable_picture(name, at, format)? else {
            let d = Diagnostic::new(codes::MISSING_INCLUDE, at, format!("the picture `{name}` was not found"));
            return d.help("pictures are searched in the same folders as included files; -I DIR adds a folder").into();
        };
        self.picture_at(path, at)
    }

    fn read_mesh_file(&mut self, build: BuildMesh) -> Result<Arc<dyn Thing>> {
        self.read_mesh_file(build)
    }

    fn read_function_if_sized(&mut self) -> Result<Option<([usize; 2], Arc<dyn Thing>)>> {
        if !matches!(self.peek()?, Token::Function(_)) {
            return Ok(None);
        }
        self.read_function_if_sized()
    }

    fn find_font_or_substitute(&mut self, name: &str, at: Span) -> Result<Arc<Font>> {
        self.find_font_or_substitute(name, at)
    }

    fn skip_item(&mut self) -> Result<()> {
        self.skip_next_item()
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        let diagnostic = self.stream.with_call_trace(diagnostic);
        self.reporter.report(diagnostic);
    }

    fn unexpected(&mut self, expected: &str) -> Diagnostic {
        self.unexpected_token(expected)
    }

    fn unknown_word(&mut self, block: &str, takes: &[&'static str]) -> Diagnostic {
        self.unknown_word_error(block, takes)
    }
}

impl Interpreter<'_> {
    /// Finds a picture file. Returns `None` without a message if the file does not exist, and an error if the scene may
    /// not read it. A name without an extension gets the one of the format, in small or capital letters; without a
    /// format, that of PNG.
    fn find_readable_picture(&mut self, name: &str, at: Span, format: Option<&str>) -> Result<Option<PathBuf>> {
        if name.contains('.') {
            return self.find_readable_file(name, at);
        }
        let endings: &[&str] = match format {
            Some("jpeg") => &["jpg", "JPG", "jpeg", "JPEG"],
            Some("tiff") => &["tiff", "TIFF", "tif", "TIF"],
            Some(format) => &[format, &format.to_uppercase()],
            None => &["png", "PNG"],
        };
        let names: Vec<String> = endings.iter().map(|ending| format!("{name}.{ending}")).collect();
        let search = &self.inputs.options.search;
        let found = names.iter().find(|name| search.find_exact(self.inputs.files, name).is_some());
        self.find_readable_file(found.unwrap_or(&names[0]), at)
    }

    /// Returns the picture in a file, which is decoded once per run.
    fn picture_at(&mut self, path: PathBuf, at: Span) -> Result<Arc<Picture>> {
        if let Some(picture) = self.evaluator.assets().pictures.get(&path) {
            return Ok(picture.clone());
        }
        let picture = Arc::new(Picture::read(self.inputs.files, &path).map_err(|fault| fault.at(at))?);
        self.evaluator.assets().pictures.insert(path, picture.clone());
        Ok(picture)
    }

    /// Checks the width or height of a function's picture.
    pub(super) fn checked_picture_side(&self, n: f64, span: Span) -> Result<usize> {
        if (1.0..=16384.0).contains(&n) {
            return Ok(n as usize);
        }
        Diagnostic::err(codes::BAD_ARGUMENT, span, format!("a picture has 1 to 16384 points a side, found {n}"))
    }
}
