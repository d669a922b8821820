//! A place on a surface: what is painted there.

use crate::color::{Color, Rgb};
use crate::math::{DVec2, DVec3, Ray};
use crate::pattern::Spot;
use crate::texture::Normal;
use crate::world::{Coat, Found, Layer, Material, Part, World};
use smallvec::SmallVec;

/// A layer of the texture at a place.
pub(super) struct Shown<'w> {
    pub layer: &'w Layer,
    /// Its pigment there.
    pub color: Color,
    /// What the layers above let pass of it.
    pub weight: Rgb,
    /// With its bumps; length 1, in world space.
    pub normal: DVec3,
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
        let spot = Spot {
            p: coat.local(surface.point),
            world: surface.point,
            uv: if material.uv { found.mapped_uv(&surface) } else { DVec2::ZERO },
            normal,
            ray: ray.dir,
            noise: world.noise,
            waves: world.waves,
        };
        let mut painter = Painter { coat, quick, layers: SmallVec::new() };
        let pass = painter.paint(material, &spot, Rgb::ONE);
        Self { part, point: surface.point, normal, cos, layers: painter.layers, pass }
    }
}

/// Collects what is painted at a place.
struct Painter<'w> {
    coat: &'w Coat,
    quick: bool,
    layers: SmallVec<[Shown<'w>; 2]>,
}

impl<'w> Painter<'w> {
    /// Adds the layers of a material that counts for `weight`; gives what passes them.
    fn paint(&mut self, material: &'w Material, spot: &Spot, weight: Rgb) -> Rgb {
        let mut pass = Rgb::ONE;
        for layer in &material.layers {
            match &layer.choice {
                Some(choice) => {
                    let (number, inner) = choice.pattern.see(spot);
                    let mut passed = Rgb::ZERO;
                    for (part, share) in choice.parts.shares(number, choice.averages()) {
                        passed += share * self.paint(part, &inner, weight * pass * share);
                    }
                    pass *= passed;
                }
                None => {
                    let normal = layer.normal.as_ref().map_or(spot.normal, |bumps| self.bumped(bumps, spot));
                    // as was measured: `slope` and `aoi` of a pigment see the bumps
                    let color = layer.color(&Spot { normal, ..*spot }, self.quick);
                    self.layers.push(Shown { layer, color, weight: weight * pass, normal });
                    pass *= color.passing();
                }
            }
            if pass == Rgb::ZERO {
                break;
            }
        }
        pass
    }

    /// The normal that light sees.
    fn bumped(&self, bumps: &Normal, spot: &Spot) -> DVec3 {
        let Some(place) = &self.coat.place else { return bumps.perturb(spot, spot.normal) };
        // Into the texture's space by Mᵀ, back by M⁻ᵀ.
        let local = place.inverse().normal(spot.normal).normalize_or(spot.normal);
        place.normal(bumps.perturb(spot, local)).normalize_or(spot.normal)
    }
}

/// What is painted on the side that a ray sees.
fn coat(part: &Part, from_inside: bool) -> &Coat {
    part.inside.as_ref().filter(|_| from_inside).unwrap_or(&part.outside)
}

/// What all layers at the place where `ray` meets `found` let pass.
pub(super) fn pass(world: &World, ray: &Ray, found: &Found) -> Rgb {
    let part = &world.parts[found.leaf.id as usize];
    let from_inside = part.inside.is_some() && ray.dir.dot(found.surface(ray).normal) > 0.0;
    let coat = coat(part, from_inside);
    let material = &world.materials[coat.material as usize];
    if material.solid {
        return material.pass;
    }
    let surface = found.surface(ray);
    let spot = Spot {
        p: coat.local(surface.point),
        world: surface.point,
        uv: if material.uv { found.mapped_uv(&surface) } else { DVec2::ZERO },
        normal: surface.normal,
        ray: ray.dir,
        noise: world.noise,
        waves: world.waves,
    };
    pass_of(material, &spot)
}

/// What passes the layers of a material.
fn pass_of(material: &Material, spot: &Spot) -> Rgb {
    material.layers.iter().fold(Rgb::ONE, |pass, layer| match &layer.choice {
        Some(choice) => {
            let (number, inner) = choice.pattern.see(spot);
            let shares = choice.parts.shares(number, choice.averages());
            pass * shares.iter().fold(Rgb::ZERO, |sum, (part, share)| sum + *share * pass_of(part, &inner))
        }
        None => pass * layer.color(spot, false).passing(),
    })
}
