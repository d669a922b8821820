//! How surfaces answer to light: one function for each term of `finish` (manual, "Finish"; details measured on 3.7).

use super::mirror::film;
use super::refract::Interiors;
use super::site::{Shown, Site};
use super::trace::Tracer;
use crate::color::Rgb;
use crate::math::{DVec3, fp};
use crate::world::{Lamp, Layer, Lobe};
use std::f64::consts::FRAC_PI_2;

/// Where the light comes from and where it is looked at from.
struct Incidence {
    /// The ray that looks.
    dir: DVec3,
    /// N, length 1.
    normal: DVec3,
    /// l, length 1, towards the lamp.
    to_lamp: DVec3,
    /// N·l; negative from behind.
    cos: f64,
}

impl Tracer<'_> {
    /// The light that a place sends back along the ray, without what it mirrors and lets pass.
    pub(super) fn shade(&mut self, dir: DVec3, site: &Site, inside: &Interiors) -> Rgb {
        if !self.setup.quality.lit {
            return site.layers.iter().map(|shown| shown.weight * shown.color.rgb).sum();
        }
        let mut sum = Rgb::ZERO;
        for shown in &site.layers {
            sum += shown.weight * glow(shown);
        }
        for lamp in &self.setup.world.lights {
            sum += self.answer(lamp, dir, site, inside);
        }
        sum
    }

    /// What it answers to one lamp.
    fn answer(&mut self, lamp: &Lamp, dir: DVec3, site: &Site, inside: &Interiors) -> Rgb {
        let to_lamp = lamp.location - site.point;
        let distance = to_lamp.length();
        let l = to_lamp / distance;
        let answers = |shown: &Shown| {
            let side = if shown.normal.dot(l) > 0.0 { answers_front } else { answers_back };
            side(shown.layer, site.part.double_illuminate)
        };
        if !site.layers.iter().any(answers) || distance == 0.0 {
            return Rgb::ZERO;
        }
        let mut light = lamp.strength(distance);
        if !lamp.shadowless && self.setup.quality.shadows && light != Rgb::ZERO {
            light *= self.unshadowed(site.point, l, distance, inside);
        }
        if light == Rgb::ZERO {
            return Rgb::ZERO;
        }
        let mut sum = Rgb::ZERO;
        for shown in &site.layers {
            let at = Incidence { dir, normal: shown.normal, to_lamp: l, cos: shown.normal.dot(l) };
            let grain = if shown.layer.sheen.crand == 0.0 { 0.0 } else { shown.layer.sheen.crand * self.random() };
            let mut answer = scattered(shown, &at, grain, site.part.double_illuminate);
            if at.cos > 0.0 && !lamp.shadowless {
                answer += highlight(shown, &at);
            }
            answer *= film(site, shown, l, self.setup.world);
            sum += shown.weight * answer;
        }
        sum * light
    }
}

fn answers_front(layer: &Layer, _: bool) -> bool {
    layer.sheen.diffuse != 0.0 || layer.sheen.phong.strength != 0.0 || layer.sheen.specular.strength != 0.0
}

fn answers_back(layer: &Layer, double_illuminate: bool) -> bool {
    layer.sheen.diffuse_back != 0.0 || (double_illuminate && layer.sheen.diffuse != 0.0)
}

/// `ambient` and `emission`.
fn glow(shown: &Shown) -> Rgb {
    shown.color.rgb * shown.opacity * shown.layer.sheen.glow
}

/// `diffuse`, `brilliance`, `crand`.
fn scattered(shown: &Shown, at: &Incidence, grain: f64, double_illuminate: bool) -> Rgb {
    let layer = shown.layer;
    let amount = if at.cos > 0.0 || double_illuminate { layer.sheen.diffuse } else { layer.sheen.diffuse_back };
    if amount == 0.0 {
        return Rgb::ZERO;
    }
    // opacity · d·|N·l|ᵇ, less some grain, of which all is seen however thin the layer is; what falls below zero darkens the other
    // terms (measured on 3.7)
    shown.color.rgb * (shown.opacity * amount * power(at.cos.abs(), layer.sheen.brilliance) - grain)
}

/// `phong` and `specular`, coloured by `metallic`.
fn highlight(shown: &Shown, at: &Incidence) -> Rgb {
    let layer = shown.layer;
    let mut amount = 0.0;
    if layer.sheen.phong.strength != 0.0 {
        // (R·l)ⁿ, where R is the mirrored ray
        amount += lobe(&layer.sheen.phong, (at.dir - at.normal * (2.0 * at.dir.dot(at.normal))).dot(at.to_lamp));
    }
    if layer.sheen.specular.strength != 0.0 {
        // (N·h)ⁿ, where h is half-way between lamp and eye
        amount += lobe(&layer.sheen.specular, at.normal.dot((at.to_lamp - at.dir).normalize_or_zero()));
    }
    if amount == 0.0 {
        return Rgb::ZERO;
    }
    metal_tint(layer.sheen.metallic, at.cos, shown.color.rgb) * amount
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
