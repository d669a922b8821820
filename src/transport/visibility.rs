//! Shadow rays: the share of a light's radiance that arrives at a surface.

use super::interface::{Interface, Interiors, copy_interiors};
use super::photons::{self, Photons};
use super::random::Purpose;
use super::segment::{ShadowSegments, Span};
use super::shading_point::{self, ShadingPoint};
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::{Area, LightSample};
use crate::math::packet::{Flags, Numbers, RayPacket, Vectors, set_lanes};
use crate::math::{DVec3, Lanes, Range, Ray};
use crate::shape::Kernel;
use crate::world::{Intersection, Intersections, LightFilters, LightSource, World};

/// A ray from a surface to a light.
struct ShadowRay<'a> {
    light: &'a LightSource,
    ray: &'a Ray,
    /// Distances between which objects occlude the light.
    range: Range,
    /// Distance of the light from the surface.
    distance: f64,
}

impl Tracer<'_> {
    /// Returns the grid of lights of an `area_light`; `None` for a light that is one point, as all lights are at low quality
    /// levels and to rays after diffuse bounces (quirk: `area_light_in_radiosity`).
    #[inline]
    pub(super) fn light_grid<'a>(&self, light: &'a LightSource, bounces: u8) -> Option<&'a Area> {
        light.emitter.area.as_ref().filter(|_| bounces == 0 && self.context.quality.area_lights)
    }

    /// Returns the visibility of a light from a point, per channel: 0 in full shadow, 1 without any occluder. `inside`
    /// lists the interiors that contain the point; `sample` is that of the light's centre; `bounces` is the number of
    /// diffuse bounces between camera and point.
    #[inline]
    pub(super) fn visibility(
        &mut self,
        light: &LightSource,
        point: DVec3,
        sample: &LightSample,
        inside: &Interiors,
        bounces: u8,
    ) -> Rgb {
        match self.light_grid(light, bounces) {
            Some(area) => {
                let random = self.random.sequence(Purpose::AreaLight);
                self.area_visibility((light, area), point, sample, inside, random)
            }
            None => self.visibility_along_ray(light, &Ray::new(point, sample.to_light), sample.distance, inside),
        }
    }

    /// Returns the visibility along one shadow ray to a light at a distance, per channel.
    pub(super) fn visibility_along_ray(
        &mut self,
        light: &LightSource,
        ray: &Ray,
        distance: f64,
        inside: &Interiors,
    ) -> Rgb {
        let epsilon = self.context.world.epsilon.shadow;
        let mut range = Range { min: epsilon, max: distance - epsilon };
        if let Some(projector) = light.through.as_ref().filter(|_| self.context.quality.shadows) {
            let Some(hit) = projector.closest(ray, range, |_| true) else { return Rgb::ZERO };
            // Objects between the projector and the light do not occlude, air does (quirk: `projected_through_range`).
            range.max = hit.t();
        }
        if light.emitter.shadowless || !self.context.quality.shadows || range.max <= range.min {
            return Rgb::ONE;
        }
        self.counts.shadow += 1;
        self.transmittance(&ShadowRay { light, ray, range, distance }, inside)
    }

    /// Returns for which of the shadow rays `counts` of a packet, each to a point of the light at the distance `distance`, that point
    /// is visible at all; and the share that is visible, per channel. Both are those of [`Self::visibility_along_ray`], for lights and
    /// scenes that are [lit in packets](Self::lights_packets). `inside` returns the interiors that contain the origin of a ray.
    pub(super) fn visibility_along_rays(
        &mut self,
        light: &LightSource,
        (rays, distance): (&RayPacket, &Numbers),
        counts: Flags,
        inside: impl Fn(usize) -> Interiors,
    ) -> (Flags, Vectors) {
        let world = self.context.world;
        let mut share = Vectors::splat(Rgb::ONE);
        let epsilon = world.epsilon.shadow;
        let max = *distance - epsilon;
        let casts_shadows = !light.emitter.shadowless && self.context.quality.shadows;
        let has_ray = counts & Lanes::splat(epsilon).less_than(max);
        if !casts_shadows || !has_ray.any() {
            return (counts, share);
        }
        let role = |id: u32| world.shadow_role(id);
        let hints = (&mut self.occluders[light.number], &mut self.shadow_coherence);
        let occlusion = world.geometry.occlusion_of_packet(rays, has_ray, (epsilon, &max), role, hints);
        self.counts.shadow += u64::from((has_ray & !occlusion.may_be_filtered).bits().count_ones());
        for i in set_lanes(occlusion.may_be_filtered.bits()) {
            let transmitted = self.visibility_along_ray(light, &rays.ray(i), distance.0[i], &inside(i));
            share.set_lane(i, transmitted);
        }
        (counts & !occlusion.occluded & !share.is_zero(), share)
    }

    /// True if photons replace the light that an object on the shadow ray transmits. (Not inlined: shadow rays of scenes
    /// without photons are faster without this code.)
    #[inline(never)]
    fn is_replaced_by_photons(&self, shadow: &ShadowRay) -> bool {
        if self.targets_transmit_light || self.context.photons.as_ref().is_none_or(Photons::is_empty) {
            return false;
        }
        let world = self.context.world;
        let replaces = |id: u32| {
            let object = &world.objects[id as usize];
            object.is_hit_by_photons && photons::photons_replace_transmitted(world, shadow.light, object.photons)
        };
        world.geometry.any(shadow.ray, shadow.range, replaces)
    }

    /// Returns the product of the transmittances of all surfaces and segments along a shadow ray. A solid has two
    /// surfaces, and both attenuate.
    fn transmittance(&mut self, shadow: &ShadowRay, inside: &Interiors) -> Rgb {
        let ShadowRay { light, ray, range, distance } = *shadow;
        let world = self.context.world;
        let use_quick_color = !self.context.quality.pigments;
        // The search for an opaque occluder ends at its first hit. Without a hit, it has come by all objects whose boxes the
        // ray intersects, and knows which of them may filter the light.
        let role = |id: u32| world.shadow_role(id);
        let occluder = &mut self.occluders[light.number];
        let Some(filters) = world.geometry.filters_unless_occluded(ray, range, role, occluder) else {
            return Rgb::ZERO;
        };
        if self.context.photons.is_some() && self.is_replaced_by_photons(shadow) {
            return Rgb::ZERO;
        }
        // Air attenuates only light with `media_attenuation` (quirk: `fog_and_shadows`).
        let has_air = light.emitter.attenuated && self.has_air();
        let has_media = self.has_media();
        if filters.is_empty() && !has_air && !has_media {
            return Rgb::ONE;
        }
        let mut surfaces = Intersections::new();
        if !filters.is_empty() {
            add_filtering_surfaces(world, ray, range, &filters, &mut surfaces);
        }
        if world.colors_light || has_air || has_media {
            let segments = ShadowSegments { distance, has_air, has_media, scene_media_in_solids: true };
            return self.segmented_transmittance(ray, &surfaces, copy_interiors(inside), segments);
        }
        let mut transmittance = Rgb::ONE;
        for hit in &surfaces {
            transmittance *= shading_point::shadow_transmittance(world, ray, hit, use_quick_color);
        }
        transmittance
    }

    /// Returns the product of the transmittances of all surfaces along a ray up to a distance, without interiors. Objects for which
    /// `filters` is false count as absent.
    pub(super) fn transmittance_of_surfaces(&self, ray: &Ray, distance: f64, filters: impl Fn(u32) -> bool) -> Rgb {
        let world = self.context.world;
        let mut transmittance = Rgb::ONE;
        let mut range = Range { min: world.epsilon.shadow, max: distance };
        while transmittance != Rgb::ZERO {
            let Some(hit) = world.geometry.closest(ray, range, &filters) else { break };
            transmittance *= shading_point::shadow_transmittance(world, ray, &hit, !self.context.quality.pigments);
            range.min = hit.t() + world.epsilon.shadow;
            // Far away, a step can be smaller than the rounding error of the distance.
            if range.min <= hit.t() {
                break;
            }
        }
        transmittance
    }

    /// Returns the transmittance along a shadow ray if air or interiors attenuate light: multiplies segment by segment,
    /// from the nearest surface to the farthest.
    fn segmented_transmittance(
        &mut self,
        ray: &Ray,
        surfaces: &[Intersection],
        mut inside: Interiors,
        segments: ShadowSegments,
    ) -> Rgb {
        let (mut transmittance, mut from) = (Rgb::ONE, 0.0);
        for hit in surfaces {
            transmittance *= self.shadow_span_transmittance(ray, &Span::new(from, hit.t()), &inside, &segments);
            transmittance *= self.transmittance_crossing_surface(ray, hit, from, &mut inside);
            from = hit.t();
        }
        // Media of interiors end at surfaces: a light inside of a medium is not attenuated (quirk: `light_inside_media`).
        let last = ShadowSegments { has_media: false, scene_media_in_solids: false, ..segments };
        transmittance * self.shadow_span_transmittance(ray, &Span::new(from, last.distance), &inside, &last)
    }

    /// Returns the transmittance of a surface, with caustics, and of the interior that the ray leaves at the surface;
    /// `segment_start` is the distance of the surface before. Updates the list `inside`.
    fn transmittance_crossing_surface(
        &mut self,
        ray: &Ray,
        hit: &Intersection,
        segment_start: f64,
        inside: &mut Interiors,
    ) -> Rgb {
        let world = self.context.world;
        let mut transmittance = shading_point::shadow_transmittance(world, ray, hit, !self.context.quality.pigments);
        if !self.context.tracks_interiors {
            return transmittance;
        }
        let own = world.parts[hit.part_number() as usize].interior;
        let interior = &world.interiors[own as usize];
        if let Some(at) = inside.iter().rposition(|&i| i == own) {
            inside.remove(at);
            transmittance *= self.shadow_interior_transmittance(own, hit.t() - segment_start);
        } else {
            inside.push(own);
        }
        if interior.caustics != 0.0 {
            let surface = hit.surface(ray);
            let shading = ShadingPoint::new(world, ray, (hit, &surface), &self.context.quality, &Interface::NONE);
            let normal = shading.materials.last().map_or(shading.smooth, |material| material.normal);
            transmittance *= interior.caustic_factor(normal.dot(ray.dir).abs());
        }
        transmittance
    }
}

