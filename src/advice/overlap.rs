//! The warning about coincident surfaces: rounding decides which one a ray hits first, and the picture shows specks of
//! both.
//!
//! Only visible surfaces count: the contact of a box and its floor is hidden.

use super::is_visible_to_camera;
use crate::diagnostic::{Diagnostic, codes};
use crate::math::{DVec3, Range, Ray};
use crate::render;
use crate::world::{Intersection, PlacedSolid, SolidKind, World};
use rustc_hash::FxHashMap;

/// Maximum number of test rays, so that the test takes no noticeable time.
const MAX_RAYS: usize = 1500;
/// Number of pixels per test ray.
const PIXELS_PER_RAY: usize = 30;
/// Minimum number of points at which two surfaces must coincide. (At common edges, surfaces always coincide.)
const MIN_POINTS: u32 = 3;
/// Maximum number of warnings about coincident surfaces.
const MAX_WARNINGS: usize = 3;
/// Distance along a ray below which surfaces coincide, relative to the length of the ray.
const TOLERANCE: f64 = 1e-9;

/// Kind of a coincidence of two surfaces.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Coincidence {
    /// Coincident surfaces with different materials.
    Materials,
    /// Coincidence of a surface with the end of a subtracted object: a skin without thickness remains.
    Skin,
}

pub(super) fn coincidence_warnings(world: &World, options: &render::Options) -> Vec<Diagnostic> {
    let mut pairs: FxHashMap<(u32, u32), u32> = FxHashMap::default();
    let mut out: Vec<Diagnostic> = vec![];
    for ray in rays_beside_pixel_centers(world, options) {
        for (a, b, kind) in first_hit_coincident_pairs(world, &ray) {
            let places = pairs.entry((a, b)).or_insert(0);
            *places += 1;
            if *places == MIN_POINTS
                && let Some(d) = coincident_parts_warning(world, a, b, kind)
                && !out.iter().any(|other| other.labels == d.labels)
            {
                out.push(d);
            }
        }
        if out.len() >= MAX_WARNINGS {
            break;
        }
    }
    out
}

/// Returns test rays all over the picture, beside the centres of pixels, where objects often have edges.
fn rays_beside_pixel_centers(world: &World, options: &render::Options) -> impl Iterator<Item = Ray> + use<> {
    let (width, height) = (options.width as f64, options.height as f64);
    let view = world.eye.view(options.width, options.height);
    let count = MAX_RAYS.min(options.width * options.height / PIXELS_PER_RAY);
    // Low-discrepancy sequence R2 (Roberts 2018).
    (0..count).filter_map(move |i| {
        let part = |step: f64| (0.5 + step * (i + 1) as f64).fract();
        view.ray_at_pixel_position(part(0.754_877_666_246_693) * width, part(0.569_840_290_998_053) * height)
    })
}

/// Returns the pairs of parts whose surfaces coincide at the first hit of a ray, as part indices with the smaller one first.
fn first_hit_coincident_pairs(world: &World, ray: &Ray) -> Vec<(u32, u32, Coincidence)> {
    let range = Range { min: world.epsilon.surface, max: f64::INFINITY };
    let Some(seen) = world.geometry.closest(ray, range, |id| is_visible_to_camera(world, id)) else { return vec![] };
    let near = TOLERANCE * (1.0 + seen.t());
    let around = Range { min: seen.t() - near, max: seen.t() + near };
    let normal = seen.surface(ray).normal;
    let mut out = vec![];
    world.geometry.visit_all_shape_hits(ray, around, &mut |item, other| {
        if other.part_number() != seen.part_number()
            && is_visible_to_camera(world, item.object())
            && let Some(kind) = coincidence_kind(world, ray, &item, &seen, &other, normal)
        {
            let (a, b) = (seen.part_number().min(other.part_number()), seen.part_number().max(other.part_number()));
            out.push((a, b, kind));
        }
    });
    out
}

fn coincidence_kind(
    world: &World,
    ray: &Ray,
    item: &PlacedSolid,
    seen: &Intersection,
    other: &Intersection,
    normal: DVec3,
) -> Option<Coincidence> {
    // An intersection shows only some surfaces of its parts.
    let cut = matches!(item.node().kind(), SolidKind::Intersection(_) | SolidKind::Merge(_));
    let along = other.surface(ray).normal.dot(normal);
    if along.abs() < 1.0 - 1e-6 {
        return None;
    }
    if cut && item.object() == seen.object && along < 0.0 {
        return Some(Coincidence::Skin);
    }
    let kept = !cut || item.inside(ray.at(seen.t()) - normal * (TOLERANCE.sqrt() * (1.0 + seen.t())));
    let look = |found: &Intersection| world.parts.get(found.part_number() as usize).map(|part| &part.outside);
    let (a, b) = (look(seen)?, look(other)?);
    let same = a.material == b.material && a.place.as_deref() == b.place.as_deref();
    (kept && !same).then_some(Coincidence::Materials)
}

fn coincident_parts_warning(world: &World, a: u32, b: u32, kind: Coincidence) -> Option<Diagnostic> {
    let (a, b) = (world.parts.get(a as usize)?, world.parts.get(b as usize)?);
    // Two passes of a loop or two copies have one position.
    let one = a.source == b.source;
    let (message, help) = match kind {
        Coincidence::Materials => (
            "two surfaces coincide: rounding decides which one is visible",
            "move one of them a little, as by `0.001*y`",
        ),
        Coincidence::Skin => (
            "the subtracted object ends in the surface of the other one: a skin without thickness remains",
            "enlarge it a little, so that it extends beyond the other one",
        ),
    };
    let d = Diagnostic::new(codes::SAME_SURFACE, a.source, message).help(help);
    Some(if one { d.label("two copies of this") } else { d.label("this one").also(b.source, "and this one") })
}
