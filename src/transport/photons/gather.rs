//! Estimates of the light of stored photons.

use super::super::direct_light::{Incidence, LitSurface, highlight_factor};
use super::super::ray_state::RayState;
use super::super::shading_point::ShadedLayer;
use super::super::tracer::Tracer;
use super::map::{FoundPhoton, SearchPoint};
use super::{Found, Photons, SearchedMap};
use crate::color::Rgb;
use crate::math::{DVec3, fp};
use std::f64::consts::PI;

/// Factor of the radius of a search that is repeated because too few photons were found.
const EXPANSION: f64 = 3.0;
/// Minimum cosine of the angle of incidence by which flux is divided.
const MIN_COS: f64 = 0.1;
/// Factor of the normal in [`SearchPoint::flattening`] (quirk: `photons_off_surface`).
const FLATTENING: f64 = 16.0;

/// True if a layer shows the light of photons.
pub(super) fn reflects_photons(shaded: &ShadedLayer) -> bool {
    let finish = &shaded.layer.finish;
    let is_diffuse = finish.diffuse != 0.0 || finish.diffuse_back != 0.0;
    is_diffuse && shaded.opacity != 0.0 || finish.has_highlights()
}

impl Photons {
    /// Finds the photons of an estimate in one of the maps, and returns the radius that the photons fill. `buffers` receive
    /// the photons, first, and those of a second search.
    fn photons_and_radius(&self, map: &SearchedMap, at: SearchPoint, buffers: &mut [Found; 2]) -> f64 {
        let [found, farther] = buffers;
        let [least, most] = self.gather;
        let narrow = map.photons.find_nearest_and_radius(at, map.radius, most, found);
        let n_found = found.len();
        if n_found >= least {
            return narrow;
        }
        // Search farther, unless the density rises too much at a border
        let before = n_found as f64 / (narrow * narrow);
        let wide = map.photons.find_nearest_and_radius(at, map.radius * EXPANSION, most, farther);
        let after = farther.len() as f64 / (wide * wide);
        if farther.len() < self.expand_min || after <= before * (1.0 + self.max_increase) {
            std::mem::swap(found, farther);
            return wide;
        }
        narrow
    }
}

impl Tracer<'_> {
    /// Returns the radiance that photons cause by diffuse and specular reflection at a surface. Rays that gather light for
    /// radiosity see no highlights (quirk: `radiosity_without_highlights`).
    #[inline(never)]
    pub(in super::super) fn photon_light<'s>(&mut self, state: &RayState, surface: &impl LitSurface<'s>) -> Rgb {
        let Some(photons) = &self.context.photons else { return Rgb::ZERO };
        if photons.surface.photons.is_empty() || !surface.part().collects_photons {
            return Rgb::ZERO;
        }
        if !surface.any_layer(reflects_photons) {
            return Rgb::ZERO;
        }
        let at = SearchPoint { point: surface.point(), flattening: FLATTENING * surface.top_normal() };
        let radius = photons.photons_and_radius(&photons.surface, at, &mut self.photon_buffers);
        let found = &self.photon_buffers[0];
        if found.is_empty() || radius <= 0.0 {
            return Rgb::ZERO;
        }
        let (both_sides, smooth) = (surface.part().double_illuminate, surface.smooth_normal());
        let has_highlights = state.bounces == 0;
        let sum = surface.weighted_layer_sum(|shaded| {
            let finish = &shaded.layer.finish;
            let has_highlights = has_highlights && finish.has_highlights();
            // Sum the terms of `diffuse_factor` without the factors that all photons share
            let (mut diffuse, mut highlights) = (Rgb::ZERO, Rgb::ZERO);
            for found in found.iter() {
                let photon = photons.surface.photons.power(found.index());
                let to_light = -photon.dir();
                let cos = shaded.normal.dot(to_light);
                // The density of photons contains the cosine at the smooth surface (quirk: `photons_from_behind`).
                let flux = photon.flux() / smooth.dot(to_light).max(MIN_COS);
                let is_front = cos > 0.0 || both_sides;
                let amount = if is_front { finish.diffuse } else { finish.diffuse_back };
                if amount != 0.0 && !shaded.is_translucent {
                    diffuse += flux * (amount * fp::power(cos.abs(), finish.brilliance));
                }
                if is_front && has_highlights {
                    let at = Incidence { dir: state.ray.dir, normal: shaded.normal, to_light, cos };
                    highlights += highlight_factor(shaded, &at) * flux;
                }
            }
            shaded.weight * (shaded.color.rgb * shaded.opacity * diffuse + highlights)
        });
        sum / (PI * radius * radius)
    }

    /// Returns the light of photons at a point of a medium, times the phase function that `phase` returns for the cosine
    /// of the angle between ray and light.
    #[inline(never)]
    pub(in super::super) fn photon_fluence(&mut self, p: DVec3, dir: DVec3, phase: impl Fn(f64) -> f64) -> Rgb {
        let Some(photons) = &self.context.photons else { return Rgb::ZERO };
        if photons.media.photons.is_empty() {
            return Rgb::ZERO;
        }
        let radius = photons.photons_and_radius(&photons.media, SearchPoint::in_space(p), &mut self.photon_buffers);
        let found = &self.photon_buffers[0];
        if radius <= 0.0 {
            return Rgb::ZERO;
        }
        let light = |found: &FoundPhoton| {
            let photon = photons.media.photons.power(found.index());
            phase(-dir.dot(photon.dir())) * photon.flux()
        };
        let sum: Rgb = found.iter().map(light).sum();
        sum / (4.0 / 3.0 * PI * radius * radius * radius)
    }
}
