//! Surfaces that show a single layer, the most frequent ones: of a material with one layer, or of one that a pattern selects,
//! such as the squares of a checkerboard. Shading them needs no lists of materials and layers, and gives the same bits as
//! [`super::shading_point::ShadingPoint`].
//!
//! Plain surfaces are the opaque ones without any special effect, see [`crate::world::Shading`].

use super::direct_light::{LitSurface, emitted_light};
use super::interface::Interface;
use super::radiance::Radiance;
use super::ray_state::RayState;
use super::reflect::{Mirror, MirrorContext, film_factor, reflected_radiance, unreflected_share_if_conserving};
use super::scatter::{RayAtMaterial, mirror_direction};
use super::shading_point::{Bumped, PatternSpaces, ShadedLayer, texture_context};
use super::tracer::Tracer;
use crate::color::{Color, Rgb};
use crate::math::{DVec3, Ray};
use crate::pattern::TextureContext;
use crate::world::{Intersection, Layer, Part, Surface, World};
use std::slice;

/// Point of a surface with a single layer; `IS_PLAIN` is true for a plain surface. (A parameter of the type, so that the
/// compiler inlines the code of plain surfaces into the loop over rays.)
pub(super) struct SingleLayerPoint<'w, const IS_PLAIN: bool> {
    part: &'w Part,
    pub point: DVec3,
    /// Normal without bumps, length 1, towards the ray's origin.
    smooth: DVec3,
    pub shaded: ShadedLayer<'w>,
    /// Transmittance for light from beyond the surface; 0 for a plain surface.
    transmittance: Rgb,
}

/// A layer at a point: its pigment and its normal.
struct Look<'w> {
    layer: &'w Layer,
    color: Color,
    /// Normal with the layer's bumps, length 1, in world space.
    normal: DVec3,
    /// Factor of the light, see [`Bumped::weight`].
    weight: Rgb,
    /// True if reflected light is subtracted from transmitted light at this point.
    conserves_energy: bool,
}

impl<'w> Look<'w> {
    /// Evaluates a layer that has bumps or a pattern. `normal` is that of the context, which need not be read again; `frame` is
    /// the space of the pattern that selected the layer, `None` if it is the part's only one.
    #[inline(always)]
    fn at(
        layer: &'w Layer,
        context: &mut TextureContext,
        mut normal: DVec3,
        part: &Part,
        frame: Option<&PatternSpaces>,
    ) -> Self {
        let mut weight = Rgb::ONE;
        if let Some(bumps) = &layer.normal {
            let bumped = Bumped::new(bumps, context, normal, &part.outside, frame);
            (normal, weight, context.normal) = (bumped.lit, bumped.weight, bumped.seen);
        }
        // quirk: conserve_energy_without_pigment
        let conserves_energy = layer.finish.conserve_energy && !layer.is_outside_once_pictures(context, false);
        Self { layer, color: layer.color(context, false), normal, weight, conserves_energy }
    }

    /// Returns the look of a layer with one colour everywhere and without bumps; `None` for others.
    #[inline(always)]
    fn everywhere(layer: &'w Layer, normal: DVec3) -> Option<Self> {
        let color = layer.color_everywhere(false).filter(|_| layer.normal.is_none())?;
        Some(Self { layer, color, normal, weight: Rgb::ONE, conserves_energy: layer.finish.conserve_energy })
    }
}

impl<'w, const IS_PLAIN: bool> SingleLayerPoint<'w, IS_PLAIN> {
    /// Evaluates the only layer of a part's material at the hit `found` of `ray`, on the surface `surface`. `interface` is the
    /// optical boundary, which does not count for a plain surface.
    #[inline(always)]
    fn evaluate(
        world: &'w World,
        part: &'w Part,
        ray: &Ray,
        (found, surface): (&Intersection, &Surface),
        interface: &Interface,
    ) -> Self {
        let smooth = facing_normal(surface, ray);
        let layer = &world.materials[part.outside.material as usize].layers[0];
        let look = Look::everywhere(layer, smooth).unwrap_or_else(|| {
            // (The compiler would copy the context if the pair were taken apart.)
            let mut evaluation = texture_context(world, &part.outside, found, surface, smooth, ray);
            Look::at(layer, &mut evaluation.1, smooth, part, None)
        });
        Self::new(world, part, (surface.point, smooth), ray.dir, &look, interface)
    }