/// Adds the transparent surfaces along a shadow ray to the empty list `surfaces`, from the nearest to the farthest. A surface
/// closer to the one before than the minimum distance is skipped: a thinner box filters once, and so does the edge of its
/// shadow (quirk: `shadow_min_distance`).
fn add_filtering_surfaces<'w>(
    world: &'w World,
    ray: &Ray,
    range: Range,
    filters: &LightFilters,
    surfaces: &mut Intersections<'w>,
) {
    if world.restarts_shadow_rays {
        return add_surfaces_one_by_one(world, ray, range, surfaces);
    }
    world.geometry.add_hits_on_filters(filters, ray, range, surfaces);
    surfaces.sort_by(|a, b| a.t().total_cmp(&b.t()));
    let (mut last, epsilon) = (f64::NEG_INFINITY, &world.epsilon);
    surfaces.retain(|hit| {
        let counts =
            hit.t() - last > epsilon.shadow.max(epsilon.reduced_for_tiny_scene(hit.leaf.shape.quirks().min_distance));
        if counts {
            last = hit.t();
        }
        counts
    });
}

/// Adds the same surfaces as [`add_filtering_surfaces`], but each is found by a ray that starts at the surface before (quirk:
/// `isosurface_csg_shadows`).
fn add_surfaces_one_by_one<'w>(world: &'w World, ray: &Ray, range: Range, surfaces: &mut Intersections<'w>) {
    let filters = |id: u32| {
        let object = &world.objects[id as usize];
        object.shadow && !object.opaque
    };
    let (mut onward, mut left, mut start) = (*ray, range, 0.0);
    while let Some(mut hit) = world.geometry.closest(&onward, left, filters) {
        hit.hit.t += start;
        // Far away, a step can be smaller than the rounding error of the distance.
        if hit.t() <= start {
            break;
        }
        start = hit.t();
        surfaces.push(hit);
        onward.origin = ray.at(start);
        left = Range { min: world.epsilon.shadow, max: range.max - start };
    }
}
