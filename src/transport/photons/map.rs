//! A photon map: a balanced kd-tree of photons with a search for the nearest ones (Jensen, Realistic Image Synthesis
//! Using Photon Mapping, 2001).

use crate::color::Rgb;
use crate::math::{DVec3, cancel};
use smallvec::SmallVec;

/// Maximum number of photons of a leaf of the tree.
const LEAF: usize = 16;

/// Maximum depth of the tree: each division halves the photons, of which there are fewer than 2³², down to a leaf.
const MAX_DEPTH: usize = 28;

/// Maximum number of photons around which [`PhotonMap::mean_radius_holding_count`] measures the distance of neighbours.
const RADIUS_SAMPLES: usize = 256;

/// A stored photon, in single precision: maps are large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon {
    /// Position in world space.
    position: [f32; 3],
    /// Flux of the stored photon: power on a surface, power times length in a medium.
    flux: [f32; 3],
    /// Direction of flight, length 1.
    dir: [f32; 3],
}

impl Photon {
    /// Creates a photon.
    pub fn new(position: DVec3, flux: Rgb, dir: DVec3) -> Self {
        let [position, flux, dir] = [position, flux, dir].map(|v| v.as_vec3().to_array());
        Self { position, flux, dir }
    }

    /// Creates a photon from position, flux and direction in single precision.
    pub fn from_numbers(position: [f32; 3], flux: [f32; 3], dir: [f32; 3]) -> Self {
        Self { position, flux, dir }
    }

    /// Returns position, flux and direction.
    pub fn numbers(&self) -> impl Iterator<Item = f32> {
        [self.position, self.flux, self.dir].into_iter().flatten()
    }
}

/// Power and direction of a photon in a map.
#[derive(Clone, Copy, Debug)]
pub struct PhotonPower {
    flux: [f32; 3],
    dir: [f32; 3],
}

impl PhotonPower {
    /// Returns the flux of the photon: power on a surface, power times length in a medium.
    pub fn flux(&self) -> Rgb {
        Rgb::from_array(self.flux.map(f64::from))
    }

    /// Returns the direction of flight, length 1.
    pub fn dir(&self) -> DVec3 {
        DVec3::from_array(self.dir.map(f64::from))
    }
}

/// A photon that a search has found. Its distance is in the upper 32 bits, its index in the lower ones: the bits of numbers
/// that are not negative have the order of the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct FoundPhoton(u64);

impl FoundPhoton {
    fn new(squared_distance: f32, index: u32) -> Self {
        Self(u64::from(squared_distance.to_bits()) << 32 | u64::from(index))
    }

    fn squared_distance(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    /// Returns the number of the photon, for [`PhotonMap::power`].
    pub fn index(self) -> u32 {
        self.0 as u32
    }
}

/// Photons that a search has found; a heap with the farthest photon first when the list is full.
pub type Found = Vec<FoundPhoton>;

/// A balanced kd-tree of photons. The middle photon of each range divides the range along an axis.
#[derive(Debug, Default)]
pub struct PhotonMap {
    /// Positions of the photons, a list for each coordinate: a search reads hardly anything else. [`LEAF`] infinite coordinates
    /// follow, so that any photon begins a whole block.
    positions: [Vec<f32>; 3],
    powers: Vec<PhotonPower>,
    /// Axis of the division, by the index of the dividing photon.
    axes: Vec<u8>,
    /// Minimum and maximum coordinates of the photons.
    bounds: [[f32; 3]; 2],
}

impl PhotonMap {
    /// Builds the tree, without photons whose position or flux is not finite. The result depends only on the photons
    /// and their order.
    pub fn new(mut photons: Vec<Photon>) -> Self {
        photons.retain(|photon| photon.position.iter().chain(&photon.flux).all(|x| x.is_finite()));
        photons.truncate(u32::MAX as usize);
        let mut axes = vec![0; photons.len()];
        sort_into_tree_order(&mut photons, &mut axes);
        Self::from_parts(photons, axes)
    }

    /// Creates a map from the photons and axes of [`Self::tree`].
    pub fn from_tree(photons: impl Iterator<Item = (Photon, u8)>) -> Self {
        let (photons, axes) = photons.unzip();
        Self::from_parts(photons, axes)
    }

    fn from_parts(photons: Vec<Photon>, axes: Vec<u8>) -> Self {
        let positions = [0, 1, 2].map(|axis| {
            let padding = std::iter::repeat_n(f32::INFINITY, LEAF);
            photons.iter().map(|photon| photon.position[axis]).chain(padding).collect()
        });
        let bounds = bounds(&photons);
        // (The standard library reuses the memory of `photons`.)
        let powers = photons.into_iter().map(|Photon { flux, dir, .. }| PhotonPower { flux, dir }).collect();
        Self { positions, powers, axes, bounds }
    }

    /// Returns the photons in the order of the tree, each with the axis of its division.
    pub fn tree(&self) -> impl Iterator<Item = (Photon, u8)> {
        let photon = |i: usize| {
            let PhotonPower { flux, dir } = self.powers[i];
            Photon { position: self.position(i), flux, dir }
        };
        (0..self.len()).map(move |i| (photon(i), self.axes[i]))
    }

