//! The tables of the noise, computed at compile time.
//!
//! `tests/noise/measure.py` finds the tables from the output of `vturbulence` and `f_noise_generator` at and between
//! lattice points (quirk: `noise_tables`). Three of them follow from the random numbers of the language's own `rand()`;
//! the fourth is stored.

/// Linear congruential generator of POV-Ray's `rand()`; bits 16 to 30 are the random number.
struct Random(u32);

impl Random {
    const fn next_random(&mut self) -> usize {
        self.0 = self.0.wrapping_mul(1_812_433_253).wrapping_add(12_345);
        (self.0 >> 16 & 0x7fff) as usize
    }
}

/// Hash table of noise generators 1 and 2: a permutation of 0 to 4095.
pub static HASH: [u16; 4096] = shuffled_indices();

/// Starts of the rows of lattice points: element i is four times the low 8 bits of element i of [`HASH`].
static STARTS: [u16; 4096] = starts_of_rows();

/// Index into the hash table of noise generators 1 and 2: a number below 4096.
#[derive(Clone, Copy)]
pub struct HashIndex(usize);

impl HashIndex {
    /// Returns the index with the low 12 bits of a number.
    #[inline(always)]
    pub fn from_low_bits(i: usize) -> Self {
        Self(i & 0xfff)
    }

    /// Returns the bitwise exclusive or of two indices.
    #[inline(always)]
    pub fn xor(self, other: Self) -> Self {
        Self(self.0 ^ other.0)
    }

    /// Returns the hash table's entry, which is an index of the same table.
    #[inline(always)]
    pub fn hash(self) -> Self {
        Self(usize::from(self.entry_of(&HASH)))
    }

    /// Returns the row of the lattice point whose hash is the table's entry.
    #[inline(always)]
    pub fn row(self) -> RowStart {
        RowStart(usize::from(self.entry_of(&STARTS)))
    }

    #[inline(always)]
    fn entry_of(self, table: &[u16; 4096]) -> u16 {
        // SAFETY: `from_low_bits` makes numbers below 4096, entries of `HASH` are below 4096, and so is what `xor`
        // makes of both.
        #[expect(unsafe_code, reason = "bounds checks here and of the rows take a tenth of the noise's time")]
        unsafe {
            *table.get_unchecked(self.0)
        }
    }
}

/// Start of a lattice point's row in [`CORNERS`], and of its first row in [`super::value::LANES`], in numbers from the
/// start of the table: four times the index of the row. (The processor can multiply by 8 bytes in an address, but not by
/// the 32 bytes of a row.)
#[derive(Clone, Copy)]
pub struct RowStart(usize);

impl RowStart {
    /// Returns the row of a table that is `ROWS` rows after the lattice point's row.
    #[inline(always)]
    pub fn row_after<const ROWS: usize, const N: usize>(self, table: &[Row; N]) -> &Row {
        const { assert!(256 + ROWS <= N) }
        // SAFETY: starts come from `STARTS` alone. They are multiples of 4 up to 1020, so that the row is one of the
        // first 256; and the table has at least `ROWS` more.
        #[expect(unsafe_code, reason = "bounds checks here and of the hashes take a tenth of the noise's time")]
        unsafe {
            &*table.as_ptr().cast::<f64>().add(self.0).cast::<Row>().add(ROWS)
        }
    }
}

/// Row of a table of noise: four numbers with the alignment for one load; without it, compilers use two.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub struct Row(pub [f64; 4]);

/// Value and gradient of a lattice point in noise generators 1 and 2, by the low 8 bits of its hash.
pub static CORNERS: [Row; 256] = corner_table();

/// Hash table of noise generator 3: nearly a permutation of 0 to 2047.
pub static PERMUTATION: [u16; 2048] = FOR_PERLIN.1;

/// Gradients of length 1 in noise generator 3; the first is repeated at the end.
pub static GRADIENTS: [[f64; 3]; 2049] = FOR_PERLIN.0;

