//! A photon map: a balanced kd-tree of photons with a search for the nearest ones (Jensen, Realistic Image Synthesis
//! Using Photon Mapping, 2001).

use crate::color::Rgb;
use crate::math::{DVec3, cancel};
use glam::Vec4;

/// Number of photons of a leaf of the tree; the last leaf may have fewer.
const LEAF: usize = 16;

/// Maximum number of divisions between the root and a leaf: each division halves the number of leaves, which is at most
/// 2²⁸.
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

/// A photon that a search has found: its squared distance as the upper 32 bits, its index as the lower 32 bits. Floats
/// that are not negative have the order of their bits, so the order of this type is that of the distances.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct FoundPhoton(u64);

impl FoundPhoton {
    fn new(squared_distance: f32, index: u32) -> Self {
        Self(u64::from(squared_distance.to_bits()) << 32 | u64::from(index))
    }

    fn squared_distance(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    /// Returns the index of the photon, for [`PhotonMap::power`].
    pub fn index(self) -> u32 {
        self.0 as u32
    }
}

/// Photons that a search has found; a heap with the farthest photon first once the list holds the maximum number.
pub type Found = Vec<FoundPhoton>;

/// A point near which photons are searched, and the measure of their distance: that of a photon at `point` + d is
/// |d|·√(1 + |`flattening`·d|).
#[derive(Clone, Copy, Debug)]
pub struct SearchPoint {
    /// Point in world space.
    pub point: DVec3,
    /// Normal of a surface times a factor (1 / length), by which photons off the surface are more distant; 0 in space.
    pub flattening: DVec3,
}

impl SearchPoint {
    /// Creates a point of a search for photons in all directions.
    pub fn in_space(point: DVec3) -> Self {
        Self { point, flattening: DVec3::ZERO }
    }
}

/// A balanced kd-tree of photons: each node divides its blocks of [`LEAF`] photons into halves along an axis.
#[derive(Debug, Default)]
pub struct PhotonMap {
    /// Positions of the photons, by leaf. Infinite coordinates fill the last block.
    blocks: Vec<Block>,
    powers: Vec<PhotonPower>,
    /// Divisions of the nodes, by the index of the first block behind the plane; entry 0 is unused.
    divisions: Vec<Division>,
    /// Boxes of the blocks.
    block_bounds: Vec<Bounds>,
    /// Box of all photons.
    bounds: Bounds,
}

/// Positions of the photons of a leaf, a list for each coordinate.
type Block = [[f32; LEAF]; 3];

/// Plane that divides the photons of a node.
#[derive(Clone, Copy, Debug, Default)]
struct Division {
    /// Coordinate of the plane: the minimum of the photons behind the plane. No photon in front of it has a larger one.
    at: f32,
    axis: u8,
    /// Box of the node's photons.
    bounds: Bounds,
}

/// Minimum and maximum coordinates of photons. Of no photons, the minimum is ∞ and the maximum -∞.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    low: [f32; 3],
    high: [f32; 3],
}

impl Default for Bounds {
    fn default() -> Self {
        Self { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] }
    }
}

impl Bounds {
    fn of(photons: &[Photon]) -> Self {
        let mut bounds = Self::default();
        for photon in photons {
            bounds.add(&Self { low: photon.position, high: photon.position });
        }
        bounds
    }

    /// Extends the box to contain another one.
    fn add(&mut self, other: &Self) {
        for i in 0..3 {
            self.low[i] = self.low[i].min(other.low[i]);
            self.high[i] = self.high[i].max(other.high[i]);
        }
    }

    /// Returns the distance of a point from the box along each axis.
    fn axis_distances(&self, p: [f32; 3]) -> [f32; 3] {
        [0, 1, 2].map(|i| (self.low[i] - p[i]).max(p[i] - self.high[i]).max(0.0))
    }

    /// Returns the minimum of |n·(q - p)| for the points q of the box.
    fn distance_along(&self, n: [f32; 3], p: [f32; 3]) -> f32 {
        let (mut least, mut most) = (0.0, 0.0);
        for i in 0..3 {
            let (a, b) = (n[i] * (self.low[i] - p[i]), n[i] * (self.high[i] - p[i]));
            least += a.min(b);
            most += a.max(b);
        }
        least.max(-most).max(0.0)
    }
}

impl PhotonMap {
    /// Builds the tree, without photons whose position or flux is not finite. The result depends only on the photons
    /// and their order.
    pub fn new(mut photons: Vec<Photon>) -> Self {
        photons.retain(|photon| photon.position.iter().chain(&photon.flux).all(|x| x.is_finite()));
        photons.truncate(u32::MAX as usize);
        let mut axes = vec![0; photons.len().div_ceil(LEAF)];
        sort_into_tree_order(&mut photons, &mut axes);
        Self::from_parts(photons, &axes)
    }

    /// Creates a map from the photons and axes of [`Self::tree`]; axes are below 3.
    pub fn from_tree(photons: impl Iterator<Item = (Photon, u8)>) -> Self {
        let (photons, axes): (Vec<Photon>, Vec<u8>) = photons.unzip();
        let axes: Vec<u8> = axes.into_iter().step_by(LEAF).collect();
        Self::from_parts(photons, &axes)
    }

