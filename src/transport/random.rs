//! Random numbers, each keyed by frame, pixel, sample, vertex of the ray tree, and purpose. Therefore a new use of
//! random numbers changes no other numbers, and they do not depend on threads or on the rendered region.

use crate::math::rng::{self, KeyStart};

/// Use of a random number.
#[derive(Clone, Copy, Debug)]
pub enum Purpose {
    /// Position of a sample in its pixel.
    PixelPosition,
    /// Start of the sequence of points on the lens, for a pixel.
    Lens,
    /// Positions of an area light's lights, for a shadow.
    AreaLight,
    /// Random grain of diffuse light (`crand`).
    Grain,
    /// `jitter` of a rainbow.
    Rainbow,
    /// Positions of samples in media.
    Media,
    /// Positions of samples on and below the surface of translucent solids.
    Subsurface,
}

/// Number of purposes of random numbers.
const PURPOSES: usize = Purpose::Subsurface as usize + 1;

/// Generator of the random numbers of one sample after another.
#[derive(Clone, Copy, Debug)]
pub struct Random {
    frame: u64,
    pixel: u64,
    sample: u64,
    /// Number of ray segments that the sample has traced.
    vertex: u64,
    /// Number of draws at the present vertex, by purpose.
    draws: [u64; PURPOSES],
}

impl Random {
    /// Creates the generator of a frame's random numbers.
    pub(super) fn new(frame: u32) -> Self {
        Self { frame: u64::from(frame), pixel: 0, sample: 0, vertex: 0, draws: [0; PURPOSES] }
    }

    /// Starts a sample of a pixel: later numbers are keyed by both.
    pub(super) fn begin_sample(&mut self, pixel: u64, sample: u64) {
        self.begin_vertex(pixel, sample, 0);
    }

    /// Starts a vertex of a sample of a pixel: as [`Self::begin_sample`] and then [`Self::next_vertex`], `vertex` times.
    pub(super) fn begin_vertex(&mut self, pixel: u64, sample: u64, vertex: u64) {
        (self.pixel, self.sample, self.vertex, self.draws) = (pixel, sample, vertex, [0; PURPOSES]);
    }

    /// Starts the next vertex of the sample's ray tree.
    pub(super) fn next_vertex(&mut self) {
        (self.vertex, self.draws) = (self.vertex + 1, [0; PURPOSES]);
    }

    /// Returns the next random number for a purpose, in [0, 1).
    pub fn next(&mut self, purpose: Purpose) -> f64 {
        self.sequence(purpose).at(0)
    }

    /// Returns an unlimited sequence of random numbers, another one on each call.
    pub fn sequence(&mut self, purpose: Purpose) -> RandomSequence {
        let draws = &mut self.draws[purpose as usize];
        *draws += 1;
        let n = *draws;
        self.nth_sequence([self.pixel, self.sample, self.vertex], purpose, n)
    }

    /// Returns the sequence that [`Self::sequence`] returns first after the start of a sample.
    pub fn first_sequence(&self, pixel: u64, sample: u64, purpose: Purpose) -> RandomSequence {
        self.nth_sequence([pixel, sample, 0], purpose, 1)
    }

    /// Returns the sequence that the call number `n` of [`Self::sequence`], counted from 1, returns at a vertex of a sample of a pixel.
    pub(super) fn nth_sequence(&self, [pixel, sample, vertex]: [u64; 3], purpose: Purpose, n: u64) -> RandomSequence {
        RandomSequence::new(&[self.frame, pixel, sample, vertex, purpose as u64, n])
    }

    /// Returns a sequence of random numbers that all samples of a pixel share.
    pub fn pixel_sequence(&self, pixel: u64, purpose: Purpose) -> RandomSequence {
        RandomSequence::new(&[self.frame, pixel, u64::MAX, purpose as u64])
    }
}

/// A sequence of random numbers that can be indexed.
#[derive(Clone, Copy, Debug, Default)]
pub struct RandomSequence(KeyStart);

impl RandomSequence {
    fn new(key: &[u64]) -> Self {
        Self(KeyStart::new(&[rng::random_word(key)]))
    }

    /// Returns the random number of this index in the sequence, in [0, 1).
    #[inline(always)]
    pub fn at(self, number: u64) -> f64 {
        self.0.unit(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_are_independent_of_each_other() {
        let draw = |grains: usize| {
            let mut random = Random::new(3);
            random.begin_sample(5, 7);
            (0..grains).for_each(|_| assert!(random.next(Purpose::Grain) < 1.0));
            let first = random.next(Purpose::AreaLight);
            random.next_vertex();
            [first, random.next(Purpose::AreaLight), random.next(Purpose::Grain)]
        };
        assert_eq!(draw(0), draw(9));
        let [a, b, c] = draw(0);
        assert!(a != b && b != c && a != c);
    }
}
