//! Random numbers of unit cubes, for the patterns `cells` and `crackle`.
//!
//! There are 4096 numbers, one for each hash of a cube: the output of the Mersenne Twister with its default seed (M.
//! Matsumoto and T. Nishimura 1998; quirk: `noise_tables`).

use super::lattice;
use super::tables::HASH;
use crate::math::DVec3;
use std::cell::RefCell;

/// A unit cube of a cellular pattern, by integer coordinates whose low bits are exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell(pub [usize; 3]);

impl Cell {
    /// Returns the unit cube that contains a point, and the point's position in the cube, 0 to 1 along each axis.
    pub fn cell_and_position(p: DVec3) -> (Self, DVec3) {
        let ((i, x), (j, y), (k, z)) = (
            lattice::lattice_cell_and_position(p.x),
            lattice::lattice_cell_and_position(p.y),
            lattice::lattice_cell_and_position(p.z),
        );
        (Self([i, j, k]), DVec3::new(x, y, z))
    }

    /// Returns the unit cube at this offset from the cube.
    pub fn offset_by(self, by: [isize; 3]) -> Self {
        Self([0, 1, 2].map(|axis| self.0[axis].wrapping_add_signed(by[axis])))
    }

    /// Returns the unit cube's random number, 0 to 1.
    pub fn random(self) -> f64 {
        RANDOM[self.hash()]
    }

    /// Returns a random point in the unit cube, 0 to 1 along each axis; x is [`Self::random`].
    pub fn random_offset_in_cell(self) -> DVec3 {
        let hash = self.hash();
        DVec3::new(RANDOM[hash], RANDOM[hash + 1], RANDOM[hash + 2])
    }

    /// Hash of the unit cube: the permutation is applied to x, y and z in turn (Perlin 1985).
    fn hash(self) -> usize {
        let [x, y, z] = self.0;
        hash_index(hash_index(hash_index(x) ^ y) ^ z)
    }

    /// Calls `look`, which must not call this function again, with the random points of the unit cube and of those
    /// around it. Each thread caches some of them, since neighbouring points need the same ones.
    pub fn with_neighbour_points<T>(self, look: impl FnOnce(&Around) -> T) -> T {
        REMEMBERED.with_borrow_mut(|remembered| {
            let around = &mut remembered[self.cache_slot()];
            if !(around.known && around.cell == self) {
                around.fill_points(self);
            }
            look(around)
        })
    }
}

impl Cell {
    /// Returns the entry of the unit cube in the cache. The 64 cubes of a block of 4x4x4 have different entries; their
    /// order differs between blocks, so that two patterns that are some blocks apart do not replace each other's cubes.
    fn cache_slot(self) -> usize {
        let [x, y, z] = self.0;
        let block = (x >> 2).wrapping_mul(7) ^ (y >> 2).wrapping_mul(13) ^ (z >> 2).wrapping_mul(29);
        (x & 3 | (y & 3) << 2 | (z & 3) << 4) ^ (block & 63)
    }
}

fn hash_index(i: usize) -> usize {
    HASH[i & 0xfff] as usize
}

/// The random points of a unit cube and of the 26 around it.
pub struct Around {
    cell: Cell,
    known: bool,
    /// Coordinates x, y and z of the random points relative to the corner of the central cube, in the order of `NEXT`;
    /// unused entries are infinite.
    pub points: [[f64; 28]; 3],
}

/// Offsets of a unit cube and of those that touch it, the nearer ones first.
const NEXT: [[isize; 3]; 27] = neighbour_offsets();

const fn neighbour_offsets() -> [[isize; 3]; 27] {
    let (mut out, mut n, mut far) = ([[0; 3]; 27], 0, 0);
    while far <= 3 {
        let mut code = 0;
        while code < 27 {
            let step = [code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1];
            if step[0] * step[0] + step[1] * step[1] + step[2] * step[2] == far {
                out[n] = step;
                n += 1;
            }
            code += 1;
        }
        far += 1;
    }
    out
}

impl Around {
    const NOTHING: Self = Self { cell: Cell([0; 3]), known: false, points: [[0.0; 28]; 3] };

    /// Replaces the cached random points by those around another unit cube.
    fn fill_points(&mut self, cell: Cell) {
        (self.cell, self.known) = (cell, true);
        self.points = [[f64::INFINITY; 28]; 3];
        let [x, y, z] = cell.0.map(|i| [i.wrapping_sub(1), i, i.wrapping_add(1)]);
        // As `Cell::hash`, but shared lookups are done once.
        let columns = x.map(|x| y.map(|y| hash_index(hash_index(x) ^ y)));
        for (n, step) in NEXT.iter().enumerate() {
            let [i, j, k] = step.map(|step| (step + 1) as usize);
            let hash = hash_index(columns[i][j] ^ z[k]);
            for axis in 0..3 {
                self.points[axis][n] = step[axis] as f64 + RANDOM[hash + axis];
            }
        }
    }
}

