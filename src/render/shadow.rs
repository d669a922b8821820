//! What reaches a surface of a light.

use super::refract::{Interface, Interiors};
use super::shading_point::{self, ShadingPoint};
use super::trace::{Path, Tracer};
use crate::color::Rgb;
use crate::light::LightSample;
use crate::math::{DVec3, Range, Ray};
use crate::world::{Intersection, LightSource, World};
use std::ops::ControlFlow;

/// A ray towards a light.
pub(super) struct ToLight<'a> {
    pub light: &'a LightSource,
    pub ray: Ray,
    /// Where on it something keeps light away.
    pub range: Range,
    /// To where the light is.
    pub distance: f64,
}

impl Tracer<'_> {
    /// The part of the light that comes through to a point that `path` has come to, in shadows that are soft or hard.
    pub(super) fn reaching(&mut self, light: &LightSource, point: DVec3, arriving: &LightSample, path: &Path) -> Rgb {
        match light.emitter.area.as_ref().filter(|_| self.setup.quality.extended) {
            Some(area) => self.through_area(light, area, point, arriving, path),
            None => self.unshadowed(light, point, arriving, path),
        }
    }

    /// The part of the light that comes through along one ray.
    pub(super) fn unshadowed(&mut self, light: &LightSource, point: DVec3, arriving: &LightSample, path: &Path) -> Rgb {
        let near = self.setup.world.epsilon.shadow;
        let mut range = Range { min: near, max: arriving.distance - near };
        let ray = Ray::new(point, arriving.from);
        if let Some(through) = light.through.as_ref().filter(|_| self.setup.quality.shadows) {
            let Some(passed) = through.closest(&ray, range, |_| true) else { return Rgb::ZERO };
            // What lies between it and the light is not in the way, but for air (measured on POV-Ray 3.7).
            range.max = passed.t();
        }
        if light.emitter.shadowless || !self.setup.quality.shadows || range.max <= range.min {
            return Rgb::ONE;
        }
        self.rays.shadow += 1;
        let to_light = ToLight { light, ray, range, distance: arriving.distance };
        self.passing(&to_light, &path.inside)
    }

    /// What all objects let pass. Every surface on the way takes its share, so what passes a solid is taken from twice.
    fn passing(&mut self, to_light: &ToLight, inside: &Interiors) -> Rgb {
        let ToLight { light, ref ray, range, distance } = *to_light;
        let world = self.setup.world;
        let (see_through, quick) = (world.see_through, !self.setup.quality.real);
        // First whether anything opaque is in the way: that search ends at its first hit.
        let blocks = |id: u32| {
            let object = &world.objects[id as usize];
            object.shadow && (object.opaque || !see_through)
        };
        if world.geometry.any_after(ray, range, blocks, &mut self.blockers[light.number]) {
            return Rgb::ZERO;
        }
        let hazy = light.emitter.attenuated && self.is_hazy();
        if !see_through && !hazy {
            return Rgb::ONE;
        }
        let filters = |id: u32| {
            let object = &world.objects[id as usize];
            object.shadow && !object.opaque
        };
        if world.colors_light || hazy {
            return self.colored(ray, range, filters, inside.clone(), hazy.then_some(distance));
        }
        let mut light = Rgb::ONE;
        for found in surfaces(world, ray, range, filters) {
            light *= shading_point::pass(world, ray, &found, quick);
        }
        light
    }

    /// What comes through if light also changes between surfaces: those are taken from the nearest to the farthest. Of a light that is
    /// `media_attenuation`, fog takes its share of each stretch (measured on 3.7), as far as `hazy`, the light's distance.
    fn colored(
        &mut self,
        ray: &Ray,
        range: Range,
        filters: impl Fn(u32) -> bool,
        mut inside: Interiors,
        hazy: Option<f64>,
    ) -> Rgb {
        let (mut light, mut before) = (Rgb::ONE, 0.0);
        for found in surfaces(self.setup.world, ray, range, filters) {
            if hazy.is_some() {
                light *= self.stretch(ray, before, found.t(), &inside);
            }
            light *= self.crossing(ray, &found, before, &mut inside);
            before = found.t();
        }
        match hazy {
            Some(distance) => light * self.stretch(ray, before, distance, &inside),
            None => light,
        }
    }

    /// What comes through a surface, and of what the ray leaves there, since the surface before.
    fn crossing(&mut self, ray: &Ray, found: &Intersection, before: f64, inside: &mut Interiors) -> Rgb {
        let world = self.setup.world;
        let mut light = shading_point::pass(world, ray, found, !self.setup.quality.real);
        if !self.setup.asks_inside {
            return light;
        }
        let own = world.parts[found.part() as usize].interior;
        let interior = &world.interiors[own as usize];
        if let Some(at) = inside.iter().rposition(|&i| i == own) {
            inside.remove(at);
            light *= self.shaded(own, found.t() - before);
        } else {
            inside.push(own);
        }
        if interior.caustics != 0.0 {
            let shading = ShadingPoint::new(world, ray, found, &self.setup.quality, &Interface::NONE);
            let normal = shading.coats.last().map_or(shading.smooth, |coat| coat.normal);
            light *= interior.caustic(normal.dot(ray.dir).abs());
        }
        light
    }

    /// What the air leaves of light along a stretch of a ray.
    fn stretch(&mut self, ray: &Ray, from: f64, to: f64, inside: &Interiors) -> Rgb {
        self.veil(&Ray::new(ray.at(from), ray.dir), to - from, inside).transmittance
    }
}

/// The surfaces that take their share of a light's ray, from the nearest to the farthest. One that is no farther behind another than the
/// tolerance is not met: a box thinner than that filters once, and so does the edge of its shadow (quirk: `shadow_min_distance`).
fn surfaces<'w>(world: &'w World, ray: &Ray, range: Range, filters: impl Fn(u32) -> bool) -> Vec<Intersection<'w>> {
    let mut surfaces = vec![];
    let _ = world.geometry.visit(ray, range, filters, &mut |found| {
        surfaces.push(found);
        ControlFlow::Continue(())
    });
    surfaces.sort_by(|a, b| a.t().total_cmp(&b.t()));
    let (mut last, epsilon) = (f64::NEG_INFINITY, &world.epsilon);
    surfaces.retain(|found| {
        let met = found.t() - last > epsilon.shadow.max(epsilon.own(found.leaf.shape.quirks().min_distance));
        if met {
            last = found.t();
        }
        met
    });
    surfaces
}
