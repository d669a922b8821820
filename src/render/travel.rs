//! What lies between two surfaces: the one place where light changes on its way, towards the eye or from a light.

use super::refract::Interiors;
use super::trace::Tracer;
use crate::atmosphere::{self, Veil};
use crate::color::Rgb;
use crate::math::Ray;

impl Tracer<'_> {
    /// What the air does to light that comes towards a ray's origin from as far as `length`. There is none inside of what is not hollow,
    /// nor at low quality; and shadows know nothing of it (all measured on POV-Ray 3.7).
    pub(super) fn veil(&mut self, ray: &Ray, length: f64, inside: &Interiors) -> Veil {
        let world = self.setup.world;
        let hazy = !world.fogs.is_empty() || !world.rainbows.is_empty();
        if !hazy || !self.setup.quality.air || inside.iter().any(|&i| world.filled[i as usize]) {
            return Veil::NONE;
        }
        let fogs = atmosphere::fogs(&world.fogs, ray, length, world.noise);
        fogs.before(atmosphere::rainbows(&world.rainbows, ray, length, &mut || self.random()))
    }

    /// What is left of light that goes so far inside of what fills something.
    pub(super) fn faded(&self, interior: u32, length: f64) -> Rgb {
        self.setup.world.interiors[interior as usize].fade(length)
    }
}
