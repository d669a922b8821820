//! Light that a surface emits or reflects from light sources, with a function per term of `finish` (manual, "Finish").

use super::area_light::jittered_offset;
use super::random::Purpose;
use super::ray_state::RayState;
use super::reflect::film_factor;
use super::shading_point::{ShadedLayer, ShadingPoint};
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::LightSample;
use crate::math::{DVec3, fp};
use crate::world::{LightSource, Lobe, Part};
use std::f64::consts::FRAC_PI_2;

/// Geometry of the reflection of light by one layer.
pub(super) struct Incidence {
    /// Direction of the ray that hits the surface, length 1.
    pub dir: DVec3,
    /// Surface normal N, length 1.
    pub normal: DVec3,
    /// Direction l towards the light, length 1.
    pub to_light: DVec3,
    /// Cosine of the angle of incidence, N·l; negative for light from behind.
    pub cos: f64,
}

/// Point of a surface that light sources, photons or other surfaces illuminate, with its layers.
pub(super) trait LitSurface<'w> {
    fn part(&self) -> &'w Part;
    /// Returns the point in world space.
    fn point(&self) -> DVec3;
    /// Returns the normal without bumps, length 1, towards the ray's origin.
    fn smooth_normal(&self) -> DVec3;
    /// Returns the normal of the topmost layer, with its bumps, length 1.
    fn top_normal(&self) -> DVec3;
    /// True if `test` is true for any layer.
    fn any_layer(&self, test: impl Fn(&ShadedLayer<'w>) -> bool) -> bool;
    /// Returns the sum of `light` over all layers, weighted by the shares of their materials.
    fn weighted_layer_sum(&self, light: impl FnMut(&ShadedLayer<'w>) -> Rgb) -> Rgb;
    /// Calls `visit` with each layer and the share of its material.
    fn for_each_layer(&self, visit: impl FnMut(f64, &ShadedLayer<'w>));
}

/// A light source, relative to one point of a surface.
#[derive(Clone, Copy)]
struct Source<'a> {
    light: &'a LightSource,
    /// Direction to the light's location, the centre of an `area_light`; films use this one direction (quirk:
    /// `irid_of_area_center`).
    center: DVec3,
}

impl<'w> Tracer<'w> {
    /// Returns the radiance that a surface sends along the ray by its own emission and by diffuse and specular
    /// reflection of light sources and photons, and by subsurface light transport; without `reflection`, radiosity and
    /// transmission. At a quality level without lights, it is the colour of the pigments.
    pub(super) fn emitted_and_direct_light(&mut self, state: &RayState, shading: &ShadingPoint<'w>) -> Rgb {
        if !self.context.quality.lights {
            return shading.weighted_layer_sum(|shaded| shaded.weight * shaded.color.rgb);
        }
        let mut sum =
            shading.weighted_layer_sum(|shaded| shaded.weight * emitted_light(shaded, self.context.has_ambient));
        self.add_light_of_sources(state, shading, &mut sum);
        if self.context.quality.subsurface {
            sum += self.subsurface_light(state, shading);
        }
        if self.context.photons.is_some() {
            sum += self.photon_light(state, shading);
        }
        sum
    }

    /// Adds to `sum` the radiance that the light sources of the surface cause by diffuse and specular reflection.
    #[inline]
    pub(super) fn add_light_of_sources(&mut self, state: &RayState, surface: &impl LitSurface<'w>, sum: &mut Rgb) {
        let world = self.context.world;
        // (Light that passes through targets of photons reaches other surfaces as photons.)
        self.targets_transmit_light = !surface.part().collects_photons;
        for &number in &world.lit_by[surface.part().light_set() as usize] {
            *sum += self.reflected_light(&world.lights[number as usize], state, surface);
        }
        self.targets_transmit_light = false;
    }

    /// Returns the radiance that one light source causes by diffuse and specular reflection.
    fn reflected_light(&mut self, light: &LightSource, state: &RayState, surface: &impl LitSurface<'w>) -> Rgb {
        let center = light.emitter.sample(surface.point(), DVec3::ZERO);
        let source = Source { light, center: center.to_light };
        let visibility =
            |tracer: &mut Self| tracer.visibility(light, surface.point(), &center, &state.inside, state.bounces);
        let Some(area) = self.light_grid(light, state.bounces).filter(|area| area.illumination) else {
            return self.reflected_light_of_sample(&center, source, state, surface, visibility);
        };
        // `area_illumination`: each light of the grid illuminates, with the shadow of the whole grid (quirk: `area_illumination_shadow`)
        let visibility = visibility(self);
        if visibility == Rgb::ZERO {
            return Rgb::ZERO;
        }
        let [columns, rows] = area.size.map(indices_of_sampled_lights);
        let mut sum = Rgb::ZERO;
        let random = self.random.sequence(Purpose::AreaLight);
        let sides = area.sides(-center.to_light);
        for cell in rows.clone().flat_map(|j| columns.clone().map(move |i| [i, j])) {
            if self.count_surface_and_is_stopped() {
                break;
            }
            let offset = jittered_offset(area, cell, &sides, random);
            let sample = light.emitter.sample(surface.point(), offset);
            sum += self.reflected_light_of_sample(&sample, source, state, surface, |_| visibility);
        }
        sum / (columns.len() * rows.len()) as f64
    }

    /// Returns the radiance of the light from one direction that a surface reflects along the ray, diffusely and as
    /// highlights. `visibility` is called only if any of this light is reflected.
    fn reflected_light_of_sample(
        &mut self,
        sample: &LightSample,
        Source { light, center }: Source,
        state: &RayState,
        surface: &impl LitSurface<'w>,
        visibility: impl FnOnce(&mut Self) -> Rgb,
    ) -> Rgb {
        let l = sample.to_light;
        let dir = state.ray.dir;
        // quirk: radiosity_without_highlights
        let has_highlights = state.bounces == 0;
        // quirk: area_illumination_both_sides
        let shines_through =
            light.emitter.area.as_ref().is_some_and(|area| area.illumination) && !self.context.quality.area_lights;
        let both_sides = surface.part().double_illuminate || shines_through;
        if sample.light == Rgb::ZERO || !l.is_finite() || !reflects_light(surface, l, both_sides) {
            return Rgb::ZERO;
        }
        let incident = sample.light * visibility(self);
        if incident == Rgb::ZERO {
            return Rgb::ZERO;
        }
        let sum = surface.weighted_layer_sum(|shaded| {
            let at = Incidence { dir, normal: shaded.normal, to_light: l, cos: shaded.normal.dot(l) };
            let crand = shaded.layer.finish.crand;
            let grain = if crand == 0.0 { 0.0 } else { crand * self.random.next(Purpose::Grain) };
            let mut reflected = diffuse_factor(shaded, &at, grain, both_sides);
            // quirk: double_illuminate_highlights
            if (at.cos > 0.0 || both_sides) && has_highlights && !light.emitter.shadowless {
                reflected += highlight_factor(shaded, &at);
            }
            reflected *= film_factor(surface.point(), shaded, center, self.context.world);
            shaded.weight * reflected
        });
        sum * incident
    }
}

/// Maximum number of lights along a side of a grid with `area_illumination` that all illuminate by themselves.
const MAX_SIDE: u32 = 256;
/// Number of lights along a longer side that illuminate. The light changes smoothly along a side: that of 128 evenly spaced
/// lights differs from that of all by less than a 16-bit picture shows.
const SAMPLES_OF_LONG_SIDE: u32 = 128;

/// Returns the indices of those lights along one side of an `area_illumination` grid that illuminate: all of a short
/// side, evenly spaced ones of a long side.
fn indices_of_sampled_lights(lights_on_side: u32) -> impl ExactSizeIterator<Item = u32> + Clone {
    let n_samples = if lights_on_side > MAX_SIDE { SAMPLES_OF_LONG_SIDE } else { lights_on_side };
    // The middle of each of `n_samples` equal parts
    (0..n_samples)
        .map(move |i| ((2 * u64::from(i) + 1) * u64::from(lights_on_side) / (2 * u64::from(n_samples))) as u32)
}

/// True if any layer reflects light from a direction diffusely or as a highlight.
fn reflects_light<'w>(surface: &impl LitSurface<'w>, to_light: DVec3, both_sides: bool) -> bool {
    surface.any_layer(|shaded| {
        let finish = &shaded.layer.finish;
        match both_sides || shaded.normal.dot(to_light) > 0.0 {
            true => finish.diffuse != 0.0 || finish.has_highlights(),
            false => finish.diffuse_back != 0.0,
        }
    })
}

/// Returns the light that a layer emits: that of `emission`, and if `has_ambient` that of `ambient`. Layers above are
/// not considered.
pub(super) fn emitted_light(shaded: &ShadedLayer, has_ambient: bool) -> Rgb {
    let finish = &shaded.layer.finish;
    shaded.color.rgb * shaded.opacity * (if has_ambient { finish.ambient + finish.emission } else { finish.emission })
}

/// Returns the share of incident light that a layer reflects diffusely: `diffuse`, `brilliance`, `crand`. `grain` is
/// subtracted; `both_sides` treats light from behind as light from the front.
#[inline]
pub(super) fn diffuse_factor(shaded: &ShadedLayer, at: &Incidence, grain: f64, both_sides: bool) -> Rgb {
    let layer = shaded.layer;
    let amount = if at.cos > 0.0 || both_sides { layer.finish.diffuse } else { layer.finish.diffuse_back };
    if amount == 0.0 || shaded.is_translucent {
        return Rgb::ZERO;
    }
    // opacity · d·|N·l|ᵇ - grain (quirk: `crand_ignores_opacity`)
    shaded.color.rgb * (shaded.opacity * amount * fp::power(at.cos.abs(), layer.finish.brilliance) - grain)
}

/// Returns the share of incident light that a layer reflects as highlights: `phong` and `specular`, tinted by
/// `metallic`.
#[inline]
pub(super) fn highlight_factor(shaded: &ShadedLayer, at: &Incidence) -> Rgb {
    let layer = shaded.layer;
    let mut amount = 0.0;
    if layer.finish.phong.strength != 0.0 {
        // (R·l)ⁿ, where R is the mirror direction of the ray
        amount +=
            lobe_strength(&layer.finish.phong, (at.dir - at.normal * (2.0 * at.dir.dot(at.normal))).dot(at.to_light));
    }
    if layer.finish.specular.strength != 0.0 {
        // (N·h)ⁿ, where h is half-way between light and ray (Blinn 1977)
        amount += lobe_strength(&layer.finish.specular, at.normal.dot((at.to_light - at.dir).normalize_or_zero()));
    }
    if amount == 0.0 {
        return Rgb::ZERO;
    }
    metal_tint(layer.finish.metallic, at.cos, shaded.color.rgb) * amount
}

/// Returns the strength of a highlight, strength · cosⁿ.
pub(super) fn lobe_strength(lobe: &Lobe, cos: f64) -> f64 {
    if cos <= 0.0 { 0.0 } else { lobe.strength * fp::power(cos, lobe.exponent) }
}

/// Returns the tint of light that a layer reflects: white without `metallic`, else the pigment's colour, but white at a
/// grazing angle, by F of Strauss, A realistic lighting model for computer animators, 1990.
pub(super) fn metal_tint(metallic: f64, cos: f64, pigment: Rgb) -> Rgb {
    if metallic == 0.0 {
        return Rgb::ONE;
    }
    const K: f64 = 1.12;
    let x = fp::acos(cos.clamp(-1.0, 1.0)) / FRAC_PI_2;
    // F(x) = (1/(x-k)² - 1/k²) / (1/(1-k)² - 1/k²)
    let rise = |x: f64| 1.0 / ((x - K) * (x - K)) - 1.0 / (K * K);
    // For bumps that are seen from behind, x is above 1, and F is 1 (quirk: `bumps_from_behind`).
    let fresnel = (rise(x) / rise(1.0)).min(1.0);
    Rgb::ONE + (pigment - Rgb::ONE) * (metallic * (1.0 - fresnel))
}
