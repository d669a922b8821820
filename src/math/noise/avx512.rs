//! The operations of [`super::avx2`] in the instructions of AVX-512: still four numbers at once, but with twice as many
//! registers, so that less is stored between operations. The results have the same bits.

use super::avx2;
pub use super::avx2::{LatticePoint, Vector, components, plus, times, vector};
use std::marker::PhantomData;

/// Mark of the copies of `avx2`'s functions for a caller of this module; see [`super::wide`].
struct Encoded<Caller>(PhantomData<Caller>);

/// Finds the lattice cell that contains a point.
#[target_feature(enable = "avx2,avx512f,avx512dq,avx512vl")]
#[inline]
pub fn locate<Caller>(p: Vector) -> LatticePoint {
    avx2::locate::<Encoded<Caller>>(p)
}

/// Computes [`super::value::scalar_noise`].
#[target_feature(enable = "avx2,avx512f,avx512dq,avx512vl")]
#[inline]
pub fn scalar_noise<Caller>(at: LatticePoint) -> f64 {
    avx2::scalar_noise::<Encoded<Caller>>(at)
}

/// Computes [`super::value::vector_noise`].
#[target_feature(enable = "avx2,avx512f,avx512dq,avx512vl")]
#[inline]
pub fn vector_noise<Caller>(at: LatticePoint) -> Vector {
    avx2::vector_noise::<Encoded<Caller>>(at)
}
