//! Objects: shapes, CSG and lights with what is said of them (manual, "Object", "Object Modifiers").

mod camera;
mod embedded;
mod light;
mod read;

use super::{Defaults, Painted, Weight};
use crate::math::{Aabb, Transform};
use crate::medium::Interior;
use crate::shape::{Shape, moved_box};
use crate::source::Span;
use crate::texture::Texture;
use crate::value::{SharedDefault, StaticDefault, Thing, Unsupported};
use serde::Serialize;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

pub use camera::read_camera;
pub use light::{LIGHT_GROUP, LightSource};
pub use read::is_object;

/// What an object is made of.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ObjectKind {
    /// One shape.
    Shape(Shape),
    /// Several objects.
    Csg(CsgOp, Arc<[Object]>),
    /// A light, which a union may carry along.
    Light(Arc<LightSource>),
}

/// How a CSG object is made of its parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CsgOp {
    /// All of them.
    Union,
    /// What they share.
    Intersection,
    /// The first without the others.
    Difference,
    /// All of them, without the surfaces inside.
    Merge,
}

/// Switches; a CSG object's hold for its parts too.
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
    /// All switched off.
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

/// An object as it was written. Cheap to copy: a copy shares all but its place, until something else is said of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Object {
    /// What it is.
    #[serde(flatten)]
    pub body: Arc<ObjectBody>,
    /// All its transforms, in the space around its block.
    pub transform: SharedDefault<Transform>,
    /// The text that made it.
    pub source: Span,
    /// The default texture where it was put into the scene, for all of its parts that say nothing; of an outermost object
    /// only.
    pub default_texture: Arc<Texture>,
}

/// What an object is, wherever it lies. Its fields are read and set as the object's own.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ObjectBody {
    /// What it is made of.
    pub kind: ObjectKind,
    /// What it looks like; its parent's texture, or the default, where it says nothing.
    pub texture: Option<Painted>,
    /// What most objects do not say.
    #[serde(flatten)]
    pub uncommon: SharedDefault<Uncommon>,
    /// The word it was written with.
    pub word: &'static str,
    /// How large it is, if it is more than a shape.
    #[serde(skip)]
    pub bulk: Option<Box<Bulk>>,
}

/// How large an object is that is more than a shape.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bulk {
    /// The box that [`Object::pov_bounds`] tells of a CSG object; moved along with the object.
    pub pov_bounds: Option<Aabb>,
    /// What is in it.
    pub weight: Weight,
}

/// What few objects say.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Uncommon {
    /// What it looks like from inside.
    pub interior_texture: Option<Painted>,
    /// The textures that its shape carries itself; number 1 is the first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub embedded: Option<Arc<[Painted]>>,
    /// What fills it.
    pub interior: Option<Arc<Interior>>,
    /// Only what lies inside all of these is there; moved along with the object.
    pub clipped_by: Option<Arc<[Object]>>,
    /// A hint about its pov_bounds.
    pub bounded_by: Option<Arc<[Object]>>,
    /// Of a group of lights: do lights outside shine on it too?
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light_group: Option<bool>,
    /// Switches.
    pub flags: Flags,
    /// What was said and is not drawn yet.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unsupported: Option<Arc<Vec<Unsupported>>>,
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
            unsupported: None,
        };
        &NOTHING
    }
}

impl Uncommon {
    fn transform_by(&mut self, step: &Transform) {
        if let Some(painted) = &mut self.interior_texture {
            painted.transform_by(step);
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
    /// One of which nothing more is said.
    pub fn new(kind: ObjectKind, word: &'static str) -> Self {
        let bulk = match &kind {
            ObjectKind::Csg(_, parts) if !parts.is_empty() => {
                Some(Box::new(Bulk { pov_bounds: None, weight: Weight::default().around(parts) }))
            }
            _ => None,
        };
        Self { kind, texture: None, uncommon: SharedDefault::DEFAULT, word, bulk }
    }

    /// How much is in it.
    pub fn weight(&self) -> Weight {
        self.bulk.as_ref().map_or(Weight::SHAPE, |bulk| bulk.weight)
    }

    /// Does it hold places that are moved when the object is?
    fn holds_places(&self) -> bool {
        let moved = |painted: &Option<Painted>| painted.as_ref().is_some_and(|p| p.moved.is_some());
        let bound = self.uncommon.clipped_by.is_some() || self.uncommon.bounded_by.is_some();
        let boxed = self.bulk.as_ref().is_some_and(|bulk| bulk.pov_bounds.is_some());
        boxed || bound || moved(&self.texture) || moved(&self.uncommon.interior_texture)
    }
}

impl Deref for Object {
    type Target = ObjectBody;

    fn deref(&self) -> &ObjectBody {
        &self.body
    }
}

impl DerefMut for Object {
    /// Its own body from now on.
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
    /// One of which nothing is said yet.
    pub fn new(kind: ObjectKind, word: &'static str, source: Span, defaults: &Defaults) -> Self {
        Self {
            body: Arc::new(ObjectBody::new(kind, word)),
            transform: SharedDefault::DEFAULT,
            source,
            default_texture: defaults.texture.clone(),
        }
    }

    /// A shape whose block is being read.
    pub(in crate::scene) fn unfinished(word: &'static str, source: Span, defaults: &Defaults) -> Self {
        let nothing = ObjectKind::Csg(CsgOp::Union, Arc::default());
        Self::new(nothing, word, source, defaults)
    }

    /// Does `uv_mapping` of the group around it hold for it too? (Measured on POV-Ray 3.7.)
    pub fn follows_uv(&self) -> bool {
        self.uncommon.interior_texture.is_none()
    }

    /// Moves the object with its textures and what clips it.
    pub fn transform_by(&mut self, step: &Transform) {
        self.transform = self.transform.then(step).into();
        if !self.body.holds_places() {
            return;
        }
        let body = Arc::make_mut(&mut self.body);
        if let Some(pov_bounds) = body.bulk.as_mut().and_then(|bulk| bulk.pov_bounds.as_mut()) {
            *pov_bounds = moved_box(step, pov_bounds);
        }
        if let Some(painted) = &mut body.texture {
            painted.transform_by(step);
        }
        if body.uncommon.explicit().is_some() {
            body.uncommon.transform_by(step);
        }
    }
}
