//! `normal { … }` of a camera: its rays turn as a surface's normal turns where it is bumpy (manual, "Camera Ray Perturbation").

use crate::math::noise::NoiseGenerator;
use crate::math::{DVec2, Ray};
use crate::pattern::TextureContext;
use crate::texture::{Normal, NormalProgram};
use serde::Serialize;
use std::sync::Arc;

/// A lowered normal, with what patterns want to know of the scene.
#[derive(Clone, Debug, Serialize)]
pub struct Bumps {
    program: Arc<NormalProgram>,
    noise: NoiseGenerator,
    waves: usize,
}

impl Bumps {
    /// Lowers a normal; `noise` and `waves` are the scene's.
    pub(super) fn new(normal: &Normal, noise: NoiseGenerator, waves: usize) -> Self {
        Self { program: Arc::new(NormalProgram::new(normal)), noise, waves }
    }

    /// A ray whose direction is the normal at a place of the picture. For flat cameras that goes from -½ to ½ to the right and up, for
    /// others it is in the angles and lengths of their formulas (measured on POV-Ray 3.7).
    pub(super) fn turn(&self, ray: Ray, place: DVec2) -> Ray {
        let ctx = TextureContext { waves: self.waves, ..TextureContext::free(place.extend(0.0), self.noise) };
        Ray::new(ray.origin, self.program.perturb(&ctx, ray.dir).normalize_or(ray.dir))
    }
}
