//! Pigments, normals and layers at a hit, evaluated at one point.

use super::context::Quality;
use super::direct_light::LitSurface;
use super::interface::Interface;
use super::reflect::unreflected_share_if_conserving;
use crate::color::{Color, Rgb, gray};
use crate::math::{DVec2, DVec3, Ray, cancel};
use crate::pattern::{Space, TextureContext};
use crate::shape::{Kernel, TextureWeights};
use crate::texture::NormalProgram;
use crate::world::{Intersection, Layer, Material, Part, PlacedMaterial, SolidNode, Surface, World};
use smallvec::SmallVec;
use std::ops::Range;

/// One layer of a texture, evaluated at a point.
pub(super) struct ShadedLayer<'w> {
    pub layer: &'w Layer,
    /// Colour of the pigment.
    pub color: Color,
    /// Share of the pigment that is not transparent.
    pub opacity: f64,
    /// Transmittance of the layers above.
    pub weight: Rgb,
    /// Normal with the layer's bumps, length 1, in world space.
    pub normal: DVec3,
    /// Cosine of the angle between the reversed ray and `normal`; negative where bumps are seen from behind.
    pub cos: f64,
    /// True if subsurface light transport replaces the layer's diffuse reflection.
    pub is_translucent: bool,
}

impl<'w> ShadedLayer<'w> {
    /// Returns the topmost layer of a texture without bumps, at a point where its colour is known.
    pub fn on_top(layer: &'w Layer, color: Color, at: &TextureContext, opacity_by_color: bool) -> Self {
        let (weight, normal) = (Rgb::ONE, at.normal);
        let (opacity, cos) = (color.opacity(opacity_by_color), -at.ray.dot(normal));
        Self { layer, color, opacity, weight, normal, cos, is_translucent: false }
    }
}

/// One texture, evaluated at a point. Where a pattern blends several textures, each is lit, reflects and refracts
/// separately, and the result is the sum weighted by their shares (quirk: `blend_by_light`).
pub(super) struct MaterialSample {
    /// Share of the texture in a blend of textures, from 0 to 1.
    pub share: f64,
    /// Normal with the bumps of the topmost layer, length 1, towards the ray's origin.
    pub normal: DVec3,
    /// Positions in [`ShadingPoint::layers`] of the layers, from the topmost to the lowest visible one; never empty.
    layers: Range<usize>,
    /// Transmittance of all layers, for light from beyond the surface.
    pub transmittance: Rgb,
}

/// The point where a ray hits a surface, with the materials at that point.
pub(super) struct ShadingPoint<'w> {
    pub part: &'w Part,
    pub point: DVec3,
    /// Normal without bumps, length 1, towards the ray's origin.
    pub smooth: DVec3,
    /// Materials at the point; empty only if all shares are too small.
    pub materials: SmallVec<[MaterialSample; 1]>,
    /// Layers of all materials, one material after another.
    layers: SmallVec<[ShadedLayer<'w>; 2]>,
}

impl<'w> ShadingPoint<'w> {
    /// Evaluates the materials at the hit `found` of `ray` on the surface `surface`; `interface` is the optical boundary at the hit.
    // (Forced: the compiler would return a value of this size by a copy.)
    #[inline(always)]
    pub fn new(
        world: &'w World,
        ray: &Ray,
        (found, surface): (&Intersection, &Surface),
        quality: &Quality,
        interface: &Interface,
    ) -> Self {
        let part = &world.parts[found.part_number() as usize];
        let from_inside = ray.dir.dot(surface.normal) > 0.0;
        let smooth = if from_inside { -surface.normal } else { surface.normal };
        let mut this = Self { part, point: surface.point, smooth, materials: SmallVec::new(), layers: SmallVec::new() };
        this.collect_materials(world, ray, found, (surface, from_inside), (quality, interface));
        this
    }

    /// Evaluates all materials at the hit. The surface is hit from inside if `from_inside` is true.
    fn collect_materials(
        &mut self,
        world: &'w World,
        ray: &Ray,
        found: &Intersection,
        (surface, from_inside): (&Surface, bool),
        (quality, interface): (&Quality, &Interface),
    ) {
        let normal = self.smooth;
        let mut painter = Painter {
            placed: &self.part.outside,
            quality,
            interface,
            opacity_by_color: world.opacity_by_color,
            bailout: world.adc_bailout,
            pattern_normal: normal,
            materials: &mut self.materials,
            layers: &mut self.layers,
        };
        each_material(world, found, surface, from_inside, |placed, share| {
            let (material, ctx) = texture_context(world, placed, found, surface, normal, ray);
            painter.placed = placed;
            painter.collect_material(material, &ctx, share, None);
        });
    }

