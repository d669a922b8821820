//! A bounding volume hierarchy: four boxes to a node, in single precision, rounded so that it never misses what double
//! precision would hit.
//!
//! It knows boxes and their numbers, nothing of what is in them.

mod build;

use crate::math::{Aabb, DVec3, Range, Ray};
use glam::{BVec4A, Vec3A, Vec4};
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Boxes whose corners reach further than this are not for a hierarchy in single precision.
const REACH: f64 = 1e30;
/// No hierarchy is deeper: below the level where only halving keeps this promise, it halves.
const DEPTH: usize = 20;
/// Each level leaves at most three entries behind.
const STACK: usize = 3 * DEPTH + 4;
/// Rounding of the slab test in single precision, relative: three operations, each off by 2⁻²⁴, and some reserve.
const SLACK: f32 = 5e-7;

/// The hierarchy over boxes 0 … n-1 in the order that [`Bvh::build`] returned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bvh {
    nodes: Vec<Wide>,
}

/// Four children side by side; unused ones have an empty box.
#[derive(Clone, Debug, PartialEq)]
#[repr(align(64))]
struct Wide {
    /// `planes[0]` holds the lower ends along x, y, z, `planes[1]` the upper ones.
    planes: [[Vec4; 3]; 2],
    /// The number of a node, or of the first item.
    child: [u32; 4],
    /// How many items; 0 if the child is a node.
    count: [u32; 4],
}

/// Is the box small enough for a hierarchy?
pub fn fits(b: &Aabb) -> bool {
    b.min.abs().max(b.max.abs()).max_element() < REACH
}

impl Bvh {
    /// Hands the items whose boxes the ray meets in the range, and a few of their neighbours, to `visit`, near boxes first. `visit` gets the item's place
    /// and how far hits still count, and returns how far they count from now on, or breaks off.
    pub fn traverse(&self, ray: &Ray, range: Range, mut visit: impl FnMut(usize, f64) -> ControlFlow<(), f64>) {
        if self.nodes.is_empty() {
            return;
        }
        let flat = FlatRay::new(ray, range);
        let mut max = range.max;
        let mut stack = Stack::new();
        flat.push_children(&self.nodes[0], max, &mut stack);
        while let Some(Entry { near, child, count }) = stack.pop() {
            if f64::from(near) > max {
                continue;
            }
            if count == 0 {
                flat.push_children(&self.nodes[child as usize], max, &mut stack);
                continue;
            }
            for item in child..child + count {
                match visit(item as usize, max) {
                    ControlFlow::Continue(new_max) => max = new_max,
                    ControlFlow::Break(()) => return,
                }
            }
        }
    }

    /// Hands the items whose boxes hold the point, and a few of their neighbours, to `visit`, until it breaks off.
    pub fn around(&self, p: DVec3, mut visit: impl FnMut(usize) -> ControlFlow<()>) {
        let below: [Vec4; 3] = std::array::from_fn(|i| Vec4::splat(round_down(p[i])));
        let above: [Vec4; 3] = std::array::from_fn(|i| Vec4::splat(round_up(p[i])));
        let mut stack: SmallVec<[u32; 64]> = SmallVec::new();
        stack.extend((!self.nodes.is_empty()).then_some(0));
        while let Some(node) = stack.pop() {
            let node = &self.nodes[node as usize];
            let [lo, hi] = &node.planes;
            let within = |i: usize| lo[i].cmple(above[i]) & hi[i].cmpge(below[i]);
            let mask = (within(0) & within(1) & within(2)).bitmask();
            for slot in (0..4).filter(|&slot| mask >> slot & 1 == 1 && !node.is_unused(slot)) {
                let (child, count) = (node.child[slot], node.count[slot]);
                if count == 0 {
                    stack.push(child);
                } else if (child..child + count).try_for_each(|item| visit(item as usize)).is_break() {
                    return;
                }
            }
        }
    }
}

/// What is still to be looked at, the nearest last. (Room that is not written before it is used.)
type Stack = SmallVec<[Entry; STACK]>;

/// A piece of it: a node (`count` 0) or items, and where the ray enters its box at the earliest.
#[derive(Clone, Copy)]
struct Entry {
    near: f32,
    child: u32,
    count: u32,
}

impl Wide {
    const EMPTY: Wide = Wide { planes: [[Vec4::INFINITY; 3], [Vec4::NEG_INFINITY; 3]], child: [0; 4], count: [0; 4] };

