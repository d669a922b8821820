//! How surfaces answer to light: one function for each term of `finish` (manual, "Finish"; details measured on 3.7).

use super::area::offset;
use super::mirror::film;
use super::random::Purpose;
use super::shading_point::{ShadedLayer, ShadingPoint};
use super::trace::{Path, Tracer};
use crate::color::Rgb;
use crate::light::LightSample;
use crate::math::{DVec3, fp};
use crate::world::{LightSource, Lobe};
use std::f64::consts::FRAC_PI_2;

/// Where the light comes from and where it is looked at from.
struct Incidence {
    /// The ray that looks.
    dir: DVec3,
    /// N, length 1.
    normal: DVec3,
    /// l, length 1, towards the light.
    to_light: DVec3,
    /// N·l; negative from behind.
    cos: f64,
}

/// What shines on a place.
#[derive(Clone, Copy)]
struct Source<'a> {
    light: &'a LightSource,
    /// Towards its location, which is the middle of a grid; films shine as in light from there (measured on POV-Ray 3.7).
    middle: DVec3,
}

impl Tracer<'_> {
    /// The light that a place sends back along the ray, without what it mirrors and lets pass.
    pub(super) fn shade(&mut self, path: &Path, shading: &ShadingPoint) -> Rgb {
        if !self.setup.quality.lit {
            return shading.sum(|shaded| shaded.weight * shaded.color.rgb);
        }
        let mut sum = shading.sum(|shaded| shaded.weight * glow(shaded));
        let world = self.setup.world;
        for &number in &world.lit_by[shading.part.lights() as usize] {
            sum += self.answer(&world.lights[number as usize], path, shading);
        }
        sum
    }

    /// What it answers to one light.
    fn answer(&mut self, light: &LightSource, path: &Path, shading: &ShadingPoint) -> Rgb {
        let dir = path.ray.dir;
        let arriving = light.emitter.sample(shading.point, DVec3::ZERO);
        let extended = self.setup.quality.extended;
        let Some(area) = light.emitter.area.as_ref().filter(|area| area.illumination && extended) else {
            let from_light = |tracer: &mut Self| tracer.reaching(light, shading.point, &arriving, path);
            return self.answer_to(&arriving, Source { light, middle: arriving.from }, dir, shading, from_light);
        };
        // Each light of the grid by itself, all the same; but the shadow is that of the whole grid (measured on 3.7).
        let passed = self.reaching(light, shading.point, &arriving, path);
        if passed == Rgb::ZERO {
            return Rgb::ZERO;
        }
        let [n, m] = area.size;
        let mut sum = Rgb::ZERO;
        let random = self.random.row(Purpose::AreaLight);
        for cell in (0..m).flat_map(|j| (0..n).map(move |i| [i, j])) {
            let toward = -arriving.from;
            let offset = offset(area, cell, toward, random);
            let one = light.emitter.sample(shading.point, offset);
            sum += self.answer_to(&one, Source { light, middle: arriving.from }, dir, shading, |_| passed);
        }
        sum / (f64::from(n) * f64::from(m))
    }

    /// What it answers to light that arrives in one way, of which `passed` says how much comes through.
    fn answer_to(
        &mut self,
        arriving: &LightSample,
        Source { light, middle }: Source,
        dir: DVec3,
        shading: &ShadingPoint,
        passed: impl FnOnce(&mut Self) -> Rgb,
    ) -> Rgb {
        let l = arriving.from;
        // (Where grids are drawn as one light, what a whole grid shines on answers on both sides: measured on POV-Ray 3.7 at quality
        // 2, 3 and 4.)
        let shines_through =
            light.emitter.area.as_ref().is_some_and(|area| area.illumination) && !self.setup.quality.extended;
        let both_sides = shading.part.double_illuminate || shines_through;
        if arriving.light == Rgb::ZERO || !l.is_finite() || !answers(shading, l, both_sides) {
            return Rgb::ZERO;
        }
        let arriving = arriving.light * passed(self);
        if arriving == Rgb::ZERO {
            return Rgb::ZERO;
        }
        let sum = shading.sum(|shaded| {
            let at = Incidence { dir, normal: shaded.normal, to_light: l, cos: shaded.normal.dot(l) };
            let crand = shaded.layer.finish.crand;
            let grain = if crand == 0.0 { 0.0 } else { crand * self.random.next(Purpose::Grain) };
            let mut answer = scattered(shaded, &at, grain, both_sides);
            // (What light reaches from behind is bright there, too: measured on POV-Ray 3.7.)
            if (at.cos > 0.0 || both_sides) && !light.emitter.shadowless {
                answer += highlight(shaded, &at);
            }
            answer *= film(shading.point, shaded, middle, self.setup.world);
            shaded.weight * answer
        });
        sum * arriving
    }
}

