//! Reads objects and their modifiers (manual, "Object Modifiers").

use super::embedded::EmbeddedTextures;
use super::{CsgOp, Object, ObjectBody, ObjectKind, ObjectRadiosity};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::Transform;
use crate::medium::Interior;
use crate::scene::words::{FLAGS, MODIFIERS};
use crate::scene::{Defaults, Material, Painted, Weight, read_layers, read_material};
use crate::shape::{Kernel, Shape};
use crate::source::Span;
use crate::texture::Texture;
use crate::value::words::{is_word_in_rows, read_row};
use crate::value::{Family, Language, Next, Reader, ReaderExt, Value};
use std::sync::Arc;

/// Returns the CSG operation of a block's word; `None` for other blocks.
fn csg_op(word: &str) -> Option<CsgOp> {
    Some(match word {
        // The name of `union` before 1993.
        "union" | "composite" => CsgOp::Union,
        "intersection" => CsgOp::Intersection,
        "difference" => CsgOp::Difference,
        "merge" => CsgOp::Merge,
        _ => return None,
    })
}

/// True if a block of this name is an object.
pub fn is_object(word: &str) -> bool {
    matches!(word, "object" | "light_source" | "light_group") || csg_op(word).is_some() || Shape::is_name(word)
}

impl Object {
    /// Reads an object: a block, whose name is the next token, or a declared object.
    ///
    /// The result is boxed, because objects are large and passed from block to block.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(r: &mut dyn Reader, defaults: &Defaults) -> Result<Box<Self>> {
        match r.peek_next()? {
            Next::Block(word) => {
                let source = r.take_token()?;
                let object = Self::read_block(word, source, r, defaults)?;
                r.leave_block()?;
                Ok(object)
            }
            Next::Thing(_) => match (r.span(), r.take_declared::<Object>()?) {
                (source, Some(object)) => Ok(Box::new(Self { source, ..(*object).clone() })),
                _ => Err(r.unexpected("an object").into()),
            },
            _ => Err(r.unexpected("an object").into()),
        }
    }

    /// Reads the contents of an object's block.
    fn read_block(word: &'static str, source: Span, r: &mut dyn Reader, defaults: &Defaults) -> Result<Box<Self>> {
        if let Some(op) = csg_op(word) {
            return Self::read_csg(op, word, source, r, defaults);
        }
        if word == "light_source" {
            if matches!(r.peek_next()?, Next::Thing(_)) {
                let mut object = Self::read(r, defaults)?;
                object.source = source;
                object.read_modifiers_stays_visible(None, r, defaults)?;
                return Ok(object);
            }
            return Self::read_light(source, r, defaults);
        }
        if word == "light_group" {
            return Self::read_light_group(source, r, defaults);
        }
        // A declared object is allowed in the block of any shape (quirk: `object_in_any_block`).
        if word == "object" || r.peek_next()? == Next::Thing("object") {
            let mut object = Self::read(r, defaults)?;
            object.source = source;
            object.read_modifiers_stays_visible(None, r, defaults)?;
            return Ok(object);
        }
        let Some(shape) = Shape::read_params_of(word, r) else { return Err(r.unexpected("an object").into()) };
        let mut object = Box::new(Self::unfinished(word, source, defaults));
        let mut shape = match shape {
            Err(fault) if fault.code == codes::NOT_FINITE => {
                object.read_rest_of_invisible(*fault, r, defaults)?;
                return Ok(object);
            }
            shape => shape?,
        };
        if object.read_modifiers_stays_visible(Some(&mut shape), r, defaults)? {
            let shape = match defaults.recent.find_shape(&shape) {
                Some(known) => known,
                None => {
                    shape.complete_and_check(source, r)?;
                    defaults.recent.add_shape(&shape);
                    shape
                }
            };
            object.kind = ObjectKind::Shape(shape);
        }
        Ok(object)
    }

    /// Reads the rest of a shape with a number that is not finite. As in POV-Ray, such a shape is invisible
    /// (quirk: `infinite_shapes_vanish`).
    fn read_rest_of_invisible(&mut self, fault: Diagnostic, r: &mut dyn Reader, defaults: &Defaults) -> Result<()> {
        r.report(invisible_warning(self.word, fault));
        loop {
            let next = r.peek_next()?;
            if next == Next::End {
                return Ok(());
            }
            if !self.read_modifier(next, r, defaults)? {
                r.skip_item()?;
            }
        }
    }

    fn read_csg(
        op: CsgOp,
        word: &'static str,
        source: Span,
        r: &mut dyn Reader,
        defaults: &Defaults,
    ) -> Result<Box<Self>> {
        let mut parts = vec![];
        loop {
            match r.peek_next()? {
                Next::Block(part) if is_object(part) => parts.push(*Self::read(r, defaults)?),
                Next::Thing("object" | "light_source") => parts.push(*Self::read(r, defaults)?),
                _ => break,
            }
        }
        let pov_bounds = Self::pov_bounds_of_parts(op, &parts);
        let mut object = Box::new(Self::new(ObjectKind::Csg(op, parts.into()), word, source, defaults));
        object.weight().check_depth(source)?;
        object.bulk.get_or_insert_default().pov_bounds = Some(pov_bounds);
        object.read_modifiers_stays_visible(None, r, defaults)?;
        Ok(object)
    }

    /// Reads modifiers and the shape's own words up to the end of the block. Returns false if a transform that is not
    /// finite makes the object empty.
    fn read_modifiers_stays_visible(
        &mut self,
        mut shape: Option<&mut Shape>,
        r: &mut dyn Reader,
        defaults: &Defaults,
    ) -> Result<bool> {
        let mut is_finite = true;
        let mut embedded = EmbeddedTextures::new(defaults);
        loop {
            let next = r.peek_next()?;
            if next == Next::End {
                if let Some(painted) = embedded.painted() {
                    self.uncommon.embedded = Some(painted);
                }
                if let (None, Some(radiosity)) = (self.uncommon.radiosity, defaults.radiosity) {
                    self.uncommon.radiosity = Some(radiosity);
                }
                // A copy without modifiers shares everything.
                if let Some(ObjectBody { texture: Some(painted), .. }) = Arc::get_mut(&mut self.body) {
                    defaults.recent.deduplicate(&mut painted.texture);
                }
                return Ok(is_finite);
            }
            if let Some(shape) = shape.as_deref_mut()
                && (shape.read_own(next, r)? || shape.read_textured(next, r, &mut embedded)?)
            {
                continue;
            }
            let read = match self.read_modifier(next, r, defaults) {
                // The number has been consumed.
                Err(fault)
                    if fault.code == codes::NOT_FINITE && matches!(next, Next::Word(_)) && next.is_transform() =>
                {
                    r.report(invisible_warning(self.word, *fault));
                    self.kind = ObjectKind::Csg(CsgOp::Union, Arc::default());
                    is_finite = false;
                    continue;
                }
                read => read?,
            };
            if !read {
                let own = shape.as_deref().map(|s| s.spec().word_names()).unwrap_or_default();
                let words = [own, MODIFIERS.word_names()].concat();
                let fault = r.unknown_word(self.word, &words);
                skip_color(next, fault, r)?;
            }
        }
    }

    /// Reads one modifier of an object; returns false if the token `next` begins none.
    pub(in crate::scene) fn read_modifier(
        &mut self,
        next: Next,
        r: &mut dyn Reader,
        defaults: &Defaults,
    ) -> Result<bool> {
        if is_word_in_rows(FLAGS, next) {
            return read_row(FLAGS, &mut self.uncommon.flags, next, r);
        }
        match next {
            next if next.is_transform() => {
                if let Some(step) = r.transform()? {
                    self.transform_by(&step);
                }
            }
            Next::Block(word @ ("clipped_by" | "bounded_by")) => self.read_clips_or_bounds(word, r, defaults)?,
            Next::Word(word) if matches!(word, "clipped_by" | "bounded_by") || MODIFIERS.ignores(word) => {
                r.take_token()?;
                r.flag()?;
            }
            Next::Block("interior") => {
                r.take_token()?;
                self.uncommon.interior = Some(Arc::new(Interior::read(r, self.uncommon.interior.as_deref())?));
                r.leave_block()?;
            }
            Next::Thing("interior") => self.uncommon.interior = r.take_declared::<Interior>()?,
            Next::Block("material") => {
                r.take_token()?;
                let material = read_material(r, defaults, self.uncommon.interior.clone())?;
                r.leave_block()?;
                self.set_material(&material, &r.language());
            }
            Next::Thing("material") => {
                if let Some(material) = r.take_declared::<Material>()? {
                    self.set_material(&material, &r.language());
                }
            }
            Next::Block("radiosity") => self.uncommon.radiosity = Some(ObjectRadiosity::read_with_braces(r)?),
            Next::Block("photons") => self.uncommon.photons.get_or_insert_default().read_with_braces(r)?,
            _ => return self.read_texture_if_next(next, r, defaults),
        }
        Ok(true)
    }

    /// Reads `texture`, `interior_texture`, or a part of a texture such as `pigment`; returns false for another token.
    fn read_texture_if_next(&mut self, next: Next, r: &mut dyn Reader, defaults: &Defaults) -> Result<bool> {
        match next {
            Next::Block("texture") | Next::Thing("texture") => {
                let texture = read_layers(r, defaults)?;
                self.texture = Some(self.with_layers(self.texture.as_ref(), Arc::new(texture), &r.language()));
            }
            Next::Block("interior_texture") => {
                r.take_token()?;
                let texture = Texture::read(r, &defaults.texture)?;
                r.leave_block()?;
                self.uncommon.interior_texture =
                    Some(self.with_layers(self.uncommon.interior_texture.as_ref(), Arc::new(texture), &r.language()));
            }
            _ => {
                let mut texture = match &self.texture {
                    Some(painted) => self.texture_in_block_space(painted),
                    None => (*defaults.texture).clone(),
                };
                if !texture.read_part(r, next, &defaults.texture)? {
                    return Ok(false);
                }
                self.texture = Some(Painted::new(Arc::new(texture), &self.transform));
            }
        }
        Ok(true)
    }

    /// Returns a copy of a texture of the object, in the space of the block around the object, so that layers or parts
    /// can be added there. The copy has the transforms that the object got since the texture was set; none with
    /// `uv_mapping`.
    fn texture_in_block_space(&self, painted: &Painted) -> Texture {
        let mut texture = (*painted.texture).clone();
        let block_from_texture = painted.block_from_texture(&self.transform);
        if !self.uncommon.flags.uv_mapping && *block_from_texture != Transform::IDENTITY {
            texture.transform(block_from_texture);
        }
        texture
    }

    /// Returns `texture` as layers above `below`, the object's present texture or interior texture, even if a
    /// declaration set that one (quirk: `textures_add_layers`).
    fn with_layers(&self, below: Option<&Painted>, texture: Arc<Texture>, language: &Language) -> Painted {
        let layers = match below {
            Some(below) => {
                let mut all = self.texture_in_block_space(below);
                all.layers.extend(texture.layers.iter().cloned());
                all.untint_upper_layers(language);
                Arc::new(all)
            }
            None => texture,
        };
        Painted::new(layers, &self.transform)
    }

    fn read_clips_or_bounds(&mut self, word: &'static str, r: &mut dyn Reader, defaults: &Defaults) -> Result<()> {
        let at = r.take_token()?;
        let (mut parts, mut borrows) = (vec![], false);
        loop {
            match r.peek_next()? {
                Next::End => break,
                // `clipped_by { bounded_by }` repeats the objects of `bounded_by`, if there are any.
                Next::Word(other @ ("clipped_by" | "bounded_by")) if other != word => {
                    r.take_token()?;
                    borrows = true;
                    let other =
                        if word == "clipped_by" { &self.uncommon.bounded_by } else { &self.uncommon.clipped_by };
                    parts.extend(other.iter().flat_map(|o| o.iter().cloned()));
                }
                _ => parts.push(*Self::read(r, defaults)?),
            }
        }
        r.leave_block()?;
        if parts.is_empty() && borrows {
            return Ok(());
        }
        if parts.is_empty() {
            r.report(Diagnostic::new(codes::EMPTY_BLOCK, at, format!("this `{word}` holds no object")));
            return Ok(());
        }
        Weight::check_clipping_shape_count(&parts, at)?;
        let weight = self.weight().enclosing(&parts);
        weight.check_depth(at)?;
        self.bulk.get_or_insert_default().weight = weight;
        let uncommon = &mut *self.uncommon;
        let field = if word == "clipped_by" { &mut uncommon.clipped_by } else { &mut uncommon.bounded_by };
        let before = field.take().into_iter().flat_map(|b| b.to_vec());
        *field = Some(before.chain(parts).collect());
        Ok(())
    }

    fn set_material(&mut self, material: &Material, language: &Language) {
        if let Some(texture) = &material.texture {
            self.texture = Some(self.with_layers(self.texture.as_ref(), texture.clone(), language));
        }
        if let Some(texture) = &material.interior_texture {
            self.uncommon.interior_texture =
                Some(self.with_layers(self.uncommon.interior_texture.as_ref(), texture.clone(), language));
        }
        if let Some(interior) = &material.interior {
            self.uncommon.interior = Some(interior.clone());
        }
    }
}

/// Returns the warning about an object that is invisible because of a number that is not finite.
fn invisible_warning(word: &str, fault: Diagnostic) -> Diagnostic {
    let message = format!("nothing of this `{word}` is drawn: {}", fault.message);
    Diagnostic { code: codes::INFINITE, severity: codes::INFINITE.severity(), message, ..fault }
        .help("look for a division by zero, or a number that grows in a loop")
}

/// Skips a colour, which an object ignores (quirk: `object_color_ignored`). `fault` is the error for another token.
fn skip_color(next: Next, fault: Diagnostic, r: &mut dyn Reader) -> Result<()> {
    let at = r.span();
    let is_color = match next {
        Next::Word(_) if r.may_be_at_color()? => r.color().is_ok(),
        Next::Value => matches!(r.value(), Ok((Value::Color(_), _))),
        _ => false,
    };
    if !is_color {
        return Err(fault.into());
    }
    let d = Diagnostic::new(codes::MISPLACED, at, "a colour of an object itself changes nothing");
    r.report(d.help("it belongs into a pigment: `pigment { color … }`"));
    Ok(())
}
