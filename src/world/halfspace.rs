//! Intersections of half-spaces, and boxes around them: bounds for intersections of slanted planes.
//!
//! A box is clipped by one half-space after the other, as a convex polyhedron (Sutherland and Hodgman, Reentrant
//! polygon clipping, 1974, face by face). All rounding is outwards: both the half-spaces and the box get a margin.

use crate::math::bvh::Shaft;
use crate::math::{Aabb, DVec3, Transform, tolerance};
use crate::shape::{Kernel, Shape};
use smallvec::SmallVec;

/// Maximum number of half-spaces that clip a box.
const MAX_HALF_SPACES: usize = 64;
/// Half-width of the start box for an unbounded intersection, as a multiple of the largest distance of a half-space.
const START_EXTENT_FACTOR: f64 = 1e4;
/// Half-width of the start box above which [`clip_box`] returns its argument unclipped.
const MAX_START_EXTENT: f64 = 1e100;
/// Distance by which each half-space that clips a box is moved outwards, relative to the box's largest coordinate.
const MARGIN: f64 = 1e-10;

/// Deviation of a half-space's normal, length 1, from an axis up to which it counts as parallel to the axis: rounding of a
/// rotation, with a reserve.
const AXIS_DEVIATION: f64 = 1e-12;

/// Rounding error of the height above a half-space, relative to the coordinates, with a reserve.
const NOISE: f64 = 1e-12;

/// Half-space of all points p with normal·p ≤ distance.
#[derive(Clone, Copy, Debug)]
pub struct HalfSpace {
    /// Outward normal of the half-space, length 1.
    normal: DVec3,
    distance: f64,
}

/// Half-spaces whose intersection contains a solid.
pub type HalfSpaces = SmallVec<[HalfSpace; 16]>;

impl HalfSpace {
    /// Transforms the half-space normal·p ≤ distance by `m` from object to world space; `None` if not finite.
    fn from_object_space(m: &Transform, normal: DVec3, distance: f64) -> Option<Self> {
        // n·(M⁻¹·p) ≤ d, where M⁻¹·p = A·p + b: (Aᵀ·n)·p ≤ d - n·b
        let n = m.inv.matrix3.transpose() * normal;
        let (length, distance) = (n.length(), distance - normal.dot(m.inv.translation));
        let plane = Self { normal: n / length, distance: distance / length };
        (length > 0.0 && plane.normal.is_finite() && plane.distance.is_finite()).then_some(plane)
    }

    /// Returns the half-space in the object space of `m`; `None` if not finite.
    fn to_object_space(self, m: &Transform) -> Option<Self> {
        // n·(A·p + b) ≤ d: (Aᵀ·n)·p ≤ d - n·b
        let n = m.m.matrix3.transpose() * self.normal;
        let (length, distance) = (n.length(), self.distance - self.normal.dot(m.m.translation));
        let local = Self { normal: n / length, distance: distance / length };
        (length > 0.0 && local.normal.is_finite() && local.distance.is_finite()).then_some(local)
    }

    /// True if each ray of the shaft leaves the half-space within half the distance `min` and does not return, so that
    /// it hits nothing in the half-space at `min` or farther away.
    pub fn shaft_exits_before(&self, shaft: &Shaft, min: f64) -> bool {
        let height = |p: DVec3| self.normal.dot(p) - self.distance;
        let noise = NOISE * (self.distance.abs() + shaft.apex.abs().max_element());
        let start = height(shaft.apex) - noise;
        let end = shaft.corners.iter().map(|p| height(*p)).fold(f64::INFINITY, f64::min);
        let length = shaft.corners.iter().map(|p| p.distance(shaft.apex)).fold(0.0, f64::max);
        // Heights are linear along a ray.
        end > 0.0 && start * length + (end - start) * (0.5 * min) > 0.0
    }

    fn is_slanted(&self) -> bool {
        self.normal.abs().max_element() != 1.0
    }
}

