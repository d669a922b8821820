//! Lowered cameras: vectors in world space and angles in radians; no `look_at`, degrees or defaults.

use super::perspective::Window;
use super::{Bumps, Lens, MeshRays, cylinder, fisheye, omnimax, orthographic, panoramic, spherical, ultra_wide_angle};
use crate::math::{DVec2, DVec3, Ray};
use serde::Serialize;
use std::sync::Arc;

/// A lowered camera.
#[derive(Clone, Debug, Serialize)]
pub struct LoweredCamera {
    /// Position and orientation.
    pub frame: Frame,
    /// Projection.
    pub projection: Projection,
    /// Lens of focal blur; `None` for a pinhole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lens: Option<Lens>,
    /// Perturbation of rays by a `normal`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bumps: Option<Bumps>,
}

/// Vectors of a camera, in world space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Frame {
    /// Position of the eye.
    pub origin: DVec3,
    /// From the eye to the centre of the window.
    pub direction: DVec3,
    /// Horizontal side of the window; its length is the width.
    pub right: DVec3,
    /// Vertical side of the window; its length is the height.
    pub up: DVec3,
}

/// Projection of a camera. Each formula has a file of its own.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Projection {
    /// Rays from one point through a window.
    Perspective,
    /// The lecture's window at distance 1; a missing tangent follows from square pixels.
    Lecture {
        /// Tangent of half the horizontal angle of view.
        tan_x: Option<f64>,
        /// Tangent of half the vertical angle of view.
        tan_y: Option<f64>,
    },
    /// Parallel rays.
    Orthographic,
    /// See `fisheye`; the angle of the whole disc.
    Fisheye(f64),
    /// See `ultra_wide_angle`; the horizontal angle.
    UltraWideAngle(f64),
    /// See `omnimax`.
    Omnimax,
    /// See `panoramic`.
    Panoramic,
    /// See `cylinder`; the type, 1 to 4, and the angle about the axis.
    Cylinder(u8, f64),
    /// See `spherical`; the horizontal and vertical angles.
    Spherical(DVec2),
    /// Rays from the faces of meshes.
    Mesh(#[serde(skip)] Arc<MeshRays>),
}

impl Frame {
    /// Returns the unit vectors right, up and ahead, and the lengths of the three vectors.
    pub fn axes(&self) -> ([DVec3; 3], DVec3) {
        let vectors = [self.right, self.up, self.direction];
        (vectors.map(DVec3::normalize_or_zero), DVec3::from_array(vectors.map(DVec3::length)))
    }
}

/// The rays of a picture of one size.
#[derive(Clone, Debug)]
pub struct View {
    rays: Rays,
    bumps: Option<Bumps>,
    /// Size of the picture in pixels.
    size: DVec2,
}

#[derive(Clone, Debug)]
enum Rays {
    /// Rays through a flat window.
    Window(Window),
    /// Rays of a curved projection, or with bumps.
    Bent(Box<Bent>),
    /// Rays from the faces of meshes.
    Faces(Arc<MeshRays>),
}

/// A projection that is not a flat window.
#[derive(Clone, Debug)]
struct Bent {
    projection: Projection,
    origin: DVec3,
    /// Unit vectors right, up and ahead.
    axes: [DVec3; 3],
    /// Lengths: width and height of the window, length of the direction.
    lengths: DVec3,
}

impl LoweredCamera {
    /// The rays of a picture of this size in pixels.
    pub fn view(&self, width: usize, height: usize) -> View {
        let frame = self.frame;
        let rays = match self.projection.clone() {
            Projection::Mesh(mesh) => Rays::Faces(mesh),
            Projection::Perspective => Rays::Window(Window::of(&frame, width, height)),
            Projection::Lecture { tan_x, tan_y } => {
                Rays::Window(super::lecture::window(&frame, (tan_x, tan_y), width, height))
            }
            projection => {
                let (axes, lengths) = frame.axes();
                Rays::Bent(Box::new(Bent { projection, origin: frame.origin, axes, lengths }))
            }
        };
        View { rays, bumps: self.bumps.clone(), size: DVec2::new(width as f64, height as f64) }
    }
}

