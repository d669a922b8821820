//! What reaches a surface of a lamp's light.

use super::site;
use super::trace::Tracer;
use crate::color::Rgb;
use crate::math::{DVec3, Range, Ray, tolerance};
use std::ops::ControlFlow;

impl Tracer<'_> {
    /// The part of the light that comes through from a lamp at `distance` along `dir`. Every surface on the way takes
    /// its share, so what passes a solid is taken from twice.
    pub(super) fn unshadowed(&mut self, point: DVec3, dir: DVec3, distance: f64) -> Rgb {
        self.rays.shadow += 1;
        let world = self.setup.world;
        let ray = Ray::new(point, dir);
        let range = Range { min: tolerance::SHADOW, max: distance - tolerance::SHADOW };
        let see_through = self.setup.quality.real && world.see_through;
        // First whether anything opaque is in the way: that search ends at its first hit.
        let blocks = |id: u32| {
            let object = &world.objects[id as usize];
            object.shadow && (object.opaque || !see_through)
        };
        if world.geometry.any(&ray, range, blocks) {
            return Rgb::ZERO;
        }
        if !see_through {
            return Rgb::ONE;
        }
        let filters = |id: u32| {
            let object = &world.objects[id as usize];
            object.shadow && !object.opaque
        };
        let mut light = Rgb::ONE;
        let _ = world.geometry.visit(&ray, range, filters, &mut |found| {
            light *= site::pass(world, &ray, &found);
            if light == Rgb::ZERO { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        light
    }
}
