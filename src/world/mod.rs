//! The lowered scene: the data that rays need. Every object has one transform and its inverse; there are no names,
//! versions, degrees or nested blocks.

mod child_bvh;
mod convex_interval;
mod convex_packet;
mod digest;
mod geometry;
mod halfspace;
mod instance;
mod leaf;
mod lower;
mod material;
mod medium;
mod node;
mod probe;
mod ray_epsilon;
mod sky;

pub use geometry::{
    Blocker, ClosestHits, Coherence, Geometry, HitBuffer, LightFilters, PacketOcclusion, PacketSurfaces, PlacedSolid,
    ShadowRole, ShaftOccluder, surfaces_of_packet,
};
pub use leaf::{Intersection, Intersections, Leaf, Surface};
pub use lower::{lower, lower_and_free};
pub use material::{Choice, Layer, LayerColor, Lobe, LoweredFinish, Material, Shading};
pub use medium::Medium;
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
use crate::scene::{PhotonMapSettings, PhotonSettings, Radiosity, SubsurfaceSettings};
use crate::source::Span;
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The scene, lowered to the data that rays need.
#[derive(Debug, Serialize)]
pub struct World {
    /// Camera of the scene.
    pub eye: LoweredCamera,
    /// Span of the camera's block; [`Span::NONE`] for the default camera.
    #[serde(skip)]
    pub camera_source: Span,
    /// All objects that rays can hit.
    pub geometry: Geometry,
    /// Minimum hit distances of rays.
    pub epsilon: RayEpsilon,
    /// Properties of shapes, by [`Intersection::part_number`].
    pub parts: Vec<Part>,
    /// Properties of objects, by [`SolidNode::object`].
    pub objects: Vec<ObjectInfo>,
    /// Solids for `cutaway_textures`, by [`UncommonPart::cut`]. A point on a cutting shape shows the materials of all
    /// solids that contain the point in equal shares, or [`Part::outside`] if none does.
    pub cuts: Vec<Vec<(SolidNode, PlacedMaterial)>>,
    /// Materials, by [`PlacedMaterial::material`].
    pub materials: Vec<Material>,
    /// Interiors, by [`Part::interior`].
    pub interiors: Vec<Arc<Interior>>,
    /// Media of the interiors that have some, by the interior's number.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub media: BTreeMap<u32, Box<[Medium]>>,
    /// Media of the whole scene.
    #[serde(skip_serializing_if = "<[Medium]>::is_empty")]
    pub air: Box<[Medium]>,
    /// Noise generator of patterns that do not name one.
    pub noise: NoiseGenerator,
    /// Distinct `photons` settings of objects, by [`ObjectInfo::photons`]; the first are the defaults.
    pub photons: Vec<PhotonSettings>,
    /// Settings of radiosity; `None` for a scene without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radiosity: Option<Box<Radiosity>>,
    /// Settings of the photon map; `None` for a scene without photons.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub photon_map: Option<PhotonMapSettings>,
    /// Settings of subsurface light transport; `None` for a scene without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub subsurface: Option<SubsurfaceSettings>,
    /// Number of wave sources of `ripples` and `waves` (`number_of_waves`).
    pub waves: usize,
    /// True for each interior, by its number, that is not hollow and keeps fog out.
    pub filled: Vec<bool>,
    /// All lights of the scene.
    pub lights: Vec<LightSource>,
    /// Sets of lights that illuminate a shape, by [`UncommonPart::light_set`]: the numbers of the lights.
    pub lit_by: Vec<Box<[u32]>>,
    /// Sky sphere and background.
    pub sky: Sky,
    /// All fogs that have an effect.
    pub fogs: Vec<Fog>,
    /// All rainbows of the scene.
    pub rainbows: Vec<Rainbow>,
    /// Conversion from the scene's colour values to linear light.
    pub gamma: Gamma,
    /// Maximum depth of the ray tree.
    pub max_trace_level: u32,
    /// Importance below which rays are not traced.
    pub adc_bailout: f64,
    /// True for the blending of filters before version 3.7; see [`crate::scene::Settings::opacity_by_color`].
    pub opacity_by_color: bool,
    /// True if any object transmits light.
    pub see_through: bool,
    /// True if a shadow ray starts anew at each surface that it passes (quirk: `isosurface_csg_shadows`).
    pub restarts_shadow_rays: bool,
    /// True if any interior refracts light.
    pub bends: bool,
    /// True if any interior disperses light.
    pub disperses: bool,
    /// True if any interior attenuates light or makes caustics.
    pub colors_light: bool,
    /// Wavelengths of red, green and blue for `irid`.
    pub irid_wavelength: Rgb,
}

/// Properties of one shape in the world apart from its geometry: materials, interior, lights, photons.
#[derive(Clone, Debug, Serialize)]
pub struct Part {
    /// Material of the shape's outer side, with the transform of its texture space.
    pub outside: PlacedMaterial,
    /// Properties that only few shapes have; `None` for a shape with none of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uncommon: Option<Box<UncommonPart>>,
    /// Index of the shape's interior in [`World::interiors`].
    pub interior: u32,
    /// True if light from behind counts as light from the front.
    pub double_illuminate: bool,
    /// True if textures are evaluated at surface coordinates (u, v, 0) in place of the point (`uv_mapping` of the
    /// object).
    pub uv: bool,
    /// True if the shape stores photons and shows their light (no `collect off`).
    #[serde(skip)]
    pub collects_photons: bool,
    /// `no_shadow` of the shape or of a block around it. Only [`World::scene_digest`] uses it: shadows depend on
    /// [`ObjectInfo::shadow`] of the object that contains the shape.
    #[serde(skip)]
    pub no_shadow: bool,
    /// Span of the object's block.
    pub source: Span,
}