/// Appends half-spaces in world space that contain a shape with flat faces or round walls, up to 64 in `out`; none for
/// other shapes. With `inverse`, they contain the outside of the shape.
pub fn push_half_spaces_of(shape: &Shape, m: &Transform, inverse: bool, out: &mut HalfSpaces) {
    let turned = || shape.as_half_space().into_iter().map(|(normal, distance)| (-normal, -distance)).collect();
    let planes = if inverse { turned() } else { shape.half_spaces() };
    let room = MAX_HALF_SPACES.saturating_sub(out.len());
    let placed = planes.into_iter().take(room);
    out.extend(
        placed.filter_map(|(normal, distance)| {
            HalfSpace::from_object_space(m, normal, distance + 2.0 * tolerance::INSIDE)
        }),
    );
}

/// Returns the box, in the object space of `m`, of those half-spaces whose faces are perpendicular to an axis of that space;
/// it is infinite in directions without such a half-space. `planes` are in world space.
pub fn slabs_in_object_space(planes: &[HalfSpace], m: &Transform) -> Aabb {
    let mut slabs = Aabb::INFINITE;
    for HalfSpace { normal, distance } in planes.iter().filter_map(|plane| plane.to_object_space(m)) {
        for axis in 0..3 {
            let deviation = (normal - normal[axis].signum() * DVec3::AXES[axis]).abs().max_element();
            if deviation > AXIS_DEVIATION {
                continue;
            }
            if normal[axis] > 0.0 {
                slabs.max[axis] = slabs.max[axis].min(distance);
            } else {
                slabs.min[axis] = slabs.min[axis].max(-distance);
            }
        }
    }
    slabs
}

