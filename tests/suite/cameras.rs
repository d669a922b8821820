//! The rays of each camera in closed form: middle, edges, corners, poles (manual, "Types of Projection").

use durer::camera::{Kind, LectureCamera, PovrayCamera, View};
use durer::math::{DVec2, DVec3, Ray, fp};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_3};

const SIZE: (usize, usize) = (80, 60);

fn view(kind: Kind, angle: Option<f64>) -> View {
    let right = DVec3::X * 4.0 / 3.0;
    PovrayCamera { kind, angle, right, location: DVec3::new(1.0, 2.0, 3.0), ..PovrayCamera::default() }
        .lower()
        .view(SIZE.0, SIZE.1)
}

/// The ray through a position in the picture, from (0, 0) at the lower left to (1, 1).
fn at(view: &View, x: f64, y: f64) -> Option<Ray> {
    view.ray_at_pixel_position(x * SIZE.0 as f64, (1.0 - y) * SIZE.1 as f64)
}

#[track_caller]
fn looks(view: &View, (x, y): (f64, f64), along: DVec3) {
    let ray = at(view, x, y).unwrap();
    assert!(ray.dir.distance(along.normalize()) < 1e-12, "{} is not {}", ray.dir, along.normalize());
}

#[track_caller]
fn begins(view: &View, (x, y): (f64, f64), place: DVec3) {
    let ray = at(view, x, y).unwrap();
    assert!(ray.origin.distance(place) < 1e-12, "{}", ray.origin);
}

/// A direction at these angles to the right and upwards, in degrees.
fn globe(right: f64, up: f64) -> DVec3 {
    let ((sin_x, cos_x), (sin_y, cos_y)) = (fp::sin_cos(right.to_radians()), fp::sin_cos(up.to_radians()));
    DVec3::new(sin_x * cos_y, sin_y, cos_x * cos_y)
}

const KINDS: [Kind; 10] = [
    Kind::Perspective,
    Kind::Orthographic,
    Kind::Fisheye,
    Kind::UltraWideAngle,
    Kind::Panoramic,
    Kind::Cylinder(1),
    Kind::Cylinder(2),
    Kind::Cylinder(3),
    Kind::Cylinder(4),
    Kind::Spherical,
];

#[test]
fn central_rays_point_ahead_and_have_length_1() {
    for kind in KINDS {
        let view = view(kind, Some(100.0));
        looks(&view, (0.5, 0.5), DVec3::Z);
        begins(&view, (0.5, 0.5), DVec3::new(1.0, 2.0, 3.0));
        for (x, y) in [(0.1, 0.2), (0.5, 0.9), (0.8, 0.45)] {
            if let Some(ray) = at(&view, x, y) {
                assert!((ray.dir.length() - 1.0).abs() < 1e-12, "{kind:?}");
            }
        }
    }
}

#[test]
fn perspective() {
    let wide = view(Kind::Perspective, Some(90.0));
    looks(&wide, (0.0, 0.5), DVec3::new(-1.0, 0.0, 1.0));
    looks(&wide, (1.0, 1.0), DVec3::new(1.0, 0.75, 1.0));
    // without an angle: by right, up and direction alone
    looks(&view(Kind::Perspective, None), (0.0, 0.0), DVec3::new(-2.0 / 3.0, -0.5, 1.0));
}

