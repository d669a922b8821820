//! Which object last kept a light away. POV-Ray asks that one first whether it does so again, and what it only weakens then is weakened
//! once more when all objects are asked: an object that lets light through counts twice, until another takes its place. It is
//! remembered if its own texture lets nothing pass, though those of its parts may, and if it was the first that the ray met. Rays from
//! the eye and all others have a memory each; lights of a `light_group` have none. (All measured on POV-Ray 3.7:
//! `tests/light_cases/remembered*.pov`.)
//!
//! So what a pixel shows depends on those before it, in worlds where such objects are ([`crate::world::World::remembers`]). There whole
//! blocks are drawn as in POV-Ray, row by row. What it still remembers of the blocks before, each block finds out by rays of
//! its own through some of them when it has to know, and so depends on nothing but its place.

use super::Region;
use super::blocks::BLOCK;
use super::refract::Interiors;
use super::shading_point;
use super::shadow::ToLight;
use super::trace::Tracer;
use crate::color::Rgb;
use crate::math;
use std::ops::Range;

/// So many blocks before may tell what is remembered, the last one first, by pixels so far apart. (Most often one row is enough. With all
/// pixels, two of a thousand random scenes more were as in POV-Ray, and those that have to know took twice the time.)
const STEPS: [usize; 4] = [2, 4, 4, 4];

/// Numbers of objects: for each light that of rays from the eye, and that of all others.
type Objects = Vec<[Option<u32>; 2]>;

/// What is remembered.
pub(super) struct Memory {
    last: Objects,
    past: Past,
}

/// What may be known of the pixels that were drawn before.
#[derive(Default)]
struct Past {
    /// Pixels that were not asked yet, row by row: where they begin and end, how far they are apart, and y. The last was drawn last.
    rows: Vec<(Range<usize>, usize, usize)>,
    /// What those know that were asked.
    found: Objects,
}

impl Memory {
    /// When a block of the picture is begun.
    pub fn at(block: Region, picture: Region, lights: usize) -> Self {
        let mut rows = vec![];
        let across = picture.width.div_ceil(BLOCK);
        let number = block.y / BLOCK * across + block.x / BLOCK;
        for (before, step) in (0..number).rev().zip(STEPS) {
            let [x, y] = [before % across, before / across].map(|at| at * BLOCK);
            let bottom = (y + BLOCK).min(picture.height);
            rows.extend((y..bottom).rev().step_by(step).map(|y| (x..(x + BLOCK).min(picture.width), step, y)));
        }
        rows.reverse();
        Self { past: Past { rows, found: vec![[None; 2]; lights] }, ..Self::of_nothing(lights) }
    }

    /// Before any pixel; in worlds where nothing is remembered nobody asks, for no light.
    pub fn of_nothing(lights: usize) -> Self {
        Self { last: vec![[None; 2]; lights], past: Past::default() }
    }
}

impl Tracer<'_> {
    /// What the remembered object lets pass, on a way of this level; the ray is `inside` of others then, if it meets it.
    pub(super) fn past_remembered(&mut self, to_light: &ToLight, level: u32, inside: &mut Interiors) -> Rgb {
        let ToLight { light, ref ray, distance, .. } = *to_light;
        let (world, range) = (self.setup.world, math::Range { min: self.setup.world.nearness.surface, max: distance });
        let kind = usize::from(level > 1);
        let passes = |id: u32| world.objects[id as usize].remembered && !world.objects[id as usize].opaque;
        // (Others keep all of the light away when all objects are asked.)
        if self.memory.last[light.number][kind].is_none() && world.geometry.any(ray, range, passes) {
            let _ = (kind..2).find_map(|kind| self.recall(light.number, kind));
        }
        // Of rays from the eye, if nothing is remembered, that of the others.
        let remembered = self.memory.last[light.number][kind..].iter().find_map(|object| *object);
        let found = remembered.and_then(|last| world.geometry.closest(ray, range, |id| id == last));
        match found {
            Some(found) if !world.parts[found.part() as usize].no_shadow => self.crossing(ray, &found, 0.0, inside),
            _ => Rgb::ONE,
        }
    }

    /// Is the first thing in the way one to be remembered, which lets nothing pass?
    pub(super) fn remembers(&mut self, to_light: &ToLight, level: u32) -> bool {
        let ToLight { light, ref ray, range, .. } = *to_light;
        let world = self.setup.world;
        let Some(found) = world.geometry.closest(ray, range, |id| world.objects[id as usize].shadow) else {
            return false;
        };
        let keeps = world.objects[found.object as usize].remembered
            && shading_point::pass(world, ray, &found, !self.setup.quality.real) == Rgb::ZERO;
        if keeps {
            self.memory.last[light.number][usize::from(level > 1)] = Some(found.object);
        }
        keeps
    }

    /// What is remembered of a light, if need be since the blocks before.
    fn recall(&mut self, light: usize, kind: usize) -> Option<u32> {
        let lights = self.memory.last.len();
        while self.memory.last[light][kind].or(self.memory.past.found.get(light)?[kind]).is_none() {
            let (columns, step, y) = self.memory.past.rows.pop()?;
            let known = self.after(Memory::of_nothing(lights), columns.step_by(step), y).last;
            for (found, known) in self.memory.past.found.iter_mut().flatten().zip(known.iter().flatten()) {
                *found = found.or(*known);
            }
        }
        let slot = &mut self.memory.last[light][kind];
        *slot = slot.or(self.memory.past.found[light][kind]);
        *slot
    }
}

/// The whole blocks around an area, as far as they lie within another.
pub(super) fn blocks_around(area: Region, within: Region) -> Region {
    let cut = |start: usize, length: usize, low: usize, size: usize| {
        let from = (start / BLOCK * BLOCK).max(low);
        (from, (start + length).next_multiple_of(BLOCK).min(low + size) - from)
    };
    let (x, width) = cut(area.x, area.width, within.x, within.width);
    let (y, height) = cut(area.y, area.height, within.y, within.height);
    Region { x, y, width, height }
}
