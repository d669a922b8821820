//! Estimates of the light of stored photons.

use super::super::direct_light::{Incidence, LitSurface, diffuse_factor, highlight_factor};
use super::super::ray_state::RayState;
use super::super::shading_point::ShadedLayer;
use super::super::tracer::Tracer;
use super::{Found, Photons};
use crate::color::Rgb;
use crate::math::DVec3;
use std::f64::consts::PI;

/// Factor of the radius of a search that is repeated because too few photons were found.
const EXPANSION: f64 = 3.0;
/// Minimum cosine of the angle of incidence by which flux is divided.
const MIN_COS: f64 = 0.05;

impl Photons {
    /// Finds the photons of an estimate on a surface, and returns the radius that they fill.
    fn surface_photons_and_radius(&self, p: DVec3, found: &mut Found) -> f64 {
        let [least, most] = self.gather;
        let narrow = self.surface.find_nearest_and_radius(p, self.radius[0], most, found);
        if found.len() >= least {
            return narrow;
        }
        // Search farther, unless the density rises too much at a border
        let before = found.len() as f64 / (narrow * narrow);
        let mut more = Found::new();
        let wide = self.surface.find_nearest_and_radius(p, self.radius[0] * EXPANSION, most, &mut more);
        let after = more.len() as f64 / (wide * wide);
        if more.len() < self.expand_min || after <= before * (1.0 + self.max_increase) {
            *found = more;
            return wide;
        }
        narrow
    }
}

impl Tracer<'_> {
    /// Returns the radiance that photons cause by diffuse and specular reflection at a surface.
    #[inline(never)]
    pub(in super::super) fn photon_light<'s>(&mut self, state: &RayState, surface: &impl LitSurface<'s>) -> Rgb {
        let Some(photons) = &self.context.photons else { return Rgb::ZERO };
        if photons.surface.is_empty() || !surface.part().collects_photons {
            return Rgb::ZERO;
        }
        let reflects =
            |shaded: &ShadedLayer| shaded.layer.finish.diffuse != 0.0 || shaded.layer.finish.diffuse_back != 0.0;
        if !surface.any_layer(reflects) {
            return Rgb::ZERO;
        }
        let radius = photons.surface_photons_and_radius(surface.point(), &mut self.found_photons);
        if self.found_photons.is_empty() || radius <= 0.0 {
            return Rgb::ZERO;
        }
        let both_sides = surface.part().double_illuminate;
        let found = &self.found_photons;
        let sum = surface.weighted_layer_sum(|shaded| {
            let mut sum = Rgb::ZERO;
            for (_, index) in found {
                let photon = photons.surface.power(*index);
                let to_light = -photon.dir();
                let cos = shaded.normal.dot(to_light);
                // The density of photons contains the cosine at the smooth surface.
                let smooth_cos = surface.smooth_normal().dot(to_light).abs().max(MIN_COS);
                let at = Incidence { dir: state.ray.dir, normal: shaded.normal, to_light, cos };
                let mut reflected = diffuse_factor(shaded, &at, 0.0, both_sides);
                if cos > 0.0 || both_sides {
                    reflected += highlight_factor(shaded, &at);
                }
                sum += reflected / smooth_cos * photon.flux();
            }
            shaded.weight * sum
        });
        sum / (PI * radius * radius)
    }

    /// Returns the light of photons at a point of a medium, times the phase function that `phase` returns for the cosine
    /// of the angle between ray and light.
    #[inline(never)]
    pub(in super::super) fn photon_fluence(&mut self, p: DVec3, dir: DVec3, phase: impl Fn(f64) -> f64) -> Rgb {
        let Some(photons) = &self.context.photons else { return Rgb::ZERO };
        if photons.media.is_empty() {
            return Rgb::ZERO;
        }
        let radius =
            photons.media.find_nearest_and_radius(p, photons.radius[1], photons.gather[1], &mut self.found_photons);
        if radius <= 0.0 {
            return Rgb::ZERO;
        }
        let light = |(_, index): &(f32, u32)| {
            let photon = photons.media.power(*index);
            phase(-dir.dot(photon.dir())) * photon.flux()
        };
        let sum: Rgb = self.found_photons.iter().map(light).sum();
        sum / (4.0 / 3.0 * PI * radius * radius * radius)
    }
}
