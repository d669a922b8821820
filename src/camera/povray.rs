//! POV-Ray's camera. The order of words does not matter (quirk: `camera_word_order`): `angle` sets the length of
//! `direction`, then `look_at` turns the camera, and transforms come last. Before `#version 3.5` each word takes effect
//! where it is written, see [`super::ordered`].

use super::{FocalBlur, MeshCamera, MeshRays};
use super::{Frame, LoweredCamera, Projection};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec2, DVec3, Transform, fp};
use crate::source::Span;
use crate::texture::{Normal, Pigment};
use crate::value::Reader;
use serde::Serialize;
use std::sync::Arc;

/// Camera of POV-Ray's language, as written in a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PovrayCamera {
    /// Projection of the camera.
    pub kind: Kind,
    /// Position of the camera's eye.
    pub location: DVec3,
    /// Vector from the camera's eye to the centre of its window.
    pub direction: DVec3,
    /// Horizontal side of the camera's window.
    pub right: DVec3,
    /// Vertical side of the camera's window.
    pub up: DVec3,
    /// Direction that `look_at` keeps upright.
    pub sky: DVec3,
    /// The point shown in the centre of the picture; `None` if it is not stated.
    pub look_at: Option<DVec3>,
    /// Horizontal angle of view in degrees; `None` for `angle 0`, too.
    pub angle: Option<f64>,
    /// True if `angle` is stated, even as 0.
    pub has_angle: bool,
    /// Vertical angle of view of a spherical camera, in degrees; `None` for half the horizontal angle.
    pub vertical_angle: Option<f64>,
    /// True if `right` or `up` is stated, which fixes the window of an orthographic camera.
    pub sized: bool,
    /// True if the words have taken effect in their order, so that `look_at` and `angle` are done.
    pub ordered: bool,
    /// Span of the camera's angle of view.
    pub angle_span: Span,
    /// Settings of the camera's focal blur.
    pub blur: FocalBlur,
    /// Meshes and settings of a mesh camera; `None` for other cameras.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<Arc<MeshCamera>>,
    /// Perturbation of camera rays by a `normal`; `None` for a camera without `normal`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal: Option<Arc<Normal>>,
    /// Pigment for the transmittance of a square lens, from `bokeh`; `None` for a disc.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bokeh: Option<Arc<Pigment>>,
    /// Transform of the whole camera, applied last.
    pub transform: Transform,
}

impl Default for PovrayCamera {
    fn default() -> Self {
        Self {
            kind: Kind::Perspective,
            location: DVec3::ZERO,
            direction: DVec3::Z,
            // quirk: camera_right_1_33
            right: DVec3::new(1.33, 0.0, 0.0),
            up: DVec3::Y,
            sky: DVec3::Y,
            look_at: None,
            angle: None,
            has_angle: false,
            vertical_angle: None,
            sized: false,
            ordered: false,
            angle_span: Span::NONE,
            blur: FocalBlur::default(),
            mesh: None,
            normal: None,
            bokeh: None,
            transform: Transform::IDENTITY,
        }
    }
}

/// Projection of POV-Ray's camera, by its word.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs)]
pub enum Kind {
    Perspective,
    Orthographic,
    Fisheye,
    UltraWideAngle,
    Omnimax,
    Panoramic,
    Cylinder(u8),
    Spherical,
    Mesh,
}

/// Default angle of view of curved projections, in degrees (quirk: `camera_default_angle`).
const USUAL_ANGLE: f64 = 90.0;

impl PovrayCamera {
    /// Reads a camera's angles of view after the word: `angle horizontal [vertical]`.
    pub(super) fn read_angle(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.angle_span = r.span();
        let angle = r.float()?;
        self.angle = (angle != 0.0).then_some(angle);
        self.has_angle = true;
        self.vertical_angle = r.optional_float()?;
        Ok(())
    }

    /// Reads the N of `cylinder N`, the type of a cylindrical camera, from 1 to 4.
    pub(super) fn read_cylinder_type(&mut self, r: &mut dyn Reader) -> Result<()> {
        let (at, number) = (r.span(), r.float()?);
        if !(1.0..5.0).contains(&number) {
            let message = format!("a `cylinder` camera has a type from 1 to 4, found {number}");
            let help = "1 and 3 turn about the axis that goes up, 2 and 4 about the one across; 3 and 4 move along it";
            return Err(Diagnostic::new(codes::BAD_CAMERA, at, message).help(help).into());
        }
        self.kind = Kind::Cylinder(number as u8);
        Ok(())
    }

