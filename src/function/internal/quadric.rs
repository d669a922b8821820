//! Distances from spheres, boxes and tori; angles. The zero sets are the surfaces of the manual; elsewhere the numbers
//! are distances (quirk: `internal_functions`).

use super::super::Interval;
use crate::math::fp;

/// Internal function `f_r`: √(x² + y² + z²).
pub fn f_r([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// Internal function `f_ph`: The angle from the y axis, from 0 to π, in radians; 0 in the origin (colatitude of
/// spherical coordinates).
pub fn f_ph([x, y, z]: [f64; 3]) -> f64 {
    let r = (x * x + y * y + z * z).sqrt();
    if r > 0.0 { fp::acos((y / r).clamp(-1.0, 1.0)) } else { 0.0 }
}

/// Internal function `f_th`: The angle around the y axis, in radians, 0 along z, π/2 along x.
pub fn f_th([x, _, z]: [f64; 3]) -> f64 {
    fp::atan2(x, z)
}

/// Internal function `f_sphere`: The distance from a sphere.
pub fn f_sphere([x, y, z, radius]: [f64; 4]) -> f64 {
    (x * x + y * y + z * z).sqrt() - radius
}

/// Internal function `f_ellipsoid`: √((a x)² + (b y)² + (c z)²), which is 1 on an ellipsoid of half axes 1/a, 1/b, 1/c.
pub fn f_ellipsoid([x, y, z, a, b, c]: [f64; 6]) -> f64 {
    let (x, y, z) = (a * x, b * y, c * z);
    (x * x + y * y + z * z).sqrt()
}

/// Internal function `f_torus`: The distance from the circle of the major radius around the y axis, less the minor
/// radius (Weisstein, MathWorld, "Torus").
pub fn f_torus([x, y, z, major, minor]: [f64; 5]) -> f64 {
    let across = (x * x + z * z).sqrt() - major;
    (across * across + y * y).sqrt() - minor
}

/// Internal function `f_rounded_box`: The distance from a box that is smaller by the radius, minus the radius, minus
/// 1e-6 as in POV-Ray. Inside the smaller box the number is constant.
pub fn f_rounded_box([x, y, z, radius, a, b, c]: [f64; 7]) -> f64 {
    let beyond = |u: f64, half: f64| (u.abs() - half + radius).max(0.0);
    let (x, y, z) = (beyond(x, a), beyond(y, b), beyond(z, c));
    (x * x + y * y + z * z).sqrt() - radius - 1e-6
}

/// Internal function `f_superellipsoid`: 1 - ((|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n))^(n/2): the superellipsoid of
/// A. Barr, "Superquadrics and Angle-Preserving Transformations" (IEEE CG&A, 1981), with the exponents of POV-Ray's
/// `superellipsoid`.
pub fn f_superellipsoid([x, y, z, e, n]: [f64; 5]) -> f64 {
    let around = fp::pow(x.abs(), 2.0 / e) + fp::pow(y.abs(), 2.0 / e);
    1.0 - fp::pow(fp::pow(around, e / n) + fp::pow(z.abs(), 2.0 / n), n / 2.0)
}

fn sqrt_bounds(a: Interval) -> Interval {
    a.map_increasing(|x| x.max(0.0).sqrt())
}

fn norm_bounds(a: &[Interval]) -> Interval {
    sqrt_bounds(a.iter().fold(Interval::point(0.0), |sum, x| sum + x.square()))
}

/// Bounds of the internal function [`f_r`] over a box of arguments.
pub fn r_bounds(a: &[Interval]) -> Interval {
    norm_bounds(a)
}

/// Bounds of the internal function [`f_sphere`] over a box of arguments.
pub fn sphere_bounds(a: &[Interval]) -> Interval {
    let [point @ .., radius] = a else { return Interval::ALL };
    norm_bounds(point) + -*radius
}

/// Bounds of the internal function [`f_ellipsoid`] over a box of arguments.
pub fn ellipsoid_bounds(i: &[Interval]) -> Interval {
    let &[x, y, z, a, b, c] = i else { return Interval::ALL };
    norm_bounds(&[a * x, b * y, c * z])
}

/// Upper bound of the gradient of the internal function [`f_ellipsoid`].
pub fn ellipsoid_max_gradient(inverse_half_axes: &[f64]) -> f64 {
    inverse_half_axes.iter().fold(0.0, |most, x| x.abs().max(most))
}

/// Bounds of the internal function [`f_torus`] over a box of arguments.
pub fn torus_bounds(a: &[Interval]) -> Interval {
    let &[x, y, z, major, minor] = a else { return Interval::ALL };
    norm_bounds(&[norm_bounds(&[x, z]) + -major, y]) + -minor
}

/// Bounds of the internal function [`f_rounded_box`] over a box of arguments.
pub fn rounded_box_bounds(i: &[Interval]) -> Interval {
    let &[x, y, z, radius, a, b, c] = i else { return Interval::ALL };
    let beyond = |u: Interval, half: Interval| (u.abs() + -half + radius).map_increasing(|u| u.max(0.0));
    norm_bounds(&[beyond(x, a), beyond(y, b), beyond(z, c)]) + -radius + Interval::point(-1e-6)
}

/// Bounds of the internal function [`f_superellipsoid`] over a box of arguments, for exponents that are one positive
/// number each.
pub fn superellipsoid_bounds(a: &[Interval]) -> Interval {
    let &[x, y, z, e, n] = a else { return Interval::ALL };
    if e.lo != e.hi || n.lo != n.hi || !(e.lo > 0.0 && n.lo > 0.0) {
        return Interval::ALL;
    }
    let (e, n) = (e.lo, n.lo);
    let power = |i: Interval, p: f64| i.map_increasing(|x| fp::pow(x.max(0.0), p));
    let around = power(x.abs(), 2.0 / e) + power(y.abs(), 2.0 / e);
    let sum = power(around, e / n) + power(z.abs(), 2.0 / n);
    Interval::point(1.0) + -power(sum, n / 2.0)
}
