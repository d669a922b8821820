//! POV-Ray's second sampling method: a pixel is the mean of its corners, and is subdivided where the corners differ
//! (manual, "Anti-Aliasing Options"). The depth counts the pixel itself (quirk: `antialias_depth`).

use super::antialias::Difference;
use super::pixel_area::{Pixel, PixelArea};
use super::sampler::{SamplePoint, Sampler};
use crate::transport::{Purpose, Random};
use rustc_hash::FxHashMap;

/// Settings of the sampling method with corners.
pub(super) struct Corners<'m> {
    pub difference: &'m Difference,
    /// Maximum depth of subdivision, counting the pixel; 1 for none.
    pub depth: u32,
    /// Random displacement of samples, as a share of half of the smallest piece's edge.
    pub jitter: f64,
    /// Width of the picture in pixels.
    pub width: usize,
}

/// Subdivision of one pixel into square pieces.
struct Subdivision<'a, 'm, 't, 'w> {
    corners: &'a Corners<'m>,
    sampler: &'t mut Sampler<'w>,
    corner_samples: &'a PixelArea,
    x: usize,
    y: usize,
    /// Samples within the pixel, by position in units of the smallest piece.
    between: FxHashMap<[u32; 2], Pixel>,
}

impl Corners<'_> {
    /// Number of smallest pieces along the edge of a pixel.
    fn pieces_per_edge(&self) -> u32 {
        1 << (self.depth - 1)
    }

    /// Returns the point at a position, in smallest pieces from the pixel's top left corner. Pixels that share the position get
    /// the same sample.
    pub fn point(&self, random: &Random, [x, y]: [usize; 2], [pieces_right, pieces_down]: [u32; 2]) -> SamplePoint {
        let pieces = self.pieces_per_edge();
        let (x, y) = (x + (pieces_right / pieces) as usize, y + (pieces_down / pieces) as usize);
        let (pieces_right, pieces_down) = (pieces_right % pieces, pieces_down % pieces);
        // (There is one corner more than pixels in a row.)
        let pixel = y as u64 * (self.width as u64 + 1) + x as u64;
        let sample = u64::from(pieces_down) << 32 | u64::from(pieces_right);
        let random = random.first_sequence(pixel, sample, Purpose::PixelPosition);
        let off = |i| if self.jitter == 0.0 { 0.0 } else { (random.at(i) - 0.5) * self.jitter };
        let at = |corner: usize, piece: u32, i| corner as f64 + (f64::from(piece) + off(i)) / f64::from(pieces);
        SamplePoint { x_pixels: at(x, pieces_right, 0), y_pixels: at(y, pieces_down, 1), pixel, sample }
    }

    /// Computes a pixel from the samples at its corners.
    pub fn pixel(&self, sampler: &mut Sampler, corner_samples: &PixelArea, x: usize, y: usize) -> Pixel {
        let between = FxHashMap::default();
        let mut subdivision = Subdivision { corners: self, sampler, corner_samples, x, y, between };
        subdivision.piece_mean([0, 0], self.pieces_per_edge()).map(|c| c as f32)
    }
}

impl Subdivision<'_, '_, '_, '_> {
    /// Returns the sample at a position, in smallest pieces from the pixel's top left corner. Each sample is taken once.
    fn cached_sample(&mut self, [pieces_right, pieces_down]: [u32; 2]) -> Pixel {
        let pieces = self.corners.pieces_per_edge();
        if pieces_right % pieces == 0 && pieces_down % pieces == 0 {
            return *self
                .corner_samples
                .at(self.x + (pieces_right / pieces) as usize, self.y + (pieces_down / pieces) as usize);
        }
        if let Some(known) = self.between.get(&[pieces_right, pieces_down]) {
            return *known;
        }
        let point = self.corners.point(self.sampler.random(), [self.x, self.y], [pieces_right, pieces_down]);
        let sample = self.sampler.sample_at(&point);
        self.between.insert([pieces_right, pieces_down], sample);
        sample
    }

    /// Returns the mean of a square piece, subdivided where its corners differ.
    fn piece_mean(&mut self, [pieces_right, pieces_down]: [u32; 2], edge_pieces: u32) -> [f64; 4] {
        let places = [
            [pieces_right, pieces_down],
            [pieces_right + edge_pieces, pieces_down],
            [pieces_right, pieces_down + edge_pieces],
            [pieces_right + edge_pieces, pieces_down + edge_pieces],
        ];
        let corners = places.map(|place| self.cached_sample(place));
        let differ =
            (1..4).any(|i| (0..i).any(|j| self.corners.difference.reaches_threshold(&corners[i], &corners[j])));
        let parts = if edge_pieces == 1 || !differ || self.sampler.is_stopped() {
            corners.map(|corner| corner.map(f64::from))
        } else {
            let half = edge_pieces / 2;
            [[0, 0], [half, 0], [0, half], [half, half]]
                .map(|[x, y]| self.piece_mean([pieces_right + x, pieces_down + y], half))
        };
        [0, 1, 2, 3].map(|c| parts.iter().map(|part| part[c]).sum::<f64>() * 0.25)
    }
}
