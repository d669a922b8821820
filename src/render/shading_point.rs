//! A place on a surface: what is painted there.

use super::mirror::left_over;
use super::refract::Interface;
use super::trace::Quality;
use crate::color::{Color, Rgb, gray};
use crate::math::{DVec2, DVec3, Ray};
use crate::pattern::{Space, TextureContext};
use crate::shape::{Kernel, TextureWeights};
use crate::texture::NormalProgram;
use crate::world::{Intersection, Layer, Material, Part, PlacedMaterial, SolidNode, Surface, World};
use smallvec::SmallVec;

/// A layer of the texture at a place.
pub(super) struct ShadedLayer<'w> {
    pub layer: &'w Layer,
    /// Its pigment there.
    pub color: Color,
    /// The part of the pigment that is not see-through.
    pub opacity: f64,
    /// What the layers above let pass of it.
    pub weight: Rgb,
    /// With its bumps; length 1, in world space.
    pub normal: DVec3,
    /// Between the ray, turned round, and this normal; negative where bumps are seen from behind.
    pub cos: f64,
}

/// A texture at a place. Where a pattern chooses among several, what is seen is the sum over them by their shares, each with the mirror
/// and the refraction of its own (measured on POV-Ray 3.7).
pub(super) struct Coat<'w> {
    /// How much of the place shows it.
    pub share: f64,
    /// Length 1, towards the ray's origin, with the bumps of the topmost layer.
    pub normal: DVec3,
    /// From the topmost to the lowest that can be seen; never empty.
    pub layers: SmallVec<[ShadedLayer<'w>; 2]>,
    /// What passes all layers of the light from behind.
    pub pass: Rgb,
}

/// The place where a ray meets a surface.
pub(super) struct ShadingPoint<'w> {
    pub part: &'w Part,
    pub point: DVec3,
    /// Length 1, towards the ray's origin, without bumps.
    pub smooth: DVec3,
    /// Never empty, but where all shares are none.
    pub coats: SmallVec<[Coat<'w>; 1]>,
}

impl<'w> ShadingPoint<'w> {
    /// Where `ray` meets `found` at a border.
    pub fn new(world: &'w World, ray: &Ray, found: &Intersection, quality: &Quality, interface: &Interface) -> Self {
        let part = &world.parts[found.part() as usize];
        let surface = found.surface(ray);
        let against = ray.dir.dot(surface.normal);
        let normal = if against > 0.0 { -surface.normal } else { surface.normal };
        let mut this = Self { part, point: surface.point, smooth: normal, coats: SmallVec::new() };
        let mut painter = Painter {
            placed: &part.outside,
            quality,
            interface,
            opacity_by_color: world.opacity_by_color,
            bailout: world.adc_bailout,
            seen: normal,
            coats: &mut this.coats,
        };
        of_materials(world, found, &surface, against > 0.0, |placed, share| {
            let (material, ctx) = texture_context(world, placed, found, &surface, normal, ray);
            painter.placed = placed;
            painter.paint(material, &ctx, share, None);
        });
        this
    }

    /// All layers of all coats.
    pub fn layers(&self) -> impl Iterator<Item = &ShadedLayer<'w>> {
        self.coats.iter().flat_map(|coat| &coat.layers)
    }

    /// The sum over all layers of what `light` says, by the shares of their coats.
    pub fn sum(&self, mut light: impl FnMut(&ShadedLayer<'w>) -> Rgb) -> Rgb {
        let mut sum = Rgb::ZERO;
        for coat in &self.coats {
            sum += coat.share * coat.layers.iter().map(&mut light).sum::<Rgb>();
        }
        sum
    }
}

/// Collects what is painted at a place.
struct Painter<'w, 'a> {
    placed: &'w PlacedMaterial,
    quality: &'a Quality,
    interface: &'a Interface,
    opacity_by_color: bool,
    bailout: f64,
    /// The normal that patterns see: that of the last bumps before them, in whatever space those were (measured on POV-Ray 3.7); only
    /// `slope` and `aoi` show it.
    seen: DVec3,
    coats: &'a mut SmallVec<[Coat<'w>; 1]>,
}

