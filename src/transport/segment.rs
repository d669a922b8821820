//! Radiance and transmittance along ray segments in fog and interiors, for camera and shadow rays.

use super::interface::Interiors;
use super::media::MediaStretch;
use super::random::Purpose;
use super::ray_state::RayState;
use super::tracer::Tracer;
use crate::atmosphere::{self, Segment};
use crate::color::Rgb;
use crate::math::Ray;
use crate::world::Medium;
use smallvec::SmallVec;

/// A stretch of a ray, in distances from its origin.
pub(super) struct Span {
    pub from: f64,
    pub to: f64,
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

/// Interiors and lights of a segment of a ray, and whether the ray is a shadow ray.
pub(super) struct SegmentContext<'a> {
    /// Interiors that contain the segment.
    pub inside: &'a Interiors,
    /// Number of the set of lights that media scatter, an index in [`crate::world::World::lit_by`]: the set of the surface
    /// at the segment's end, 0 without a surface (quirk: `media_lights`).
    pub light_set: u32,
    /// Number of diffuse bounces between the camera and the segment.
    pub bounces: u8,
    /// True for a shadow ray, for which the transmittance alone counts.
    pub is_shadow: bool,
}

/// Properties of the segments of one shadow ray.
pub(super) struct ShadowSegments {
    /// Distance of the light from the start of the shadow ray, in world units.
    pub distance: f64,
    /// True if fog, rainbows and media of the whole scene attenuate the light.
    pub has_air: bool,
    /// True if the scene has interiors with media.
    pub has_media: bool,
    /// True if media of the whole scene attenuate the light in solid interiors, too (quirk: `media_in_solid_shadow`).
    pub scene_media_in_solids: bool,
}

impl<'w> Tracer<'w> {
    /// Returns the radiance added and the transmittance of air and media along a span of a ray with a normalized direction.
    /// Solid (not `hollow`) interiors hold no air and no media (quirk: `fog_needs_hollow`).
    #[inline]
    pub(super) fn segment(&mut self, state: &RayState, span: &Span, light_set: u32) -> Segment {
        let RayState { ray, inside, bounces, .. } = state;
        let (has_air, has_media) = (self.has_air(), self.has_media());
        if self.has_filled_interior(inside) {
            return Segment::NONE;
        }
        let context = SegmentContext { inside, light_set, bounces: *bounces, is_shadow: false };
        let air = if has_air { self.air_segment(ray, span, &context) } else { Segment::NONE };
        if has_media { air.in_front_of(self.interior_media_segment(ray, span, &context)) } else { air }
    }

    /// Returns the radiance added and the transmittance along a ray without a hit, whose direction has length 1. Media
    /// of interiors around the ray do not count (quirk: `endless_media`).
    pub(super) fn endless_segment(&mut self, state: &RayState) -> Segment {
        let RayState { ray, inside, bounces, .. } = state;
        if !self.has_air() || self.has_filled_interior(inside) {
            return Segment::NONE;
        }
        let context = SegmentContext { inside, light_set: 0, bounces: *bounces, is_shadow: false };
        self.air_segment(ray, &Span::from_origin(Segment::FAR), &context)
    }

    /// Returns the transmittance of air and media along a span of a shadow ray.
    pub(super) fn shadow_span_transmittance(
        &mut self,
        ray: &Ray,
        span: &Span,
        inside: &Interiors,
        segments: &ShadowSegments,
    ) -> Rgb {
        if !segments.has_air && !segments.has_media {
            return Rgb::ONE;
        }
        let context = SegmentContext { inside, light_set: 0, bounces: 0, is_shadow: true };
        if self.has_filled_interior(inside) {
            let attenuates = segments.has_air && segments.scene_media_in_solids;
            return if attenuates { self.air_media_segment(ray, span, &context).transmittance } else { Rgb::ONE };
        }
        let mut transmittance = Rgb::ONE;
        if segments.has_air {
            transmittance *= self.air_segment(ray, span, &context).transmittance;
        }
        if segments.has_media {
            transmittance *= self.interior_media_segment(ray, span, &context).transmittance;
        }
        transmittance
    }

    /// True if any interior of the list is not hollow, so that neither air nor media are inside.
    pub(super) fn has_filled_interior(&self, inside: &Interiors) -> bool {
        let world = self.context.world;
        inside.iter().any(|&i| world.filled[i as usize])
    }

    /// Returns the segment of fogs, rainbows and media of the whole scene; fogs are in front of media, and rainbows behind
    /// both (quirk: `media_in_front`).
    fn air_segment(&mut self, ray: &Ray, span: &Span, context: &SegmentContext) -> Segment {
        let world = self.context.world;
        let start = if span.from == 0.0 { *ray } else { Ray::new(ray.at(span.from), ray.dir) };
        let length = span.to - span.from;
        let mut air = Segment::NONE;
        if !world.fogs.is_empty() {
            air = atmosphere::combine_fogs_adding_radiance(&world.fogs, &start, length, world.noise);
        }
        air = air.in_front_of(self.air_media_segment(ray, span, context));
        if !world.rainbows.is_empty() {
            let random = &mut self.random;
            air = air.in_front_of(atmosphere::average_rainbows(&world.rainbows, &start, length, &mut || {
                random.next(Purpose::Rainbow)
            }));
        }
        air
    }

    /// Returns the segment of the media of the whole scene.
    fn air_media_segment(&mut self, ray: &Ray, span: &Span, context: &SegmentContext) -> Segment {
        let world = self.context.world;
        if world.air.is_empty() || span.to <= span.from {
            return Segment::NONE;
        }
        let media: SmallVec<[&Medium; 4]> = world.air.iter().collect();
        self.media_segment(&MediaStretch::new(ray, span, &media, context))
    }

    /// Returns the segment of the media of all interiors in the list.
    fn interior_media_segment(&mut self, ray: &Ray, span: &Span, context: &SegmentContext) -> Segment {
        let world = self.context.world;
        // (Loops: collecting an iterator of iterators took 3 % of a scene with media.)
        let mut media = SmallVec::<[&Medium; 4]>::new();
        for own in context.inside.iter().filter_map(|i| world.media.get(i)) {
            for medium in own {
                media.push(medium);
            }
        }
        if media.is_empty() || span.to <= span.from {
            return Segment::NONE;
        }
        self.media_segment(&MediaStretch::new(ray, span, &media, context))
    }

    /// True if the scene has fog, rainbows or media without an object, and the quality shows them.
    pub(super) fn has_air(&self) -> bool {
        self.context.quality.atmosphere && self.context.world.has_air()
    }

    /// True if the scene has interiors with media, and the quality shows them.
    pub(super) fn has_media(&self) -> bool {
        self.context.quality.atmosphere && !self.context.world.media.is_empty()
    }

    /// Returns the transmittance of an interior, without its media, over the segment at whose end the ray leaves it.
    /// The transmittance applies to light from beyond that surface, not to light of the surface itself (quirk:
    /// `attenuation_beyond_surface`).
    pub(super) fn interior_transmittance(&self, interior: u32, length: f64) -> Rgb {
        self.context.world.interiors[interior as usize].fade_transmittance(length)
    }

    /// Returns the transmittance of an interior, without its media, for a shadow ray, which a `fade_power` of 0 does
    /// not attenuate (quirk: `fade_power_0_shadow`).
    pub(super) fn shadow_interior_transmittance(&self, interior: u32, length: f64) -> Rgb {
        let interior = &self.context.world.interiors[interior as usize];
        if interior.fade_power > 0.0 { interior.fade_transmittance(length) } else { Rgb::ONE }
    }
}
