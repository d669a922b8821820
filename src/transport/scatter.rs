//! The rays that continue from a surface: reflected, transmitted, totally reflected, dispersed.

use super::interface::{Interface, reflect};
use super::radiance::Radiance;
use super::ray_state::RayState;
use super::reflect::{self, Mirror, MirrorContext};
use super::shading_point::{MaterialSample, ShadingPoint};
use super::tracer::Tracer;
use crate::color::{Rgb, gray};
use crate::math::{DVec3, Ray};
use smallvec::SmallVec;

/// A surface that a ray hits, with its optical boundary.
pub(super) struct Boundary<'a, 'w> {
    pub shading: &'a ShadingPoint<'w>,
    pub interface: &'a Interface,
    /// Transmittance of the interior that the ray leaves at the surface, for light from beyond the surface.
    pub attenuation: Rgb,
}

/// Continuation of the light that one material transmits.
pub(super) enum Transmission {
    /// No ray continues: the material is opaque, the ray too faint, or the ray tree too deep.
    Ends,
    /// The ray continues in this refracted direction of length 1.
    Refracted(DVec3),
    /// Total internal reflection of the ray.
    Total,
    /// Total internal reflection that is too faint to be traced.
    TotalTooFaint,
    /// White light splits into this number of coloured rays.
    Dispersed(u32),
}

/// A transmitted or totally reflected ray that continues.
pub(super) struct Continuation {
    /// Direction of the ray, length 1.
    dir: DVec3,
    /// True for total internal reflection.
    is_total: bool,
    /// Factor by which the ray's throughput differs from that of the incoming ray.
    throughput: Rgb,
    /// Factor by which the ray's importance differs from that of the incoming ray.
    weight: f64,
    /// Factor by which the ray's transparency differs from that of the incoming ray.
    transparency: f64,
}

impl Transmission {
    /// True for total internal reflection.
    pub fn is_total(&self) -> bool {
        matches!(self, Self::Total | Self::TotalTooFaint)
    }
}

/// A ray that meets one material of a surface.
pub(super) struct RayAtMaterial {
    /// Direction of the ray, length 1.
    pub dir: DVec3,
    /// Normal with the bumps of the material, length 1.
    pub normal: DVec3,
    /// Normal without bumps, length 1, towards the ray's origin.
    pub smooth: DVec3,
    /// Share of the material in a blend of materials.
    pub share: f64,
    /// Transmittance of all layers of the material.
    pub transmittance: Rgb,
    /// Transmittance of the interior that the ray leaves at the surface.
    pub attenuation: Rgb,
}

impl RayAtMaterial {
    /// Returns the refracted or totally reflected ray that continues; `None` if no ray does, or several by dispersion. `film`
    /// returns the factor of the material's thin film for light from a direction.
    #[inline]
    pub fn continuation(&self, transmission: &Transmission, film: impl FnOnce(DVec3) -> Rgb) -> Option<Continuation> {
        let &Self { share, transmittance, attenuation, .. } = self;
        match *transmission {
            Transmission::Ends | Transmission::TotalTooFaint | Transmission::Dispersed(_) => None,
            // The interior's attenuation does not lower the weight (quirk: `attenuation_keeps_weight`).
            Transmission::Refracted(dir) => Some(Continuation {
                dir,
                is_total: false,
                throughput: share * attenuation * transmittance,
                weight: transmittance.abs().max_element(),
                transparency: share * gray(transmittance) * gray(attenuation),
            }),
            // All light is reflected, but the weight falls as if it were transmitted (quirk: `total_reflection_weight`).
            Transmission::Total => {
                let dir = mirror_direction(self.dir, self.normal, self.smooth);
                Some(Continuation {
                    dir,
                    is_total: true,
                    throughput: share * attenuation * film(dir),
                    weight: transmittance.max_element(),
                    transparency: 0.0,
                })
            }
        }
    }
}

impl Continuation {
    fn follows_same_path(&self, other: &Continuation) -> bool {
        self.dir == other.dir && self.is_total == other.is_total
    }

    /// Adds the contribution of another material whose ray continues along the same path.
    fn merge(&mut self, other: &Continuation) {
        self.throughput += other.throughput;
        self.weight = self.weight.max(other.weight);
        self.transparency += other.transparency;
    }
}