    /// Creates a map from photons in the order of the tree, and the axes of its divisions.
    fn from_parts(photons: Vec<Photon>, axes: &[u8]) -> Self {
        let mut divisions = vec![Division::default(); axes.len()];
        let block_bounds: Vec<Bounds> = photons.chunks(LEAF).map(Bounds::of).collect();
        let bounds = find_divisions(&block_bounds, axes, &mut divisions);
        let coordinate = |chunk: &[Photon], i: usize, axis: usize| {
            chunk.get(i).map_or(f32::INFINITY, |photon| photon.position[axis])
        };
        let block = |chunk: &[Photon]| [0, 1, 2].map(|axis| std::array::from_fn(|i| coordinate(chunk, i, axis)));
        let blocks = photons.chunks(LEAF).map(block).collect();
        // (The standard library reuses the memory of `photons`.)
        let powers = photons.into_iter().map(|Photon { flux, dir, .. }| PhotonPower { flux, dir }).collect();
        Self { blocks, powers, divisions, block_bounds, bounds }
    }

    /// Returns the photons in the order of the tree. The first photon of each block comes with the axis of the division in
    /// front of the block, other photons with 0.
    pub fn tree(&self) -> impl Iterator<Item = (Photon, u8)> {
        let photon = |i: usize| {
            let PhotonPower { flux, dir } = self.powers[i];
            Photon { position: self.position(i), flux, dir }
        };
        let axis = |i: usize| if i.is_multiple_of(LEAF) { self.divisions[i / LEAF].axis } else { 0 };
        (0..self.len()).map(move |i| (photon(i), axis(i)))
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
        self.blocks[i / LEAF].map(|list| list[i % LEAF])
    }

    /// Finds the `count` photons nearest to a point within a radius, or all if there are fewer, and returns the radius that
    /// they fill: the distance of the farthest photon if there are `count`, `radius` otherwise. `count` must not be 0.
    pub fn find_nearest_and_radius(&self, from: SearchPoint, radius: f64, count: usize, found: &mut Found) -> f64 {
        found.clear();
        let [p, flattening] = [from.point, from.flattening].map(|v| v.as_vec3().to_array());
        let mut search = Search { map: self, p, flattening, limit: (radius * radius) as f32, count, found };
        let axis_distances = self.bounds.axis_distances(search.p);
        let [x, y, z] = axis_distances;
        if !self.is_empty() && x * x + y * y + z * z < search.limit {
            search.visit_all(axis_distances);
        }
        f64::from(search.limit).sqrt()
    }

    /// Returns the mean radius of a ball around a photon that contains `count` photons, the one at the centre included.
    pub fn mean_radius_holding_count(&self, count: usize) -> f64 {
        let n = self.len().min(RADIUS_SAMPLES);
        let (mut sum, mut found) = (0.0, Found::default());
        for i in 0..n {
            let p = DVec3::from_array(self.position(i * self.len() / n).map(f64::from));
            self.find_nearest_and_radius(SearchPoint::in_space(p), f64::MAX.sqrt(), count.min(self.len()), &mut found);
            let farthest = found.iter().map(|photon| photon.squared_distance()).fold(0.0, f32::max);
            sum += f64::from(farthest).sqrt();
        }
        sum / n.max(1) as f64
    }
}

/// Sorts photons into the order of the tree, and stores the axis of each division at the index of the first block behind
/// it.
fn sort_into_tree_order(photons: &mut [Photon], axes: &mut [u8]) {
    if axes.len() <= 1 || cancel::is_cancelled() {
        return;
    }
    // Axis along which the photons extend farthest
    let Bounds { low, high } = Bounds::of(photons);
    let extent = |i: &usize| high[*i] - low[*i];
    let axis = (0..3).max_by(|a, b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
    let middle = axes.len() / 2;
    photons.select_nth_unstable_by(middle * LEAF, |a, b| a.position[axis].total_cmp(&b.position[axis]));
    axes[middle] = axis as u8;
    let (below, above) = photons.split_at_mut(middle * LEAF);
    let (axes_below, axes_above) = axes.split_at_mut(middle);
    sort_into_tree_order(below, axes_below);
    sort_into_tree_order(above, axes_above);
}

/// Finds the planes and boxes of the divisions of photons in the order of the tree, from the boxes of their blocks, and
/// returns the box of all.
fn find_divisions(blocks: &[Bounds], axes: &[u8], divisions: &mut [Division]) -> Bounds {
    if axes.len() <= 1 {
        return blocks.first().copied().unwrap_or_default();
    }
    let middle = axes.len() / 2;
    let (below, above) = blocks.split_at(middle);
    let mut bounds = find_divisions(below, &axes[..middle], &mut divisions[..middle]);
    let bounds_above = find_divisions(above, &axes[middle..], &mut divisions[middle..]);
    bounds.add(&bounds_above);
    let axis = axes[middle];
    divisions[middle] = Division { at: bounds_above.low[axis as usize], axis, bounds };
    bounds
}

/// A search for the photons nearest to a point.
struct Search<'a> {
    map: &'a PhotonMap,
    p: [f32; 3],
    /// See [`SearchPoint::flattening`].
    flattening: [f32; 3],
    /// Squared distance from the point of the search from which on photons are ignored; shrinks as nearer ones are
    /// found.
    limit: f32,
    count: usize,
    found: &'a mut Found,
}

