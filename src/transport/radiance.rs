//! The loop over ray states: the radiance of one camera ray is the sum over all rays that it spawns.

use super::interface::Interface;
use super::ray_state::{MAX_SURFACES, RayState};
use super::scatter::Boundary;
use super::segment::Span;
use super::shading_point::ShadingPoint;
use super::single_layer::SingleLayerPoint;
use super::tracer::Tracer;
use crate::atmosphere::{Segment, ViewKind};
use crate::color::{Rgb, gray};
use crate::math::{DVec3, Range, Ray};
use crate::world::{HitBuffer, Intersection, RayKind};

/// Light that arrives along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radiance {
    /// Radiance in the scene's colour space (see `assumed_gamma`).
    pub rgb: Rgb,
    /// Transparency of the picture: 1 - alpha.
    pub transparency: f64,
}

impl Radiance {
    /// Result of a camera ray that does not exist: black, and transparent in a picture with alpha (quirk:
    /// `camera_without_ray`).
    pub const NO_RAY: Self = Self { rgb: Rgb::ZERO, transparency: 1.0 };

    pub(super) const ZERO: Self = Self { rgb: Rgb::ZERO, transparency: 0.0 };
}

impl<'w> Tracer<'w> {
    /// Returns the radiance along a camera ray, whose direction has length 1.
    #[inline(always)]
    pub fn camera_radiance(&mut self, ray: Ray) -> Radiance {
        self.counts.camera += 1;
        let inside = self.context.interiors_of_camera_ray(ray.origin);
        self.radiance_times_throughput(RayState::camera(ray, inside))
    }

    /// Returns the radiance along a ray times the throughput of `state`, and the transparency times that of `state`.
    #[inline(always)]
    pub(super) fn radiance_times_throughput(&mut self, state: RayState) -> Radiance {
        let mut sum = Radiance::ZERO;
        self.add_radiance_times_throughput(state, &mut sum);
        sum
    }

    /// Adds the radiance along a ray times the throughput of `state`, and the transparency times that of `state`, to `sum`:
    /// traces the ray and all rays that it spawns, the last spawned first. (The sum is not returned, because the copy of a
    /// returned value can begin only when all of its numbers are stored.)
    pub(super) fn add_radiance_times_throughput(&mut self, mut state: RayState, sum: &mut Radiance) {
        // A nested query leaves the states of the query around it in the queue.
        let pending = self.queue.len();
        while !self.count_surface_and_is_stopped() {
            if state.n_surfaces < MAX_SURFACES && self.trace_and_continues(&mut state, sum) {
                continue;
            }
            if self.queue.len() == pending {
                break;
            }
            let Some(next) = self.queue.pop() else { break };
            state = next;
        }
        self.queue.truncate(pending);
    }

    /// Traces a ray up to its first hit: adds the light of the segment and of the surface to `sum`, and pushes the rays that
    /// continue. True if one ray continues that was not pushed, and `state` is that ray.
    #[inline]
    fn trace_and_continues(&mut self, state: &mut RayState, sum: &mut Radiance) -> bool {
        self.random.next_vertex();
        let mut buffer = HitBuffer::default();
        let hit = self.closest(state, &mut buffer);
        self.shade_and_continues(state, hit, sum)
    }

    /// Adds the radiance along a ray, whose first hit is known, times the throughput of `state` to `sum`; `None` for a ray that
    /// hits nothing.
    #[inline(never)]
    pub(super) fn add_radiance_from_first_hit(
        &mut self,
        mut state: RayState,
        hit: Option<&Intersection<'w>>,
        sum: &mut Radiance,
    ) {
        let pending = self.queue.len();
        self.random.next_vertex();
        if self.count_surface_and_is_stopped() {
            return;
        }
        if self.shade_and_continues(&mut state, hit, sum) {
            self.add_radiance_times_throughput(state, sum);
        }
        while self.queue.len() > pending
            && let Some(next) = self.queue.pop()
        {
            self.add_radiance_times_throughput(next, sum);
        }
    }

