//! `normal { … }` of a camera: rays are turned as the normal of a bumpy surface (manual, "Camera Ray Perturbation").

use crate::math::noise::NoiseGenerator;
use crate::math::{DVec2, Ray};
use crate::pattern::TextureContext;
use crate::texture::{Normal, NormalProgram};
use serde::Serialize;
use std::sync::Arc;

/// Perturbation of camera rays by a lowered `normal`, with the scene's settings for patterns.
#[derive(Clone, Debug, Serialize)]
pub struct Bumps {
    program: Arc<NormalProgram>,
    noise: NoiseGenerator,
    waves: usize,
}

impl Bumps {
    /// Lowers a camera's `normal`; `noise` and `waves` are the scene's settings.
    pub(super) fn new(normal: &Normal, noise: NoiseGenerator, waves: usize) -> Self {
        Self { program: Arc::new(NormalProgram::new(normal)), noise, waves }
    }

    /// Returns the camera ray whose direction is the perturbed normal at a position of the picture: from -½ to ½ to the
    /// right and up for flat cameras, angles and lengths of the formula for others (quirk: `camera_normal_position`).
    pub(super) fn perturb_ray(&self, ray: Ray, bump_position: DVec2) -> Ray {
        let ctx = TextureContext {
            waves: self.waves,
            ..TextureContext::without_surface(bump_position.extend(0.0), self.noise)
        };
        Ray::new(ray.origin, self.program.perturb(&ctx, ray.dir).normalize_or(ray.dir))
    }
}
