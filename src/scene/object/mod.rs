//! Objects: shapes, CSG and lights with their modifiers (manual, "Object", "Object Modifiers").

mod camera;
mod embedded;
mod light;
mod photons;
mod radiosity;
mod read;

use super::{Defaults, Painted, Weight};
use crate::math::{Aabb, Transform};
use crate::medium::Interior;
use crate::shape::{Shape, transformed_box};
use crate::source::Span;
use crate::texture::Texture;
use crate::value::{SharedDefault, StaticDefault, Thing};
use serde::Serialize;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

pub use camera::read_camera;
pub use light::{LIGHT_GROUP, LightSource};
pub use photons::{PHOTONS, PhotonSettings};
pub use radiosity::{OBJECT_RADIOSITY, ObjectRadiosity};
pub use read::is_object;

/// Geometry of an object: a shape, a CSG object or a light.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ObjectKind {
    /// A single shape, such as a sphere.
    Shape(Shape),
    /// A CSG object: the operation and the operands.
    Csg(CsgOp, Arc<[Object]>),
    /// A light, which can be a part of a union.
    Light(Arc<LightSource>),
}

/// CSG operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CsgOp {
    /// Union that keeps the surfaces inside it.
    Union,
    /// Intersection of all parts.
    Intersection,
    /// Difference: the first part without the others.
    Difference,
    /// Union without the surfaces inside it.
    Merge,
}

/// Switches of an object. Switches of a CSG object also apply to its parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[allow(missing_docs)]
pub struct Flags {
    pub no_shadow: bool,
    pub no_image: bool,
    pub no_reflection: bool,
    pub no_radiosity: bool,
    pub hollow: bool,
    pub inverse: bool,
    pub double_illuminate: bool,
    pub cutaway_textures: bool,
    pub uv_mapping: bool,
}

impl Flags {
    /// Switches of an object without modifiers: all off.
    pub const NONE: Self = Self {
        no_shadow: false,
        no_image: false,
        no_reflection: false,
        no_radiosity: false,
        hollow: false,
        inverse: false,
        double_illuminate: false,
        cutaway_textures: false,
        uv_mapping: false,
    };
}

/// An object of the scene. Copies are cheap: until they are modified, they share everything but the transform.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Object {
    /// Contents of the object, shared with its copies.
    #[serde(flatten)]
    pub body: Arc<ObjectBody>,
    /// Product of all transforms of the object: from object space to the space of the block around it.
    pub transform: SharedDefault<Transform>,
    /// Span of the word of the object's block, or of the name of a declared object.
    pub source: Span,
    /// Default texture for parts without a texture, as it was when the object was added to the scene; used for
    /// outermost objects only.
    pub default_texture: Arc<Texture>,
}

/// Contents of an object except its transform. [`Object`] dereferences to it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ObjectBody {
    /// Geometry of the object.
    pub kind: ObjectKind,
    /// Texture of the object; `None` for the parent's texture or, at last, the default.
    pub texture: Option<Painted>,
    /// Rarely used fields of the object.
    #[serde(flatten)]
    pub uncommon: SharedDefault<Uncommon>,
    /// Word of the object's block, such as `sphere`.
    pub word: &'static str,
    /// Bounding box, nesting depth and number of shapes of a CSG object, or of an object with clipping or bounding
    /// objects; `None` for any other shape or light.
    #[serde(skip)]
    pub bulk: Option<Box<Bulk>>,
}

/// Bounding box, nesting depth and number of shapes of a CSG object, or of an object with clipping or bounding objects.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bulk {
    /// POV-Ray's box of a CSG object, in the space after the object's transforms and before clipping; `None` for a
    /// shape or a light.
    pub pov_bounds: Option<Aabb>,
    /// Nesting depth and number of shapes.
    pub weight: Weight,
}

/// Rarely used fields of an object.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Uncommon {
    /// Texture on the inside of the object's surface.
    pub interior_texture: Option<Painted>,
    /// Textures embedded in the shape, such as those of a mesh; number 1 is the first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub embedded: Option<Arc<[Painted]>>,
    /// Interior of the object.
    pub interior: Option<Arc<Interior>>,
    /// Clipping objects, outside of which the object is cut away; they are transformed with the object.
    pub clipped_by: Option<Arc<[Object]>>,
    /// Bounding objects: rays that miss them skip the object.
    pub bounded_by: Option<Arc<[Object]>>,
    /// `global_lights` of a light group: true if lights outside of the group illuminate it; `None` for other objects.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light_group: Option<bool>,
    /// Switches of the object, such as `no_shadow`.
    pub flags: Flags,
    /// `photons` block of the object; `None` without the block.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub photons: Option<PhotonSettings>,
    /// `radiosity` block of the object; `None` without the block.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radiosity: Option<ObjectRadiosity>,
}

