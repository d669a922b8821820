//! Camera rays that are traced in packets. Each has the radiance that [`Tracer::camera_radiance`] returns, to the last bit: the
//! first hits are found side by side, and so is the light of plain surfaces (see [`super::packet_light`]) and what these reflect;
//! all else is computed ray by ray.

use super::packet_light::{LitPoints, PlainPoint};
use super::radiance::Radiance;
use super::ray_state::RayState;
use super::segment::Span;
use super::single_layer::SingleLayerPoint;
use super::tracer::Tracer;
use crate::atmosphere::Segment;
use crate::color::{Rgb, gray};
use crate::math::packet::{MIN_RAYS, PACKET, RayPacket};
use crate::math::{Mask, Ray};
use crate::world::{ClosestHits, Intersection, RayKind, Surface, surfaces_of_packet};
use smallvec::SmallVec;

/// A sample of the picture: a camera ray, and the key of its random numbers.
#[derive(Clone, Copy, Debug)]
pub struct CameraSample {
    /// The camera ray, whose direction has length 1.
    pub ray: Ray,
    /// Key of the pixel.
    pub pixel: u64,
    /// Number of the sample in the pixel.
    pub sample: u64,
}

/// A camera ray, or a ray to which reflections have turned it.
#[derive(Clone, Copy)]
struct PacketRay {
    /// Index of the ray's sample.
    index: usize,
    ray: Ray,
    /// Importance of the ray, see [`RayState::weight`].
    weight: f64,
    /// Factor of the ray's radiance in the sample.
    throughput: Rgb,
}

type PacketRays = SmallVec<[PacketRay; PACKET]>;

/// Points with mirrors, each with the index of its ray.
type Mirrors<'w> = SmallVec<[(usize, PlainPoint<'w>); PACKET]>;

/// The rays of a packet, which have reached the same vertex of their samples' ray trees.
struct Packet<'a> {
    samples: &'a [CameraSample],
    rays: PacketRays,
    /// Number of reflections before.
    vertex: u32,
}

impl Packet<'_> {
    /// True if the rays were reflected.
    fn is_reflected(&self) -> bool {
        self.vertex > 0
    }

    /// Factor of the transparency that the rays contribute to the alpha channel, see [`RayState::transparency`].
    fn transparency(&self) -> f64 {
        if self.is_reflected() { 0.0 } else { 1.0 }
    }
}

impl<'w> Tracer<'w> {
    /// Returns the radiances of several samples: the same as [`Self::begin_sample`] and [`Self::camera_radiance`] for each of
    /// them. `radiances` has as many elements as `samples`.
    pub fn camera_radiances(&mut self, samples: &[CameraSample], radiances: &mut [Radiance]) {
        for (samples, radiances) in samples.chunks(PACKET).zip(radiances.chunks_mut(PACKET)) {
            radiances.fill(Radiance::ZERO);
            self.counts.camera += samples.len() as u64;
            let rays = samples.iter().enumerate();
            let rays =
                rays.map(|(index, sample)| PacketRay { index, ray: sample.ray, weight: 1.0, throughput: Rgb::ONE });
            let mut packet = Packet { samples, rays: rays.collect(), vertex: 0 };
            while packet.rays.len() >= MIN_RAYS && !self.is_stopped() {
                self.trace_packet(&mut packet, radiances);
            }
            for ray in &packet.rays {
                let state = self.begin_ray_of_packet(&packet, ray);
                self.add_radiance_times_throughput(state, &mut radiances[ray.index]);
            }
        }
    }

    /// Traces the rays of a packet to their first hits, and adds the light there to the radiances of their samples. Rays that plain
    /// surfaces reflect are left in the packet; others are traced to their ends.
    fn trace_packet(&mut self, packet: &mut Packet, radiances: &mut [Radiance]) {
        let world = self.context.world;
        let rays = RayPacket::new(packet.rays.len(), |i| packet.rays[i].ray);
        let kind = if packet.is_reflected() { RayKind::Reflected } else { RayKind::Camera };
        let range = self.range_of(kind);
        let mut hits = ClosestHits::default();
        let is_visible = |id: u32| world.objects[id as usize].is_visible_to(kind);
        let counts = Mask::from_fn(|i| i < packet.rays.len());
        let found = (&mut hits, &mut self.coherence[usize::from(packet.is_reflected())]);
        world.geometry.find_closest_of_packet(&rays, counts, range, is_visible, found);
        let mut lit = LitPoints::new(&rays);
        let mirrors = self.shade_hits_of_packet(packet, &rays, &hits, &mut lit, radiances);
        if !lit.is_empty() {
            self.add_light_of_sources_to_points(&mut lit);
            for (i, light) in lit.light() {
                let ray = &packet.rays[i];
                radiances[ray.index].rgb += ray.throughput * light;
            }
        }
        packet.rays = mirrors.iter().filter_map(|mirror| self.reflect_ray_of_packet(packet, &hits, mirror)).collect();
        packet.vertex += 1;
    }