    /// Creates the point of a layer with this look; `smooth` is the normal without bumps.
    #[inline(always)]
    fn new(
        world: &World,
        part: &'w Part,
        (point, smooth): (DVec3, DVec3),
        ray_dir: DVec3,
        look: &Look<'w>,
        interface: &Interface,
    ) -> Self {
        let &Look { layer, color, normal, weight, conserves_energy } = look;
        let opacity = color.opacity(world.opacity_by_color);
        let shaded =
            ShadedLayer { layer, color, opacity, weight, normal, cos: -ray_dir.dot(normal), is_translucent: false };
        let mut transmittance = color.transmittance();
        if !IS_PLAIN && conserves_energy {
            transmittance *= unreflected_share_if_conserving(&shaded, interface);
        }
        if !IS_PLAIN {
            transmittance = layer.finish.refraction * transmittance;
        }
        Self { part, point, smooth, shaded, transmittance }
    }
}

/// Returns the normal of a surface on the side of the ray's origin.
#[inline(always)]
pub(super) fn facing_normal(surface: &Surface, ray: &Ray) -> DVec3 {
    if ray.dir.dot(surface.normal) > 0.0 { -surface.normal } else { surface.normal }
}

impl<'w> SingleLayerPoint<'w, false> {
    /// Evaluates the layer that a pattern of materials selects at the hit `found` of `ray`, if the part's material
    /// [selects single layers](crate::world::Material::selects_single_layers). `None` if the pattern blends two.
    fn of_selected_layer(
        world: &'w World,
        part: &'w Part,
        ray: &Ray,
        found: &Intersection,
        interface: &Interface,
    ) -> Option<Self> {
        let surface = found.surface(ray);
        let smooth = facing_normal(&surface, ray);
        let evaluation = texture_context(world, &part.outside, found, &surface, smooth, ray);
        let choice = evaluation.0.choice()?;
        let (number, mut inner) = choice.pattern.number_and_entry_context(&evaluation.1);
        let layer = &choice.only_material(number)?.layers[0];
        let frame = PatternSpaces { space: &choice.space, outer: None };
        let look = Look::everywhere(layer, smooth).unwrap_or_else(|| {
            let normal = inner.normal;
            Look::at(layer, &mut inner, normal, part, Some(&frame))
        });
        Some(Self::new(world, part, (surface.point, smooth), ray.dir, &look, interface))
    }
}

impl<'w> SingleLayerPoint<'w, true> {
    /// Evaluates the material at the hit `found` of `ray` on the plain surface `surface` of a part. `None` if the surface
    /// transmits light at this point although its material counts as opaque: an `image_map` that is wrapped around the
    /// origin or the y axis has no colour there.
    #[inline(always)]
    pub fn on_plain_surface(
        world: &'w World,
        part: &'w Part,
        ray: &Ray,
        (found, surface): (&Intersection, &Surface),
    ) -> Option<Self> {
        let at = Self::evaluate(world, part, ray, (found, surface), &Interface::NONE);
        if at.transmittance == Rgb::ZERO { Some(at) } else { None }
    }

    /// True if the surface reflects rays.
    pub fn has_mirror(&self) -> bool {
        self.shaded.layer.finish.mirror.is_some()
    }
}

