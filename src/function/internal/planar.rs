//! Plane curves, extruded along z or swept around the y axis (manual, "SOR Switch", "SOR Offset", "SOR Angle"): the
//! `…_2d` functions and the four algebraic cylinders. Sources: J. D. Lawrence, "A Catalog of Special Plane Curves"
//! (1972) and MathWorld under the curve's name (weights of the parameters; quirk: `internal_functions`).

use super::{clamp_symmetrically, scale_and_clamp_field};
use crate::math::fp;

/// Maps a point to the plane of a curve that is extruded or swept. For a swept curve, x is the distance from the y axis
/// minus the offset, and the point is rotated by the angle.
fn curve_plane_point([x, y, z]: [f64; 3], [switch, offset, degrees]: [f64; 3]) -> (f64, f64) {
    if switch > 0.0 {
        let u = (x * x + z * z).sqrt() - offset;
        let (sin, cos) = fp::sin_cos(degrees.to_radians());
        (u * cos - y * sin, u * sin + y * cos)
    } else {
        (x, y)
    }
}

/// Internal function `f_algbr_cyl1`: `strength` times the left minus the right side of y² = x² - |x|³, a figure of
/// eight.
pub fn f_algbr_cyl1([x, y, z, strength, limit, sor, offset, degrees]: [f64; 8]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    let value = strength * (y * y - x * x + x * x * x.abs());
    // All other functions return a negative limit, this one its opposite.
    value.min(limit).max(-limit)
}

/// Internal function `f_algbr_cyl2`: `-strength` times the left side of 2 x⁴ - 3 x² y + y² - 2 y³ + y⁴ = 0, the tacnode
/// curve.
pub fn f_algbr_cyl2([x, y, z, strength, limit, sor, offset, degrees]: [f64; 8]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    let (x2, y2) = (x * x, y * y);
    clamp_symmetrically(-strength * (2.0 * x2 * x2 - 3.0 * x2 * y + y2 - 2.0 * y2 * y + y2 * y2), limit)
}

/// Internal function `f_algbr_cyl3`: `-strength` times the left side of x⁴ + x² y² - 2 x² y - x y² + y² = 0, the
/// keratoid cusp.
pub fn f_algbr_cyl3([x, y, z, strength, limit, sor, offset, degrees]: [f64; 8]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    let (x2, y2) = (x * x, y * y);
    clamp_symmetrically(-strength * (x2 * x2 + x2 * y2 - 2.0 * x2 * y - x * y2 + y2), limit)
}

/// Internal function `f_algbr_cyl4`: `strength` times the right minus the left side of (x² + y²)² = y³ - 3 x² y, the
/// trifolium.
pub fn f_algbr_cyl4([x, y, z, strength, limit, sor, offset, degrees]: [f64; 8]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    let (x2, y2) = (x * x, y * y);
    let s = x2 + y2;
    clamp_symmetrically(-strength * (s * s + 3.0 * x2 * y - y2 * y), limit)
}

/// Internal function `f_devils_curve_2d`: `strength` times the left minus the right side of y⁴ - b² y² = x⁴ - a² x²,
/// the devil's curve.
pub fn f_devils_curve_2d([x, y, z, strength, a, b, sor, offset, degrees]: [f64; 9]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    let (x2, y2) = (x * x, y * y);
    scale_and_clamp_field(strength, y2 * (y2 - b * b) - x2 * (x2 - a * a))
}

/// Internal function `f_folium_surface_2d`: `-strength` times the left side of y² (1 + (b - 4 a) x) + (1 + b) x² = 0, a
/// folium.
pub fn f_folium_surface_2d([x, y, z, strength, a, b, sor, offset, degrees]: [f64; 9]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    scale_and_clamp_field(-strength, y * y * (1.0 + (b - 4.0 * a) * x) + (1.0 + b) * x * x)
}

/// Internal function `f_kampyle_of_eudoxus_2d`: `strength` times the right minus the left side of
/// y² = b² (x⁴ - a b x²), the kampyle of Eudoxus.
pub fn f_kampyle_of_eudoxus_2d([x, y, z, strength, a, b, sor, offset, degrees]: [f64; 9]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    let x2 = x * x;
    scale_and_clamp_field(strength, b * b * x2 * (x2 - a * b) - y * y)
}

/// Internal function `f_lemniscate_of_gerono_2d`: `strength` times the right minus the left side of
/// y² = b² (a² x² - x⁴), the eight curve or lemniscate of Gerono.
pub fn f_lemniscate_of_gerono_2d([x, y, z, strength, a, b, sor, offset, degrees]: [f64; 9]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    let x2 = x * x;
    scale_and_clamp_field(strength, b * b * x2 * (a * a - x2) - y * y)
}

/// Internal function `f_piriform_2d`: `strength` times the right minus the left side of y² = c² x³ (a + b x), the
/// piriform.
pub fn f_piriform_2d([x, y, z, strength, a, b, c, sor, offset, degrees]: [f64; 10]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    scale_and_clamp_field(strength, c * c * x * x * x * (a + b * x) - y * y)
}

/// Internal function `f_strophoid_2d`: `strength` times the right minus the left side of (b - x) y² = c² x² (x + a),
/// the strophoid.
pub fn f_strophoid_2d([x, y, z, strength, a, b, c, sor, offset, degrees]: [f64; 10]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    scale_and_clamp_field(strength, (x - b) * y * y + c * c * x * x * (x + a))
}

/// Internal function `f_witch_of_agnesi_2d`: `strength` times the right minus the left side of y (x² + a²) = b, the
/// witch of Agnesi.
pub fn f_witch_of_agnesi_2d([x, y, z, strength, a, b, sor, offset, degrees]: [f64; 9]) -> f64 {
    let (x, y) = curve_plane_point([x, y, z], [sor, offset, degrees]);
    scale_and_clamp_field(strength, b - y * (x * x + a * a))
}