    /// Its empty box keeps all rays out but those with directions that are infinite or no numbers. The root is nobody's child.
    fn is_unused(&self, slot: usize) -> bool {
        self.child[slot] | self.count[slot] == 0
    }

    fn set_box(&mut self, slot: usize, (lo, hi): (Vec3A, Vec3A)) {
        for axis in 0..3 {
            self.planes[0][axis][slot] = lo[axis];
            self.planes[1][axis][slot] = hi[axis];
        }
    }
}

/// The ray in single precision, four times side by side. Origins are rounded away from the ray's way, once for the planes
/// where it enters and once for those where it leaves, so that it seems to enter earlier and to leave later.
struct FlatRay {
    enter: [Vec4; 3],
    leave: [Vec4; 3],
    inverse: [Vec4; 3],
    /// 1 where the direction is negative: the ray enters through the upper plane.
    side: [usize; 3],
    min: Vec4,
}

impl FlatRay {
    fn new(ray: &Ray, range: Range) -> Self {
        let side: [usize; 3] = std::array::from_fn(|i| usize::from(ray.dir[i].is_sign_negative()));
        // More than the origin's rounding, and never zero: no plane is then at the distance 0, which 1/0 would spoil.
        let error = |i: usize| (ray.origin[i].abs() * 2.5e-7).max(1e-19) * if side[i] == 1 { -1.0 } else { 1.0 };
        let origin = |sign: f64| std::array::from_fn(|i| Vec4::splat((ray.origin[i] + sign * error(i)) as f32));
        let inverse = |i: usize| ((1.0 / ray.dir[i]) as f32).clamp(-f32::MAX, f32::MAX);
        Self {
            enter: origin(1.0),
            leave: origin(-1.0),
            inverse: std::array::from_fn(|i| Vec4::splat(inverse(i))),
            side,
            min: Vec4::splat(round_down(range.min)),
        }
    }

    /// Slab test of four boxes; pushes those that are met, the nearest last.
    fn push_children(&self, node: &Wide, max: f64, stack: &mut Stack) {
        let (near, met) = self.slabs(node, max);
        let near = near.to_array();
        let first = stack.len();
        let mut mask = met.bitmask();
        while mask != 0 {
            let slot = mask.trailing_zeros() as usize & 3;
            mask &= mask - 1;
            if node.is_unused(slot) {
                continue;
            }
            let entry = Entry { near: near[slot], child: node.child[slot], count: node.count[slot] };
            // Insertion sort: at most four.
            stack.push(entry);
            let mut at = stack.len() - 1;
            while at > first && stack[at - 1].near < stack[at].near {
                stack.swap(at - 1, at);
                at -= 1;
            }
        }
    }

    fn slabs(&self, node: &Wide, max: f64) -> (Vec4, BVec4A) {
        // (`& 1` tells the compiler that there are but two.)
        let at = |side: usize, i: usize, origin: &[Vec4; 3]| (node.planes[side & 1][i] - origin[i]) * self.inverse[i];
        let enter = |i: usize| at(self.side[i], i, &self.enter);
        let leave = |i: usize| at(self.side[i] ^ 1, i, &self.leave);
        let near = enter(0).max(enter(1)).max(enter(2)).max(self.min);
        let far = leave(0).min(leave(1)).min(leave(2)).min(Vec4::splat(round_up(max)));
        let near = near - near.abs() * SLACK;
        (near, near.cmple(far + far.abs() * SLACK))
    }
}

fn round_down(x: f64) -> f32 {
    let y = x as f32;
    if f64::from(y) > x { y.next_down() } else { y }
}

