//! `finish { subsurface }`: light that enters a translucent solid and leaves it elsewhere, by the BSSRDF of Jensen,
//! Marschner, Levoy and Hanrahan, A Practical Model for Subsurface Light Transport, SIGGRAPH 2001: light that is
//! scattered often by the dipole approximation (section 2.1), light that is scattered once by its path (section 3.1).

use super::dipole::{Dipole, boundary_mismatch};
use super::random::{Purpose, RandomSequence};
use super::ray_state::RayState;
use super::shading_point::{ShadedLayer, ShadingPoint};
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::math::{DVec3, Range, Ray, fp};
use crate::world::{Intersection, Surface};
use smallvec::SmallVec;
use std::f64::consts::{PI, TAU};

/// Fractional part of the golden ratio: turns by this share of a circle spread points evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Weight of a sample below which it is traced at random: with a probability in proportion to its weight, and then with
/// this weight.
const FULL_WEIGHT: f64 = 0.05;

/// Point of a translucent surface that a ray shows.
struct Exit<'a> {
    state: &'a RayState,
    point: DVec3,
    /// Outward normal at the point, length 1.
    normal: DVec3,
    /// Number of the translucent solid's interior; only surfaces with the same interior count as surfaces of this
    /// solid.
    interior: u32,
    /// Index of refraction of the interior.
    ior: f64,
    /// Transmittance of the surface for light that leaves in the direction of the ray's origin.
    transmittance: f64,
    random: RandomSequence,
}

/// Colour channels that share one dipole of subsurface scattering.
#[derive(Clone, Copy)]
struct Channels {
    dipole: Dipole,
    /// 1 for the channels with this dipole, 0 for the others.
    mask: Rgb,
}

/// A point of the refracted ray at which light is scattered.
struct ScatteringPoint<'a> {
    ray: &'a Ray,
    /// Distance of the point along the ray.
    distance: f64,
    /// Density of the distance for each dipole, as a share of the mean density.
    weights: SmallVec<[f64; 3]>,
}

/// Refraction of a direction at the boundary of a solid: the cosine inside and the transmittance.
struct Refracted {
    /// Cosine of the angle between direction and normal inside the solid.
    cos_inside: f64,
    /// Transmittance of the boundary, for unpolarised light.
    transmittance: f64,
}

impl<'w> Tracer<'w> {
    /// Returns the radiance that translucent layers send along a ray, in place of their diffuse reflection.
    #[inline(never)]
    pub(super) fn subsurface_light(&mut self, state: &RayState, shading: &ShadingPoint) -> Rgb {
        let mut sum = Rgb::ZERO;
        for material in &shading.materials {
            for shaded in shading.layers_of(material).iter().filter(|shaded| shaded.is_translucent) {
                sum += material.share * shaded.weight * self.light_through_solid(state, shading, shaded);
            }
        }
        sum
    }

    /// Returns the radiance of one translucent layer; its transparency has no effect (quirk: `subsurface_opacity`).
    fn light_through_solid(&mut self, state: &RayState, shading: &ShadingPoint, shaded: &ShadedLayer) -> Rgb {
        let ior = self.context.world.interiors[shading.part.interior as usize].ior;
        let exit = Exit {
            state,
            point: shading.point,
            normal: shading.smooth,
            interior: shading.part.interior,
            ior,
            transmittance: refraction_on_entry(-state.ray.dir.dot(shading.smooth), ior).transmittance,
            random: self.random.sequence(Purpose::Subsurface),
        };
        let all: SmallVec<[Channels; 3]> = channels_of(shaded, ior).collect();
        self.multiple_scattering_light(&exit, &all) + self.single_scattering_light(&exit, &all)
    }

