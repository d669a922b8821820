//! Lowered media: what rays need of a `media` block.

use crate::color::Rgb;
use crate::math::noise::NoiseGenerator;
use crate::math::{Aabb, DVec3, Ray, Transform};
use crate::medium::{Media, MediaSampling, Scattering};
use crate::pattern::TextureContext;
use crate::source::Span;
use crate::texture::{Density, PigmentProgram};
use serde::Serialize;

/// A medium in world space.
#[derive(Clone, Debug, Serialize)]
pub struct Medium {
    /// Light that the medium emits per world unit at density 1.
    pub emission: Rgb,
    /// Light that the medium absorbs and scatters away per world unit at density 1.
    pub extinction: Rgb,
    /// Light that the medium scatters.
    pub scattering: Scattering,
    /// Parameters of the sampling along rays.
    pub sampling: MediaSampling,
    /// True if the medium stores photons and shows their light.
    pub collects_photons: bool,
    /// Number of the set of lights that illuminate the medium, see [`super::World::lit_by`].
    pub light_set: u32,
    /// Span of the `media` block.
    #[serde(skip)]
    pub source: Span,
    /// Densities whose product is the medium's, those first that are known to be 0 outside of a region.
    densities: Box<[PigmentProgram]>,
    /// Transform from the space of the densities to world space; `None` for the identity.
    place: Option<Box<Transform>>,
}

impl Medium {
    /// Lowers a medium; `place` transforms its densities to world space.
    pub(super) fn new(media: &Media, place: &Transform, light_set: u32) -> Self {
        let scattered = media.scattering.color * media.scattering.extinction;
        let program = |density: &Density| PigmentProgram::new(density.as_pigment());
        let mut densities: Vec<PigmentProgram> = media.densities.iter().map(program).collect();
        // Where one density is 0, the others are not evaluated.
        densities.sort_by_key(|density| !density.has_support());
        Self {
            emission: media.emission,
            extinction: media.absorption + scattered,
            scattering: media.scattering,
            sampling: media.sampling,
            collects_photons: !media.ignores_photons && media.scattering.color != Rgb::ZERO,
            light_set,
            source: media.source,
            densities: densities.into(),
            place: (!place.is_identity() && !media.densities.is_empty()).then(|| Box::new(*place)),
        }
    }

    /// True if the medium has the same density everywhere.
    pub fn is_homogeneous(&self) -> bool {
        self.densities.is_empty()
    }

    /// Returns the density at a point in world space, for each channel; `dir` is the direction of the ray.
    pub fn density_at(&self, world_point: DVec3, dir: DVec3, noise: NoiseGenerator, waves: usize) -> Rgb {
        if self.densities.is_empty() {
            return Rgb::ONE;
        }
        let p = self.place.as_ref().map_or(world_point, |place| place.inverse_transform_point(world_point));
        let ctx = TextureContext { waves, world: world_point, ray: dir, ..TextureContext::without_surface(p, noise) };
        let mut product = Rgb::ONE;
        for density in &self.densities {
            product *= density.color_at(&ctx).rgb;
            if product == Rgb::ZERO {
                break;
            }
        }
        product
    }

    /// True if the density is certainly 0 everywhere in a box in world space.
    pub fn is_empty_in(&self, bounds: &Aabb) -> bool {
        let corners = bounds.corners().map(|p| self.place.as_ref().map_or(p, |place| place.inverse_transform_point(p)));
        bounds.is_finite() && self.densities.iter().any(|density| density.is_black_in_hull_of(corners))
    }

    /// Returns distances along a ray in world space outside of which the density is 0; they are infinite where none are
    /// known. The first is greater than the second if the density is 0 on the whole ray.
    pub fn extent_on_ray(&self, ray: &Ray) -> [f64; 2] {
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY];
        if !self.densities.first().is_some_and(PigmentProgram::has_support) {
            return everywhere;
        }
        let local = self.place.as_ref().map_or(*ray, |place| place.inverse_transform_ray(ray));
        let extents = self.densities.iter().filter_map(|density| density.known_support_on_ray(&local));
        extents.fold(everywhere, |[from, to], [start, end]| [from.max(start), to.min(end)])
    }
}
