//! A place on a surface: what is painted there.

use super::mirror::left_over;
use super::refract::Border;
use super::trace::Quality;
use crate::color::{Color, Rgb, gray};
use crate::math::{DVec2, DVec3, Ray};
use crate::pattern::{Space, Spot};
use crate::texture::Normal;
use crate::world::{Coat, Found, Layer, Material, Node, Part, Surface, World};
use smallvec::SmallVec;

/// A layer of the texture at a place.
pub(super) struct Shown<'w> {
    pub layer: &'w Layer,
    /// Its pigment there.
    pub color: Color,
    /// The part of the pigment that is not see-through.
    pub opacity: f64,
    /// What the layers above let pass of it.
    pub weight: Rgb,
    /// How much of the place shows this texture, where a pattern chooses among several.
    pub share: f64,
    /// With its bumps; length 1, in world space.
    pub normal: DVec3,
    /// Between the ray, turned round, and this normal; negative where bumps are seen from behind.
    pub cos: f64,
}

/// The place where a ray meets a surface.
pub(super) struct Site<'w> {
    pub part: &'w Part,
    pub point: DVec3,
    /// Length 1, towards the ray's origin, with the bumps of the topmost layer.
    pub normal: DVec3,
    /// From the topmost to the lowest that can be seen.
    pub layers: SmallVec<[Shown<'w>; 2]>,
    /// Without bumps.
    pub smooth: DVec3,
    /// What passes all layers of the light from behind.
    pub pass: Rgb,
}

impl<'w> Site<'w> {
    /// Where `ray` meets `found` at a border.
    pub fn new(world: &'w World, ray: &Ray, found: &Found, quality: &Quality, border: &Border) -> Self {
        let part = &world.parts[found.leaf.id as usize];
        let surface = found.surface(ray);
        let against = ray.dir.dot(surface.normal);
        let normal = if against > 0.0 { -surface.normal } else { surface.normal };
        let mut painter = Painter {
            coat: &part.outside,
            quality,
            border,
            opacity_by_color: world.opacity_by_color,
            bailout: world.adc_bailout,
            layers: SmallVec::new(),
        };
        let pass = of_coats(world, part, against > 0.0, surface.point, |coat, share| {
            let (material, spot) = spot(world, coat, found, &surface, normal, ray);
            painter.coat = coat;
            share * painter.paint(material, &spot, Rgb::splat(share), share, None)
        });
        let (bumped, refraction) =
            painter.layers.first().map_or((normal, 1.0), |top| (top.normal, top.layer.sheen.refraction));
        Self {
            part,
            point: surface.point,
            normal: bumped,
            smooth: normal,
            layers: painter.layers,
            pass: refraction * pass,
        }
    }
}

/// Collects what is painted at a place.
struct Painter<'w, 'a> {
    coat: &'w Coat,
    quality: &'a Quality,
    border: &'a Border,
    opacity_by_color: bool,
    bailout: f64,
    layers: SmallVec<[Shown<'w>; 2]>,
}

impl<'w> Painter<'w, '_> {
    /// Adds the layers of a material that counts for `weight`; gives what passes them. Without light, the lowest layer alone
    /// is seen (measured on POV-Ray 3.7).
    fn paint(&mut self, material: &'w Material, spot: &Spot, weight: Rgb, share: f64, frame: Option<&Frame>) -> Rgb {
        let mut pass = Rgb::ONE;
        let hidden = if self.quality.lit { 0 } else { material.layers.len() - 1 };
        for layer in &material.layers[hidden..] {
            match &layer.choice {
                Some(choice) => {
                    let (number, inner) = choice.pattern.see(spot);
                    let mut passed = Rgb::ZERO;
                    let within = Frame { space: &choice.pattern.space, outer: frame };
                    for (part, s) in choice.parts.shares(number, choice.averages()) {
                        passed += s * self.paint(part, &inner, weight * pass * s, share * s, Some(&within));
                    }
                    pass *= passed;
                }
                None => {
                    let bumps = layer.normal.as_ref().filter(|_| self.quality.mirrors);
                    let normal = bumps.map_or(spot.normal, |bumps| self.bumped(bumps, spot, frame));
                    let quick = !self.quality.real;
                    let color = match bumps {
                        // as was measured: `slope` and `aoi` of a pigment see the bumps
                        Some(_) => layer.color(&Spot { normal, ..*spot }, quick),
                        None => layer.color(spot, quick),
                    };
                    let cos = -spot.ray.dot(normal);
                    let opacity = color.opacity(self.opacity_by_color);
                    let shown = Shown { layer, color, opacity, weight: weight * pass, share, normal, cos };
                    pass *= color.passing() * left_over(&shown, self.border);
                    self.layers.push(shown);
                }
            }
            // What shows too little of itself is not looked at (measured on POV-Ray 3.7).
            if pass == Rgb::ZERO || gray(pass) <= self.bailout {
                break;
            }
        }
        pass
    }