    /// Returns the radiance that was scattered often. Rays in all directions, from a point below the surface for each
    /// dipole, find the points where light enters (quirk: `subsurface_hits`). The dipoles share the points: the density
    /// of the points is the mean of the densities around the origins (balance heuristic; Veach and Guibas, Optimally
    /// Combining Sampling Techniques for Monte Carlo Rendering, 1995).
    fn multiple_scattering_light(&mut self, exit: &Exit, all: &[Channels]) -> Rgb {
        let n_samples = self.context.world.subsurface.as_ref().map_or(0, |settings| settings.diffuse_samples);
        if all.is_empty() {
            return Rgb::ZERO;
        }
        let thickness = self.distance_inside(&Ray::new(exit.point, -exit.normal)).unwrap_or(f64::INFINITY);
        let below = |channels: &Channels| exit.point - exit.normal * channels.dipole.depth.min(0.5 * thickness);
        let origins: SmallVec<[DVec3; 3]> = all.iter().map(below).collect();
        let tangent = exit.normal.any_orthonormal_vector();
        let bitangent = exit.normal.cross(tangent);
        let (mut sum, mut n_hits) = (Rgb::ZERO, 0_u32);
        for i in 0..n_samples {
            if self.count_surface_and_is_stopped() {
                break;
            }
            // Points of a spiral on the sphere, which is turned by chance
            let cos = 1.0 - 2.0 * (f64::from(i) + exit.random.at(0)) / f64::from(n_samples);
            let sin = (1.0 - cos * cos).max(0.0).sqrt();
            let (y, x) = fp::sin_cos(TAU * fp::fraction_above_floor(f64::from(i) * GOLDEN + exit.random.at(1)));
            let ray =
                Ray::new(origins[i as usize % origins.len()], exit.normal * cos + (tangent * x + bitangent * y) * sin);
            let Some(hit) = self.closest_surface(&ray) else { continue };
            n_hits += 1;
            if self.interior_of(&hit) != exit.interior {
                continue;
            }
            let surface = hit.surface(&ray);
            // Density of the points per area: |n·ω|/(4πt²)
            let density = |origin: &DVec3| {
                let path = surface.point - *origin;
                let square = path.length_squared();
                surface.normal.dot(path).abs() / (4.0 * PI * square * square.sqrt())
            };
            let density = origins.iter().map(density).sum::<f64>() / origins.len() as f64;
            let square = surface.point.distance_squared(exit.point);
            let weight = |sum: Rgb, channels: &Channels| sum + channels.mask * channels.dipole.reflectance(square);
            let weight = all.iter().fold(Rgb::ZERO, weight) / density;
            if !weight.is_finite() {
                continue;
            }
            // Russian roulette: most points far away count for nothing.
            let kept = (weight.max_element() / FULL_WEIGHT).min(1.0);
            if exit.random.at(2 * u64::from(i) + 3) < kept {
                sum += weight / kept * self.entering_light(exit, &hit, &surface);
            }
        }
        sum * (exit.transmittance / f64::from(n_hits.max(1)))
    }

    /// Returns the light that enters a solid at a point of its surface: times the cosine and the transmittance of the
    /// surface. Light from either side enters (quirk: `subsurface_both_sides`).
    fn entering_light(&mut self, exit: &Exit, hit: &Intersection, surface: &Surface) -> Rgb {
        let world = self.context.world;
        let light_set = world.parts[hit.part_number() as usize].light_set();
        let mut sum = Rgb::ZERO;
        for &number in &world.lit_by[light_set as usize] {
            let light = &world.lights[number as usize];
            let sample = light.emitter.sample(surface.point, DVec3::ZERO);
            let cos = surface.normal.dot(sample.to_light).abs();
            if sample.light == Rgb::ZERO || cos.is_nan() || cos == 0.0 {
                continue;
            }
            let visibility = self.visibility(light, surface.point, &sample, &exit.state.inside, exit.state.bounces);
            sum += sample.light * visibility * (cos * refraction_on_entry(cos, exit.ior).transmittance);
        }
        if world.subsurface.as_ref().is_some_and(|settings| settings.radiosity) {
            // Gathered light counts as if it came along the normal.
            let gathered = self.gathered_light_into_solid(exit.state, surface.point, surface.normal);
            sum += gathered * refraction_on_entry(1.0, exit.ior).transmittance;
        }
        sum
    }

    /// Returns the radiance that was scattered once, on the refracted ray (section 3.1). Distances along the ray are
    /// chosen with the mean of the dipoles' densities σ_t·exp(-σ_t·s) (balance heuristic).
    fn single_scattering_light(&mut self, exit: &Exit, all: &[Channels]) -> Rgb {
        let n_samples = self.context.world.subsurface.as_ref().map_or(0, |settings| settings.single_samples);
        let cos = -exit.state.ray.dir.dot(exit.normal);
        let inner = refraction_on_entry(cos, exit.ior);
        if all.is_empty() || inner.transmittance == 0.0 {
            return Rgb::ZERO;
        }
        let along_surface = exit.state.ray.dir + exit.normal * cos;
        let ray = Ray::new(exit.point, along_surface / exit.ior - exit.normal * inner.cos_inside);
        let end = self.distance_inside(&ray).unwrap_or(f64::INFINITY);
        let mut sum = Rgb::ZERO;
        for i in 0..n_samples {
            if self.count_surface_and_is_stopped() {
                break;
            }
            let share = (f64::from(i) + exit.random.at(2 * u64::from(i) + 2)) / f64::from(n_samples);
            let distance = -fp::ln(1.0 - share) * all[i as usize % all.len()].dipole.depth;
            if distance < end {
                let density = |channels: &Channels| {
                    let depth = channels.dipole.depth;
                    fp::exp(-distance / depth) / depth
                };
                let mean = all.iter().map(density).sum::<f64>() / all.len() as f64;
                let weights = all.iter().map(|channels| density(channels) / mean).collect();
                sum += self.light_scattered_once(exit, all, &ScatteringPoint { ray: &ray, distance, weights });
            }
        }
        sum * (inner.transmittance / f64::from(n_samples.max(1)))
    }