    /// Evaluates the surfaces at the hits of a packet: adds points of plain surfaces to `lit`, and the radiances of other rays to
    /// those of their samples. Returns the points with mirrors.
    #[inline(always)]
    fn shade_hits_of_packet(
        &mut self,
        packet: &mut Packet,
        rays: &RayPacket,
        hits: &ClosestHits<'w>,
        lit: &mut LitPoints<'w>,
        radiances: &mut [Radiance],
    ) -> Mirrors<'w> {
        let mut plain = 0;
        for (i, hit) in hits.iter().enumerate() {
            plain |= u32::from(hit.as_ref().is_some_and(|hit| self.may_be_lit_in_packet(hit))) << i;
        }
        let surfaces = surfaces_of_packet(rays, hits, plain);
        let (mut mirrors, has_air) = (Mirrors::new(), self.has_air());
        for (i, hit) in hits.iter().enumerate().take(packet.rays.len()) {
            let ray = packet.rays[i];
            let radiance = &mut radiances[ray.index];
            match hit {
                None if self.lights_packets && !has_air => {
                    let sky = Segment::NONE.in_front_of(self.background(ray.ray.dir, packet.is_reflected()));
                    radiance.rgb += ray.throughput * sky.radiance;
                    radiance.transparency += packet.transparency() * gray(sky.transmittance);
                }
                Some(hit)
                    if plain >> i & 1 == 1
                        && let Some(at) = self.plain_point(&ray.ray, (hit, &surfaces.lane(i))) =>
                {
                    if has_air {
                        let state = self.state_of_ray(packet, &ray);
                        let air = self.segment(&state, &Span::from_origin(hit.t()), 0);
                        radiance.rgb += ray.throughput * air.radiance;
                        packet.rays[i].throughput *= air.transmittance;
                    }
                    let camera_origin = packet.samples[ray.index].ray.origin;
                    lit.add(i, &at, camera_origin, self.context.has_ambient);
                    if at.has_mirror() {
                        mirrors.push((i, at));
                    }
                }
                hit => {
                    let state = self.begin_ray_of_packet(packet, &ray);
                    self.add_radiance_from_first_hit(state, hit.as_ref(), radiance);
                }
            }
        }
        mirrors
    }

    /// Returns the ray that the mirror at the hit of a packet's ray reflects; `None` if it reflects none.
    fn reflect_ray_of_packet(
        &mut self,
        packet: &Packet,
        hits: &ClosestHits,
        (i, at): &(usize, PlainPoint<'w>),
    ) -> Option<PacketRay> {
        let (ray, hit) = (&packet.rays[*i], hits[*i].as_ref()?);
        let mut state = self.state_of_ray(packet, ray);
        let is_reflected = self.reflect_at_plain_point(&mut state, hit, at);
        let RayState { ray: reflected, weight, throughput, .. } = state;
        is_reflected.then_some(PacketRay { index: ray.index, ray: reflected, weight, throughput })
    }

    /// Returns the state of a packet's ray.
    fn state_of_ray(&self, packet: &Packet, ray: &PacketRay) -> RayState {
        let inside = self.context.interiors_of_camera_ray(packet.samples[ray.index].ray.origin);
        RayState {
            level: packet.vertex + 1,
            weight: ray.weight,
            throughput: ray.throughput,
            transparency: packet.transparency(),
            is_reflected: packet.is_reflected(),
            n_surfaces: packet.vertex,
            ..RayState::camera(ray.ray, inside)
        }
    }

    /// Starts the ray's sample, as [`Self::begin_sample`], at the vertex of its ray tree that the packet has reached, and returns
    /// the ray's state.
    fn begin_ray_of_packet(&mut self, packet: &Packet, ray: &PacketRay) -> RayState {
        let CameraSample { pixel, sample, .. } = packet.samples[ray.index];
        self.begin_sample(pixel, sample);
        self.random.begin_vertex(pixel, sample, u64::from(packet.vertex));
        self.state_of_ray(packet, ray)
    }

    /// True if the material at a hit is plain, so that its light can be computed in a packet.
    #[inline(always)]
    fn may_be_lit_in_packet(&self, hit: &Intersection) -> bool {
        let world = self.context.world;
        let part = &world.parts[hit.part_number() as usize];
        let material = &world.materials[part.outside.material as usize];
        self.lights_packets
            && part.uncommon.is_none()
            && material.is_plain
            && !part.double_illuminate
            && material.layers[0].finish.diffuse_back == 0.0
    }

    /// Evaluates the plain material at the hit of a ray; `None` if it transmits light there, or its bumps are not finite.
    #[inline(always)]
    fn plain_point(&self, ray: &Ray, (hit, surface): (&Intersection<'w>, &Surface)) -> Option<PlainPoint<'w>> {
        let world = self.context.world;
        let part = &world.parts[hit.part_number() as usize];
        SingleLayerPoint::on_plain_surface(world, part, ray, (hit, surface)).filter(|at| !at.shaded.weight.is_nan())
    }
}