impl StaticDefault for Uncommon {
    fn static_default() -> &'static Self {
        static NOTHING: Uncommon = Uncommon {
            interior_texture: None,
            embedded: None,
            interior: None,
            clipped_by: None,
            bounded_by: None,
            light_group: None,
            flags: Flags::NONE,
            photons: None,
            radiosity: None,
        };
        &NOTHING
    }
}

impl Uncommon {
    fn transform_by(&mut self, step: &Transform) {
        if let Some(painted) = &mut self.interior_texture {
            painted.transform_by(step);
        }
        if let Some(interior) = self.interior.as_mut().filter(|interior| interior.has_transformed_contents()) {
            Arc::make_mut(interior).transform(step);
        }
        for bound in [&mut self.clipped_by, &mut self.bounded_by] {
            let moved = |o: &Object| {
                let mut o = o.clone();
                o.transform_by(step);
                o
            };
            *bound = bound.as_ref().map(|parts| parts.iter().map(moved).collect());
        }
    }
}

impl ObjectBody {
    /// Creates the contents of an object without modifiers.
    pub fn new(kind: ObjectKind, word: &'static str) -> Self {
        let bulk = match &kind {
            ObjectKind::Csg(_, parts) if !parts.is_empty() => {
                Some(Box::new(Bulk { pov_bounds: None, weight: Weight::default().enclosing(parts) }))
            }
            _ => None,
        };
        Self { kind, texture: None, uncommon: SharedDefault::DEFAULT, word, bulk }
    }

    /// Returns the object's nesting depth and number of shapes.
    pub fn weight(&self) -> Weight {
        self.bulk.as_ref().map_or(Weight::SHAPE, |bulk| bulk.weight)
    }

    /// True if a transform of the object must also transform its box, textures, interior, clipping or bounding objects.
    fn has_transformed_contents(&self) -> bool {
        let moved = |painted: &Option<Painted>| painted.as_ref().is_some_and(|p| p.moved.is_some());
        let bound = self.uncommon.clipped_by.is_some() || self.uncommon.bounded_by.is_some();
        let boxed = self.bulk.as_ref().is_some_and(|bulk| bulk.pov_bounds.is_some());
        let interior = self.uncommon.interior.as_ref().is_some_and(|interior| interior.has_transformed_contents());
        boxed || bound || interior || moved(&self.texture) || moved(&self.uncommon.interior_texture)
    }
}

impl Deref for Object {
    type Target = ObjectBody;

    fn deref(&self) -> &ObjectBody {
        &self.body
    }
}

impl DerefMut for Object {
    /// Returns the contents for a change. Contents shared with copies are cloned first.
    fn deref_mut(&mut self) -> &mut ObjectBody {
        Arc::make_mut(&mut self.body)
    }
}

impl Thing for Object {
    fn kind(&self) -> &'static str {
        "object"
    }
}

impl Object {
    /// Creates an object without modifiers.
    pub fn new(kind: ObjectKind, word: &'static str, source: Span, defaults: &Defaults) -> Self {
        Self {
            body: Arc::new(ObjectBody::new(kind, word)),
            transform: SharedDefault::DEFAULT,
            source,
            default_texture: defaults.texture.clone(),
        }
    }

    /// Creates an object whose shape is still to be read.
    pub(in crate::scene) fn unfinished(word: &'static str, source: Span, defaults: &Defaults) -> Self {
        let nothing = ObjectKind::Csg(CsgOp::Union, Arc::default());
        Self::new(nothing, word, source, defaults)
    }

    /// True if `uv_mapping` of the group around the object also applies to the object (quirk: `uv_mapping_of_group`).
    pub fn takes_group_uv_mapping(&self) -> bool {
        self.uncommon.interior_texture.is_none()
    }

    /// Transforms the object with its textures, its interior, and its clipping and bounding objects.
    pub fn transform_by(&mut self, step: &Transform) {
        self.transform = self.transform.then(step).into();
        if !self.body.has_transformed_contents() {
            return;
        }
        let body = Arc::make_mut(&mut self.body);
        if let Some(pov_bounds) = body.bulk.as_mut().and_then(|bulk| bulk.pov_bounds.as_mut()) {
            *pov_bounds = transformed_box(step, pov_bounds);
        }
        if let Some(painted) = &mut body.texture {
            painted.transform_by(step);
        }
        if body.uncommon.explicit_value().is_some() {
            body.uncommon.transform_by(step);
        }
    }
}
