//! Algebraic surfaces: a polynomial, times the field strength, clamped to ±10. The surfaces are classical; unless noted
//! otherwise the equation is MathWorld's under that name (signs and parameters; quirk: `internal_functions`).

use super::scale_and_clamp_field;
use std::f64::consts::SQRT_2;

/// Internal function `f_bicorn`: `strength` times the right minus the left side of (x² + 2 a y - a²)² = y² (a² - x²),
/// the bicorn, swept around y.
pub fn f_bicorn([x, y, z, strength, a]: [f64; 5]) -> f64 {
    let (q, a2) = (x * x + z * z, a * a);
    let s = q + 2.0 * a * y - a2;
    scale_and_clamp_field(strength, y * y * (a2 - q) - s * s)
}

/// Internal function `f_bifolia`: `strength` times the right minus the left side of (x² + y²)² = a x² y, the bifolium,
/// swept around y.
pub fn f_bifolia([x, y, z, strength, a]: [f64; 5]) -> f64 {
    let q = x * x + z * z;
    let s = q + y * y;
    scale_and_clamp_field(strength, a * y * q - s * s)
}

/// Internal function `f_boy_surface`: Boy's surface as the sextic of F. Apéry, "Models of the Real Projective Plane"
/// (1987). The scale only multiplies.
pub fn f_boy_surface([x, y, z, strength, scale]: [f64; 5]) -> f64 {
    let (q, z2, w) = (x * x + y * y, z * z, 1.0 - z);
    let first = 64.0 * w * w * w * z2 * z - 48.0 * w * w * z2 * (3.0 * q + 2.0 * z2);
    let bracket = 27.0 * q * q - 24.0 * z2 * q + 36.0 * SQRT_2 * y * z * (y * y - 3.0 * x * x) + 4.0 * z2 * z2;
    let last = -81.0 * q * q - 72.0 * z2 * q + 108.0 * SQRT_2 * x * z * (x * x - 3.0 * y * y) + 4.0 * z2 * z2;
    scale_and_clamp_field(strength, scale * (first + 12.0 * w * z * bracket + (9.0 * q - 2.0 * z2) * last))
}

/// Internal function `f_crossed_trough`: `strength` times the right minus the left side of y = x² z².
pub fn f_crossed_trough([x, y, z, strength]: [f64; 4]) -> f64 {
    scale_and_clamp_field(strength, x * x * z * z - y)
}

/// Internal function `f_cubic_saddle`: `strength` times the left minus the right side of z = x³ - y³.
pub fn f_cubic_saddle([x, y, z, strength]: [f64; 4]) -> f64 {
    scale_and_clamp_field(strength, y * y * y - x * x * x + z)
}

/// Internal function `f_cushion`: `strength` times the left side of
/// x² z² - z⁴ - 2 x² z + 2 z³ + x² - z² - (x² - z)² - y⁴ - 2 x² y² - y² z² + 2 y² z + y² = 0, the cushion.
pub fn f_cushion([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, y2, z2) = (x * x, y * y, z * z);
    let planar = x2 * z2 - z2 * z2 - 2.0 * x2 * z + 2.0 * z2 * z + x2 - z2 - (x2 - z) * (x2 - z);
    scale_and_clamp_field(strength, planar - y2 * (y2 + 2.0 * x2 + z2 - 2.0 * z - 1.0))
}

/// Internal function `f_devils_curve`: `strength` times the left minus the right side of
/// y⁴ - y² / 4 = (x² + z²)² - 0.36 x², after the devil's curve.
pub fn f_devils_curve([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, y2) = (x * x, y * y);
    let q = x2 + z * z;
    scale_and_clamp_field(strength, y2 * y2 - 0.25 * y2 - q * q + 0.36 * x2)
}

