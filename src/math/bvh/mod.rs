//! A bounding volume hierarchy: eight boxes per node, in single precision, rounded so that it never misses a hit of
//! double precision.
//!
//! The hierarchy contains boxes and indices; its users store the items.

mod build;
mod flat_ray;
mod node;
mod pack;
mod packet;
mod shaft;
mod split;
mod triangles;

pub use shaft::Shaft;
pub use triangles::Triangles;

use crate::math::{Aabb, DVec3, Range, Ray};
use flat_ray::FlatRay;
use glam::Vec4;
use node::{Child, Kind, WIDTH, Wide};
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Maximum coordinate of the boxes in a BVH, whose precision is single.
const REACH: f64 = 1e30;
/// Number of entries of the traversal's stack that need no allocation: each level of the BVH leaves at most seven
/// entries, and usually one.
const STACK: usize = 32;
/// Relative rounding error of the slab test in single precision: three operations at each end, each with an error of
/// 2⁻²⁴, and a reserve.
const SLACK: f64 = 5e-7;

/// Bounding volume hierarchy with eight children a node, over boxes 0 … n-1 in the order that [`Bvh::build`] returned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bvh {
    nodes: Vec<Wide>,
}

/// True if the box is within the single-precision range of a BVH.
pub fn fits_single_precision(b: &Aabb) -> bool {
    b.min.abs().max(b.max.abs()).max_element() < REACH
}

/// Traverses a BVH with one of the two implementations of `FlatRay::new` and `slabs`, portable or AVX2.
macro_rules! walk {
    ($flat_ray:path, $slabs:path, $bvh:ident, $ray:ident, $range:ident, $fetch:expr, $visit:ident) => {{
        let flat = $flat_ray($ray, $range, &$bvh.nodes[0]);
        let (mut max, mut flat_max) = ($range.max, pad_up($range.max));
        // (Entries whose bits are all 0 are cleared many at a time.)
        let mut stack = [Entry { near: 0.0, child: Child::node(0) }; STACK];
        let mut open = 0;
        // Overflow of the stack.
        let mut below = vec![];
        let mut child = Child::node(0);
        loop {
            match child.kind() {
                Kind::Node(number) => {
                    let node = &$bvh.nodes[number];
                    let (mask, near) = $slabs(node, &flat, flat_max);
                    if mask != 0 {
                        if open > STACK - WIDTH {
                            below.extend_from_slice(&stack[..open]);
                            open = 0;
                        }
                        let before = open;
                        (child, open) = nearest_child_pushing_others(node, mask, &near, &mut stack, open);
                        for entry in &stack[before..open] {
                            match entry.child.kind() {
                                Kind::Node(number) => node::prefetch(&$bvh.nodes, number),
                                Kind::Items(items) => $fetch(items.start),
                            }
                        }
                        continue;
                    }
                }
                Kind::Items(items) => {
                    for item in items {
                        match $visit(item, max) {
                            ControlFlow::Continue(new_max) => max = new_max,
                            ControlFlow::Break(()) => return,
                        }
                    }
                    flat_max = pad_up(max);
                }
            }
            loop {
                let entry = match open.checked_sub(1) {
                    Some(last) => stack[last],
                    None => match below.pop() {
                        Some(entry) => entry,
                        None => return,
                    },
                };
                open = open.saturating_sub(1);
                if entry.near <= flat_max {
                    child = entry.child;
                    break;
                }
            }
        }
    }};
}
use walk;

/// Visits the children of a BVH's only node with one of the two implementations, near ones first. (A scene of up
/// to eight objects has one node; a traversal with a stack takes a quarter more instructions there.)
macro_rules! visit_only_node {
    ($flat_ray:path, $slabs:path, $node:expr, $ray:ident, $range:ident, $visit:ident) => {{
        let flat = $flat_ray($ray, $range, $node);
        let mut max = $range.max;
        let (mut mask, near) = $slabs($node, &flat, pad_up(max));
        while mask != 0 {
            let slot = nearest_slot(mask, &near);
            mask &= !(1 << slot);
            if near[slot] > pad_up(max) {
                return;
            }
            if let Kind::Items(items) = $node.child[slot].kind() {
                for item in items {
                    match $visit(item, max) {
                        ControlFlow::Continue(new_max) => max = new_max,
                        ControlFlow::Break(()) => return,
                    }
                }
            }
        }
    }};
}

/// Returns the child of a BVH node that a ray enters first among those in a non-empty mask.
#[inline(always)]
fn nearest_slot(mask: u32, near: &[f32; WIDTH]) -> usize {
    let slot = |mask: u32| mask.trailing_zeros() as usize & (WIDTH - 1);
    let (mut nearest, mut others) = (slot(mask), mask & (mask - 1));
    while others != 0 {
        if near[slot(others)] < near[nearest] {
            nearest = slot(others);
        }
        others &= others - 1;
    }
    nearest
}

/// Position of an item in the BVH's order.
type ItemPosition = usize;
/// End of the interval of `t` in which hits are still of interest.
type RangeEnd = f64;

