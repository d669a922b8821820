//! Directions of the rays of a radiosity sample.

use crate::math::{DVec3, fp};
use std::f64::consts::TAU;

/// Turn between two points of a sunflower spiral, as a share of the circle: the golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Returns `count` directions about z with a density in proportion to their cosine: a sunflower spiral on the disc (Vogel
/// 1979), projected up to the hemisphere (Malley's method). The first directions of the list are spread evenly, too.
pub fn directions(count: u32) -> Box<[DVec3]> {
    let bits = 32 - (count.max(2) - 1).leading_zeros();
    let reversed = (0..1u32 << bits).map(|i| i.reverse_bits() >> (32 - bits));
    let spiral = |i: u32| {
        let radius2 = (f64::from(i) + 0.5) / f64::from(count);
        let (sin, cos) = fp::sin_cos(TAU * (f64::from(i) * GOLDEN).fract());
        let radius = radius2.sqrt();
        DVec3::new(radius * cos, radius * sin, (1.0 - radius2).max(0.0).sqrt())
    };
    reversed.filter(|&i| i < count).map(spiral).collect()
}

/// Two vectors of length 1 that are orthogonal to a normal and to each other (Duff and others, Building an orthonormal
/// basis, revisited, 2017).
pub fn tangents(n: DVec3) -> [DVec3; 2] {
    let sign = 1f64.copysign(n.z);
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    [DVec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x), DVec3::new(b, sign + n.y * n.y * a, -n.y)]
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

    #[test]
    fn tangents_are_orthonormal() {
        for n in [DVec3::X, DVec3::Z, -DVec3::Z, DVec3::new(0.6, 0.0, -0.8), DVec3::new(1.0, 2.0, 3.0).normalize()] {
            let [t, b] = tangents(n);
            let small = [t.dot(n), b.dot(n), t.dot(b), t.length() - 1.0, b.length() - 1.0];
            assert!(small.iter().all(|x| x.abs() < 1e-12), "{n}");
        }
    }
}
