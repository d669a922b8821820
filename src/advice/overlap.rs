//! Surfaces that lie in one another: which one a ray meets first is chance, and the picture shows specks of both.
//!
//! Only what is seen counts: a box that stands on a floor touches it, and nobody sees where.

use super::shows;
use crate::diagnostic::{Diagnostic, codes};
use crate::math::{DVec3, Range, Ray};
use crate::render;
use crate::world::{Intersection, PlacedSolid, SolidKind, World};
use rustc_hash::FxHashMap;

/// So many rays are asked at most, and no more than one for so many pixels: it must not be noticed.
const SAMPLES: usize = 1500;
const PIXELS: usize = 30;
/// Two surfaces must be seen together at so many places: along an edge they always meet.
const PLACES: u32 = 3;
/// As many pairs are told.
const TOLD: usize = 3;
/// Surfaces that are nearer than this along a ray, relative to its length, are one.
const NEAR: f64 = 1e-9;

/// What two surfaces do where they meet.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Fight {
    /// Each has its own look.
    Looks,
    /// One is the end of what the other begins: a skin without thickness.
    Skin,
}

pub(super) fn of_picture(world: &World, options: &render::Options) -> Vec<Diagnostic> {
    let mut pairs: FxHashMap<(u32, u32), u32> = FxHashMap::default();
    let mut out: Vec<Diagnostic> = vec![];
    for ray in rays(world, options) {
        for (a, b, fight) in meetings(world, &ray) {
            let places = pairs.entry((a, b)).or_insert(0);
            *places += 1;
            if *places == PLACES
                && let Some(d) = told(world, a, b, fight)
                && !out.iter().any(|other| other.labels == d.labels)
            {
                out.push(d);
            }
        }
        if out.len() >= TOLD {
            break;
        }
    }
    out
}

/// A few rays all over the picture, none through the middle of a pixel: things that are drawn with round numbers have their edges there.
fn rays(world: &World, options: &render::Options) -> impl Iterator<Item = Ray> + use<> {
    let (width, height) = (options.width as f64, options.height as f64);
    let view = world.eye.view(options.width, options.height);
    let count = SAMPLES.min(options.width * options.height / PIXELS);
    // The multiples of these two irrational numbers fill a square evenly (Roberts 2018, "R2").
    (0..count).filter_map(move |i| {
        let part = |step: f64| (0.5 + step * (i + 1) as f64).fract();
        view.ray(part(0.754_877_666_246_693) * width, part(0.569_840_290_998_053) * height)
    })
}

/// The surfaces that share the place that this ray sees, by their numbers, the smaller first.
fn meetings(world: &World, ray: &Ray) -> Vec<(u32, u32, Fight)> {
    let range = Range { min: world.epsilon.surface, max: f64::INFINITY };
    let Some(seen) = world.geometry.closest(ray, range, |id| shows(world, id)) else { return vec![] };
    let near = NEAR * (1.0 + seen.t());
    let around = Range { min: seen.t() - near, max: seen.t() + near };
    let normal = seen.surface(ray).normal;
    let mut out = vec![];
    world.geometry.shapes_at(ray, around, &mut |item, other| {
        if other.part() != seen.part()
            && shows(world, item.object())
            && let Some(fight) = fight(world, ray, &item, &seen, &other, normal)
        {
            let (a, b) = (seen.part().min(other.part()), seen.part().max(other.part()));
            out.push((a, b, fight));
        }
    });
    out
}

fn fight(
    world: &World,
    ray: &Ray,
    item: &PlacedSolid,
    seen: &Intersection,
    other: &Intersection,
    normal: DVec3,
) -> Option<Fight> {
    // (An object that cuts its parts shows some of their surfaces and not others.)
    let cut = matches!(item.node().kind(), SolidKind::Intersection(_) | SolidKind::Merge(_));
    let along = other.surface(ray).normal.dot(normal);
    if along.abs() < 1.0 - 1e-6 {
        return None;
    }
    if cut && item.object() == seen.object && along < 0.0 {
        return Some(Fight::Skin);
    }
    let kept = !cut || item.inside(ray.at(seen.t()) - normal * (NEAR.sqrt() * (1.0 + seen.t())));
    let look = |found: &Intersection| world.parts.get(found.part() as usize).map(|part| &part.outside);
    let (a, b) = (look(seen)?, look(other)?);
    let same = a.material == b.material && a.place.as_deref() == b.place.as_deref();
    (kept && !same).then_some(Fight::Looks)
}

fn told(world: &World, a: u32, b: u32, fight: Fight) -> Option<Diagnostic> {
    let (a, b) = (world.parts.get(a as usize)?, world.parts.get(b as usize)?);
    // Two passes of a loop, or two copies of one thing: a place by itself tells enough.
    let one = a.source == b.source;
    let (message, help) = match fight {
        Fight::Looks => (
            "two surfaces lie in one another: chance decides which is seen",
            "move one of them a little, as by `0.001*y`",
        ),
        Fight::Skin => (
            "what is taken away ends in the surface of the other: a skin without thickness is left",
            "let it stick out a little, so that it goes all the way through",
        ),
    };
    let d = Diagnostic::new(codes::SAME_SURFACE, a.source, message).help(help);
    Some(if one { d.label("two copies of this") } else { d.label("this one").also(b.source, "and this one") })
}