    /// Returns the light of all light sources that one point of the refracted ray scatters along the ray (quirk:
    /// `subsurface_single_scattering`).
    fn light_scattered_once(&mut self, exit: &Exit, all: &[Channels], scattering: &ScatteringPoint) -> Rgb {
        let world = self.context.world;
        let &ScatteringPoint { ray, distance, ref weights } = scattering;
        let point = ray.at(distance);
        let mut sum = Rgb::ZERO;
        for light in &world.lights {
            let below = light.emitter.sample(point, DVec3::ZERO);
            let to_light = Ray::new(point, below.to_light);
            let Some(hit) = self.closest_surface(&to_light).filter(|hit| self.interior_of(hit) == exit.interior) else {
                continue;
            };
            let surface = hit.surface(&to_light);
            let light_set = world.parts[hit.part_number() as usize].light_set();
            let sample = light.emitter.sample(surface.point, DVec3::ZERO);
            let cos = surface.normal.dot(sample.to_light).abs();
            let is_inside = !light.emitter.is_parallel() && below.distance < hit.t();
            let is_lit = world.lit_by[light_set as usize].iter().any(|&number| number as usize == light.number);
            if is_inside || !is_lit || sample.light == Rgb::ZERO || cos.is_nan() || cos == 0.0 {
                continue;
            }
            let entry = refraction_on_entry(cos, exit.ior);
            // The path inside, as if light were refracted: s_i' = s_i·|n·ω|/|n·ω'|
            let path = distance + hit.t() * cos / entry.cos_inside;
            // G = |n·ω_o'|/|n·ω_i'|
            let geometry = surface.normal.dot(ray.dir).abs() / entry.cos_inside;
            let share = |sum: Rgb, (Channels { dipole, mask }, weight): (&Channels, &f64)| {
                sum + *mask * (weight * 0.25 * dipole.albedo * fp::exp(-path / dipole.depth) / (1.0 + geometry))
            };
            let share = all.iter().zip(weights).fold(Rgb::ZERO, share);
            let visibility = self.visibility(light, surface.point, &sample, &exit.state.inside, exit.state.bounces);
            sum += share * sample.light * visibility * (cos * entry.transmittance);
        }
        sum
    }

    /// Returns the closest hit of any object along a ray from inside a solid.
    fn closest_surface(&self, ray: &Ray) -> Option<Intersection<'w>> {
        let world = self.context.world;
        let range = Range { min: world.epsilon.surface, max: f64::INFINITY };
        world.geometry.closest(ray, range, |_| true)
    }

    /// Returns the distance up to the next surface of any object along a ray from a surface into the solid; `None`
    /// without one.
    fn distance_inside(&self, ray: &Ray) -> Option<f64> {
        self.closest_surface(ray).map(|hit| hit.t())
    }

    fn interior_of(&self, hit: &Intersection) -> u32 {
        self.context.world.parts[hit.part_number() as usize].interior
    }
}

/// Returns the dipoles of a layer, each with its channels; channels with equal dipoles are computed together. A channel
/// without a dipole is dark (quirk: `subsurface_zero_channel`).
fn channels_of(shaded: &ShadedLayer, ior: f64) -> impl Iterator<Item = Channels> {
    let finish = &shaded.layer.finish;
    let lengths = finish.scattering_length.as_deref().copied().unwrap_or_default();
    let mismatch = boundary_mismatch(ior);
    let reflectances = shaded.color.rgb * finish.diffuse;
    let dipoles: [Option<Dipole>; 3] = [0, 1, 2].map(|i| Dipole::new(reflectances[i], lengths[i], mismatch));
    (0..3).filter_map(move |i| {
        let dipole = dipoles[i]?;
        let is_first = !dipoles[..i].contains(&Some(dipole));
        let mask = Rgb::from_array(dipoles.map(|other| f64::from(u8::from(other == Some(dipole)))));
        is_first.then_some(Channels { dipole, mask })
    })
}

/// Returns the refraction of light that enters a solid from outside at this cosine of incidence, by Snell's law and
/// Fresnel's equations; zeros for total reflection.
fn refraction_on_entry(cos: f64, ior: f64) -> Refracted {
    // cos²θ₂ = 1 - (1 - cos²θ₁)/n²
    let cos2 = 1.0 - (1.0 - cos * cos) / (ior * ior);
    if cos2.is_nan() || cos2 <= 0.0 {
        return Refracted { cos_inside: 0.0, transmittance: 0.0 };
    }
    let inside = cos2.sqrt();
    let perpendicular = (cos - ior * inside) / (cos + ior * inside);
    let parallel = (inside - ior * cos) / (inside + ior * cos);
    let reflectance = (perpendicular * perpendicular + parallel * parallel) / 2.0;
    Refracted { cos_inside: inside, transmittance: 1.0 - reflectance }
}
