//! Geometric queries of the scene's text: `trace`, `inside` and extents of declared objects.

use super::Geometry;
use super::lower::lower_alone;
use crate::diagnostic::Result;
use crate::math::{Aabb, DVec3, Range, Ray, tolerance};
use crate::scene::Object;
use crate::value::Solid;

impl Solid for Probe {
    fn contains(&self, p: DVec3) -> bool {
        self.inside(p)
    }
}

/// A declared object that rays can hit.
#[derive(Debug)]
pub struct Probe(Geometry);

impl Probe {
    /// Lowers one object.
    ///
    /// # Errors
    /// If numbers are not finite or transforms singular, as for a whole scene.
    pub fn new(object: &Object) -> Result<Self> {
        Ok(Self(lower_alone(object)?))
    }

    /// Returns the first hit of a ray and the outward normal at the hit, of length 1; `None` without a hit and for a
    /// direction of length 0.
    pub fn hit_point_and_normal(&self, from: DVec3, direction: DVec3) -> Option<(DVec3, DVec3)> {
        let direction = direction.try_normalize()?;
        let ray = Ray { origin: from, dir: direction };
        let found = self.0.closest(&ray, Range { min: tolerance::SURFACE, max: f64::INFINITY }, |_| true)?;
        let surface = found.surface(&ray);
        Some((surface.point, surface.normal))
    }

    /// Returns a box around all surfaces; empty for an object without surfaces.
    pub fn bounds(&self) -> Aabb {
        self.0.items().map(|item| item.bounds()).fold(Aabb::EMPTY, Aabb::union)
    }

    /// True if the point is inside the object.
    pub fn inside(&self, p: DVec3) -> bool {
        let mut inside = false;
        self.0.visit_containing(p, &mut |_| inside = true);
        inside
    }
}
