//! POV-Ray's perspective camera. The order of its words does not matter (measured on 3.7): all are collected, then
//! `angle` sets the length of `direction`, `look_at` turns everything, and transforms come last.

use super::Window;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec3, Transform, fp};
use crate::source::Span;
use crate::value::{RawItem, Reader};
use serde::Serialize;

/// As it was written.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Perspective {
    /// The eye.
    pub location: DVec3,
    /// From the eye to the middle of the window.
    pub direction: DVec3,
    /// Across the window.
    pub right: DVec3,
    /// Up the window.
    pub up: DVec3,
    /// Which way `look_at` keeps upright.
    pub sky: DVec3,
    /// The point in the middle of the picture.
    pub look_at: Option<DVec3>,
    /// Horizontal angle of view in degrees.
    pub angle: Option<f64>,
    /// Where the angle was written.
    pub angle_span: Span,
    /// Applied to all of it in the end.
    pub transform: Transform,
    /// What was said and is not drawn yet.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub undrawn: Vec<RawItem>,
}

impl Default for Perspective {
    fn default() -> Self {
        Self {
            location: DVec3::ZERO,
            direction: DVec3::Z,
            // POV-Ray's 1.33, which is not quite 4/3 (measured)
            right: DVec3::new(1.33, 0.0, 0.0),
            up: DVec3::Y,
            sky: DVec3::Y,
            look_at: None,
            angle: None,
            angle_span: Span::NONE,
            transform: Transform::IDENTITY,
            undrawn: vec![],
        }
    }
}

impl Perspective {
    /// `angle horizontal [vertical]`
    pub(super) fn read_angle(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.angle_span = r.span();
        let angle = r.float()?;
        self.angle = (angle != 0.0).then_some(angle);
        // The vertical angle of other kinds of cameras, which are not drawn yet.
        if let Some(vertical) = r.optional_float()? {
            let all = vec![angle, vertical];
            self.undrawn.push(RawItem::Block("angle", Box::new([RawItem::Numbers { width: 1, all }])));
        }
        Ok(())
    }

    pub(super) fn check(&self, source: Span) -> Result<()> {
        if let Some(angle) = self.angle.filter(|a| !(*a > 0.0 && *a < 180.0)) {
            let message = format!("a perspective camera's `angle` lies between 0 and 180 degrees, this is {angle}");
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

    /// The rays of a picture of this size.
    pub fn window(&self, width: usize, height: usize) -> Window {
        let (mut direction, mut right, mut up) = (self.direction, self.right, self.up);
        if let Some(angle) = self.angle {
            // half the window's width over the direction's length is the tangent of half the angle
            direction = direction.normalize() * (right.length() / 2.0 / fp::tan(angle.to_radians() / 2.0));
        }
        if let Some(target) = self.look_at {
            (direction, right, up) = self.turned(target, direction, right, up);
        }
        let t = &self.transform;
        let (direction, right, up) = (t.vector(direction), t.vector(right), t.vector(up));
        Window {
            origin: t.point(self.location),
            corner: direction - right * 0.5 + up * 0.5,
            across: right / width as f64,
            down: -up / height as f64,
        }
    }

    /// Direction, right and up turned towards `look_at`, their lengths and their handedness kept.
    fn turned(&self, target: DVec3, direction: DVec3, right: DVec3, up: DVec3) -> (DVec3, DVec3, DVec3) {
        // What has no handedness, as `up z` with the usual direction, counts as left-handed (measured on 3.7).
        let left_handed = up.cross(direction).dot(right) <= 0.0;
        let ahead = (target - self.location).normalize();
        let side = self.sky.normalize().cross(ahead);
        // Looking along `sky`, the given `right` tells what is level.
        let side = if side.length() < 1e-10 { right.normalize() } else { side.normalize() };
        let top = ahead.cross(side).normalize_or(up);
        let across = if left_handed { -side } else { side };
        (ahead * direction.length(), across * right.length(), top * up.length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_camera_looks_along_z() {
        let window = Perspective::default().window(4, 3);
        let ray = window.ray(2.0, 1.5);
        assert_eq!((ray.origin, ray.dir), (DVec3::ZERO, DVec3::Z));
        // the top left corner of the window lies at (-1.33/2, 1/2, 1)
        let corner = DVec3::new(-0.665, 0.5, 1.0).normalize();
        assert!(window.ray(0.0, 0.0).dir.distance(corner) < 1e-15);
    }

    #[test]
    fn angle_is_that_of_the_whole_width() {
        let camera = Perspective { angle: Some(90.0), ..Perspective::default() };
        let window = camera.window(100, 75);
        let (left, right) = (window.ray(0.0, 37.5).dir, window.ray(100.0, 37.5).dir);
        assert!(left.dot(right).abs() < 1e-12);
    }

    #[test]
    fn look_at_keeps_the_horizon_level() {
        let camera = Perspective {
            location: DVec3::new(1.0, 5.0, -7.0),
            look_at: Some(DVec3::new(0.0, 1.0, 0.0)),
            ..Perspective::default()
        };
        let window = camera.window(64, 48);
        assert!(window.across.y.abs() < 1e-15);
        let middle = window.ray(32.0, 24.0).dir;
        assert!(middle.distance((DVec3::new(-1.0, -4.0, 7.0)).normalize()) < 1e-15);
    }

    #[test]
    fn up_along_direction_mirrors() {
        // seen in POV-Ray 3.7: `camera { location <0, 30, 0> up z right x look_at <0, 0, 0.0001> }`
        let across = |up| {
            let (location, right) = (DVec3::new(0.0, 30.0, 0.0), DVec3::X);
            let look_at = Some(DVec3::new(0.0, 0.0, 0.0001));
            Perspective { location, right, up, look_at, ..Perspective::default() }.window(1, 1).across
        };
        assert!(across(DVec3::Z).distance(-DVec3::X) < 1e-12);
        assert!(across(DVec3::Y).distance(DVec3::X) < 1e-12);
    }
}