    /// Adds the light of the segment up to a ray's hit and of the surface there to `sum`, and pushes the rays that continue. True
    /// if one ray continues that was not pushed, and `state` is that ray.
    #[inline(always)]
    fn shade_and_continues(
        &mut self,
        state: &mut RayState,
        hit: Option<&Intersection<'w>>,
        sum: &mut Radiance,
    ) -> bool {
        let Some(hit) = hit else {
            self.add_background(state, sum);
            return false;
        };
        // Air between the origin and the hit
        let part = &self.context.world.parts[hit.part_number() as usize];
        if let Some(rank) = state.gather_rank
            && !self.apply_importance_and_survives(state, rank, hit)
        {
            return false;
        }
        if self.may_cross_fog_or_media(state) {
            let air = self.segment(state, &Span::from_origin(hit.t()), part.light_set());
            sum.rgb += state.throughput * air.radiance;
            state.attenuate(&air);
        }
        let material = &self.context.world.materials[part.outside.material as usize];
        if part.uncommon.is_none()
            && material.shading.is_plain()
            && self.shows_surfaces_fully
            && let surface = hit.surface(&state.ray)
            && let Some(at) = SingleLayerPoint::on_plain_surface(self.context.world, part, &state.ray, (hit, &surface))
        {
            self.add_light_of_single_layer(state, &at, sum);
            return self.reflect_at_plain_point(state, hit, &at);
        }
        self.shade_general_surface(state, hit, sum)
    }

    /// Adds the light along a ray that hits nothing to `sum`.
    #[inline]
    fn add_background(&mut self, state: &RayState, sum: &mut Radiance) {
        let air = match self.may_cross_fog_or_media(state) {
            true => self.endless_segment(state),
            false => Segment::NONE,
        };
        let all = air.in_front_of(self.background(state.ray.dir, state.is_reflected));
        sum.rgb += state.throughput * all.radiance;
        sum.transparency += state.transparency * gray(all.transmittance);
    }

    /// Adds the light of a surface to `sum`, and pushes the rays that continue. True if one ray continues that was not pushed,
    /// and `state` is that ray. (Not inlined: the loop is faster with the code of plain surfaces alone.)
    #[inline(never)]
    fn shade_general_surface(&mut self, state: &mut RayState, hit: &Intersection<'w>, sum: &mut Radiance) -> bool {
        let part = &self.context.world.parts[hit.part_number() as usize];
        let material = &self.context.world.materials[part.outside.material as usize];
        let interface = self.interface(state, hit);
        if part.uncommon.is_none() && material.is_clear && self.try_pass_clear_surface(state, hit, &interface) {
            return true;
        }
        if part.uncommon.is_none() && self.shows_surfaces_fully && !self.context.world.disperses {
            if material.is_single_layer {
                return self.shade_single_layer(state, hit, &interface, sum);
            }
            if material.selects_single_layers
                && let Some(continues) = self.shade_selected_layer(state, hit, &interface, sum)
            {
                return continues;
            }
        }
        // Light that the surface itself sends
        let quality = if state.bounces == 0 { &self.context.quality } else { &self.context.gather_quality };
        let surface = hit.surface(&state.ray);
        let shading = ShadingPoint::new(self.context.world, &state.ray, (hit, &surface), quality, &interface);
        if !self.ignores_surface_light(state) {
            sum.rgb += state.throughput * self.emitted_and_direct_light(state, &shading);
        }
        if self.context.radiosity.is_some() {
            sum.rgb += state.throughput * self.indirect_light(state, &shading);
        }
        // Rays that continue
        let attenuation = self.attenuation_before(&interface, shading.part.interior, hit.t());
        self.scatter(state, &Boundary { shading: &shading, interface: &interface, attenuation }, sum);
        false
    }

    /// Continues a ray beyond a surface whose material is clear, and returns true. Returns false, without any effect,
    /// if the ray may change its direction or end there, or if the scene has radiosity; [`Self::scatter`] then handles
    /// the hit.
    #[inline(never)]
    fn try_pass_clear_surface(&mut self, state: &mut RayState, hit: &Intersection, interface: &Interface) -> bool {
        let (world, quality) = (self.context.world, &self.context.quality);
        let is_plain = quality.lights && quality.pigments && self.context.radiosity.is_none() && !world.disperses;
        let goes_on = state.level < self.max_trace_level && state.weight.min(gray(Rgb::ONE)) > self.adc_bailout;
        if !is_plain || !goes_on || interface.refracts() {
            return false;
        }
        let interior = world.parts[hit.part_number() as usize].interior;
        let attenuation = self.attenuation_before(interface, interior, hit.t());
        state.throughput *= attenuation;
        state.transparency *= gray(Rgb::ONE) * gray(attenuation);
        if self.context.tracks_interiors {
            interface.update_crossed_interiors(&mut state.inside, interior);
        }
        state.ray = Ray::new(hit.point(&state.ray), state.ray.dir);
        (state.has_transmitted, state.gather_rank) = (true, None);
        state.n_surfaces += 1;
        self.counts.transmitted += 1;
        true
    }

