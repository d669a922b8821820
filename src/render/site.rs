//! A place on a surface: what is painted there.

use crate::color::{Color, Rgb};
use crate::math::{DVec3, Ray};
use crate::world::{Coat, Found, Layer, Part, World};
use smallvec::SmallVec;

/// A layer of the texture at a place.
pub(super) struct Shown<'w> {
    pub layer: &'w Layer,
    /// Its pigment there.
    pub color: Color,
    /// What the layers above let pass of it.
    pub weight: Rgb,
}

/// The place where a ray meets a surface.
pub(super) struct Site<'w> {
    pub part: &'w Part,
    pub point: DVec3,
    /// Length 1, towards the ray's origin.
    pub normal: DVec3,
    /// Between the ray, turned round, and the normal.
    pub cos: f64,
    /// From the topmost to the lowest that can be seen.
    pub layers: SmallVec<[Shown<'w>; 2]>,
    /// What passes all layers of the light from behind.
    pub pass: Rgb,
}

impl<'w> Site<'w> {
    /// Where `ray` meets `found`; `quick` as the lower qualities show it: nothing is see-through.
    pub fn new(world: &'w World, ray: &Ray, found: &Found, quick: bool) -> Self {
        let part = &world.parts[found.leaf.id as usize];
        let surface = found.surface(ray);
        let against = ray.dir.dot(surface.normal);
        let (normal, cos) = if against > 0.0 { (-surface.normal, against) } else { (surface.normal, -against) };
        let coat = coat(part, against > 0.0);
        let material = &world.materials[coat.material as usize];
        let local = coat.local(surface.point);
        let (mut layers, mut pass) = (SmallVec::new(), Rgb::ONE);
        for layer in &material.layers {
            let color = layer.color(local, quick);
            layers.push(Shown { layer, color, weight: pass });
            pass *= passing(&color);
            if pass == Rgb::ZERO {
                break;
            }
        }
        Self { part, point: surface.point, normal, cos, layers, pass }
    }
}

/// What is painted on the side that a ray sees.
fn coat(part: &Part, from_inside: bool) -> &Coat {
    part.inside.as_ref().filter(|_| from_inside).unwrap_or(&part.outside)
}

/// What a colour lets pass of the light from behind: filter · rgb + transmit.
pub(super) fn passing(color: &Color) -> Rgb {
    color.rgb * color.filter + color.transmit
}

/// What all layers at the place where `ray` meets `found` let pass.
pub(super) fn pass(world: &World, ray: &Ray, found: &Found) -> Rgb {
    let part = &world.parts[found.leaf.id as usize];
    let from_inside = part.inside.is_some() && ray.dir.dot(found.surface(ray).normal) > 0.0;
    let coat = coat(part, from_inside);
    let material = &world.materials[coat.material as usize];
    let local = if material.solid { DVec3::ZERO } else { coat.local(ray.at(found.t())) };
    material.layers.iter().fold(Rgb::ONE, |pass, layer| pass * passing(&layer.color(local, false)))
}