    /// True if the camera projects through a flat window from one point.
    pub fn is_perspective(&self) -> bool {
        self.kind == Kind::Perspective
    }

    /// Checks the camera's angle, the lengths of its vectors, and that it does not look at its own location; `source`
    /// is the span of the block.
    ///
    /// # Errors
    /// A diagnostic at the first of these faults.
    pub(super) fn check_camera(&self, source: Span) -> Result<()> {
        let flat = matches!(self.kind, Kind::Perspective | Kind::Orthographic);
        if let Some(angle) = self.angle.filter(|a| flat && !(*a > 0.0 && *a < 180.0)) {
            let message = format!("a perspective camera's `angle` lies between 0 and 180 degrees, this is {angle}");
            return Diagnostic::err(codes::BAD_CAMERA, self.angle_span, message);
        }
        if let Some(angle) = self.angle.filter(|a| !a.is_finite() || *a < 0.0) {
            let message = format!("a camera's `angle` is a number of degrees above 0, this is {angle}");
            return Diagnostic::err(codes::BAD_CAMERA, self.angle_span, message);
        }
        let bad = |message: &str| Diagnostic::err(codes::BAD_CAMERA, source, message);
        if self.look_at == Some(self.location) {
            let message = "the camera looks at the place where it stands";
            let d = Diagnostic::new(codes::BAD_CAMERA, source, message);
            return d
                .help("`look_at` names what is in the middle of the picture: any other point than `location`")
                .into();
        }
        let vectors = [("direction", self.direction), ("right", self.right), ("up", self.up), ("sky", self.sky)];
        for (name, vector) in vectors {
            if vector == DVec3::ZERO {
                return bad(&format!("the camera's `{name}` is zero"));
            }
        }
        Ok(())
    }

    /// Lowers POV-Ray's camera.
    pub fn lower(&self) -> LoweredCamera {
        let frame = self.frame();
        let lens = self.blur.lower_lens(self.location);
        LoweredCamera { frame, projection: self.projection(&frame), lens, bumps: None }
    }

    /// Returns the camera's location and window in world space.
    pub(super) fn frame(&self) -> Frame {
        let mut camera = self.clone();
        if !self.ordered {
            camera.apply_angle();
            if self.has_angle || !self.sized {
                camera.scale_orthographic_window();
            }
            camera.apply_look_at();
        }
        camera.transform_location_and_axes(&self.transform);
        Frame { origin: camera.location, direction: camera.direction, right: camera.right, up: camera.up }
    }

    /// Sets the length of `direction` from the angle of view: tan(angle/2) = half the window's width / the length. Has
    /// an effect only on perspective and orthographic cameras with an `angle`.
    pub(super) fn apply_angle(&mut self) {
        let flat = matches!(self.kind, Kind::Perspective | Kind::Orthographic);
        if let Some(angle) = self.angle.filter(|_| flat) {
            let length = self.right.length() / 2.0 / fp::tan(angle.to_radians() / 2.0);
            self.direction = self.direction.normalize() * length;
        }
    }

    /// Scales `right` and `up` of an orthographic camera by the distance of `look_at`; has no effect on other cameras
    /// (quirk: `orthographic_window`).
    pub(super) fn scale_orthographic_window(&mut self) {
        if self.kind == Kind::Orthographic {
            let scale = self.look_at.unwrap_or(DVec3::Z).distance(self.location) / self.direction.length();
            (self.right, self.up) = (self.right * scale, self.up * scale);
        }
    }

    /// Turns the camera's direction, right and up towards `look_at`, if it is stated; keeps lengths and handedness.
    pub(super) fn apply_look_at(&mut self) {
        let Some(target) = self.look_at else { return };
        let Self { direction, right, up, .. } = *self;
        // quirk: camera_without_handedness
        let left_handed = up.cross(direction).dot(right) <= 0.0;
        let ahead = (target - self.location).normalize();
        let side = self.sky.normalize().cross(ahead);
        // If the camera looks along `sky`, the given `right` is level.
        let side = if side.length() < 1e-10 { right.normalize() } else { side.normalize() };
        let top = ahead.cross(side).normalize_or(up);
        let across = if left_handed { -side } else { side };
        self.direction = ahead * direction.length();
        self.right = across * right.length();
        self.up = top * up.length();
    }

    /// Transforms location, direction, right and up, but neither `sky` nor `look_at`.
    pub(super) fn transform_location_and_axes(&mut self, by: &Transform) {
        self.location = by.transform_point(self.location);
        self.direction = by.transform_vector(self.direction);
        self.right = by.transform_vector(self.right);
        self.up = by.transform_vector(self.up);
    }

