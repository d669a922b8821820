//! Shafts of rays from one point to a parallelogram, and the boxes of a BVH that a shaft can intersect (Haines and
//! Wallace, Shaft culling for efficient ray-cast radiosity, 1991).

use super::node::{Child, Kind};
use super::{Bvh, REACH, round_down, round_up};
use crate::math::{Aabb, DVec3};
use glam::{Vec3, Vec4};
use smallvec::SmallVec;
use std::cell::OnceCell;
use std::ops::ControlFlow;

/// Relative error of a sum of three products in single precision, with a reserve.
const SUM_ERROR: f32 = 5e-7;
/// Distance by which each side of a shaft is moved outwards, relative to the coordinates.
const MARGIN: f64 = 1e-6;

/// Convex hull of a point, the apex, and a parallelogram.
#[derive(Clone, Debug)]
pub struct Shaft {
    /// Common origin of the shaft's rays.
    pub apex: DVec3,
    /// Corners of the parallelogram, in order around it.
    pub corners: [DVec3; 4],
    bounds: Aabb,
    /// Sides of the shaft; computed for the first box that does not contain the apex.
    sides: OnceCell<[Side; 4]>,
}

/// Half-space normal·p ≤ distance that contains a shaft.
#[derive(Clone, Copy, Debug)]
struct Side {
    normal: Vec3,
    distance: f32,
}

impl Side {
    /// Creates the half-space that contains all vertices; all of space for a normal of length 0.
    fn around(vertices: &[DVec3; 5], normal: DVec3) -> Self {
        let normal = normal.normalize_or_zero().as_vec3();
        let n = normal.as_dvec3();
        let distance =
            vertices.iter().map(|p| n.dot(*p) + MARGIN * n.abs().dot(p.abs())).fold(-f64::INFINITY, f64::max);
        Self { normal, distance: round_up(distance) }
    }
}

impl Shaft {
    /// Creates the shaft from `apex` to the parallelogram with `corners`, in order around it; `None` if a vertex is not
    /// finite or exceeds the range of a BVH.
    pub fn new(apex: DVec3, corners: [DVec3; 4]) -> Option<Self> {
        let [a, b, c, d] = corners;
        let is_valid = |p: &DVec3| p.is_finite() && p.abs().max_element() < REACH;
        let bounds = Aabb::from_points([apex, a, b, c, d]);
        let margin = MARGIN * bounds.min.abs().max(bounds.max.abs()).max_element();
        let shaft = Self { apex, corners, bounds: bounds.grown(margin), sides: OnceCell::new() };
        [apex, a, b, c, d].iter().all(is_valid).then_some(shaft)
    }

    /// Returns the half-spaces through the apex and each side of the parallelogram.
    fn sides(&self) -> &[Side; 4] {
        self.sides.get_or_init(|| {
            let Self { apex, corners: [a, b, c, d], .. } = *self;
            let to_center = (a + c) * 0.5 - apex;
            [[a, b], [b, c], [c, d], [d, a]].map(|[start, end]| {
                let normal = (start - apex).cross(end - apex);
                Side::around(&[apex, a, b, c, d], if normal.dot(to_center) > 0.0 { -normal } else { normal })
            })
        })
    }

    /// False only if the shaft does not intersect the box.
    pub fn may_intersect(&self, b: &Aabb) -> bool {
        let overlaps = self.bounds.min.cmple(b.max).all() && self.bounds.max.cmpge(b.min).all();
        overlaps
            && (b.contains(self.apex)
                || self.sides().iter().all(|side| {
                    let n = side.normal.as_dvec3();
                    // The corner of the box that is deepest inside of the half-space
                    let least = (n * b.min).min(n * b.max).element_sum();
                    // NaN, for an infinite box, does not reject the box.
                    least.is_nan() || least <= f64::from(side.distance)
                }))
    }
}

