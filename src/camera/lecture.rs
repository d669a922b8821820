//! The lecture's camera ("Generating rays"), right-handed: `camera { eye <..> center <..> up <..> fov_x 60 fov_y 45 }`.
//! An addition of durer. If one angle is left out, pixels are square.

use super::perspective::Window;
use super::{Frame, LoweredCamera, Projection};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec3, Transform, fp};
use crate::source::Span;
use crate::value::Reader;
use serde::Serialize;

/// The lecture's camera as written in a scene: `eye`, `center`, `up` and angles of view.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LectureCamera {
    /// Position of the camera's eye.
    pub eye: DVec3,
    /// The point shown in the centre of the picture.
    pub center: DVec3,
    /// Direction that points up in the picture.
    pub up: DVec3,
    /// Horizontal angle of view in degrees; `None` follows from `fov_y` and square pixels, and is 60 without `fov_y`.
    pub fov_x: Option<f64>,
    /// Vertical angle of view in degrees; `None` follows from `fov_x` and square pixels.
    pub fov_y: Option<f64>,
    /// Transform of the whole camera, applied last.
    pub transform: Transform,
}

impl Default for LectureCamera {
    fn default() -> Self {
        Self {
            eye: DVec3::ZERO,
            center: DVec3::NEG_Z,
            up: DVec3::Y,
            fov_x: None,
            fov_y: None,
            transform: Transform::IDENTITY,
        }
    }
}

impl LectureCamera {
    pub(super) fn check_camera(&self, source: Span) -> Result<()> {
        let bad = |message: &str| Diagnostic::err(codes::BAD_CAMERA, source, message);
        if self.eye == self.center {
            return bad("the camera's `eye` and `center` are the same point");
        }
        if self.up.cross(self.eye - self.center).length_squared() == 0.0 {
            return bad("the camera looks along its `up`, so that no side is up");
        }
        Ok(())
    }

    /// Lowers the lecture's camera: p(i, j) = eye + α·u + β·v − w.
    pub fn lower(&self) -> LoweredCamera {
        let w = (self.eye - self.center).normalize();
        let u = self.up.cross(w).normalize();
        let v = w.cross(u);
        let half = |angle: f64| fp::tan(angle.to_radians() / 2.0);
        let (tan_x, tan_y) = match (self.fov_x, self.fov_y) {
            (None, None) => (Some(half(60.0)), None),
            (x, y) => (x.map(half), y.map(half)),
        };
        let t = &self.transform;
        let frame = Frame {
            origin: t.transform_point(self.eye),
            direction: -t.transform_vector(w),
            right: t.transform_vector(u),
            up: t.transform_vector(v),
        };
        LoweredCamera { frame, projection: Projection::Lecture { tan_x, tan_y }, lens: None, bumps: None }
    }
}

/// Returns the window of a camera's frame of unit vectors at distance 1; the tangents are of half the angles of view,
/// and a missing one follows from square pixels.
pub(super) fn lecture_window(
    frame: &Frame,
    (tan_half_x, tan_half_y): (Option<f64>, Option<f64>),
    width: usize,
    height: usize,
) -> Window {
    let aspect = width as f64 / height as f64;
    let tan_half_x = tan_half_x.or(tan_half_y.map(|y| y * aspect)).unwrap_or(aspect);
    let tan_half_y = tan_half_y.unwrap_or(tan_half_x / aspect);
    let Frame { origin, direction, right: u, up: v } = *frame;
    Window {
        origin,
        corner: -u * tan_half_x + v * tan_half_y + direction,
        across: u * (2.0 * tan_half_x / width as f64),
        down: v * (-2.0 * tan_half_y / height as f64),
    }
}

/// Reads a camera's angle of view in degrees, between 0 and 180.
pub(super) fn read_field_of_view_degrees(word: &str, r: &mut dyn Reader) -> Result<f64> {
    let (at, angle) = (r.span(), r.float()?);
    if angle > 0.0 && angle < 180.0 {
        return Ok(angle);
    }
    let message = format!("`{word}` lies between 0 and 180 degrees, this is {angle}");
    Diagnostic::err(codes::BAD_CAMERA, at, message)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The lecture's formula, with pixel centres at (i + ½, j + ½).
    fn by_the_lecture(camera: &LectureCamera, i: usize, j: usize, width: f64, height: f64) -> DVec3 {
        let w = (camera.eye - camera.center).normalize();
        let u = camera.up.cross(w).normalize();
        let v = w.cross(u);
        let (fov_x, fov_y) = (camera.fov_x.unwrap().to_radians(), camera.fov_y.unwrap().to_radians());
        let alpha = fp::tan(fov_x / 2.0) * (i as f64 + 0.5 - width / 2.0) / (width / 2.0);
        let beta = fp::tan(fov_y / 2.0) * (height / 2.0 - (j as f64 + 0.5)) / (height / 2.0);
        (alpha * u + beta * v - w).normalize()
    }

    #[test]
    fn rays_are_the_lecture_s() {
        let camera = LectureCamera {
            eye: DVec3::new(3.0, 4.0, 5.0),
            center: DVec3::new(0.5, 0.0, -1.0),
            fov_x: Some(70.0),
            fov_y: Some(40.0),
            ..LectureCamera::default()
        };
        let view = camera.lower().view(64, 48);
        let window = view.window_of_unperturbed_rays().unwrap();
        for (i, j) in [(0, 0), (63, 47), (10, 30)] {
            let ray = window.ray_at_pixel_position(i as f64 + 0.5, j as f64 + 0.5);
            assert!(ray.dir.distance(by_the_lecture(&camera, i, j, 64.0, 48.0)) < 1e-14);
        }
    }

    #[test]
    fn one_angle_gives_square_pixels() {
        let camera = LectureCamera { fov_y: Some(50.0), ..LectureCamera::default() };
        let view = camera.lower().view(300, 100);
        let window = view.window_of_unperturbed_rays().unwrap();
        assert!((window.across.length() - window.down.length()).abs() < 1e-15);
    }
}
