//! `perspective`: rays from one point through a flat window (manual, "Perspective"; lecture, "Generating rays").

use super::Frame;
use crate::math::packet::{Numbers, RayPacket, Vectors};
use crate::math::registers::wide_versions;
use crate::math::{DVec3, Lanes, Ray};
use serde::Serialize;

/// Camera rays through a flat window: from `origin` in the direction corner + x·across + y·down, with x and y in pixels
/// from the top left corner of the picture. In world space, not normalised.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Window {
    /// Position of the camera's eye.
    pub origin: DVec3,
    /// Direction from the eye to the top left corner of the window.
    pub corner: DVec3,
    /// Step of the ray's direction for one pixel to the right.
    pub across: DVec3,
    /// Step of the ray's direction for one pixel down.
    pub down: DVec3,
}

impl Window {
    /// Returns the window of a camera's frame for a picture of this size in pixels.
    pub(super) fn for_picture(frame: &Frame, width: usize, height: usize) -> Self {
        Self {
            origin: frame.origin,
            corner: frame.direction - frame.right * 0.5 + frame.up * 0.5,
            across: frame.right / width as f64,
            down: -frame.up / height as f64,
        }
    }

    /// Returns the unit camera ray through a point of the picture; the centre of pixel (i, j) is (i + ½, j + ½).
    pub fn ray_at_pixel_position(&self, x: f64, y: f64) -> Ray {
        let dir = self.corner + self.across * x + self.down * y;
        Ray::new(self.origin, dir.normalize())
    }
}

wide_versions! {
    /// Stores the rays through points of the picture, as [`Window::ray_at_pixel_position`] does for each.
    pub(super) fn set_rays_through_window(window: &Window, x: &Numbers, y: &Numbers, rays: &mut RayPacket) {
        let Window { origin, corner, across, down } = window;
        let dir = Vectors::splat(*corner) + Vectors::splat(*across) * *x + Vectors::splat(*down) * *y;
        let reciprocal = Lanes::splat(1.0) / dir.length_squared().sqrt();
        (rays.origin, rays.dir) = (Vectors::splat(*origin), dir * reciprocal);
    }
}