#[test]
fn orthographic() {
    // the size of a perspective camera's field of view at the distance of `look_at`
    let camera = PovrayCamera {
        kind: Kind::Orthographic,
        angle: Some(90.0),
        right: DVec3::X * 4.0 / 3.0,
        location: DVec3::Z * -5.0,
        look_at: Some(DVec3::ZERO),
        ..PovrayCamera::default()
    };
    let view = camera.lower().view(SIZE.0, SIZE.1);
    for corner in [(0.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
        looks(&view, corner, DVec3::Z);
        begins(&view, corner, DVec3::new(10.0 * (corner.0 - 0.5), 7.5 * (corner.1 - 0.5), -5.0));
    }
}

#[test]
fn fisheye() {
    let half = view(Kind::Fisheye, Some(180.0));
    // The disc touches the upper and the lower side, where up has length 1.
    looks(&half, (0.5, 1.0), DVec3::Y);
    looks(&half, (0.5 + 0.375, 0.5), DVec3::X);
    looks(&half, (0.5, 0.75), globe(0.0, 45.0));
    assert!(at(&half, 0.0, 0.0).is_none() && at(&half, 0.01, 0.5).is_none());
    let all = view(Kind::Fisheye, Some(360.0));
    looks(&all, (0.5, 0.0), DVec3::NEG_Z);
}

#[test]
fn ultra_wide_angle() {
    let view = view(Kind::UltraWideAngle, Some(120.0));
    let (sin, cos) = fp::sin_cos(FRAC_PI_3);
    looks(&view, (1.0, 0.5), DVec3::new(sin, 0.0, cos));
    looks(&view, (0.0, 0.5), DVec3::new(-sin, 0.0, cos));
    // three quarters of the angle from bottom to top
    looks(&view, (0.5, 1.0), globe(0.0, 45.0));
}

#[test]
fn omnimax() {
    let view = view(Kind::Omnimax, None);
    // The upper edge is a quarter turn above the axis, the lowest row an eighth below it.
    let top = at(&view, 0.5, 1.0).unwrap().dir;
    assert!((fp::acos(top.z).to_degrees() - 90.0).abs() < 0.2 && top.y > 0.0, "{top}");
    let bottom = at(&view, 0.5, 1e-6).unwrap().dir;
    assert!((bottom.y + FRAC_1_SQRT_2).abs() < 1e-3 && (bottom.z - FRAC_1_SQRT_2).abs() < 1e-3, "{bottom}");
    assert!(at(&view, 0.0, 1.0).is_none());
}

#[test]
fn panoramic() {
    let view = view(Kind::Panoramic, None);
    looks(&view, (1.0, 0.5), DVec3::X);
    looks(&view, (0.0, 0.5), DVec3::NEG_X);
    looks(&view, (0.5, 0.75), DVec3::new(0.0, 1.0, 1.0));
    assert!(at(&view, 0.5, 1.0).unwrap().dir.y > 1.0 - 1e-12);
}

#[test]
fn cylinders() {
    let eye = DVec3::new(1.0, 2.0, 3.0);
    for (kind, moves) in [(1, false), (3, true)] {
        let view = view(Kind::Cylinder(kind), Some(180.0));
        looks(&view, (1.0, 0.5), DVec3::X);
        looks(&view, (0.75, 0.5), DVec3::new(1.0, 0.0, 1.0));
        looks(&view, (0.5, 1.0), if moves { DVec3::Z } else { DVec3::new(0.0, 0.5, 1.0) });
        begins(&view, (0.5, 1.0), if moves { eye + DVec3::Y * 0.5 } else { eye });
    }
    for (kind, moves) in [(2, false), (4, true)] {
        let view = view(Kind::Cylinder(kind), Some(180.0));
        looks(&view, (0.5, 1.0), DVec3::Y);
        looks(&view, (1.0, 0.5), if moves { DVec3::Z } else { DVec3::new(2.0 / 3.0, 0.0, 1.0) });
        begins(&view, (1.0, 0.5), if moves { eye + DVec3::X * 2.0 / 3.0 } else { eye });
    }
}

#[test]
fn spherical() {
    let all = view(Kind::Spherical, None);
    for (x, y) in [(0.25, 0.5), (0.75, 0.3), (1.0, 0.5), (0.6, 0.9)] {
        looks(&all, (x, y), globe(360.0 * (x - 0.5), 180.0 * (y - 0.5)));
    }
    looks(&all, (0.3, 1.0), DVec3::Y);
    looks(&all, (0.3, 0.0), DVec3::NEG_Y);
    // the vertical angle is half the horizontal one, unless it is given
    looks(&view(Kind::Spherical, Some(90.0)), (1.0, 1.0), globe(45.0, 22.5));
}

#[test]
fn lecture_camera() {
    let camera = LectureCamera {
        eye: DVec3::Z * 4.0,
        center: DVec3::ZERO,
        fov_x: Some(90.0),
        fov_y: Some(60.0),
        ..LectureCamera::default()
    };
    let view = camera.lower().view(SIZE.0, SIZE.1);
    looks(&view, (0.5, 0.5), DVec3::NEG_Z);
    looks(&view, (1.0, 0.5), DVec3::new(1.0, 0.0, -1.0));
    let half = DVec2::new(1.0, fp::tan(30_f64.to_radians()));
    looks(&view, (0.0, 0.0), DVec3::new(-half.x, -half.y, -1.0));
}
