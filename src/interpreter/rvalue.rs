//! Reads the value of `#declare X = …` or of a macro's argument: any value that can have a name.

use super::Interpreter;
use super::array::empty_dictionary;
use super::evaluator::Contents;
use super::evaluator::is_callable;
use super::reader::TransformThing;
use super::reporter::hints;
use super::stream::{BlockName, Token};
use crate::atmosphere::{Fog, Rainbow, SkySphere};
use crate::diagnostic::Result;
use crate::medium::{Interior, Media};
use crate::scene::{Object, ObjectRadiosity, is_object, read_camera, read_layers, read_material};
use crate::source::Span;
use crate::syntax::ast::{Bracket, Expr, ExprKind, Punctuation};
use crate::texture::{
    ColorMap, Density, DensityMap, Finish, Normal, NormalMap, Pigment, PigmentMap, SlopeMap, TextureMap,
};
use crate::value::{Next, Reader, Thing, Value};
use std::sync::Arc;

impl<'a> Interpreter<'a> {
    /// Reads a complete value. Directives and macros after the value do not run yet.
    pub(super) fn read_rvalue(&mut self) -> Result<Contents<'a>> {
        self.in_mode(|mode| mode.defers_directives = true, Self::read_deferring_rvalue)
    }

    fn read_deferring_rvalue(&mut self) -> Result<Contents<'a>> {
        match self.peek()? {
            Token::Expr(Expr { kind: ExprKind::Name(symbol), span, .. }) => {
                if let Some(contents @ (Contents::Faulty(_) | Contents::Array(_))) =
                    self.evaluator.scopes().get(*symbol)
                {
                    let contents = contents.clone();
                    self.stream.advance();
                    return Ok(contents);
                }
                // An empty dictionary (3.8).
                if self.inputs.names.text(*symbol) == "dictionary" && !self.evaluator.is_declared(*symbol) {
                    self.stream.advance();
                    return Ok(empty_dictionary());
                }
                let value = self.evaluate_name(*symbol, *span)?;
                let whole = self.next_value_is_complete(false);
                self.stream.advance();
                match is_callable(&value) {
                    true => self.read_call_or_value(value, *span),
                    false if whole => Ok(Contents::Value(value)),
                    false => self.read_rest_of_value(value, *span),
                }
            }
            Token::Function(_) => Ok(Contents::Value(Value::Thing(self.read_function()?))),
            Token::Expr(_) | Token::Numbers(_) | Token::Callee(_) | Token::Open(Bracket::Paren, _) => {
                self.read_expression_as_contents()
            }
            Token::Punctuation(Punctuation::Not | Punctuation::Operator(_)) => self.read_expression_as_contents(),
            Token::Element(span) => {
                let contents = self.take_array_element()?;
                match contents {
                    Contents::Value(value) => self.read_rest_of_value(value, span),
                    contents => Ok(contents),
                }
            }
            Token::Word("array") => self.read_array(),
            Token::Block(BlockName { word: Some("array"), .. }) => self.read_braced_array(self.stream.next_span()),
            Token::Block(BlockName { word: None, span, .. }) if self.inputs.sources.snippet(span) == "dictionary" => {
                self.read_dictionary()
            }
            Token::Word(_) if self.may_be_at_color()? => self.read_expression_as_contents(),
            _ => match Reader::peek_next(self)? {
                Next::Block(word) => self.read_declarable_block(word).map(|thing| Contents::Value(Value::Thing(thing))),
                _ => Err(self.unexpected_token("a value").into()),
            },
        }
    }

    /// Reads an expression of the scene, and returns its value as the contents of a variable.
    fn read_expression_as_contents(&mut self) -> Result<Contents<'a>> {
        self.read_value().map(|(value, _)| Contents::Value(value))
    }

    /// Returns the function or spline `value` itself, or reads its call if a `(` follows its name.
    fn read_call_or_value(&mut self, value: Value, span: Span) -> Result<Contents<'a>> {
        if self.call_follows()? { self.read_rest_of_value(value, span) } else { Ok(Contents::Value(value)) }
    }

    /// Reads the rest of a value whose first operand was read.
    fn read_rest_of_value(&mut self, value: Value, span: Span) -> Result<Contents<'a>> {
        if matches!(&value, Value::Thing(_)) && !is_callable(&value) {
            return Ok(Contents::Value(value));
        }
        self.continue_value(value, span).map(|(value, _)| Contents::Value(value))
    }

    /// Reads a block that can be declared, such as `texture { … }`.
    fn read_declarable_block(&mut self, word: &'static str) -> Result<Arc<dyn Thing>> {
        let defaults = self.builder.defaults().clone();
        if word == "spline" {
            return Ok(self.read_spline()?);
        }
        if word == "texture" {
            return Ok(Arc::new(read_layers(self, &defaults)?));
        }
        if is_object(word) {
            return Ok(Arc::<Object>::from(Object::read(self, &defaults)?));
        }
        let base = &defaults.texture.layers[0];
        match word {
            "pigment" => self.read_block_with(|r, _| Pigment::read(r, &base.pigment, &defaults.texture)),
            "normal" => self.read_block_with(|r, _| Normal::read(r, base.normal.as_deref(), &defaults.texture)),
            "finish" => self.read_block_with(|r, _| Finish::read(r, &base.finish)),
            "color_map" | "colour_map" => self.read_block_with(|r, _| ColorMap::read(r)),
            "pigment_map" => self.read_block_with(|r, _| PigmentMap::read_entries(r, &defaults.texture, false)),
            "normal_map" => self.read_block_with(|r, _| NormalMap::read_entries(r, &defaults.texture, false)),
            "slope_map" => self.read_block_with(|r, _| SlopeMap::read_entries(r, &defaults.texture, false)),
            "texture_map" => self.read_block_with(|r, _| TextureMap::read_entries(r, &defaults.texture, false)),
            "media" => self.read_block_with(|r, at| Media::read(r, at)),
            "density" => self.read_block_with(|r, _| Density::read(r)),
            "density_map" => self.read_block_with(|r, _| DensityMap::read_entries(r, &defaults.texture, false)),
            "interior" => self.read_block_with(|r, _| Interior::read(r, None)),
            "material" => self.read_block_with(|r, _| read_material(r, &defaults, None)),
            "fog" => self.read_block_with(|r, _| Fog::read(r)),
            "rainbow" => self.read_block_with(|r, at| Rainbow::read(r, at)),
            "sky_sphere" => self.read_block_with(|r, at| SkySphere::read(r, &defaults.texture, at)),
            "camera" => self.read_block_with(|r, at| read_camera(r, at, &defaults)),
            "transform" => self.read_block_with(|r, _| Ok(TransformThing(r.read_transform_contents()?))),
            _ => {
                let error = self.unexpected_token("something that can be declared");
                Err(error.maybe_help(hints::block_place_hint(word).map(Into::into)).into())
            }
        }
    }

    /// Reads the next block. `read_contents` reads what is between the braces, which are consumed here; it receives the
    /// span of the block's keyword.
    fn read_block_with<T: Thing>(
        &mut self,
        read_contents: impl FnOnce(&mut Self, Span) -> Result<T>,
    ) -> Result<Arc<dyn Thing>> {
        let at = self.take_token()?;
        let thing = read_contents(self, at)?;
        self.leave_block()?;
        Ok(Arc::new(thing))
    }

    /// Reads the contents of `#default { … }` or `default { … }` up to the `}`, and changes the defaults.
    pub(super) fn read_defaults(&mut self) -> Result<()> {
        loop {
            let next = Reader::peek_next(self)?;
            match next {
                Next::End => return Ok(()),
                Next::Block("texture") | Next::Thing("texture") => {
                    let defaults = self.builder.defaults().clone();
                    let texture = read_layers(self, &defaults)?;
                    self.builder.set_default_texture(Arc::new(texture));
                }
                Next::Block("camera") => {
                    let at = self.take_token()?;
                    let defaults = self.builder.defaults().clone();
                    let camera = read_camera(self, at, &defaults)?;
                    self.builder.set_default_camera(camera);
                    self.leave_block()?;
                }
                Next::Block("radiosity") => {
                    let radiosity = ObjectRadiosity::read_with_braces(self)?;
                    self.builder.set_default_radiosity(radiosity);
                }
                _ => {
                    let base = self.builder.defaults().texture.clone();
                    let mut texture = (*base).clone();
                    if !texture.read_part(self, next, &base)? {
                        let words = ["texture", "pigment", "normal", "finish", "camera", "radiosity"];
                        return Err(self.unknown_word("default", &words).into());
                    }
                    self.builder.set_default_texture(Arc::new(texture));
                }
            }
        }
    }
}
