//! A photon map: a balanced kd-tree of photons with a search for the nearest ones (Jensen, Realistic Image Synthesis
//! Using Photon Mapping, 2001).

use crate::color::Rgb;
use crate::math::{DVec3, cancel};
use glam::Vec4;

/// Maximum number of photons of a leaf of the tree.
const LEAF: usize = 16;

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

/// Found photons: squared distances and indices. A heap with the farthest photon first when the list is full.
pub type Found = Vec<(f32, u32)>;

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

    /// Finds the at most `count` photons nearest to a point within a radius, and returns the radius that they fill: the
    /// distance of the farthest one if there are `count`, the radius of the search otherwise.
    pub fn find_nearest_and_radius(&self, p: DVec3, radius: f64, count: usize, found: &mut Found) -> f64 {
        found.clear();
        let mut search = Search { map: self, p: p.as_vec3().to_array(), limit: (radius * radius) as f32, count, found };
        let [low, high] = self.bounds;
        let apart = [0, 1, 2].map(|i| (low[i] - search.p[i]).max(search.p[i] - high[i]).max(0.0));
        let [x, y, z] = apart;
        if x * x + y * y + z * z < search.limit {
            search.visit(0, self.len(), apart);
        }
        f64::from(search.limit).sqrt()
    }

    /// Returns the mean radius of a ball around a photon that contains `count` photons, the one at the centre included.
    pub fn mean_radius_holding_count(&self, count: usize) -> f64 {
        let n = self.len().min(RADIUS_SAMPLES);
        let (mut sum, mut found) = (0.0, Found::new());
        for i in 0..n {
            let p = DVec3::from_array(self.position(i * self.len() / n).map(f64::from));
            self.find_nearest_and_radius(p, f64::MAX.sqrt(), count.min(self.len()), &mut found);
            sum += found.first().map_or(0.0, |(squared, _)| f64::from(*squared).sqrt());
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

impl Search<'_> {
    /// Searches the photons of a range of the tree. `axis_distances` is the distance of the point from the range's part
    /// of space along each axis (S. Arya and D. M. Mount, "Algorithms for fast vector quantization", 1993).
    fn visit(&mut self, from: usize, to: usize, axis_distances: [f32; 3]) {
        if to - from <= LEAF {
            return self.visit_leaf(from, to);
        }
        let middle = from + (to - from) / 2;
        let axis = self.map.axes[middle] as usize;
        let beyond = self.p[axis] - self.map.positions[axis][middle];
        let (near, far) =
            if beyond < 0.0 { ((from, middle), (middle + 1, to)) } else { ((middle + 1, to), (from, middle)) };
        self.visit(near.0, near.1, axis_distances);
        let mut apart_of_far = axis_distances;
        apart_of_far[axis] = beyond;
        let [x, y, z] = apart_of_far;
        if x * x + y * y + z * z < self.limit {
            self.visit_one(middle);
            self.visit(far.0, far.1, apart_of_far);
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
    #[inline]
    fn visit_leaf(&mut self, from: usize, to: usize) {
        let blocks = self.map.positions.each_ref().map(|list| list[from..].first_chunk::<LEAF>());
        let [Some(x), Some(y), Some(z)] = blocks else { return };
        let [px, py, pz] = self.p.map(Vec4::splat);
        let (mut squared, mut near) = ([0.0; LEAF], 0);
        // Four photons at once; those beyond the range are ignored afterwards.
        for at in (0..LEAF).step_by(4) {
            let [x, y, z] = [x, y, z].map(|list| Vec4::from_slice(&list[at..]));
            let (x, y, z) = (x - px, y - py, z - pz);
            let block = x * x + y * y + z * z;
            block.write_to_slice(&mut squared[at..]);
            near |= block.cmplt(Vec4::splat(self.limit)).bitmask() << at;
        }
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
    fn add(&mut self, squared_distance: f32, i: u32) {
        if self.found.len() < self.count {
            self.found.push((squared_distance, i));
            if self.found.len() == self.count {
                (0..self.count / 2).rev().for_each(|i| sift_down(self.found, i));
                self.limit = self.found[0].0;
            }
        } else {
            self.found[0] = (squared_distance, i);
            sift_down(self.found, 0);
            self.limit = self.found[0].0;
        }
    }
}

/// Restores the order of a heap below the entry `i`.
fn sift_down(heap: &mut [(f32, u32)], mut i: usize) {
    loop {
        let mut child = 2 * i + 1;
        if child >= heap.len() {
            return;
        }
        if child + 1 < heap.len() && heap[child + 1].0 > heap[child].0 {
            child += 1;
        }
        if heap[child].0 <= heap[i].0 {
            return;
        }
        heap.swap(i, child);
        i = child;
    }
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
        let mut found = Found::new();
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
