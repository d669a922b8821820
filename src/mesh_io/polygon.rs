//! Triangulation of polygons.

use crate::math::{DVec2, DVec3, cancel};
use glam::Vec3;

/// Number of corners from which a polygon is assumed to be convex: clipping ears takes time in proportion to the square
/// of the number of corners.
const LARGE: usize = 2000;

/// Calls `visit` with the triangles of a polygon, as indices of its corners: a fan if it is convex; else ears are
/// clipped (Meisters, Polygons have ears, 1975).
pub fn triangulate(points: &[Vec3], mut visit: impl FnMut([usize; 3])) {
    let n = points.len();
    let flat = if n > 3 && n <= LARGE { project_polygon(points) } else { vec![] };
    let convex = (0..flat.len()).all(|i| doubled_signed_area(&flat, (i + n - 1) % n, i, (i + 1) % n) >= 0.0);
    if convex {
        (1..n.saturating_sub(1)).for_each(|i| visit([0, i, i + 1]));
        return;
    }
    let mut rest: Vec<usize> = (0..n).collect();
    while rest.len() > 3 {
        // The search for an ear takes quadratic time; a cancelled run needs no triangles.
        if cancel::is_cancelled() {
            return;
        }
        let m = rest.len();
        let corner = |i: usize| [rest[(i + m - 1) % m], rest[i], rest[(i + 1) % m]];
        // (A polygon that intersects itself may have no ear: then any corner will do.)
        let ear = (0..m).find(|&i| is_ear(&flat, corner(i), &rest)).unwrap_or(0);
        visit(corner(ear));
        rest.remove(ear);
    }
    visit([rest[0], rest[1], rest[2]]);
}

/// Returns the polygon projected along the axis of its normal (Newell's sum), counter-clockwise.
fn project_polygon(points: &[Vec3]) -> Vec<DVec2> {
    let wide = || points.iter().map(|p| p.as_dvec3());
    let (first, next) = (points[0].as_dvec3(), wide().cycle().skip(1));
    let normal = wide().zip(next).fold(DVec3::ZERO, |sum, (a, b)| sum + (a - first).cross(b - first));
    let z = normal.abs().max_position();
    let sign = normal[z].signum();
    wide().map(|p| DVec2::new(p[(z + 1) % 3], p[(z + 2) % 3] * sign)).collect()
}

/// Returns twice the signed area of three corners of a polygon, negative if they turn to the right.
fn doubled_signed_area(flat: &[DVec2], a: usize, b: usize, c: usize) -> f64 {
    (flat[b] - flat[a]).perp_dot(flat[c] - flat[b])
}

/// True if the polygon's corner b turns to the left, with no other corner in its triangle.
fn is_ear(flat: &[DVec2], [a, b, c]: [usize; 3], rest: &[usize]) -> bool {
    let holds = |p: usize| {
        doubled_signed_area(flat, a, b, p) >= 0.0
            && doubled_signed_area(flat, b, c, p) >= 0.0
            && doubled_signed_area(flat, c, a, p) >= 0.0
    };
    let other = |p: &&usize| ![flat[a], flat[b], flat[c]].contains(&flat[**p]);
    doubled_signed_area(flat, a, b, c) > 0.0 && !rest.iter().filter(other).any(|&p| holds(p))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn concave_polygons_keep_their_area() {
        // A star of ten corners in a slanted plane, in both orientations.
        let star = |i: usize| {
            let (angle, r) = (i as f64 * std::f64::consts::PI / 5.0, if i.is_multiple_of(2) { 2.0 } else { 0.7 });
            let (x, y) = (r * crate::math::fp::cos(angle), r * crate::math::fp::sin(angle));
            Vec3::new(x as f32, y as f32, (x + y) as f32)
        };
        for turned in [false, true] {
            let points: Vec<Vec3> = (0..10).map(|i| star(if turned { 9 - i } else { i })).collect();
            let (mut sum, mut signed, mut count) = (0.0, DVec3::ZERO, 0);
            triangulate(&points, |[a, b, c]| {
                let [a, b, c] = [a, b, c].map(|i| points[i].as_dvec3());
                let area = (b - a).cross(c - a) / 2.0;
                (sum, signed, count) = (sum + area.length(), signed + area, count + 1);
            });
            assert_eq!(count, 8);
            assert!((sum - signed.length()).abs() < 1e-6, "{sum} {signed}");
        }
    }

    #[test]
    fn few_corners() {
        for n in 0..3 {
            triangulate(&vec![Vec3::ZERO; n], |_| panic!("{n}"));
        }
        let mut count = 0;
        triangulate(&[Vec3::ZERO; 7], |_| count += 1);
        assert_eq!(count, 5);
    }
}