    fn projection(&self, frame: &Frame) -> Projection {
        let angle = self.angle.unwrap_or(USUAL_ANGLE).to_radians();
        match self.kind {
            Kind::Perspective => Projection::Perspective,
            Kind::Orthographic => Projection::Orthographic,
            Kind::Fisheye => Projection::Fisheye(angle),
            Kind::UltraWideAngle => Projection::UltraWideAngle(angle),
            Kind::Omnimax => Projection::Omnimax,
            Kind::Panoramic => Projection::Panoramic,
            Kind::Cylinder(number) => Projection::Cylinder(number, angle),
            Kind::Spherical => {
                let across = self.angle.unwrap_or(360.0);
                let upright = self.vertical_angle.unwrap_or(across / 2.0);
                Projection::Spherical(DVec2::new(across.to_radians(), upright.to_radians()))
            }
            Kind::Mesh => self.mesh.as_ref().map_or(Projection::Perspective, |mesh| {
                Projection::Mesh(Arc::new(MeshRays::new(mesh, frame.origin, frame.direction)))
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::Window;

    fn window(camera: &PovrayCamera, width: usize, height: usize) -> Window {
        *camera.lower().view(width, height).window_of_unperturbed_rays().unwrap()
    }

    #[test]
    fn the_default_camera_looks_along_z() {
        let window = window(&PovrayCamera::default(), 4, 3);
        let ray = window.ray_at_pixel_position(2.0, 1.5);
        assert_eq!((ray.origin, ray.dir), (DVec3::ZERO, DVec3::Z));
        // The top left corner of the window is at (-1.33/2, 1/2, 1)
        let corner = DVec3::new(-0.665, 0.5, 1.0).normalize();
        assert!(window.ray_at_pixel_position(0.0, 0.0).dir.distance(corner) < 1e-15);
    }

    #[test]
    fn angle_is_that_of_the_whole_width() {
        let camera = PovrayCamera { angle: Some(90.0), ..PovrayCamera::default() };
        let window = window(&camera, 100, 75);
        let (left, right) =
            (window.ray_at_pixel_position(0.0, 37.5).dir, window.ray_at_pixel_position(100.0, 37.5).dir);
        assert!(left.dot(right).abs() < 1e-12);
    }

    #[test]
    fn look_at_keeps_the_horizon_level() {
        let camera = PovrayCamera {
            location: DVec3::new(1.0, 5.0, -7.0),
            look_at: Some(DVec3::new(0.0, 1.0, 0.0)),
            ..PovrayCamera::default()
        };
        let window = window(&camera, 64, 48);
        assert!(window.across.y.abs() < 1e-15);
        let middle = window.ray_at_pixel_position(32.0, 24.0).dir;
        assert!(middle.distance((DVec3::new(-1.0, -4.0, 7.0)).normalize()) < 1e-15);
    }

    #[test]
    fn focal_distance_is_euclidean() {
        // POV-Ray's planes z = 10 and z = 4 are sharp.
        let lens = |location, transform, focal_point| {
            let blur = FocalBlur { aperture: 1.0, samples: [0, 9], focal_point, ..FocalBlur::default() };
            PovrayCamera { location, transform, blur, ..PovrayCamera::default() }.lower().lens.unwrap()
        };
        for focal_point in [DVec3::new(6.0, 0.0, 8.0), DVec3::new(0.0, 0.0, -10.0)] {
            assert_eq!(lens(DVec3::ZERO, Transform::IDENTITY, focal_point).distance, 10.0);
        }
        let doubled = Transform::scale(DVec3::splat(2.0)).unwrap();
        assert_eq!(lens(DVec3::Z * -4.0, doubled, DVec3::Z * 8.0).distance, 12.0);
    }

    #[test]
    fn up_along_direction_mirrors() {
        // POV-Ray: `camera { location <0, 30, 0> up z right x look_at <0, 0, 0.0001> }`
        let across = |up| {
            let (location, right) = (DVec3::new(0.0, 30.0, 0.0), DVec3::X);
            let look_at = Some(DVec3::new(0.0, 0.0, 0.0001));
            window(&PovrayCamera { location, right, up, look_at, ..PovrayCamera::default() }, 1, 1).across
        };
        assert!(across(DVec3::Z).distance(-DVec3::X) < 1e-12);
        assert!(across(DVec3::Y).distance(DVec3::X) < 1e-12);
    }
}