impl<'w> Painter<'w, '_> {
    /// Adds the coats of a material that counts for `share`. (A texture that a pattern chooses has no layers beside it: POV-Ray refuses
    /// that, and so do we.)
    fn paint(&mut self, material: &'w Material, ctx: &TextureContext, share: f64, frame: Option<&PatternSpaces>) {
        match material.layers.iter().find_map(|layer| layer.choice.as_deref()) {
            Some(choice) => {
                let (number, inner) = choice.pattern.see(&self.sees(ctx));
                let inner = TextureContext { normal: ctx.normal, ..inner };
                let within = PatternSpaces { space: &choice.space, outer: frame };
                let mut shares = choice.shares(number);
                // (The upper of two goes first, as `seen` shows.)
                if !choice.averages() {
                    shares.reverse();
                }
                for (part, s) in shares {
                    self.paint(part, &inner, share * s, Some(&within));
                }
            }
            None => self.coat(material, ctx, share, frame),
        }
    }

    /// The place as patterns see it.
    fn sees(&self, ctx: &TextureContext) -> TextureContext {
        TextureContext { normal: self.seen, ..*ctx }
    }

    /// Without light, the last layer that is looked at is seen alone (measured on POV-Ray 3.7).
    fn coat(&mut self, material: &'w Material, ctx: &TextureContext, share: f64, frame: Option<&PatternSpaces>) {
        // (It is filled where it stays: it is large.)
        let number = self.coats.len();
        self.coats.push(Coat { share, normal: ctx.normal, layers: SmallVec::new(), pass: Rgb::ONE });
        let mut pass = Rgb::ONE;
        for layer in &material.layers {
            let bumps = layer.normal.as_ref().filter(|_| self.quality.mirrors);
            let quick = !self.quality.real;
            let (normal, seen, weight) = match bumps.map(|bumps| self.bumped(bumps, ctx, frame)) {
                None => (ctx.normal, self.seen, pass),
                // as was measured: `slope` and `aoi` of a pigment see the bumps
                Some(bumped) if bumped.seen.is_finite() => {
                    self.seen = bumped.seen;
                    (bumped.lit.normalize_or(ctx.normal), bumped.seen, pass)
                }
                // Where a normal is no number, nothing that is seen of it is (measured on POV-Ray 3.7).
                Some(_) => (ctx.normal, ctx.normal, Rgb::NAN),
            };
            let seen = TextureContext { normal: seen, ..*ctx };
            let color = layer.color(&seen, quick);
            let cos = -ctx.ray.dot(normal);
            let opacity = color.opacity(self.opacity_by_color);
            let layers = &mut self.coats[number].layers;
            if !self.quality.lit {
                layers.clear();
            }
            let weight = if self.quality.lit { weight } else { Rgb::ONE };
            let shaded = ShadedLayer { layer, color, opacity, weight, normal, cos };
            pass *= color.passing();
            // The mirror takes nothing where there is no pigment (measured on POV-Ray 3.7).
            if layer.finish.conserve_energy && !layer.is_nothing(&seen, quick) {
                pass *= left_over(&shaded, self.interface);
            }
            layers.push(shaded);
            // What shows too little of itself is not looked at (measured on POV-Ray 3.7).
            if pass == Rgb::ZERO || gray(pass) <= self.bailout {
                break;
            }
        }
        let coat = &mut self.coats[number];
        let refraction = coat.layers.first().map_or(1.0, |top| {
            coat.normal = top.normal;
            top.layer.finish.refraction
        });
        coat.pass = refraction * pass;
    }

    /// The normal with bumps: into the space of its texture by Mᵀ, back by M⁻ᵀ. What is in the entry of a map, or in a texture with
    /// `uv_mapping`, begins with one of length 1, and its pigment sees it as it is in there (all measured on POV-Ray 3.7).
    fn bumped(&self, bumps: &NormalProgram, ctx: &TextureContext, frame: Option<&PatternSpaces>) -> Bumped {
        let within = frame.is_some() || bumps.framed;
        let place = self.placed.place.as_deref().filter(|_| within || !bumps.stays);
        let local = place.map_or(ctx.normal, |m| m.inverse_normal(ctx.normal));
        let local = frame.map_or(local, |frame| frame.inside(local));
        let local = if within { local.normalize_or(local) } else { local };
        let inner = bumps.perturb(&self.sees(ctx), local);
        let outer = frame.map_or(inner, |frame| frame.outside(inner));
        let lit = place.map_or(outer, |m| m.normal(outer));
        let seen = if within { inner } else { lit };
        Bumped { lit, seen: if bumps.keeps_length() { seen } else { seen.normalize_or(seen) } }
    }
}

/// A normal with bumps.
struct Bumped {
    /// As light meets it, of any length, in world space.
    lit: DVec3,
    /// As the pigment sees it; no number where it is none.
    seen: DVec3,
}

/// The spaces of the patterns that chose a texture, the innermost first.
struct PatternSpaces<'a> {
    space: &'a Space,
    outer: Option<&'a PatternSpaces<'a>>,
}