    /// Returns the transmittance, without media, of the interior `interior` over a segment of this length at whose end a ray
    /// meets its boundary: 1 unless the ray leaves the interior there.
    #[inline]
    pub(super) fn attenuation_before(&self, interface: &Interface, interior: u32, length: f64) -> Rgb {
        match self.context.world.colors_light && interface.leaves_interior() {
            true => self.interior_transmittance(interior, length),
            false => Rgb::ONE,
        }
    }

    /// True if the light of surfaces along a ray does not count: that of camera rays in a pass that collects radiosity samples.
    pub(super) fn ignores_surface_light(&self, state: &RayState) -> bool {
        state.bounces == 0 && self.context.radiosity.as_ref().is_some_and(|radiosity| !radiosity.is_final())
    }

    /// Stores the distance of the first hit of a ray that gathers light, and divides the ray's throughput by the
    /// object's `importance`. True if the ray is traced on, false if it ends there: only the share `importance` of the
    /// rays to an object is traced on.
    #[inline(never)]
    fn apply_importance_and_survives(&mut self, state: &mut RayState, rank: f64, hit: &Intersection) -> bool {
        self.first_distance = hit.t();
        let importance = self.context.world.parts[hit.part_number() as usize].importance();
        state.throughput /= importance;
        rank < importance
    }

    /// Returns the range of the hits of a ray.
    #[inline(always)]
    pub(super) fn range_of(&self, kind: RayKind) -> Range {
        let max = if kind == RayKind::Camera { self.context.camera.reach } else { f64::INFINITY };
        Range { min: self.context.world.epsilon.surface, max }
    }

    /// Returns the closest hit among the objects that are visible to this kind of ray, in the buffer.
    fn closest<'b>(&self, state: &RayState, buffer: &'b mut HitBuffer<'w>) -> Option<&'b Intersection<'w>> {
        let world = self.context.world;
        let kind = match state {
            _ if state.bounces > 0 => RayKind::Radiosity,
            _ if state.is_reflected => RayKind::Reflected,
            _ if state.has_transmitted => RayKind::Transmitted,
            _ => RayKind::Camera,
        };
        let range = self.range_of(kind);
        world.geometry.closest_in(buffer, &state.ray, range, |id| world.objects[id as usize].is_visible_to(kind))
    }

    /// True if fog, rainbows or media may be along the ray, and they count for this ray (`radiosity { media }`).
    fn may_cross_fog_or_media(&self, state: &RayState) -> bool {
        let counts =
            || state.bounces == 0 || self.context.world.radiosity.as_ref().is_some_and(|settings| settings.media);
        (self.has_air() || self.has_media() && !state.inside.is_empty()) && counts()
    }

    /// Returns the optical boundary at a hit; [`Interface::NONE`] unless rays keep a list of interiors.
    pub(super) fn interface(&self, state: &RayState, hit: &Intersection) -> Interface {
        if !self.context.tracks_interiors {
            return Interface::NONE;
        }
        let world = self.context.world;
        let own = world.parts[hit.part_number() as usize].interior;
        let interface = Interface::new(&state.inside, own, &world.interiors);
        match state.hue {
            Some(hue) => interface.of_hue(hue, &state.inside, own, &world.interiors),
            None => interface,
        }
    }

    /// Returns the light of sky and background in a direction, and as transmittance what stays transparent in a picture with
    /// alpha; `is_reflected` is true for a ray that was reflected.
    pub(super) fn background(&self, dir: DVec3, is_reflected: bool) -> Segment {
        let (world, keeps_alpha) = (self.context.world, self.context.keeps_alpha);
        if keeps_alpha && !is_reflected && world.sky.is_transparent_in_alpha_pictures() {
            return Segment::NONE;
        }
        let view = match keeps_alpha {
            true if is_reflected => ViewKind::Mirror,
            true => ViewKind::Alpha,
            false => ViewKind::Opaque,
        };
        world.sky.light_from(dir, view, !self.context.quality.pigments, world.noise, world.waves)
    }
}
