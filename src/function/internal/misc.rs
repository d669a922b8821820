//! Blobs and ellipsoids of Gaussians, lattices, and single surfaces. The formulas follow the manual's words (constants
//! and signs; quirk: `internal_functions`).

use super::super::Interval;
use crate::math::fp;
use std::f64::consts::{PI, TAU};

/// Apothem of a hexagon of side 1: cos 30°.
const COS_30: f64 = 0.866_025_403_784_438_6;

/// Internal function `f_blob`: -s₁ (1 - k₁² d₁²)² - s₂ (1 - k₂² d₂²)²: the density of `blob` (manual, "Blob"), from
/// components at ±P0/2 on the x axis.
pub fn f_blob([x, y, z, distance, s1, k1, s2, k2]: [f64; 8]) -> f64 {
    let from_axis = y * y + z * z;
    let component = |u: f64, s: f64, k: f64| {
        let inside = 1.0 - k * k * (u * u + from_axis);
        if inside > 0.0 { s * inside * inside } else { 0.0 }
    };
    -component(x + 0.5 * distance, s1, k1) - component(x - 0.5 * distance, s2, k2)
}

/// Internal function `f_blob2`: t - s (exp(-k d₁²) + exp(-k d₂²)): J. Blinn's blobs, "A Generalization of Algebraic
/// Surface Drawing" (1982).
pub fn f_blob2([x, y, z, distance, k, s, t]: [f64; 7]) -> f64 {
    let (from_axis, u) = (y * y + z * z, x - distance);
    t - s * (fp::exp(-k * (x * x + from_axis)) + fp::exp(-k * (u * u + from_axis)))
}

/// Returns the quadratic forms of three ellipsoids around the x, y and z axes: 1 along their axis, e across.
fn ellipsoid_forms(x: f64, y: f64, z: f64, e: f64) -> [f64; 3] {
    let (x, y, z) = (x * x, y * y, z * z);
    [x + e * (y + z), y + e * (x + z), z + e * (x + y)]
}

/// Internal function `f_cross_ellipsoids`: t - s max exp(-k q) over the three ellipsoids q.
pub fn f_cross_ellipsoids([x, y, z, e, k, s, t]: [f64; 7]) -> f64 {
    let [a, b, c] = ellipsoid_forms(x, y, z, e).map(|q| -k * q);
    t - s * fp::exp(a.max(b).max(c))
}

/// Internal function `f_isect_ellipsoids`: t - s min exp(-k q) over the three ellipsoids q.
pub fn f_isect_ellipsoids([x, y, z, e, k, s, t]: [f64; 7]) -> f64 {
    let [a, b, c] = ellipsoid_forms(x, y, z, e).map(|q| -k * q);
    t - s * fp::exp(a.min(b).min(c))
}

/// Internal function `f_flange_cover`: t - s Σ exp(-k q) over the three ellipsoids q.
pub fn f_flange_cover([x, y, z, e, k, s, t]: [f64; 7]) -> f64 {
    t - s * ellipsoid_forms(x, y, z, e).map(|q| fp::exp(-k * q)).iter().sum::<f64>()
}

/// Internal function `f_spikes`: s (Σ exp(-k q) - w exp(-m r²)) over the three ellipsoids q.
pub fn f_spikes([x, y, z, e, k, s, m, w]: [f64; 8]) -> f64 {
    let sum: f64 = ellipsoid_forms(x, y, z, e).map(|q| fp::exp(-k * q)).iter().sum();
    s * (sum - w * fp::exp(-m * (x * x + y * y + z * z)))
}

/// Internal function `f_spikes_2d`: y - h cos(a x) cos(b z) exp(-c (x² + z²)).
pub fn f_spikes_2d([x, y, z, h, a, b, c]: [f64; 7]) -> f64 {
    y - h * fp::cos(a * x) * fp::cos(b * z) * fp::exp(-c * (x * x + z * z))
}

/// Internal function `f_comma`: A comma: a ball of radius s/2 and a horn along the half circle of radius 3s/4 above it,
/// of half the ball's size times cos(θ / 2), θ the angle around the y axis.
pub fn f_comma([x, y, z, s]: [f64; 4]) -> f64 {
    let x = if x == 0.0 && z == 0.0 { 1e-4 } else { x };
    let u = x - 0.5 * s;
    let head = (u * u + y * y + z * z).sqrt() - 0.5 * s;
    let v = x + 0.25 * s;
    let away = (v * v + z * z).sqrt() - 0.75 * s;
    let tail = (away * away + y * y).sqrt() - 0.5 * s * fp::cos(0.5 * fp::atan2(z, x));
    head.min(tail.max(-z))
}

