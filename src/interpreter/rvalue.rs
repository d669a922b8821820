//! What may stand behind `#declare X =` and as a macro's argument: anything that can have a name.

use super::Interpreter;
use super::pieces::is_callable;
use super::reader::TransformThing;
use super::scope::Slot;
use super::stream::{BlockName, Token};
use crate::atmosphere::{Fog, Rainbow, SkySphere};
use crate::diagnostic::Result;
use crate::scene::{Object, is_object, read_camera, read_layers, read_material};
use crate::source::Span;
use crate::syntax::ast::{Bracket, Expr, ExprKind, Sign};
use crate::syntax::word;
use crate::texture::{ColorMap, Finish, Interior, Normal, NormalMap, Pigment, PigmentMap, SlopeMap, TextureMap};
use crate::value::{Next, Reader, Thing, Value, given};
use std::sync::Arc;

/// Blocks that may be declared, and whose kind is not read yet.
pub const LATER: &[&str] =
    &["media", "density", "density_map", "warp", "radiosity", "photons", "pattern", "array", "texture_list"];

impl<'a> Interpreter<'a> {
    /// The next complete value. No directive and no macro behind it runs.
    pub(super) fn rvalue(&mut self) -> Result<Slot<'a>> {
        let closed = std::mem::replace(&mut self.closed, true);
        let slot = self.rvalue_closed();
        self.closed = closed;
        slot
    }

    fn rvalue_closed(&mut self) -> Result<Slot<'a>> {
        match self.peek()? {
            Token::Expr(Expr { kind: ExprKind::Name(symbol), span, .. }) => {
                if let Some(slot @ (Slot::Faulty(_) | Slot::Array(_))) = self.scopes.get(*symbol) {
                    let slot = slot.clone();
                    self.advance();
                    return Ok(slot);
                }
                let value = self.name_value(*symbol, *span)?;
                let whole = self.is_whole(false);
                self.advance();
                match is_callable(&value) {
                    true => self.call_or_value(value, *span),
                    false if whole => Ok(Slot::Value(value)),
                    false => self.rest_of_value(value, *span),
                }
            }
            Token::Function(_) => Ok(Slot::Value(Value::Thing(self.read_function()?))),
            Token::Expr(_) | Token::Numbers(_) | Token::Callee(_) | Token::Open(Bracket::Paren, _) => {
                self.plain_value()
            }
            Token::Sign(Sign::Not | Sign::Operator(_)) => self.plain_value(),
            Token::Element(span) => {
                let slot = self.take_element()?;
                match slot {
                    Slot::Value(value) => self.rest_of_value(value, span),
                    slot => Ok(slot),
                }
            }
            Token::Word("array") => self.array(),
            Token::Block(BlockName { word: Some("array"), .. }) => self.array_of_braces(self.here()),
            Token::Block(BlockName { word: None, span, .. }) if self.sources.snippet(span) == "dictionary" => {
                self.dictionary()
            }
            Token::Word(_) if self.at_color()? => self.plain_value(),
            _ => match Reader::next(self)? {
                Next::Block(word) => self.thing_block(word).map(|thing| Slot::Value(Value::Thing(thing))),
                _ => Err(self.unexpected_token("a value").into()),
            },
        }
    }

    fn plain_value(&mut self) -> Result<Slot<'a>> {
        self.value_here().map(|(value, _)| Slot::Value(value))
    }

    /// A function's name alone, or its call.
    fn call_or_value(&mut self, value: Value, span: Span) -> Result<Slot<'a>> {
        if self.call_follows()? { self.rest_of_value(value, span) } else { Ok(Slot::Value(value)) }
    }

    /// What was read may be the first operand of more, or be called.
    fn rest_of_value(&mut self, value: Value, span: Span) -> Result<Slot<'a>> {
        if matches!(&value, Value::Thing(_)) && !is_callable(&value) {
            return Ok(Slot::Value(value));
        }
        self.value_from(value, span).map(|(value, _)| Slot::Value(value))
    }

    /// A block that has a kind of value.
    fn thing_block(&mut self, word: &'static str) -> Result<Arc<dyn Thing>> {
        let defaults = self.defaults.clone();
        if word == "spline" {
            return Ok(self.spline()?);
        }
        if word == "texture" {
            return Ok(Arc::new(read_layers(self, &defaults)?));
        }
        if is_object(word) {
            return Ok(Arc::<Object>::from(Object::read(self, &defaults)?));
        }
        if LATER.contains(&word) {
            return Ok(Arc::new(self.keep_undrawn(word)?));
        }
        let base = &defaults.texture.layers[0];
        match word {
            "pigment" => self.inside(|r, _| Pigment::read(r, &base.pigment, &defaults.texture)),
            "normal" => self.inside(|r, _| Normal::read(r, base.normal.as_deref(), &defaults.texture)),
            "finish" => self.inside(|r, _| Finish::read(r, &base.finish)),
            "color_map" | "colour_map" => self.inside(|r, _| ColorMap::read(r)),
            "pigment_map" => self.inside(|r, _| PigmentMap::read_entries(r, &defaults.texture, false)),
            "normal_map" => self.inside(|r, _| NormalMap::read_entries(r, &defaults.texture, false)),
            "slope_map" => self.inside(|r, _| SlopeMap::read_entries(r, &defaults.texture, false)),
            "texture_map" => self.inside(|r, _| TextureMap::read_entries(r, &defaults.texture, false)),
            "interior" => self.inside(|r, _| Interior::read(r, None)),
            "material" => self.inside(|r, _| read_material(r, &defaults, None)),
            "fog" => self.inside(|r, _| Fog::read(r)),
            "rainbow" => self.inside(|r, at| Rainbow::read(r, at)),
            "sky_sphere" => self.inside(|r, at| SkySphere::read(r, &defaults.texture, at)),
            "camera" => self.inside(|r, at| read_camera(r, at, &defaults)),
            "transform" => self.inside(|r, _| Ok(TransformThing(r.transform_block()?))),
            _ => Err(self.unexpected_token("something that can be declared").into()),
        }
    }

    /// Opens the block that comes next, at the place that `read` is told, and closes it.
    fn inside<T: Thing>(&mut self, read: impl FnOnce(&mut Self, Span) -> Result<T>) -> Result<Arc<dyn Thing>> {
        let at = self.take()?;
        let thing = read(self, at)?;
        self.leave()?;
        Ok(Arc::new(thing))
    }

    /// `#default { … }` and `default { … }`, between the braces.
    pub(super) fn read_defaults(&mut self) -> Result<()> {
        loop {
            let next = Reader::next(self)?;
            match next {
                Next::End => return Ok(()),
                Next::Block("texture") | Next::Thing("texture") => {
                    let defaults = self.defaults.clone();
                    self.defaults.texture = Arc::new(read_layers(self, &defaults)?);
                }
                Next::Block("camera") => {
                    let at = self.take()?;
                    let defaults = self.defaults.clone();
                    self.scene.camera = read_camera(self, at, &defaults)?;
                    self.leave()?;
                }
                _ => {
                    let base = self.defaults.texture.clone();
                    let mut texture = (*base).clone();
                    if !texture.read_part(self, next, &base)? {
                        let words = ["texture", "pigment", "normal", "finish", "camera"];
                        return Err(self.unknown_word("default", &words).into());
                    }
                    self.defaults.texture = Arc::new(texture);
                }
            }
        }
    }

    /// Looks up the constants that stay as they are once for all.
    pub(super) fn keep_constants(&mut self) {
        let changing = ["version", "now", "input_file_name"];
        for (name, _) in word::CONSTANTS.iter().filter(|(name, _)| !changing.contains(name)) {
            let i = self.names.intern(name).0 as usize;
            if i >= self.constants.len() {
                self.constants.resize(i + 1, None);
            }
            self.constants[i] = self.constant_value(name);
        }
    }

    /// Names that the program sets.
    pub(super) fn constant_value(&self, name: &str) -> Option<Value> {
        use crate::math::DVec3;
        use crate::value::VecN;
        let flag = |b: bool| Some(Value::Float(f64::from(b)));
        let float = |x: f64| Some(Value::Float(x));
        match name {
            "x" => Some(Value::Vector(DVec3::X.into())),
            "y" => Some(Value::Vector(DVec3::Y.into())),
            "z" => Some(Value::Vector(DVec3::Z.into())),
            "u" => Some(Value::Vector(VecN::from_slice(&[1.0, 0.0]))),
            "v" => Some(Value::Vector(VecN::from_slice(&[0.0, 1.0]))),
            "t" => Some(Value::Vector(VecN::from_slice(&[0.0, 0.0, 0.0, 1.0]))),
            "pi" => float(std::f64::consts::PI),
            "true" | "on" | "yes" => flag(true),
            "false" | "off" | "no" => flag(false),
            "image_width" => float(self.options.size.0 as f64),
            "image_height" => float(self.options.size.1 as f64),
            "version" => float(f64::from(self.language.version) / 100.0),
            "now" => float(self.options.host.since_1970().as_secs_f64() / 86_400.0 - DAYS_TO_2000),
            "input_file_name" => Some(Value::Text(self.options.input_name.as_str().into())),
            _ => self.options.timing.constant(name).map(Value::Float),
        }
    }

    /// `--declare NAME=VALUE`: a number, vector or colour, or else text.
    pub(super) fn declare_options(&mut self) {
        for (name, value) in &self.options.declares {
            let value = given(value).unwrap_or_else(|_| Value::Text(value.trim_matches('"').into()));
            let symbol = self.names.intern(name);
            self.scopes.set_global(symbol, Slot::Value(value), vec![]);
        }
    }
}

/// Days from the beginning of the year 1970 to that of 2000, where `now` starts (manual, "now").
const DAYS_TO_2000: f64 = 10_957.0;
