//! Building by the surface-area heuristic over bins (Wald, On fast construction of SAH-based bounding volume hierarchies,
//! 2007), always in the same order.

use super::{Bvh, Child, DEPTH, Kind, WIDTH, Wide, round_down, round_up};
use crate::math::Aabb;
use glam::Vec3A;
use smallvec::SmallVec;
use std::ops::Range;

/// A node's child that holds no more items than this is not divided any further.
const LEAF: usize = 3;
/// Of more items than this, only cuts along the longest axis are weighed.
const LARGE: usize = 1024;
/// The same where so many items are tested at once.
pub const PACK: usize = 4;

impl Bvh {
    /// Over boxes that [`super::fits`] accepts; also returns which box comes at which place in its order.
    pub fn build(boxes: impl ExactSizeIterator<Item = Aabb>) -> (Bvh, Vec<u32>) {
        Build { bvh: Bvh::default(), leaf: LEAF, pack: 1 }.run(boxes)
    }

    /// The same over packs of up to [`PACK`] boxes, which are the items of the hierarchy; also returns the places of each pack's boxes in
    /// the order.
    pub fn build_packs(boxes: impl ExactSizeIterator<Item = Aabb>) -> (Bvh, Vec<u32>, Vec<Range<u32>>) {
        let (mut bvh, order) = Build { bvh: Bvh::default(), leaf: PACK, pack: PACK }.run(boxes);
        let mut packs = Vec::with_capacity(order.len().div_ceil(2));
        for child in bvh.nodes.iter_mut().flat_map(|node| &mut node.child).filter(|child| **child != Child::NONE) {
            if let Kind::Items(items) = child.kind() {
                *child = Child::items(packs.len(), 1);
                packs.push(items.start as u32..items.end as u32);
            }
        }
        packs.shrink_to_fit();
        (bvh, order, packs)
    }
}

/// A hierarchy that is being built.
struct Build {
    bvh: Bvh,
    /// Pieces with so few items are not divided again.
    leaf: usize,
    /// So many items cost as much as one.
    pack: usize,
}

/// Items that are to be divided: places, and the boxes around them and around their middles.
#[derive(Clone)]
struct Piece {
    items: Range<usize>,
    around: Around,
    /// What it costs a ray to look at them all.
    cost: f32,
}

impl Build {
    fn run(mut self, boxes: impl ExactSizeIterator<Item = Aabb>) -> (Bvh, Vec<u32>) {
        let mut prims: Vec<Prim> = boxes.enumerate().map(|(i, b)| Prim::new(&b, i as u32)).collect();
        let mut around = Around::EMPTY;
        prims.iter().for_each(|prim| around.add(prim));
        if !prims.is_empty() {
            self.bvh.nodes.reserve(prims.len() / self.leaf / 4 + 1);
            let all = Piece { items: 0..prims.len(), around, cost: f32::INFINITY };
            self.build_node(&mut prims, all, 0);
        }
        self.bvh.nodes.shrink_to_fit();
        (self.bvh, prims.into_iter().map(|p| p.index).collect())
    }

    /// Divides the items into eight, then each of them; returns the node's number.
    fn build_node(&mut self, prims: &mut [Prim], all: Piece, depth: usize) -> usize {
        let number = self.bvh.nodes.len();
        self.bvh.nodes.push(Wide::EMPTY);
        let halve = must_halve(all.items.len(), self.leaf, depth);
        let mut pieces: SmallVec<[Piece; WIDTH]> = SmallVec::new();
        pieces.push(all);
        while pieces.len() < WIDTH {
            // Divide the piece that costs most.
            let open = (0..pieces.len()).filter(|&i| pieces[i].items.len() > self.pack);
            let Some(costly) = open.max_by(|&a, &b| pieces[a].cost.total_cmp(&pieces[b].cost)) else { break };
            let Piece { items: Range { start, end }, around, .. } = pieces[costly].clone();
            let (count, halves) = self.divide(&mut prims[start..end], &around, halve);
            let mid = start + count;
            let piece = |items: Range<usize>, around: Around| {
                let area = if halve { 1.0 } else { area(around.lo, around.hi) };
                Piece { cost: area * items.len().div_ceil(self.pack) as f32, items, around }
            };
            let [left, right] = halves;
            pieces[costly] = piece(start..mid, left);
            pieces.insert(costly + 1, piece(mid..end, right));
        }
        for (slot, piece) in pieces.into_iter().enumerate() {
            let bounds = (piece.around.lo, piece.around.hi);
            let child = match piece.items.len() {
                count if count <= self.leaf => Child::items(piece.items.start, count),
                _ => Child::node(self.build_node(prims, piece, depth + 1)),
            };
            self.bvh.nodes[number].set(slot, bounds, child);
        }
        number
    }

