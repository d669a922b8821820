//! Reads colours.

use super::super::Interpreter;
use super::super::stream::Token;
use crate::color::{Color, Gamma, Rgb, transfer};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::fp;
use crate::source::Span;
use crate::value::words::word;
use crate::value::{FloatOrColor, Reader, Value, ValueKind, VecN, WordSpec};

/// Keywords that begin a colour, such as `rgb`.
pub const COLOR_WORDS: &[WordSpec] = &[
    word(
        "color",
        ValueKind::Nothing,
        "",
        "may stand before any colour; alone before a vector: red, green, blue, filter, transmit",
    ),
    word("colour", ValueKind::Nothing, "", "the same"),
    word("rgb", ValueKind::Vector, "", "red, green and blue, as the scene computes with them"),
    word("rgbf", ValueKind::Vector, "", "and how much light it lets through in its own colour"),
    word("rgbt", ValueKind::Vector, "", "and how much light it lets through unchanged"),
    word("rgbft", ValueKind::Vector, "", "and both"),
    word("srgb", ValueKind::Vector, "", "red, green and blue as painting programs count them"),
    word("srgbf", ValueKind::Vector, "", "with filter"),
    word("srgbt", ValueKind::Vector, "", "with transmit"),
    word("srgbft", ValueKind::Vector, "", "with both"),
    word("red", ValueKind::Float, "0", "this component alone; several may follow one another"),
    word("green", ValueKind::Float, "0", "this component alone"),
    word("blue", ValueKind::Float, "0", "this component alone"),
    word("filter", ValueKind::Float, "0", "how much light it lets through in its own colour; also behind a colour"),
    word("transmit", ValueKind::Float, "0", "how much light it lets through unchanged; also behind a colour"),
    word("alpha", ValueKind::Float, "0", "an old spelling of `filter`"),
];

/// Accessor of one component of a colour.
type Component = fn(&mut Color) -> &mut f64;

/// Words for one component of a colour, with their accessors; [`COLOR_WORDS`] describes the words.
const COMPONENTS: &[(&str, Component)] = &[
    ("red", |color| &mut color.rgb.x),
    ("green", |color| &mut color.rgb.y),
    ("blue", |color| &mut color.rgb.z),
    ("filter", |color| &mut color.filter),
    ("transmit", |color| &mut color.transmit),
    ("alpha", |color| &mut color.filter),
];

/// True if the word begins a colour.
pub fn begins_color(word: &str) -> bool {
    COLOR_WORDS.iter().any(|w| w.name == word)
}

/// True if the word sets one component of a colour.
pub(super) fn is_color_component(word: &str) -> bool {
    COMPONENTS.iter().any(|(name, _)| *name == word)
}

/// Replaces positive infinity by [`Color::BLINDING`], and negative infinity and NaN by 0 (quirk: `infinite_colors`).
fn finite_component(x: f64) -> f64 {
    match x {
        x if x.is_finite() => x,
        f64::INFINITY => Color::BLINDING,
        _ => 0.0,
    }
}

impl Interpreter<'_> {
    /// Reads the value after `rgb`, `rgbt` and the like. A number fills as many components as the word has letters. The
    /// fourth component of `rgbt` is `transmit`.
    fn read_color_value(&mut self, word: &str) -> Result<Color> {
        // POV-Ray allows comparisons without parentheses in colours: `color (A > 1) ? Red : Blue`.
        let (value, span) = self.read_expression(true)?;
        self.as_color(value, word, span)
    }

    /// Reads components such as `filter 0.5` after a colour.
    fn read_color_components(&mut self, color: &mut Color) -> Result<()> {
        while let Token::Word(word) = self.peek_continuation()?
            && is_color_component(word)
        {
            self.stream.advance();
            let x = self.float()?;
            set_component(color, word, x);
        }
        Ok(())
    }

    fn as_color(&mut self, value: Value, word: &str, span: Span) -> Result<Color> {
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
            // The fourth number is the transmit; a fifth is ignored.
            (c[4], c[3]) = (c[3], 0.0);
        }
        if !c.iter().all(|x| x.is_finite()) {
            let d = Diagnostic::new(codes::INFINITE, span, "this colour holds a number that is not finite");
            self.report(d.help("look for a division by zero, or a number that grows in a loop"));
            c = c.map(finite_component);
        }
        let mut color = Color::from_array(c);
        if word.starts_with('s') {
            color.rgb = self.srgb_to_working_space(color.rgb);
        }
        Ok(color)
    }

    /// Converts an sRGB colour to the scene's working space.
    fn srgb_to_working_space(&self, c: Rgb) -> Rgb {
        let linear = transfer::srgb_decode_rgb(c);
        match self.builder.language().assumed_gamma {
            Some(Gamma::Srgb) => c,
            Some(Gamma::Power(g)) if g != 1.0 => {
                let power = |x: f64| fp::pow(x.max(0.0), 1.0 / g);
                Rgb::new(power(linear.x), power(linear.y), power(linear.z))
            }
            _ => linear,
        }
    }

    /// Reads a colour, such as `color rgb <…>`, `rgb <…>`, `<…>`, `color red 1 green 0.5` or `color Red filter 0.5`.
    pub(super) fn read_color(&mut self) -> Result<Color> {
        let mut word = match self.peek()? {
            Token::Word(word) if begins_color(word) => {
                self.stream.advance();
                word
            }
            _ => "color",
        };
        if matches!(word, "color" | "colour")
            && let Token::Word(next) = self.peek()?
            && begins_color(next)
        {
            self.stream.advance();
            word = next;
        }
        let mut color = Color::BLACK;
        match word {
            word if is_color_component(word) => {
                let x = self.float()?;
                set_component(&mut color, word, x);
            }
            word => color = self.read_color_value(word)?,
        }
        self.read_color_components(&mut color)?;
        Ok(color)
    }

    /// Reads a number or a colour.
    pub(super) fn read_float_or_color(&mut self) -> Result<FloatOrColor> {
        if matches!(self.peek()?, Token::Word(_)) {
            return self.color().map(FloatOrColor::Color);
        }
        let (value, span) = self.read_value()?;
        if let Value::Float(x) = value {
            return Ok(FloatOrColor::Float(x));
        }
        let mut color = self.as_color(value, "color", span)?;
        self.read_color_components(&mut color)?;
        Ok(FloatOrColor::Color(color))
    }
}

fn set_component(color: &mut Color, word: &str, x: f64) {
    if let Some((_, field)) = COMPONENTS.iter().find(|(name, _)| *name == word) {
        *field(color) = x;
    }
}