impl Around {
    /// Returns the three least squared distances from a position to the random points, ascending, and the index of the
    /// nearest point. NaN is ignored.
    pub fn nearest_squared_distances(&self, from: DVec3) -> ([f64; 3], Option<usize>) {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has the feature that the function needs.
            #[expect(unsafe_code, reason = "the compiler can't know the processor")]
            return unsafe { self.nearest_squared_distances_avx2(from) };
        }
        self.nearest_squared_distances_portably(from)
    }

    /// Computes [`Self::nearest_squared_distances`] with AVX2, four numbers at once.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn nearest_squared_distances_avx2(&self, from: DVec3) -> ([f64; 3], Option<usize>) {
        self.nearest_squared_distances_portably(from)
    }

    /// Computes [`Self::nearest_squared_distances`] with loops for automatic vectorisation.
    #[inline(always)]
    fn nearest_squared_distances_portably(&self, from: DVec3) -> ([f64; 3], Option<usize>) {
        let [xs, ys, zs] = &self.points;
        let mut sums = [0.0; 28];
        for i in 0..28 {
            let way = DVec3::new(xs[i] - from.x, ys[i] - from.y, zs[i] - from.z);
            sums[i] = way.x * way.x + way.y * way.y + way.z * way.z;
        }
        // The three smallest of each of four lanes, then of all.
        let mut least = [[f64::INFINITY; 4]; 3];
        for four in sums.chunks_exact(4) {
            for lane in 0..4 {
                let before = [least[0][lane], least[1][lane], least[2][lane]];
                let [first, second, third] = insert_into_three_smallest(before, four[lane]);
                (least[0][lane], least[1][lane], least[2][lane]) = (first, second, third);
            }
        }
        let three =
            least.as_flattened().iter().fold([f64::INFINITY; 3], |best, sum| insert_into_three_smallest(best, *sum));
        (three, sums.iter().position(|sum| *sum == three[0]))
    }
}

/// Returns the three smallest of four numbers, ascending, without branches; the first three are ascending already.
#[inline(always)]
fn insert_into_three_smallest([first, second, third]: [f64; 3], new: f64) -> [f64; 3] {
    let order = |a: f64, b: f64| if a < b { (a, b) } else { (b, a) };
    let (first, new) = order(new, first);
    let (second, new) = order(new, second);
    [first, second, order(new, third).0]
}

thread_local! {
    /// Cache of random points with an entry for each of 4x4x4 adjacent unit cubes.
    static REMEMBERED: RefCell<[Around; 64]> = const { RefCell::new([Around::NOTHING; 64]) };
}

/// Random numbers of unit cubes, by hash; the last two entries are the second and third coordinate for the last hash.
static RANDOM: [f64; 4098] = mersenne_twister();

/// Random numbers of the generator MT19937 from seed 5489.
const fn mersenne_twister() -> [f64; 4098] {
    const N: usize = 624;
    let (mut state, mut i) = ([5489u32; N], 1);
    while i < N {
        let last = state[i - 1];
        state[i] = (last ^ last >> 30).wrapping_mul(1_812_433_253).wrapping_add(i as u32);
        i += 1;
    }
    let (mut out, mut n) = ([0.0; 4098], 0);
    while n < out.len() {
        // the recurrence
        let i = n % N;
        let y = state[i] & 0x8000_0000 | state[(i + 1) % N] & 0x7fff_ffff;
        let twist = if y & 1 == 1 { 0x9908_b0df } else { 0 };
        state[i] = state[(i + 397) % N] ^ y >> 1 ^ twist;
        // tempering
        let mut y = state[i];
        y ^= y >> 11;
        y ^= y << 7 & 0x9d2c_5680;
        y ^= y << 15 & 0xefc6_0000;
        y ^= y >> 18;
        out[n] = y as f64 / 4_294_967_296.0;
        n += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mersenne_twister_reference_values() {
        // The C++ standard's `mt19937` gives 4123659995 as its 10 000th number; its first are these.
        assert_eq!(
            RANDOM[..2].iter().map(|r| r * 4_294_967_296.0).collect::<Vec<_>>(),
            [3_499_211_612.0, 581_869_302.0]
        );
    }

    #[test]
    fn neighbours_match_single_cubes() {
        for corner in [[0; 3], [5, 4095, usize::MAX], [1, 2, 7], [4097, 2, 7]].map(Cell) {
            corner.with_neighbour_points(|around| {
                for (n, step) in NEXT.iter().enumerate() {
                    let point = DVec3::from(step.map(|i| i as f64)) + corner.offset_by(*step).random_offset_in_cell();
                    assert_eq!(point, DVec3::from([0, 1, 2].map(|axis| around.points[axis][n])));
                }
            });
        }
    }

    #[test]
    fn cells_reach_below_zero() {
        let (cell, within) = Cell::cell_and_position(DVec3::new(-0.25, 1.5, 3.0));
        assert_eq!(within, DVec3::new(0.75, 0.5, 0.0));
        assert_eq!(cell.random(), Cell([0, 1, 3]).offset_by([-1, 0, 0]).random());
        assert_eq!(cell.random(), cell.random_offset_in_cell().x);
    }
}
