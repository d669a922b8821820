//! Camera rays that are traced in packets. Each has the radiance that [`Tracer::camera_radiance`] returns, to the last bit: the
//! first hits are found side by side, and so are the light of plain surfaces (see [`light`]) and what these reflect, and
//! the light of opaque surfaces with several layers (see [`layers`]); all else is computed ray by ray.

mod area_light;
mod layers;
mod light;

use super::context::FrameContext;
use super::interface::Interiors;
use super::radiance::Radiance;
use super::ray_state::RayState;
use super::segment::Span;
use super::single_layer::SingleLayerPoint;
use super::tracer::Tracer;
use crate::atmosphere::Segment;
use crate::color::{Rgb, gray};
use crate::math::packet::{MIN_RAYS, Numbers, PACKET, RayPacket, Vectors, set_lanes};
use crate::math::{Mask, Ray};
use crate::world::{ClosestHits, Intersection, RayKind, Shading, Surface, surfaces_of_packet};
use light::{LitPoints, PlainPoint};
use smallvec::SmallVec;

pub(super) use area_light::KnownLights;
pub(super) use layers::LitLayer;

/// Samples of the picture whose camera rays are traced side by side.
#[derive(Clone, Copy, Debug)]
pub struct SamplePacket {
    /// The camera rays, whose directions have length 1.
    pub rays: RayPacket,
    /// Samples that have a camera ray, as bits.
    pub existing: u32,
    /// Keys of the pixels.
    pub pixel: [u64; PACKET],
    /// Numbers of the samples in their pixels.
    pub sample: [u64; PACKET],
}

impl SamplePacket {
    /// Packet without samples.
    pub const NONE: Self = Self { rays: RayPacket::ZERO, existing: 0, pixel: [0; PACKET], sample: [0; PACKET] };
}

/// The camera rays of samples, or the rays to which as many reflections have turned them.
struct Packet<'a> {
    samples: &'a SamplePacket,
    rays: RayPacket,
    /// Rays that are still to be traced, as bits.
    active: u32,
    /// Importance of each ray, see [`RayState::weight`].
    weight: Numbers,
    /// Factor of each ray's radiance in its sample: red, green and blue.
    throughput: Vectors,
    /// Number of reflections before.
    vertex: u32,
}

/// A ray that a mirror reflects.
struct ReflectedRay {
    /// Number of the ray in the packet.
    lane: usize,
    ray: Ray,
    weight: f64,
    throughput: Rgb,
}

type ReflectedRays = SmallVec<[ReflectedRay; PACKET]>;

impl<'a> Packet<'a> {
    /// Creates the packet of the samples' camera rays.
    fn new(samples: &'a SamplePacket) -> Self {
        let throughput = Vectors::splat(Rgb::ONE);
        Self { samples, rays: samples.rays, active: samples.existing, weight: throughput.x, throughput, vertex: 0 }
    }

    /// True if the rays were reflected.
    fn is_reflected(&self) -> bool {
        self.vertex > 0
    }

    /// Returns the interiors that contain the origin of a ray: those of its camera ray, which reflections do not change.
    fn interiors(&self, context: &FrameContext, i: usize) -> Interiors {
        context.interiors_of_camera_ray(self.samples.rays.origin.lane(i))
    }

    /// Factor of the transparency that the rays contribute to the alpha channel, see [`RayState::transparency`].
    fn transparency(&self) -> f64 {
        if self.is_reflected() { 0.0 } else { 1.0 }
    }

    /// Replaces the rays by those that are reflected.
    fn reflect(&mut self, reflected: &[ReflectedRay]) {
        (self.active, self.vertex) = (0, self.vertex + 1);
        for ReflectedRay { lane, ray, weight, throughput } in reflected {
            self.active |= 1 << lane;
            self.rays.set_ray(*lane, ray);
            self.weight.0[*lane] = *weight;
            self.throughput.set_lane(*lane, *throughput);
        }
    }
}