impl View {
    /// Maximum number of rays through a point of the picture.
    pub fn count(&self) -> usize {
        if let Rays::Faces(mesh) = &self.rays { mesh.count() } else { 1 }
    }

    /// Maximum distance of a hit, in world units.
    pub fn reach(&self) -> f64 {
        if let Rays::Faces(mesh) = &self.rays { mesh.reach() } else { f64::INFINITY }
    }

    /// Returns the unit ray through a point of the picture, in pixels from the top left corner; `None` where the camera
    /// has no ray.
    pub fn ray(&self, x: f64, y: f64) -> Option<Ray> {
        self.ray_of(x, y, 0)
    }

    /// Returns ray `number` of several.
    pub fn ray_of(&self, x: f64, y: f64, number: usize) -> Option<Ray> {
        // -½ to ½, to the right and up
        let at = || DVec2::new(x / self.size.x - 0.5, 0.5 - y / self.size.y);
        let (ray, place) = match &self.rays {
            Rays::Window(window) if self.bumps.is_none() => return Some(window.ray(x, y)),
            Rays::Window(window) => (window.ray(x, y), at()),
            Rays::Bent(bent) => bent.ray(at())?,
            // quirk: mesh_camera_bumps
            Rays::Faces(mesh) => (mesh.ray(x, y, number, self.size)?, DVec2::ZERO),
        };
        Some(self.bumps.as_ref().map_or(ray, |bumps| bumps.turn(ray, place)))
    }

    /// Common origin of all rays; `None` if each ray has its own.
    pub fn origin(&self) -> Option<DVec3> {
        match &self.rays {
            Rays::Window(window) => Some(window.origin),
            Rays::Faces(_) => None,
            Rays::Bent(bent) if bent.moves() => None,
            Rays::Bent(bent) => Some(bent.origin),
        }
    }

    /// The flat window of a camera without bumps.
    pub fn window(&self) -> Option<&Window> {
        match &self.rays {
            Rays::Window(window) if self.bumps.is_none() => Some(window),
            _ => None,
        }
    }
}

impl Bent {
    /// True if each ray has its own origin.
    fn moves(&self) -> bool {
        matches!(self.projection, Projection::Orthographic | Projection::Cylinder(3 | 4, _))
    }

    /// Returns the ray through a position of the picture, from -½ to ½ to the right and up, and the position for bumps.
    fn ray(&self, at: DVec2) -> Option<(Ray, DVec2)> {
        let lengths = self.lengths;
        let sight = match &self.projection {
            // These have a window or faces.
            Projection::Perspective | Projection::Lecture { .. } | Projection::Mesh(_) => return None,
            Projection::Orthographic => orthographic::ray(at, lengths),
            Projection::Fisheye(angle) => fisheye::ray(at, lengths, *angle)?,
            Projection::UltraWideAngle(angle) => ultra_wide_angle::ray(at, lengths, *angle),
            Projection::Omnimax => omnimax::ray(at, lengths)?,
            Projection::Panoramic => panoramic::ray(at, lengths),
            Projection::Cylinder(kind, angle) => cylinder::ray(*kind, at, lengths, *angle),
            Projection::Spherical(angles) => {
                let (dir, place) = spherical::ray(at, *angles, self.axes);
                return Some((Ray::new(self.origin, dir.try_normalize()?), place));
            }
        };
        let LocalRay { origin, dir, place } = sight;
        let [right, up, ahead] = self.axes;
        let world = right * dir.x + up * dir.y + ahead * dir.z;
        Some((Ray::new(self.origin + right * origin.x + up * origin.y, world.try_normalize()?), place))
    }
}

/// A ray in the camera's own axes.
pub(super) struct LocalRay {
    /// Origin along right and up.
    pub(super) origin: DVec2,
    /// Direction along right, up and ahead, of any length.
    pub(super) dir: DVec3,
    /// Position for bumps.
    pub(super) place: DVec2,
}

impl LocalRay {
    /// A ray that starts at the eye.
    pub(super) fn from_eye(dir: DVec3, place: DVec2) -> Self {
        Self { origin: DVec2::ZERO, dir, place }
    }
}