/// Internal function `f_hex_x`: Hexagonal cylinders along z: the distance from the axis of the nearest, along the
/// hexagon's normals.
pub fn f_hex_x([x, y, _, _]: [f64; 4]) -> f64 {
    let fold = |u: f64, period: f64| (u - period * (u / period).round()).abs();
    let (x, y) = (fold(x, 2.0 * COS_30), fold(y, 3.0));
    let across = |x: f64, y: f64| x.max(0.5 * x + COS_30 * y);
    across(x, y).min(across(COS_30 - x, (1.5 - y).abs()))
}

/// Internal function `f_hex_y`: The distance in the plane from the nearest line of three families of parallels, 1.5
/// apart and turned by 60°.
pub fn f_hex_y([x, y, _, _]: [f64; 4]) -> f64 {
    let fold = |u: f64| (u - 1.5 * (u / 1.5).round()).abs();
    fold(y).min(fold(COS_30 * x + 0.5 * y)).min(fold(COS_30 * x - 0.5 * y))
}

/// Internal function `f_mesh1`: Woven threads: along z at multiples of P0, along x at multiples of P1, each a wave that
/// is high where its neighbours and the crossing threads are low. POV-Ray's result for negative distances is unknown.
pub fn f_mesh1([x, y, z, dx, dz, flat, amplitude, high]: [f64; 8]) -> f64 {
    let nearest = |across: f64, along: f64, side: f64, period: f64, sign: f64| {
        let first = (across / period).floor();
        let thread = |n: f64, height: f64| {
            let (u, v) = (flat * (across - n * period), high * (y - height));
            u * u + v * v
        };
        let wave = sign * amplitude * fp::cos(PI * (along / side + first));
        thread(first, wave).min(thread(first + 1.0, -wave))
    };
    let square = nearest(x, z, dz, dx, -1.0).min(nearest(z, x, dx, dz, 1.0));
    square.sqrt()
}

fn polynomial_from_constant(y: f64, [a, b, c, d, e]: [f64; 5]) -> f64 {
    a + y * (b + y * (c + y * (d + y * e)))
}

/// Internal function `f_poly4`: √(x² + z²) minus the polynomial in y, or minus -5 where the polynomial is less.
pub fn f_poly4([x, y, z, a, b, c, d, e]: [f64; 8]) -> f64 {
    (x * x + z * z).sqrt() - polynomial_from_constant(y, [a, b, c, d, e]).max(-5.0)
}

/// Internal function `f_polytubes`: The horizontal distance from the nearest of the tubes around the y axis, whose
/// distance from the axis is the polynomial; at most 10000. For a number with a fraction one of the gaps is wider.
pub fn f_polytubes([x, y, z, number, a, b, c, d, e]: [f64; 9]) -> f64 {
    if number.is_nan() || number < 1.0 {
        return 1e4;
    }
    let (step, last) = (TAU / number, number.floor() - 1.0);
    let (q, radius) = ((x * x + z * z).sqrt(), polynomial_from_constant(y, [a, b, c, d, e]));
    let from_tube = |away: f64| {
        let (across, half) = (q - radius.abs(), fp::sin(0.5 * away));
        across * across + 4.0 * q * radius.abs() * half * half
    };

    // The nearest tube precedes or follows the point; the first follows the last.
    let angle = if radius < 0.0 { fp::atan2(-x, -z) } else { fp::atan2(x, z) }.rem_euclid(TAU);
    let nearest = (angle / step).round().min(last) * step;
    from_tube(angle - nearest).min(from_tube(angle)).sqrt().min(1e4)
}

/// Internal function `f_quantum`: 1.2 - 1.6 (2 y² - x² - z²)² exp(-4 r / 3): the density of the 3d orbital of hydrogen
/// (e.g. D. Griffiths, "Introduction to Quantum Mechanics", 1995, table of wave functions), with 4/3 as POV-Ray writes
/// it.
pub fn f_quantum([x, y, z, _]: [f64; 4]) -> f64 {
    let (q, y2) = (x * x + z * z, y * y);
    let harmonic = 2.0 * y2 - q;
    1.2 - 1.6 * harmonic * harmonic * fp::exp(-1.333_333_32 * (q + y2).sqrt())
}

/// Bounds of the internal function [`f_poly4`] over a box of arguments.
pub fn poly4_bounds(i: &[Interval]) -> Interval {
    let &[x, y, z, a, b, c, d, e] = i else { return Interval::ALL };
    let radius = [d, c, b, a].iter().fold(e, |sum, k| sum * y + *k).map_increasing(|u| u.max(-5.0));
    let q = (x.square() + z.square()).map_increasing(|u| u.max(0.0).sqrt());
    q + -radius
}
