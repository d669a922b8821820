//! What a ray needs: every object with M and M⁻¹; no names, versions, degrees or nested blocks.

mod child_bvh;
mod convex_interval;
mod geometry;
mod halfspace;
mod instance;
mod leaf;
mod lower;
mod material;
mod node;
mod probe;
mod ray_epsilon;
mod sky;

pub use geometry::{Blocker, Geometry, PlacedSolid};
pub use leaf::{Intersection, Intersections, Leaf, Surface};
pub use lower::{lower, lower_away};
pub use material::{Choice, Layer, LayerColor, Lobe, LoweredFinish, Material};
pub use node::{SolidKind, SolidNode};
pub use probe::Probe;
pub use ray_epsilon::RayEpsilon;
pub use sky::Sky;

use crate::atmosphere::{Fog, Rainbow};
use crate::camera::LoweredCamera;
use crate::color::Gamma;
use crate::color::Rgb;
use crate::light::LoweredLight;
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec3, Transform};
use crate::medium::Interior;
use crate::source::Span;
use serde::Serialize;
use std::sync::Arc;

/// The lowered scene.
#[derive(Debug, Serialize)]
pub struct World {
    /// Where rays begin.
    pub eye: LoweredCamera,
    /// The text of the camera; none of the one that stands for a missing one.
    #[serde(skip)]
    pub camera_source: Span,
    /// All objects.
    pub geometry: Geometry,
    /// Nearer to where they begin, rays meet nothing.
    pub epsilon: RayEpsilon,
    /// By [`Intersection::part`].
    pub parts: Vec<Part>,
    /// By [`SolidNode::object`].
    pub objects: Vec<ObjectInfo>,
    /// By [`UncommonPart::cut`]: what can be cut. At a point, all that hold it are seen in equal parts, and [`Part::outside`] where none does.
    pub cuts: Vec<Vec<(SolidNode, PlacedMaterial)>>,
    /// By [`PlacedMaterial::material`].
    pub materials: Vec<Material>,
    /// What fills objects, by number of the interior.
    pub interiors: Vec<Arc<Interior>>,
    /// The noise of patterns that do not say which.
    pub noise: NoiseGenerator,
    /// How many sources `ripples` and `waves` have.
    pub waves: usize,
    /// By number of the interior: does it keep fog out?
    pub filled: Vec<bool>,
    /// All lights.
    pub lights: Vec<LightSource>,
    /// By [`UncommonPart::lights`]: which lights shine on it.
    pub lit_by: Vec<Box<[u32]>>,
    /// What rays see that hit nothing.
    pub sky: Sky,
    /// All fogs that show.
    pub fogs: Vec<Fog>,
    /// All rainbows.
    pub rainbows: Vec<Rainbow>,
    /// From the numbers of the scene to light.
    pub gamma: Gamma,
    /// How often a ray may be reflected and bent.
    pub max_trace_level: u32,
    /// Rays that count for no more than this are not followed.
    pub adc_bailout: f64,
    /// As in [`crate::scene::Settings`].
    pub opacity_by_color: bool,
    /// Does light pass through any object?
    pub see_through: bool,
    /// Is light bent anywhere?
    pub bends: bool,
    /// Does any interior split light into its colours?
    pub disperses: bool,
    /// Does light change on its way through any interior, other than by bending?
    pub colors_light: bool,
    /// Of the light that `irid` is worked out for.
    pub irid_wavelength: Rgb,
}

/// What belongs to a leaf.
#[derive(Clone, Debug, Serialize)]
pub struct Part {
    /// Seen from outside.
    pub outside: PlacedMaterial,
    /// What few of them have.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncommon: Option<Box<UncommonPart>>,
    /// Number of what fills it.
    pub interior: u32,
    /// Light from behind counts as light from the front.
    pub double_illuminate: bool,
    /// Its textures see places on the surface, (u, v, 0), instead of points (`uv_mapping` of the object).
    pub uv: bool,
    /// `no_shadow` of its own or of a block around it; an object that it is a part of may cast its shadow all the same.
    #[serde(skip)]
    pub no_shadow: bool,
    /// The text that made it.
    pub source: Span,
}

/// What else may be seen of a leaf than its own materials.
#[derive(Clone, Debug, Default, Serialize)]
pub struct UncommonPart {
    /// Seen from inside, if that differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inside: Option<PlacedMaterial>,
    /// The textures that the shape carries itself; number 1 is the first.
    pub embedded: Box<[PlacedMaterial]>,
    /// Number of the set of lights that shine on it; 0: those of no group.
    pub lights: u32,
    /// Of a shape that cuts (`cutaway_textures`): number of what it cuts, which is seen in place of `outside`.
    pub cut: Option<u32>,
}

/// A material where it lies.
#[derive(Clone, Debug, Serialize)]
pub struct PlacedMaterial {
    /// Number of the material.
    pub material: u32,
    /// World from texture; `None` where both are the same or it does not matter.
    pub place: Option<Arc<Transform>>,
}

impl Part {
    /// Number of the set of lights that shine on it.
    pub fn lights(&self) -> u32 {
        self.uncommon.as_ref().map_or(0, |uncommon| uncommon.lights)
    }
}

impl PlacedMaterial {
    /// A point of the world in the texture's space.
    pub fn local(&self, p: DVec3) -> DVec3 {
        self.place.as_ref().map_or(p, |m| m.inverse_point(p))
    }
}

/// What belongs to an object as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ObjectInfo {
    /// Does it cast shadows?
    pub shadow: bool,
    /// Does the camera see it?
    pub image: bool,
    /// Does it see it through others?
    pub through: bool,
    /// Do mirrors show it?
    pub reflection: bool,
    /// Does no light pass anywhere?
    pub opaque: bool,
    /// Number of what fills it, or [`Self::VIEW`].
    pub interior: u32,
}

impl ObjectInfo {
    /// In place of an interior: it is but another object as some rays see it, which has been counted.
    pub const VIEW: u32 = u32::MAX;
}

/// A light in its place.
#[derive(Clone, Debug, Serialize)]
pub struct LightSource {
    /// Where it stands in [`World::lights`].
    #[serde(skip)]
    pub number: usize,
    /// How it shines.
    pub emitter: LoweredLight,
    /// Only what passes this shines, and nothing between the two is in the way (`projected_through`).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub through: Option<Box<Geometry>>,
}

impl World {
    /// Must rays know what they are in?
    pub fn asks_inside(&self) -> bool {
        self.bends || self.colors_light || !self.fogs.is_empty() || !self.rainbows.is_empty()
    }
}
