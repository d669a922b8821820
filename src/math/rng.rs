//! Random numbers that are functions of a key, independent of the order of calls.

/// Returns a random number in [0, 1) that is a function of its key alone: (frame, pixel, sample, dimension) or the
/// like. SplitMix64's finaliser (Steele, Lea and Flood 2014) folds the words in.
pub fn random_unit(key: &[u64]) -> f64 {
    unit_of_word(mix_bits(fold_key(key)))
}

/// Start of a key, to which further words can be appended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KeyStart(u64);

impl KeyStart {
    /// Creates the start of a key.
    pub fn new(words: &[u64]) -> Self {
        Self(fold_key(words))
    }

    /// Returns the number of [`random_unit`] for the key that ends with one more word.
    #[inline(always)]
    pub fn unit(self, word: u64) -> f64 {
        unit_of_word(mix_bits(fold_word(self.0, word)))
    }
}

/// Returns the number in [0, 1) of the upper 53 bits of a word.
#[inline(always)]
fn unit_of_word(word: u64) -> f64 {
    (word >> 11) as f64 / (1u64 << 53) as f64
}

/// Returns a random word of 64 bits that is a function of its key alone.
pub fn random_word(key: &[u64]) -> u64 {
    mix_bits(fold_key(key))
}

/// Sequence of random numbers: [`random_unit`] of a key followed by 1, 2, 3 …; for tests. (Rendering code names each
/// number's purpose.)
#[derive(Clone, Copy, Debug)]
pub struct Stream {
    folded: u64,
    dimension: u64,
}

impl Stream {
    /// Creates the sequence of random numbers of this key.
    pub fn new(key: &[u64]) -> Self {
        Self { folded: fold_key(key), dimension: 0 }
    }

    /// Returns the next random number in [0, 1).
    #[allow(clippy::should_implement_trait)]
    pub fn next_random(&mut self) -> f64 {
        self.dimension += 1;
        unit_of_word(mix_bits(fold_word(self.folded, self.dimension)))
    }
}

fn fold_key(key: &[u64]) -> u64 {
    key.iter().fold(0x9e37_79b9_7f4a_7c15, |h, &word| fold_word(h, word))
}

#[inline(always)]
fn fold_word(h: u64, word: u64) -> u64 {
    mix_bits(h ^ word).wrapping_add(0x9e37_79b9_7f4a_7c15)
}

#[inline(always)]
fn mix_bits(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stream_is_a_short_way_to_write_keys() {
        let mut stream = Stream::new(&[3, 1, 4]);
        assert_eq!(
            [stream.next_random(), stream.next_random()],
            [random_unit(&[3, 1, 4, 1]), random_unit(&[3, 1, 4, 2])]
        );
    }

    #[test]
    fn a_key_may_have_a_known_start() {
        assert_eq!(KeyStart::new(&[3, 1]).unit(4), random_unit(&[3, 1, 4]));
    }

    #[test]
    fn numbers_spread_evenly() {
        let mean = (0..10_000).map(|i| random_unit(&[7, i])).sum::<f64>() / 10_000.0;
        assert!((mean - 0.5).abs() < 0.01, "{mean}");
    }
}
