//! Shadow rays: the object that occludes a ray wholly, or the objects that may filter its light.

use super::{Blocker, Geometry};
use crate::math::{Range, Ray};
use crate::world::leaf::Intersections;
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Effect of an object on the light of a shadow ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShadowRole {
    /// The object casts no shadow.
    Ignored,
    /// The object may transmit a part of the light.
    Filters,
    /// The object transmits no light.
    Occludes,
}

/// The objects that may filter the light of one shadow ray, because the ray intersects their boxes.
#[derive(Debug, Default)]
pub struct LightFilters {
    indices: SmallVec<[u32; 4]>,
}

impl LightFilters {
    /// Adds the object with this index. (Not inlined: shadow rays that meet no such object are faster without this code.)
    #[inline(never)]
    fn push(&mut self, index: usize) {
        self.indices.push(index as u32);
    }

    /// True if no object filters the light.
    pub fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }
}

impl Geometry {
    /// Returns the objects that may filter the light of a shadow ray within the range, or `None` if an object occludes
    /// it wholly; `role_of_object` returns the effect of an object by its number. Tests the object in `last_occluder`
    /// first, which occluded an earlier ray from nearby, and stores the new occluder in `last_occluder`.
    pub fn filters_unless_occluded(
        &self,
        ray: &Ray,
        range: Range,
        role_of_object: impl Fn(u32) -> ShadowRole,
        last_occluder: &mut Option<Blocker>,
    ) -> Option<LightFilters> {
        if let Some(Blocker(i)) = *last_occluder {
            let item = &self.items[i];
            if role_of_object(item.object()) == ShadowRole::Occludes && item.any(ray, range) {
                return None;
            }
        }
        *last_occluder = None;
        let mut filters = LightFilters::default();
        self.visit_intersected_boxes(ray, range, |i, range| {
            let item = &self.items[i];
            match role_of_object(item.object()) {
                ShadowRole::Occludes if item.any(ray, range) => {
                    *last_occluder = Some(Blocker(i));
                    return ControlFlow::Break(());
                }
                ShadowRole::Filters => filters.push(i),
                ShadowRole::Occludes | ShadowRole::Ignored => {}
            }
            ControlFlow::Continue(range.max)
        });
        last_occluder.is_none().then_some(filters)
    }

    /// Appends all hits of the ray in the range on the objects that may filter its light to `out`, in no particular order.
    pub fn add_hits_on_filters<'a>(
        &'a self,
        filters: &LightFilters,
        ray: &Ray,
        range: Range,
        out: &mut Intersections<'a>,
    ) {
        filters.indices.iter().for_each(|&i| self.items[i as usize].hits(ray, range, out));
    }
}
