//! Lowers each shared texture, finish and normal only once.

use crate::color::Rgb;
use crate::scene::Settings;
use crate::texture::{Finish, Normal, NormalProgram};
use crate::world::LoweredFinish;
use crate::world::material::SharedParts;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Finishes and normals that were already lowered.
#[derive(Default)]
pub(super) struct SharedSurfaceParts {
    ambient_light: Rgb,
    /// Length of one unit in millimetres; `None` for a scene without subsurface light transport.
    mm_per_unit: Option<f64>,
    finishes: LoweredTable<Finish, Arc<LoweredFinish>>,
    normals: LoweredTable<Normal, Arc<NormalProgram>>,
}

impl SharedSurfaceParts {
    /// Creates an empty table for finishes of a scene with these settings.
    pub fn new(settings: &Settings) -> Self {
        let mm_per_unit = settings.subsurface.as_ref().map(|_| settings.mm_per_unit);
        Self { ambient_light: settings.ambient_light, mm_per_unit, ..Self::default() }
    }

    /// Drops the finishes and normals added since the last call that no object uses.
    pub fn drop_unused(&mut self) {
        self.finishes.drop_unused();
        self.normals.drop_unused();
    }
}

impl SharedParts for SharedSurfaceParts {
    fn lower_finish(&mut self, finish: &Arc<Finish>) -> Arc<LoweredFinish> {
        self.finishes
            .get_or_lower(finish, |finish| Arc::new(LoweredFinish::new(finish, self.ambient_light, self.mm_per_unit)))
            .clone()
    }

    fn lower_normal(&mut self, normal: &Arc<Normal>) -> Arc<NormalProgram> {
        self.normals.get_or_lower(normal, |normal| Arc::new(NormalProgram::new(normal))).clone()
    }
}

/// Table of lowered values by the address of their source, which is kept alive.
pub(super) struct LoweredTable<T, U> {
    known: FxHashMap<*const T, (Arc<T>, U)>,
    /// Keys that were added for the current object.
    fresh: Vec<*const T>,
}

impl<T, U> Default for LoweredTable<T, U> {
    fn default() -> Self {
        Self { known: FxHashMap::default(), fresh: vec![] }
    }
}

impl<T, U> LoweredTable<T, U> {
    /// Returns the lowered `thing`, which `lower` makes if the table has none.
    pub fn get_or_lower(&mut self, thing: &Arc<T>, lower: impl FnOnce(&T) -> U) -> &U {
        let address = Arc::as_ptr(thing);
        let (_, lowered) = self.known.entry(address).or_insert_with(|| {
            self.fresh.push(address);
            (thing.clone(), lower(thing))
        });
        lowered
    }

    /// Drops the values added since the last call whose source nothing else refers to.
    pub fn drop_unused(&mut self) {
        for address in self.fresh.drain(..) {
            if self.known.get(&address).is_some_and(|(thing, _)| Arc::strong_count(thing) == 1) {
                self.known.remove(&address);
            }
        }
    }
}
