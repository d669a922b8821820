//! `reflection`: how much a place mirrors (manual, "Reflection"; details measured on 3.7). What lies above a layer takes
//! nothing from its mirror.

use super::refract::Interface;
use super::shade::metal_tint;
use super::shading_point::{Coat, ShadedLayer};
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
    pub interface: &'a Interface,
    pub world: &'a World,
}

/// A layer that mirrors.
pub(super) struct Mirror<'a> {
    pub reflection: &'a Reflection,
    pub shaded: &'a ShadedLayer<'a>,
    /// That of its coat.
    pub share: f64,
}

/// A mirrored ray: what it is mirrored by, and how much it counts.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Bounce {
    pub normal: DVec3,
    pub weight: f64,
}

/// The rays that the layers mirror, each once: how much one counts says how far it is followed (measured on 3.7).
pub(super) fn bounces(mirrors: &[Mirror], incoming: Incoming) -> SmallVec<[Bounce; 2]> {
    let mut bounces = SmallVec::new();
    for bounce in mirrors.iter().filter_map(|mirror| bounce(mirror, incoming)) {
        if !bounces.contains(&bounce) {
            bounces.push(bounce);
        }
    }
    bounces
}

/// What the layers that mirror this ray, which goes on along `out` from `point`, show of its light.
pub(super) fn answer(mirrors: &[Mirror], point: DVec3, incoming: Incoming, ray: Bounce, out: DVec3, light: Rgb) -> Rgb {
    let mut sum = Rgb::ZERO;
    for mirror in mirrors.iter().filter(|mirror| bounce(mirror, incoming) == Some(ray)) {
        let light = light * film(point, mirror.shaded, out, incoming.world);
        let seen = match mirror.reflection.exponent {
            1.0 => light,
            // (What counts for less than nothing has no power, and the pixel is black, as in POV-Ray 3.7.)
            exponent => light.map(|x| fp::pow(x, 1.0 / exponent)),
        };
        sum += amount(mirror.reflection, mirror.shaded, incoming.interface) * seen * mirror.share;
    }
    sum
}

/// What is totally reflected along `out` from `point` of a coat: all, but for a film on top.
pub(super) fn total(coat: &Coat, point: DVec3, out: DVec3, world: &World) -> Rgb {
    coat.layers.first().map_or(Rgb::ONE, |top| film(point, top, out, world))
}

/// What a thin film on a layer makes of light from a direction (`irid`).
pub(super) fn film(point: DVec3, shaded: &ShadedLayer, from: DVec3, world: &World) -> Rgb {
    match &shaded.layer.finish.irid {
        // bumps that are seen or lit from behind count as from the front (measured on 3.7)
        Some(irid) => {
            let cosines = shaded.normal.dot(from).abs() + shaded.cos.abs();
            irid.tint(point, cosines, world.irid_wavelength, world.noise)
        }
        None => Rgb::ONE,
    }
}

/// The ray that one layer mirrors; `None` if it counts too little. What lies above takes from that, by its gray, although
/// it takes nothing from what is seen; shares of a blend and the tint of a metal do not (measured on POV-Ray 3.7). Only `fresnel`
/// asks for the angle, else it is the larger of the author's numbers.
fn bounce(mirror: &Mirror, incoming: Incoming) -> Option<Bounce> {
    let Mirror { reflection, shaded, .. } = mirror;
    let part = match reflection.fresnel {
        true => untinted(reflection, shaded.cos, incoming.interface),
        false => reflection.min.max(reflection.max),
    };
    let weight = incoming.weight * gray(shaded.weight) * part.max_element();
    (weight > incoming.world.adc_bailout).then_some(Bounce { normal: shaded.normal, weight })
}

/// What a layer leaves for the light that passes it: with `conserve_energy`, what it does not mirror.
pub(super) fn left_over(shaded: &ShadedLayer, interface: &Interface) -> Rgb {
    match shaded.layer.finish.mirror.as_deref().filter(|_| shaded.layer.finish.conserve_energy) {
        Some(mirror) => Rgb::ONE - amount(mirror, shaded, interface),
        None => Rgb::ONE,
    }
}

/// How much one layer mirrors at this angle.
fn amount(mirror: &Reflection, shaded: &ShadedLayer, interface: &Interface) -> Rgb {
    let cos = shaded.cos;
    untinted(mirror, cos, interface) * metal_tint(mirror.metallic, cos, shaded.color.rgb)
}

/// The same before `metallic` tints it.
fn untinted(mirror: &Reflection, cos: f64, interface: &Interface) -> Rgb {
    let part = if mirror.fresnel {
        interface.fresnel(cos)
    } else if mirror.min == mirror.max {
        0.0
    } else {
        fp::pow(1.0 - cos.min(1.0), mirror.falloff)
    };
    // min + (max - min)·part
    mirror.min + (mirror.max - mirror.min) * part
}
