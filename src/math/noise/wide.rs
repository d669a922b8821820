//! Chooses between [`super::value`] and its AVX2 implementation. Both give the same bits. Each caller has a type as its
//! mark, so that it has a copy of the noise of its own, which the compiler inlines. Functions for a single point take
//! its coordinates as three numbers, in registers. A `DVec3` would be passed through memory: the caller writes
//! coordinates one by one, the noise reads two at once, and the processor's store forwarding fails.

use super::super::DVec3;
use super::{Turbulence, value};
use std::ops::ControlFlow;

/// Defines a function that calls its namesake in `avx2` if the processor has the feature, else the one in `value`.
macro_rules! twins {
    (
        $(#[$doc:meta])*
        $name:ident $(<$state:ident, $visitor:ident: ($($bound:tt)+)>)?
        ($f:ident; $($argument:ident: $type:ty),*) $(-> $out:ty)? $body:block
    ) => {
        $(#[$doc])*
        pub fn $name$(<$state, $visitor: $($bound)+>)?($($argument: $type),*) $(-> $out)? {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2")]
                fn avx2$(<$state, $visitor: $($bound)+>)?($($argument: $type),*) $(-> $out)? {
                    use super::avx2::$f;
                    $body
                }
                if is_x86_feature_detected!("avx2") {
                    // SAFETY: the processor has the feature that the function needs.
                    #[expect(unsafe_code, reason = "the compiler can't know the processor")]
                    return unsafe { avx2($($argument),*) };
                }
            }
            use value::$f;
            $body
        }
    };
}

/// Mark of the noise's copies for a single point.
enum Single {}

/// Mark of the noise's copy for turbulence.
enum Octave {}

twins! {
    /// Computes the noise [`value::scalar_noise`] at a point, with AVX2 if the processor has it.
    scalar_at(scalar_noise; x: f64, y: f64, z: f64) -> f64 {
        scalar_noise::<Single>(DVec3::new(x, y, z))
    }
}

twins! {
    /// Folds octaves of the noise [`value::scalar_noise`] until `step` breaks: the noise at the point, and at its
    /// multiples by the powers of `lacunarity`.
    fold_octaves<T, Step: (Fn(T, f64) -> ControlFlow<T, T>)>(
        scalar_noise; x: f64, y: f64, z: f64, lacunarity: f64, start: T, step: Step
    ) -> T {
        let (mut frequency, mut state) = (1.0, start);
        loop {
            match step(state, scalar_noise::<Step>(DVec3::new(x, y, z) * frequency)) {
                ControlFlow::Continue(next) => state = next,
                ControlFlow::Break(end) => return end,
            }
            frequency *= lacunarity;
        }
    }
}

twins! {
    /// Computes the vector noise [`value::vector_noise`], with AVX2 if the processor has it.
    vector_at(vector_noise; x: f64, y: f64, z: f64) -> DVec3 {
        vector_noise::<Single>(DVec3::new(x, y, z))
    }
}

twins! {
    /// Returns the turbulence at a point: the weighted sum of octaves of [`value::vector_noise`].
    turbulence(vector_noise; x: f64, y: f64, z: f64, series: Turbulence) -> DVec3 {
        let mut sum = DVec3::ZERO;
        for (frequency, weight) in series.octaves() {
            sum += weight * vector_noise::<Octave>(DVec3::new(x, y, z) * frequency);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn avx2_matches_portable_bits() {
        let point = |i: i32| DVec3::new(0.37 * f64::from(i) - 99.0, -1.93 * f64::from(i), 0.011 * f64::from(i));
        let far = [1e18, -1e300, f64::MAX, f64::INFINITY, f64::NAN, -0.0, 1.0, -1.0, 4.5e15, -9.1e15];
        let strange = far.map(|x| DVec3::new(x, 0.5, -x));
        let points: Vec<DVec3> = (0..1001).map(point).chain(strange).collect();
        for p in &points {
            let (scalar_noise, vector) = (value::scalar_noise::<Single>(*p), value::vector_noise::<Single>(*p));
            // (The payload of a NaN does not matter.)
            let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
            assert!(same(scalar_at(p.x, p.y, p.z), scalar_noise), "{p}");
            fold_octaves(p.x, p.y, p.z, 2.2, (3, 1.0), |(left, frequency), octave| {
                assert!(same(octave, value::scalar_noise::<Single>(*p * frequency)), "{p}");
                let next = (left - 1, frequency * 2.2);
                if left == 0 { ControlFlow::Break(next) } else { ControlFlow::Continue(next) }
            });
            assert!(
                vector_at(p.x, p.y, p.z).to_array().into_iter().zip(vector.to_array()).all(|(a, b)| same(a, b)),
                "{p}"
            );
        }
    }
}
