//! Half-spaces, and the box around what they share: so an intersection of slanted planes gets a box of its own.
//!
//! A box is cut by one half-space after the other, as a convex polyhedron (Sutherland and Hodgman, Reentrant polygon
//! clipping, 1974, face by face). Everything is rounded outwards: the half-spaces by a margin, the box by its own.

use crate::math::{Aabb, DVec3, Transform, tolerance};
use crate::shape::{Kernel, Shape};
use smallvec::SmallVec;

/// More of them are not looked at.
const MOST: usize = 64;
/// An unbounded box begins as one that reaches so many times as far as any of the half-spaces is away.
const FAR: f64 = 1e4;
/// With numbers beyond this nothing is cut.
const FARTHEST: f64 = 1e100;
/// How far each half-space is moved outwards, relative to the box's largest coordinate.
const MARGIN: f64 = 1e-10;

/// Points with normal·p ≤ distance.
#[derive(Clone, Copy, Debug)]
pub struct HalfSpace {
    /// Length 1.
    normal: DVec3,
    distance: f64,
}

/// Half-spaces that something lies in.
pub type HalfSpaces = SmallVec<[HalfSpace; 16]>;

impl HalfSpace {
    /// normal·p ≤ distance in the object's space, seen from the world; `None` where that is not a plane of numbers.
    fn under(m: &Transform, normal: DVec3, distance: f64) -> Option<Self> {
        // n·(M⁻¹·p) ≤ d, where M⁻¹·p = A·p + b: (Aᵀ·n)·p ≤ d - n·b
        let n = m.inv.matrix3.transpose() * normal;
        let (length, distance) = (n.length(), distance - normal.dot(m.inv.translation));
        let plane = Self { normal: n / length, distance: distance / length };
        (length > 0.0 && plane.normal.is_finite() && plane.distance.is_finite()).then_some(plane)
    }

    fn is_slanted(&self) -> bool {
        self.normal.abs().max_element() != 1.0
    }
}

/// Appends half-spaces that a shape's inside and surface lie in, if it has flat faces or round walls.
pub fn push_shape(shape: &Shape, m: &Transform, inverse: bool, out: &mut HalfSpaces) {
    let turned = || shape.as_half_space().into_iter().map(|(normal, distance)| (-normal, -distance)).collect();
    let planes = if inverse { turned() } else { shape.half_spaces() };
    let room = MOST.saturating_sub(out.len());
    let placed = planes.into_iter().take(room);
    out.extend(placed.filter_map(|(normal, distance)| HalfSpace::under(m, normal, distance + 2.0 * tolerance::INSIDE)));
}

/// A box around what all the half-spaces share of `start`.
pub fn cut(start: Aabb, planes: &[HalfSpace]) -> Aabb {
    // The axis' own planes are in the boxes already.
    if start.is_empty() || !planes.iter().any(HalfSpace::is_slanted) {
        return start;
    }
    let size = |b: &Aabb| {
        let finite = |v: DVec3| v.map(|x| if x.is_finite() { x.abs() } else { 0.0 }).max_element();
        finite(b.min).max(finite(b.max))
    };
    let far = FAR * planes.iter().map(|p| p.distance.abs()).fold(size(&start).max(1.0), f64::max);
    if far > FARTHEST {
        return start;
    }
    let mut bounds = start.intersection(Aabb::from_corners(DVec3::splat(-far), DVec3::splat(far)));
    // From a box that is much too large the first cuts are coarse; the next ones start from what they left.
    for _ in 0..3 {
        let before = bounds;
        let margin = MARGIN * size(&before);
        let found = Polyhedron::cuboid(&before).cut(planes, margin).bounds();
        if found.is_empty() {
            return Aabb::EMPTY;
        }
        let found = found.grown(tolerance::BOUNDS * size(&found).max(margin)).intersection(before);
        // What reaches the end of the world goes on there, perhaps in all directions.
        if found.min.min_element() < -0.99 * far || found.max.max_element() > 0.99 * far {
            return start;
        }
        bounds = found;
        if size(&found) > 0.01 * size(&before) {
            break;
        }
    }
    bounds
}

/// A side of a face, from corner to corner.
type Edge = [DVec3; 2];

/// A convex polyhedron: faces, each the list of its edges in no particular order.
struct Polyhedron {
    faces: Vec<SmallVec<[Edge; 8]>>,
}

impl Polyhedron {
    fn cuboid(b: &Aabb) -> Self {
        let corners = b.corners();
        // Bit i of a corner's number says at which end of axis i it lies.
        let face = |axis: usize, end: usize| {
            let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
            let at = [0, u, u | v, v].map(|rest| corners[(end << axis) | rest]);
            (0..4).map(|i| [at[i], at[(i + 1) % 4]]).collect()
        };
        Self { faces: (0..6).map(|i| face(i / 2, i % 2)).collect() }
    }