/// Does any layer answer to light from a direction?
fn answers(shading: &ShadingPoint, from: DVec3, both_sides: bool) -> bool {
    shading.layers().any(|shaded| {
        let finish = &shaded.layer.finish;
        match both_sides || shaded.normal.dot(from) > 0.0 {
            true => finish.diffuse != 0.0 || finish.phong.strength != 0.0 || finish.specular.strength != 0.0,
            false => finish.diffuse_back != 0.0,
        }
    })
}

/// `ambient` and `emission`.
fn glow(shaded: &ShadedLayer) -> Rgb {
    shaded.color.rgb * shaded.opacity * shaded.layer.finish.glow
}

/// `diffuse`, `brilliance`, `crand`.
fn scattered(shaded: &ShadedLayer, at: &Incidence, grain: f64, both_sides: bool) -> Rgb {
    let layer = shaded.layer;
    let amount = if at.cos > 0.0 || both_sides { layer.finish.diffuse } else { layer.finish.diffuse_back };
    if amount == 0.0 {
        return Rgb::ZERO;
    }
    // opacity · d·|N·l|ᵇ, less some grain, of which all is seen however thin the layer is; what falls below zero darkens the other
    // terms (measured on 3.7)
    shaded.color.rgb * (shaded.opacity * amount * power(at.cos.abs(), layer.finish.brilliance) - grain)
}

/// `phong` and `specular`, coloured by `metallic`.
fn highlight(shaded: &ShadedLayer, at: &Incidence) -> Rgb {
    let layer = shaded.layer;
    let mut amount = 0.0;
    if layer.finish.phong.strength != 0.0 {
        // (R·l)ⁿ, where R is the mirrored ray
        amount += lobe(&layer.finish.phong, (at.dir - at.normal * (2.0 * at.dir.dot(at.normal))).dot(at.to_light));
    }
    if layer.finish.specular.strength != 0.0 {
        // (N·h)ⁿ, where h is half-way between light and eye
        amount += lobe(&layer.finish.specular, at.normal.dot((at.to_light - at.dir).normalize_or_zero()));
    }
    if amount == 0.0 {
        return Rgb::ZERO;
    }
    metal_tint(layer.finish.metallic, at.cos, shaded.color.rgb) * amount
}

/// strength · cosⁿ
fn lobe(lobe: &Lobe, cos: f64) -> f64 {
    if cos <= 0.0 { 0.0 } else { lobe.strength * power(cos, lobe.exponent) }
}

/// The colour of what metal mirrors: the pigment's, but white at a grazing angle, by F of Strauss, A realistic lighting
/// model for computer animators, 1990.
pub(super) fn metal_tint(metallic: f64, cos: f64, pigment: Rgb) -> Rgb {
    if metallic == 0.0 {
        return Rgb::ONE;
    }
    const K: f64 = 1.12;
    let x = fp::acos(cos.clamp(-1.0, 1.0)) / FRAC_PI_2;
    // F(x) = (1/(x-k)² - 1/k²) / (1/(1-k)² - 1/k²)
    let rise = |x: f64| 1.0 / ((x - K) * (x - K)) - 1.0 / (K * K);
    // Bumps that are seen from behind lie past x = 1, where F first stays (measured on POV-Ray 3.7).
    let fresnel = (rise(x) / rise(1.0)).min(1.0);
    Rgb::ONE + (pigment - Rgb::ONE) * (metallic * (1.0 - fresnel))
}

/// x to a power; most are whole numbers, which takes a few products.
fn power(x: f64, exponent: f64) -> f64 {
    let whole = exponent as u32;
    if f64::from(whole) == exponent && whole < 4096 { fp::power_of(x, whole) } else { fp::pow(x, exponent) }
}
