//! Chooses between [`super::value`] and its twin for processors that compute four numbers at once. Both give the same bits.

use super::super::DVec3;
use super::{Turbulence, value};

/// `f(arguments)` by the twin in `avx2` where the processor can, else by the one in `value`.
macro_rules! twins {
    ($(#[$doc:meta])* $name:ident($f:ident; $($argument:ident: $type:ty),*) $(-> $out:ty)? $body:block) => {
        $(#[$doc])*
        pub fn $name($($argument: $type),*) $(-> $out)? {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2")]
                fn avx2($($argument: $type),*) $(-> $out)? {
                    use super::avx2::$f;
                    $body
                }
                if is_x86_feature_detected!("avx2") {
                    // SAFETY: the processor has just been asked whether it has what the function needs.
                    #[expect(unsafe_code, reason = "the compiler can't know the processor")]
                    return unsafe { avx2($($argument),*) };
                }
            }
            use value::$f;
            $body
        }
    };
}

twins! {
    /// [`value::scalar`].
    scalar_at(scalar; p: DVec3) -> f64 {
        scalar(p)
    }
}

twins! {
    /// [`value::scalar`] at several points.
    scalars(scalar; points: &[DVec3], out: &mut [f64]) {
        for (p, out) in points.iter().zip(out) {
            *out = scalar(*p);
        }
    }
}

twins! {
    /// [`value::vector`].
    vector_at(vector; p: DVec3) -> DVec3 {
        vector(p)
    }
}

twins! {
    /// Octaves of [`value::vector`].
    turbulence(vector; p: DVec3, series: Turbulence) -> DVec3 {
        let mut sum = DVec3::ZERO;
        for (frequency, weight) in series.octaves() {
            sum += weight * vector(p * frequency);
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twins_give_the_same_bits() {
        let point = |i: i32| DVec3::new(0.37 * f64::from(i) - 99.0, -1.93 * f64::from(i), 0.011 * f64::from(i));
        let points: Vec<DVec3> = (0..1001).map(point).collect();
        let mut out = vec![0.0; points.len()];
        scalars(&points, &mut out);
        for (p, out) in points.iter().zip(&out) {
            assert_eq!(out.to_bits(), value::scalar(*p).to_bits());
            assert_eq!(scalar_at(*p).to_bits(), value::scalar(*p).to_bits());
            assert_eq!(vector_at(*p), value::vector(*p));
        }
    }
}
