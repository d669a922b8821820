//! The path of a photon from a light over a target to the surfaces and media that store the photon.

use super::super::context::interiors_around;
use super::super::interface::{Interface, Interiors, copy_interiors};
use super::super::radiance::Radiance;
use super::super::ray_state::{MAX_SURFACES, RayState};
use super::super::scatter::Boundary;
use super::super::segment::{ShadowSegments, Span};
use super::super::shading_point::ShadingPoint;
use super::super::tracer::Tracer;
use super::emission::{Emitted, Job, Source, photon_power_per_measure};
use super::gather::reflects_photons;
use super::map::Photon;
use super::{PhotonPass, PhotonShard, Ring};
use crate::color::Rgb;
use crate::math::{Range, Ray};
use crate::world::{LightSource, Medium, World};
use std::cell::Cell;

/// A photon in flight.
struct Flight {
    state: RayState,
    /// Length of the photon's path since its emission, in world units.
    distance: f64,
    /// True once the photon has hit the target at which it was emitted.
    has_hit_target: bool,
}

/// The pass, the light and the target of the photons that are being traced.
struct Beam<'a, 'w> {
    pass: &'a PhotonPass,
    source: &'a Source,
    light: &'w LightSource,
}

impl Beam<'_, '_> {
    /// True if photons pass the object on their way to the target (`pass_through`).
    fn passes(&self, world: &World, object: u32) -> bool {
        let settings = &world.photons[world.objects[object as usize].photons as usize];
        object != self.source.target && settings.pass_through == Some(true)
    }
}

impl<'w> Tracer<'w> {
    /// Emits and traces the photons of a job; `None` if the tracer was cancelled. The tracer then has the limits of
    /// photons, and cannot trace camera rays.
    pub fn shoot_photons(&mut self, pass: &PhotonPass, job: &Job) -> Option<PhotonShard> {
        let source = &pass.plan.sources[job.source];
        let world = self.context.world;
        self.max_trace_level = pass.settings.max_trace_level.unwrap_or(world.max_trace_level);
        self.adc_bailout = pass.settings.adc_bailout.unwrap_or(world.adc_bailout);
        self.traces_photons = true;
        let beam = Beam { pass, source, light: &world.lights[source.light as usize] };
        let inside = match self.context.tracks_interiors {
            true => interiors_around(world, beam.light.emitter.location),
            false => Interiors::new(),
        };
        let mut shard = PhotonShard { source: job.source, rings: vec![] };
        for number in job.rings.clone() {
            let mut ring = Ring { number, hits_target: false, surface: vec![], media: vec![] };
            for i in 0..source.n_in_ring(number) {
                self.begin_sample(u64::from(number), u64::from(i));
                if self.is_stopped() {
                    return None;
                }
                self.trace_photon(&beam, &source.emit(number, i), copy_interiors(&inside), &mut ring);
            }
            shard.rings.push(ring);
        }
        Some(shard)
    }

    /// Traces one photon and all photons into which surfaces split it.
    fn trace_photon(&mut self, beam: &Beam<'_, 'w>, emitted: &Emitted, inside: Interiors, ring: &mut Ring) {
        let state = RayState { throughput: Rgb::splat(emitted.measure), ..RayState::camera(emitted.ray, inside) };
        let mut flights = vec![Flight { state, distance: 0.0, has_hit_target: false }];
        while let Some(flight) = flights.pop() {
            if self.count_surface_and_is_stopped() {
                return;
            }
            if flight.state.n_surfaces < MAX_SURFACES {
                self.trace_to_next_surface(beam, flight, &mut flights, ring);
            }
        }
    }

    /// Traces a photon to the next surface, stores the photon there and in media before it, and adds the photons that
    /// continue.
    fn trace_to_next_surface(
        &mut self,
        beam: &Beam<'_, 'w>,
        mut flight: Flight,
        flights: &mut Vec<Flight>,
        ring: &mut Ring,
    ) {
        self.random.next_vertex();
        let (world, source) = (self.context.world, beam.source);
        let range = Range { min: world.epsilon.surface, max: f64::INFINITY };
        let has_passed = Cell::new(false);
        let is_hit = |object: u32| {
            let is_hit = world.objects[object as usize].is_hit_by_photons
                && (flight.has_hit_target || !beam.passes(world, object));
            has_passed.set(has_passed.get() || !is_hit);
            is_hit
        };
        let Some(hit) = world.geometry.closest(&flight.state.ray, range, is_hit) else { return };
        if !flight.has_hit_target {
            // Another object is in front of the target.
            if hit.object != source.target {
                return;
            }
            ring.hits_target = true;
            self.attenuate_before_target(beam, &mut flight.state, hit.t(), has_passed.get());
            if flight.state.throughput == Rgb::ZERO {
                return;
            }
        } else if beam.pass.settings.media_steps > 0 {
            self.store_in_media(beam, &flight, hit.t(), ring);
        }
        // Air and media on the way
        let segments = ShadowSegments {
            distance: hit.t(),
            has_air: beam.light.emitter.attenuated && self.has_air(),
            has_media: self.has_media(),
            scene_media_in_solids: false,
        };
        let ray = flight.state.ray;
        let transmittance =
            self.shadow_span_transmittance(&ray, &Span::from_origin(hit.t()), &flight.state.inside, &segments);
        flight.state.throughput *= transmittance;
        flight.distance += hit.t();
        // Store the photon
        let interface = self.interface(&flight.state, &hit);
        let surface = hit.surface(&ray);
        let shading = ShadingPoint::new(world, &ray, (&hit, &surface), &self.context.quality, &interface);
        if flight.has_hit_target && stores_photons(&shading) {
            let flux = flight.state.throughput * photon_power_per_measure(source, beam.light, flight.distance);
            ring.surface.push(Photon::new(shading.point, flux, ray.dir));
        }
        // Photons that continue; all are attenuated (the quirk `attenuation_beyond_surface` is one of camera rays)
        if world.colors_light && interface.leaves_interior() {
            flight.state.throughput *= self.interior_transmittance(shading.part.interior, hit.t());
        }
        let continues = world.photon_refracts_and_reflects(beam.light, world.objects[hit.object as usize].photons);
        self.add_continued(flight, &shading, &interface, continues, flights);
    }