    /// Returns all layers of all materials at the point.
    pub fn layers(&self) -> impl Iterator<Item = &ShadedLayer<'w>> {
        self.layers.iter()
    }

    /// Returns the layers of a material, from the topmost to the lowest visible one.
    pub fn layers_of(&self, material: &MaterialSample) -> &[ShadedLayer<'w>] {
        &self.layers[material.layers.clone()]
    }

    /// True if no ray continues: no material transmits or mirrors light.
    pub fn ends_rays(&self) -> bool {
        self.materials.iter().all(|material| material.transmittance == Rgb::ZERO)
            && self.layers.iter().all(|shaded| shaded.layer.finish.mirror.is_none())
    }
}

impl<'w> LitSurface<'w> for ShadingPoint<'w> {
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
        self.layers.first().map_or(self.smooth, |shaded| shaded.normal)
    }

    #[inline]
    fn any_layer(&self, test: impl Fn(&ShadedLayer<'w>) -> bool) -> bool {
        self.layers.iter().any(test)
    }

    // (Forced: with several callers, the compiler would make this a call.)
    #[inline(always)]
    fn weighted_layer_sum(&self, mut light: impl FnMut(&ShadedLayer<'w>) -> Rgb) -> Rgb {
        let layers = self.layers.as_slice();
        let mut sum = Rgb::ZERO;
        for material in self.materials.as_slice() {
            let mut sum_of_layers = Rgb::ZERO;
            for shaded in &layers[material.layers.clone()] {
                sum_of_layers += light(shaded);
            }
            sum += material.share * sum_of_layers;
        }
        sum
    }

    fn for_each_layer(&self, mut visit: impl FnMut(f64, &ShadedLayer<'w>)) {
        for material in &self.materials {
            self.layers_of(material).iter().for_each(|shaded| visit(material.share, shaded));
        }
    }
}

/// Collects the materials at a point of a surface.
struct Painter<'w, 'a> {
    placed: &'w PlacedMaterial,
    quality: &'a Quality,
    interface: &'a Interface,
    opacity_by_color: bool,
    bailout: f64,
    /// Normal that the patterns `slope` and `aoi` use: the result of the last bumps before them, in the space of those
    /// bumps (quirk: `slope_after_bumps`).
    pattern_normal: DVec3,
    materials: &'a mut SmallVec<[MaterialSample; 1]>,
    layers: &'a mut SmallVec<[ShadedLayer<'w>; 2]>,
}

impl<'w> Painter<'w, '_> {
    /// Adds a material with its share. If a layer is a pattern of textures, only the textures that the pattern selects
    /// are added, and the other layers are ignored.
    fn collect_material(
        &mut self,
        material: &'w Material,
        ctx: &TextureContext,
        share: f64,
        frame: Option<&PatternSpaces>,
    ) {
        match material.choice() {
            Some(choice) => {
                let (number, inner) = choice.pattern.number_and_entry_context(&self.context_with_pattern_normal(ctx));
                let inner = TextureContext { normal: ctx.normal, ..inner };
                let within = PatternSpaces { space: &choice.space, outer: frame };
                let mut shares = choice.shares(number);
                // quirk: upper_texture_first
                if !choice.averages() {
                    shares.reverse();
                }
                for (part, s) in shares {
                    if cancel::is_cancelled() {
                        break;
                    }
                    self.collect_material(part, &inner, share * s, Some(&within));
                }
            }
            None => self.add(material, ctx, share, frame),
        }
    }

    /// Returns the texture context with the normal that `slope` and `aoi` use in place of its own.
    fn context_with_pattern_normal(&self, ctx: &TextureContext) -> TextureContext {
        TextureContext { normal: self.pattern_normal, ..*ctx }
    }

    /// Adds the evaluated layers of a material. At a quality level without light sources, only the lowest visible layer
    /// is added (quirk: `unlit_layers`).
    fn add(&mut self, material: &'w Material, ctx: &TextureContext, share: f64, frame: Option<&PatternSpaces>) {
        let first = self.layers.len();
        let mut transmittance = Rgb::ONE;
        for layer in &material.layers {
            let bumps = layer.normal.as_ref().filter(|_| self.quality.reflection);
            let use_quick_color = !self.quality.pigments;
            let bumped = match bumps {
                None => Bumped { lit: ctx.normal, seen: self.pattern_normal, weight: Rgb::ONE },
                Some(bumps) => {
                    Bumped::new(bumps, &self.context_with_pattern_normal(ctx), ctx.normal, self.placed, frame)
                }
            };
            let Bumped { lit: normal, seen, weight } = bumped;
            // quirk: slope_after_bumps
            if bumps.is_some() && weight == Rgb::ONE {
                self.pattern_normal = seen;
            }
            let weight = transmittance * weight;
            let seen_from = || TextureContext { normal: seen, ..*ctx };
            let color =
                layer.color_everywhere(use_quick_color).unwrap_or_else(|| layer.color(&seen_from(), use_quick_color));
            let cos = -ctx.ray.dot(normal);
            let opacity = color.opacity(self.opacity_by_color);
            if !self.quality.lights {
                self.layers.truncate(first);
            }
            let weight = if self.quality.lights { weight } else { Rgb::ONE };
            let is_translucent = layer.finish.scattering_length.is_some() && self.quality.subsurface;
            let shaded = ShadedLayer { layer, color, opacity, weight, normal, cos, is_translucent };
            transmittance *= color.transmittance();
            // quirk: conserve_energy_without_pigment
            if layer.finish.conserve_energy && !layer.is_outside_once_pictures(&seen_from(), use_quick_color) {
                transmittance *= unreflected_share_if_conserving(&shaded, self.interface);
            }
            self.layers.push(shaded);
            // quirk: layers_below_adc_bailout
            if transmittance == Rgb::ZERO || gray(transmittance) <= self.bailout {
                break;
            }
        }
        let top = self.layers.get(first);
        let (normal, refraction) = top.map_or((ctx.normal, 1.0), |top| (top.normal, top.layer.finish.refraction));
        let transmittance = refraction * transmittance;
        self.materials.push(MaterialSample { share, normal, layers: first..self.layers.len(), transmittance });
    }
}

