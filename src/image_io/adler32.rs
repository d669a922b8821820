//! The checksum Adler-32 of zlib streams (RFC 1950, section 8.2) of parts of a stream, which are combined.

/// Largest prime below 2¹⁶, by which the sums of Adler-32 are divided.
const MODULUS: u64 = 65_521;

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
        let sums = u64::from(simd_adler32::adler32(&bytes));
        Self { sum: sums & 0xffff, sum_of_sums: sums >> 16, length: bytes.len() as u64 % MODULUS }
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
        for end in [0, 1, 703, 65_521, 65_522, bytes.len()] {
            let whole = Adler32::of(&bytes[..end]);
            assert_eq!(whole.to_bytes(), by_definition(&bytes[..end]), "{end}");
            for middle in [0, end / 3, end] {
                let (first, second) = bytes[..end].split_at(middle);
                assert_eq!(Adler32::of(first).then(Adler32::of(second)).to_bytes(), whole.to_bytes(), "{middle} {end}");
            }
        }
    }
}
