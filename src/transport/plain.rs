//! Plain surfaces, the most frequent ones: a single opaque layer whose reflection is proportional to the incoming light.
//! Shading them needs no lists of materials and layers, and gives the same bits as [`super::shading_point::ShadingPoint`].

use super::direct_light::{LitSurface, emitted_light};
use super::radiance::Radiance;
use super::ray_state::RayState;
use super::reflect::{Mirror, MirrorContext, reflected_radiance};
use super::scatter::mirror_direction;
use super::shading_point::{Bumped, ShadedLayer, texture_context};
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::math::{DVec3, Ray};
use crate::world::{Intersection, Part, World};
use std::slice;

/// Point of a plain surface, with its one layer.
pub(super) struct PlainPoint<'w> {
    part: &'w Part,
    point: DVec3,
    /// Normal without bumps, length 1, towards the ray's origin.
    smooth: DVec3,
    shaded: ShadedLayer<'w>,
}

impl<'w> PlainPoint<'w> {
    /// Evaluates the material at the hit `found` of `ray` on the plain surface of a part. `None` if the surface
    /// transmits light at this point although its material counts as opaque: an `image_map` that is wrapped around the
    /// origin or the y axis has no colour there.
    #[inline(always)]
    pub fn new(world: &'w World, part: &'w Part, ray: &Ray, found: &Intersection) -> Option<Self> {
        let surface = found.surface(ray);
        let smooth = if ray.dir.dot(surface.normal) > 0.0 { -surface.normal } else { surface.normal };
        let layer = &world.materials[part.outside.material as usize].layers[0];
        let (mut normal, mut weight) = (smooth, Rgb::ONE);
        let color = match layer.color_everywhere(false).filter(|_| layer.normal.is_none()) {
            Some(color) => color,
            None => {
                let (_, mut context) = texture_context(world, &part.outside, found, &surface, smooth, ray);
                if let Some(bumps) = &layer.normal {
                    let bumped = Bumped::new(bumps, &context, smooth, &part.outside, None);
                    (normal, weight, context.normal) = (bumped.lit, bumped.weight, bumped.seen);
                }
                layer.color(&context, false)
            }
        };
        if color.transmittance() != Rgb::ZERO {
            return None;
        }
        let opacity = color.opacity(world.opacity_by_color);
        let cos = -ray.dir.dot(normal);
        let shaded = ShadedLayer { layer, color, opacity, weight, normal, cos, is_translucent: false };
        Some(Self { part, point: surface.point, smooth, shaded })
    }
}

impl<'w> LitSurface<'w> for PlainPoint<'w> {
    fn part(&self) -> &'w Part {
        self.part
    }

    fn point(&self) -> DVec3 {
        self.point
    }

    fn smooth_normal(&self) -> DVec3 {
        self.smooth
    }

    fn top_normal(&self) -> DVec3 {
        self.shaded.normal
    }

    #[inline(always)]
    fn any_layer(&self, test: impl Fn(&ShadedLayer<'w>) -> bool) -> bool {
        test(&self.shaded)
    }

    #[inline(always)]
    fn weighted_layer_sum(&self, mut light: impl FnMut(&ShadedLayer<'w>) -> Rgb) -> Rgb {
        light(&self.shaded)
    }

    #[inline(always)]
    fn for_each_layer(&self, mut visit: impl FnMut(f64, &ShadedLayer<'w>)) {
        visit(1.0, &self.shaded);
    }
}

impl<'w> Tracer<'w> {
    /// Adds to `sum` the light that a plain surface emits, and the light of sources and photons that it reflects along the
    /// ray.
    pub(super) fn add_plain_light(&mut self, state: &RayState, at: &PlainPoint<'w>, sum: &mut Radiance) {
        let mut light = at.shaded.weight * emitted_light(&at.shaded, self.context.has_ambient);
        self.add_light_of_sources(state, at, &mut light);
        if self.context.photons.is_some() {
            light += self.photon_light(state, at);
        }
        sum.rgb += state.throughput * light;
    }

    /// Replaces a ray by the ray that the plain surface at its hit reflects. False, without any effect, if the surface reflects
    /// none.
    pub(super) fn reflect_at_plain_point(
        &mut self,
        state: &mut RayState,
        hit: &Intersection,
        at: &PlainPoint<'w>,
    ) -> bool {
        if at.shaded.layer.finish.mirror.is_none() || state.level >= self.max_trace_level {
            return false;
        }
        let interface = self.interface(state, hit);
        let world = self.context.world;
        let context = MirrorContext { weight: state.weight, bailout: self.adc_bailout, interface: &interface, world };
        let Some(mirror) = Mirror::new(&at.shaded, 1.0, context) else { return false };
        let out = mirror_direction(state.ray.dir, at.shaded.normal, at.smooth);
        let bounce = mirror.bounce();
        let share = reflected_radiance(slice::from_ref(&mirror), at.point, context, bounce, out, Rgb::ONE);
        self.counts.reflected += 1;
        state.ray = Ray::new(at.point, out);
        (state.level, state.weight, state.is_reflected) = (state.level + 1, bounce.weight, true);
        (state.throughput, state.transparency) = (state.throughput * share, 0.0);
        state.gather_rank = None;
        state.n_surfaces += 1;
        true
    }
}