/// Returns a box around the intersection of the box `start` with all half-spaces; `start` itself if no half-space is
/// slanted or the intersection is unbounded.
pub fn clip_box(start: Aabb, planes: &[HalfSpace]) -> Aabb {
    // Axis-parallel planes are in the boxes already.
    if start.is_empty() || !planes.iter().any(HalfSpace::is_slanted) {
        return start;
    }
    let size = |b: &Aabb| {
        let finite = |v: DVec3| v.map(|x| if x.is_finite() { x.abs() } else { 0.0 }).max_element();
        finite(b.min).max(finite(b.max))
    };
    let far = START_EXTENT_FACTOR * planes.iter().map(|p| p.distance.abs()).fold(size(&start).max(1.0), f64::max);
    if far > MAX_START_EXTENT {
        return start;
    }
    let mut bounds = start.intersection(Aabb::from_corners(DVec3::splat(-far), DVec3::splat(far)));
    // Clipping a box that is much too large is inexact; repeat from the result.
    for _ in 0..3 {
        let before = bounds;
        let margin = MARGIN * size(&before);
        let found = Polyhedron::cuboid(&before).cut(planes, margin).bounds();
        if found.is_empty() {
            return Aabb::EMPTY;
        }
        let found = found.grown(tolerance::BOUNDS * size(&found).max(margin)).intersection(before);
        // A box that reaches the end of the start box is unbounded, perhaps in all directions.
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

/// An edge of a face, from corner to corner.
type Edge = [DVec3; 2];

/// A convex polyhedron: each face is a list of edges in no particular order.
struct Polyhedron {
    faces: Vec<SmallVec<[Edge; 8]>>,
}

impl Polyhedron {
    fn cuboid(b: &Aabb) -> Self {
        let corners = b.corners();
        // Bit i of a corner's number selects the end of axis i.
        let face = |axis: usize, end: usize| {
            let (u, v) = (1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3));
            let at = [0, u, u | v, v].map(|rest| corners[(end << axis) | rest]);
            (0..4).map(|i| [at[i], at[(i + 1) % 4]]).collect()
        };
        Self { faces: (0..6).map(|i| face(i / 2, i % 2)).collect() }
    }

    /// Clips the polyhedron by all half-spaces, each moved outwards by `margin`.
    fn cut(mut self, planes: &[HalfSpace], margin: f64) -> Self {
        for plane in planes {
            let height = |p: DVec3| plane.normal.dot(p) - plane.distance - margin;
            // The new face consists of the edges along which the other faces are clipped.
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

/// Clips a face to the points where `height` is negative, closes it along the cut, and returns the new edge.
fn cut_face(face: &mut SmallVec<[Edge; 8]>, height: &impl Fn(DVec3) -> f64) -> Option<Edge> {
    let mut ends: SmallVec<[DVec3; 2]> = SmallVec::new();
    face.retain(|edge| {
        let [a, b] = edge.map(height);
        if a > 0.0 && b > 0.0 {
            return false;
        }
        // Interpolate from the lower end, so that both faces of an edge get the same point.
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
    // A convex face is cut at two edges; if rounding found more, take the two farthest points.
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
            HalfSpace::from_object_space(turn, DVec3::new(sign(0), sign(1), sign(2)).normalize(), 1.0 / 3f64.sqrt())
        };
        (0..8).filter_map(plane).collect()
    }

    fn near(a: Aabb, b: Aabb) -> bool {
        a.min.distance(b.min) < 1e-5 && a.max.distance(b.max) < 1e-5
    }

    #[test]
    fn planes_alone() {
        let unit = Aabb::from_corners(DVec3::NEG_ONE, DVec3::ONE);
        assert!(near(clip_box(Aabb::INFINITE, &octahedron(&Transform::IDENTITY)), unit));
        // Far away from the origin, and of any size.
        let far = Transform::scale(DVec3::splat(0.01)).unwrap().then(&Transform::translate(DVec3::splat(900.0)));
        assert!(near(clip_box(Aabb::INFINITE, &octahedron(&far)), far.transform_aabb(&unit)));
        // Four faces are unbounded; seven are bounded, as the neighbours of the missing face meet above it.
        let open = octahedron(&Transform::IDENTITY);
        assert_eq!(clip_box(Aabb::INFINITE, &open[4..]), Aabb::INFINITE);
        assert!(near(clip_box(Aabb::INFINITE, &open[1..]), unit));
        let away = HalfSpace { normal: DVec3::ONE.normalize(), distance: -5.0 };
        assert!(clip_box(Aabb::INFINITE, &[&open[..], &[away]].concat()).is_empty());
    }

    #[test]
    fn a_box_and_a_plane() {
        // x + y ≤ -1.5 leaves a corner.
        let plane = HalfSpace { normal: DVec3::new(1.0, 1.0, 0.0).normalize(), distance: -1.5 / 2f64.sqrt() };
        let left = clip_box(Aabb::from_corners(DVec3::NEG_ONE, DVec3::ONE), &[plane]);
        assert!(near(left, Aabb::from_corners(DVec3::NEG_ONE, DVec3::new(-0.5, -0.5, 1.0))));
        let through = HalfSpace { normal: DVec3::new(1.0, 1.0, 0.0).normalize(), distance: 0.0 };
        assert_eq!(clip_box(Aabb::INFINITE, &[through]), Aabb::INFINITE);
    }

    #[test]
    fn slabs_of_rotated_planes() {
        let turn =
            Transform::scale(DVec3::new(2.0, 3.0, 1.0)).unwrap().then(&Transform::rotate(DVec3::new(20.0, 30.0, 40.0)));
        let turn = turn.then(&Transform::translate(DVec3::new(5.0, 6.0, 7.0)));
        let planes = [(DVec3::Y, 4.0), (DVec3::NEG_Y, -1.0), (DVec3::Z, 3.0), (DVec3::new(0.6, 0.8, 0.0), 1.0)];
        let planes: Vec<_> = planes.iter().filter_map(|(n, d)| HalfSpace::from_object_space(&turn, *n, *d)).collect();
        let Aabb { min, max } = slabs_in_object_space(&planes, &turn);
        assert!((max.y - 4.0).abs() < 1e-12 && (min.y - 1.0).abs() < 1e-12 && (max.z - 3.0).abs() < 1e-12);
        assert_eq!([min.x, min.z, max.x], [f64::NEG_INFINITY, f64::NEG_INFINITY, f64::INFINITY]);
    }
}
