//! Building by the surface-area heuristic over bins (Wald, On fast construction of SAH-based bounding volume hierarchies,
//! 2007), always in the same order.

use super::{Bvh, DEPTH, Wide, round_down, round_up};
use crate::math::Aabb;
use glam::Vec3A;
use smallvec::SmallVec;

/// A node's child that holds no more items than this is not divided any further.
const LEAF: usize = 3;

impl Bvh {
    /// Over boxes that [`super::fits`] accepts; also returns which box comes at which place in its order.
    pub fn build(boxes: impl ExactSizeIterator<Item = Aabb>) -> (Bvh, Vec<u32>) {
        let mut bvh = Bvh { nodes: Vec::with_capacity(boxes.len() / 2 + 1) };
        let mut prims: Vec<Prim> = boxes.enumerate().map(|(i, b)| Prim::new(&b, i as u32)).collect();
        if !prims.is_empty() {
            bvh.build_node(&mut prims, 0, 0);
        }
        bvh.nodes.shrink_to_fit();
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
}

/// A box to be sorted in.
#[derive(Clone, Copy)]
struct Prim {
    lo: [f32; 3],
    hi: [f32; 3],
    index: u32,
}

impl Prim {
    fn new(b: &Aabb, index: u32) -> Self {
        Self { lo: b.min.to_array().map(round_down), hi: b.max.to_array().map(round_up), index }
    }

    fn lo(&self) -> Vec3A {
        self.lo.into()
    }

    fn hi(&self) -> Vec3A {
        self.hi.into()
    }

    /// Twice the middle.
    fn center(&self) -> Vec3A {
        self.lo() + self.hi()
    }
}

fn bounds(prims: &[Prim]) -> (Vec3A, Vec3A) {
    prims.iter().fold((Vec3A::INFINITY, Vec3A::NEG_INFINITY), |(lo, hi), p| (lo.min(p.lo()), hi.max(p.hi())))
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
        let one = Bin { lo: p.lo(), hi: p.hi(), count: 1 };
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