impl<'w> Tracer<'w> {
    /// Stores the radiances of several samples: those of [`Self::begin_sample`] and [`Self::camera_radiance`] for each of them, and
    /// [`Radiance::NO_RAY`] for those without a camera ray.
    pub fn camera_radiances(&mut self, samples: &SamplePacket, radiances: &mut [Radiance; PACKET]) {
        for (i, radiance) in radiances.iter_mut().enumerate() {
            *radiance = if samples.existing >> i & 1 == 1 { Radiance::ZERO } else { Radiance::NO_RAY };
        }
        self.counts.camera += u64::from(samples.existing.count_ones());
        let mut packet = Packet::new(samples);
        while packet.active.count_ones() as usize >= MIN_RAYS && !self.is_stopped() {
            self.trace_packet(&mut packet, radiances);
        }
        for i in set_lanes(packet.active) {
            let state = self.begin_ray_of_packet(&packet, i);
            self.add_radiance_times_throughput(state, &mut radiances[i]);
        }
    }

    /// Traces the rays of a packet to their first hits, and adds the light there to the radiances of their samples. Rays that plain
    /// surfaces reflect are left in the packet; others are traced to their ends.
    fn trace_packet(&mut self, packet: &mut Packet, radiances: &mut [Radiance; PACKET]) {
        let world = self.context.world;
        let kind = if packet.is_reflected() { RayKind::Reflected } else { RayKind::Camera };
        let range = self.range_of(kind);
        let mut hits = ClosestHits::default();
        let is_visible = |id: u32| world.objects[id as usize].is_visible_to(kind);
        let counts = Mask::from_bits(packet.active);
        let found = (&mut hits, &mut self.coherence[usize::from(packet.is_reflected())]);
        world.geometry.find_closest_of_packet(&packet.rays, counts, range, is_visible, found);
        let reflected = self.shade_hits_of_packet(packet, &hits, radiances);
        packet.reflect(&reflected);
    }

    /// Adds the light at the hits of a packet's rays to the radiances of their samples. Returns the rays that plain surfaces
    /// reflect; traces all others to their ends.
    #[inline(always)]
    fn shade_hits_of_packet(
        &mut self,
        packet: &mut Packet,
        hits: &ClosestHits<'w>,
        radiances: &mut [Radiance; PACKET],
    ) -> ReflectedRays {
        let plain =
            lanes_of_hits(hits, |hit| self.may_be_lit_in_packet(hit, |shading| shading == Shading::PlainInPackets));
        let surfaces = surfaces_of_packet(&packet.rays, hits, plain);
        let (mut lit, mut others) = (LitPoints::new(), 0);
        let (mut reflected, has_air) = (ReflectedRays::new(), self.has_air());
        for i in set_lanes(packet.active) {
            let (ray, radiance) = (packet.rays.ray(i), &mut radiances[i]);
            match &hits[i] {
                None if self.lights_packets && !has_air => {
                    let sky = Segment::NONE.in_front_of(self.background(ray.dir, packet.is_reflected()));
                    radiance.rgb += packet.throughput.lane(i) * sky.radiance;
                    radiance.transparency += packet.transparency() * gray(sky.transmittance);
                }
                Some(hit)
                    if plain >> i & 1 == 1
                        && let Some(at) = self.plain_point(&ray, (hit, &surfaces.lane(i))) =>
                {
                    if has_air {
                        self.cross_air(packet, i, hit, radiance);
                    }
                    lit.add(i, &at, self.context.has_ambient);
                    if at.has_mirror() {
                        reflected.extend(self.reflect_ray_of_packet(packet, i, (hit, &at)));
                    }
                }
                _ => others |= 1 << i,
            }
        }
        if !lit.is_empty() {
            self.add_light_of_sources_to_points(&mut lit, packet);
            for (i, light) in lit.light() {
                radiances[i].rgb += packet.throughput.lane(i) * light;
            }
        }
        if others != 0 {
            self.shade_other_hits(packet, hits, others, radiances);
        }
        reflected
    }

