//! How near to where a ray begins surfaces are not met.

use super::Geometry;
use crate::math::{Aabb, DVec3, tolerance};
use serde::Serialize;

/// In units of the world.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RayEpsilon {
    /// By rays that look.
    pub surface: f64,
    /// By those to lights, at both of their ends.
    pub shadow: f64,
}

/// A usual scene is as large as this, in which tolerances are as they were measured.
const USUAL: f64 = 10.0;

impl RayEpsilon {
    /// As in POV-Ray 3.7.
    pub const MEASURED: Self = Self { surface: tolerance::SURFACE, shadow: tolerance::SHADOW };

    /// The measured one; but where all that has an end lies so near to the eye that none of it would be seen (POV-Ray shows nothing then),
    /// that of the same scene in a usual size.
    pub fn of(geometry: &Geometry, eye: DVec3) -> Self {
        let mut all = Aabb::from_points([eye]);
        let boxes = geometry.items().map(|item| item.node().bounds()).filter(Aabb::is_finite);
        let mut sizes = boxes.map(|bounds| {
            all = all.union(bounds);
            all.size().length()
        });
        let Some(size) = sizes.try_fold(0.0, |_, size| (size < tolerance::SURFACE).then_some(size)) else {
            return Self::MEASURED;
        };
        if size == 0.0 {
            return Self::MEASURED;
        }
        let part = size / USUAL;
        Self { surface: tolerance::SURFACE * part, shadow: tolerance::SHADOW * part }
    }

    /// What an object's own least distance is in this world.
    pub fn own(&self, least: f64) -> f64 {
        least * (self.surface / tolerance::SURFACE)
    }
}
