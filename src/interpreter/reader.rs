//! The interpreter as a [`Reader`]: what a family sees of the stream.

use super::eval::{SMALL, as_float};
use super::scope::Slot;
use super::stream::{FrameKind, Token};
use super::{Interpreter, hints};
use crate::color::{Color, Gamma, Rgb, transfer};
use crate::diagnostic::{Diagnostic, Result, codes, did_you_mean};
use crate::math::{DVec2, DVec3, Transform, fp};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::{FloatOrColor, Language, Next, Reader, ReaderExt, Thing, Value, VecN};
use std::sync::Arc;

/// The words that begin a colour.
const COLOR_WORDS: &[&str] = &[
    "color", "colour", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "srgbf", "srgbt", "srgbft", "red", "green", "blue",
    "filter", "transmit", "alpha",
];

/// A declared transform.
#[derive(Debug)]
pub(super) struct TransformThing(pub(super) Transform);

impl Thing for TransformThing {
    fn kind(&self) -> &'static str {
        "transform"
    }
}

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
            Token::Word(word) if COLOR_WORDS.contains(&word) => {
                let color = self.color()?;
                Ok((Value::Color(color), span))
            }
            _ => Err(self.unexpected_token("a value").into()),
        }
    }

    /// "expected …, found …" about what comes next.
    pub(super) fn unexpected_token(&mut self, expected: &str) -> Diagnostic {
        let span = self.here();
        let found = match self.peek() {
            Err(fault) => return *fault,
            Ok(Token::Word(word)) => format!("`{word}`"),
            Ok(Token::Block(Block { name, .. }) | Token::Open(name)) => {
                format!("`{} {{`", self.sources.snippet(name.span))
            }
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), span })) => {
                let slot = self.scopes.get(*symbol);
                if matches!(slot, Some(Slot::Faulty(_))) || slot.is_none() && !self.is_constant(*symbol) {
                    let Err(fault) = self.name_value(*symbol, *span) else {
                        return self.expected(*span, expected, "a name");
                    };
                    return *fault;
                }
                format!("`{}`", self.names.text(*symbol))
            }
            Ok(Token::Expr(_) | Token::Numbers(_)) => "a value".to_string(),
            Ok(Token::Entry(_)) => "`[`".to_string(),
            Ok(Token::Group(_)) => "`{`".to_string(),
            Ok(Token::Function) => "a function".to_string(),
            Ok(Token::End) => match self.blocks.last() {
                Some((block, _)) => format!("the end of `{block} {{…}}`"),
                None => "the end".to_string(),
            },
        };
        self.expected(span, expected, &found)
    }

    fn expected(&self, span: Span, expected: &str, found: &str) -> Diagnostic {
        Diagnostic::new(codes::EXPECTED, span, format!("expected {expected}, found {found}"))
    }

    /// Must a value come next? Says which one is missing.
    fn at_value(&mut self, wanted: &str) -> Result<()> {
        match self.peek()? {
            Token::End | Token::Block(_) | Token::Entry(_) | Token::Group(_) => {
                Err(self.unexpected_token(wanted).into())
            }
            _ => Ok(()),
        }
    }

    /// What a name in word position is: a thing, a value, or nothing.
    fn next_of_name(&mut self, symbol: Symbol) -> Next {
        match self.scopes.get(symbol) {
            Some(Slot::Value(Value::Thing(thing))) => Next::Thing(thing.kind()),
            _ => Next::Value,
        }
    }

    fn as_vector(&self, value: &Value, span: Span) -> Result<DVec3> {
        let vector = match value {
            Value::Float(x) => DVec3::splat(*x),
            Value::Vector(v) if v.len <= 3 => v.xyz(),
            other => {
                let message = format!("expected a vector of three numbers, found {}", other.describe());
                return Diagnostic::err(codes::WRONG_TYPE, span, message);
            }
        };
        finite(vector, span)
    }

    /// The colour that an expression gives after one of the words `rgb`, `rgbt` …: a number stands for as many components
    /// as the word has letters, and the two last of `rgbt` are swapped into place.
    fn color_after(&mut self, word: &str) -> Result<Color> {
        let (value, span) = self.value_here()?;
        self.as_color(value, word, span)
    }

    /// `filter 0.5` and its kin after a colour.
    fn color_components(&mut self, color: &mut Color) -> Result<()> {
        while let Token::Word(word @ ("red" | "green" | "blue" | "filter" | "transmit" | "alpha")) = self.peek_on()? {
            self.advance();
            let x = self.float()?;
            set_component(color, word, x);
        }
        Ok(())
    }

    fn as_color(&self, value: Value, word: &str, span: Span) -> Result<Color> {
        let letters = word.trim_start_matches('s').len();
        let mut c = match value {
            Value::Float(x) => VecN::splat(x, if word.starts_with("col") { 5 } else { letters as u8 }).c,
            Value::Vector(v) => v.c,
            Value::Color(color) => color.to_array(),
            other => {
                let message = format!("expected a colour, found {}", other.describe());
                return Diagnostic::err(codes::WRONG_TYPE, span, message);
            }
        };
        if matches!(word, "rgbt" | "srgbt") {
            // The fourth number is the transmit; a fifth has no meaning.
            (c[4], c[3]) = (c[3], 0.0);
        }
        if !c.iter().all(|x| x.is_finite()) {
            return Diagnostic::err(codes::NOT_FINITE, span, "this colour holds a number that is not finite");
        }
        let mut color = Color::from_array(c);
        if word.starts_with('s') {
            color.rgb = self.linear_of_srgb(color.rgb);
        }
        Ok(color)
    }

    /// An sRGB colour in the numbers that the scene computes with.
    fn linear_of_srgb(&self, c: Rgb) -> Rgb {
        let linear = transfer::srgb_decode_rgb(c);
        match self.language.assumed_gamma {
            Some(Gamma::Srgb) => c,
            Some(Gamma::Power(g)) if g != 1.0 => {
                let power = |x: f64| fp::pow(x.max(0.0), 1.0 / g);
                Rgb::new(power(linear.x), power(linear.y), power(linear.z))
            }
            _ => linear,
        }
    }

    /// One `translate`, `rotate` … after its word was consumed.
    fn transform_step(&mut self, word: &str) -> Result<Transform> {
        let span = {
            self.peek()?;
            self.here()
        };
        let singular = |_| {
            let d = Diagnostic::new(codes::SINGULAR, span, format!("this `{word}` flattens space"));
            Box::new(d.help("a factor of 0 has no inverse; use a small number instead"))
        };
        Ok(match word {
            "translate" => Transform::translate(self.vector()?),
            "rotate" => Transform::rotate(self.vector()?),
            "scale" => {
                let factors = self.vector()?;
                // POV-Ray takes a factor of 0 for 1, with a warning.
                let mended = DVec3::select(factors.cmpeq(DVec3::ZERO), DVec3::ONE, factors);
                if mended != factors {
                    let message = "a factor of 0 would flatten the object; 1 is used instead";
                    self.report_fault(Diagnostic::new(codes::ZERO_SCALE, span, message));
                }
                Transform::scale(mended).map_err(singular)?
            }
            _ => {
                let m = self.numbers(12)?;
                let row = |i: usize| DVec3::new(m[3 * i], m[3 * i + 1], m[3 * i + 2]);
                Transform::from_rows([row(0), row(1), row(2), row(3)]).map_err(singular)?
            }
        })
    }

    /// What stands between the braces of a `transform`.
    pub(super) fn transform_block(&mut self) -> Result<Transform> {
        let mut all = Transform::IDENTITY;
        loop {
            match Reader::next(self)? {
                Next::End => return Ok(all),
                Next::Word("inverse") => {
                    self.advance();
                    all = all.inverse();
                }
                _ => match self.transform()? {
                    Some(step) => all = all.then(&step),
                    None => {
                        let words = ["translate", "rotate", "scale", "matrix", "transform", "inverse"];
                        return Err(self.unknown_word("transform", &words).into());
                    }
                },
            }
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
            Token::Expr(_) | Token::Numbers(_) | Token::Function => Next::Value,
            Token::Entry(_) => Next::Entry,
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
        Err(self.unexpected_token("a declared thing").into())
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
        self.as_vector(&value, span)
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
        // `color` alone, `color rgb <…>`, `rgb <…>`, `<…>`, `color red 1 green 0.5`, `color Red filter 0.5`
        let mut word = match self.peek()? {
            Token::Word(word) if COLOR_WORDS.contains(&word) => {
                self.advance();
                word
            }
            _ => "color",
        };
        if matches!(word, "color" | "colour")
            && let Token::Word(next) = self.peek()?
            && COLOR_WORDS.contains(&next)
        {
            self.advance();
            word = next;
        }
        let mut color = Color::BLACK;
        match word {
            "red" | "green" | "blue" | "filter" | "transmit" | "alpha" => {
                let x = self.float()?;
                set_component(&mut color, word, x);
            }
            word => color = self.color_after(word)?,
        }
        self.color_components(&mut color)?;
        Ok(color)
    }

    fn continued(&mut self) -> Result<Next> {
        match self.peek_on()? {
            Token::End => Ok(Next::End),
            _ => Reader::next(self),
        }
    }

    fn float_or_color(&mut self) -> Result<FloatOrColor> {
        if matches!(self.peek()?, Token::Word(_)) {
            return self.color().map(FloatOrColor::Color);
        }
        let (value, span) = self.value_here()?;
        if let Value::Float(x) = value {
            return Ok(FloatOrColor::Float(x));
        }
        let mut color = self.as_color(value, "color", span)?;
        self.color_components(&mut color)?;
        Ok(FloatOrColor::Color(color))
    }

    fn at_color(&mut self) -> Result<bool> {
        Ok(match self.peek()? {
            Token::Word(word) => COLOR_WORDS.contains(&word),
            Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) => {
                matches!(self.next_of_name(*symbol), Next::Value)
                    && !matches!(self.scopes.get(*symbol), Some(Slot::Value(Value::Text(_))))
            }
            Token::Expr(_) | Token::Numbers(_) => true,
            _ => false,
        })
    }

    fn transform(&mut self) -> Result<Option<Transform>> {
        match Reader::next(self)? {
            Next::Word(word @ ("translate" | "rotate" | "scale" | "matrix")) => {
                self.advance();
                self.transform_step(word).map(Some)
            }
            Next::Word("transform") => {
                // `transform T`, as in old scenes
                self.advance();
                let declared = ReaderExt::thing::<TransformThing>(self)?;
                declared.map(|t| Some(t.0)).ok_or_else(|| Box::new(self.unexpected_token("a transform")))
            }
            Next::Block("transform") => {
                self.take()?;
                let all = self.transform_block()?;
                self.leave()?;
                Ok(Some(all))
            }
            Next::Thing("transform") => Ok(ReaderExt::thing::<TransformThing>(self)?.map(|t| t.0)),
            _ => Ok(None),
        }
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
        self.language
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        let diagnostic = self.with_trace(diagnostic);
        self.report_fault(diagnostic);
    }

    fn unexpected(&mut self, expected: &str) -> Diagnostic {
        self.unexpected_token(expected)
    }

    fn unknown_word(&mut self, block: &str, takes: &[&'static str]) -> Diagnostic {
        let span = self.here();
        let word = match self.peek() {
            Err(fault) => return *fault,
            Ok(Token::Word(word)) => word.to_string(),
            Ok(Token::Block(Block { name, .. }) | Token::Open(name)) => self.sources.snippet(name.span).to_string(),
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }))
                if self.scopes.get(*symbol).is_none() && !self.is_constant(*symbol) =>
            {
                let name = self.names.text(*symbol).to_string();
                let d =
                    Diagnostic::new(codes::UNKNOWN_WORD, span, format!("`{name}` is not something a `{block}` takes"));
                let declared = self.scopes.names().map(|s| self.names.text(s));
                let near = did_you_mean(&name, takes.iter().copied().chain(declared));
                let hint = hints::other_tools(&name).map(String::from);
                return d.help(format!("it takes {}", list(takes))).maybe_help(near).maybe_help(hint);
            }
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }))
                if matches!(self.scopes.get(*symbol), Some(Slot::Faulty(_))) =>
            {
                return self.unexpected_token(block);
            }
            Ok(_) => {
                return self
                    .unexpected_token(&format!("a word of `{block}`"))
                    .help(format!("it takes {}", list(takes)));
            }
        };
        let near = did_you_mean(&word, takes.iter().copied());
        Diagnostic::new(codes::UNKNOWN_WORD, span, format!("`{word}` is not something a `{block}` takes"))
            .help(format!("it takes {}", list(takes)))
            .maybe_help(near)
    }

    fn skip_unsupported(&mut self, what: &str) -> Result<()> {
        let token = self.peek()?;
        let (word, span) = match token {
            Token::Block(Block { name, .. }) | Token::Open(name) => (name.word.unwrap_or(what), name.span),
            Token::Word(word) => (word, self.here()),
            _ => (what, self.here()),
        };
        self.report(Diagnostic::new(codes::UNSUPPORTED, span, format!("`{word}` is not drawn yet: it is left out")));
        match token {
            Token::Block(_) => self.advance(),
            Token::Open(_) => {
                self.take()?;
                self.skip_to_end()?;
                self.leave()?;
            }
            _ => {
                self.advance();
                self.skip_arguments()?;
            }
        }
        Ok(())
    }
}