/// Internal function `f_dupin_cyclid`: The inversion of a torus, displaced by d and e, in a sphere of radius k: Dupin's
/// cyclide. With s = x² + y² + z² it is s² times [`f_torus2`] at k² p / s - (d, ∓e, 0), where e has the opposite sign
/// in one of the terms.
pub fn f_dupin_cyclid([x, y, z, strength, major, minor, d, e, radius]: [f64; 9]) -> f64 {
    let (k, s) = (radius * radius, x * x + y * y + z * z);
    let square = k * k - 2.0 * k * (d * x + e * y) + (d * d + e * e) * s;
    let (u, v, w) = (k * x - d * s, k * y + e * s, k * z);
    let (sum, difference) = (major * major + minor * minor, major * major - minor * minor);
    let rest = 2.0 * sum * (u * u + w * w) - 2.0 * difference * v * v - difference * difference * s * s;
    scale_and_clamp_field(strength, rest - square * square)
}

/// Internal function `f_enneper`: `strength` times the right minus the left side of
/// ((y² - x²) / 2z + 2 z² / 9)³ = 6 ((y² - x²) / 4z)²: Enneper's surface (A. Gray, 1993, "Enneper's Surface") without
/// its constants; a z below 0.2 in absolute value is replaced by 0.2 in the denominators.
pub fn f_enneper([x, y, z, strength]: [f64; 4]) -> f64 {
    let w = if z.abs() < 0.2 { 0.2 } else { z };
    let a = (y * y - x * x) / (2.0 * w);
    let b = a + 2.0 * z * z / 9.0;
    scale_and_clamp_field(strength, 1.5 * a * a - b * b * b)
}

/// Internal function `f_folium_surface`: `strength` times the left side of
/// (y² + z²) (1 + (b - 4 a) x) + (1 + b) x² = 0.
pub fn f_folium_surface([x, y, z, strength, a, b]: [f64; 6]) -> f64 {
    scale_and_clamp_field(strength, (y * y + z * z) * (1.0 + (b - 4.0 * a) * x) + (1.0 + b) * x * x)
}

/// Internal function `f_glob`: `strength` times the right minus the left side of y² + z² = (x⁵ + x⁴) / 2.
pub fn f_glob([x, y, z, strength]: [f64; 4]) -> f64 {
    let x2 = x * x;
    scale_and_clamp_field(strength, 0.5 * x2 * x2 * (x + 1.0) - y * y - z * z)
}

/// Internal function `f_heart`: `strength` times the right minus the left side of
/// (2 x² + y² + z² - 1)³ = (x² / 10 + y²) z³, the heart surface of G. Taubin (1993).
pub fn f_heart([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, y2, z2) = (x * x, y * y, z * z);
    let s = 2.0 * x2 + y2 + z2 - 1.0;
    scale_and_clamp_field(strength, (0.1 * x2 + y2) * z2 * z - s * s * s)
}

/// Internal function `f_hunt_surface`: `-strength` times the left side of
/// 4 (x² + y² + z² - 13)³ + 27 (3 x² + y² - 4 z² - 12)² = 0, Hunt's surface.
pub fn f_hunt_surface([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, y2, z2) = (x * x, y * y, z * z);
    let (a, b) = (x2 + y2 + z2 - 13.0, 3.0 * x2 + y2 - 4.0 * z2 - 12.0);
    scale_and_clamp_field(strength, -4.0 * a * a * a - 27.0 * b * b)
}

/// Internal function `f_hyperbolic_torus`: [`f_torus2`] with -z² instead of z².
pub fn f_hyperbolic_torus([x, y, z, strength, major, minor]: [f64; 6]) -> f64 {
    scale_and_clamp_field(strength, torus_polynomial(x * x - z * z, y * y, 2.0, major, minor))
}

/// Internal function `f_parabolic_torus`: [`f_torus2`] with -z instead of z², and half the linear terms.
pub fn f_parabolic_torus([x, y, z, strength, major, minor]: [f64; 6]) -> f64 {
    scale_and_clamp_field(strength, torus_polynomial(x * x - z, y * y, 1.0, major, minor))
}

/// Internal function `f_torus2`: `strength` times the right minus the left side of
/// (x² + y² + z² + R² - r²)² = 4 R² (x² + z²), the torus around y.
pub fn f_torus2([x, y, z, strength, major, minor]: [f64; 6]) -> f64 {
    scale_and_clamp_field(strength, torus_polynomial(x * x + z * z, y * y, 2.0, major, minor))
}

