//! Random numbers, each keyed by its use: frame, pixel, sample, vertex of the ray tree, and purpose. A new use shifts no other number, and
//! nothing depends on threads or on what else is rendered.

use crate::math::rng;

/// Use of a random number.
#[derive(Clone, Copy, Debug)]
pub enum Purpose {
    /// Position of a sample in its pixel.
    PixelPosition,
    /// Start of the sequence of points on a lens, for a pixel.
    Lens,
    /// Positions of the lights of a grid, for a shadow.
    AreaLight,
    /// `crand`
    Grain,
    /// `jitter` of a rainbow.
    Rainbow,
}

/// Number of purposes.
const PURPOSES: usize = Purpose::Rainbow as usize + 1;

/// Generates the random numbers of one sample after another.
#[derive(Clone, Copy, Debug)]
pub struct Random {
    frame: u64,
    pixel: u64,
    sample: u64,
    /// Number of surfaces that the sample's rays have hit.
    vertex: u64,
    /// Number of draws at this vertex, by purpose.
    draws: [u64; PURPOSES],
}

impl Random {
    /// The numbers of a frame.
    pub(super) fn new(frame: u32) -> Self {
        Self { frame: u64::from(frame), pixel: 0, sample: 0, vertex: 0, draws: [0; PURPOSES] }
    }

    /// Starts a sample of a pixel.
    pub(super) fn begin(&mut self, pixel: u64, sample: u64) {
        (self.pixel, self.sample, self.vertex, self.draws) = (pixel, sample, 0, [0; PURPOSES]);
    }

    /// Moves on to the next surface.
    pub(super) fn next_vertex(&mut self) {
        (self.vertex, self.draws) = (self.vertex + 1, [0; PURPOSES]);
    }

    /// Returns a number in [0, 1).
    pub fn next(&mut self, purpose: Purpose) -> f64 {
        self.sequence(purpose).at(0)
    }

    /// Returns a sequence of any number of values.
    pub fn sequence(&mut self, purpose: Purpose) -> RandomSequence {
        let draws = &mut self.draws[purpose as usize];
        *draws += 1;
        RandomSequence(rng::random_word(&[self.frame, self.pixel, self.sample, self.vertex, purpose as u64, *draws]))
    }

    /// Returns a sequence that all samples of the pixel share.
    pub fn pixel_sequence(&self, purpose: Purpose) -> RandomSequence {
        RandomSequence(rng::random_word(&[self.frame, self.pixel, u64::MAX, purpose as u64]))
    }
}

/// A sequence of random numbers that can be indexed.
#[derive(Clone, Copy, Debug)]
pub struct RandomSequence(u64);

impl RandomSequence {
    /// Returns one of the numbers, in [0, 1).
    pub fn at(self, number: u64) -> f64 {
        rng::random_unit(&[self.0, number])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_are_independent_of_each_other() {
        let draw = |grains: usize| {
            let mut random = Random::new(3);
            random.begin(5, 7);
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