    /// The normal that light sees: into the space of its texture by Mᵀ, back by M⁻ᵀ.
    fn bumped(&self, bumps: &Normal, spot: &Spot, frame: Option<&Frame>) -> DVec3 {
        let place = self.coat.place.as_deref().filter(|_| !bumps.stays);
        let local = place.map_or(spot.normal, |m| m.inverse_normal(spot.normal));
        let local = frame.map_or(local, |frame| frame.inside(local));
        let bumped = bumps.perturb(spot, local);
        let bumped = frame.map_or(bumped, |frame| frame.outside(bumped));
        place.map_or(bumped, |m| m.normal(bumped)).normalize_or(spot.normal)
    }
}

/// The spaces of the patterns that chose a texture, the innermost first.
struct Frame<'a> {
    space: &'a Space,
    outer: Option<&'a Frame<'a>>,
}

impl Frame<'_> {
    fn inside(&self, n: DVec3) -> DVec3 {
        self.space.normal_inside(self.outer.map_or(n, |outer| outer.inside(n)))
    }

    fn outside(&self, n: DVec3) -> DVec3 {
        let n = self.space.normal_outside(n);
        self.outer.map_or(n, |outer| outer.outside(n))
    }
}

/// The sum over what is painted on the side that a ray sees, all of it in equal parts, which `answer` is told; mostly one.
fn of_coats<'w>(
    world: &'w World,
    part: &'w Part,
    from_inside: bool,
    point: DVec3,
    mut answer: impl FnMut(&'w Coat, f64) -> Rgb,
) -> Rgb {
    if let Some(inside) = part.inside.as_ref().filter(|_| from_inside) {
        return answer(inside, 1.0);
    }
    if let Some(cut) = part.cut {
        let holds = |(node, coat): &'w (Node, Coat)| node.inside(point).then_some(coat);
        let coats: SmallVec<[&Coat; 4]> = world.cuts[cut as usize].iter().filter_map(holds).collect();
        if !coats.is_empty() {
            let share = 1.0 / coats.len() as f64;
            return coats.into_iter().map(|coat| answer(coat, share)).sum();
        }
    }
    answer(&part.outside, 1.0)
}

/// A material, and the place as it sees it; the normal is in world space.
fn spot<'w>(
    world: &'w World,
    coat: &Coat,
    found: &Found,
    surface: &Surface,
    normal: DVec3,
    ray: &Ray,
) -> (&'w Material, Spot) {
    let material = &world.materials[coat.material as usize];
    let spot = Spot {
        p: coat.local(surface.point),
        world: surface.point,
        uv: if material.uv { found.mapped_uv(surface) } else { DVec2::ZERO },
        normal,
        ray: ray.dir,
        noise: world.noise,
        waves: world.waves,
    };
    (material, spot)
}

/// What all layers at the place where `ray` meets `found` let pass; `quick` as the lower qualities show them.
pub(super) fn pass(world: &World, ray: &Ray, found: &Found, quick: bool) -> Rgb {
    let part = &world.parts[found.leaf.id as usize];
    let outside = &world.materials[part.outside.material as usize];
    if part.inside.is_none() && part.cut.is_none() && outside.solid && !quick {
        return outside.pass;
    }
    let surface = found.surface(ray);
    of_coats(world, part, ray.dir.dot(surface.normal) > 0.0, surface.point, |coat, share| {
        let (material, spot) = spot(world, coat, found, &surface, surface.normal, ray);
        share * pass_of(material, &spot, quick)
    })
}

/// What passes the layers of a material.
fn pass_of(material: &Material, spot: &Spot, quick: bool) -> Rgb {
    material.layers.iter().fold(Rgb::ONE, |pass, layer| match &layer.choice {
        Some(choice) => {
            let (number, inner) = choice.pattern.see(spot);
            let shares = choice.parts.shares(number, choice.averages());
            pass * shares.iter().fold(Rgb::ZERO, |sum, (part, share)| sum + *share * pass_of(part, &inner, quick))
        }
        None => pass * layer.color(spot, quick).passing(),
    })
}