/// Polynomial that the functions of tori share: -(q + y²)² + w (R² + r²) q - w (R² - r²) y² - (R² - r²)².
fn torus_polynomial(q: f64, y2: f64, weight: f64, major: f64, minor: f64) -> f64 {
    let (sum, difference) = (major * major + minor * minor, major * major - minor * minor);
    let s = q + y2;
    weight * (sum * q - difference * y2) - s * s - difference * difference
}

/// Internal function `f_kampyle_of_eudoxus`: `strength` times the right minus the left side of
/// y² + z² = b² (x⁴ - a² x²), the kampyle of Eudoxus, swept around x.
pub fn f_kampyle_of_eudoxus([x, y, z, strength, a, b]: [f64; 6]) -> f64 {
    let x2 = x * x;
    scale_and_clamp_field(strength, b * b * x2 * (x2 - a * a) - y * y - z * z)
}

/// Internal function `f_klein_bottle`: `-strength` times the left side of
/// (s + 2 y - 1) ((s - 2 y - 1)² - 8 z²) + 16 x z (s - 2 y - 1) = 0 with s = x² + y² + z², the Klein bottle.
pub fn f_klein_bottle([x, y, z, strength]: [f64; 4]) -> f64 {
    let s = x * x + y * y + z * z;
    let q = s - 2.0 * y - 1.0;
    scale_and_clamp_field(-strength, (s + 2.0 * y - 1.0) * (q * q - 8.0 * z * z) + 16.0 * x * z * q)
}

/// Internal function `f_kummer_surface_v1`: `strength` times the right minus the left side of
/// x⁴ + y⁴ + z⁴ + 1 = x² + y² + z² + x² y² + y² z² + z² x², Kummer's surface.
pub fn f_kummer_surface_v1([x, y, z, strength]: [f64; 4]) -> f64 {
    scale_and_clamp_field(-strength, kummer_quartic([x, y, z], [-1.0, -1.0, 0.0]) + 1.0)
}

