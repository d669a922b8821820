//! Division of the boxes of a BVH's subtree into two groups, at the cheapest of the planes between bins (Wald, On fast
//! construction of SAH-based bounding volume hierarchies, 2007).

use super::{round_down, round_up};
use crate::math::Aabb;
use glam::{Vec3A, Vec4};

/// Partitions the boxes of a BVH's subtree into two non-empty groups at the cheapest plane; returns the start of the
/// second group and the bounds of both.
pub(super) fn split_boxes(prims: &mut [Prim], around: &Around, force_halving: bool) -> (usize, [Around; 2]) {
    let cut = match prims.len() {
        _ if force_halving => None,
        0..=32 => Cut::find_cheapest_cut::<6>(prims, around),
        _ => Cut::find_cheapest_cut::<16>(prims, around),
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

/// A box that the construction of a BVH sorts. (Both corners are loaded as four numbers at once.)
#[derive(Clone, Copy)]
pub(super) struct Prim {
    /// Lower corner of the box; the bits of `w` are the index of the box.
    lower: Vec4,
    /// Upper corner of the box; `w` is 1, so that no sum with the other `w` is subnormal, which some processors add slowly.
    upper: Vec4,
}

impl Prim {
    pub fn new(b: &Aabb, index: u32) -> Self {
        let [lower, upper] = [b.min.to_array().map(round_down), b.max.to_array().map(round_up)];
        Self::from_corners(lower.into(), upper.into(), index)
    }

    #[inline]
    pub fn from_corners(lower: Vec3A, upper: Vec3A, index: u32) -> Self {
        Self { lower: lower.extend(f32::from_bits(index)), upper: upper.extend(1.0) }
    }

    #[inline]
    pub fn index(&self) -> u32 {
        self.lower.w.to_bits()
    }

    #[inline]
    fn lower_corner(&self) -> Vec3A {
        Vec3A::from_vec4(self.lower)
    }

    #[inline]
    fn upper_corner(&self) -> Vec3A {
        Vec3A::from_vec4(self.upper)
    }

    /// Returns twice the centre of the box.
    #[inline]
    fn doubled_center(&self) -> Vec3A {
        self.lower_corner() + self.upper_corner()
    }
}

/// Bounds of some boxes, and of their centres, during the construction of a BVH.
#[derive(Clone, Copy)]
pub(super) struct Around {
    /// Lower and upper corner of a box around the boxes.
    pub lo: Vec3A,
    pub hi: Vec3A,
    /// Lower and upper corner of a box around the boxes' doubled centres.
    first: Vec3A,
    last: Vec3A,
}

impl Around {
    pub const EMPTY: Around =
        Around { lo: Vec3A::INFINITY, hi: Vec3A::NEG_INFINITY, first: Vec3A::INFINITY, last: Vec3A::NEG_INFINITY };

    #[inline]
    pub fn add(&mut self, prim: &Prim) {
        let (lo, hi, doubled_center) = (prim.lower_corner(), prim.upper_corner(), prim.doubled_center());
        *self = Around {
            lo: self.lo.min(lo),
            hi: self.hi.max(hi),
            first: self.first.min(doubled_center),
            last: self.last.max(doubled_center),
        };
    }

    #[inline]
    pub fn join(&mut self, other: &Around) {
        *self = Around {
            lo: self.lo.min(other.lo),
            hi: self.hi.max(other.hi),
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        };
    }
}

/// Returns half of the surface of a box with these corners; 0 for an empty box.
#[inline]
pub(super) fn half_surface_area(lo: Vec3A, hi: Vec3A) -> f32 {
    let s = (hi - lo).max(Vec3A::ZERO);
    // (Bounded, so that the sum of all stays finite.)
    (s.x * s.y + s.y * s.z + s.z * s.x).min(1e28)
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

    fn cost(&self) -> f32 {
        half_surface_area(self.lo, self.hi) * self.count as f32
    }
}

/// A split plane of the surface-area heuristic, between bins along an axis.
struct Cut {
    axis: usize,
    from: f32,
    scale: f32,
    bin: f32,
}

impl Cut {
    /// Returns the cheapest split plane between bins along each axis; `None` if all are equally good.
    fn find_cheapest_cut<const BINS: usize>(prims: &[Prim], around: &Around) -> Option<Cut> {
        let extent = around.last - around.first;
        if extent.max_element() <= 0.0 || !extent.is_finite() {
            return None;
        }
        let scale = Vec3A::select(extent.cmpgt(Vec3A::ZERO), Vec3A::splat(BINS as f32 * 0.9999) / extent, Vec3A::ZERO);
        let mut bins = [[Bin::EMPTY; BINS]; 3];
        for prim in prims {
            let one = Bin { lo: prim.lower_corner(), hi: prim.upper_corner(), count: 1 };
            let places = (prim.doubled_center() - around.first) * scale;
            for (bins, number) in bins.iter_mut().zip(rounded_below_16(places - 0.5)) {
                let bin = &mut bins[number.min(BINS - 1)];
                *bin = bin.join(one);
            }
        }
        let cuts = (0..3).map(|axis| (axis, cheapest_left_bin_count(&bins[axis])));
        let (axis, (bin, cost)) = cuts.min_by(|a, b| a.1.1.total_cmp(&b.1.1))?;
        let cut = Cut { axis, from: around.first[axis], scale: scale[axis], bin: bin as f32 };
        cost.is_finite().then_some(cut)
    }

    #[inline]
    fn is_left(&self, prim: &Prim) -> bool {
        (prim.lower[self.axis] + prim.upper[self.axis] - self.from) * self.scale < self.bin
    }
}

/// Rounds numbers from -0.5 to below 15.5 to integers; returns any integers below 16 for others. (A conversion by `as` also
/// handles infinite numbers and NaN, which takes longer.)
#[inline(always)]
fn rounded_below_16(numbers: Vec3A) -> [usize; 3] {
    // The last bit of a number from 2²³ to 2²⁴ is worth 1, and the last bits of 3·2²² are 0.
    let shifted = numbers + Vec3A::splat((3 << 22) as f32);
    shifted.to_array().map(|x| (x.to_bits() & 15) as usize)
}

/// Returns the number of bins on the left of the cheapest split plane, and its cost; infinite if all items are in one
/// bin.
fn cheapest_left_bin_count<const BINS: usize>(bins: &[Bin; BINS]) -> (usize, f32) {
    // Cost of bins i and above.
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

/// Moves the boxes of the left group before the others; returns their number and the bounds of both groups.
fn partition(prims: &mut [Prim], left: impl Fn(&Prim) -> bool) -> (usize, [Around; 2]) {
    let (mut i, mut j) = (0, prims.len());
    let [mut before, mut behind] = [Around::EMPTY; 2];
    while i < j {
        // (By reference: a copy would be built in memory first.)
        let prim = &prims[i];
        if left(prim) {
            before.add(prim);
            i += 1;
        } else {
            behind.add(prim);
            j -= 1;
            prims.swap(i, j);
        }
    }
    (i, [before, behind])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_to_integers() {
        for k in -8..248 {
            let x = k as f32 / 16.0;
            let expected = x.round_ties_even() as usize;
            assert_eq!(rounded_below_16(Vec3A::new(x, 3.0, x)), [expected, 3, expected], "{x}");
        }
        for x in [f32::NAN, f32::INFINITY, -1e30] {
            assert!(rounded_below_16(Vec3A::splat(x)).iter().all(|number| *number < 16), "{x}");
        }
    }
}
