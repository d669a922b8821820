//! Projections: from a position in the picture to a ray in the camera's own axes. One file a formula.

mod cylinder;
mod fisheye;
mod omnimax;
mod orthographic;
mod panoramic;
mod spherical;
mod ultra_wide_angle;

use super::MeshRays;
use crate::math::{DVec2, DVec3, Ray};
use serde::Serialize;
use std::sync::Arc;

/// Projection of a lowered camera. Each formula has a file of its own.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Projection {
    /// Camera rays from one point through a flat window.
    Perspective,
    /// The lecture's camera: a window at distance 1; a missing tangent follows from square pixels.
    Lecture {
        /// Tangent of half the horizontal angle of view.
        tan_x: Option<f64>,
        /// Tangent of half the vertical angle of view.
        tan_y: Option<f64>,
    },
    /// Parallel camera rays.
    Orthographic,
    /// Fisheye camera, with the angle of view of the whole disc, in radians.
    Fisheye(f64),
    /// Ultra wide angle camera, with the horizontal angle of view, in radians.
    UltraWideAngle(f64),
    /// Omnimax camera, a fisheye for domed screens.
    Omnimax,
    /// Panoramic camera.
    Panoramic,
    /// Cylindrical camera, with its type, 1 to 4, and the angle of view about the axis, in radians.
    Cylinder(u8, f64),
    /// Spherical camera, with the horizontal and vertical angles of view, in radians.
    Spherical(DVec2),
    /// Mesh camera: rays from the faces of meshes.
    Mesh(#[serde(skip)] Arc<MeshRays>),
}

impl Projection {
    /// True if each ray of the projection has its own origin.
    pub(super) fn has_origin_per_ray(&self) -> bool {
        matches!(self, Projection::Orthographic | Projection::Cylinder(3 | 4, _))
    }

    /// Returns the unit camera ray through a position of the picture, from -½ to ½ to the right and up, and the
    /// position for bumps; `None` where the projection has no ray, and for flat windows and faces. `axes` are the unit
    /// vectors right, up and ahead, `right_up_direction_lengths` are the width and height of the window and the length of the
    /// direction.
    pub(super) fn ray_and_bump_position(
        &self,
        picture_fraction_from_center: DVec2,
        origin: DVec3,
        axes: [DVec3; 3],
        right_up_direction_lengths: DVec3,
    ) -> Option<(Ray, DVec2)> {
        let local = match self {
            // These have a window or faces.
            Projection::Perspective | Projection::Lecture { .. } | Projection::Mesh(_) => return None,
            Projection::Orthographic => {
                orthographic::orthographic_ray(picture_fraction_from_center, right_up_direction_lengths)
            }
            Projection::Fisheye(angle) => {
                fisheye::fisheye_ray(picture_fraction_from_center, right_up_direction_lengths, *angle)?
            }
            Projection::UltraWideAngle(angle) => {
                ultra_wide_angle::ultra_wide_angle_ray(picture_fraction_from_center, right_up_direction_lengths, *angle)
            }
            Projection::Omnimax => omnimax::omnimax_ray(picture_fraction_from_center, right_up_direction_lengths)?,
            Projection::Panoramic => panoramic::panoramic_ray(picture_fraction_from_center, right_up_direction_lengths),
            Projection::Cylinder(kind, angle) => {
                cylinder::cylindrical_ray(*kind, picture_fraction_from_center, right_up_direction_lengths, *angle)
            }
            Projection::Spherical(angles) => {
                let (dir, bump_position) =
                    spherical::direction_and_bump_position(picture_fraction_from_center, *angles, axes);
                return Some((Ray::new(origin, dir.try_normalize()?), bump_position));
            }
        };
        let [right, up, ahead] = axes;
        let world = right * local.dir.x + up * local.dir.y + ahead * local.dir.z;
        let eye = origin + right * local.origin.x + up * local.origin.y;
        Some((Ray::new(eye, world.try_normalize()?), local.bump_position))
    }
}

/// Camera ray in the camera's own axes: right, up and ahead.
struct LocalRay {
    /// Origin of the camera ray along the axes right and up.
    origin: DVec2,
    /// Direction of the camera ray along right, up and ahead, of any length.
    dir: DVec3,
    /// Position at which the pattern of the camera's `normal` is evaluated.
    bump_position: DVec2,
}

impl LocalRay {
    /// Returns a camera ray that starts at the eye; its bumps are evaluated at `bump_position`.
    fn from_eye(dir: DVec3, bump_position: DVec2) -> Self {
        Self { origin: DVec2::ZERO, dir, bump_position }
    }
}