fn round_up(x: f64) -> f32 {
    -round_down(-x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boxes on a grid, some of them without thickness.
    fn grid() -> Vec<Aabb> {
        let cell = |i: usize| DVec3::new((i % 7) as f64, (i / 7 % 5) as f64, (i / 35) as f64) * 2.0;
        (0..200).map(|i| Aabb::from_corners(cell(i), cell(i) + DVec3::new(1.0, 1.0, (i % 3) as f64))).collect()
    }

    fn met(boxes: &[Aabb], ray: &Ray, range: Range) -> Vec<u32> {
        let (bvh, order) = Bvh::build(boxes.iter().copied());
        let mut found = vec![];
        bvh.traverse(ray, range, |i, max| {
            found.push(order[i]);
            ControlFlow::Continue(max)
        });
        found.sort();
        found
    }

    #[test]
    fn every_box_is_there_once() {
        let (_, mut order) = Bvh::build(grid().into_iter());
        order.sort();
        assert_eq!(order, (0..200).collect::<Vec<_>>());
        let same = vec![Aabb::from_corners(DVec3::ZERO, DVec3::ONE); 50];
        let through = Ray::new(DVec3::splat(-1.0), DVec3::ONE);
        assert_eq!(met(&same, &through, Range::ALL).len(), 50);
        assert!(met(&[], &through, Range::ALL).is_empty());
    }

    #[test]
    fn rays_along_faces_and_axes_meet_what_slabs_meet() {
        let boxes = grid();
        for k in 0..300 {
            let part = |m: usize| ((k * m) % 13) as f64 - 1.0;
            let dir = [DVec3::X, -DVec3::Y, DVec3::Z, DVec3::new(1.0, 0.5, 0.0), DVec3::new(-0.0, 1.0, -1.0)][k % 5];
            let ray = Ray::new(DVec3::new(part(3), part(5), part(7)), dir);
            for range in [Range::ALL, Range::FORWARD, Range { min: 0.5, max: 3.0 }] {
                let found = met(&boxes, &ray, range);
                for (i, b) in boxes.iter().enumerate() {
                    let really = b.slabs(&ray, range).is_some();
                    assert!(!really || found.binary_search(&(i as u32)).is_ok(), "misses box {i} by {ray:?}");
                }
                assert!(found.len() < 60, "{} of 200 boxes by {ray:?}", found.len());
            }
        }
    }

    #[test]
    fn never_too_deep() {
        // Each box is half as far and half as large as the one before, so that the heuristic peels off one at a time.
        let boxes: Vec<Aabb> =
            (0..3000).map(|i| DVec3::splat(0.5_f64.powi(i % 90))).map(|p| Aabb::from_corners(p, p * 1.1)).collect();
        let (bvh, _) = Bvh::build(boxes.iter().copied());
        let mut depth = vec![0; bvh.nodes.len()];
        for (i, node) in bvh.nodes.iter().enumerate() {
            for slot in (0..4).filter(|&s| node.count[s] == 0 && node.child[s] > 0) {
                depth[node.child[slot] as usize] = depth[i] + 1;
            }
        }
        assert!(*depth.iter().max().unwrap() < DEPTH, "{depth:?}");
        assert_eq!(met(&boxes, &Ray::new(DVec3::splat(-1.0), DVec3::ONE), Range::ALL).len(), 3000);
    }

    #[test]
    fn rounding_goes_outwards() {
        for x in [0.1, -0.1, 1.0, 1e-50, -1e-50, 16_777_217.0, 1e29, -1e39, f64::INFINITY] {
            assert!(f64::from(round_down(x)) <= x && f64::from(round_up(x)) >= x, "{x}");
        }
        assert_eq!((round_down(0.5), round_up(0.5)), (0.5, 0.5));
    }

    #[test]
    fn points() {
        let boxes = grid();
        let (bvh, order) = Bvh::build(boxes.iter().copied());
        for k in 0..200 {
            let p = DVec3::new((k % 27) as f64, (k % 19) as f64, (k % 25) as f64) * 0.5;
            let mut found = vec![];
            bvh.around(p, |i| {
                found.push(order[i] as usize);
                ControlFlow::Continue(())
            });
            found.sort();
            let mut want = (0..boxes.len()).filter(|&i| boxes[i].contains(p));
            assert!(want.all(|i| found.binary_search(&i).is_ok()) && found.len() < 30, "{p} {found:?}");
        }
    }

    #[test]
    fn breaks_off_and_shortens() {
        let boxes = grid();
        let ray = Ray::new(DVec3::new(-5.0, 0.5, 0.5), DVec3::X);
        let (bvh, _) = Bvh::build(boxes.iter().copied());
        let mut count = 0;
        bvh.traverse(&ray, Range::FORWARD, |_, _| {
            count += 1;
            ControlFlow::Break(())
        });
        assert_eq!(count, 1);
        let mut near = 0;
        bvh.traverse(&ray, Range::FORWARD, |_, _| {
            near += 1;
            ControlFlow::Continue(5.5)
        });
        assert!(near < met(&boxes, &ray, Range::FORWARD).len());
    }
}
