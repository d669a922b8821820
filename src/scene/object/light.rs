//! Reads lights with their objects, and light groups (manual, "Looks_like", "Projected_Through", "Light Groups").

use super::{CsgOp, Object, ObjectKind, is_object};
use crate::diagnostic::Result;
use crate::light::Light;
use crate::light::words::LIGHT;
use crate::math::Transform;
use crate::scene::Defaults;
use crate::source::Span;
use crate::value::words::word;
use crate::value::{Next, Reader, ReaderExt, Spec, ValueKind};
use serde::Serialize;
use std::sync::Arc;

/// A light with its objects, in the space of the block around it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LightSource {
    /// Light without its objects.
    #[serde(flatten)]
    pub light: Light,
    /// Visible shape of the light (`looks_like`), which casts no shadow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub looks_like: Option<Object>,
    /// Object that the light must pass (`projected_through`); nothing between the light and the object casts shadows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub projected_through: Option<Object>,
}

impl From<Light> for LightSource {
    fn from(light: Light) -> Self {
        Self { light, looks_like: None, projected_through: None }
    }
}

/// Words of `light_group`.
pub const LIGHT_GROUP: Spec = Spec {
    name: "light_group",
    summary: "lights and objects: those lights shine on these objects alone, and other lights do not",
    words: &[word("global_lights", ValueKind::Flag, "off", "lights outside of the group shine on its objects too")],
    has_transforms: true,
    ..Spec::EMPTY
};

impl LightSource {
    /// Reads the contents of a `light_source` block; `source` is the span of its word.
    pub(super) fn read(r: &mut dyn Reader, source: Span, defaults: &Defaults) -> Result<Self> {
        let mut lit = Self::from(Light::read_location_and_color(r, source)?);
        loop {
            match r.peek_next()? {
                Next::End => break,
                Next::Block("looks_like") => {
                    let mut object = Self::read_block_object(r, defaults)?;
                    object.transform_by(&Transform::translate(lit.light.location));
                    lit.looks_like = Some(object);
                }
                Next::Block("projected_through") => lit.projected_through = Some(Self::read_block_object(r, defaults)?),
                next if lit.light.read_own(next, r)? => {}
                next if next.is_transform() => {
                    if let Some(step) = r.transform()? {
                        lit.transform(&step);
                    }
                }
                _ => return Err(r.unknown_word_in(&LIGHT)),
            }
        }
        lit.light.check_circular_grid()?;
        Ok(lit)
    }

    fn read_block_object(r: &mut dyn Reader, defaults: &Defaults) -> Result<Object> {
        r.take_token()?;
        let object = Object::read(r, defaults)?;
        r.leave_block()?;
        Ok(*object)
    }

    fn transform(&mut self, by: &Transform) {
        self.light.transform(by);
        for part in [&mut self.looks_like, &mut self.projected_through].into_iter().flatten() {
            part.transform_by(by);
        }
    }
}

impl Object {
    /// Reads the contents of a `light_group` block; `source` is the span of its word.
    pub(super) fn read_light_group(source: Span, r: &mut dyn Reader, defaults: &Defaults) -> Result<Box<Self>> {
        let (mut parts, mut global, mut steps) = (vec![], false, vec![]);
        loop {
            match r.peek_next()? {
                Next::End => break,
                Next::Block(part) if is_object(part) => parts.push(*Self::read(r, defaults)?),
                Next::Thing("object" | "light_source") => parts.push(*Self::read(r, defaults)?),
                Next::Word("global_lights") => {
                    r.take_token()?;
                    global = r.flag()?;
                }
                next if next.is_transform() => steps.extend(r.transform()?),
                _ => return Err(r.unknown_word_in(&LIGHT_GROUP)),
            }
        }
        let pov_bounds = Self::pov_bounds_of_parts(CsgOp::Union, &parts);
        let kind = ObjectKind::Csg(CsgOp::Union, parts.into());
        let mut object = Box::new(Self::new(kind, "light_group", source, defaults));
        object.weight().check_depth(source)?;
        object.bulk.get_or_insert_default().pov_bounds = Some(pov_bounds);
        object.uncommon.light_group = Some(global);
        for step in steps {
            object.transform_by(&step);
        }
        Ok(object)
    }

    /// Reads the contents of a light's block as an object; `source` is the span of the block's word.
    pub(super) fn read_light(source: Span, r: &mut dyn Reader, defaults: &Defaults) -> Result<Box<Self>> {
        let lit = LightSource::read(r, source, defaults)?;
        Ok(Box::new(Self::new(ObjectKind::Light(Arc::new(lit)), "light_source", source, defaults)))
    }
}
