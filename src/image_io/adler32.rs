//! The checksum Adler-32 of zlib streams: RFC 1950, section 8.2.

/// Largest prime below 2¹⁶, by which the sums of Adler-32 are divided.
const MODULUS: u64 = 65_521;
/// Number of sums that are computed side by side, so that compilers use vectors.
const LANES: usize = 32;
/// Maximum size of a block in bytes: the sums of sums of 22 bytes fit 16 bits.
const BLOCK: usize = 22 * LANES;

/// Checksum of some bytes, which can be combined with that of the bytes after them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Adler32 {
    /// 1 plus the sum of the bytes, modulo [`MODULUS`].
    sum: u64,
    /// Sum of the values of `sum` after each byte, modulo [`MODULUS`].
    sum_of_sums: u64,
    /// Number of bytes, modulo [`MODULUS`].
    length: u64,
}

impl Default for Adler32 {
    /// Returns the checksum of no bytes.
    fn default() -> Self {
        Self { sum: 1, sum_of_sums: 0, length: 0 }
    }
}

impl Adler32 {
    /// Returns the checksum of bytes.
    pub fn of(bytes: &[u8]) -> Self {
        bytes.chunks(BLOCK).map(Self::of_block).fold(Self::default(), Self::then)
    }

    /// Returns the checksum of at most [`BLOCK`] bytes.
    fn of_block(block: &[u8]) -> Self {
        let (rows, rest) = block.as_chunks::<LANES>();
        let (mut sums, mut sums_of_sums) = ([0_u16; LANES], [0_u16; LANES]);
        for row in rows {
            for lane in 0..LANES {
                sums[lane] += u16::from(row[lane]);
                sums_of_sums[lane] += sums[lane];
            }
        }
        // The first of n bytes is a part of n sums, the last of one.
        let length = (rows.len() * LANES) as u64;
        let total = |lanes: [u16; LANES]| lanes.into_iter().map(u64::from).sum::<u64>();
        let excess: u64 = (0..).zip(sums).map(|(lane, sum)| lane * u64::from(sum)).sum();
        let sum_of_sums = length + LANES as u64 * total(sums_of_sums) - excess;
        let whole_rows = Self { sum: 1 + total(sums), sum_of_sums, length };
        rest.iter().map(|byte| Self::of_byte(*byte)).fold(whole_rows, Self::then)
    }

    fn of_byte(byte: u8) -> Self {
        let sum = 1 + u64::from(byte);
        Self { sum, sum_of_sums: sum, length: 1 }
    }

    /// Returns the checksum of these bytes followed by those of `next`. Each of the sums of `next` begins with 1, and
    /// becomes larger by `self.sum - 1`.
    pub fn then(self, next: Self) -> Self {
        let before = self.sum + MODULUS - 1;
        Self {
            sum: (before + next.sum) % MODULUS,
            sum_of_sums: (self.sum_of_sums + next.sum_of_sums + next.length * before) % MODULUS,
            length: (self.length + next.length) % MODULUS,
        }
    }

    /// Returns the checksum as a zlib stream stores it.
    pub fn to_bytes(self) -> [u8; 4] {
        ((self.sum_of_sums << 16 | self.sum) as u32).to_be_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Adler-32 as RFC 1950 defines it, byte by byte.
    fn by_definition(bytes: &[u8]) -> [u8; 4] {
        let (mut a, mut b) = (1, 0);
        for byte in bytes {
            a = (a + u32::from(*byte)) % 65_521;
            b = (b + a) % 65_521;
        }
        (b << 16 | a).to_be_bytes()
    }

    #[test]
    fn checksums_of_parts_combine_to_that_of_the_whole() {
        assert_eq!(Adler32::of(b"Wikipedia").to_bytes(), [0x11, 0xe6, 0x03, 0x98]);
        let bytes: Vec<u8> =
            (0..200_000_u32).map(|i| if i < 100_000 { 255 } else { (i.wrapping_mul(i) >> 7) as u8 }).collect();
        for end in [0, 1, 31, 32, 33, 703, 704, 705, 65_521, 65_522, bytes.len()] {
            let whole = Adler32::of(&bytes[..end]);
            assert_eq!(whole.to_bytes(), by_definition(&bytes[..end]), "{end}");
            for middle in [0, end / 3, end] {
                let (first, second) = bytes[..end].split_at(middle);
                assert_eq!(Adler32::of(first).then(Adler32::of(second)).to_bytes(), whole.to_bytes(), "{middle} {end}");
            }
        }
    }
}
