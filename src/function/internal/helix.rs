//! Helical tubes: helices, the spiral and the torus with windings. Each is the distance, in the tube's cross section,
//! from a curve (A. Gray, "Modern Differential Geometry of Curves and Surfaces", 1993, "Helix"); the cross section is a
//! superellipse of exponent 2 / type (manual, "Cross Section Type").

use crate::math::fp;
use std::f64::consts::{PI, TAU};

/// Radius that a cross section of this type needs to contain the point (a, b): (|a|^p + |b|^p)^(1/p) with p = 2 / type.
/// Type 0 gives squares, 1 circles, 2 diamonds.
fn cross_section_radius_through(a: f64, b: f64, kind: f64) -> f64 {
    let (a, b) = (a.abs(), b.abs());
    match kind {
        0.0 => a.max(b),
        1.0 => (a * a + b * b).sqrt(),
        2.0 => a + b,
        _ => fp::pow(fp::pow(a, 2.0 / kind) + fp::pow(b, 2.0 / kind), kind / 2.0),
    }
}

/// Rotates the point (a, b) by an angle with this sine and cosine.
fn rotate_point(a: f64, b: f64, (sin, cos): (f64, f64)) -> (f64, f64) {
    (a * cos - b * sin, a * sin + b * cos)
}

/// Returns x minus the middle of the period that contains it; both may have any sign.
fn offset_from_period_middle(x: f64, period: f64) -> f64 {
    x - period * (x / period).floor() - period / 2.0
}

/// Internal function `f_helix1`: The tube's cross section is spanned by the distance from the cylinder of the major
/// radius, and by y. The distance never exceeds that to the cylinder's opposite side.
pub fn f_helix1([x, y, z, number, period, minor, major, shape, kind, degrees]: [f64; 10]) -> f64 {
    let q = (x * x + z * z).sqrt();
    let pitch = TAU / (number * period);
    let along = offset_from_period_middle(y - fp::atan2(-z, x) / period, pitch);
    let (a, b) = rotate_point(q - major, along / shape, fp::sin_cos(degrees.to_radians()));
    // `min` also drops NaN where there is no helix.
    cross_section_radius_through(a, b, kind).min(q + major) - minor
}

/// Internal function `f_helix2`: A cylinder whose horizontal cross section turns around the y axis together with its
/// centre.
pub fn f_helix2([x, y, z, _, period, minor, major, _, kind, _]: [f64; 10]) -> f64 {
    let (sin, cos) = fp::sin_cos(period * y);
    let (a, b) = rotate_point(x - major * cos, z - major * sin, (-sin, cos));
    cross_section_radius_through(a, b, kind) - minor
}

/// Internal function `f_spiral`: Around the y axis, in the plane y = 0: the spiral of Archimedes r = winding · angle /
/// 2π from the centre, cut by a sphere.
pub fn f_spiral([x, y, z, winding, thickness, radius, _, _, kind]: [f64; 9]) -> f64 {
    let around = x * x + z * z;
    let r = (around + y * y).sqrt();
    let from_spiral = around.sqrt() - winding * fp::atan2(z, -x).rem_euclid(TAU) / TAU;
    let across = (from_spiral + winding / 2.0) % winding - winding / 2.0;
    let tube = cross_section_radius_through(across, y, kind);
    let tube = if r < tube { r } else { tube } - thickness;
    tube.max(r - radius)
}

/// Internal function `f_helical_torus`: A torus of major radius P0; P1 windings around it that turn P2 times. P5 is the
/// radius of the windings' centres.
pub fn f_helical_torus(
    [x, y, z, major, loops, twist, fatness, threshold, minor, flatness, period, amplitude, phase]: [f64; 13],
) -> f64 {
    let q = (x * x + z * z).sqrt();
    let across = q - major;
    let from_circle = (across * across + y * y).sqrt();
    let azimuth = fp::atan2(x, z);

    // Angle around the tube to the next winding, and the distance from it.
    let turn = loops * azimuth + twist * fp::atan2(across, y);
    let away = turn - TAU * (turn / TAU).floor() - PI;
    let deep = from_circle - minor;
    let square = deep * deep + flatness * away * away;
    let axis = q + major - minor - threshold;
    if square.is_nan() || square < 0.0 {
        return axis;
    }
    let distance = square.sqrt().min(from_circle + minor);

    // Grooves surround the winding.
    let groove = if fatness == 0.0 {
        0.0
    } else {
        fatness * fp::cos(period * fp::atan2(amplitude * away, deep) + phase * azimuth)
    };
    (distance - threshold - groove).min(axis)
}
