//! `reflection`: the share of light in mirror direction that a surface reflects (manual, "Reflection"). Upper layers do
//! not attenuate the reflection of lower layers (quirk: `layers_keep_reflection`).

use super::direct_light::metal_tint;
use super::interface::Interface;
use super::shading_point::{MaterialSample, ShadedLayer, ShadingPoint};
use crate::color::{Rgb, gray};
use crate::math::{DVec3, fp};
use crate::texture::Reflection;
use crate::world::World;

/// Data that the mirror reflections of all layers at a hit share: importance of the incoming ray, optical boundary and
/// World.
#[derive(Clone, Copy)]
pub(super) struct MirrorContext<'a> {
    /// Importance of the ray that hits the surface, from which the importance of the reflected rays follows.
    pub weight: f64,
    /// Importance below which rays are not traced.
    pub bailout: f64,
    pub interface: &'a Interface,
    pub world: &'a World,
}

/// A layer with `reflection`, and the ray that it reflects.
pub(super) struct Mirror<'a> {
    reflection: &'a Reflection,
    shaded: &'a ShadedLayer<'a>,
    /// Share of the layer's material in a blend of materials.
    share: f64,
    /// The reflected ray.
    bounce: Bounce,
}

impl<'a> Mirror<'a> {
    /// Creates the mirror of a layer that has the share `share` in a blend of materials; `None` if the layer has no
    /// `reflection`, or reflects a ray whose weight is below `adc_bailout`.
    #[inline]
    pub fn new(shaded: &'a ShadedLayer<'a>, share: f64, context: MirrorContext) -> Option<Self> {
        let reflection = shaded.layer.finish.mirror.as_deref()?;
        Some(Self { reflection, shaded, share, bounce: bounce(reflection, shaded, context)? })
    }

    /// Returns the ray that the layer reflects.
    pub fn bounce(&self) -> Bounce {
        self.bounce
    }
}

/// A reflected ray: the normal that reflects it, and its weight. Layers with an equal normal and weight share one ray.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Bounce {
    pub normal: DVec3,
    pub weight: f64,
}

/// Returns the rays that the layers reflect, equal ones only once.
#[inline]
pub(super) fn bounces<'a>(mirrors: &'a [Mirror]) -> impl Iterator<Item = Bounce> + use<'a> {
    let is_new = |i: usize| mirrors[..i].iter().all(|before| before.bounce != mirrors[i].bounce);
    (0..mirrors.len()).filter(move |&i| is_new(i)).map(|i| mirrors[i].bounce)
}

/// True if a bounce's reflected light is proportional to the incoming light: no layer has an `exponent` except 1.
pub(super) fn is_linear(mirrors: &[Mirror], bounce: Bounce) -> bool {
    mirrors.iter().all(|mirror| mirror.reflection.exponent == 1.0 || mirror.bounce != bounce)
}

/// Returns the radiance that a bounce's layers reflect at `point` from `light`, which arrives from the direction `out`
/// of the reflected ray.
pub(super) fn reflected_radiance(
    mirrors: &[Mirror],
    point: DVec3,
    context: MirrorContext,
    bounce: Bounce,
    out: DVec3,
    light: Rgb,
) -> Rgb {
    let mut sum = Rgb::ZERO;
    for mirror in mirrors.iter().filter(|mirror| mirror.bounce == bounce) {
        let light = light * film_factor(point, mirror.shaded, out, context.world);
        let seen = match mirror.reflection.exponent {
            1.0 => light,
            // The power of a negative number is not a number, and the pixel is black, as in POV-Ray.
            exponent => light.map(|x| fp::pow(x, 1.0 / exponent)),
        };
        sum += reflectance(mirror.reflection, mirror.shaded, context.interface) * seen * mirror.share;
    }
    sum
}

/// Returns the factor of totally reflected light that arrives from the direction `out`: 1, unless the top layer has a
/// thin film.
pub(super) fn total_reflection_film_factor(
    shading: &ShadingPoint,
    material: &MaterialSample,
    out: DVec3,
    world: &World,
) -> Rgb {
    shading.layers_of(material).first().map_or(Rgb::ONE, |top| film_factor(shading.point, top, out, world))
}

/// Returns the factor that a layer's thin film (`irid`) applies to light from the direction `to_light`. Bumps that are
/// seen or lit from behind count as from the front (quirk: `bumps_from_behind`).
pub(super) fn film_factor(point: DVec3, shaded: &ShadedLayer, to_light: DVec3, world: &World) -> Rgb {
    match &shaded.layer.finish.irid {
        Some(irid) => {
            let cosine_sum = shaded.normal.dot(to_light).abs() + shaded.cos.abs();
            irid.interference_factor(point, cosine_sum, world.irid_wavelength, world.noise)
        }
        None => Rgb::ONE,
    }
}

/// Returns the ray that one layer reflects; `None` if its weight is below `adc_bailout`. The gray of the layers above
/// lowers the weight, but shares of a blend, the tint of a metal and, without `fresnel`, the angle do not (quirk:
/// `reflection_weight`).
#[inline]
fn bounce(reflection: &Reflection, shaded: &ShadedLayer, context: MirrorContext) -> Option<Bounce> {
    let part = match reflection.fresnel {
        true => untinted_reflectance(reflection, shaded.cos, context.interface),
        false => reflection.min.max(reflection.max),
    };
    let weight = context.weight * gray(shaded.weight) * part.max_element();
    (weight > context.bailout).then_some(Bounce { normal: shaded.normal, weight })
}

/// Returns the share of light that a layer with `conserve_energy` does not reflect; 1 for other layers.
pub(super) fn unreflected_share_if_conserving(shaded: &ShadedLayer, interface: &Interface) -> Rgb {
    match shaded.layer.finish.mirror.as_deref().filter(|_| shaded.layer.finish.conserve_energy) {
        Some(mirror) => Rgb::ONE - reflectance(mirror, shaded, interface),
        None => Rgb::ONE,
    }
}

/// Returns the mirror reflectance of one layer at the ray's angle, with the tint of `metallic`.
fn reflectance(mirror: &Reflection, shaded: &ShadedLayer, interface: &Interface) -> Rgb {
    let cos = shaded.cos;
    untinted_reflectance(mirror, cos, interface) * metal_tint(mirror.metallic, cos, shaded.color.rgb)
}

/// Returns the mirror reflectance of a layer at this cosine of the angle to the normal, without the tint of `metallic`.
fn untinted_reflectance(mirror: &Reflection, cos: f64, interface: &Interface) -> Rgb {
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
