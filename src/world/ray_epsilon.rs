//! Minimum hit distances along rays.

use super::Geometry;
use crate::math::{Aabb, DVec3, tolerance};
use serde::Serialize;

/// Minimum hit distances, in world units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RayEpsilon {
    /// Minimum distance for camera, reflected and transmitted rays (quirk: `surface_min_distance`).
    pub surface: f64,
    /// Minimum distance for shadow rays, from both ends (quirk: `shadow_min_distance`).
    pub shadow: f64,
}

/// Size of a scene for which POV-Ray's absolute distances are suitable, in world units.
const USUAL: f64 = 10.0;

impl RayEpsilon {
    /// Minimum hit distances that POV-Ray uses in any scene.
    pub const POV_RAY: Self = Self { surface: tolerance::SURFACE, shadow: tolerance::SHADOW };

    /// Returns POV-Ray's minimum distances. A scene too small and too near to `eye` for these gets distances in
    /// proportion to its size.
    pub fn for_scene(geometry: &Geometry, eye: DVec3) -> Self {
        let mut all = Aabb::from_points([eye]);
        let boxes = geometry.items().map(|item| item.node().bounds()).filter(Aabb::is_finite);
        let mut sizes = boxes.map(|bounds| {
            all = all.union(bounds);
            all.size().length()
        });
        let Some(size) = sizes.try_fold(0.0, |_, size| (size < tolerance::SURFACE).then_some(size)) else {
            return Self::POV_RAY;
        };
        if size == 0.0 {
            return Self::POV_RAY;
        }
        let part = size / USUAL;
        Self { surface: tolerance::SURFACE * part, shadow: tolerance::SHADOW * part }
    }

    /// Returns a shape's minimum hit distance, reduced in proportion to the size of a tiny scene and unchanged in any
    /// other scene.
    pub fn reduced_for_tiny_scene(&self, min_distance: f64) -> f64 {
        min_distance * (self.surface / tolerance::SURFACE)
    }
}