/// A perturbed normal.
pub(super) struct Bumped {
    /// Normal for shading, length 1, in world space.
    pub lit: DVec3,
    /// Normal for the patterns of the pigment.
    pub seen: DVec3,
    /// Factor of the light: 1, or NaN where the bumps are not finite (quirk: `nan_normal_is_black`).
    pub weight: Rgb,
}

impl Bumped {
    /// Perturbs `normal` in the space of the texture. Within the entry of a map, or a texture with `uv_mapping`, bumps start
    /// from a normal of length 1, and the pigment uses the normal of that space (quirk: `bumps_within_maps`).
    pub fn new(
        bumps: &NormalProgram,
        ctx: &TextureContext,
        normal: DVec3,
        placed: &PlacedMaterial,
        frame: Option<&PatternSpaces>,
    ) -> Self {
        let within = frame.is_some() || bumps.framed;
        let place = placed.place.as_deref().filter(|_| within || !bumps.stays);
        let local = place.map_or(normal, |m| m.inverse_transform_normal(normal));
        let local = frame.map_or(local, |frame| frame.normal_to_innermost(local));
        let local = if within { local.normalize_or(local) } else { local };
        let inner = bumps.perturb(ctx, local);
        let outer = frame.map_or(inner, |frame| frame.normal_from_innermost(inner));
        let lit = place.map_or(outer, |m| m.transform_normal(outer));
        let seen = if within { inner } else { lit };
        let seen = if bumps.forbids_normalization() { seen } else { seen.normalize_or(seen) };
        match seen.is_finite() {
            true => Self { lit: lit.normalize_or(normal), seen, weight: Rgb::ONE },
            false => Self { lit: normal, seen: normal, weight: Rgb::NAN },
        }
    }
}

/// Spaces of the nested patterns that chose a texture, the innermost first.
pub(super) struct PatternSpaces<'a> {
    /// Space of the innermost pattern.
    pub space: &'a Space,
    /// Spaces of the patterns around it.
    pub outer: Option<&'a PatternSpaces<'a>>,
}

impl PatternSpaces<'_> {
    fn normal_to_innermost(&self, n: DVec3) -> DVec3 {
        self.space.normal_to_pattern_space(self.outer.map_or(n, |outer| outer.normal_to_innermost(n)))
    }

    fn normal_from_innermost(&self, n: DVec3) -> DVec3 {
        let n = self.space.normal_from_pattern_space(n);
        self.outer.map_or(n, |outer| outer.normal_from_innermost(n))
    }
}

