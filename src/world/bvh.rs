//! A bounding volume hierarchy: four boxes to a node, in single precision, rounded so that it never misses what double
//! precision would hit.
//!
//! Built by the surface-area heuristic over bins (Wald, On fast construction of SAH-based bounding volume hierarchies,
//! 2007), always in the same order. It knows boxes and their numbers, nothing of what is in them.

use crate::math::{Aabb, DVec3, Range, Ray};
use glam::{BVec4A, Vec3A, Vec4};
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Boxes whose corners reach further than this are not for a hierarchy in single precision.
const REACH: f64 = 1e30;
/// A node's child that holds no more items than this is not divided any further.
const LEAF: usize = 3;
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
    /// Over boxes that [`fits`] accepts; also returns which box comes at which place in its order.
    pub fn build(boxes: &[Aabb]) -> (Bvh, Vec<u32>) {
        let mut prims: Vec<Prim> = boxes.iter().enumerate().map(|(i, b)| Prim::new(b, i as u32)).collect();
        let mut bvh = Bvh { nodes: Vec::with_capacity(boxes.len() / 2 + 1) };
        if !prims.is_empty() {
            bvh.build_node(&mut prims, 0, 0);
        }
        (bvh, prims.into_iter().map(|p| p.index).collect())
    }

    /// Divides the items into four, then each of them; returns the node's number.
    fn build_node(&mut self, prims: &mut [Prim], first: usize, depth: usize) -> u32 {
        let number = self.nodes.len();
        self.nodes.push(Wide::EMPTY);
        let halve = must_halve(prims.len(), depth);
        let mut cuts: SmallVec<[(usize, usize, f32); 4]> = SmallVec::new();
        cuts.push((0, prims.len(), f32::INFINITY));
        while cuts.len() < 4 {
            // Divide the piece that costs most.
            let costly =
                (0..cuts.len()).filter(|&i| cuts[i].1 - cuts[i].0 > 1).max_by(|&a, &b| cuts[a].2.total_cmp(&cuts[b].2));
            let Some(piece) = costly else { break };
            let (lo, hi, _) = cuts[piece];
            let mid = lo + divide(&mut prims[lo..hi], halve);
            let size = |piece: &[Prim]| if halve { 1.0 } else { half_area(piece) };
            let cost = |lo: usize, hi: usize| size(&prims[lo..hi]) * (hi - lo) as f32;
            cuts[piece] = (lo, mid, cost(lo, mid));
            cuts.insert(piece + 1, (mid, hi, cost(mid, hi)));
        }
        for (slot, &(lo, hi, _)) in cuts.iter().enumerate() {
            self.nodes[number].set_box(slot, bounds(&prims[lo..hi]));
            let (child, count) = if hi - lo <= LEAF {
                ((first + lo) as u32, (hi - lo) as u32)
            } else {
                (self.build_node(&mut prims[lo..hi], first + lo, depth + 1), 0)
            };
            self.nodes[number].child[slot] = child;
            self.nodes[number].count[slot] = count;
        }
        number as u32
    }

    /// Hands the items whose boxes the ray meets in the range, and a few of their neighbours, to `visit`, near boxes first. `visit` gets the item's place
    /// and how far hits still count, and returns how far they count from now on, or breaks off.
    pub fn traverse(&self, ray: &Ray, range: Range, mut visit: impl FnMut(usize, f64) -> ControlFlow<(), f64>) {
        if self.nodes.is_empty() {
            return;
        }
        let flat = FlatRay::new(ray, range);
        let mut max = range.max;
        let mut stack = [Entry { near: f32::NEG_INFINITY, child: 0, count: 0 }; STACK];
        let mut height = 1;
        while height > 0 {
            height -= 1;
            let Entry { near, child, count } = stack[height];
            if f64::from(near) > max {
                continue;
            }
            if count == 0 {
                height = flat.push_children(&self.nodes[child as usize], max, &mut stack, height);
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

/// What is still to be looked at: a node (`count` 0) or items, and where the ray enters its box at the earliest.
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

    /// Slab test of four boxes; pushes those that are met, the nearest last, and returns the new height.
    fn push_children(&self, node: &Wide, max: f64, stack: &mut [Entry; STACK], first: usize) -> usize {
        let (near, met) = self.slabs(node, max);
        let near = near.to_array();
        let mut height = first;
        let mut mask = met.bitmask();
        while mask != 0 {
            let slot = mask.trailing_zeros() as usize & 3;
            mask &= mask - 1;
            if node.is_unused(slot) {
                continue;
            }
            let entry = Entry { near: near[slot], child: node.child[slot], count: node.count[slot] };
            // Insertion sort: at most four.
            let mut at = height;
            while at > first && stack[at - 1].near < entry.near {
                stack[at] = stack[at - 1];
                at -= 1;
            }
            stack[at] = entry;
            height += 1;
        }
        height
    }

    fn slabs(&self, node: &Wide, max: f64) -> (Vec4, BVec4A) {
        let at = |side: usize, i: usize, origin: &[Vec4; 3]| (node.planes[side][i] - origin[i]) * self.inverse[i];
        let enter = |i: usize| at(self.side[i], i, &self.enter);
        let leave = |i: usize| at(1 - self.side[i], i, &self.leave);
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

/// A box to be sorted in.
#[derive(Clone, Copy)]
struct Prim {
    lo: Vec3A,
    hi: Vec3A,
    index: u32,
}

impl Prim {
    fn new(b: &Aabb, index: u32) -> Self {
        let (lo, hi) = (b.min.to_array().map(round_down), b.max.to_array().map(round_up));
        Self { lo: lo.into(), hi: hi.into(), index }
    }

    /// Twice the middle.
    fn center(&self) -> Vec3A {
        self.lo + self.hi
    }
}

fn bounds(prims: &[Prim]) -> (Vec3A, Vec3A) {
    prims.iter().fold((Vec3A::INFINITY, Vec3A::NEG_INFINITY), |(lo, hi), p| (lo.min(p.lo), hi.max(p.hi)))
}

fn half_area(prims: &[Prim]) -> f32 {
    area(bounds(prims))
}

fn area((lo, hi): (Vec3A, Vec3A)) -> f32 {
    let s = (hi - lo).max(Vec3A::ZERO);
    s.x * s.y + s.y * s.z + s.z * s.x
}

#[derive(Clone, Copy)]
struct Bin {
    lo: Vec3A,
    hi: Vec3A,
    count: u32,
}

impl Bin {
    const EMPTY: Bin = Bin { lo: Vec3A::INFINITY, hi: Vec3A::NEG_INFINITY, count: 0 };

    fn join(self, other: Bin) -> Bin {
        Bin { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi), count: self.count + other.count }
    }

    fn cost(&self) -> f32 {
        area((self.lo, self.hi)) * self.count as f32
    }
}

/// Orders the items in two groups, neither empty, at the cheapest place; returns where the second one starts.
fn divide(prims: &mut [Prim], halve: bool) -> usize {
    match prims.len() {
        n if halve => n / 2,
        0..=32 => divide_by_bins::<6>(prims),
        _ => divide_by_bins::<16>(prims),
    }
}

/// The cheapest of the places between so many bins along each axis.
fn divide_by_bins<const BINS: usize>(prims: &mut [Prim]) -> usize {
    let none = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
    let (lo, hi) = prims.iter().fold(none, |(lo, hi), p| (lo.min(p.center()), hi.max(p.center())));
    let extent = hi - lo;
    // All in one place: any half is as good as the other.
    if extent.max_element() <= 0.0 || !extent.is_finite() {
        return prims.len() / 2;
    }
    let scale = Vec3A::select(extent.cmpgt(Vec3A::ZERO), Vec3A::splat(BINS as f32 * 0.9999) / extent, Vec3A::ZERO);
    let bin_of = |p: &Prim| ((p.center() - lo) * scale).to_array().map(|x| (x as usize).min(BINS - 1));
    let mut bins = [[Bin::EMPTY; BINS]; 3];
    for p in prims.iter() {
        let one = Bin { lo: p.lo, hi: p.hi, count: 1 };
        for (bins, bin) in bins.iter_mut().zip(bin_of(p)) {
            bins[bin] = bins[bin].join(one);
        }
    }
    let best = (0..3).map(|axis| (axis, cheapest_cut(&bins[axis]))).min_by(|a, b| a.1.1.total_cmp(&b.1.1));
    match best {
        Some((axis, (cut, cost))) if cost.is_finite() => {
            let mid = partition(prims, |p| bin_of(p)[axis] < cut);
            if mid == 0 || mid == prims.len() { prims.len() / 2 } else { mid }
        }
        _ => prims.len() / 2,
    }
}

/// Are the levels that are left just enough for so many items, if each divides them by four?
fn must_halve(count: usize, depth: usize) -> bool {
    let levels = count.div_ceil(LEAF).max(1).ilog2() as usize / 2 + 2;
    depth + levels >= DEPTH
}

/// The number of bins on the left of the best cut, and its cost; infinite where all items are in one bin.
fn cheapest_cut<const BINS: usize>(bins: &[Bin; BINS]) -> (usize, f32) {
    // Cost of everything from bin i on.
    let mut right = [0.0; BINS];
    let mut sum = Bin::EMPTY;
    for i in (1..BINS).rev() {
        sum = sum.join(bins[i]);
        right[i] = if sum.count > 0 { sum.cost() } else { f32::INFINITY };
    }
    let mut best = (0, f32::INFINITY);
    let mut sum = Bin::EMPTY;
    for cut in 1..BINS {
        sum = sum.join(bins[cut - 1]);
        let cost = sum.cost() + right[cut];
        if sum.count > 0 && cost < best.1 {
            best = (cut, cost);
        }
    }
    best
}

/// Moves the items that belong to the left before the others; returns how many they are.
fn partition(prims: &mut [Prim], left: impl Fn(&Prim) -> bool) -> usize {
    let (mut i, mut j) = (0, prims.len());
    while i < j {
        if left(&prims[i]) {
            i += 1;
        } else {
            j -= 1;
            prims.swap(i, j);
        }
    }
    i
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
        let (bvh, order) = Bvh::build(boxes);
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
        let (_, mut order) = Bvh::build(&grid());
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
        let (bvh, _) = Bvh::build(&boxes);
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
        let (bvh, order) = Bvh::build(&boxes);
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
        let (bvh, _) = Bvh::build(&boxes);
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