    /// Adds the light at those hits of a packet's rays whose surfaces are not plain, and at the end of rays without hits, to the
    /// radiances of the rays' samples; traces the rays that continue to their ends. `lanes` are the rays, as bits. (Not inlined: the
    /// loop over plain surfaces is faster without this code.)
    #[inline(never)]
    fn shade_other_hits(
        &mut self,
        packet: &mut Packet,
        hits: &ClosestHits<'w>,
        lanes: u32,
        radiances: &mut [Radiance; PACKET],
    ) {
        let has_layers = |shading| matches!(shading, Shading::Layers | Shading::PlainLongChain);
        let layered = lanes & lanes_of_hits(hits, |hit| self.may_be_lit_in_packet(hit, has_layers));
        let done = match layered.count_ones() as usize >= MIN_RAYS {
            true => self.shade_layered_hits(packet, hits, layered, radiances),
            false => 0,
        };
        for i in set_lanes(lanes & !done) {
            let state = self.begin_ray_of_packet(packet, i);
            self.add_radiance_from_first_hit(state, hits[i].as_ref(), &mut radiances[i]);
        }
    }

    /// Adds the light of the air up to the hit of a packet's ray to the radiance of its sample, and attenuates the ray.
    fn cross_air(&mut self, packet: &mut Packet, i: usize, hit: &Intersection, radiance: &mut Radiance) {
        let air = self.segment(&self.state_of_ray(packet, i), &Span::from_origin(hit.t()), 0);
        let throughput = packet.throughput.lane(i);
        radiance.rgb += throughput * air.radiance;
        packet.throughput.set_lane(i, throughput * air.transmittance);
    }

    /// Returns the ray that the mirror at the hit of a packet's ray reflects; `None` if it reflects none.
    fn reflect_ray_of_packet(
        &mut self,
        packet: &Packet,
        lane: usize,
        (hit, at): (&Intersection<'w>, &PlainPoint<'w>),
    ) -> Option<ReflectedRay> {
        let mut state = self.state_of_ray(packet, lane);
        let is_reflected = self.reflect_at_plain_point(&mut state, hit, at);
        let RayState { ray, weight, throughput, .. } = state;
        is_reflected.then_some(ReflectedRay { lane, ray, weight, throughput })
    }

    /// Returns the state of a packet's ray.
    fn state_of_ray(&self, packet: &Packet, i: usize) -> RayState {
        let inside = packet.interiors(self.context, i);
        RayState {
            level: packet.vertex + 1,
            weight: packet.weight.0[i],
            throughput: packet.throughput.lane(i),
            transparency: packet.transparency(),
            is_reflected: packet.is_reflected(),
            n_surfaces: packet.vertex,
            ..RayState::camera(packet.rays.ray(i), inside)
        }
    }

    /// Starts the sample of a packet's ray, as [`Self::begin_sample`], at the vertex of its ray tree that the packet has reached,
    /// and returns the ray's state.
    fn begin_ray_of_packet(&mut self, packet: &Packet, i: usize) -> RayState {
        let (pixel, sample) = (packet.samples.pixel[i], packet.samples.sample[i]);
        self.begin_sample(pixel, sample);
        self.random.begin_vertex(pixel, sample, u64::from(packet.vertex));
        self.state_of_ray(packet, i)
    }

    /// True if the light of the surface at a hit can be computed in a packet, if its material is one for which `fits` is true.
    #[inline(always)]
    fn may_be_lit_in_packet(&self, hit: &Intersection, fits: impl Fn(Shading) -> bool) -> bool {
        let world = self.context.world;
        let part = &world.parts[hit.part_number() as usize];
        self.lights_packets
            && part.uncommon.is_none()
            && !part.double_illuminate
            && fits(world.material_outside(hit).shading)
    }

    /// Evaluates the plain material at the hit of a ray; `None` if it transmits light there, or its bumps are not finite.
    #[inline(always)]
    fn plain_point(&self, ray: &Ray, (hit, surface): (&Intersection<'w>, &Surface)) -> Option<PlainPoint<'w>> {
        let world = self.context.world;
        let part = &world.parts[hit.part_number() as usize];
        SingleLayerPoint::on_plain_surface(world, part, ray, (hit, surface)).filter(|at| !at.shaded.weight.is_nan())
    }
}

/// Returns the rays whose hit has a property, as bits.
#[inline(always)]
fn lanes_of_hits(hits: &ClosestHits, has_property: impl Fn(&Intersection) -> bool) -> u32 {
    let mut lanes = 0;
    for (i, hit) in hits.iter().enumerate() {
        lanes |= u32::from(hit.as_ref().is_some_and(&has_property)) << i;
    }
    lanes
}
