//! Lights: each in its place, with the objects that belong to it, and what it shines on.

use super::{Group, Inherited, Lowering, Solid, lower_alone};
use crate::diagnostic::Result;
use crate::light::LoweredLight;
use crate::scene::{Flags, LightSource};
use crate::world;
use crate::world::lower::place::not_finite;

impl Lowering {
    /// A light; what it looks like is seen like any object.
    pub(super) fn lower_light(
        &mut self,
        lit: &LightSource,
        own: &Inherited,
        inherited: &Inherited,
    ) -> Result<Option<Solid>> {
        let mut light = lit.light.clone();
        light.transform(&own.place.now);
        if !light.location.is_finite() {
            return not_finite(light.source).map(|()| None);
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
        // A light in a union within a group is one of all lights (measured on POV-Ray 3.7).
        match inherited.lights_here {
            true => self.groups[inherited.lights as usize - 1].lights.push(number),
            false => self.global.push(number),
        }
        let flags = Flags { no_shadow: true, ..Flags::NONE };
        // What a light looks like is not a part of the group around it: all lights shine on it, those of the group and those outside, also
        // where `global_lights` is off (measured on POV-Ray 3.7).
        let lights = match inherited.lights {
            group if group != 0 && lit.looks_like.is_some() => {
                self.add(Group { lights: vec![], within: Some(group), global: true })
            }
            _ => 0,
        };
        let around = Inherited { place: own.place.clone(), lights, flags, ..Inherited::default() };
        lit.looks_like.as_ref().map_or(Ok(None), |object| self.lower_object(object, &around))
    }

    /// A group of lights; its number.
    pub(super) fn add_group(&mut self, global: bool) -> u32 {
        self.add(Group { lights: vec![], within: None, global })
    }

    fn add(&mut self, group: Group) -> u32 {
        self.groups.push(group);
        self.groups.len() as u32
    }

    /// For each group of lights, number 0 being none, the lights that shine on its objects, in the order in which they were declared.
    pub(super) fn lit_by(&self) -> Vec<Box<[u32]>> {
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
