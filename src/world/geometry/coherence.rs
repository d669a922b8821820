//! Choice between packets of rays and single rays.

use crate::math::packet::{Flags, MIN_RAYS};

/// Number of tested boxes after which packets are compared with single rays.
const TESTED_BOXES: u32 = 48;
/// Mean number of rays that hit a tested box, times two, below which single rays are quicker than packets.
const TWICE_RAYS_PER_BOX: u32 = 5;
/// Number of packets whose rays are traced one by one before packets are tried again.
const SINGLE_PACKETS: u32 = 64;

/// Measure of whether packets of rays are quicker than single rays, by the packets before: among many small objects they are not. A
/// hint, which never changes a result.
#[derive(Debug, Default)]
pub struct Coherence {
    /// Number of boxes that packets tested.
    n_boxes: u32,
    /// Sum of the numbers of rays that hit each of these boxes.
    n_rays: u32,
    /// Number of packets whose rays are to be traced one by one.
    n_single: u32,
}

impl Coherence {
    /// True if the rays of the next packet, of which `counts` count, are to be traced one by one.
    pub(super) fn next_is_single(&mut self, counts: Flags) -> bool {
        let is_single = self.n_single > 0;
        self.n_single -= u32::from(is_single);
        is_single || (counts.bits().count_ones() as usize) < MIN_RAYS
    }

    /// Records how many boxes a packet tested, and the sum of the numbers of rays that hit each.
    pub(super) fn record(&mut self, [n_boxes, n_rays]: [u32; 2]) {
        (self.n_boxes, self.n_rays) = (self.n_boxes + n_boxes, self.n_rays + n_rays);
        if self.n_boxes >= TESTED_BOXES {
            let is_slow = 2 * self.n_rays < TWICE_RAYS_PER_BOX * self.n_boxes;
            *self = Self { n_single: if is_slow { SINGLE_PACKETS } else { 0 }, ..Self::default() };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packets_whose_rays_hit_few_boxes_together_are_traced_singly_for_a_while() {
        let (all, two) = (Flags::from_bits(0xff), Flags::from_bits(0b1001));
        let mut coherence = Coherence::default();
        assert!(coherence.next_is_single(two) && !coherence.next_is_single(all));
        coherence.record([40, 40]);
        assert!(!coherence.next_is_single(all), "not enough boxes to judge by");
        coherence.record([40, 40]);
        assert!((0..SINGLE_PACKETS).all(|_| coherence.next_is_single(all)) && !coherence.next_is_single(all));
        coherence.record([80, 400]);
        assert!(!coherence.next_is_single(all));
    }
}