impl Interpreter<'_> {
    /// Was this frame's span pushed for a block with a word in front?
    fn is_block(&self, span: Span) -> bool {
        !self.sources.snippet(span).starts_with(['{', '['])
    }

    /// The values, entries and texts after a word.
    fn skip_arguments(&mut self) -> Result<()> {
        loop {
            match Reader::next(self)? {
                Next::Value => {
                    // What can't be evaluated yet (functions, arrays) is passed over too.
                    if matches!(self.peek()?, Token::Function) {
                        self.advance();
                    } else {
                        drop(self.value_here());
                    }
                }
                Next::Entry | Next::Group => self.advance(),
                Next::Thing("color_map" | "pigment" | "texture" | "normal") => drop(self.take_thing()?),
                _ => return Ok(()),
            }
        }
    }

    fn skip_to_end(&mut self) -> Result<()> {
        let mut open = 0;
        loop {
            match self.peek()? {
                Token::End if open == 0 => return Ok(()),
                Token::End => {
                    open -= 1;
                    self.leave()?;
                }
                Token::Open(_) => {
                    open += 1;
                    self.take()?;
                }
                _ => self.advance(),
            }
        }
    }
}

fn set_component(color: &mut Color, word: &str, x: f64) {
    match word {
        "red" => color.rgb.x = x,
        "green" => color.rgb.y = x,
        "blue" => color.rgb.z = x,
        "transmit" => color.transmit = x,
        // `alpha` is its old name.
        _ => color.filter = x,
    }
}

/// Words in backticks, the first twelve of many.
fn list(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().take(12).map(|w| format!("`{w}`")).collect();
    if words.len() > 12 { format!("{} …", quoted.join(" ")) } else { quoted.join(" ") }
}