impl<'w, const IS_PLAIN: bool> LitSurface<'w> for SingleLayerPoint<'w, IS_PLAIN> {
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
    /// Adds to `sum` the light that a surface emits, and the light of sources and photons that it reflects along the ray.
    #[inline]
    pub(super) fn add_light_of_single_layer<const IS_PLAIN: bool>(
        &mut self,
        state: &RayState,
        at: &SingleLayerPoint<'w, IS_PLAIN>,
        sum: &mut Radiance,
    ) {
        if !self.ignores_surface_light(state) {
            let mut light = at.shaded.weight * emitted_light(&at.shaded, self.context.has_ambient);
            self.add_light_of_sources(state, at, &mut light);
            if self.context.photons.is_some() {
                light += self.photon_light(state, at);
            }
            sum.rgb += state.throughput * light;
        }
        if self.context.radiosity.is_some() {
            sum.rgb += state.throughput * self.indirect_light(state, at);
        }
    }

    /// Adds the light of a surface of one layer to `sum`, and pushes the rays that continue, except the first. True if there is
    /// a first one, which then is in `state`. (Not inlined: the loop over rays is faster with the code of plain surfaces
    /// alone.)
    #[inline(never)]
    pub(super) fn shade_single_layer(
        &mut self,
        state: &mut RayState,
        hit: &Intersection<'w>,
        interface: &Interface,
        sum: &mut Radiance,
    ) -> bool {
        let world = self.context.world;
        let part = &world.parts[hit.part_number() as usize];
        let surface = hit.surface(&state.ray);
        let at = SingleLayerPoint::<false>::evaluate(world, part, &state.ray, (hit, &surface), interface);
        self.shade_at_single_layer(state, hit, &at, interface, sum)
    }

    /// As [`Self::shade_single_layer`], for a surface whose material
    /// [selects single layers](crate::world::Material::selects_single_layers). `None`, without any effect, if the pattern
    /// blends two at the hit.
    #[inline(never)]
    pub(super) fn shade_selected_layer(
        &mut self,
        state: &mut RayState,
        hit: &Intersection<'w>,
        interface: &Interface,
        sum: &mut Radiance,
    ) -> Option<bool> {
        let world = self.context.world;
        let part = &world.parts[hit.part_number() as usize];
        let at = SingleLayerPoint::of_selected_layer(world, part, &state.ray, hit, interface)?;
        Some(self.shade_at_single_layer(state, hit, &at, interface, sum))
    }

    /// As [`Self::shade_single_layer`], for an evaluated layer.
    #[inline(always)]
    fn shade_at_single_layer(
        &mut self,
        state: &mut RayState,
        hit: &Intersection<'w>,
        at: &SingleLayerPoint<'w, false>,
        interface: &Interface,
        sum: &mut Radiance,
    ) -> bool {
        let (world, part) = (self.context.world, at.part);
        self.add_light_of_single_layer(state, at, sum);
        let ends_ray = at.transmittance == Rgb::ZERO && at.shaded.layer.finish.mirror.is_none();
        if ends_ray || state.level >= self.max_trace_level {
            return false;
        }
        let transmission = self.transmission(state, at.transmittance, at.shaded.normal, interface, part.interior);
        let ray_at_material = RayAtMaterial {
            dir: state.ray.dir,
            normal: at.shaded.normal,
            smooth: at.smooth,
            share: 1.0,
            transmittance: at.transmittance,
            attenuation: self.attenuation_before(interface, part.interior, hit.t()),
        };
        let film = |out| film_factor(at.point, &at.shaded, out, world);
        let transmitted = ray_at_material.continuation(&transmission, film);
        let reflected = if transmission.is_total() { None } else { self.reflected_ray(state, at, interface) };
        let transmitted =
            transmitted.map(|path| self.transmitted_state(state, at.point, &path, interface, part.interior));
        match (reflected, transmitted) {
            (Some(reflected), transmitted) => {
                self.queue.extend(transmitted);
                reflected.replace(state, at.point);
            }
            (None, Some(transmitted)) => *state = transmitted,
            (None, None) => return false,
        }
        true
    }

    /// Replaces a ray by the ray that the plain surface at its hit reflects. False, without any effect, if the surface reflects
    /// none.
    pub(super) fn reflect_at_plain_point(
        &mut self,
        state: &mut RayState,
        hit: &Intersection,
        at: &SingleLayerPoint<'w, true>,
    ) -> bool {
        if at.shaded.layer.finish.mirror.is_none() || state.level >= self.max_trace_level {
            return false;
        }
        let interface = self.interface(state, hit);
        let Some(reflected) = self.reflected_ray(state, at, &interface) else { return false };
        reflected.replace(state, at.point);
        true
    }

    /// Returns the ray that the surface reflects; `None` if it reflects none. Counts the ray.
    #[inline]
    fn reflected_ray<const IS_PLAIN: bool>(
        &mut self,
        state: &RayState,
        at: &SingleLayerPoint<'w, IS_PLAIN>,
        interface: &Interface,
    ) -> Option<ReflectedRay> {
        let world = self.context.world;
        let context = MirrorContext { weight: state.weight, bailout: self.adc_bailout, interface, world };
        let mirror = Mirror::new(&at.shaded, 1.0, context)?;
        let dir = mirror_direction(state.ray.dir, at.shaded.normal, at.smooth);
        let bounce = mirror.bounce();
        let share = reflected_radiance(slice::from_ref(&mirror), at.point, context, bounce, dir, Rgb::ONE);
        self.counts.reflected += 1;
        Some(ReflectedRay { dir, share, weight: bounce.weight })
    }
}

/// A ray that a surface reflects.
struct ReflectedRay {
    /// Direction of the ray, length 1.
    dir: DVec3,
    /// Share of the ray's light that the surface reflects.
    share: Rgb,
    /// Importance of the ray.
    weight: f64,
}

impl ReflectedRay {
    /// Replaces the ray of `state`, which hit the surface at `point`, by the reflected ray.
    #[inline]
    fn replace(&self, state: &mut RayState, point: DVec3) {
        state.ray = Ray::new(point, self.dir);
        (state.level, state.weight, state.is_reflected) = (state.level + 1, self.weight, true);
        (state.throughput, state.transparency) = (state.throughput * self.share, 0.0);
        state.gather_rank = None;
        state.n_surfaces += 1;
    }
}