    /// Returns the number of photons.
    pub fn len(&self) -> usize {
        self.powers.len()
    }

    /// True if the map has no photons.
    pub fn is_empty(&self) -> bool {
        self.powers.is_empty()
    }

    /// Returns the power and direction of the photon with an index that a search found.
    pub fn power(&self, index: u32) -> &PhotonPower {
        &self.powers[index as usize]
    }

    fn position(&self, i: usize) -> [f32; 3] {
        self.positions.each_ref().map(|list| list[i])
    }

    /// Finds the at most `count` photons, one or more, nearest to a point within a radius, and returns the radius that they fill: the
    /// distance of the farthest one if there are `count`, the radius of the search otherwise.
    pub fn find_nearest_and_radius(&self, p: DVec3, radius: f64, count: usize, found: &mut Found) -> f64 {
        found.clear();
        let mut search = Search { map: self, p: p.as_vec3().to_array(), limit: (radius * radius) as f32, count, found };
        let [low, high] = self.bounds;
        let apart = [0, 1, 2].map(|i| (low[i] - search.p[i]).max(search.p[i] - high[i]).max(0.0));
        let [x, y, z] = apart;
        if x * x + y * y + z * z < search.limit {
            search.visit_all(apart);
        }
        f64::from(search.limit).sqrt()
    }

    /// Returns the mean radius of a ball around a photon that contains `count` photons, the one at the centre included.
    pub fn mean_radius_holding_count(&self, count: usize) -> f64 {
        let n = self.len().min(RADIUS_SAMPLES);
        let (mut sum, mut found) = (0.0, Found::default());
        for i in 0..n {
            let p = DVec3::from_array(self.position(i * self.len() / n).map(f64::from));
            self.find_nearest_and_radius(p, f64::MAX.sqrt(), count.min(self.len()), &mut found);
            let farthest = found.iter().map(|photon| photon.squared_distance()).fold(0.0, f32::max);
            sum += f64::from(farthest).sqrt();
        }
        sum / n.max(1) as f64
    }
}

/// Sorts photons into the order of the tree, and stores the axes of the divisions.
fn sort_into_tree_order(photons: &mut [Photon], axes: &mut [u8]) {
    if photons.len() <= LEAF || cancel::is_cancelled() {
        return;
    }
    // Axis along which the photons extend farthest
    let [low, high] = bounds(photons);
    let extent = |i: &usize| high[*i] - low[*i];
    let axis = (0..3).max_by(|a, b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
    let middle = photons.len() / 2;
    photons.select_nth_unstable_by(middle, |a, b| a.position[axis].total_cmp(&b.position[axis]));
    axes[middle] = axis as u8;
    let (below, above) = photons.split_at_mut(middle);
    let (axes_below, axes_above) = axes.split_at_mut(middle);
    sort_into_tree_order(below, axes_below);
    sort_into_tree_order(&mut above[1..], &mut axes_above[1..]);
}

/// Returns the minimum and maximum coordinates of photons. Of an empty list, the minimum is ∞ and the maximum -∞.
fn bounds(photons: &[Photon]) -> [[f32; 3]; 2] {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for photon in photons {
        for i in 0..3 {
            low[i] = low[i].min(photon.position[i]);
            high[i] = high[i].max(photon.position[i]);
        }
    }
    [low, high]
}

/// A search for the photons nearest to a point.
struct Search<'a> {
    map: &'a PhotonMap,
    p: [f32; 3],
    /// Squared distance from the point of the search from which on photons are ignored; shrinks as nearer ones are
    /// found.
    limit: f32,
    count: usize,
    found: &'a mut Found,
}

/// A part of the tree that a search has still to visit.
#[derive(Clone, Copy, Default)]
struct Pending {
    /// Range of the part's photons.
    from: u32,
    to: u32,
    /// Photon that divides the part from its neighbour.
    middle: u32,
    /// Distance of the point of the search from the part's box along each axis.
    axis_distances: [f32; 3],
}

impl Search<'_> {
    /// Searches all photons of the tree. `axis_distances` is the distance of the point from the photons' box along each
    /// axis.
    fn visit_all(&mut self, axis_distances: [f32; 3]) {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has the feature that the function needs.
            #[expect(unsafe_code, reason = "the compiler can't know the processor")]
            return unsafe { self.visit_all_avx2(axis_distances) };
        }
        self.visit_all_portably(axis_distances);
    }

    /// The same, compiled for processors with wider vectors. Sums have the same order, so the results are equal.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn visit_all_avx2(&mut self, axis_distances: [f32; 3]) {
        self.visit_all_portably(axis_distances);
    }

    /// Visits the leaves of the tree, from the nearest on, as far as they can contain photons within the limit (S. Arya and
    /// D. M. Mount, "Algorithms for fast vector quantization", 1993).
    #[inline(always)]
    fn visit_all_portably(&mut self, axis_distances: [f32; 3]) {
        let mut pending: SmallVec<[Pending; MAX_DEPTH]> = SmallVec::new();
        let (mut from, mut to, mut apart) = (0, self.map.len(), axis_distances);
        loop {
            // Down to the leaf that is nearest to the point
            while to - from > LEAF {
                let middle = from + (to - from) / 2;
                let axis = self.map.axes[middle] as usize;
                let beyond = self.p[axis] - self.map.positions[axis][middle];
                let mut apart_of_far = apart;
                apart_of_far[axis] = beyond;
                let (below, above) = ((from, middle), (middle + 1, to));
                let (near, far) = if beyond < 0.0 { (below, above) } else { (above, below) };
                let [start, end, middle] = [far.0, far.1, middle].map(|i| i as u32);
                pending.push(Pending { from: start, to: end, middle, axis_distances: apart_of_far });
                (from, to) = near;
            }
            self.visit_leaf(from, to);
            loop {
                let Some(part) = pending.pop() else { return };
                let [x, y, z] = part.axis_distances;
                if x * x + y * y + z * z < self.limit {
                    self.visit_one(part.middle as usize);
                    (from, to, apart) = (part.from as usize, part.to as usize, part.axis_distances);
                    break;
                }
            }
        }
    }

    /// Adds one photon if it is near enough.
    #[inline]
    fn visit_one(&mut self, i: usize) {
        let position = self.map.position(i);
        let [x, y, z] = [0, 1, 2].map(|axis| position[axis] - self.p[axis]);
        let squared = x * x + y * y + z * z;
        if squared < self.limit {
            self.add(squared, i as u32);
        }
    }

    /// Adds the photons of a range of at most [`LEAF`] that are near enough.
    #[inline(always)]
    fn visit_leaf(&mut self, from: usize, to: usize) {
        let blocks = self.map.positions.each_ref().map(|list| list[from..].first_chunk::<LEAF>());
        let [Some(x), Some(y), Some(z)] = blocks else { return };
        let [px, py, pz] = self.p;
        // (Loops that the compiler turns into vectors.)
        let mut squared = [0.0; LEAF];
        for i in 0..LEAF {
            let (x, y, z) = (x[i] - px, y[i] - py, z[i] - pz);
            squared[i] = x * x + y * y + z * z;
        }
        let mut near = 0_u32;
        for (i, squared) in squared.iter().enumerate() {
            near |= u32::from(*squared < self.limit) << i;
        }
        // Photons beyond the range are ignored.
        near &= (1 << (to - from)) - 1;
        while near != 0 {
            let i = near.trailing_zeros() as usize;
            near &= near - 1;
            // (Photons before have lowered the limit.)
            if squared[i] < self.limit {
                self.add(squared[i], (from + i) as u32);
            }
        }
    }

    /// Adds a photon that is nearer than the limit; in a full list it replaces the farthest one.
    #[inline(always)]
    fn add(&mut self, squared_distance: f32, i: u32) {
        let photon = FoundPhoton::new(squared_distance, i);
        if self.found.len() < self.count {
            self.found.push(photon);
            if self.found.len() < self.count {
                return;
            }
            for i in (0..self.count / 2).rev() {
                let photon = self.found[i];
                sift_down(self.found, i, photon);
            }
        } else {
            sift_down(self.found, 0, photon);
        }
        self.limit = self.found[0].squared_distance();
    }
}