impl Bvh {
    /// Calls `visit` with the items of the BVH whose boxes the ray hits in the range, and a few of their neighbours,
    /// near boxes first. `visit` receives the item's position and the current end of the range, and returns the new
    /// end, or breaks. A ray with a coordinate that is not finite hits nothing.
    pub fn traverse(
        &self,
        ray: &Ray,
        range: Range,
        visit: impl FnMut(ItemPosition, RangeEnd) -> ControlFlow<(), RangeEnd>,
    ) {
        if self.nodes.is_empty() || !ray.is_finite() {
            return;
        }
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has the feature that the function needs.
            #[expect(unsafe_code, reason = "the compiler can't know the processor")]
            return unsafe { self.traverse_avx2(ray, range, visit) };
        }
        self.traverse_portably(ray, range, visit);
    }

    fn traverse_portably(
        &self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(ItemPosition, RangeEnd) -> ControlFlow<(), RangeEnd>,
    ) {
        if let [only] = &*self.nodes {
            visit_only_node!(FlatRay::new, node::slabs, only, ray, range, visit);
            return;
        }
        walk!(FlatRay::new, node::slabs, self, ray, range, |_| (), visit);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn traverse_avx2(
        &self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(ItemPosition, RangeEnd) -> ControlFlow<(), RangeEnd>,
    ) {
        if let [only] = &*self.nodes {
            visit_only_node!(flat_ray::avx2::flat_ray, node::avx2::slabs, only, ray, range, visit);
            return;
        }
        walk!(flat_ray::avx2::flat_ray, node::avx2::slabs, self, ray, range, |_| (), visit);
    }

    /// Calls `visit` with the items of the BVH whose boxes contain the point, and with the other items of their leaves,
    /// until it breaks.
    pub fn visit_items_near_point(&self, p: DVec3, mut visit: impl FnMut(usize) -> ControlFlow<()>) {
        let below = p.to_array().map(|x| Vec4::splat(round_down(x)));
        let above = p.to_array().map(|x| Vec4::splat(round_up(x)));
        let mut stack: SmallVec<[Child; 64]> = SmallVec::new();
        stack.extend((!self.nodes.is_empty()).then_some(Child::node(0)));
        while let Some(child) = stack.pop() {
            match child.kind() {
                Kind::Node(number) => {
                    let node = &self.nodes[number];
                    let [lower, upper] = &node.planes;
                    for half in 0..2 {
                        let within = |i: usize| lower[i][half].cmple(above[i]) & upper[i][half].cmpge(below[i]);
                        let mask = (within(0) & within(1) & within(2)).bitmask();
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

/// A node or item that the traversal of a BVH is to visit, and the earliest `t` at which the ray enters its box.
#[derive(Clone, Copy)]
struct Entry {
    near: f32,
    child: Child,
}

/// Returns the nearest child of a BVH node among those in a non-empty mask, and pushes the others onto the stack, near
/// ones last. Also returns the new length of the stack.
#[inline(always)]
fn nearest_child_pushing_others(
    node: &Wide,
    mut mask: u32,
    near: &[f32; WIDTH],
    stack: &mut [Entry; STACK],
    stack_length: usize,
) -> (Child, usize) {
    let mut take = || {
        let slot = mask.trailing_zeros() as usize & (WIDTH - 1);
        mask &= mask - 1;
        (Entry { near: near[slot], child: node.child[slot] }, mask != 0)
    };
    let (mut first, more) = take();
    if !more {
        return (first.child, stack_length);
    }
    let mut end = stack_length;
    loop {
        let (mut entry, more) = take();
        if entry.near < first.near {
            std::mem::swap(&mut entry, &mut first);
        }
        // Insertion sort: at most seven entries, usually one.
        let mut at = end;
        while at > stack_length && stack[at - 1].near < entry.near {
            stack[at] = stack[at - 1];
            at -= 1;
        }
        stack[at] = entry;
        end += 1;
        if !more {
            return (first.child, end);
        }
    }
}

/// Enlarges a distance by the rounding error of the slab test and of the distance itself.
#[inline(always)]
fn pad_up(max: f64) -> f32 {
    let max = max as f32;
    max + max.abs() * SLACK as f32 + f32::MIN_POSITIVE
}

fn pad_down(min: f64) -> f32 {
    -pad_up(-min)
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

    /// Boxes on a grid, some of them flat.
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
    fn rays_along_faces_and_axes_match_exact_slabs() {
        // All boxes, and as many as one node holds.
        assert_eq!(Bvh::build(grid()[..8].iter().copied()).0.nodes.len(), 1);
        for (boxes, most) in [(grid(), 59), (grid()[..8].to_vec(), 2)] {
            rays_match_exact_slabs(&boxes, most);
        }
    }

    /// Checks that rays meet all boxes that they hit, and at most `most` of them.
    fn rays_match_exact_slabs(boxes: &[Aabb], most: usize) {
        for k in 0..300 {
            let part = |m: usize| ((k * m) % 13) as f64 - 1.0;
            let dir = [DVec3::X, -DVec3::Y, DVec3::Z, DVec3::new(1.0, 0.5, 0.0), DVec3::new(-0.0, 1.0, -1.0)][k % 5];
            let ray = Ray::new(DVec3::new(part(3), part(5), part(7)), dir);
            for range in [Range::ALL, Range::FORWARD, Range { min: 0.5, max: 3.0 }] {
                let found = met(boxes, &ray, range);
                for (i, b) in boxes.iter().enumerate() {
                    let really = b.slabs(&ray, range).is_some();
                    assert!(!really || found.binary_search(&(i as u32)).is_ok(), "misses box {i} by {ray:?}");
                }
                assert!(found.len() <= most, "{} of {} boxes by {ray:?}", found.len(), boxes.len());
            }
        }
    }

    /// Numbers beyond single precision: the ray hits nothing, or what the exact slabs hit, and both implementations
    /// agree.
    #[test]
    fn rays_beyond_single_precision() {
        let (bvh, _) = Bvh::build(grid().into_iter());
        let far = [1e308, 1.7e308, 1e39, 3e38, 1e-308];
        let ways = [DVec3::Z, DVec3::new(1e-300, 0.0, 1.0), DVec3::splat(1e308), DVec3::splat(-1e-308), DVec3::ZERO];
        for k in 0..far.len() * 2 * 3 {
            let axis = DVec3::AXES[k % 3] * if k % 2 == 0 { 1.0 } else { -1.0 };
            let origin = axis * far[k / 6];
            for (dir, range) in ways.into_iter().flat_map(|dir| [Range::ALL, Range::FORWARD].map(|range| (dir, range)))
            {
                let ray = Ray::new(origin, dir);
                let (mut found, mut plainly) = (vec![], vec![]);
                bvh.traverse(&ray, range, |i, max| {
                    found.push(i);
                    ControlFlow::Continue(max)
                });
                bvh.traverse_portably(&ray, range, |i, max| {
                    plainly.push(i);
                    ControlFlow::Continue(max)
                });
                assert!(found == plainly && found.iter().all(|i| *i < 200), "{ray:?}");
            }
        }
    }

    #[test]
    fn never_too_deep() {
        // Each box is half as far and half as large as the one before, so that the heuristic splits off one at a time.
        let boxes: Vec<Aabb> =
            (0..3000).map(|i| DVec3::splat(0.5_f64.powi(i % 90))).map(|p| Aabb::from_corners(p, p * 1.1)).collect();
        let (bvh, _) = Bvh::build(boxes.iter().copied());
        let mut depth = vec![0; bvh.nodes.len()];
        for (i, node) in bvh.nodes.iter().enumerate() {
            for child in node.child.iter().filter(|child| **child != Child::NONE) {
                if let Kind::Node(number) = child.kind() {
                    depth[number] = depth[i] + 1;
                }
            }
        }
        assert!(*depth.iter().max().unwrap() < 24, "{depth:?}");
        assert_eq!(met(&boxes, &Ray::new(DVec3::splat(-1.0), DVec3::ONE), Range::ALL).len(), 3000);
    }

    #[test]
    fn full_stacks_lose_nothing() {
        // All boxes contain the origin: all are visited, and the stack overflows.
        let boxes: Vec<Aabb> =
            (1..5000).map(|i| DVec3::new(1.0, 0.5, 2.0) * f64::from(i)).map(|p| Aabb::from_corners(-p, p)).collect();
        for dir in [DVec3::ONE, DVec3::NEG_X, DVec3::new(0.3, -0.5, 0.0)] {
            assert_eq!(met(&boxes, &Ray::new(DVec3::ZERO, dir), Range::ALL).len(), boxes.len());
        }
    }

    #[test]
    fn immense_and_tiny_directions() {
        for length in [1e-300, 1e-40, 1e-6, 1e6, 1e40, 1e300] {
            let ray = Ray::new(DVec3::new(-5.0, 0.5, 0.0), DVec3::X * length);
            for range in [Range::ALL, Range::FORWARD] {
                assert!(met(&grid(), &ray, range).len() >= 7, "{length} {range:?}");
            }
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[test]
    fn avx2_visits_the_same_boxes() {
        if !is_x86_feature_detected!("avx2") {
            return;
        }
        let (bvh, _) = Bvh::build(grid().into_iter());
        for k in 0..500 {
            let at = |m: usize| (k * m % 97) as f64 / 9.7;
            let ray = Ray::new(DVec3::new(at(13), at(29), at(31)), DVec3::new(at(7) - 5.0, at(11) - 5.0, at(5) - 4.0));
            for range in [Range::ALL, Range::FORWARD] {
                let (mut plain, mut wide) = (vec![], vec![]);
                bvh.traverse_portably(&ray, range, |i, max| {
                    plain.push(i);
                    ControlFlow::Continue(max)
                });
                let visit = |i, max| {
                    wide.push(i);
                    ControlFlow::Continue(max)
                };
                // SAFETY: the processor has the feature.
                #[expect(unsafe_code, reason = "as above")]
                unsafe {
                    bvh.traverse_avx2(&ray, range, visit);
                }
                assert_eq!(plain, wide, "{ray:?}");
            }
        }
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
            bvh.visit_items_near_point(p, |i| {
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
