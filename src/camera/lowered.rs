//! Cameras as a ray needs them: vectors in world space and angles in radians; nothing to look at, no degrees, no defaults.

use super::perspective::Window;
use super::{Bumps, Lens, MeshRays, cylinder, fisheye, omnimax, orthographic, panoramic, spherical, ultra_wide_angle};
use crate::math::{DVec2, DVec3, Ray};
use serde::Serialize;
use std::sync::Arc;

/// A lowered camera.
#[derive(Clone, Debug, Serialize)]
pub struct LoweredCamera {
    /// Where it is and where it looks.
    pub frame: Frame,
    /// How it projects.
    pub projection: Projection,
    /// What blurs, if anything does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lens: Option<Lens>,
    /// What turns the rays as bumps turn a surface's normal, if anything does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bumps: Option<Bumps>,
}

/// The vectors of a camera, in world space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Frame {
    /// The eye.
    pub origin: DVec3,
    /// To the middle of the picture.
    pub direction: DVec3,
    /// Across the picture; its length is the picture's width.
    pub right: DVec3,
    /// Up the picture; its length is the picture's height.
    pub up: DVec3,
}

/// How a camera projects. Each has a file of its own with its formula.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Projection {
    /// Rays from one point through a window.
    Perspective,
    /// The lecture's window: half its sides at distance 1 are the tangents; of which one may follow from square pixels.
    Lecture {
        /// Of half the angle of view across.
        tan_x: Option<f64>,
        /// Of half the angle of view from top to bottom.
        tan_y: Option<f64>,
    },
    /// Parallel rays.
    Orthographic,
    /// All directions in a disc: see the file of this name. The angle is that of the whole disc.
    Fisheye(f64),
    /// See the file of this name. The angle is that from left to right.
    UltraWideAngle(f64),
    /// See the file of this name.
    Omnimax,
    /// See the file of this name.
    Panoramic,
    /// See the file of this name. The number is the type, 1 to 4; the angle is that across, or for types 2 and 4 that upright.
    Cylinder(u8, f64),
    /// See the file of this name. The angles are those across and upright.
    Spherical(DVec2),
    /// Rays from the faces of meshes.
    Mesh(#[serde(skip)] Arc<MeshRays>),
}

impl Frame {
    /// The unit vectors of right, up, ahead, and the lengths they had.
    pub fn axes(&self) -> ([DVec3; 3], DVec3) {
        let vectors = [self.right, self.up, self.direction];
        (vectors.map(DVec3::normalize_or_zero), DVec3::from_array(vectors.map(DVec3::length)))
    }
}

/// The rays of one picture of a size.
#[derive(Clone, Debug)]
pub struct View {
    rays: Rays,
    bumps: Option<Bumps>,
    /// The picture, in pixels.
    size: DVec2,
}

#[derive(Clone, Debug)]
enum Rays {
    /// Those of most cameras.
    Window(Window),
    /// Those of all others.
    Bent(Box<Bent>),
    /// Those from the faces of meshes.
    Faces(Arc<MeshRays>),
}

/// Rays that no flat window gives.
#[derive(Clone, Debug)]
struct Bent {
    projection: Projection,
    origin: DVec3,
    /// Unit vectors: right, up, ahead.
    axes: [DVec3; 3],
    /// Lengths: the picture's width and height, and that of the direction.
    lengths: DVec3,
}

impl LoweredCamera {
    /// The rays of a picture of so many pixels.
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
    /// How many rays a point of the picture may have.
    pub fn count(&self) -> usize {
        if let Rays::Faces(mesh) = &self.rays { mesh.count() } else { 1 }
    }

    /// How far the camera sees.
    pub fn reach(&self) -> f64 {
        if let Rays::Faces(mesh) = &self.rays { mesh.reach() } else { f64::INFINITY }
    }

    /// The unit ray through a point of the picture, in pixels from its top left corner; `None` where the camera sees nothing.
    pub fn ray(&self, x: f64, y: f64) -> Option<Ray> {
        self.ray_of(x, y, 0)
    }

    /// Of several rays, the one of that number.
    pub fn ray_of(&self, x: f64, y: f64, number: usize) -> Option<Ray> {
        // -½ to ½, to the right and up
        let at = || DVec2::new(x / self.size.x - 0.5, 0.5 - y / self.size.y);
        let (ray, place) = match &self.rays {
            Rays::Window(window) if self.bumps.is_none() => return Some(window.ray(x, y)),
            Rays::Window(window) => (window.ray(x, y), at()),
            Rays::Bent(bent) => bent.ray(at())?,
            // (All have the bumps of one place: measured on POV-Ray 3.7.)
            Rays::Faces(mesh) => (mesh.ray(x, y, number, self.size)?, DVec2::ZERO),
        };
        Some(self.bumps.as_ref().map_or(ray, |bumps| bumps.turn(ray, place)))
    }

    /// Where all rays begin; `None` if each begins elsewhere.
    pub fn origin(&self) -> Option<DVec3> {
        match &self.rays {
            Rays::Window(window) => Some(window.origin),
            Rays::Faces(_) => None,
            Rays::Bent(bent) if bent.moves() => None,
            Rays::Bent(bent) => Some(bent.origin),
        }
    }

    /// The flat window, of a camera that has one and no bumps.
    pub fn window(&self) -> Option<&Window> {
        match &self.rays {
            Rays::Window(window) if self.bumps.is_none() => Some(window),
            _ => None,
        }
    }
}

impl Bent {
    /// Does each ray begin elsewhere?
    fn moves(&self) -> bool {
        matches!(self.projection, Projection::Orthographic | Projection::Cylinder(3 | 4, _))
    }

    /// The ray through a place of the picture, from -½ to ½ to the right and up, and where bumps are asked.
    fn ray(&self, at: DVec2) -> Option<(Ray, DVec2)> {
        let lengths = self.lengths;
        let sight = match &self.projection {
            // (These have a window, or faces.)
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

/// What a projection makes of a place of the picture.
pub(super) struct LocalRay {
    /// Where the ray begins, along right and up.
    pub(super) origin: DVec2,
    /// Along right, up and ahead; of any length.
    pub(super) dir: DVec3,
    /// Where bumps are asked.
    pub(super) place: DVec2,
}

impl LocalRay {
    /// A ray that begins at the eye.
    pub(super) fn from_eye(dir: DVec3, place: DVec2) -> Self {
        Self { origin: DVec2::ZERO, dir, place }
    }
}
