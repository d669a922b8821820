//! Lowers lights with their `looks_like` objects and light groups.

use super::{Group, Inherited, Lowering, Solid, lower_alone};
use crate::diagnostic::Result;
use crate::light::LoweredLight;
use crate::scene::{Flags, LightSource};
use crate::world;
use crate::world::lower::place::not_finite_error;

impl Lowering {
    /// Lowers a light, and adds its `looks_like` object to the geometry.
    pub(super) fn lower_light(
        &mut self,
        lit: &LightSource,
        own: &Inherited,
        inherited: &Inherited,
    ) -> Result<Option<Solid>> {
        let mut light = lit.light.clone();
        light.transform(&own.place.now);
        if !light.location.is_finite() {
            return not_finite_error(light.source).map(|()| None);
        }
        let through = match &lit.projected_through {
            Some(object) => {
                let mut object = object.clone();
                object.transform_by(&own.place.now);
                Some(Box::new(lower_alone(&object)?))
            }
            None => None,
        };
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
            group if group != 0 && lit.looks_like.is_some() => {
                self.add(Group { lights: vec![], within: Some(group), global: true })
            }
            _ => 0,
        };
        let around = Inherited { place: own.place.clone(), light_set, flags, ..Inherited::default() };
        lit.looks_like.as_ref().map_or(Ok(None), |object| self.lower_object(object, &around))
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
