//! Construction: first a binary tree by the surface-area heuristic over bins (Wald, On fast construction of SAH-based
//! bounding volume hierarchies, 2007), then nodes with eight children, chosen from the binary tree to minimise the
//! expected number of node visits (Ylitie, Karras and Laine, Efficient incoherent ray traversal on GPUs through
//! compressed wide BVHs, 2017, section 3.1). The result is deterministic.

use super::Bvh;
use super::node::{Child, WIDTH, Wide};
use super::split::{Around, Prim, half_surface_area, split_boxes};
use crate::math::{Aabb, cancel, fork};
use glam::Vec3A;
use smallvec::SmallVec;
use std::array::from_fn;
use std::ops::Range;

/// Number of levels from the root of the binary tree that are split at the cheapest plane; deeper levels are split in
/// halves, which bounds the tree's depth.
const COST_SPLIT_LEVELS: usize = 64;
/// Cost of intersecting a single item of the BVH, relative to visiting a node.
const ITEM: f32 = 1.5;
/// Cost of intersecting a pack of items of the BVH, relative to visiting a node.
const PACK: f32 = 1.0;
/// Maximum number of boxes in a pack of a BVH.
const LARGEST: usize = 8;
/// Number of boxes of a BVH node below which a build does not poll for cancellation.
const PRIMS_BETWEEN_POLLS: usize = 1 << 14;
/// Number of boxes of a BVH from which two threads build its halves.
const PRIMS_FOR_TWO_THREADS: usize = 1 << 14;
/// Minimum number of boxes that one thread prepares in a row.
const PRIMS_FOR_A_THREAD: usize = 1 << 13;
/// Maximum number of items in a leaf of the BVH.
const LEAF: u32 = 4;

impl Bvh {
    /// Builds a BVH over boxes that [`super::fits_single_precision`] accepts; also returns the index of the box at each
    /// position of the hierarchy's order.
    pub fn build(boxes: impl ExactSizeIterator<Item = Aabb>) -> (Bvh, Vec<u32>) {
        let prims = boxes.enumerate().map(|(i, b)| Prim::new(&b, i as u32)).collect();
        let (bvh, order, _) = Build::build_hierarchy(prims, &|items| items.len() == 1, ITEM);
        (bvh, order)
    }

    /// Builds a BVH over `count` boxes, given by their corners, whose items are packs of boxes: a group of boxes that
    /// `fits_in_one_pack` accepts becomes one item; `fits_in_one_pack` accepts each single box. Also returns the range of
    /// each pack's boxes in the order.
    pub fn build_packs(
        count: usize,
        box_corners: impl Fn(u32) -> [Vec3A; 2] + Sync,
        fits_in_one_pack: impl Fn(&[u32]) -> bool + Sync,
    ) -> (Bvh, Vec<u32>, Vec<Range<u32>>) {
        let is_pack = |items: &[Prim]| {
            if items.len() > LARGEST {
                return false;
            }
            let numbers: SmallVec<[u32; LARGEST]> = items.iter().map(Prim::index).collect();
            fits_in_one_pack(&numbers)
        };
        let prims = fork::map(count, PRIMS_FOR_A_THREAD, |i| {
            let [lower, upper] = box_corners(i as u32);
            Prim::from_corners(lower, upper, i as u32)
        });
        Build::build_hierarchy(prims, &is_pack, PACK)
    }
}

/// State of the construction of a BVH.
struct Build {
    prims: Vec<Prim>,
    binary_tree: BinaryTree,
    bvh: Bvh,
    /// Range of the boxes of each item of the BVH.
    items: Vec<Range<u32>>,
}

/// Nodes of the binary tree from which a BVH is made, or of one of its subtrees; children before their parents.
struct BinaryTree(Vec<BinaryNode>);

/// Parameters of the construction of a BVH's binary tree.
struct Splitting<'a, F> {
    /// True if these boxes become one item of the BVH.
    is_item: &'a F,
    item_cost: f32,
}

/// A node of the BVH's binary tree: an item, or two halves.
struct BinaryNode {
    /// Indices of the node's two halves; for an item, the range of its boxes.
    parts: [u32; 2],
    /// Number of items in the subtree of the node; an item can be a pack of several boxes.
    items: u32,
    /// For 2, 3, … 8 children of a wide BVH node: how many of them the first half receives at the least cost; 0 if
    /// fewer children cost less.
    first: [u8; WIDTH - 1],
    /// True if testing all items of the subtree at once costs least.
    is_leaf: bool,
}

/// A finished subtree of the BVH, until its parent is made.
struct Half {
    number: u32,
    lo: Vec3A,
    hi: Vec3A,
    items: u32,
    /// Least cost of the subtree with at most 1, 2, … 7 children of a wide node.
    cost: [f32; WIDTH - 1],
}

