//! Position and orientation of a camera.

use crate::math::DVec3;
use serde::Serialize;

/// Position, direction and window vectors of a camera, in world space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Frame {
    /// Position of the camera's eye.
    pub origin: DVec3,
    /// Vector from the camera's eye to the centre of its window.
    pub direction: DVec3,
    /// Horizontal side of the camera's window; its length is the width.
    pub right: DVec3,
    /// Vertical side of the camera's window; its length is the height.
    pub up: DVec3,
}

impl Frame {
    /// Returns the camera's unit vectors right, up and ahead, and the lengths of `right`, `up` and `direction`.
    pub fn unit_axes_and_lengths(&self) -> ([DVec3; 3], DVec3) {
        let vectors = [self.right, self.up, self.direction];
        (vectors.map(DVec3::normalize_or_zero), DVec3::from_array(vectors.map(DVec3::length)))
    }
}
