//! The interpreter as a [`Reader`]: what a family sees of the stream.

mod color;
mod message;
mod skip;
mod transform;

pub(super) use transform::TransformThing;

use super::eval::{as_float, as_vector};
use super::operators::SMALL;
use super::scope::Slot;
use super::stream::{FrameKind, Token};
use super::{Interpreter, compat, hints};
use crate::color::Color;
use crate::diagnostic::{Diagnostic, Result, codes, did_you_mean};
use crate::image_io::Picture;
use crate::math::{DVec2, DVec3, Transform};
use crate::scene::Object;
use crate::source::{Span, fonts};
use crate::syntax::ast::{self, *};
use crate::value::{FloatOrColor, Language, Next, Reader, Said, Solid, Thing, Value, VecN};
use crate::world::Probe;
pub use color::COLOR_WORDS;
use color::begins_color;
use std::path::PathBuf;
use std::sync::Arc;

impl<'a> Interpreter<'a> {
    /// The next value that is a number, vector, colour or text, with its place.
    pub(super) fn value_here(&mut self) -> Result<(Value, Span)> {
        let token = self.peek()?;
        let span = self.here();
        match token {
            Token::Expr(e) => {
                self.advance();
                Ok((self.eval(e)?, e.span))
            }
            Token::Element(e) => {
                let slot = self.take_element()?;
                Ok((self.slot_value(slot, e.span)?, e.span))
            }
            Token::Numbers(data) => {
                self.advance();
                let value = match data {
                    [x] => Value::Float(*x),
                    data if data.len() <= 5 => Value::Vector(VecN::from_slice(data)),
                    _ => {
                        let message = format!("a vector has two to five numbers, this has {}", data.len());
                        return Diagnostic::err(codes::WRONG_COUNT, span, message);
                    }
                };
                Ok((value, span))
            }
            // A word of durer's own may also be a name of the author's: `camera { eye eye }`.
            Token::Word(word) if self.names.find(word).is_some_and(|s| self.scopes.get(s).is_some()) => {
                self.advance();
                match self.names.find(word) {
                    Some(symbol) => Ok((self.name_value(symbol, span)?, span)),
                    None => Err(self.unexpected_token("a value").into()),
                }
            }
            Token::Word(word) if begins_color(word) => {
                let color = self.color()?;
                Ok((Value::Color(color), span))
            }
            _ => Err(self.unexpected_token("a value").into()),
        }
    }

    /// What a name in word position is: a thing, a value, or nothing.
    fn next_of_name(&mut self, symbol: Symbol) -> Next {
        match self.scopes.get(symbol) {
            Some(Slot::Value(Value::Thing(thing))) => Next::Thing(thing.kind()),
            _ => Next::Value,
        }
    }
}

fn finite(v: DVec3, span: Span) -> Result<DVec3> {
    if v.is_finite() {
        return Ok(v);
    }
    Diagnostic::err(codes::NOT_FINITE, span, "this vector holds a number that is not finite")
}

