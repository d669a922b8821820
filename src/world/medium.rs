//! Lowered media: what rays need of a `media` block.

use crate::color::Rgb;
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec3, Transform};
use crate::medium::{Media, MediaSampling, Scattering};
use crate::pattern::TextureContext;
use crate::texture::PigmentProgram;
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
    /// Number of the set of lights that illuminate the medium, see [`super::World::lit_by`].
    pub lights: u32,
    densities: Box<[PigmentProgram]>,
    /// Transform from the space of the densities to world space; `None` for the identity.
    place: Option<Box<Transform>>,
}

impl Medium {
    /// Lowers a medium; `place` transforms its densities to world space.
    pub(super) fn new(media: &Media, place: &Transform, lights: u32) -> Self {
        let scattered = media.scattering.color * media.scattering.extinction;
        Self {
            emission: media.emission,
            extinction: media.absorption + scattered,
            scattering: media.scattering,
            sampling: media.sampling,
            lights,
            densities: media.densities.iter().map(|density| PigmentProgram::new(density.as_pigment())).collect(),
            place: (!place.is_identity() && !media.densities.is_empty()).then(|| Box::new(*place)),
        }
    }

    /// True if the medium has the same density everywhere.
    pub fn is_homogeneous(&self) -> bool {
        self.densities.is_empty()
    }

    /// Returns the density at a point in world space, for each channel; `dir` is the direction of the ray.
    pub fn density_at(&self, world: DVec3, dir: DVec3, noise: NoiseGenerator, waves: usize) -> Rgb {
        if self.densities.is_empty() {
            return Rgb::ONE;
        }
        let p = self.place.as_ref().map_or(world, |place| place.inverse_transform_point(world));
        let ctx = TextureContext { waves, world, ray: dir, ..TextureContext::without_surface(p, noise) };
        self.densities.iter().map(|density| density.color_at(&ctx).rgb).product()
    }
}