impl Bvh {
    /// Calls `visit` with each item of each leaf whose box the shaft may intersect, in no particular order, until `visit`
    /// returns `Break`. A leaf can contain items whose own boxes are outside of the shaft.
    pub fn visit_items_near_shaft(&self, shaft: &Shaft, mut visit: impl FnMut(usize) -> ControlFlow<()>) {
        let below = shaft.bounds.min.to_array().map(|x| Vec4::splat(round_down(x)));
        let above = shaft.bounds.max.to_array().map(|x| Vec4::splat(round_up(x)));
        let mut stack: SmallVec<[Child; 64]> = SmallVec::new();
        stack.extend((!self.nodes.is_empty()).then_some(Child::node(0)));
        while let Some(child) = stack.pop() {
            match child.kind() {
                Kind::Node(number) => {
                    let node = &self.nodes[number];
                    let [lower, upper] = &node.planes;
                    for half in 0..2 {
                        let overlaps = |i: usize| lower[i][half].cmple(above[i]) & upper[i][half].cmpge(below[i]);
                        let mut mask = overlaps(0) & overlaps(1) & overlaps(2);
                        for Side { normal, distance } in shaft.sides() {
                            // Height of the box's lowest corner, lowered by its rounding error
                            let term = |i: usize| {
                                let product = node.planes[usize::from(normal[i] < 0.0)][i][half] * normal[i];
                                product - product.abs() * SUM_ERROR
                            };
                            // NaN does not reject a box.
                            mask &= !(term(0) + term(1) + term(2)).cmpgt(Vec4::splat(*distance));
                        }
                        let mask = mask.bitmask();
                        stack.extend(
                            (0..4).filter(|slot| mask >> slot & 1 == 1).map(|slot| node.child[4 * half + slot]),
                        );
                    }
                }
                Kind::Items(mut items) => {
                    if items.try_for_each(&mut visit).is_break() {
                        return;
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Range, Ray};

    /// Returns a number in [-1, 1) that is a function of `k`.
    fn number(k: u32) -> f64 {
        f64::from(k.wrapping_mul(2_654_435_761).rotate_left(13).wrapping_mul(2_246_822_519) >> 8) / f64::from(1 << 23)
            - 1.0
    }

    fn vector(k: u32) -> DVec3 {
        DVec3::new(number(3 * k), number(3 * k + 1), number(3 * k + 2))
    }

    #[test]
    fn no_ray_of_a_shaft_hits_a_box_that_the_shaft_misses() {
        let mut n_empty = 0;
        for k in 0..300 {
            let scale = [1.0, 1e-4, 1e6][k as usize % 3];
            let boxes: Vec<Aabb> = (0..40)
                .map(|i| (vector(10_000 + 97 * k + 2 * i), vector(20_000 + 97 * k + i)))
                .map(|(p, size)| Aabb::from_corners(p * scale, (p + size * 0.1) * scale))
                .collect();
            let (bvh, order) = Bvh::build(boxes.iter().copied());
            // Some parallelograms are flat, others a point
            let (apex, center) = (vector(3 * k) * scale, vector(3 * k + 1) * scale);
            let sides = [0.3, 1e-9, 0.0].map(|size| size * scale);
            let [a, b] = [vector(5 * k) * sides[k as usize / 3 % 3], vector(7 * k) * sides[k as usize / 9 % 2]];
            let shaft = Shaft::new(apex, [center + a + b, center + a - b, center - a - b, center - a + b]).unwrap();
            let mut found = vec![];
            bvh.visit_items_near_shaft(&shaft, |i| {
                found.push(order[i] as usize);
                ControlFlow::Continue(())
            });
            for (i, bounds) in boxes.iter().enumerate() {
                let visited = found.contains(&i) && shaft.may_intersect(bounds);
                n_empty += usize::from(!visited);
                for sample in 0..20 {
                    let [u, v] = [number(sample * 31 + k), number(sample * 57 + k)];
                    let ray = Ray::new(apex, center + a * u + b * v - apex);
                    let hits = bounds.slabs(&ray, Range { min: 0.0, max: 1.0 }).is_some();
                    assert!(visited || !hits, "{shaft:?} misses {bounds:?}");
                }
            }
        }
        assert!(n_empty > 9_000, "{n_empty} of 12 000 boxes are outside");
    }

    #[test]
    fn vertices_that_are_not_finite_make_no_shaft() {
        let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        assert!(Shaft::new(DVec3::Z, square).is_some());
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200] {
            let wrong = DVec3::new(0.0, wrong, 0.0);
            assert!(Shaft::new(wrong, square).is_none(), "{wrong}");
            for i in 0..4 {
                let mut corners = square;
                corners[i] = wrong;
                assert!(Shaft::new(DVec3::Z, corners).is_none(), "{wrong}");
            }
        }
    }

    #[test]
    fn a_shaft_without_extent_intersects_infinite_boxes_and_its_own_point() {
        let shaft = Shaft::new(DVec3::ONE * 0.5, [DVec3::ONE * 0.5; 4]).unwrap();
        assert!(shaft.may_intersect(&Aabb::INFINITE));
        assert!(shaft.may_intersect(&Aabb::from_corners(DVec3::ZERO, DVec3::ONE)));
        assert!(!shaft.may_intersect(&Aabb::from_corners(DVec3::ONE, DVec3::ONE * 2.0)));
    }
}