    /// Orders the items in two groups, neither empty, at the cheapest place; returns where the second one starts, and what is around
    /// each.
    fn divide(&self, prims: &mut [Prim], around: &Around, halve: bool) -> (usize, [Around; 2]) {
        let cut = match prims.len() {
            _ if halve => None,
            0..=32 => Cut::find::<6>(prims, around, self.pack),
            _ => Cut::find::<16>(prims, around, self.pack),
        };
        if let Some(cut) = cut {
            let (count, halves) = partition(prims, |prim| cut.is_left(prim));
            if count > 0 && count < prims.len() {
                return (count, halves);
            }
        }
        let count = prims.len() / 2;
        let mut halves = [Around::EMPTY; 2];
        prims.iter().enumerate().for_each(|(i, prim)| halves[usize::from(i >= count)].add(prim));
        (count, halves)
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

/// The box around some items, and the one around their middles.
#[derive(Clone, Copy)]
struct Around {
    lo: Vec3A,
    hi: Vec3A,
    first: Vec3A,
    last: Vec3A,
}

impl Around {
    const EMPTY: Around =
        Around { lo: Vec3A::INFINITY, hi: Vec3A::NEG_INFINITY, first: Vec3A::INFINITY, last: Vec3A::NEG_INFINITY };

    #[inline]
    fn add(&mut self, prim: &Prim) {
        let (lo, hi, center) = (prim.lo(), prim.hi(), prim.center());
        *self = Around {
            lo: self.lo.min(lo),
            hi: self.hi.max(hi),
            first: self.first.min(center),
            last: self.last.max(center),
        };
    }
}

fn area(lo: Vec3A, hi: Vec3A) -> f32 {
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

    #[inline]
    fn join(self, other: Bin) -> Bin {
        Bin { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi), count: self.count + other.count }
    }

    fn cost(&self, pack: u32) -> f32 {
        area(self.lo, self.hi) * self.count.div_ceil(pack) as f32
    }
}

/// A plane between bins along an axis.
struct Cut {
    axis: usize,
    from: f32,
    scale: f32,
    bin: f32,
}

impl Cut {
    /// The cheapest of the places between so many bins along each axis; `None` if any half is as good as the other.
    fn find<const BINS: usize>(prims: &[Prim], around: &Around, pack: usize) -> Option<Cut> {
        let extent = around.last - around.first;
        if extent.max_element() <= 0.0 || !extent.is_finite() {
            return None;
        }
        let scale = Vec3A::select(extent.cmpgt(Vec3A::ZERO), Vec3A::splat(BINS as f32 * 0.9999) / extent, Vec3A::ZERO);
        // Where there are many, a cut across the longest extent is as good as any.
        let axes = if prims.len() > LARGE { extent.max_position()..extent.max_position() + 1 } else { 0..3 };
        let mut bins = [[Bin::EMPTY; BINS]; 3];
        for prim in prims {
            let one = Bin { lo: prim.lo(), hi: prim.hi(), count: 1 };
            let places = ((prim.center() - around.first) * scale).to_array();
            for axis in axes.clone() {
                let bin = &mut bins[axis][(places[axis] as i32 as usize).min(BINS - 1)];
                *bin = bin.join(one);
            }
        }
        let cuts = axes.map(|axis| (axis, cheapest_cut(&bins[axis], pack as u32)));
        let (axis, (bin, cost)) = cuts.min_by(|a, b| a.1.1.total_cmp(&b.1.1))?;
        let cut = Cut { axis, from: around.first[axis], scale: scale[axis], bin: bin as f32 };
        cost.is_finite().then_some(cut)
    }

    #[inline]
    fn is_left(&self, prim: &Prim) -> bool {
        (prim.lo[self.axis] + prim.hi[self.axis] - self.from) * self.scale < self.bin
    }
}

/// Are the levels that are left just enough for so many items, if each divides them by eight?
fn must_halve(count: usize, leaf: usize, depth: usize) -> bool {
    let levels = count.div_ceil(leaf).max(1).ilog2() as usize / 3 + 2;
    depth + levels >= DEPTH
}

/// The number of bins on the left of the best cut, and its cost; infinite where all items are in one bin.
fn cheapest_cut<const BINS: usize>(bins: &[Bin; BINS], pack: u32) -> (usize, f32) {
    // Cost of everything from bin i on.
    let mut right = [0.0; BINS];
    let mut sum = Bin::EMPTY;
    for i in (1..BINS).rev() {
        sum = sum.join(bins[i]);
        right[i] = if sum.count > 0 { sum.cost(pack) } else { f32::INFINITY };
    }
    let mut best = (0, f32::INFINITY);
    let mut sum = Bin::EMPTY;
    for cut in 1..BINS {
        sum = sum.join(bins[cut - 1]);
        let cost = sum.cost(pack) + right[cut];
        if sum.count > 0 && cost < best.1 {
            best = (cut, cost);
        }
    }
    best
}

/// Moves the items that belong to the left before the others; returns how many they are, and what is around both.
fn partition(prims: &mut [Prim], left: impl Fn(&Prim) -> bool) -> (usize, [Around; 2]) {
    let (mut i, mut j) = (0, prims.len());
    let [mut before, mut behind] = [Around::EMPTY; 2];
    while i < j {
        let prim = prims[i];
        if left(&prim) {
            before.add(&prim);
            i += 1;
        } else {
            behind.add(&prim);
            j -= 1;
            prims.swap(i, j);
        }
    }
    (i, [before, behind])
}
