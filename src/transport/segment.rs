//! Radiance and transmittance along ray segments in fog and interiors, for camera and shadow rays.

use super::interface::Interiors;
use super::random::Purpose;
use super::tracer::Tracer;
use crate::atmosphere::{self, Segment};
use crate::color::Rgb;
use crate::math::Ray;

/// A stretch of a ray, in distances from its origin.
pub(super) struct Span {
    from: f64,
    to: f64,
}

impl Span {
    /// Creates the span between two distances.
    pub fn new(from: f64, to: f64) -> Self {
        Self { from, to }
    }

    /// Creates the span from the ray's origin to a distance.
    pub fn from_origin(to: f64) -> Self {
        Self { from: 0.0, to }
    }
}

impl Tracer<'_> {
    /// Returns the radiance added and the transmittance of the air along a span of a ray of length 1. Solid (not
    /// `hollow`) interiors hold no air (quirk: `fog_needs_hollow`).
    #[inline]
    pub(super) fn segment(&mut self, ray: &Ray, span: &Span, inside: &Interiors) -> Segment {
        if self.has_air() { self.air(ray, span, inside) } else { Segment::NONE }
    }

    fn air(&mut self, ray: &Ray, span: &Span, inside: &Interiors) -> Segment {
        let world = self.context.world;
        if inside.iter().any(|&i| world.filled[i as usize]) {
            return Segment::NONE;
        }
        let start = if span.from == 0.0 { *ray } else { Ray::new(ray.at(span.from), ray.dir) };
        let length = span.to - span.from;
        let fogs = atmosphere::combine_fogs(&world.fogs, &start, length, world.noise);
        let random = &mut self.random;
        fogs.in_front_of(atmosphere::combine_rainbows(&world.rainbows, &start, length, &mut || {
            random.next(Purpose::Rainbow)
        }))
    }

    /// True if the scene has fog or a rainbow, and the quality shows it.
    pub(super) fn has_air(&self) -> bool {
        let world = self.context.world;
        self.context.quality.atmosphere && (!world.fogs.is_empty() || !world.rainbows.is_empty())
    }

    /// Returns the transmittance of an interior over the segment at whose end the ray leaves it. The transmittance
    /// applies to light from beyond that surface, not to light of the surface itself (quirk:
    /// `attenuation_beyond_surface`).
    pub(super) fn attenuation(&self, interior: u32, length: f64) -> Rgb {
        self.context.world.interiors[interior as usize].attenuation(length)
    }

    /// Returns the transmittance of an interior for a shadow ray, which a `fade_power` of 0 does not attenuate (quirk:
    /// `fade_power_0_shadow`).
    pub(super) fn shadow_attenuation(&self, interior: u32, length: f64) -> Rgb {
        let interior = &self.context.world.interiors[interior as usize];
        if interior.fade_power > 0.0 { interior.attenuation(length) } else { Rgb::ONE }
    }
}