impl PatternSpaces<'_> {
    fn inside(&self, n: DVec3) -> DVec3 {
        self.space.normal_inside(self.outer.map_or(n, |outer| outer.inside(n)))
    }

    fn outside(&self, n: DVec3) -> DVec3 {
        let n = self.space.normal_outside(n);
        self.outer.map_or(n, |outer| outer.outside(n))
    }
}

/// Tells what is painted on the side that a ray sees, and in what shares; mostly one.
fn of_materials<'w>(
    world: &'w World,
    found: &Intersection,
    surface: &Surface,
    from_inside: bool,
    mut tell: impl FnMut(&'w PlacedMaterial, f64),
) {
    let part = &world.parts[found.part() as usize];
    let Some(uncommon) = &part.uncommon else { return tell(&part.outside, 1.0) };
    if let Some(inside) = uncommon.inside.as_ref().filter(|_| from_inside != found.keeps_sides()) {
        return tell(inside, 1.0);
    }
    if let Some(cut) = uncommon.cut {
        let holds = |(node, placed): &'w (SolidNode, PlacedMaterial)| node.inside(surface.point).then_some(placed);
        let materials: SmallVec<[&PlacedMaterial; 4]> = world.cuts[cut as usize].iter().filter_map(holds).collect();
        if !materials.is_empty() {
            let share = 1.0 / materials.len() as f64;
            return materials.into_iter().for_each(|placed| tell(placed, share));
        }
    }
    if uncommon.embedded.is_empty() {
        return tell(&part.outside, 1.0);
    }
    // Small shares are not seen, and the others get no more for it; each component and each corner is asked by itself, whether or not
    // others look the same (measured on POV-Ray 3.7, for blobs and meshes).
    let mut seen = TextureWeights::new();
    for (slot, share) in found.leaf.shape.texture_weights(surface.object_point, &found.hit) {
        match seen.iter_mut().find(|(other, _)| *other == slot) {
            _ if share < world.adc_bailout => {}
            Some((_, sum)) => *sum += share,
            None => seen.push((slot, share)),
        }
    }
    for (slot, share) in seen {
        let own = slot.checked_sub(1).and_then(|number| uncommon.embedded.get(number as usize));
        tell(own.unwrap_or(&part.outside), share);
    }
}

/// A material, and the place as it sees it; the normal is in world space.
fn texture_context<'w>(
    world: &'w World,
    placed: &PlacedMaterial,
    found: &Intersection,
    surface: &Surface,
    normal: DVec3,
    ray: &Ray,
) -> (&'w Material, TextureContext) {
    let material = &world.materials[placed.material as usize];
    let on_surface = world.parts[found.part() as usize].uv;
    let uv = if on_surface || material.uv { found.mapped_uv(surface) } else { DVec2::ZERO };
    let ctx = TextureContext {
        p: placed.local(if on_surface { uv.extend(0.0) } else { surface.point }),
        world: surface.point,
        uv,
        normal,
        ray: ray.dir,
        noise: world.noise,
        waves: world.waves,
    };
    (material, ctx)
}

/// What all layers at the place where `ray` meets `found` let pass; `quick` as the lower qualities show them.
pub(super) fn pass(world: &World, ray: &Ray, found: &Intersection, quick: bool) -> Rgb {
    let part = &world.parts[found.part() as usize];
    let outside = &world.materials[part.outside.material as usize];
    if part.uncommon.is_none() && outside.solid && !quick {
        return outside.pass;
    }
    let surface = found.surface(ray);
    let from_inside = ray.dir.dot(surface.normal) > 0.0;
    // Patterns see it from where the ray comes, as elsewhere (measured on POV-Ray 3.7).
    let normal = if from_inside { -surface.normal } else { surface.normal };
    let (mut pass, mut seen) = (Rgb::ZERO, 0.0);
    of_materials(world, found, &surface, from_inside, |placed, share| {
        let (material, ctx) = texture_context(world, placed, found, &surface, normal, ray);
        pass += share * pass_of(material, &ctx, quick);
        seen += share;
    });
    // Shares that are too small to be seen are missing twice from light (measured on POV-Ray 3.7).
    pass * seen
}

/// What passes the layers of a material.
fn pass_of(material: &Material, ctx: &TextureContext, quick: bool) -> Rgb {
    material.layers.iter().fold(Rgb::ONE, |pass, layer| match &layer.choice {
        Some(choice) => {
            let (number, inner) = choice.pattern.see(ctx);
            let shares = choice.shares(number);
            pass * shares.iter().fold(Rgb::ZERO, |sum, (part, share)| sum + *share * pass_of(part, &inner, quick))
        }
        None => pass * layer.color(ctx, quick).passing(),
    })
}
