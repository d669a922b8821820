//! `reflection`: how much a place mirrors (manual, "Reflection"; details measured on 3.7). What lies above a layer takes
//! nothing from its mirror.

use super::refract::Border;
use super::shade::metal_tint;
use super::site::{Shown, Site};
use crate::color::{Rgb, gray};
use crate::math::{DVec3, fp};
use crate::texture::Reflection;
use crate::world::World;
use smallvec::SmallVec;

/// The ray that is mirrored.
#[derive(Clone, Copy)]
pub(super) struct Incoming<'a> {
    /// How much it counts.
    pub weight: f64,
    pub border: &'a Border,
    pub world: &'a World,
}

/// A mirrored ray: what it is mirrored by, and how much it counts.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Bounce {
    pub normal: DVec3,
    pub weight: f64,
}

/// The rays that the layers mirror, each once: how much one counts says how far it is followed (measured on 3.7).
pub(super) fn bounces(site: &Site, incoming: Incoming) -> SmallVec<[Bounce; 2]> {
    let mut bounces = SmallVec::new();
    for bounce in mirrors(site).filter_map(|(mirror, shown)| bounce(mirror, shown, incoming)) {
        if !bounces.contains(&bounce) {
            bounces.push(bounce);
        }
    }
    bounces
}

/// What the layers that mirror this ray, which goes on along `out`, show of its light.
pub(super) fn answer(site: &Site, incoming: Incoming, ray: Bounce, out: DVec3, light: Rgb) -> Rgb {
    let mut sum = Rgb::ZERO;
    for (mirror, shown) in mirrors(site).filter(|(mirror, shown)| bounce(mirror, shown, incoming) == Some(ray)) {
        let light = light * film(site, shown, out, incoming.world);
        let seen = match mirror.exponent {
            1.0 => light,
            exponent => light.max(Rgb::ZERO).map(|x| fp::pow(x, 1.0 / exponent)),
        };
        sum += amount(mirror, shown, incoming.border) * seen * shown.share;
    }
    sum
}

/// What is totally reflected along `out`: all, but for a film on top.
pub(super) fn total(site: &Site, out: DVec3, world: &World) -> Rgb {
    site.layers.first().map_or(Rgb::ONE, |top| film(site, top, out, world))
}

/// What a thin film on a layer makes of light from a direction (`irid`).
pub(super) fn film(site: &Site, shown: &Shown, from: DVec3, world: &World) -> Rgb {
    match &shown.layer.sheen.irid {
        // bumps that are seen or lit from behind count as from the front (measured on 3.7)
        Some(irid) => {
            let cosines = shown.normal.dot(from).abs() + shown.cos.abs();
            irid.tint(site.point, cosines, world.irid_wavelength, world.noise)
        }
        None => Rgb::ONE,
    }
}

/// The ray that one layer mirrors; `None` if it counts too little. What lies above takes from that, by its gray, although
/// it takes nothing from what is seen; shares of a blend do not (measured on POV-Ray 3.7). Only `fresnel` asks for the angle,
/// else it is the larger of the author's numbers.
fn bounce(mirror: &Reflection, shown: &Shown, incoming: Incoming) -> Option<Bounce> {
    let part = match mirror.fresnel {
        true => amount(mirror, shown, incoming.border),
        false => mirror.min.max(mirror.max),
    };
    let above = if shown.share == 0.0 { 0.0 } else { gray(shown.weight) / shown.share };
    let weight = incoming.weight * above * part.max_element();
    (weight > incoming.world.adc_bailout).then_some(Bounce { normal: shown.normal, weight })
}

/// What a layer leaves for the light that passes it: with `conserve_energy`, what it does not mirror.
pub(super) fn left_over(shown: &Shown, border: &Border) -> Rgb {
    match shown.layer.sheen.mirror.as_deref().filter(|_| shown.layer.sheen.conserve_energy) {
        Some(mirror) => Rgb::ONE - amount(mirror, shown, border),
        None => Rgb::ONE,
    }
}

fn mirrors<'a>(site: &'a Site) -> impl Iterator<Item = (&'a Reflection, &'a Shown<'a>)> {
    site.layers.iter().filter_map(|shown| Some((shown.layer.sheen.mirror.as_deref()?, shown)))
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