    /// Multiplies the throughput of a photon, which hits its target at a distance from the light, by the share of the light's
    /// beam, and by the transmittance of objects that it has passed if `has_passed`; updates its interiors.
    fn attenuate_before_target(&mut self, beam: &Beam<'_, 'w>, state: &mut RayState, distance: f64, has_passed: bool) {
        let (world, ray) = (self.context.world, state.ray);
        state.throughput *= beam.light.emitter.beam_share_at(ray.at(distance), -ray.dir, distance);
        if !has_passed || state.throughput == Rgb::ZERO {
            return;
        }
        // quirk: pass_through_transparent
        let filters = |object| world.objects[object as usize].is_hit_by_photons && beam.passes(world, object);
        state.throughput *= self.transmittance_of_surfaces(&ray, distance, filters);
        // The target can be inside of an object that the photon has passed.
        if self.context.tracks_interiors {
            state.inside = interiors_around(world, ray.at(distance - world.epsilon.surface));
        }
    }

    /// Adds the photons that continue from a surface which refracts photons or not, and reflects them or not.
    fn add_continued(
        &mut self,
        Flight { mut state, distance, .. }: Flight,
        shading: &ShadingPoint<'w>,
        interface: &Interface,
        [refracts, reflects]: [bool; 2],
        flights: &mut Vec<Flight>,
    ) {
        if !refracts && !reflects {
            return;
        }
        let dir = state.ray.dir;
        let is_total = shading.materials.iter().any(|material| interface.refract(dir, material.normal).is_none());
        (state.is_reflected, state.has_transmitted) = (false, false);
        let pending = self.queue.len();
        let mut unused = Radiance::ZERO;
        self.scatter(&state, &Boundary { shading, interface, attenuation: Rgb::ONE }, &mut unused);
        for mut next in self.queue.drain(pending..) {
            let is_allowed = if next.has_transmitted {
                // (quirk: `straight_ray_keeps_level` is one of camera rays.)
                next.level = state.level + 1;
                refracts
            } else if is_total {
                reflects || refracts
            } else {
                // quirk: photon_weight_of_reflection
                next.weight *= next.weight / state.weight;
                reflects && next.weight > self.adc_bailout
            };
            if is_allowed && next.throughput != Rgb::ZERO {
                flights.push(Flight { state: next, distance, has_hit_target: true });
            }
        }
    }

    /// Stores photons along a stretch of the ray, at points where a medium that collects photons has a density; none
    /// inside a solid that is not hollow.
    fn store_in_media(&mut self, beam: &Beam, flight: &Flight, length: f64, ring: &mut Ring) {
        let (world, state) = (self.context.world, &flight.state);
        if !self.context.quality.atmosphere || !length.is_finite() || self.has_filled_interior(&state.inside) {
            return;
        }
        let of_interior = |i: &u32| world.media.get(i).into_iter().flat_map(|media| media.iter());
        let media: Vec<&Medium> =
            world.air.iter().chain(state.inside.iter().flat_map(of_interior)).filter(|m| m.collects_photons).collect();
        if media.is_empty() {
            return;
        }
        // Spacing of the photons, which diverge from the light
        let settings = &beam.pass.settings;
        let spread = if beam.source.is_cone() { flight.distance / beam.source.distance.max(1e-9) } else { 1.0 };
        let step = beam.source.spacing * settings.media_factor * spread.max(1e-9);
        let n = (length / step).ceil().clamp(1.0, f64::from(settings.media_steps)) as u32;
        let step = length / f64::from(n);
        // quirk: photons_diverge_in_media
        let flux_step = |t: f64| if beam.source.is_cone() { step * (1.0 + t / flight.distance) } else { step };
        let random = self.random.sequence(super::super::random::Purpose::Media);
        let segments =
            ShadowSegments { distance: length, has_air: false, has_media: true, scene_media_in_solids: false };
        let ray: Ray = state.ray;
        let (mut from, mut transmittance) = (0.0, Rgb::ONE);
        for i in 0..n {
            let t = (f64::from(i) + random.at(u64::from(i))) * step;
            transmittance *= self.shadow_span_transmittance(&ray, &Span::new(from, t), &state.inside, &segments);
            from = t;
            let p = ray.at(t);
            let is_there = |medium: &&Medium| medium.density_at(p, ray.dir, world.noise, world.waves) != Rgb::ZERO;
            if media.iter().any(is_there) {
                let flux = state.throughput
                    * transmittance
                    * photon_power_per_measure(beam.source, beam.light, flight.distance + t);
                ring.media.push(Photon::new(p, flux * flux_step(t), ray.dir));
            }
        }
    }
}

/// True if the surface stores photons. (Objects of a `light_group` store photons of all lights that emit any; quirk:
/// `photons_of_global_lights`.)
fn stores_photons(shading: &ShadingPoint) -> bool {
    shading.part.collects_photons && shading.layers().any(|shaded| reflects_photons(shaded))
}
