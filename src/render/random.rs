//! Random numbers, each known by what it is for: the frame, the pixel, the sample, the surface on the way, and the purpose. So a new
//! draw somewhere shifts no other, and nothing depends on threads or on what else is drawn.

use crate::math::rng;

/// What a number is drawn for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Purpose {
    /// Where a sample lies in its pixel.
    Place,
    /// Where the row of places on a lens begins, for a pixel.
    Lens,
    /// Where the lights of a grid stand, for a shadow.
    AreaLight,
    /// `crand`
    Grain,
    /// The colours of a rainbow.
    Rainbow,
}

/// How many purposes there are.
const PURPOSES: usize = Purpose::Rainbow as usize + 1;

/// Gives the numbers of one sample after another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Random {
    frame: u64,
    pixel: u64,
    sample: u64,
    /// How many surfaces the sample's rays have met.
    vertex: u64,
    /// How many numbers each purpose got there.
    drawn: [u64; PURPOSES],
}

impl Random {
    pub fn new(frame: u32) -> Self {
        Self { frame: u64::from(frame), pixel: 0, sample: 0, vertex: 0, drawn: [0; PURPOSES] }
    }

    /// From here on numbers belong to this sample of this pixel.
    pub fn begin(&mut self, pixel: u64, sample: u64) {
        (self.pixel, self.sample, self.vertex, self.drawn) = (pixel, sample, 0, [0; PURPOSES]);
    }

    /// From here on they belong to the next surface.
    pub fn next_vertex(&mut self) {
        (self.vertex, self.drawn) = (self.vertex + 1, [0; PURPOSES]);
    }

    /// A number in [0, 1).
    pub fn next(&mut self, purpose: Purpose) -> f64 {
        self.row(purpose).at(0)
    }

    /// As many numbers as are asked for.
    pub fn row(&mut self, purpose: Purpose) -> Row {
        let drawn = &mut self.drawn[purpose as usize];
        *drawn += 1;
        Row(rng::word(&[self.frame, self.pixel, self.sample, self.vertex, purpose as u64, *drawn]))
    }

    /// The same for all samples of a pixel.
    pub fn of_pixel(&self, purpose: Purpose) -> Row {
        Row(rng::word(&[self.frame, self.pixel, u64::MAX, purpose as u64]))
    }
}

/// Numbers that are counted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row(u64);

impl Row {
    /// One of them, in [0, 1).
    pub fn at(self, number: u64) -> f64 {
        rng::unit(&[self.0, number])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_draw_shifts_no_other() {
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