    /// What of it lies in all the half-spaces, each moved outwards by `margin`.
    fn cut(mut self, planes: &[HalfSpace], margin: f64) -> Self {
        for plane in planes {
            let height = |p: DVec3| plane.normal.dot(p) - plane.distance - margin;
            // The new face, of the lines along which the others are cut.
            let mut lid = SmallVec::new();
            for face in &mut self.faces {
                lid.extend(cut_face(face, &height));
            }
            self.faces.retain(|face| !face.is_empty());
            if !lid.is_empty() {
                self.faces.push(lid);
            }
        }
        self
    }

    fn bounds(&self) -> Aabb {
        Aabb::from_points(self.faces.iter().flatten().flatten().copied())
    }
}

/// Keeps what of a face lies below, closes it along the cut, and returns that line.
fn cut_face(face: &mut SmallVec<[Edge; 8]>, height: &impl Fn(DVec3) -> f64) -> Option<Edge> {
    let mut ends: SmallVec<[DVec3; 2]> = SmallVec::new();
    face.retain(|edge| {
        let [a, b] = edge.map(height);
        if a > 0.0 && b > 0.0 {
            return false;
        }
        // Always from the lower end: so both faces of an edge get the same point.
        let between =
            |low: DVec3, at_low: f64, high: DVec3, at_high: f64| low + (high - low) * (at_low / (at_low - at_high));
        if a > 0.0 {
            edge[0] = between(edge[1], b, edge[0], a);
            ends.push(edge[0]);
        } else if b > 0.0 {
            edge[1] = between(edge[0], a, edge[1], b);
            ends.push(edge[1]);
        }
        true
    });
    // A convex face is cut at two edges; where rounding made more of them, the farthest two are its line.
    let pairs = (0..ends.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let line = pairs
        .map(|(i, j)| [ends[i], ends[j]])
        .max_by(|a, b| a[0].distance_squared(a[1]).total_cmp(&b[0].distance_squared(b[1])))?;
    face.push(line);
    Some(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn octahedron(turn: &Transform) -> HalfSpaces {
        let plane = |i: usize| {
            let sign = |bit: usize| if i >> bit & 1 == 0 { 1.0 } else { -1.0 };
            HalfSpace::under(turn, DVec3::new(sign(0), sign(1), sign(2)).normalize(), 1.0 / 3f64.sqrt())
        };
        (0..8).filter_map(plane).collect()
    }

    fn near(a: Aabb, b: Aabb) -> bool {
        a.min.distance(b.min) < 1e-5 && a.max.distance(b.max) < 1e-5
    }

    #[test]
    fn planes_alone() {
        let unit = Aabb::from_corners(DVec3::NEG_ONE, DVec3::ONE);
        assert!(near(cut(Aabb::INFINITE, &octahedron(&Transform::IDENTITY)), unit));
        // Far away from the origin, and of any size.
        let far = Transform::scale(DVec3::splat(0.01)).unwrap().then(&Transform::translate(DVec3::splat(900.0)));
        assert!(near(cut(Aabb::INFINITE, &octahedron(&far)), far.aabb(&unit)));
        // Four faces have no end; seven still have, as the missing one's neighbours meet above it.
        let open = octahedron(&Transform::IDENTITY);
        assert_eq!(cut(Aabb::INFINITE, &open[4..]), Aabb::INFINITE);
        assert!(near(cut(Aabb::INFINITE, &open[1..]), unit));
        let away = HalfSpace { normal: DVec3::ONE.normalize(), distance: -5.0 };
        assert!(cut(Aabb::INFINITE, &[&open[..], &[away]].concat()).is_empty());
    }

    #[test]
    fn a_box_and_a_plane() {
        // x + y ≤ -1.5 leaves a corner.
        let plane = HalfSpace { normal: DVec3::new(1.0, 1.0, 0.0).normalize(), distance: -1.5 / 2f64.sqrt() };
        let left = cut(Aabb::from_corners(DVec3::NEG_ONE, DVec3::ONE), &[plane]);
        assert!(near(left, Aabb::from_corners(DVec3::NEG_ONE, DVec3::new(-0.5, -0.5, 1.0))));
        let through = HalfSpace { normal: DVec3::new(1.0, 1.0, 0.0).normalize(), distance: 0.0 };
        assert_eq!(cut(Aabb::INFINITE, &[through]), Aabb::INFINITE);
    }
}