impl Tracer<'_> {
    /// Pushes all rays that continue from a surface. Adds reflections that are not linear to `sum` at once.
    // (Forced: with the photons as a second caller, the compiler would make this a call.)
    #[inline(always)]
    pub(super) fn scatter(&mut self, state: &RayState, boundary: &Boundary, sum: &mut Radiance) {
        let first = self.queue.len();
        let Boundary { shading, interface, .. } = *boundary;
        if shading.ends_rays() {
            return;
        }
        // (A loop: collecting an iterator returns each element through memory.)
        let mut transmissions = SmallVec::<[Transmission; 1]>::new();
        for material in &shading.materials {
            let (transmittance, normal) = (material.transmittance, material.normal);
            transmissions.push(self.transmission(state, transmittance, normal, interface, shading.part.interior));
        }
        if self.context.quality.reflection {
            self.push_reflected(state, boundary, &transmissions, sum);
        }
        self.push_transmitted(state, boundary, &transmissions);
        // The queue is a stack: the ray that was pushed first is traced first.
        self.queue[first..].reverse();
    }

    /// Returns how the light continues that a material with this transmittance and normal transmits into the interior
    /// `interior`. The ray ends if the gray of the surface's transmittance or the largest channel of its weight is below
    /// `adc_bailout` (quirk: `adc_transmission`).
    #[inline]
    pub(super) fn transmission(
        &self,
        state: &RayState,
        transmittance: Rgb,
        normal: DVec3,
        interface: &Interface,
        interior: u32,
    ) -> Transmission {
        let world = self.context.world;
        let is_clear =
            self.context.quality.pigments && transmittance != Rgb::ZERO && gray(transmittance).abs() > self.adc_bailout;
        if !is_clear || state.level >= self.max_trace_level {
            return Transmission::Ends;
        }
        let refracted = interface.refract(state.ray.dir, normal);
        if state.weight * transmittance.abs().max_element() <= self.adc_bailout {
            return if refracted.is_none() { Transmission::TotalTooFaint } else { Transmission::Ends };
        }
        if world.disperses
            && state.hue.is_none()
            && let Some(samples) = interface.dispersion_samples(&state.inside, interior, &world.interiors)
        {
            return Transmission::Dispersed(samples);
        }
        refracted.map_or(Transmission::Total, Transmission::Refracted)
    }

    /// Pushes the reflected rays. Total internal reflection replaces the mirror reflection of the same material at the
    /// same normal (quirk: `total_reflection_replaces_mirror`).
    #[inline]
    fn push_reflected(
        &mut self,
        state: &RayState,
        boundary: &Boundary,
        transmissions: &[Transmission],
        sum: &mut Radiance,
    ) {
        let Boundary { shading, interface, .. } = *boundary;
        let world = self.context.world;
        if state.level >= self.max_trace_level {
            return;
        }
        let context = MirrorContext { weight: state.weight, bailout: self.adc_bailout, interface, world };
        let mut mirrors = SmallVec::<[Mirror; 1]>::new();
        for (material, transmission) in shading.materials.iter().zip(transmissions) {
            let is_total = transmission.is_total();
            for shaded in shading.layers_of(material) {
                if !(is_total && shaded.normal == material.normal)
                    && let Some(mirror) = Mirror::new(shaded, material.share, context)
                {
                    mirrors.push(mirror);
                }
            }
        }
        for bounce in reflect::bounces(&mirrors) {
            self.counts.reflected += 1;
            let out = mirror_direction(state.ray.dir, bounce.normal, shading.smooth);
            let reflectance = |light| reflect::reflected_radiance(&mirrors, shading.point, context, bounce, out, light);
            let is_linear = self.traces_photons || reflect::is_linear(&mirrors, bounce);
            let share = if is_linear { reflectance(Rgb::ONE) } else { Rgb::ONE };
            let mut reflected = state.continued(Ray::new(shading.point, out), share);
            (reflected.level, reflected.weight, reflected.is_reflected) = (state.level + 1, bounce.weight, true);
            if is_linear {
                self.queue.push(reflected);
            } else {
                reflected.throughput = Rgb::ONE;
                let light = self.radiance_times_throughput(reflected).rgb;
                sum.rgb += state.throughput * reflectance(light);
            }
        }
    }

    /// Pushes the transmitted, totally reflected and dispersed rays; equal paths are merged.
    #[inline]
    fn push_transmitted(&mut self, state: &RayState, boundary: &Boundary, transmissions: &[Transmission]) {
        let Boundary { shading, interface, attenuation } = *boundary;
        let world = self.context.world;
        let mut paths = SmallVec::<[Continuation; 1]>::new();
        for (material, transmission) in shading.materials.iter().zip(transmissions) {
            if let Transmission::Dispersed(samples) = *transmission {
                self.push_dispersed(state, boundary, material, samples);
                continue;
            }
            let MaterialSample { share, transmittance, normal, .. } = *material;
            let (dir, smooth) = (state.ray.dir, shading.smooth);
            let ray_at_material = RayAtMaterial { dir, normal, smooth, share, transmittance, attenuation };
            let film = |out| reflect::total_reflection_film_factor(shading, material, out, world);
            let Some(path) = ray_at_material.continuation(transmission, film) else { continue };
            match paths.iter_mut().find(|known| known.follows_same_path(&path)) {
                Some(known) => known.merge(&path),
                None => paths.push(path),
            }
        }
        for path in &paths {
            let next = self.transmitted_state(state, shading.point, path, interface, shading.part.interior);
            self.queue.push(next);
        }
    }

    /// Returns the state of a transmitted or totally reflected ray, which continues from `point` of the boundary of the
    /// interior `interior`. Counts the ray.
    #[inline]
    pub(super) fn transmitted_state(
        &mut self,
        state: &RayState,
        point: DVec3,
        path: &Continuation,
        interface: &Interface,
        interior: u32,
    ) -> RayState {
        let mut next = state.continued(Ray::new(point, path.dir), path.throughput);
        next.weight *= path.weight;
        if path.is_total {
            (next.level, next.is_reflected) = (state.level + 1, true);
            self.counts.reflected += 1;
        } else {
            next.transparency = state.transparency * path.transparency;
            next.has_transmitted = true;
            // A ray that is not bent stays on its level (quirk: `straight_ray_keeps_level`).
            next.level += u32::from(interface.refracts());
            if self.context.tracks_interiors {
                interface.update_crossed_interiors(&mut next.inside, interior);
            }
            self.counts.transmitted += 1;
        }
        next
    }
}

/// Returns the mirror direction of `dir` at a bumped normal. If bumps would reflect the ray into the surface, the
/// surface reflects it again; bumps that are seen from behind have no effect (quirk: `bumps_reflect_twice`).
pub(super) fn mirror_direction(dir: DVec3, normal: DVec3, smooth_normal: DVec3) -> DVec3 {
    let out = reflect(dir, normal);
    match out.dot(smooth_normal) < 0.0 {
        true if dir.dot(normal) > 0.0 => reflect(dir, smooth_normal),
        true => reflect(out, smooth_normal),
        false => out,
    }
}