impl Build {
    fn build_hierarchy<F: Fn(&[Prim]) -> bool + Sync>(
        prims: Vec<Prim>,
        is_item: &F,
        item_cost: f32,
    ) -> (Bvh, Vec<u32>, Vec<Range<u32>>) {
        // A binary tree of n leaves has 2n - 1 nodes: a vector that grows would leave gaps in memory.
        let binary_tree = BinaryTree(Vec::with_capacity(2 * prims.len()));
        let mut build = Build { prims, binary_tree, bvh: Bvh::default(), items: vec![] };
        if !build.prims.is_empty() {
            let mut around = Around::EMPTY;
            build.prims.iter().for_each(|prim| around.add(prim));
            let splitting = Splitting { is_item, item_cost };
            let root = splitting.build_subtree(&mut build.prims, 0, &around, COST_SPLIT_LEVELS, &mut build.binary_tree);
            build.bvh.nodes.reserve_exact(build.binary_tree.count_wide_nodes(root.number));
            build.bvh.nodes.push(Wide::EMPTY);
            build.items.reserve_exact(root.items as usize);
            build.fill_node(0, root.number);
        }
        build.binary_tree = BinaryTree(vec![]);
        let mut order = Vec::with_capacity(build.prims.len());
        for item in &mut build.items {
            let start = order.len() as u32;
            order.extend(build.prims[item.start as usize..item.end as usize].iter().map(Prim::index));
            *item = start..order.len() as u32;
        }
        (build.bvh, order, build.items)
    }
}

impl<F: Fn(&[Prim]) -> bool + Sync> Splitting<'_, F> {
    /// Builds the BVH's binary tree over boxes, the first of which is box `start` of the whole tree, and appends it to
    /// `tree`. The first `cost_split_levels` levels are split at the cheapest plane, deeper ones in halves by number.
    fn build_subtree(
        &self,
        prims: &mut [Prim],
        start: u32,
        around: &Around,
        cost_split_levels: usize,
        tree: &mut BinaryTree,
    ) -> Half {
        if (self.is_item)(prims) {
            return tree.add_item(start..start + prims.len() as u32, around, self.item_cost);
        }
        // A cancelled build ends quickly with a poor tree.
        let is_cancelled = prims.len() > PRIMS_BETWEEN_POLLS && cancel::is_cancelled();
        let (count, [left, right]) = split_boxes(prims, around, cost_split_levels == 0 || is_cancelled);
        let (left_prims, right_prims) = prims.split_at_mut(count);
        let (middle, cost_split_levels) = (start + count as u32, cost_split_levels.saturating_sub(1));
        let (a, b);
        if left_prims.len() + right_prims.len() < PRIMS_FOR_TWO_THREADS || fork::threads() < 2 {
            a = self.build_subtree(left_prims, start, &left, cost_split_levels, tree);
            b = self.build_subtree(right_prims, middle, &right, cost_split_levels, tree);
        } else {
            let mut right_tree = BinaryTree(Vec::with_capacity(right_prims.len()));
            let right_half;
            (a, right_half) = fork::join(
                || self.build_subtree(left_prims, start, &left, cost_split_levels, tree),
                || self.build_subtree(right_prims, middle, &right, cost_split_levels, &mut right_tree),
            );
            b = tree.append(right_tree, right_half);
        }
        tree.join_halves(&a, &b, self.item_cost)
    }
}

impl BinaryTree {
    /// Adds an item of the BVH: the boxes in this range.
    fn add_item(&mut self, boxes: Range<u32>, around: &Around, item_cost: f32) -> Half {
        let Around { lo, hi, .. } = *around;
        let cost = [half_surface_area(lo, hi) * item_cost; WIDTH - 1];
        let parts = [boxes.start, boxes.end];
        self.0.push(BinaryNode { parts, items: 1, first: [0; WIDTH - 1], is_leaf: true });
        Half { number: self.0.len() as u32 - 1, lo, hi, items: 1, cost }
    }

    /// Appends a tree that another thread has built, whose root is `half`; returns the root with its new number.
    fn append(&mut self, tree: BinaryTree, half: Half) -> Half {
        let before = self.0.len() as u32;
        self.0.extend(tree.0.into_iter().map(|node| match node.items {
            1 => node,
            _ => BinaryNode { parts: node.parts.map(|number| number + before), ..node },
        }));
        Half { number: half.number + before, ..half }
    }

