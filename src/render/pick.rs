//! `durer pick`: the first hit through a pixel.

use super::{Options, Picked};
use crate::math::Range;
use crate::value::Family;
use crate::world::World;

/// Returns the closest visible hit through the centre of pixel (x, y), counted from the top left; `None` where nothing is hit.
pub fn pick(world: &World, options: &Options, x: usize, y: usize) -> Option<Picked> {
    let ray = world.eye.view(options.width, options.height).ray_at_pixel_position(x as f64 + 0.5, y as f64 + 0.5)?;
    let range = Range { min: world.epsilon.surface, max: f64::INFINITY };
    let found = world.geometry.closest(&ray, range, |id| world.objects[id as usize].image)?;
    let surface = found.surface(&ray);
    let part = &world.parts[found.part_number() as usize];
    Some(Picked {
        shape: found.leaf.shape.spec().name,
        t: found.t(),
        point: surface.point.to_array(),
        normal: surface.normal.to_array(),
        uv: found.uv(surface.object_point).to_array(),
        source: part.source,
    })
}