/// Properties of a shape that are uncommon.
#[derive(Clone, Debug, Serialize)]
pub struct UncommonPart {
    /// Material of the inside; `None` if it is that of the outside.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inside: Option<PlacedMaterial>,
    /// Embedded textures of the shape; number 1 is the first.
    pub embedded: Box<[PlacedMaterial]>,
    /// Number of the set of lights that illuminate the shape; 0 for the lights of no group.
    pub light_set: u32,
    /// Index in [`World::cuts`] of the solids whose materials a cutting shape shows (`cutaway_textures`); `None` for
    /// other shapes.
    pub cut: Option<u32>,
    /// Share of the radiosity rays to the shape that are traced, more than 0 and at most 1.
    #[serde(skip_serializing_if = "is_one")]
    pub importance: f32,
}

/// A material with the transform of its space.
#[derive(Clone, Debug, Serialize)]
pub struct PlacedMaterial {
    /// Index of the material in [`World::materials`].
    pub material: u32,
    /// Transform from texture to world space; `None` for the identity, or if the transform has no effect.
    pub place: Option<Arc<Transform>>,
}

impl Part {
    /// Returns the number of the set of lights that illuminate the shape, an index in [`World::lit_by`].
    pub fn light_set(&self) -> u32 {
        self.uncommon.as_ref().map_or(0, |uncommon| uncommon.light_set)
    }

    /// Returns the share of the radiosity rays to the shape that are traced, more than 0 and at most 1.
    pub fn importance(&self) -> f64 {
        self.uncommon.as_ref().map_or(1.0, |uncommon| f64::from(uncommon.importance))
    }
}

impl PlacedMaterial {
    /// Transforms a point from world space to the texture's space.
    pub fn local(&self, p: DVec3) -> DVec3 {
        self.place.as_ref().map_or(p, |m| m.inverse_transform_point(p))
    }
}

/// Properties of an object as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ObjectInfo {
    /// True if the object casts shadows.
    pub shadow: bool,
    /// True if camera rays hit the object.
    pub image: bool,
    /// True if camera rays hit the object after a transparent surface.
    pub through: bool,
    /// True if reflected rays hit the object.
    pub reflection: bool,
    /// True if radiosity rays hit the object (`no_radiosity` is not set).
    pub radiosity: bool,
    /// True if photons hit the object.
    pub is_hit_by_photons: bool,
    /// Index of the object's photon settings in [`World::photons`].
    pub photons: u32,
    /// True if the object transmits light at no point of its surface.
    pub opaque: bool,
    /// Index of the object's interior, or [`Self::VIEW`].
    pub interior: u32,
}

/// Kind of a ray, by which objects can be hidden from it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// A ray of the camera that has passed no surface.
    Camera,
    /// A ray of the camera that transparent surfaces have transmitted.
    Transmitted,
    /// A ray that a surface has reflected.
    Reflected,
    /// A ray that gathers light for radiosity.
    Radiosity,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_one(importance: &f32) -> bool {
    *importance == 1.0
}

impl ObjectInfo {
    /// Value in place of an interior's index: the object is only another view of an object that is already counted.
    pub const VIEW: u32 = u32::MAX;

    /// True if rays of a kind hit the object.
    #[inline]
    pub fn is_visible_to(&self, kind: RayKind) -> bool {
        match kind {
            RayKind::Camera => self.image,
            RayKind::Transmitted => self.through,
            RayKind::Reflected => self.reflection,
            RayKind::Radiosity => self.radiosity,
        }
    }
}

/// A light in the world.
#[derive(Clone, Debug, Serialize)]
pub struct LightSource {
    /// Index of the light in [`World::lights`].
    #[serde(skip)]
    pub number: usize,
    /// The light's emission.
    pub emitter: LoweredLight,
    /// Object that the light must pass (`projected_through`); `None` for other lights. Objects between the light
    /// and this object do not occlude.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub through: Option<Box<Geometry>>,
}

impl World {
    /// Returns the material on the outside of the part that a ray hits.
    #[inline(always)]
    pub fn material_outside(&self, hit: &Intersection) -> &Material {
        &self.materials[self.parts[hit.part_number() as usize].outside.material as usize]
    }

    /// Returns whether objects with the photon settings of this number refract and whether they reflect photons of a light.
    pub fn photon_refracts_and_reflects(&self, light: &LightSource, settings: u32) -> [bool; 2] {
        self.photons[settings as usize].refracts_and_reflects(&light.emitter.photons)
    }

    /// Returns the effect of an object on the light of shadow rays.
    #[inline]
    pub fn shadow_role(&self, object: u32) -> ShadowRole {
        let object = &self.objects[object as usize];
        match (object.shadow, object.opaque || !self.see_through) {
            (false, _) => ShadowRole::Ignored,
            (true, true) => ShadowRole::Occludes,
            (true, false) => ShadowRole::Filters,
        }
    }

    /// True if the space around objects changes light: by fog, rainbows or media.
    pub fn has_air(&self) -> bool {
        !self.fogs.is_empty() || !self.rainbows.is_empty() || !self.air.is_empty()
    }

    /// True if rays must keep a list of the interiors that contain them.
    pub fn needs_interior_lists(&self) -> bool {
        self.bends || self.colors_light || !self.media.is_empty() || self.has_air()
    }
}
