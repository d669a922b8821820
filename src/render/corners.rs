//! POV-Ray's second sampling method: a pixel is the mean of its corners, and is halved both ways where those differ (manual,
//! "Anti-Aliasing Options"; that the depth counts the pixel itself was measured on POV-Ray 3.7).

use super::antialias::{Difference, pixel};
use super::grid::{Grid, Pixel};
use super::random::Purpose;
use super::trace::Tracer;
use rustc_hash::FxHashMap;

/// How pixels are halved.
pub(super) struct Corners<'m> {
    pub difference: &'m Difference,
    /// 1: never.
    pub depth: u32,
    /// How far samples are off their places at random, of half of the smallest piece's edge.
    pub jitter: f64,
    /// Of the picture in pixels.
    pub width: usize,
}

/// A pixel that is being looked at.
struct Looking<'a, 'm, 't, 'w> {
    corners: &'a Corners<'m>,
    tracer: &'t mut Tracer<'w>,
    seen: &'a Grid,
    x: usize,
    y: usize,
    /// What was seen between the corners, by place in smallest pieces.
    between: FxHashMap<[u32; 2], Pixel>,
}

impl Corners<'_> {
    /// The smallest pieces along the edge of a pixel.
    fn pieces(&self) -> u32 {
        1 << (self.depth - 1)
    }

    /// What is seen at a place, in smallest pieces from the pixel's top left corner: whichever pixel asks, it is the same.
    pub fn sample(&self, tracer: &mut Tracer, [x, y]: [usize; 2], [right, down]: [u32; 2]) -> Pixel {
        let pieces = self.pieces();
        let (x, y) = (x + (right / pieces) as usize, y + (down / pieces) as usize);
        let (right, down) = (right % pieces, down % pieces);
        // (There is one corner more than pixels in a row.)
        let number = y as u64 * (self.width as u64 + 1) + x as u64;
        tracer.begin(number, u64::from(down) << 32 | u64::from(right));
        let random = tracer.random.row(Purpose::Place);
        let off = |i| if self.jitter == 0.0 { 0.0 } else { (random.at(i) - 0.5) * self.jitter };
        let at = |corner: usize, piece: u32, i| corner as f64 + (f64::from(piece) + off(i)) / f64::from(pieces);
        pixel(&tracer.see(at(x, right, 0), at(y, down, 1)))
    }

    /// A pixel, between corners that are known.
    pub fn pixel(&self, tracer: &mut Tracer, seen: &Grid, x: usize, y: usize) -> Pixel {
        let between = FxHashMap::default();
        let mut looking = Looking { corners: self, tracer, seen, x, y, between };
        looking.piece([0, 0], self.pieces()).map(|c| c as f32)
    }
}

impl Looking<'_, '_, '_, '_> {
    fn at(&mut self, [right, down]: [u32; 2]) -> Pixel {
        let pieces = self.corners.pieces();
        if right % pieces == 0 && down % pieces == 0 {
            return *self.seen.at(self.x + (right / pieces) as usize, self.y + (down / pieces) as usize);
        }
        if let Some(known) = self.between.get(&[right, down]) {
            return *known;
        }
        let seen = self.corners.sample(self.tracer, [self.x, self.y], [right, down]);
        self.between.insert([right, down], seen);
        seen
    }

    /// The mean of a square piece.
    fn piece(&mut self, [right, down]: [u32; 2], edge: u32) -> [f64; 4] {
        let places = [[right, down], [right + edge, down], [right, down + edge], [right + edge, down + edge]];
        let corners = places.map(|place| self.at(place));
        let differ = (1..4).any(|i| (0..i).any(|j| self.corners.difference.counts(&corners[i], &corners[j])));
        let parts = if edge == 1 || !differ || self.tracer.stopped() {
            corners.map(|corner| corner.map(f64::from))
        } else {
            let half = edge / 2;
            [[0, 0], [half, 0], [0, half], [half, half]].map(|[x, y]| self.piece([right + x, down + y], half))
        };
        [0, 1, 2, 3].map(|c| parts.iter().map(|part| part[c]).sum::<f64>() * 0.25)
    }
}
