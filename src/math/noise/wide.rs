//! Chooses between [`super::value`] and its implementations for AVX2 and AVX-512. All give the same bits. Each caller
//! has a type as its mark, so that it has a copy of the noise of its own, which the compiler inlines. Functions for a
//! single point take its coordinates as three numbers, in registers. A `DVec3` would be passed through memory: the
//! caller writes coordinates one by one, the noise reads two at once, and the processor's store forwarding fails.
//!
//! Sums of octaves find the lattice cell of the next octave before they compute the noise of this one. Otherwise the
//! operations that wait for this octave's tables fill the processor's queues, and the next octave cannot begin.

use super::super::DVec3;
use super::{Turbulence, value};
use std::ops::ControlFlow;

/// Defines a function whose body is compiled three times: with the modules `avx2` and `avx512` under the name that comes
/// first, for processors with these features, and with the module `value` for all others.
macro_rules! versions {
    (
        $(#[$doc:meta])*
        $name:ident $(<$state:ident, $visitor:ident: ($($bound:tt)+)>)?
        ($lanes:ident; $($argument:ident: $type:ty),*) $(-> $out:ty)? $body:block
    ) => {
        $(#[$doc])*
        pub fn $name$(<$state, $visitor: $($bound)+>)?($($argument: $type),*) $(-> $out)? {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2")]
                fn avx2$(<$state, $visitor: $($bound)+>)?($($argument: $type),*) $(-> $out)? {
                    use super::avx2 as $lanes;
                    $body
                }
                #[target_feature(enable = "avx2,avx512f,avx512dq,avx512vl")]
                fn avx512$(<$state, $visitor: $($bound)+>)?($($argument: $type),*) $(-> $out)? {
                    use super::avx512 as $lanes;
                    $body
                }
                if is_x86_feature_detected!("avx512vl") && is_x86_feature_detected!("avx512dq") {
                    // SAFETY: the processor has the features that the function needs; AVX-512 implies AVX2.
                    #[expect(unsafe_code, reason = "the compiler can't know the processor")]
                    return unsafe { avx512($($argument),*) };
                }
                if is_x86_feature_detected!("avx2") {
                    // SAFETY: the processor has the feature that the function needs.
                    #[expect(unsafe_code, reason = "the compiler can't know the processor")]
                    return unsafe { avx2($($argument),*) };
                }
            }
            use value as $lanes;
            $body
        }
    };
}

/// Mark of the noise's copies for a single point.
enum Single {}

/// Mark of the noise's copy for turbulence.
enum Octave {}

versions! {
    /// Computes the noise [`value::scalar_noise`] at a point.
    scalar_at(lanes; x: f64, y: f64, z: f64) -> f64 {
        lanes::scalar_noise::<Single>(lanes::locate::<Single>(lanes::vector(x, y, z)))
    }
}

versions! {
    /// Folds octaves of the noise [`value::scalar_noise`] until `step` breaks: the noise at the point, and at its
    /// multiples by the powers of `lacunarity`.
    fold_octaves<T, Step: (Fn(T, f64) -> ControlFlow<T, T>)>(
        lanes; x: f64, y: f64, z: f64, lacunarity: f64, start: T, step: Step
    ) -> T {
        let p = lanes::vector(x, y, z);
        let (mut frequency, mut here, mut state) = (1.0, lanes::locate::<Step>(p), start);
        loop {
            frequency *= lacunarity;
            let next = lanes::locate::<Step>(lanes::times(frequency, p));
            match step(state, lanes::scalar_noise::<Step>(here)) {
                ControlFlow::Continue(continued) => state = continued,
                ControlFlow::Break(end) => return end,
            }
            here = next;
        }
    }
}

versions! {
    /// Computes the vector noise [`value::vector_noise`].
    vector_at(lanes; x: f64, y: f64, z: f64) -> DVec3 {
        lanes::components(lanes::vector_noise::<Single>(lanes::locate::<Single>(lanes::vector(x, y, z))))
    }
}

versions! {
    /// Returns the turbulence at a point: the weighted sum of octaves of [`value::vector_noise`].
    turbulence(lanes; x: f64, y: f64, z: f64, series: Turbulence) -> DVec3 {
        let p = lanes::vector(x, y, z);
        let (mut here, mut sum) = (lanes::locate::<Octave>(p), lanes::vector(0.0, 0.0, 0.0));
        for (frequency, weight) in series.octaves() {
            let next = lanes::locate::<Octave>(lanes::times(frequency * series.lambda, p));
            sum = lanes::plus(sum, lanes::times(weight, lanes::vector_noise::<Octave>(here)));
            here = next;
        }
        lanes::components(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn portable_scalar(p: DVec3) -> f64 {
        value::scalar_noise::<Single>(value::locate::<Single>(p))
    }

    fn portable_vector(p: DVec3) -> DVec3 {
        value::vector_noise::<Single>(value::locate::<Single>(p))
    }

    /// Returns both noises by AVX2, which a processor with AVX-512 uses nowhere else; `None` without AVX2.
    fn noise_by_avx2(p: DVec3) -> Option<(f64, DVec3)> {
        #[cfg(target_arch = "x86_64")]
        {
            #[target_feature(enable = "avx2")]
            fn compute(p: DVec3) -> (f64, DVec3) {
                use super::super::avx2::{components, locate, scalar_noise, vector, vector_noise};
                let at = locate::<Single>(vector(p.x, p.y, p.z));
                (scalar_noise::<Single>(at), components(vector_noise::<Single>(at)))
            }
            // SAFETY: the processor has the feature that the function needs.
            #[expect(unsafe_code, reason = "the compiler can't know the processor")]
            return is_x86_feature_detected!("avx2").then(|| unsafe { compute(p) });
        }
        #[cfg(not(target_arch = "x86_64"))]
        None
    }

    #[test]
    fn all_versions_match_portable_bits() {
        let point = |i: i32| DVec3::new(0.37 * f64::from(i) - 99.0, -1.93 * f64::from(i), 0.011 * f64::from(i));
        let far = [1e18, -1e300, f64::MAX, f64::INFINITY, f64::NAN, -0.0, 1.0, -1.0, 4.5e15, -9.1e15];
        let strange = far.map(|x| DVec3::new(x, 0.5, -x));
        let points: Vec<DVec3> = (0..1001).map(point).chain(strange).collect();
        for p in &points {
            let (scalar_noise, vector) = (portable_scalar(*p), portable_vector(*p));
            // (The payload of a NaN does not matter.)
            let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
            assert!(same(scalar_at(p.x, p.y, p.z), scalar_noise), "{p}");
            fold_octaves(p.x, p.y, p.z, 2.2, (3, 1.0), |(left, frequency), octave| {
                assert!(same(octave, portable_scalar(*p * frequency)), "{p}");
                let next = (left - 1, frequency * 2.2);
                if left == 0 { ControlFlow::Break(next) } else { ControlFlow::Continue(next) }
            });
            let same_vector = |a: DVec3| a.to_array().into_iter().zip(vector.to_array()).all(|(a, b)| same(a, b));
            assert!(same_vector(vector_at(p.x, p.y, p.z)), "{p}");
            assert!(noise_by_avx2(*p).is_none_or(|(a, b)| same(a, scalar_noise) && same_vector(b)), "{p}");
        }
    }
}
