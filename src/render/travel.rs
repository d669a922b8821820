//! What lies between two surfaces: the one place where light changes on its way, towards the eye or from a light.

use super::random::Purpose;
use super::refract::Interiors;
use super::trace::Tracer;
use crate::atmosphere::{self, Segment};
use crate::color::Rgb;
use crate::math::Ray;

impl Tracer<'_> {
    /// What the air does to light that comes towards a ray's origin from as far as `length`. There is none inside of what is not hollow,
    /// nor at low quality; and shadows know nothing of it, but for lights that are said to (all measured on POV-Ray 3.7).
    #[inline]
    pub(super) fn veil(&mut self, ray: &Ray, length: f64, inside: &Interiors) -> Segment {
        if self.is_hazy() { self.veil_of_air(ray, length, inside) } else { Segment::NONE }
    }

    fn veil_of_air(&mut self, ray: &Ray, length: f64, inside: &Interiors) -> Segment {
        let world = self.setup.world;
        if inside.iter().any(|&i| world.filled[i as usize]) {
            return Segment::NONE;
        }
        let fogs = atmosphere::fogs(&world.fogs, ray, length, world.noise);
        let random = &mut self.random;
        fogs.before(atmosphere::rainbows(&world.rainbows, ray, length, &mut || random.next(Purpose::Rainbow)))
    }

    /// Is there anything in the air?
    pub(super) fn is_hazy(&self) -> bool {
        let world = self.setup.world;
        self.setup.quality.air && (!world.fogs.is_empty() || !world.rainbows.is_empty())
    }

    /// What is left of light that goes so far inside of what fills something.
    pub(super) fn faded(&self, interior: u32, length: f64) -> Rgb {
        self.setup.world.interiors[interior as usize].fade(length)
    }

    /// The same of a shadow: a `fade_power` of 0, which halves what is seen, takes nothing from it (measured on POV-Ray 3.7).
    pub(super) fn shaded(&self, interior: u32, length: f64) -> Rgb {
        let interior = &self.setup.world.interiors[interior as usize];
        if interior.fade_power > 0.0 { interior.fade(length) } else { Rgb::ONE }
    }
}