fn kummer_quartic([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> f64 {
    let (x2, y2, z2) = (x * x, y * y, z * z);
    x2 * (x2 + a + b * y2) + y2 * (y2 + a + b * z2) + z2 * (z2 + a + b * x2) + c * x * y * z
}

/// Internal function `f_kummer_surface_v2`: `strength` times the right minus the left side of
/// x⁴ + y⁴ + z⁴ + a (x² + y² + z²) + b (x² y² + y² z² + z² x²) + c x y z = 1.
pub fn f_kummer_surface_v2([x, y, z, strength, a, b, c]: [f64; 7]) -> f64 {
    scale_and_clamp_field(-strength, kummer_quartic([x, y, z], [a, b, c]) - 1.0)
}

/// Internal function `f_lemniscate_of_gerono`: `strength` times the right minus the left side of y² + z² = x² - x⁴, the
/// lemniscate of Gerono, swept around x.
pub fn f_lemniscate_of_gerono([x, y, z, strength]: [f64; 4]) -> f64 {
    let x2 = x * x;
    scale_and_clamp_field(strength, x2 - x2 * x2 - y * y - z * z)
}

/// Internal function `f_mitre`: `strength` times the right minus the left side of
/// 4 x² (x² + y² + z²) = y² (1 - y² - z²), the mitre.
pub fn f_mitre([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, y2, z2) = (x * x, y * y, z * z);
    scale_and_clamp_field(strength, y2 * (1.0 - y2 - z2) - 4.0 * x2 * (x2 + y2 + z2))
}

/// Internal function `f_nodal_cubic`: `strength` times the right minus the left side of y³ + z³ = 6 y z, the folium of
/// Descartes.
pub fn f_nodal_cubic([_, y, z, strength]: [f64; 4]) -> f64 {
    scale_and_clamp_field(strength, 6.0 * y * z - y * y * y - z * z * z)
}

/// Internal function `f_ovals_of_cassini`: `strength` times the right minus the left side of
/// (x² + y² + z² + a²)² = d a² (x² + z²) + c², the ovals of Cassini, swept around y.
pub fn f_ovals_of_cassini([x, y, z, strength, a, c, d]: [f64; 7]) -> f64 {
    let (q, a2) = (x * x + z * z, a * a);
    let s = q + y * y + a2;
    scale_and_clamp_field(strength, d * a2 * q + c * c - s * s)
}

/// Internal function `f_paraboloid`: `strength` times the left minus the right side of y = x² + z².
pub fn f_paraboloid([x, y, z, strength]: [f64; 4]) -> f64 {
    scale_and_clamp_field(strength, y - x * x - z * z)
}

/// Internal function `f_pillow`: `strength` times the left minus the right side of x⁴ + y⁴ + z⁴ = x² + y² + z².
pub fn f_pillow([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, y2, z2) = (x * x, y * y, z * z);
    scale_and_clamp_field(strength, x2 * (x2 - 1.0) + y2 * (y2 - 1.0) + z2 * (z2 - 1.0))
}

/// Internal function `f_piriform`: `strength` times the left minus the right side of y² + z² = x³ - x⁴, the piriform,
/// swept around x.
pub fn f_piriform([x, y, z, strength]: [f64; 4]) -> f64 {
    scale_and_clamp_field(strength, x * x * x * (x - 1.0) + y * y + z * z)
}

/// Internal function `f_quartic_paraboloid`: `strength` times the left minus the right side of y = x⁴ + z⁴.
pub fn f_quartic_paraboloid([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, z2) = (x * x, z * z);
    scale_and_clamp_field(strength, y - x2 * x2 - z2 * z2)
}

/// Internal function `f_quartic_saddle`: `strength` times the left minus the right side of y = x⁴ - z⁴.
pub fn f_quartic_saddle([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, z2) = (x * x, z * z);
    scale_and_clamp_field(strength, y - x2 * x2 + z2 * z2)
}

/// Internal function `f_quartic_cylinder`: `strength` times the right minus the left side of
/// (x² + z²) (y² + b²) = a² b².
pub fn f_quartic_cylinder([x, y, z, strength, a, b]: [f64; 6]) -> f64 {
    let (q, b2) = (x * x + z * z, b * b);
    scale_and_clamp_field(strength, b2 * (a * a - q) - y * y * q)
}

/// Internal function `f_steiners_roman`: `-strength` times the left side of x² y² + y² z² + z² x² + x y z = 0,
/// Steiner's Roman surface.
pub fn f_steiners_roman([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, y2, z2) = (x * x, y * y, z * z);
    scale_and_clamp_field(-strength, x2 * y2 + y2 * z2 + z2 * x2 + x * y * z)
}

/// Internal function `f_strophoid`: `strength` times the right minus the left side of
/// (b - x) (y² + z²) = c² x² (x + a), the strophoid, swept around x.
pub fn f_strophoid([x, y, z, strength, a, b, c]: [f64; 7]) -> f64 {
    scale_and_clamp_field(strength, (x - b) * (y * y + z * z) + c * c * x * x * (x + a))
}

/// Internal function `f_torus_gumdrop`: `-strength` times the left side of
/// 4 (x⁴ + (y² + z²)²) + 17 x² (y² + z²) - 20 (x² + y² + z²) + 17 = 0.
pub fn f_torus_gumdrop([x, y, z, strength]: [f64; 4]) -> f64 {
    let (x2, q) = (x * x, y * y + z * z);
    scale_and_clamp_field(-strength, 4.0 * (x2 * x2 + q * q) + 17.0 * x2 * q - 20.0 * (x2 + q) + 17.0)
}

/// Internal function `f_umbrella`: `strength` times the right minus the left side of x² = y z², Whitney's umbrella.
pub fn f_umbrella([x, y, z, strength]: [f64; 4]) -> f64 {
    scale_and_clamp_field(strength, y * z * z - x * x)
}

/// Internal function `f_witch_of_agnesi`: `strength` times the right minus the left side of y (x² + z² + a) = a, the
/// witch of Agnesi, swept around y.
pub fn f_witch_of_agnesi([x, y, z, strength, a]: [f64; 5]) -> f64 {
    scale_and_clamp_field(strength, a * (1.0 - y) - y * (x * x + z * z))
}
