//! `reflection`: how much a place mirrors (manual, "Reflection"; details measured on 3.7). What lies above a layer takes
//! nothing from its mirror.

use super::refract::Border;
use super::shade::metal_tint;
use super::site::{Shown, Site};
use crate::color::Rgb;
use crate::math::fp;
use crate::texture::Reflection;

/// How a ray counts, and how little is too little (`adc_bailout`).
#[derive(Clone, Copy)]
pub(super) struct Count {
    pub weight: f64,
    pub bailout: f64,
}

/// How much the mirrored ray counts; 0 if that is too little.
pub(super) fn weight(site: &Site, border: &Border, count: Count) -> f64 {
    let weights = mirrors(site).map(|(mirror, shown)| counts(mirror, shown, site, border, count));
    weights.fold(0.0, f64::max)
}

/// What the place mirrors of the light.
pub(super) fn answer(site: &Site, border: &Border, count: Count, light: Rgb) -> Rgb {
    let mut sum = Rgb::ZERO;
    for (mirror, shown) in mirrors(site) {
        if counts(mirror, shown, site, border, count) == 0.0 {
            continue;
        }
        let seen = match mirror.exponent {
            1.0 => light,
            exponent => light.max(Rgb::ZERO).map(|x| fp::pow(x, 1.0 / exponent)),
        };
        sum += amount(mirror, shown, site.cos, border) * seen;
    }
    sum
}

/// How much one layer's mirrored ray counts; 0 if that is too little. Only `fresnel` asks for the angle, else it is the
/// larger of the author's numbers.
fn counts(mirror: &Reflection, shown: &Shown, site: &Site, border: &Border, count: Count) -> f64 {
    let part = match mirror.fresnel {
        true => amount(mirror, shown, site.cos, border),
        false => mirror.min.max(mirror.max),
    };
    let weight = count.weight * part.max_element();
    if weight > count.bailout { weight } else { 0.0 }
}

/// What `conserve_energy` leaves for the light that passes.
pub(super) fn left_over(site: &Site, border: &Border) -> Rgb {
    let mut left = Rgb::ONE;
    for (mirror, shown) in mirrors(site) {
        if shown.layer.conserve_energy {
            left -= amount(mirror, shown, site.cos, border);
        }
    }
    left
}

fn mirrors<'a>(site: &'a Site) -> impl Iterator<Item = (&'a Reflection, &'a Shown<'a>)> {
    site.layers.iter().filter_map(|shown| Some((shown.layer.mirror.as_deref()?, shown)))
}

/// How much one layer mirrors at this angle.
fn amount(mirror: &Reflection, shown: &Shown, cos: f64, border: &Border) -> Rgb {
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
