//! Directions of the rays of a radiosity sample.

use crate::math::{DVec3, GOLDEN_SECTION, fp};
use std::f64::consts::TAU;

/// Returns `count` directions about z with a density in proportion to their cosine: a sunflower spiral on the disc (Vogel
/// 1979), projected up to the hemisphere (Malley's method). The first directions of the list are spread evenly, too.
pub fn directions(count: u32) -> Box<[DVec3]> {
    let bits = 32 - (count.max(2) - 1).leading_zeros();
    let reversed = (0..1u32 << bits).map(|i| i.reverse_bits() >> (32 - bits));
    let spiral = |i: u32| {
        let radius2 = (f64::from(i) + 0.5) / f64::from(count);
        let (sin, cos) = fp::sin_cos(TAU * (f64::from(i) * GOLDEN_SECTION).fract());
        let radius = radius2.sqrt();
        DVec3::new(radius * cos, radius * sin, (1.0 - radius2).max(0.0).sqrt())
    };
    reversed.filter(|&i| i < count).map(spiral).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_integrate_low_polynomials() {
        // The mean of z over the cosine-weighted hemisphere is 2/3, that of z² is 1/2.
        for count in [1, 2, 35, 100, 1600] {
            let all = directions(count);
            assert_eq!(all.len(), count as usize);
            let tolerance = 0.5 / f64::from(count);
            let mean = |f: &dyn Fn(&DVec3) -> f64| all.iter().map(f).sum::<f64>() / f64::from(count);
            assert!((mean(&|d| d.z) - 2.0 / 3.0).abs() < tolerance, "{count}");
            assert!((mean(&|d| d.z * d.z) - 0.5).abs() < tolerance, "{count}");
            assert!(all.iter().all(|d| (d.length() - 1.0).abs() < 1e-12));
        }
    }
}
