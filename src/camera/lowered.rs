//! Lowered cameras: vectors in world space and angles in radians; no `look_at`, degrees or defaults.

use super::perspective::{Window, set_rays_through_window};
use super::{Bumps, Frame, Lens, MeshRays, Projection};
use crate::math::packet::{Numbers, PACKET, RayPacket};
use crate::math::{DVec2, DVec3, Ray};
use serde::Serialize;
use std::sync::Arc;

/// Lowered camera, from which the rays of a picture are generated.
#[derive(Clone, Debug, Serialize)]
pub struct LoweredCamera {
    /// Position and orientation of the lowered camera.
    pub frame: Frame,
    /// Projection of the lowered camera.
    pub projection: Projection,
    /// Lens of focal blur; `None` for a pinhole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lens: Option<Lens>,
    /// Perturbation of camera rays by a `normal`; `None` for a camera without `normal`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bumps: Option<Bumps>,
}

/// Generator of camera rays for a picture of a given size.
#[derive(Clone, Debug)]
pub struct View {
    rays: Rays,
    bumps: Option<Bumps>,
    /// Size of the picture in pixels.
    size: DVec2,
}

#[derive(Clone, Debug)]
enum Rays {
    /// Camera rays through a flat window.
    Window(Window),
    /// Camera rays of a curved projection.
    Bent(Box<Bent>),
    /// Camera rays from the faces of meshes.
    Faces(Arc<MeshRays>),
}

/// Camera projection that is not a flat window: curved or orthographic.
#[derive(Clone, Debug)]
struct Bent {
    projection: Projection,
    origin: DVec3,
    /// Unit vectors right, up and ahead of the camera.
    axes: [DVec3; 3],
    /// Width and height of the camera's window, and length of its direction.
    lengths: DVec3,
}

impl LoweredCamera {
    /// Returns the generator of camera rays for a picture of this size in pixels.
    pub fn view(&self, width: usize, height: usize) -> View {
        let frame = self.frame;
        let rays = match self.projection.clone() {
            Projection::Mesh(mesh) => Rays::Faces(mesh),
            Projection::Perspective => Rays::Window(Window::for_picture(&frame, width, height)),
            Projection::Lecture { tan_x, tan_y } => {
                Rays::Window(super::lecture::lecture_window(&frame, (tan_x, tan_y), width, height))
            }
            projection => {
                let (axes, lengths) = frame.unit_axes_and_lengths();
                Rays::Bent(Box::new(Bent { projection, origin: frame.origin, axes, lengths }))
            }
        };
        View { rays, bumps: self.bumps.clone(), size: DVec2::new(width as f64, height as f64) }
    }
}

impl View {
    /// Maximum number of a mesh camera's rays through a point of the picture; 1 for other cameras, also with focal blur.
    pub fn max_mesh_rays_per_point(&self) -> usize {
        if let Rays::Faces(mesh) = &self.rays { mesh.max_rays_per_point() } else { 1 }
    }

    /// Maximum distance of a hit along a camera ray, in world units.
    pub fn max_distance(&self) -> f64 {
        if let Rays::Faces(mesh) = &self.rays { mesh.max_distance() } else { f64::INFINITY }
    }

    /// Returns the unit camera ray through a point of the picture, in pixels from the top left corner; `None` where the
    /// camera has no ray.
    pub fn ray_at_pixel_position(&self, x: f64, y: f64) -> Option<Ray> {
        self.nth_ray_at_pixels(x, y, 0)
    }

    /// Returns camera ray `n` of the several through a point of the picture, in pixels; only a mesh camera has more
    /// than one. `None` where the camera has no ray.
    pub fn nth_ray_at_pixels(&self, x: f64, y: f64, n: usize) -> Option<Ray> {
        // -½ to ½, to the right and up
        let at = || DVec2::new(x / self.size.x - 0.5, 0.5 - y / self.size.y);
        let (ray, place) = match &self.rays {
            Rays::Window(window) if self.bumps.is_none() => return Some(window.ray_at_pixel_position(x, y)),
            Rays::Window(window) => (window.ray_at_pixel_position(x, y), at()),
            Rays::Bent(bent) => bent.projection.ray_and_bump_position(at(), bent.origin, bent.axes, bent.lengths)?,
            // quirk: mesh_camera_bumps
            Rays::Faces(mesh) => (mesh.ray_at_pixel_position(x, y, n, self.size)?, DVec2::ZERO),
        };
        Some(self.bumps.as_ref().map_or(ray, |bumps| bumps.perturb_ray(ray, place)))
    }

    /// Common origin of all camera rays; `None` if each ray has its own.
    pub fn common_origin(&self) -> Option<DVec3> {
        match &self.rays {
            Rays::Window(window) => Some(window.origin),
            Rays::Faces(_) => None,
            Rays::Bent(bent) if bent.projection.has_origin_per_ray() => None,
            Rays::Bent(bent) => Some(bent.origin),
        }
    }

    /// The flat window of a camera whose rays are not perturbed; `None` for any other camera.
    pub fn window_of_unperturbed_rays(&self) -> Option<&Window> {
        match &self.rays {
            Rays::Window(window) if self.bumps.is_none() => Some(window),
            _ => None,
        }
    }

    /// Stores the unit camera rays through the first `n` of some points of the picture, as [`Self::ray_at_pixel_position`] does for
    /// each, and returns those that exist, as bits.
    pub fn set_rays_at_pixel_positions(&self, x: &Numbers, y: &Numbers, n: usize, rays: &mut RayPacket) -> u32 {
        if let Some(window) = self.window_of_unperturbed_rays() {
            set_rays_through_window(window, x, y, rays);
            return (1 << n) - 1;
        }
        let mut existing = 0;
        for i in 0..n.min(PACKET) {
            if let Some(ray) = self.ray_at_pixel_position(x.0[i], y.0[i]) {
                rays.set_ray(i, &ray);
                existing |= 1 << i;
            }
        }
        existing
    }
}
