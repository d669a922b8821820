//! Directions of the rays of a radiosity sample.

use crate::math::{DVec2, DVec3, GOLDEN_SECTION, fp};
use std::f64::consts::TAU;

/// Directions about z with a density in proportion to their cosine: a sunflower spiral on the disc (Vogel 1979), projected
/// up to the hemisphere (Malley's method). Each direction is given by its ring of the disc and its angle.
#[derive(Debug)]
pub struct Directions {
    /// Number of the ring, from the centre outwards, and the direction on the disc, of length 1.
    rings: Box<[(f64, DVec2)]>,
}

impl Directions {
    /// Creates `count` directions. The first directions of the list are spread evenly, too.
    pub fn new(count: u32) -> Self {
        let bits = 32 - (count.max(2) - 1).leading_zeros();
        let reversed = (0..1u32 << bits).map(|i| i.reverse_bits() >> (32 - bits));
        let ring = |i: u32| {
            let (sin, cos) = fp::sin_cos(TAU * (f64::from(i) * GOLDEN_SECTION).fract());
            (f64::from(i), DVec2::new(cos, sin))
        };
        Self { rings: reversed.filter(|&i| i < count).map(ring).collect() }
    }

    /// Returns the number of directions.
    pub fn len(&self) -> usize {
        self.rings.len()
    }

    /// Returns direction number `i`, length 1. `shift`, from 0 to 1, places it between the inner and the outer edge of its
    /// ring; all rings have the same area.
    pub fn direction(&self, i: usize, shift: f64) -> DVec3 {
        let (ring, on_disc) = self.rings[i];
        let radius2 = (ring + shift) / self.rings.len() as f64;
        (on_disc * radius2.sqrt()).extend((1.0 - radius2).max(0.0).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_integrate_low_polynomials() {
        // The mean of z over the cosine-weighted hemisphere is 2/3, that of z² is 1/2.
        for count in [1, 2, 35, 100, 1600] {
            let directions = Directions::new(count);
            assert_eq!(directions.len(), count as usize);
            let all: Vec<_> = (0..directions.len()).map(|i| directions.direction(i, 0.5)).collect();
            let tolerance = 0.5 / f64::from(count);
            let mean = |f: &dyn Fn(&DVec3) -> f64| all.iter().map(f).sum::<f64>() / f64::from(count);
            assert!((mean(&|d| d.z) - 2.0 / 3.0).abs() < tolerance, "{count}");
            assert!((mean(&|d| d.z * d.z) - 0.5).abs() < tolerance, "{count}");
            assert!(all.iter().all(|d| (d.length() - 1.0).abs() < 1e-12));
        }
    }

    #[test]
    fn shifts_sample_all_of_the_hemisphere() {
        // The mean over all shifts is exact for any function of the height: that of z⁸ is 1/5.
        let directions = Directions::new(4);
        let heights = (0..1000).flat_map(|k| {
            let shift = (f64::from(k) + 0.5) / 1000.0;
            (0..4).map(move |i| (i, shift))
        });
        let sum: f64 = heights.map(|(i, shift)| directions.direction(i, shift).z.powi(8)).sum();
        assert!((sum / 4000.0 - 0.2).abs() < 1e-6);
    }
}