/// Calls `visit` with each material on the side that a ray hits, and its share; mostly with one.
fn each_material<'w>(
    world: &'w World,
    found: &Intersection,
    surface: &Surface,
    from_inside: bool,
    mut visit: impl FnMut(&'w PlacedMaterial, f64),
) {
    let part = &world.parts[found.part_number() as usize];
    let Some(uncommon) = &part.uncommon else { return visit(&part.outside, 1.0) };
    if let Some(inside) = uncommon.inside.as_ref().filter(|_| from_inside != found.keeps_texture_sides()) {
        return visit(inside, 1.0);
    }
    if let Some(cut) = uncommon.cut {
        let holds = |(node, placed): &'w (SolidNode, PlacedMaterial)| node.inside(surface.point).then_some(placed);
        let materials: SmallVec<[&PlacedMaterial; 4]> = world.cuts[cut as usize].iter().filter_map(holds).collect();
        if !materials.is_empty() {
            let share = 1.0 / materials.len() as f64;
            return materials.into_iter().for_each(|placed| visit(placed, share));
        }
    }
    if uncommon.embedded.is_empty() {
        return visit(&part.outside, 1.0);
    }
    // quirk: embedded_shares_below_adc_bailout
    let mut seen = TextureWeights::new();
    for (number_or_0, share) in found.leaf.shape.texture_weights(surface.object_point, &found.hit) {
        match seen.iter_mut().find(|(other, _)| *other == number_or_0) {
            _ if share < world.adc_bailout => {}
            Some((_, sum)) => *sum += share,
            None => seen.push((number_or_0, share)),
        }
    }
    for (number_or_0, share) in seen {
        let own = number_or_0.checked_sub(1).and_then(|i| uncommon.embedded.get(i as usize));
        visit(own.unwrap_or(&part.outside), share);
    }
}

/// Returns a material and the context for its patterns; the context's normal is in world space.
pub(super) fn texture_context<'w>(
    world: &'w World,
    placed: &PlacedMaterial,
    found: &Intersection,
    surface: &Surface,
    normal: DVec3,
    ray: &Ray,
) -> (&'w Material, TextureContext) {
    let material = &world.materials[placed.material as usize];
    let on_surface = world.parts[found.part_number() as usize].uv;
    // One colour everywhere does not depend on the point.
    let is_patterned = !material.solid;
    let uv = if is_patterned && (on_surface || material.uv) { found.mapped_uv(surface) } else { DVec2::ZERO };
    let ctx = TextureContext {
        p: match is_patterned {
            true => placed.local(if on_surface { uv.extend(0.0) } else { surface.point }),
            false => surface.point,
        },
        world: surface.point,
        uv,
        normal,
        ray: ray.dir,
        noise: world.noise,
        waves: world.waves,
    };
    (material, ctx)
}

/// Returns the transmittance of all layers where a shadow ray hits `found`; `use_quick_color` selects `quick_color`.
pub(super) fn shadow_transmittance(world: &World, ray: &Ray, found: &Intersection, use_quick_color: bool) -> Rgb {
    let part = &world.parts[found.part_number() as usize];
    let outside = &world.materials[part.outside.material as usize];
    if part.uncommon.is_none() && outside.solid && !use_quick_color {
        return outside.pass;
    }
    let surface = found.surface(ray);
    let from_inside = ray.dir.dot(surface.normal) > 0.0;
    // quirk: slope_faces_ray
    let normal = if from_inside { -surface.normal } else { surface.normal };
    let (mut sum, mut shares) = (Rgb::ZERO, 0.0);
    each_material(world, found, &surface, from_inside, |placed, share| {
        let (material, ctx) = texture_context(world, placed, found, &surface, normal, ray);
        sum += share * material_transmittance(material, &ctx, use_quick_color);
        shares += share;
    });
    // quirk: missing_shares_darken_twice
    sum * shares
}

/// Returns the product of the transmittances of a material's layers.
fn material_transmittance(material: &Material, ctx: &TextureContext, use_quick_color: bool) -> Rgb {
    material.layers.iter().fold(Rgb::ONE, |pass, layer| match &layer.choice {
        Some(choice) => {
            let (number, inner) = choice.pattern.number_and_entry_context(ctx);
            let shares = choice.shares(number);
            pass * shares.iter().fold(Rgb::ZERO, |sum, (part, share)| {
                sum + *share * material_transmittance(part, &inner, use_quick_color)
            })
        }
        None => pass * layer.color(ctx, use_quick_color).transmittance(),
    })
}