/// A part of the tree that a search has not visited yet.
#[derive(Clone, Copy, Default)]
struct Pending {
    /// First block of the part.
    from: u32,
    /// End of the part: the index after its last block.
    to: u32,
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

    /// [`Self::visit_all_portably`], compiled for AVX2. The order of the sums is the same, so the results are equal.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn visit_all_avx2(&mut self, axis_distances: [f32; 3]) {
        self.visit_all_portably(axis_distances);
    }

    /// Visits the leaves of the tree depth-first, at each division the side of the point first, and skips parts that are not
    /// nearer than the limit. Each division updates the distance along one axis (S. Arya and D. M. Mount, "Algorithms for
    /// fast vector quantization", 1993).
    #[inline(always)]
    fn visit_all_portably(&mut self, axis_distances: [f32; 3]) {
        let mut pending = [Pending::default(); MAX_DEPTH];
        let mut n_pending = 0;
        let mut part = Pending { from: 0, to: self.map.blocks.len() as u32, axis_distances };
        loop {
            // Descend to the leaf on the point's side of each division
            while part.to - part.from > 1 {
                let middle = part.from + (part.to - part.from) / 2;
                let Division { at, axis, .. } = self.map.divisions[middle as usize];
                let beyond = self.p[axis as usize] - at;
                // (Changed where it stays, because a copy could begin only after all changes are stored.)
                let far = &mut pending[n_pending];
                *far = part;
                far.axis_distances[axis as usize] = beyond;
                if beyond < 0.0 {
                    (part.to, far.from) = (middle, middle);
                } else {
                    (part.from, far.to) = (middle, middle);
                }
                n_pending += 1;
            }
            self.visit_leaf(part.from);
            loop {
                if n_pending == 0 {
                    return;
                }
                n_pending -= 1;
                part = pending[n_pending];
                let [x, y, z] = part.axis_distances;
                if x * x + y * y + z * z < self.limit && self.is_near_surface(&part) {
                    break;
                }
            }
        }
    }

    /// True if photons of the part can be nearer than the limit, by the distance of its box from the surface.
    #[inline(always)]
    fn is_near_surface(&self, part: &Pending) -> bool {
        if self.flattening == [0.0; 3] {
            return true;
        }
        let middle = part.from + (part.to - part.from) / 2;
        let bounds = match part.to - part.from {
            1 => &self.map.block_bounds[part.from as usize],
            _ => &self.map.divisions[middle as usize].bounds,
        };
        let [x, y, z] = bounds.axis_distances(self.p);
        // (Rounding must not hide a photon.)
        let factor = 0.999 * (1.0 + bounds.distance_along(self.flattening, self.p));
        (x * x + y * y + z * z) * factor < self.limit
    }

    /// Adds the photons of a block that are near enough.
    #[inline(always)]
    fn visit_leaf(&mut self, number: u32) {
        let [x, y, z] = &self.map.blocks[number as usize];
        let ([px, py, pz], [fx, fy, fz]) = (self.p, self.flattening);
        // (A loop that the compiler turns into vectors.)
        let mut squared = [0.0; LEAF];
        for i in 0..LEAF {
            let (x, y, z) = (x[i] - px, y[i] - py, z[i] - pz);
            squared[i] = (x * x + y * y + z * z) * (1.0 + (fx * x + fy * y + fz * z).abs());
        }
        let (limit, mut near) = (Vec4::splat(self.limit), 0);
        for at in (0..LEAF).step_by(4) {
            near |= Vec4::from_slice(&squared[at..]).cmplt(limit).bitmask() << at;
        }
        while near != 0 {
            let i = near.trailing_zeros();
            near &= near - 1;
            // (Photons before have lowered the limit.)
            let squared = squared[i as usize % LEAF];
            if squared < self.limit {
                self.add(squared, number * LEAF as u32 + i);
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
            for flattening in [DVec3::ZERO, DVec3::new(8.0, -3.0, 0.0)] {
                let from = SearchPoint { point: p, flattening };
                let distance = |d: DVec3| d.length() * (1.0 + flattening.dot(d).abs()).sqrt();
                let mut all: Vec<f64> = points.iter().map(|q| distance(*q - p)).collect();
                all.sort_by(f64::total_cmp);
                let radius = map.find_nearest_and_radius(from, 10.0, 40, &mut found);
                assert!(found.len() == 40 && (radius - all[39]).abs() < 1e-6);
                let within = all.iter().filter(|d| **d < 0.1).count();
                let radius = map.find_nearest_and_radius(from, 0.1, 4000, &mut found);
                assert!((radius - 0.1).abs() < 1e-7 && found.len() == within);
            }
        }
    }
}