    /// Makes the parent of two halves of the BVH, at the least cost.
    fn join_halves(&mut self, a: &Half, b: &Half, item_cost: f32) -> Half {
        let (lo, hi) = (a.lo.min(b.lo), a.hi.max(b.hi));
        let (area, items) = (half_surface_area(lo, hi), a.items + b.items);
        // Least cost with exactly this number of children.
        let mut cost = [f32::INFINITY; WIDTH + 1];
        let mut first = [0; WIDTH - 1];
        for children in 2..=WIDTH {
            for k in 1..children {
                let sum = a.cost[k - 1] + b.cost[children - k - 1];
                if sum < cost[children] {
                    (cost[children], first[children - 2]) = (sum, k as u8);
                }
            }
        }
        let node = area + cost[WIDTH];
        let leaf = if items <= LEAF { area * items as f32 * item_cost } else { f32::INFINITY };
        cost[1] = node.min(leaf);
        for children in 2..WIDTH {
            if cost[children - 1] <= cost[children] {
                (cost[children], first[children - 2]) = (cost[children - 1], 0);
            }
        }
        let cost = from_fn(|i| cost[i + 1]);
        let is_leaf = items <= LEAF && leaf <= node;
        self.0.push(BinaryNode { parts: [a.number, b.number], items, first, is_leaf });
        Half { number: self.0.len() as u32 - 1, lo, hi, items, cost }
    }

    /// Returns the number of wide nodes of a subtree. (A list of nodes that grows would need three times their memory for a moment.)
    fn count_wide_nodes(&self, binary_node: u32) -> usize {
        let is_node = |&child: &u32| !self.0[child as usize].is_leaf;
        1 + self
            .wide_children_of(binary_node)
            .into_iter()
            .filter(is_node)
            .map(|child| self.count_wide_nodes(child))
            .sum::<usize>()
    }

    /// Returns the children of the wide node that a node of the binary tree becomes.
    fn wide_children_of(&self, binary_node: u32) -> SmallVec<[u32; WIDTH]> {
        let mut children = SmallVec::new();
        match self.0[binary_node as usize].is_leaf {
            true => children.push(binary_node),
            false => self.choose_children(binary_node, WIDTH, &mut children),
        }
        children
    }

    /// Collects the best nodes of a subtree to be children of a wide BVH node, at most `max_count`.
    fn choose_children(&self, root: u32, mut max_count: usize, out: &mut SmallVec<[u32; WIDTH]>) {
        let binary_node = &self.0[root as usize];
        while max_count > 1 && binary_node.first[max_count - 2] == 0 {
            max_count -= 1;
        }
        if max_count == 1 {
            return out.push(root);
        }
        let first = usize::from(binary_node.first[max_count - 2]);
        self.choose_children(binary_node.parts[0], first, out);
        self.choose_children(binary_node.parts[1], max_count - first, out);
    }
}

impl Build {
    /// Fills a wide node of the BVH with children, recursively; returns their bounds.
    fn fill_node(&mut self, node: usize, binary_node: u32) -> Around {
        let mut all = Around::EMPTY;
        let mut inner: SmallVec<[(usize, usize, u32); WIDTH]> = SmallVec::new();
        for (slot, number) in self.binary_tree.wide_children_of(binary_node).into_iter().enumerate() {
            let BinaryNode { is_leaf, items, .. } = self.binary_tree.0[number as usize];
            if is_leaf {
                let mut around = Around::EMPTY;
                self.add_items(number, &mut around);
                let child = Child::items(self.items.len() - items as usize, items as usize);
                self.bvh.nodes[node].set_child(slot, (around.lo, around.hi), child);
                all.join(&around);
            } else {
                // Siblings are adjacent in memory, since they are visited together.
                inner.push((slot, self.bvh.nodes.len(), number));
                self.bvh.nodes.push(Wide::EMPTY);
            }
        }
        for (slot, child, number) in inner {
            let around = self.fill_node(child, number);
            self.bvh.nodes[node].set_child(slot, (around.lo, around.hi), Child::node(child));
            all.join(&around);
        }
        all
    }

    /// Appends the items of a subtree to the BVH, and extends `around` by their boxes.
    fn add_items(&mut self, root: u32, around: &mut Around) {
        match self.binary_tree.0[root as usize] {
            BinaryNode { items: 1, parts: [start, end], .. } => {
                self.prims[start as usize..end as usize].iter().for_each(|prim| around.add(prim));
                self.items.push(start..end);
            }
            BinaryNode { parts: [a, b], .. } => {
                self.add_items(a, around);
                self.add_items(b, around);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{DVec3, rng};

    #[test]
    fn any_number_of_threads_builds_the_same_hierarchy() {
        let random_box = |i: u64| {
            let [x, y, z, size] = [0, 1, 2, 3].map(|k| rng::random_unit(&[i, k]));
            let corner = DVec3::new(x * x, y, z);
            Aabb::from_points([corner, corner + 0.01 * size])
        };
        let build = || Bvh::build((0..40_000_usize).map(|i| random_box(i as u64)));
        let by_one = build();
        for threads in [2, 3, 7] {
            assert!(fork::with_threads(threads, build) == by_one, "{threads}");
        }
    }
}
