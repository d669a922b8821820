//! Samples of radiosity, and the light that surfaces reflect because of them.

use super::cache::{Blend, Query, Sample};
use super::{ANY_CLOSENESS, RadiosityState, ray_count};
use crate::color::{Rgb, gray};
use crate::math::{DVec3, Ray, fp, rng};
use crate::transport::direct_light::LitSurface;
use crate::transport::interface::Interiors;
use crate::transport::ray_state::RayState;
use crate::transport::shading_point::ShadedLayer;
use crate::transport::tracer::Tracer;
use std::f64::consts::TAU;

/// Point of a surface at which rays gather light for a radiosity sample, with its normals and the importance of the
/// light.
struct GatherPoint {
    point: DVec3,
    /// Normal with bumps, if they count, on the side of the gathered light.
    normal: DVec3,
    /// Normal without bumps on the same side.
    smooth: DVec3,
    /// Number of diffuse bounces between the camera ray and the point.
    depth: u8,
    /// Importance of the gathered light, which is compared with `adc_bailout`.
    importance: f64,
}

impl Tracer<'_> {
    /// Removes the radiosity samples that this tracer has collected since the last call, and returns them.
    pub fn take_radiosity_samples(&mut self) -> Vec<Sample> {
        self.last_usable_sample = None;
        self.radiosity_cache.take_samples()
    }

    /// Returns the light that a surface reflects or transmits diffusely from other surfaces and the sky.
    #[inline(never)]
    pub(in crate::transport) fn indirect_light<'s>(&mut self, state: &RayState, surface: &impl LitSurface<'s>) -> Rgb {
        let context = self.context;
        let Some(radiosity) = &context.radiosity else { return Rgb::ZERO };
        if u32::from(state.bounces) >= radiosity.settings.recursion_limit {
            return Rgb::ZERO;
        }
        let enters = context.world.subsurface.as_ref().is_some_and(|settings| settings.radiosity);
        let gathered_light_factor = |shaded: &ShadedLayer, side: f64| match enters && shaded.is_translucent {
            true => Rgb::ZERO,
            false => gathered_light_factor(shaded, side),
        };
        let mut sum = Rgb::ZERO;
        for side in [1.0, -1.0] {
            let smooth = surface.smooth_normal() * side;
            let at = |normal| GatherPoint {
                point: surface.point(),
                normal,
                smooth,
                depth: state.bounces,
                importance: state.weight,
            };
            if radiosity.settings.normal {
                surface.for_each_layer(|share, shaded| {
                    let factor = share * gathered_light_factor(shaded, side);
                    sum += self.indirect_light_at(radiosity, at(shaded.normal * side), factor);
                });
            } else {
                let factor = surface.weighted_layer_sum(|shaded| gathered_light_factor(shaded, side));
                sum += self.indirect_light_at(radiosity, at(smooth), factor);
            }
        }
        sum
    }

    /// Returns the gathered light that arrives at a point of a translucent solid's surface; the caller applies the
    /// transmittance of the surface.
    pub(in crate::transport) fn gathered_light_into_solid(
        &mut self,
        state: &RayState,
        point: DVec3,
        normal: DVec3,
    ) -> Rgb {
        let Some(radiosity) = &self.context.radiosity else { return Rgb::ZERO };
        let at = GatherPoint { point, normal, smooth: normal, depth: state.bounces, importance: state.weight };
        match u32::from(state.bounces) < radiosity.settings.recursion_limit {
            true => self.indirect_light_at(radiosity, at, Rgb::ONE),
            false => Rgb::ZERO,
        }
    }

    /// Returns the gathered light at a point times `factor` and `brightness`, made grayer by `gray_threshold`; black if
    /// its importance is at most `adc_bailout`.
    fn indirect_light_at(&mut self, radiosity: &RadiosityState, mut at: GatherPoint, factor: Rgb) -> Rgb {
        let settings = radiosity.settings;
        at.importance = at.importance * factor.abs().max_element() * settings.brightness;
        if at.importance.is_nan() || at.importance <= settings.adc_bailout {
            return Rgb::ZERO;
        }
        let light = self.gathered_light(radiosity, &at);
        let gray = Rgb::splat(gray(light));
        factor * settings.brightness * light.lerp(gray, settings.gray_threshold)
    }

    /// Returns the mean radiance over the cosine-weighted hemisphere at a point, from near samples or a new one. In a pass
    /// that collects samples, nobody reads the light of a camera ray, and it is black.
    fn gathered_light(&mut self, radiosity: &RadiosityState, at: &GatherPoint) -> Rgb {
        let query = radiosity.query(at.point, at.normal, at.depth);
        let wanted = radiosity.wanted_closeness(at.depth);
        if at.depth == 0 && !radiosity.is_final() {
            if !self.has_closeness(wanted, radiosity, &query) && !self.is_stopped() {
                let sample = self.gather(radiosity, at);
                self.radiosity_cache.insert(sample);
            }
            return Rgb::ZERO;
        }
        let mut blend = Blend::default();
        radiosity.cache.add_usable_samples_to(&query, &mut blend);
        self.radiosity_cache.add_usable_samples_to(&query, &mut blend);
        if blend.closeness < wanted && !self.is_stopped() {
            let sample = self.gather(radiosity, at);
            self.radiosity_cache.insert(sample);
            if let Some(light) = blend.mean() {
                let share = 1.0 / f64::from(blend.count + 1);
                return light.lerp(sample.light, share);
            }
            return sample.light;
        }
        blend.mean().unwrap_or(Rgb::ZERO)
    }

    /// True if the sum of 1 - error / maximum error over the radiosity samples that may be reused for the query is at least
    /// `wanted`.
    fn has_closeness(&mut self, wanted: f64, radiosity: &RadiosityState, query: &Query) -> bool {
        if wanted > ANY_CLOSENESS {
            let found = radiosity.cache.closeness_up_to(wanted, query);
            return found >= wanted || found + self.radiosity_cache.closeness_up_to(wanted - found, query) >= wanted;
        }
        // Neighbouring points can often reuse the same sample.
        if !self.last_usable_sample.is_some_and(|sample| sample.is_usable_for(query)) {
            let found = radiosity.cache.any_usable_sample(query);
            self.last_usable_sample = found.or_else(|| self.radiosity_cache.any_usable_sample(query)).copied();
        }
        self.last_usable_sample.is_some()
    }

    /// Computes a radiosity sample at a point: traces rays into the hemisphere about the normal.
    fn gather(&mut self, radiosity: &RadiosityState, at: &GatherPoint) -> Sample {
        let settings = radiosity.settings;
        let all = radiosity.directions(at.depth);
        let count = ray_count(settings, u32::from(at.depth)) as usize;
        // The point decides which rays of the pool are chosen, not the order of samples. Each sample also turns its directions
        // about the normal by an angle of its own, and shifts them within their rings, so that errors of neighbours differ.
        let [x, y, z] = at.point.to_array().map(f64::to_bits);
        let [turn, shift] = [0, 1].map(|number| rng::random_unit(&[x, y, z, number]));
        let start = settings.pool.map_or(0, |_| (turn * all.len() as f64) as usize);
        let (sin, cos) = fp::sin_cos(TAU * turn);
        let (x, y) = at.normal.any_orthonormal_pair();
        let (tangent, bitangent) = (x * cos + y * sin, y * cos - x * sin);
        let (mut light, mut inverse_distances) = (Rgb::ZERO, 0.0);
        let (mut nearest, mut toward_nearest) = (f64::INFINITY, DVec3::ZERO);
        for i in 0..count {
            let d = all.direction((start + i) % all.len(), shift);
            let dir = (tangent * d.x + bitangent * d.y + at.normal * d.z).normalize();
            // Bumps can turn directions into the surface.
            if dir.dot(at.smooth) <= 0.0 {
                continue;
            }
            let rank = (i as f64 + 0.5) / count as f64;
            let (incoming, distance) =
                self.radiance_and_first_distance(RayState::gather(Ray::new(at.point, dir), at, rank));
            inverse_distances += 1.0 / distance;
            if distance < nearest {
                (nearest, toward_nearest) = (distance, dir);
            }
            let most = incoming.max_element();
            let is_limited = settings.max_sample > 0.0 && most > settings.max_sample;
            light += if is_limited { incoming * (settings.max_sample / most) } else { incoming };
            if self.is_stopped() {
                break;
            }
        }
        let n = count as f64;
        let eye = at.point.distance(radiosity.eye);
        let harmonic = n / inverse_distances;
        // (Errors after bounces average out over the rays of a sample, so the limits double with each bounce.)
        let scale = f64::from(1_u32 << at.depth) * eye;
        let [minimum, maximum] = settings.reuse_radius_per_distance().map(|share| share * scale);
        let radius = harmonic.clamp(minimum, maximum);
        // (A camera on the surface, and a distance that is not a number, leave no radius.)
        let radius = if radius > 0.0 { radius } else { f64::MIN_POSITIVE.max(maximum * 1e-6) };
        Sample {
            point: at.point,
            normal: at.normal,
            light: light / n,
            radius,
            nearest: nearest.min(radius),
            toward_nearest,
            depth: at.depth,
        }
    }

    /// Returns the radiance along a ray that gathers light, times the ray's throughput, and the distance of its first
    /// hit.
    fn radiance_and_first_distance(&mut self, state: RayState) -> (Rgb, f64) {
        let before = std::mem::replace(&mut self.first_distance, f64::INFINITY);
        let light = self.radiance_times_throughput(state).rgb;
        let distance = std::mem::replace(&mut self.first_distance, before);
        (light, distance)
    }
}

impl RayState {
    /// Creates the state of a ray that gathers light for a radiosity sample at a point; `rank` is the ray's place among
    /// those of the sample, from 0 to 1.
    fn gather(ray: Ray, at: &GatherPoint, rank: f64) -> Self {
        Self {
            bounces: at.depth + 1,
            weight: at.importance,
            is_reflected: true,
            gather_rank: Some(rank),
            ..Self::camera(ray, Interiors::new())
        }
    }
}

/// Returns the factor of gathered light in the light that a layer sends, for light from the front (`side` = 1) or from behind.
fn gathered_light_factor(shaded: &ShadedLayer, side: f64) -> Rgb {
    let finish = &shaded.layer.finish;
    let diffuse = if side > 0.0 { finish.diffuse } else { finish.diffuse_back };
    if diffuse == 0.0 {
        return Rgb::ZERO;
    }
    shaded.weight * shaded.color.rgb * (shaded.opacity * diffuse)
}
