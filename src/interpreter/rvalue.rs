//! What may stand behind `#declare X =` and as a macro's argument: anything that can have a name.

use super::Interpreter;
use super::evaluator::Slot;
use super::evaluator::is_callable;
use super::reader::TransformThing;
use super::stream::{BlockName, Token};
use crate::atmosphere::{Fog, Rainbow, SkySphere};
use crate::diagnostic::Result;
use crate::medium::Interior;
use crate::scene::{Object, is_object, read_camera, read_layers, read_material};
use crate::source::Span;
use crate::syntax::ast::{Bracket, Expr, ExprKind, Sign};
use crate::texture::{ColorMap, Finish, Normal, NormalMap, Pigment, PigmentMap, SlopeMap, TextureMap};
use crate::value::{Next, Reader, Thing, Value};
use std::sync::Arc;

/// Blocks that may be declared, and whose kind is not read yet.
pub const LATER: &[&str] =
    &["media", "density", "density_map", "warp", "radiosity", "photons", "pattern", "array", "texture_list"];

impl<'a> Interpreter<'a> {
    /// The next complete value. No directive and no macro behind it runs.
    pub(super) fn rvalue(&mut self) -> Result<Slot<'a>> {
        self.in_mode(|mode| mode.defers = true, Self::deferring_rvalue)
    }

    fn deferring_rvalue(&mut self) -> Result<Slot<'a>> {
        match self.peek()? {
            Token::Expr(Expr { kind: ExprKind::Name(symbol), span, .. }) => {
                if let Some(slot @ (Slot::Faulty(_) | Slot::Array(_))) = self.evaluator.scopes().get(*symbol) {
                    let slot = slot.clone();
                    self.stream.advance();
                    return Ok(slot);
                }
                let value = self.name_value(*symbol, *span)?;
                let whole = self.is_whole(false);
                self.stream.advance();
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
            Token::Block(BlockName { word: Some("array"), .. }) => self.array_of_braces(self.stream.here()),
            Token::Block(BlockName { word: None, span, .. }) if self.inputs.sources.snippet(span) == "dictionary" => {
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
        let defaults = self.builder.defaults().clone();
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
                    let defaults = self.builder.defaults().clone();
                    let texture = read_layers(self, &defaults)?;
                    self.builder.set_default_texture(Arc::new(texture));
                }
                Next::Block("camera") => {
                    let at = self.take()?;
                    let defaults = self.builder.defaults().clone();
                    let camera = read_camera(self, at, &defaults)?;
                    self.builder.set_default_camera(camera);
                    self.leave()?;
                }
                _ => {
                    let base = self.builder.defaults().texture.clone();
                    let mut texture = (*base).clone();
                    if !texture.read_part(self, next, &base)? {
                        let words = ["texture", "pigment", "normal", "finish", "camera"];
                        return Err(self.unknown_word("default", &words).into());
                    }
                    self.builder.set_default_texture(Arc::new(texture));
                }
            }
        }
    }
}