/// Stores `photon` in a heap at the entry `i` or below it, in place of the entry `i`. The farthest photon comes first.
#[inline(always)]
fn sift_down(heap: &mut [FoundPhoton], mut i: usize, photon: FoundPhoton) {
    loop {
        let mut child = 2 * i + 1;
        if child + 1 < heap.len() {
            child += usize::from(heap[child + 1] > heap[child]);
        } else if child >= heap.len() {
            break;
        }
        if heap[child] <= photon {
            break;
        }
        heap[i] = heap[child];
        i = child;
    }
    heap[i] = photon;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::rng::Stream;

    #[test]
    fn the_tree_finds_the_nearest_photons() {
        let mut random = Stream::new(&[17]);
        let mut point = || DVec3::from_array([(); 3].map(|()| random.next_random()));
        let points: Vec<DVec3> = (0..3000).map(|_| point()).collect();
        let map = PhotonMap::new(points.iter().map(|p| Photon::new(*p, Rgb::ONE, DVec3::Y)).collect());
        let mut found = Found::default();
        for _ in 0..50 {
            let p = point();
            let mut all: Vec<f64> = points.iter().map(|q| q.distance(p)).collect();
            all.sort_by(f64::total_cmp);
            let radius = map.find_nearest_and_radius(p, 10.0, 40, &mut found);
            assert!(found.len() == 40 && (radius - all[39]).abs() < 1e-6);
            let within = all.iter().filter(|d| **d < 0.1).count();
            let radius = map.find_nearest_and_radius(p, 0.1, 4000, &mut found);
            assert!((radius - 0.1).abs() < 1e-7 && found.len() == within);
        }
    }
}