/// Shuffles 0 to 4095: from the last entry to the first, each is exchanged with any other.
const fn shuffled_indices() -> [u16; 4096] {
    let (mut table, mut i) = ([0; 4096], 0);
    while i < 4096 {
        table[i] = i as u16;
        i += 1;
    }
    let mut random = Random(0);
    while i > 0 {
        i -= 1;
        table.swap(i, random.next_random() & 0xfff);
    }
    table
}

/// Computes [`STARTS`].
const fn starts_of_rows() -> [u16; 4096] {
    let (mut starts, mut i) = (shuffled_indices(), 0);
    while i < 4096 {
        starts[i] = 4 * (starts[i] & 0xff);
        i += 1;
    }
    starts
}

/// Computes the values and gradients of lattice points: each row begins one entry later in [`ENTRIES`], and values are
/// halved.
const fn corner_table() -> [Row; 256] {
    let (mut rows, mut i) = ([Row([0.0; 4]); 256], 0);
    while i < 256 {
        rows[i] = Row([0.5 * ENTRIES[i], ENTRIES[i + 1], ENTRIES[i + 2], ENTRIES[i + 3]]);
        i += 1;
    }
    rows
}

/// Returns one of the 267 numbers from which the values and gradients of the noise are made.
pub const fn table_entry(i: usize) -> f64 {
    ENTRIES[i]
}

const FOR_PERLIN: ([[f64; 3]; 2049], [u16; 2048]) = {
    let mut random = Random(1);
    (gradients(&mut random), permutation(&mut random))
};

/// Computes gradients of noise: random points of the unit ball, projected to its surface.
const fn gradients(random: &mut Random) -> [[f64; 3]; 2049] {
    let (mut table, mut i) = ([[0.0; 3]; 2049], 0);
    while i < 2048 {
        let [x, y, z] = [random_coordinate(random), random_coordinate(random), random_coordinate(random)];
        let square = x * x + y * y + z * z;
        if square <= 1.0 {
            let length = square_root(square);
            table[i] = [x / length, y / length, z / length];
            i += 1;
        }
    }
    table[2048] = table[0];
    table
}

/// Returns a random coordinate in [-1, 1).
const fn random_coordinate(random: &mut Random) -> f64 {
    (random.next_random() % 4096) as f64 / 2048.0 - 1.0
}

/// Computes a square root by Newton's method, for numbers up to 1; the standard library's is not const.
const fn square_root(square: f64) -> f64 {
    let (mut root, mut steps) = (1.0, 0);
    while steps < 16 {
        root = 0.5 * (root + square / root);
        steps += 1;
    }
    root
}

/// Shuffles 0 to 2047 for noise generator 3: every second entry is exchanged with any other. POV-Ray begins one entry
/// after the end, which is 0: so 0 is in the table twice.
const fn permutation(random: &mut Random) -> [u16; 2048] {
    let (mut places, mut i) = ([0; 2049], 0);
    while i < 2048 {
        places[i] = i as u16;
        i += 1;
    }
    while i > 0 {
        places.swap(i, random.next_random() % 2048);
        i -= 2;
    }
    let mut table = [0; 2048];
    while i < 2048 {
        table[i] = places[i];
        i += 1;
    }
    table
}

