//! The state of one thread while it traces rays.

use super::context::FrameContext;
use super::packet::{KnownLights, LitLayer};
use super::photons::Found;
use super::radiosity::{RadiosityCache, RadiosityState, Sample};
use super::random::Random;
use super::ray_state::RayState;
use crate::world::{Blocker, Coherence, LightSource, ShaftOccluder, World};
use serde::Serialize;

/// Number of surfaces between two polls of the cancel flag. Two mirrors can make one camera ray take hours.
const SURFACES_PER_POLL: u32 = 64;

/// Numbers of traced rays, by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RayCounts {
    /// Number of camera rays.
    pub camera: u64,
    /// Number of shadow rays.
    pub shadow: u64,
    /// Number of reflected rays.
    pub reflected: u64,
    /// Number of rays that a transparent surface transmitted.
    pub transmitted: u64,
}

impl RayCounts {
    /// Adds the counts of another thread or tile.
    pub fn add(&mut self, other: &RayCounts) {
        self.camera += other.camera;
        self.shadow += other.shadow;
        self.reflected += other.reflected;
        self.transmitted += other.transmitted;
    }

    /// Returns the number of rays of all kinds.
    pub fn total(&self) -> u64 {
        self.camera + self.shadow + self.reflected + self.transmitted
    }
}

/// Tracer that computes one sample after another, on one thread.
pub struct Tracer<'w> {
    pub(super) context: &'w FrameContext<'w>,
    /// Numbers of rays traced so far.
    pub counts: RayCounts,
    /// Random numbers of the current sample.
    pub random: Random,
    is_cancelled: &'w (dyn Fn() -> bool + Sync),
    stopped: bool,
    surfaces_since_poll: u32,
    /// Last occluder of each light: a hint for the next shadow ray, which never changes a result.
    pub(super) occluders: Vec<Option<Blocker>>,
    /// Coherence of packets of camera rays, and of reflected rays: hints, which never change a result.
    pub(super) coherence: [Coherence; 2],
    /// Coherence of packets of shadow rays.
    pub(super) shadow_coherence: Coherence,
    /// Last object in a shaft to each light: a hint for the next shaft test, which never changes a result.
    pub(super) shaft_occluders: Vec<Option<ShaftOccluder>>,
    /// Samples of radiosity that the tracer has gathered since the last camera ray, or in a pass since the last work item.
    pub(super) radiosity_cache: RadiosityCache,
    /// Sample of radiosity that the last point of a pass could reuse: a hint for the next point, which never changes a
    /// result.
    pub(super) last_usable_sample: Option<Sample>,
    /// Distance of the first hit of the present ray that gathers light; infinite without a hit.
    pub(super) first_distance: f64,
    /// Rays that are still to be traced, the next one last.
    pub(super) queue: Vec<RayState>,
    /// Maximum depth of the ray tree.
    pub(super) max_trace_level: u32,
    /// Importance below which rays are not traced.
    pub(super) adc_bailout: f64,
    /// True if a [`super::single_layer::SingleLayerPoint`] may shade surfaces: at a quality level that shows lights, pigments
    /// and reflection.
    pub(super) shows_surfaces_fully: bool,
    /// True if the light of opaque surfaces at the hits of camera rays is computed in packets: without radiosity and photons, and if
    /// [`can_light_packets`].
    pub(super) lights_packets: bool,
    /// True if the rays are photons, whose reflection is always linear.
    pub(super) traces_photons: bool,
    /// True if shadow rays pass targets of photons as other transparent objects: the lit surface does not collect photons.
    pub(super) targets_transmit_light: bool,
    /// Buffer of the visibilities of a grid of lights, kept from packet to packet.
    pub(super) known_lights: KnownLights,
    /// Buffer of the layers at the points of a packet, kept from packet to packet.
    pub(super) layer_buffer: Vec<LitLayer<'w>>,
    /// Buffers of photon searches, kept from search to search to avoid allocations.
    pub(super) photon_buffers: [Found; 2],
}

/// True if the light of opaque surfaces can be computed in packets: there are no media and no rainbows, and each light needs to pass
/// no object, is not attenuated by fog, and illuminates from its centre.
fn can_light_packets(world: &World) -> bool {
    let is_simple = |light: &LightSource| {
        light.through.is_none()
            && light.emitter.area.as_ref().is_none_or(|area| !area.illumination)
            && !light.emitter.attenuated
    };
    world.media.is_empty() && world.air.is_empty() && world.rainbows.is_empty() && world.lights.iter().all(is_simple)
}

impl<'w> Tracer<'w> {
    /// Creates a tracer that stops soon after `is_cancelled` returns true.
    pub fn new(context: &'w FrameContext<'w>, is_cancelled: &'w (dyn Fn() -> bool + Sync)) -> Self {
        let quality = &context.quality;
        let shows_surfaces_fully = quality.lights && quality.pigments && quality.reflection;
        Self {
            context,
            counts: RayCounts::default(),
            random: Random::new(context.frame),
            is_cancelled,
            stopped: false,
            surfaces_since_poll: 0,
            occluders: vec![None; context.world.lights.len()],
            coherence: Default::default(),
            shadow_coherence: Coherence::default(),
            shaft_occluders: vec![None; context.world.lights.len()],
            radiosity_cache: RadiosityCache::new(context.world.radiosity.as_ref().map_or(1.0, |r| r.error_bound)),
            last_usable_sample: None,
            first_distance: f64::INFINITY,
            queue: vec![],
            max_trace_level: context.world.max_trace_level,
            adc_bailout: context.world.adc_bailout,
            shows_surfaces_fully,
            lights_packets: shows_surfaces_fully
                && context.radiosity.is_none()
                && context.photons.is_none()
                && can_light_packets(context.world),
            traces_photons: false,
            targets_transmit_light: false,
            known_lights: KnownLights::default(),
            layer_buffer: vec![],
            photon_buffers: <[Found; 2]>::default(),
        }
    }

    /// True if the light of plain surfaces is computed in packets.
    pub fn lights_packets(&self) -> bool {
        self.lights_packets
    }

    /// True if the tracer was cancelled, so that its results are invalid.
    pub fn is_stopped(&self) -> bool {
        self.stopped
    }

    /// Polls the cancel flag. True if the tracer was cancelled.
    pub fn poll_is_stopped(&mut self) -> bool {
        self.stopped |= (self.is_cancelled)();
        self.stopped
    }

    /// Counts a surface or a sample of media, and polls the cancel flag at every 64th. True if the tracer is cancelled.
    pub(super) fn count_surface_and_is_stopped(&mut self) -> bool {
        self.surfaces_since_poll += 1;
        if self.surfaces_since_poll == SURFACES_PER_POLL {
            self.surfaces_since_poll = 0;
            self.stopped |= (self.is_cancelled)();
        }
        self.stopped
    }

    /// Starts a sample of a pixel, by which later random numbers are keyed, and polls the cancel flag. In the final
    /// pass of radiosity, it also drops the samples that the last camera ray gathered.
    pub fn begin_sample(&mut self, pixel: u64, sample: u64) {
        self.poll_is_stopped();
        self.random.begin_sample(pixel, sample);
        if self.context.radiosity.as_ref().is_some_and(RadiosityState::is_final) {
            self.radiosity_cache.clear();
        }
    }
}