impl Reader for Interpreter<'_> {
    fn next(&mut self) -> Result<Next> {
        Ok(match self.peek()? {
            Token::Word(word) => Next::Word(word),
            Token::Block(Block { name, .. }) | Token::Open(name) => match name.word {
                Some(word) => Next::Block(word),
                None => {
                    let (text, span) = (self.sources.snippet(name.span), name.span);
                    let d = Diagnostic::new(codes::UNKNOWN_WORD, span, format!("there is no block `{text} {{…}}`"));
                    let near = did_you_mean(text, crate::syntax::word::KEYWORDS.iter().copied());
                    return d.maybe_help(near).maybe_help(hints::other_tools(text).map(String::from)).into();
                }
            },
            Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) => self.next_of_name(*symbol),
            Token::Element(_) => match self.element.as_ref().and_then(|place| self.scopes.at(place)) {
                Some(Slot::Value(Value::Thing(thing))) => Next::Thing(thing.kind()),
                _ => Next::Value,
            },
            Token::Function(_) | Token::Expr(Expr { kind: ExprKind::Function(_), .. }) => Next::Function,
            Token::Expr(_) | Token::Numbers(_) => Next::Value,
            Token::Entry(_) => Next::Entry,
            // Whoever asks for a value says what is wrong with it.
            Token::Values(_) | Token::Key(_) | Token::Colon => Next::Value,
            Token::Group(_) => Next::Group,
            Token::End => Next::End,
        })
    }

    fn span(&mut self) -> Span {
        // Whoever asks for a place can't fail: a fault in a directive on the way is told here, or nobody would tell it.
        if let Err(fault) = self.peek() {
            let fault = self.with_trace(*fault);
            self.report_fault(fault);
        }
        self.here()
    }

    fn take(&mut self) -> Result<Span> {
        let token = self.peek()?;
        let span = self.here();
        self.advance();
        match token {
            Token::Block(block) => {
                self.blocks.extend(block.name.word.map(|word| (word, block.name.span)));
                self.push_frame(&block.body, FrameKind::Enclosed, span);
                return Ok(block.name.span);
            }
            Token::Open(name) => self.blocks.extend(name.word.map(|word| (word, name.span))),
            Token::Entry(elements) | Token::Group(elements) => self.push_frame(elements, FrameKind::Enclosed, span),
            _ => {}
        }
        Ok(span)
    }

    fn leave(&mut self) -> Result<()> {
        let token = self.peek()?;
        if !matches!(token, Token::End) {
            return Err(self.unexpected_token("the end of this block").into());
        }
        let at_end = self.frames.last().is_some_and(|f| f.at >= f.elements.len());
        if !at_end {
            // A `}` whose opener stands in another directive's body.
            self.advance();
            self.blocks.pop();
            return Ok(());
        }
        let is_block = self.frames.last().is_some_and(|f| self.is_block(f.span));
        if self.frames.len() <= 1 {
            let (block, opened) = self.blocks.last().copied().unwrap_or(("block", Span::NONE));
            let message = format!("this `{block} {{` has no end");
            let help = "its `}` must come in the same file, or from the macro that opens it";
            return Diagnostic::new(codes::UNCLOSED_BLOCK, opened, message).help(help).into();
        }
        self.pop_frame();
        if is_block {
            self.blocks.pop();
        }
        Ok(())
    }

    fn value(&mut self) -> Result<(Value, Span)> {
        self.value_here()
    }

    fn take_thing(&mut self) -> Result<(Arc<dyn Thing>, Span)> {
        if let Token::Expr(Expr { kind: ExprKind::Name(symbol), span }) = self.peek()? {
            self.advance();
            if let Value::Thing(thing) = self.name_value(*symbol, *span)? {
                return Ok((thing, *span));
            }
        }
        if let Token::Function(_) | Token::Expr(Expr { kind: ExprKind::Function(_), .. }) = self.peek()? {
            let span = self.here();
            if let Slot::Value(Value::Thing(thing)) = self.rvalue()? {
                return Ok((thing, span));
            }
        }
        if let Token::Element(e) = self.peek()? {
            let slot = self.take_element()?;
            if let Value::Thing(thing) = self.slot_value(slot, e.span)? {
                return Ok((thing, e.span));
            }
        }
        Err(self.unexpected_token("a declared thing").into())
    }

    fn solid(&mut self) -> Result<Arc<dyn Solid>> {
        let defaults = self.defaults.clone();
        let object = Object::read(self, &defaults)?;
        Ok(Arc::new(Probe::new(&object)?))
    }

    fn pigment(&mut self) -> Result<Arc<dyn Thing>> {
        self.pigment_function()
    }

    fn float(&mut self) -> Result<f64> {
        self.at_value("a number")?;
        let (value, span) = self.value_here()?;
        let x = as_float(&value, span)?;
        if x.is_finite() { Ok(x) } else { Diagnostic::err(codes::NOT_FINITE, span, format!("this number is {x}")) }
    }

    fn optional_float(&mut self) -> Result<Option<f64>> {
        if Reader::next(self)? == Next::Value { self.float().map(Some) } else { Ok(None) }
    }

    fn vector(&mut self) -> Result<DVec3> {
        self.at_value("a vector")?;
        let (value, span) = self.value_here()?;
        finite(as_vector(&value, span)?, span)
    }

    fn vector2(&mut self) -> Result<DVec2> {
        let v = self.vector()?;
        Ok(DVec2::new(v.x, v.y))
    }

    fn numbers(&mut self, n: usize) -> Result<Vec<f64>> {
        let token = self.peek()?;
        let span = self.here();
        let data = match token {
            Token::Numbers(data) => {
                self.advance();
                data.to_vec()
            }
            Token::Expr(Expr { kind: ExprKind::Literal(data), .. }) => {
                self.advance();
                data.to_vec()
            }
            Token::Expr(Expr { kind: ExprKind::Vector(parts), span }) => {
                self.advance();
                self.numbers_in(parts, *span)?
            }
            _ => {
                let (value, span) = self.value_here()?;
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

    fn color(&mut self) -> Result<Color> {
        self.read_color()
    }

    fn continued(&mut self) -> Result<Next> {
        match self.peek_on()? {
            Token::End => Ok(Next::End),
            _ => Reader::next(self),
        }
    }

    fn float_or_color(&mut self) -> Result<FloatOrColor> {
        self.read_float_or_color()
    }

    fn at_color(&mut self) -> Result<bool> {
        Ok(match self.peek()? {
            Token::Word(word) => begins_color(word),
            Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) => {
                matches!(self.next_of_name(*symbol), Next::Value)
                    && !matches!(self.scopes.get(*symbol), Some(Slot::Value(Value::Text(_))))
            }
            Token::Element(_) => {
                let slot = self.element.as_ref().and_then(|place| self.scopes.at(place));
                matches!(slot, Some(Slot::Value(Value::Float(_) | Value::Vector(_) | Value::Color(_))))
            }
            Token::Expr(_) | Token::Numbers(_) => true,
            _ => false,
        })
    }

    fn transform(&mut self) -> Result<Option<Box<Transform>>> {
        self.read_transform()
    }

    fn text(&mut self) -> Result<String> {
        let (value, span) = self.value_here()?;
        match value {
            Value::Text(text) => Ok(text.to_string()),
            other => Diagnostic::err(codes::WRONG_TYPE, span, format!("expected a string, found {}", other.describe())),
        }
    }

    fn flag(&mut self) -> Result<bool> {
        Ok(self.optional_float()?.is_none_or(|x| x.abs() > SMALL))
    }

    fn language(&self) -> Language {
        let version = self.version_stated.then_some(self.language.version);
        let srgb_files = version.is_some_and(compat::has_srgb_files);
        Language { other_gamma: compat::gamma_without_setting(version), srgb_files, ..self.language }
    }

    fn find_file(&mut self, name: &str, at: Span) -> Result<Option<PathBuf>> {
        self.find_read_file(name, at)
    }

    fn picture(&mut self) -> Result<Arc<Picture>> {
        let (at, name) = (self.span(), self.text()?);
        // A name without ending means png, as POV-Ray's own output does.
        let full = if name.contains('.') { name.clone() } else { format!("{name}.png") };
        let Some(path) = self.find_read_file(&full, at)? else {
            let d = Diagnostic::new(codes::MISSING_INCLUDE, at, format!("the picture `{name}` was not found"));
            return d.help("pictures are looked for where included files are; -I DIR adds a folder").into();
        };
        if let Some(picture) = self.pictures.get(&path) {
            return Ok(picture.clone());
        }
        let picture = Arc::new(Picture::read(&path).map_err(|fault| fault.at(at))?);
        self.pictures.insert(path, picture.clone());
        Ok(picture)
    }

    fn sized_function(&mut self) -> Result<Option<([usize; 2], Arc<dyn Thing>)>> {
        let function: &ast::Function = match self.peek()? {
            Token::Function(function) => function,
            Token::Expr(Expr { kind: ExprKind::Function(function), .. }) => function,
            _ => return Ok(None),
        };
        let [width, height] = &*function.size else { return Ok(None) };
        let size = [self.picture_side(width)?, self.picture_side(height)?];
        let span = self.here();
        self.check_picture(size, width.span.to(height.span))?;
        self.advance();
        Ok(Some((size, self.read_function(function, span)?)))
    }

    fn similar_font(&mut self, name: &str) -> Option<PathBuf> {
        fonts::similar(name, &self.options.search.fonts, |path| self.options.sandbox.may_read(path))
    }

    fn pass(&mut self, row: &mut Vec<Said>) -> Result<()> {
        self.pass_over(row)
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        let diagnostic = self.with_trace(diagnostic);
        self.report_fault(diagnostic);
    }

    fn unexpected(&mut self, expected: &str) -> Diagnostic {
        self.unexpected_token(expected)
    }

    fn unknown_word(&mut self, block: &str, takes: &[&'static str]) -> Diagnostic {
        self.tell_unknown_word(block, takes)
    }

    fn keep_undrawn(&mut self, what: &'static str) -> Result<Said> {
        self.keep_with_warning(what)
    }
}

impl<'a> Interpreter<'a> {
    /// How many points a picture that a function makes has along a side.
    fn picture_side(&mut self, side: &'a Expr) -> Result<usize> {
        let n = self.number(side)?;
        if (1.0..=16384.0).contains(&n) {
            return Ok(n as usize);
        }
        Diagnostic::err(codes::BAD_ARGUMENT, side.span, format!("a picture has 1 to 16384 points a side, found {n}"))
    }
}

impl Interpreter<'_> {
    /// Was this frame's span pushed for a block with a word in front?
    fn is_block(&self, span: Span) -> bool {
        !self.sources.snippet(span).starts_with(['{', '['])
    }
}
