//! Random numbers that depend on what they are for, never on who asks first.

/// A number in [0, 1) that is a function of its key alone: (frame, pixel, sample, dimension) or the
/// like. SplitMix64's finaliser (Steele, Lea and Flood 2014) folds the words in.
pub fn unit(key: &[u64]) -> f64 {
    let mut h = 0x9e37_79b9_7f4a_7c15_u64;
    for &word in key {
        h = mix(h ^ word).wrapping_add(0x9e37_79b9_7f4a_7c15);
    }
    (mix(h) >> 11) as f64 / (1u64 << 53) as f64
}

fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
