//! The path of a photon from a light over a target to the surfaces and media that store the photon.

use super::super::context::interiors_around;
use super::super::interface::{Interiors, copy_interiors};
use super::super::radiance::Radiance;
use super::super::ray_state::{MAX_SURFACES, RayState};
use super::super::scatter::Boundary;
use super::super::segment::{ShadowSegments, Span};
use super::super::shading_point::ShadingPoint;
use super::super::tracer::Tracer;
use super::emission::{Emitted, Job, Source, photon_power_per_measure};
use super::map::Photon;
use super::{PhotonPass, PhotonShard, Ring};
use crate::color::Rgb;
use crate::math::{Range, Ray};
use crate::world::{LightSource, Medium};
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
        let settings_of = |object: u32| &world.photons[world.objects[object as usize].photons as usize];
        let has_passed = Cell::new(false);
        let passes = |object: u32| {
            let default = || !world.objects[object as usize].shadow;
            let passes = !flight.has_hit_target
                && object != source.target
                && settings_of(object).pass_through.unwrap_or_else(default);
            has_passed.set(has_passed.get() || passes);
            passes
        };
        let Some(hit) = world.geometry.closest(&flight.state.ray, range, |object| !passes(object)) else { return };
        if !flight.has_hit_target {
            // Another object is in front of the target.
            if hit.object != source.target {
                return;
            }
            ring.hits_target = true;
            let point = flight.state.ray.at(hit.t());
            flight.state.throughput *= beam.light.emitter.beam_share_at(point, -flight.state.ray.dir, hit.t());
            if flight.state.throughput == Rgb::ZERO {
                return;
            }
            // The target can be inside of an object that the photon has passed.
            if has_passed.get() && self.context.tracks_interiors {
                let before = flight.state.ray.at(hit.t() - world.epsilon.surface);
                flight.state.inside = interiors_around(world, before);
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
        let shading = ShadingPoint::new(world, &ray, &hit, &self.context.quality, &interface);
        if flight.has_hit_target && self.stores_photons(beam, &shading) {
            let flux = flight.state.throughput * photon_power_per_measure(source, beam.light, flight.distance);
            ring.surface.push(Photon::new(shading.point, flux, ray.dir));
        }
        // Photons that continue
        let [refracts, reflects] =
            world.photon_refracts_and_reflects(beam.light, world.objects[hit.object as usize].photons);
        if !refracts && !reflects {
            return;
        }
        let attenuation = match world.colors_light && interface.leaves_interior() {
            true => self.interior_transmittance(shading.part.interior, hit.t()),
            false => Rgb::ONE,
        };
        let is_total = shading.materials.iter().any(|m| interface.refract(ray.dir, m.normal).is_none());
        (flight.state.is_reflected, flight.state.has_transmitted) = (false, false);
        let pending = self.queue.len();
        let boundary = Boundary { shading: &shading, interface: &interface, attenuation };
        let mut unused = Radiance::ZERO;
        self.scatter(&flight.state, &boundary, &mut unused);
        let allowed = |state: &RayState| match state.has_transmitted {
            true => refracts,
            false => reflects || (is_total && refracts),
        };
        let continued = self.queue.drain(pending..).filter(|state| allowed(state) && state.throughput != Rgb::ZERO);
        flights.extend(continued.map(|state| Flight { state, distance: flight.distance, has_hit_target: true }));
    }

    /// True if the surface stores photons of the beam's light: the object collects photons, and the surface has a
    /// diffuse part and is lit by the light. The caller checks that the photon has hit a target.
    fn stores_photons(&self, beam: &Beam, shading: &ShadingPoint) -> bool {
        let world = self.context.world;
        let is_lit = || world.lit_by[shading.part.light_set() as usize].contains(&beam.source.light);
        let is_diffuse = || {
            shading.layers().any(|shaded| {
                let finish = &shaded.layer.finish;
                shaded.opacity != 0.0 && (finish.diffuse != 0.0 || finish.diffuse_back != 0.0)
            })
        };
        shading.part.collects_photons && is_diffuse() && is_lit()
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
                ring.media.push(Photon::new(p, flux * step, ray.dir));
            }
        }
    }
}