/// Values and gradients of lattice points in noise generators 1 and 2: multiples of 2/65535 from -1 on, rounded to 6
/// digits (quirk: `noise_tables`).
#[rustfmt::skip]
const ENTRIES: [f64; 267] = [
    -1.0, 0.604974, -0.937102, 0.414115, 0.576226, -0.0161593, 0.432334, 0.103685, 0.590539, 0.0286412, 0.46981,
    -0.84622, -0.0734112, -0.304097, -0.40206, -0.210132, -0.919127, 0.652033, -0.83151, -0.183948, -0.671107,
    0.852476, 0.043595, -0.404532, 0.75494, -0.335653, 0.618433, 0.605707, 0.708583, -0.477195, 0.899474, 0.490623,
    0.221729, -0.400381, -0.853727, -0.932586, 0.659113, 0.961303, 0.325948, -0.750851, 0.842466, 0.734401,
    -0.649866, 0.394491, -0.466056, -0.434073, 0.109026, 0.0847028, -0.738857, 0.241505, 0.16228, -0.71426,
    -0.883665, -0.150408, -0.90396, -0.686549, -0.785214, 0.488548, 0.0246433, 0.142473, -0.602136, 0.375845,
    -0.00779736, 0.498955, -0.268147, 0.856382, -0.386007, -0.596094, -0.867735, -0.570977, -0.914366, 0.28896,
    0.672206, -0.233783, 0.94815, 0.895262, 0.343252, -0.173388, -0.767971, -0.314748, 0.824308, -0.342092,
    0.721431, -0.24004, -0.63653, 0.553277, 0.376272, 0.158984, -0.452659, 0.396323, -0.420676, -0.454154, 0.122179,
    0.295857, 0.0664225, -0.202075, -0.724788, 0.453513, 0.224567, -0.908812, 0.176349, -0.320516, -0.697139,
    0.742702, -0.900786, 0.471489, -0.133532, 0.119127, -0.889769, -0.23183, -0.669673, -0.046891, -0.803433,
    -0.966735, 0.475578, -0.652644, 0.0112459, -0.730007, 0.128283, 0.145647, -0.619318, 0.272023, 0.392966,
    0.646418, -0.0207675, -0.315908, 0.480797, 0.535668, -0.250172, -0.83093, -0.653773, -0.443809, 0.119982,
    -0.897642, 0.89453, 0.165789, 0.633875, -0.886839, 0.930877, -0.537194, 0.587732, 0.722011, -0.209461,
    -0.0424659, -0.814267, -0.919432, 0.280262, -0.66302, -0.558099, -0.537469, -0.598779, 0.929656, -0.170794,
    -0.537163, 0.312581, 0.959442, 0.722652, 0.499931, 0.175616, -0.534874, -0.685115, 0.444999, 0.17171, 0.108202,
    -0.768704, -0.463828, 0.254231, 0.546014, 0.869474, 0.875212, -0.944427, 0.130724, -0.110185, 0.312184,
    -0.33138, -0.629206, 0.0606546, 0.722866, -0.0979477, 0.821561, 0.0931258, -0.972808, 0.0318151, -0.867033,
    -0.387228, 0.280995, -0.218189, -0.539178, -0.427359, -0.602075, 0.311971, 0.277974, 0.773159, 0.592493,
    -0.0331884, -0.630854, -0.269947, 0.339132, 0.581079, 0.209461, -0.317433, -0.284993, 0.181323, 0.341634,
    0.804959, -0.229572, -0.758907, -0.336721, 0.605463, -0.991272, -0.0188754, -0.300191, 0.368307, -0.176135,
    -0.3832, -0.749569, 0.62356, -0.573938, 0.278309, -0.971313, 0.839994, -0.830686, 0.439078, 0.66128, 0.694514,
    0.0565042, 0.54342, -0.438804, -0.0228428, -0.687068, 0.857267, 0.301991, -0.494255, -0.941039, 0.775509,
    0.410575, -0.362081, -0.671534, -0.348379, 0.932433, 0.886442, 0.868681, -0.225666, -0.062211, -0.0976425,
    -0.641444, -0.848112, 0.724697, 0.473503, 0.998749, 0.174701, 0.559625, -0.029099, -0.337392, -0.958129,
    -0.659785, 0.236042, -0.246937, 0.659449, -0.027512, 0.821897, -0.226215, 0.0181735, 0.500481, -0.420127,
    -0.427878, 0.566186,
];
