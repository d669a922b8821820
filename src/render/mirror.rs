//! `reflection`: how much a place mirrors (manual, "Reflection"; details measured on 3.7). What lies above a layer takes
//! nothing from its mirror.

use super::refract::Border;
use super::shade::metal_tint;
use super::site::{Shown, Site};
use crate::color::Rgb;
use crate::math::{DVec3, fp};
use crate::texture::Reflection;
use smallvec::SmallVec;

/// How a ray counts, and how little is too little (`adc_bailout`).
#[derive(Clone, Copy)]
pub(super) struct Count {
    pub weight: f64,
    pub bailout: f64,
}

/// The normals of all layers that mirror, each once.
pub(super) fn normals(site: &Site) -> SmallVec<[DVec3; 2]> {
    let mut normals = SmallVec::new();
    for (_, shown) in mirrors(site) {
        if !normals.contains(&shown.normal) {
            normals.push(shown.normal);
        }
    }
    normals
}

/// How much the ray counts that layers with this normal mirror; 0 if that is too little.
pub(super) fn weight(site: &Site, normal: DVec3, border: &Border, count: Count) -> f64 {
    let here = mirrors(site).filter(|(_, shown)| shown.normal == normal);
    let weights = here.map(|(mirror, shown)| counts(mirror, shown, border, count));
    weights.fold(0.0, f64::max)
}

/// What layers with this normal mirror of the light.
pub(super) fn answer(site: &Site, normal: DVec3, border: &Border, count: Count, light: Rgb) -> Rgb {
    let mut sum = Rgb::ZERO;
    for (mirror, shown) in mirrors(site).filter(|(_, shown)| shown.normal == normal) {
        if counts(mirror, shown, border, count) == 0.0 {
            continue;
        }
        let seen = match mirror.exponent {
            1.0 => light,
            exponent => light.max(Rgb::ZERO).map(|x| fp::pow(x, 1.0 / exponent)),
        };
        sum += amount(mirror, shown, border) * seen * shown.share;
    }
    sum
}

/// How much one layer's mirrored ray counts; 0 if that is too little. Only `fresnel` asks for the angle, else it is the
/// larger of the author's numbers.
fn counts(mirror: &Reflection, shown: &Shown, border: &Border, count: Count) -> f64 {
    let part = match mirror.fresnel {
        true => amount(mirror, shown, border),
        false => mirror.min.max(mirror.max),
    };
    let weight = count.weight * part.max_element() * shown.share;
    if weight > count.bailout { weight } else { 0.0 }
}

/// What `conserve_energy` leaves for the light that passes.
pub(super) fn left_over(site: &Site, border: &Border) -> Rgb {
    let mut left = Rgb::ONE;
    for (mirror, shown) in mirrors(site) {
        if shown.layer.conserve_energy {
            left -= amount(mirror, shown, border) * shown.share;
        }
    }
    left
}

fn mirrors<'a>(site: &'a Site) -> impl Iterator<Item = (&'a Reflection, &'a Shown<'a>)> {
    site.layers.iter().filter_map(|shown| Some((shown.layer.mirror.as_deref()?, shown)))
}

/// How much one layer mirrors at this angle.
fn amount(mirror: &Reflection, shown: &Shown, border: &Border) -> Rgb {
    let cos = shown.cos;
    let part = if mirror.fresnel {
        border.fresnel(cos)
    } else if mirror.min == mirror.max {
        0.0
    } else {
        fp::pow(1.0 - cos.min(1.0), mirror.falloff)
    };
    // min + (max - min)·part
    let amount = mirror.min + (mirror.max - mirror.min) * part;
    amount * metal_tint(mirror.metallic, cos, shown.color.rgb)
}
