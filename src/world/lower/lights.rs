//! Lowers lights with their `looks_like` objects and light groups.

use super::{Group, Inherited, Lowering, Solid, lower_alone};
use crate::diagnostic::Result;
use crate::light::{LightPhotons, LoweredLight};
use crate::scene::{Flags, LightSource};
use crate::world;
use crate::world::lower::place::not_finite_error;

impl Lowering {
    /// Adds the lowered light to the lists of lights, and returns its lowered `looks_like` object; `None` for a light
    /// without. `own` are the properties inside the light's block, `inherited` those around it.
    pub(super) fn lower_light(
        &mut self,
        scene_light: &LightSource,
        own: &Inherited,
        inherited: &Inherited,
    ) -> Result<Option<Solid>> {
        let mut light = scene_light.light.clone();
        light.transform(&own.place.world_from_block);
        if !light.location.is_finite() {
            return not_finite_error(light.source).map(|()| None);
        }
        let through = match &scene_light.projected_through {
            Some(object) => {
                let mut object = object.clone();
                object.transform_by(&own.place.world_from_block);
                Some(Box::new(lower_alone(&object)?))
            }
            None => None,
        };
        if inherited.lights_here {
            // quirk: photons_of_global_lights
            light.photons = LightPhotons { refraction: Some(false), reflection: Some(false), area_light: false };
        }
        let number = self.lights.len() as u32;
        self.lights.push(world::LightSource { number: number as usize, emitter: LoweredLight::new(&light), through });
        // quirk: light_in_union_of_group
        match inherited.lights_here {
            true => self.groups[inherited.light_set as usize - 1].lights.push(number),
            false => self.global.push(number),
        }
        let flags = Flags { no_shadow: true, ..Flags::NONE };
        // quirk: looks_like_ignores_group
        let light_set = match inherited.light_set {
            group if group != 0 && scene_light.looks_like.is_some() => {
                self.add(Group { lights: vec![], within: Some(group), global: true })
            }
            _ => 0,
        };
        let around = Inherited { place: own.place.clone(), light_set, flags, ..Inherited::default() };
        scene_light.looks_like.as_ref().map_or(Ok(None), |object| self.lower_object(object, &around))
    }

    /// Adds a light group and returns its number.
    pub(super) fn add_light_group(&mut self, global_lights: bool) -> u32 {
        self.add(Group { lights: vec![], within: None, global: global_lights })
    }

    fn add(&mut self, group: Group) -> u32 {
        self.groups.push(group);
        self.groups.len() as u32
    }

    /// Returns the lights that illuminate the objects of each light group; group 0 is that of objects in no group.
    pub(super) fn lights_of_groups(&self) -> Vec<Box<[u32]>> {
        let of_group = |group: &Group| {
            let global: &[u32] = if group.global { &self.global } else { &[] };
            let around = group.within.map_or(&[][..], |within| &self.groups[within as usize - 1].lights);
            let mut lights = [&group.lights, around, global].concat();
            lights.sort_unstable();
            lights.into()
        };
        std::iter::once(self.global.as_slice().into()).chain(self.groups.iter().map(of_group)).collect()
    }
}
